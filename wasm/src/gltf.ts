// SPDX-License-Identifier: MIT
//
// glTF files, read by gltf.wasm.

import { requireBytes } from './checks.js';
import type { GltfFile } from './engine.js';
import type { MeshPart } from './results.js';
import type { Triangles } from './triangles.js';
import { WasmModule } from './wasm_module.js';

/** The triangles of a glTF scene in world space. */
export interface GltfScene extends Triangles {
  parts: MeshPart[];
  notes: string[];
}

/** `GltfScene` as gltf.wasm lists it: five numbers per part. */
type GltfArrays = Omit<GltfScene, 'parts'> & { partNumbers: Int32Array; partNames: string[] };

/**
 * Reads GLB or glTF. An instance of its own per file: the memory it took goes with it, and no file
 * can spoil the reading of the next.
 */
export async function readGltf(
  module: WebAssembly.Module,
  { bytes, resources, limits }: GltfFile,
): Promise<GltfScene> {
  const wasm = await WasmModule.instantiate(module);
  const { partNumbers, partNames, ...scene } = wasm.answer<GltfArrays>(
    'readGltfScene',
    bytes,
    Object.keys(resources),
    Object.values(resources),
    Object.keys(limits),
    Float64Array.from(Object.values(limits)),
  );
  const parts = partNames.map((name, i) => {
    const [node, mesh, primitive, firstTriangle, triangleCount] = partNumbers.subarray(5 * i);
    return { name, node, mesh, primitive, firstTriangle, triangleCount };
  });
  return { ...scene, parts };
}

/**
 * The files that a glTF names besides itself and that its triangles need: the URIs of its buffers,
 * as it writes them. What cannot be read names none; `mesh()` says what is wrong with it.
 */
export function gltfResourceUris(bytes: Uint8Array): string[] {
  requireBytes('bytes', bytes);
  let uris: unknown[];
  try {
    const { buffers = [] } = JSON.parse(new TextDecoder().decode(jsonOf(bytes)));
    uris = buffers.map((buffer: { uri?: unknown }) => buffer.uri);
  } catch {
    return [];
  }
  return uris.filter((uri): uri is string => typeof uri === 'string' && !/^data:/i.test(uri));
}

/** The JSON of a glTF: a GLB's first chunk, else all of it. */
function jsonOf(bytes: Uint8Array): Uint8Array {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const glbMagic = 0x46546c67;
  if (bytes.length < 20 || view.getUint32(0, true) !== glbMagic) return bytes;
  return bytes.subarray(20, 20 + view.getUint32(12, true));
}
