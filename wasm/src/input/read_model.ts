// SPDX-License-Identifier: MIT
//
// From the files of a model to its triangles. What a format needs is loaded with its first file.

import type { FileInput } from '../engine.js';
import { GeodesicVoronoiError } from '../errors.js';
import { readGltf } from '../gltf.js';
import type { MeshOrigin, MeshPart } from '../results.js';
import type { Triangles } from '../triangles.js';
import type { ModelFiles } from '../types.js';
import { decompressed } from './gltf_decompression.js';
import {
  type GltfFile,
  isCompressed,
  parseGltf,
  type Resources,
  resourceUris,
} from './gltf_document.js';
import { toSizeLimits } from './limits.js';
import { FileSet } from './model_files.js';
import { type FileFormat, formatOf } from './model_format.js';

/** WebAssembly modules, compiled when they are first needed. */
export interface InputModules {
  gltf(): Promise<WebAssembly.Module>;
  draco(): Promise<WebAssembly.Module>;
}

/** What a file without normals, texture coordinates and parts has to give. */
export interface ReadModel extends Pick<Triangles, 'positions' | 'indices'> {
  /** What was passed over or changed, a sentence each. */
  notes: string[];
}

export interface Model {
  triangles: Triangles;
  origin: MeshOrigin;
  parts: MeshPart[];
  notes: string[];
}

/** The model among files. */
export interface FoundModel {
  /** Its path. */
  file: string;
  format: Exclude<FileFormat, 'zip'>;
  bytes: Uint8Array;
  /** The content of the file that it means by a URI, if that is among them. */
  resource(uri: string): Promise<Uint8Array | undefined>;
}

/** The one model among files; of a .zip, the one in it. */
export async function modelIn(files: ModelFiles): Promise<FoundModel> {
  const found = await modelAmong(files);
  const isArchive = found.format === 'zip';
  const model = isArchive
    ? await modelAmong((await import('./zip.js')).zipFiles(found.bytes))
    : found;
  const { format } = model;
  if (format !== 'zip') return { ...model, format };
  // There are zips that hold themselves.
  throw new GeodesicVoronoiError(
    'invalid-file',
    `${model.file} in the zip is a zip itself: unpack it first`,
  );
}

async function modelAmong(
  files: ModelFiles,
): Promise<Omit<FoundModel, 'format'> & { format: FileFormat }> {
  const set = new FileSet(files);
  const file = set.model;
  const bytes = await set.read(file);
  const resource = (uri: string) => set.resource(file, uri);
  return { file, format: formatOf(bytes, file), bytes, resource };
}

export async function readModel(
  { files, limits }: FileInput,
  modules: InputModules,
): Promise<Model> {
  const { file, format, bytes, resource } = await modelIn(files);
  const sizes = toSizeLimits(limits);
  switch (format) {
    case 'glTF': {
      const readable = await readableGltf(bytes, resource, modules.draco);
      const { parts, notes, ...triangles } = await readGltf(await modules.gltf(), readable, limits);
      return { triangles, parts, notes, origin: { file, format } };
    }
    case 'OBJ':
      return plain((await import('./obj_reader.js')).readObj(bytes, sizes), { file, format });
    case 'PLY':
      return plain((await import('./ply_reader.js')).readPly(bytes, sizes), { file, format });
    case 'binary STL':
      return plain((await import('./stl_reader.js')).readBinaryStl(bytes, sizes), {
        file,
        format: 'STL',
      });
    case 'text STL':
      return plain((await import('./stl_reader.js')).readTextStl(bytes, sizes), {
        file,
        format: 'STL',
      });
  }
}

/** The glTF with those of its files that are there, and nothing in it compressed. */
async function readableGltf(
  bytes: Uint8Array,
  resource: (uri: string) => Promise<Uint8Array | undefined>,
  dracoModule: () => Promise<WebAssembly.Module>,
): Promise<GltfFile> {
  const document = parseGltf(bytes);
  if (!document) return { bytes, resources: {} };
  const resources: Resources = {};
  for (const uri of resourceUris(document.json)) {
    const content = await resource(uri);
    if (content) resources[uri] = content;
  }
  return isCompressed(document.json)
    ? decompressed(document, resources, dracoModule)
    : { bytes, resources };
}

function plain({ positions, indices, notes }: ReadModel, origin: MeshOrigin): Model {
  // Two empty arrays: a worker hands over every buffer once.
  const [normals, uvs] = [new Float64Array(), new Float64Array()];
  return { triangles: { positions, indices, normals, uvs }, parts: [], notes, origin };
}
