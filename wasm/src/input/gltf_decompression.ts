// SPDX-License-Identifier: MIT
//
// Decompresses a glTF with KHR_draco_mesh_compression, EXT_meshopt_compression or
// KHR_meshopt_compression: the decoders' output becomes one more buffer, to which buffer views and
// accessors are redirected. Everything else stays as it is.

import { isObject } from '../base/checks.js';
import { imported } from '../base/compile.js';
import { counted, integer } from '../base/sentences.js';
import type { DracoDecoding, DracoMesh } from './draco.js';
import {
  dracoExtension,
  extensionOf,
  gltfFault,
  type GltfDocument,
  type GltfFile,
  type JsonObject,
  meshoptExtensions,
  objectsOf,
  type Resources,
} from './gltf_document.js';
import { GltfData, whole } from './gltf_data.js';
import type { TaskOptions } from '../api/options.js';
import type { MeshoptDecoding } from './meshopt.js';
import { inSlices, type SlicedWork } from '../base/slices.js';

/** Names of buffers that no file has, since they are no URIs. */
const binaryName = '<binary chunk>';
const decodedName = (buffer: number) => `<buffer ${buffer}>`;
const decompressedName = '<decompressed>';

export async function decompressed(
  document: GltfDocument,
  resources: Resources,
  dracoModule: () => Promise<WebAssembly.Module>,
  task: TaskOptions,
): Promise<GltfFile> {
  const { json, binary } = document;
  const data = new GltfData(document, resources);
  await decompressViews(data, task);
  await decompressPrimitives(json, data, dracoModule, task);
  for (const list of ['extensionsUsed', 'extensionsRequired']) {
    if (json[list] === undefined) continue;
    const names = [json[list]].flat();
    json[list] = names.filter(
      (name) => ![dracoExtension, ...meshoptExtensions].includes(name as string),
    );
  }

  const added = await inSlices(data.added(), { signal: task.signal });
  const all = new Map(resources).set(decompressedName, added);
  const buffers = data.list('buffers');
  if (binary && buffers.length > 0 && buffers[0].uri === undefined) {
    buffers[0].uri = binaryName;
    all.set(binaryName, binary);
  }
  // The reader decodes none again.
  for (const [buffer, content] of data.decoded) {
    buffers[buffer].uri = decodedName(buffer);
    all.set(decodedName(buffer), content);
  }
  buffers.push({ uri: decompressedName, byteLength: added.length });
  try {
    return { bytes: new TextEncoder().encode(JSON.stringify(json)), resources: all };
  } catch (cause) {
    throw gltfFault('the JSON is nested too deeply, or too long', cause);
  }
}

/** Every buffer view that is compressed becomes one of the new buffer. */
async function decompressViews(data: GltfData, { signal }: TaskOptions): Promise<void> {
  if (!data.list('bufferViews').some(meshoptOf)) return;
  const { openMeshopt } = await imported(import('./meshopt.js'));
  await inSlices(decompressingViews(data, await openMeshopt()), { signal });
}

function* decompressingViews(data: GltfData, decode: MeshoptDecoding): SlicedWork<void> {
  for (const [i, view] of data.list('bufferViews').entries()) {
    const name = meshoptOf(view);
    if (!name) continue;
    const content = decode(extensionOf(view, name)!, data, `buffer view ${i}`);
    Object.assign(view, data.add(content));
    delete (view.extensions as JsonObject)[name];
    yield 0; // the share is not told
  }
}

/** The extension by which a buffer view is compressed. */
function meshoptOf(view: JsonObject): string | undefined {
  return meshoptExtensions.find((name) => extensionOf(view, name));
}

/** Every primitive that is compressed gets accessors of its own. */
async function decompressPrimitives(
  json: JsonObject,
  data: GltfData,
  dracoModule: () => Promise<WebAssembly.Module>,
  { signal }: TaskOptions,
): Promise<void> {
  const primitives = objectsOf(json.meshes).flatMap((mesh, m) =>
    objectsOf(mesh.primitives).map((primitive, p) => ({
      primitive,
      where: `primitive ${p} of mesh ${m}`,
    })),
  );
  const compressed = primitives.filter(({ primitive }) => extensionOf(primitive, dracoExtension));
  if (compressed.length === 0) return;
  const { openDraco } = await imported(import('./draco.js'));
  const decode = await openDraco(await dracoModule());
  await inSlices(decompressingPrimitives(compressed, data, decode), { signal });
}

function* decompressingPrimitives(
  primitives: readonly { primitive: JsonObject; where: string }[],
  data: GltfData,
  decode: DracoDecoding,
): SlicedWork<void> {
  for (const { primitive, where } of primitives) {
    const compression = extensionOf(primitive, dracoExtension)!;
    const view = data.entry('bufferViews', compression.bufferView, `the bufferView of ${where}`);
    const mesh = decode(data.bytesOf(view, where), where);
    Object.assign(primitive, {
      attributes: decompressedAttributes(primitive, compression, mesh, data, where),
      indices: decompressedIndices(primitive, mesh, data, where),
      mode: 4, // strips come as single triangles too
    });
    mesh.free();
    delete (primitive.extensions as JsonObject)[dracoExtension];
    yield 0; // the share is not told
  }
}

/** The vertex attributes that are read; a decompressed primitive keeps no others. */
const attributeNames = ['POSITION', 'NORMAL', 'TEXCOORD_0', '_DENSITY'];

function decompressedAttributes(
  primitive: JsonObject,
  compression: JsonObject,
  draco: DracoMesh,
  data: GltfData,
  where: string,
): JsonObject {
  const attributes = isObject(primitive.attributes) ? primitive.attributes : {};
  const ids = isObject(compression.attributes) ? compression.attributes : {};
  const result: JsonObject = {};
  for (const name of attributeNames.filter((attribute) => attributes[attribute] !== undefined)) {
    const what = `${name} of ${where}`;
    const accessor = data.entry('accessors', attributes[name], what);
    // A compressed primitive may have plain attributes, too.
    result[name] =
      ids[name] === undefined
        ? attributes[name]
        : addAccessor(
            data,
            accessor,
            draco.attribute(whole(ids[name], what), accessor, what),
            what,
          );
  }
  return result;
}

function decompressedIndices(
  primitive: JsonObject,
  draco: DracoMesh,
  data: GltfData,
  where: string,
): number {
  const content = draco.indices();
  const count = content.byteLength / 4;
  const own = { componentType: 5125, type: 'SCALAR', count };
  const what = `the indices of ${where}`;
  // The accessor of a strip counts fewer indices than its triangles have corners.
  const isList = primitive.indices !== undefined && (primitive.mode ?? 4) === 4;
  const given = isList ? data.entry('accessors', primitive.indices, what).count : count;
  return addAccessor(data, { ...own, count: given }, { content, count }, what);
}

/** An accessor like another one, with data of its own. */
function addAccessor(
  data: GltfData,
  { componentType, type, normalized, count: wanted }: JsonObject,
  { content, count }: { content: Uint8Array; count: number },
  what: string,
): number {
  const given = whole(wanted, `the count of ${what}`);
  if (given !== count) {
    throw gltfFault(
      `${what} should have ${counted(given, 'element')}, but decompressed it has ${integer(count)}`,
    );
  }
  const bufferView = data.list('bufferViews').push(data.add(content)) - 1;
  return data.list('accessors').push({ bufferView, componentType, type, normalized, count }) - 1;
}
