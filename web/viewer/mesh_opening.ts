// SPDX-License-Identifier: MIT
//
// From a model's files to its mesh, with sites scattered on it and made ready to be drawn.

import type { GeodesicVoronoi, Mesh, MeshOptions, Sampling, SurfacePoints } from 'geodesic-voronoi';
import { DrawingBuilder } from './drawing_builder.js';
import { sentence } from './failure.js';
import { lastSegment, type NamedFiles } from './model_files.js';
import { SceneMesh } from './scene_mesh.js';

/** How sites are scattered. */
export interface Scattering {
  count: number;
  seed: number;
  sampling?: Sampling;
  /** The least number per component, as far as there are enough sites. */
  perComponent?: number;
  /** Per input vertex: random sites are closer where it is greater. */
  density?: ArrayLike<number> | undefined;
}

/** How a model is opened. */
export interface Opening {
  build: Pick<MeshOptions, 'weld' | 'orientation' | 'minComponent'>;
  scattering: Scattering;
}

/** Reads a model's files. */
export type Reader = (
  signal: AbortSignal,
  onProgress: (share: number) => void,
) => Promise<NamedFiles>;

export interface OpenedMesh {
  mesh: Mesh;
  name: string;
  /** The files that the mesh was read from. */
  files: NamedFiles;
  sites: PointList;
  scene: SceneMesh;
  /** Makes further drawings of the mesh. */
  builder: DrawingBuilder;
}

export type PointList = SurfacePoints | { face: number[]; bary: number[] };

/** Opens a mesh. If any step fails or is aborted, nothing stays open. */
export async function openMesh(
  library: GeodesicVoronoi,
  read: Reader,
  { build, scattering }: Opening,
  { signal, onProgress }: { signal: AbortSignal; onProgress: (share: number) => void },
): Promise<OpenedMesh> {
  // The builder's worker starts while the files are read.
  const builder = new DrawingBuilder();
  let mesh: Mesh | undefined;
  try {
    const files = await read(signal, onProgress);
    mesh = await library.mesh(files.files, { ...build, file: files.file }).catch((error) => {
      throw sentence(`${files.name} cannot be opened`, error);
    });
    const [sites, scene] = await Promise.all([
      scatterSites(mesh, scattering),
      sceneOf(mesh, builder),
    ]);
    signal.throwIfAborted();
    return { mesh, name: lastSegment(mesh.info.origin.file), files, sites, scene, builder };
  } catch (error) {
    mesh?.dispose();
    builder.dispose();
    throw error;
  }
}

async function sceneOf(mesh: Mesh, builder: DrawingBuilder): Promise<SceneMesh> {
  const arrays = await builder.scene(mesh);
  return new SceneMesh(arrays ?? (await import('./scene_arrays.js')).sceneArrays(mesh));
}

export async function scatterSites(
  mesh: Mesh,
  { count, seed, sampling = 'random', perComponent = 0, density }: Scattering,
): Promise<PointList> {
  if (count <= 0) return { face: [], bary: [] };
  const most = Math.floor(count / mesh.info.components);
  return mesh.sampleSites(count, {
    seed,
    sampling,
    perComponent: Math.min(perComponent, most),
    // Other samplings have none.
    density: sampling === 'random' ? density : undefined,
  });
}
