// SPDX-License-Identifier: MIT
//
// From a model's files to its mesh with sites scattered on it.

import type { GeodesicVoronoi, Mesh, MeshOptions, SurfacePoints } from 'geodesic-voronoi';
import { sentence } from './failure.js';
import { lastSegment, type NamedFiles } from './model_files.js';
import type { Scattering } from './session_listener.js';

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
  /** What it was read from. */
  files: NamedFiles;
  sites: PointList;
}

type PointList = SurfacePoints | { face: number[]; bary: number[] };

/** All of it or nothing: if anything fails, or is given up, nothing is left open. */
export async function openMesh(
  library: GeodesicVoronoi,
  read: Reader,
  { build, scattering }: Opening,
  { signal, onProgress }: { signal: AbortSignal; onProgress: (share: number) => void },
): Promise<OpenedMesh> {
  const files = await read(signal, onProgress);
  const mesh = await library.mesh(files.files, { ...build, file: files.file }).catch((error) => {
    throw sentence(`${files.name} cannot be opened`, error);
  });
  try {
    const sites = await scatterSites(mesh, scattering);
    signal.throwIfAborted();
    return { mesh, name: lastSegment(mesh.info.origin.file), files, sites };
  } catch (error) {
    mesh.dispose();
    throw error;
  }
}

export async function scatterSites(
  mesh: Mesh,
  { count, seed, sampling, perComponent = 0 }: Scattering,
): Promise<PointList> {
  if (count <= 0) return { face: [], bary: [] };
  const most = Math.floor(count / mesh.info.components);
  return mesh.sampleSites(count, { seed, sampling, perComponent: Math.min(perComponent, most) });
}
