// SPDX-License-Identifier: MIT
import type { Triangles } from './triangles.js';
import type { GltfResources, MeshPart } from './types.js';
import { WasmModule } from './wasm_module.js';

interface GltfFunctions {
  readGltfScene(
    bytes: number,
    byteLength: number,
    resources: number,
    resourceCount: number,
  ): number;
}

/** The triangles of a glTF scene in world space. */
export interface GltfScene extends Triangles {
  parts: MeshPart[];
  notes: string[];
}

/**
 * Reads GLB or glTF. An instance of its own per file: the memory it took goes with it, and no file
 * can spoil the reading of the next.
 */
export async function readGltf(
  module: WebAssembly.Module,
  bytes: Uint8Array,
  resources: GltfResources,
): Promise<GltfScene> {
  const wasm = await WasmModule.instantiate<GltfFunctions>(module);
  const utf8 = new TextEncoder();
  const entries = Object.entries(resources);
  const [positions, indices, normals, uvs, numbers, ...texts] = wasm.arrays((gltf, copyIn) => {
    const rows = entries.flatMap(([name, content]) => {
      const uri = utf8.encode(name);
      return [copyIn(uri), uri.length, copyIn(content), content.length];
    });
    return gltf.readGltfScene(
      copyIn(bytes),
      bytes.length,
      copyIn(Uint32Array.from(rows)),
      entries.length,
    );
  }) as [Float64Array, Int32Array, Float64Array, Float64Array, Int32Array, ...string[]];

  const partCount = numbers.length / 5;
  const parts = texts.slice(0, partCount).map((name, i) => {
    const [node, mesh, primitive, firstTriangle, triangleCount] = numbers.subarray(5 * i);
    return { name, node, mesh, primitive, firstTriangle, triangleCount };
  });
  return { positions, indices, normals, uvs, parts, notes: texts.slice(partCount) };
}

/**
 * The files that a glTF names besides itself and that its triangles need: the URIs of its buffers,
 * as it writes them. What cannot be read names none; `mesh()` says what is wrong with it.
 */
export function gltfResourceUris(bytes: Uint8Array): string[] {
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
