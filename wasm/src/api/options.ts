// SPDX-License-Identifier: MIT
//
// What the library's functions take: models, points and options.

import type { CvtMethod, Metric, Orientation, Sampling } from './results.js';

/**
 * Points of a surface as an argument: input triangles with barycentric coordinates, input vertices,
 * or places in space, of which the closest points of the surface are taken (`closestPoints`). One
 * point may be given without lists of one: `{ face: 7, bary: [0.2, 0.3, 0.5] }`, `{ vertex: 40 }`.
 */
export type SurfacePointsInput =
  | { face: number | ArrayLike<number>; bary: ArrayLike<number> }
  | { vertex: number | ArrayLike<number> }
  | { position: ArrayLike<number> };

export interface DistancesOptions extends TaskOptions {
  /** Default 'exact'. */
  metric?: Metric | undefined;
}

/** Options of every call that may take long. */
export interface TaskOptions {
  /**
   * Called with the share done, 0 … 1, unless the call is quick. What it throws ends the task and rejects
   * the promise; a change of a site (`insertSite`, `moveSite`, `removeSite`) is carried out nevertheless.
   */
  onProgress?: ((share: number) => void) | undefined;
  /**
   * Aborting rejects the promise with the signal's reason and changes nothing. A change of a site that
   * has begun is carried out nevertheless.
   */
  signal?: AbortSignal | undefined;
}

export interface AccuracyOptions extends TaskOptions {
  /** How many points are compared. Default 1000: a share of 0.01 comes out within about 0.003. */
  samples?: number | undefined;
}

export interface VoronoiOptions extends TaskOptions {
  /** Default 'exact'. */
  metric?: Metric | undefined;
  /**
   * How finely faces with several regions are split, 0 … 10: into parts about 2^-detail times as long as
   * the mean edge. Default 0: not at all. Regions that own no corner of a face in which they lie are
   * missed at any detail; see `maxEdge`.
   */
  detail?: number | undefined;
}

export interface PartitionOptions extends TaskOptions {
  /**
   * Leaves out faces on which labels tie, as holes, instead of giving them to the lowest label.
   * Default false.
   */
  leaveOutIndifferent?: boolean | undefined;
  /** Leaves out the components without a site. Default false. */
  leaveOutUnreachable?: boolean | undefined;
}

export interface DualOptions extends TaskOptions {
  /** Makes polygons of the regions, with Voronoi points as corners, instead. Default false. */
  primal?: boolean | undefined;
}

export interface RepairOptions extends TaskOptions {
  /** How many sites may be added. Default 1000. */
  maxAdded?: number | undefined;
}

/**
 * A number per input vertex, not negative, or with `maxEdge` per vertex before long edges were
 * halved. 'curvature' stands for `Mesh.curvatureDensity`, 'attribute' for `Mesh.density`.
 */
export type Density = ArrayLike<number> | 'attribute' | 'curvature';

export interface CvtOptions extends TaskOptions {
  /** Default 'lbfgs'. */
  method?: CvtMethod | undefined;
  /** Default 'exact'. */
  metric?: Metric | undefined;
  /** The most iterations; default 50. */
  iterations?: number | undefined;
  /** Ends when an iteration lowers the energy by no more than this share, 0 … 1. Default 0. */
  energyTolerance?: number | undefined;
  /** Ends when no site moves farther than this, in the input's units. Default 0. */
  moveTolerance?: number | undefined;
  /** Regions are smaller where the density is large. Default uniform. */
  density?: Density | undefined;
  /** Indices of the sites that stay where they are. */
  fixedSites?: ArrayLike<number> | undefined;
  /** Whether every state comes with the arrays of its diagram. Default false. */
  data?: boolean | undefined;
  /** Whether every state comes with its `Diagram`, for queries and changes. Default false. */
  diagrams?: boolean | undefined;
}

export interface RemeshOptions extends Omit<CvtOptions, 'data' | 'diagrams'> {
  /** The most iterations in each of up to three rounds; default 50. */
  iterations?: number | undefined;
  /** How many sites may be added until the dual is valid. Default 1000. */
  maxAdded?: number | undefined;
}

export interface SampleOptions extends TaskOptions {
  /** An integer from 0 to 2^53 - 1. Default 1. */
  seed?: number | undefined;
  /** Default 'random'; 'farthest' if a radius is given instead of a count. */
  sampling?: Sampling | undefined;
  /**
   * The least number of sites on each component, default 0. Missing ones are added at the end of
   * the list; to keep to the count, the last ones of components with more than enough are dropped.
   */
  perComponent?: number | undefined;
  /**
   * For random sites: spreads them as a tessellation with this density does, with a probability per
   * area in proportion to the density's square root. Default uniform.
   */
  density?: Density | undefined;
}

/** The limits by their names: those of the C++ reader. */
export const gltfLimitNames = [
  'maxJsonBytes',
  'maxObjects',
  'maxVertices',
  'maxTriangles',
  'maxZeroElements',
] as const;
export type GltfLimitName = (typeof gltfLimitNames)[number];

/**
 * Limits on what a file may ask for, so that a small file cannot take all memory or hours. The
 * error about a file that asks for more names the limit to raise. The limits of vertices and
 * triangles hold for every format, the others for glTF.
 */
export interface GltfLimits extends Partial<Record<GltfLimitName, number | undefined>> {
  /** The size of the JSON. Default 2^29. */
  maxJsonBytes?: number | undefined;
  /**
   * Nodes, meshes, primitives, accessors, buffer views, … together; also the primitives and morph
   * targets of all nodes and instances together. Default 2^18.
   */
  maxObjects?: number | undefined;
  /**
   * The vertices of all nodes and instances together; each active morph target counts its vertices
   * again. Default 2^24.
   */
  maxVertices?: number | undefined;
  /** The triangles of all nodes and instances together. Default 2^24. */
  maxTriangles?: number | undefined;
  /** Elements of accessors without a buffer view, which are zeros in no file. Default 2^20. */
  maxZeroElements?: number | undefined;
}

/** How a mesh is read and built; `MeshInfo.repairs` counts what was done. */
export interface MeshOptions extends TaskOptions {
  /** Higher limits, or lower ones. */
  limits?: GltfLimits | undefined;
  /** The path of the model to open, where a folder or a zip has several. */
  file?: string | undefined;
  /**
   * Edges longer than this are halved until none is; a share of the bounding box's diagonal, 0 … 1.
   * The triangles of the mesh, in all results too, are then the smaller ones (`Mesh.parents`). For
   * models whose triangles are about as long as regions (`Diagram.accuracy`). More than 2^24 are refused.
   * Default 0: as they are.
   */
  maxEdge?: number | undefined;
  /**
   * Vertices no farther apart than this are welded, and boundary vertices as near to the side of
   * another triangle joined to it (T-junctions); a share of the bounding box's diagonal, 0 … 1.
   * Default 0: only vertices at the same position are welded.
   */
  weld?: number | undefined;
  /** Default 'unify'. */
  orientation?: Orientation | undefined;
  /** Components with fewer triangles than this are dropped. Default 0. */
  minComponent?: number | undefined;
}

/**
 * Bytes, or an object like a `File` that is read if the model needs it. With `loadWorker()` it has
 * to be a real `Blob` or `File`, since no other such object can be sent to a worker.
 */
export type ModelFile = Uint8Array | { arrayBuffer(): Promise<ArrayBuffer> };

/**
 * The files of a folder by their paths in it: a model, the files that it refers to, and any others.
 * Files that a glTF refers to may also be given by its URIs for them (`gltfResourceUris` lists
 * these).
 */
export type ModelFiles = Record<string, ModelFile>;

/**
 * A model (glTF, also compressed by Draco or meshopt, OBJ, OFF, PLY, STL, or a zip of one) as bytes
 * or a `Blob`; or all its files by their paths; or triangles as arrays, or as a geometry of three.js.
 */
export type MeshSource = Uint8Array | ArrayBuffer | Blob | ModelFiles | MeshArrays | ThreeGeometry;

/**
 * Triangles: x, y, z per vertex, three vertex indices per triangle; without indices, every three
 * vertices are a triangle. `normals`, `uvs` and `density` have 3, 2 and 1 numbers per vertex, or none.
 */
export interface MeshArrays {
  positions: ArrayLike<number>;
  indices?: ArrayLike<number> | undefined;
  normals?: ArrayLike<number> | undefined;
  uvs?: ArrayLike<number> | undefined;
  density?: ArrayLike<number> | undefined;
}

/**
 * A `BufferGeometry` of three.js: its attributes `position`, `normal` and `uv`, and its index. They may be
 * interleaved, or normalized. All of it is taken, as it is without morph targets and skins.
 */
export interface ThreeGeometry {
  readonly isBufferGeometry: true;
  /** Those that are read are `ThreeAttribute`s; older types of three.js allow others. */
  readonly attributes: Readonly<Record<string, object>>;
  readonly index: ThreeAttribute | null;
}

/** A `BufferAttribute` of three.js, or another that it has. */
export interface ThreeAttribute {
  readonly count: number;
  getX(index: number): number;
  getY(index: number): number;
  getZ(index: number): number;
}

/**
 * A compiled module: a `WebAssembly.Module`. That name is one of the DOM's types, which a project for
 * Node need not have.
 */
export type CompiledModule = object;

/**
 * Where a WebAssembly module comes from: its address, its bytes (any typed array, also a `Buffer`),
 * what the server answered, or the module itself.
 */
export type WasmSource = URL | string | ArrayBuffer | ArrayBufferView | Response | CompiledModule;
