// SPDX-License-Identifier: MIT
//
// glTF files, read by gltf.wasm.

import type { GltfFile } from './gltf_document.js';
import type { MeshPart } from '../api/results.js';
import { inSlices } from '../base/slices.js';
import type { Triangles } from '../base/triangles.js';
import type { GltfLimits, TaskOptions } from '../api/options.js';
import { WasmModule } from '../base/wasm_module.js';

/** The triangles of a glTF scene in world space. */
interface GltfScene extends Triangles {
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
  { bytes, resources }: GltfFile,
  limits: GltfLimits,
  task: TaskOptions,
): Promise<GltfScene> {
  const wasm = await WasmModule.instantiate(module);
  const reading = wasm.call(
    'readGltfScene',
    wasm.keep(bytes),
    wasm.keep([...resources.keys()]),
    wasm.keep([...resources.values()]),
    Object.keys(limits),
    Float64Array.from(Object.values(limits)),
  );
  const arrays = await inSlices(wasm.answering<GltfArrays>(reading), task);
  const { partNumbers, partNames, ...scene } = arrays;
  const parts = partNames.map((name, i) => {
    const [node, mesh, primitive, firstTriangle, triangleCount] = partNumbers.subarray(5 * i);
    return { name, node, mesh, primitive, firstTriangle, triangleCount };
  });
  return { ...scene, parts };
}
