// SPDX-License-Identifier: MIT
//
// From a model's files to its mesh, with sites sampled on it and made ready to be drawn.

import type {
  GeodesicVoronoi,
  Mesh,
  MeshOptions,
  SampleOptions,
  TaskOptions,
} from 'geodesic-voronoi';
import { DrawingBuilder } from '../buffers/drawing_builder.js';
import { sentence } from './failure.js';
import { lastSegment, type NamedFiles, type Task } from './model_files.js';
import { SceneMesh } from '../buffers/scene_mesh.js';
import { Slices } from '../stage/next_frame.js';
import { shallowEqual } from './shallow_equal.js';
import { type PointList, type Sites, surfacePointsOf, type Tints } from './site_history.js';

/** How sites are sampled, by default as the library does. */
export interface SiteSampling extends Omit<SampleOptions, keyof TaskOptions> {
  count: number;
}

/** How a model is opened. */
export interface Opening {
  build: Pick<MeshOptions, 'maxEdge' | 'weld' | 'orientation' | 'minComponent' | 'limits'>;
  /** How sites are sampled; it may change while the model is opened. */
  siteSampling: () => SiteSampling;
  /** Sites and density that the model has had before. */
  kept?: Kept | undefined;
}

/** What is kept may change while the model is opened. */
interface Kept {
  /** Another mesh that they are on: they are put where they were. Without it, they are as they are. */
  mesh?: Mesh | undefined;
  /** In place of sampled sites; undefined if these are wanted. */
  sites: () => Sites | undefined;
  tints: () => Tints;
}

/** Reads a model's files. */
export type Reader = (task: Task) => Promise<NamedFiles>;

export interface OpenedMesh {
  mesh: Mesh;
  name: string;
  /** The files that the mesh was read from. */
  files: NamedFiles;
  sites: PointList;
  tints: Tints;
  scene: SceneMesh;
  /** Makes further drawings of the mesh. */
  builder: DrawingBuilder;
}

/** The shares of the work that are done when the files have been read, and when the mesh is there. */
const readShare = 0.4;
const meshShare = 0.8;
/** Vertices between two looks at the clock. */
const verticesPerStep = 1024;

/** Opens a mesh with its sites. If any step fails, nothing stays open. */
export async function openMesh(
  library: GeodesicVoronoi,
  read: Reader,
  { build, siteSampling, kept }: Opening,
  { signal, onProgress }: Task,
): Promise<OpenedMesh> {
  // The builder's worker starts while the files are read.
  const builder = new DrawingBuilder();
  const failing = new AbortController();
  let mesh: Mesh | undefined;
  try {
    const between = (from: number, to: number) => (share: number) =>
      onProgress(from + (to - from) * share);
    const files = await read({ signal, onProgress: between(0, readShare) });
    const building = { signal, onProgress: between(readShare, meshShare) };
    const options = { ...build, file: files.file, ...building };
    mesh = await library.mesh(files.files, options).catch((error) => {
      throw sentence(
        kept?.mesh ? 'The mesh cannot be made so' : `${files.name} cannot be opened`,
        error,
      );
    });
    const { faces, repairs } = mesh.info;
    if (repairs.mollifiedTriangles === faces)
      throw new Error(`${files.name} has no area to be seen: all of its triangles are flat.`);
    const placing = { signal, onProgress: between(meshShare, 1) };
    const drawn = sceneOf(mesh, builder, failing.signal);
    const [edited, scene] = await Promise.all([
      firstState(mesh, { siteSampling, kept }, drawn, placing),
      drawn,
    ]);
    const name = lastSegment(mesh.info.origin.file);
    return { mesh, name, files, ...edited, scene, builder };
  } catch (error) {
    failing.abort(); // first: a scene that the builder does not make any more would be made here
    mesh?.dispose();
    builder.dispose();
    throw error;
  }
}

async function sceneOf(
  mesh: Mesh,
  builder: DrawingBuilder,
  signal: AbortSignal,
): Promise<SceneMesh> {
  const { positions, indices } = mesh;
  const arrays = await builder.ask('scene', { positions, indices });
  signal.throwIfAborted();
  return new SceneMesh(arrays ?? (await import('../buffers/scene_arrays.js')).sceneArrays(mesh));
}

/** The sites and the density that are wanted when the scene is there. */
async function firstState(
  mesh: Mesh,
  { siteSampling, kept }: Omit<Opening, 'build'>,
  scene: Promise<unknown>,
  task: TaskOptions,
): Promise<Pick<OpenedMesh, 'sites' | 'tints'>> {
  for (;;) {
    const wanted = siteSampling();
    const before = { sites: kept?.sites(), tints: kept?.tints() };
    const sites =
      kept && before.sites
        ? await keptSites(mesh, kept.mesh, before.sites, task)
        : await sampleSites(mesh, wanted, task);
    const tints = before.tints && (await keptTints(mesh, kept?.mesh, before.tints, task));
    await scene;
    const now = { sites: kept?.sites(), tints: kept?.tints() };
    if (shallowEqual(siteSampling(), wanted) && shallowEqual(now, before)) return { sites, tints };
  }
}

/** The sites of a mesh before, where they were. */
async function keptSites(
  mesh: Mesh,
  before: Mesh | undefined,
  sites: Sites,
  task: TaskOptions,
): Promise<PointList> {
  const points = surfacePointsOf(sites);
  if (!before) return points;
  try {
    const positions = await before.positionsOf(points);
    return await mesh.closestPoints(positions, task);
  } catch (error) {
    throw sentence('The sites cannot be kept', error);
  }
}

/** The painted density at the vertices: what it was at the closest points of the mesh before. */
async function keptTints(
  mesh: Mesh,
  before: Mesh | undefined,
  tints: Float32Array,
  { signal }: TaskOptions,
): Promise<Tints> {
  if (!before) return tints;
  const { indices } = before;
  // Vertices that no triangle has may be anywhere.
  const places = mesh.positions.slice();
  for (let i = 0; i < places.length; ++i) if (!Number.isFinite(places[i])) places[i] = 0;
  const { face, bary } = await before.closestPoints(places, { signal });
  const kept = new Float32Array(face.length);
  const work = new Slices();
  for (let v = 0; v < kept.length; ++v) {
    if (v % verticesPerStep === 0 && work.isDue) await work.next();
    const tint = (corner: number) => bary[3 * v + corner] * tints[indices[3 * face[v] + corner]];
    kept[v] = tint(0) + tint(1) + tint(2);
  }
  return kept;
}

export async function sampleSites(
  mesh: Mesh,
  { count, seed, sampling = 'random', perComponent = 0, density }: SiteSampling,
  task: TaskOptions,
): Promise<PointList> {
  if (count === 0) return { face: [], bary: [] };
  const most = Math.max(0, Math.floor(count / mesh.info.components));
  const sampled = mesh.sampleSites(count, {
    seed,
    sampling,
    perComponent: perComponent > most ? most : perComponent, // also one that is no number
    // Other samplings have none.
    density: sampling === 'random' ? density : undefined,
    ...task,
  });
  return sampled.catch((error) => {
    throw sentence('The sites cannot be placed', error);
  });
}
