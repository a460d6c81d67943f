// SPDX-License-Identifier: MIT
/// <reference lib="esnext.disposable" preserve="true" />
//
// The objects of the library, and what their functions take.

import type {
  BareComponents,
  ClosestPoints,
  CvtMethod,
  DiagramChange,
  DiagramData,
  DualPaths,
  Distances,
  Located,
  MeshInfo,
  MeshPart,
  Metric,
  Orientation,
  Partition,
  PolygonMesh,
  RemeshQuality,
  Sampling,
  SurfacePath,
  SurfacePoints,
  Violation,
  WorstRegion,
} from './results.js';

/** What functions take as a list of points: faces with barycentric coordinates, or input vertices. */
export type SurfacePointsInput =
  | { face: ArrayLike<number>; bary: ArrayLike<number> }
  | { vertex: ArrayLike<number> };

export interface DistancesOptions extends TaskOptions {
  /** Default 'exact'. */
  metric?: Metric;
}

/** Of everything that may take long. */
export interface TaskOptions {
  /** Called with the share done, 0 … 1. */
  onProgress?: (share: number) => void;
  /**
   * Aborting rejects the promise with the signal's reason; nothing is changed. A change of a diagram that
   * has begun is carried out.
   */
  signal?: AbortSignal;
}

export interface VoronoiOptions extends TaskOptions {
  /** Default 'exact'. */
  metric?: Metric;
  /** How many times faces with several regions are split in four. Default 0. */
  detail?: number;
}

export interface PartitionOptions extends TaskOptions {
  /** Leaves holes where labels tie on a whole face, instead of giving it to the lowest. */
  leaveOutIndifferent?: boolean;
  /** Leaves out the components without a site. */
  leaveOutUnreachable?: boolean;
}

export interface DualOptions extends TaskOptions {
  /** The regions as polygons, with the Voronoi points for corners, instead. Default false. */
  primal?: boolean;
}

export interface RepairOptions extends TaskOptions {
  /** How many sites may be added. Default 1000. */
  maxAdded?: number;
}

export interface CvtOptions extends TaskOptions {
  /** Default 'lbfgs'. */
  method?: CvtMethod;
  /** Of the distances; default 'exact'. */
  metric?: Metric;
  /** At most; default 50. */
  iterations?: number;
  /** Ends when an iteration lowers the energy by no more than this share. Default 0. */
  energyTolerance?: number;
  /** Ends when no site moves further than this, in the input's units. Default 0. */
  moveTolerance?: number;
  /**
   * Per input vertex, not negative; 'curvature': `Mesh.curvatureDensity`; 'attribute': the density that the
   * mesh came with. Default uniform.
   */
  density?: ArrayLike<number> | 'attribute' | 'curvature';
  /** Indices of the sites that stay where they are. */
  fixedSites?: ArrayLike<number>;
  /** Whether every state comes with the arrays of its diagram. Default false. */
  data?: boolean;
  /** Whether every state comes with its diagram, to be asked and changed. Default false. */
  diagrams?: boolean;
}

export interface RemeshOptions extends Omit<CvtOptions, 'data' | 'diagrams'> {
  /** How many sites may be added until the dual is valid. Default 1000. */
  maxAdded?: number;
}

/** A centroidal tessellation on its way; `core/include/gvd/cvt.h` holds the definitions. */
export interface CvtState {
  /** 0: the sites given. */
  iteration: number;
  /** Σ ∫ ρ d², which never rises. */
  energy: number;
  /** How far the site that has moved furthest in this iteration has. */
  largestMove: number;
  sites: SurfacePoints;
  /** The arrays of the diagram of these sites, if these or the diagram were asked for. */
  data?: DiagramData;
  /** The diagram of these sites, if asked for. It is yours: it stays when the next one comes. */
  diagram?: Diagram;
}

export interface SampleOptions extends TaskOptions {
  /** An integer, default 1. */
  seed?: number;
  /** Default 'random', of sites by their radius 'farthest'. */
  sampling?: Sampling;
  /**
   * How many sites each component has at least, default 0. For those that it misses, the last ones of
   * others go; the new ones come last.
   */
  perComponent?: number;
}

/** The limits of `GltfLimits` in `core/include/gvd/gltf.h`, by the same names. */
export const gltfLimitNames = [
  'maxJsonBytes',
  'maxObjects',
  'maxVertices',
  'maxTriangles',
  'maxZeroElements',
] as const;
export type GltfLimitName = (typeof gltfLimitNames)[number];

/**
 * What a file may ask for, so that a small file cannot take all memory or hours. The error of a file that
 * asks for more names the limit to raise. Vertices and triangles are limited in every format.
 */
export type GltfLimits = Partial<Record<GltfLimitName, number>>;

/** `MeshOptions` in `core/include/gvd/triangle_mesh.h`; `MeshInfo.repairs` counts what was done. */
export interface MeshOptions extends TaskOptions {
  limits?: GltfLimits;
  /** Which of several models in a folder or a zip: its path there. */
  file?: string;
  /**
   * How far apart vertices may be to be welded, as a share of the bounding box's diagonal, 0 … 1.
   * Default 0: only where their positions are the same.
   */
  weld?: number;
  /** Default 'unify'. */
  orientation?: Orientation;
  /** Components with fewer triangles than this are dropped. Default 0. */
  minComponent?: number;
}

/**
 * Bytes, or what gives them if the model needs them, like a `File`; to a worker, only real ones of these
 * can be sent.
 */
export type ModelFile = Uint8Array | { arrayBuffer(): Promise<ArrayBuffer> };

/**
 * The files of a folder by their paths in it: one model, with the files that it names and any others.
 * What a glTF names may also be given by the very URI that it uses (`gltfResourceUris` lists these).
 */
export type ModelFiles = Record<string, ModelFile>;

/**
 * A model (glTF with or without Draco or meshopt, OBJ, PLY, STL, or a zip of one) as bytes or `Blob`,
 * or with all its files; or triangles.
 */
export type MeshSource = Uint8Array | ArrayBuffer | Blob | ModelFiles | MeshArrays;

/** Three numbers per vertex, three vertices per triangle; per vertex also 3, 2 and 1 numbers, or none. */
export interface MeshArrays {
  positions: ArrayLike<number>;
  indices: ArrayLike<number>;
  normals?: ArrayLike<number>;
  uvs?: ArrayLike<number>;
  density?: ArrayLike<number>;
}

/** One region of a diagram: views of its arrays, computed when asked for. */
export interface Region {
  readonly label: number;
  readonly area: number;
  /** Each a list of indices into `points`. */
  readonly loops: Int32Array[];
  /** Labels of the regions it shares an arc with, ascending. */
  readonly neighbours: number[];
}

/**
 * A diagram. Sites can come, go and move: only the surroundings are computed anew, and only what has
 * changed is handed over. The first change traces the whole diagram once more; after a tessellation,
 * its distances are found again, too.
 * Calls are carried out in their order; `sites`, `data` and `regions` are those after the last one
 * that has resolved.
 */
export interface Diagram extends Disposable {
  readonly metric: Metric;
  /**
   * By label; one that has been removed is of face -1, with coordinates 0. Whatever takes sites takes
   * this list, and gives the others the same labels.
   */
  readonly sites: SurfacePoints;
  /** Put together on the calling thread when it is asked for after changes. */
  readonly data: DiagramData;
  readonly regions: readonly Region[];
  /**
   * The same as `data` after all changes asked for so far, put together by the engine after changes: with
   * `loadWorker()`, the calling thread has no work with it. `data` and `regions` are of it then.
   */
  fetchData(options?: TaskOptions): Promise<DiagramData>;
  /** Adds a site, given as a list of one; it gets the lowest label that is free. */
  insertSite(site: SurfacePointsInput, options?: TaskOptions): Promise<DiagramChange>;
  moveSite(label: number, site: SurfacePointsInput, options?: TaskOptions): Promise<DiagramChange>;
  /**
   * The other sites keep their labels; this one's region is empty from then on, and all that is made of
   * the diagram leaves it out. Labels at the end that have no site do not count any more.
   */
  removeSite(label: number, options?: TaskOptions): Promise<DiagramChange>;
  /**
   * The nearest site by distance. Beside a bisector that may be the site beyond it: regions, as they
   * are drawn, end at bisectors that are straight within each triangle, or part of one (`detail`).
   * The site is searched for from each point: as long as the way to it has triangles to cross.
   */
  locate(points: SurfacePointsInput, options?: TaskOptions): Promise<Located>;
  /**
   * Where one more site would be, a list of one: in the worst region, far from its site; on a component
   * without a site, if there is one.
   */
  worstRegionPoint(worst: WorstRegion, options?: TaskOptions): Promise<SurfacePoints>;
  /** The shortest path from a point, given as a list of one, to its nearest site. */
  path(point: SurfacePointsInput, options?: TaskOptions): Promise<SurfacePath>;
  /** The mesh cut into the regions. */
  partition(options?: PartitionOptions): Promise<Partition>;
  /**
   * The polygonal base mesh: a vertex per site, ascending by label (`vertexLabel` has it), a polygon per
   * Voronoi point. It is a manifold with the topology of the surface if there are no `violations`.
   */
  dual(options?: DualOptions): Promise<PolygonMesh>;
  /** The sides of the dual as paths on the surface, one per arc. */
  dualPaths(options?: TaskOptions): Promise<DualPaths>;
  /** Why the dual is no faithful picture of the surface; nothing if it is. */
  violations(options?: TaskOptions): Promise<Violation[]>;
  /** How good the dual is as a remesh of the surface. */
  remeshQuality(options?: TaskOptions): Promise<RemeshQuality>;
  /**
   * A diagram of these sites and as few more as a greedy choice finds, without violations: this one
   * itself if it has none.
   */
  repair(options?: RepairOptions): Promise<Diagram>;
  dispose(): void;
}

export interface Mesh extends Disposable {
  readonly info: MeshInfo;
  /** The input in world space: x, y, z per input vertex, three vertices per input triangle. */
  readonly positions: Float64Array;
  readonly indices: Int32Array;
  /** Per input vertex normals (3 numbers) and texture coordinates (2); empty if it came without. */
  readonly normals: Float64Array;
  readonly uvs: Float64Array;
  /** Per input vertex: _DENSITY of a glTF, the property `density` of a PLY; empty if it came without. */
  readonly density: Float64Array;
  /** Of a glTF; empty for other meshes. */
  readonly parts: readonly MeshPart[];
  /**
   * Sites, by default independent and evenly spread by area; the same seed (an integer, default 1)
   * gives the same sites everywhere. 'farthest' gives fewer than asked for when it has come to
   * every vertex. With a radius, in the input's units, instead of a count: as many as it takes until
   * no vertex is farther from a site; of 'poisson', besides, no two sites are nearer to each other.
   * These distances are approximate.
   */
  sampleSites(count: number | { radius: number }, options?: SampleOptions): Promise<SurfacePoints>;
  /** What no site of these can reach, for want of one on the component. */
  bareComponents(sites: SurfacePointsInput, options?: TaskOptions): Promise<BareComponents>;
  /**
   * Per input vertex a density that follows curvature, of mean 1: with it, regions are smaller where
   * the surface bends more. `core/include/gvd/curvature.h` holds the definition.
   */
  curvatureDensity(options?: TaskOptions): Promise<Float64Array>;
  /**
   * The points of the surface closest to places in space: x, y, z each, in the frame and the unit of
   * `positions`. They can be sites at once. Of points that are as close, to rounding, it is any; of
   * triangles at the very same distance, the first one has it. The first call makes a tree of the
   * triangles, in O(n log n); a place near the surface then takes O(log n), a few microseconds.
   */
  closestPoints(positions: ArrayLike<number>, options?: TaskOptions): Promise<ClosestPoints>;
  /** The diagram of sites, of which some may lie in one place; a label each, by their order. */
  voronoi(sites: SurfacePointsInput, options?: VoronoiOptions): Promise<Diagram>;
  /** The nearest site of every input vertex, how far it is, and in which direction from the site. */
  distances(sites: SurfacePointsInput, options?: DistancesOptions): Promise<Distances>;
  /**
   * The shortest path between two points, given as a list of one each; exact. What lies farther off than
   * the path is long is not looked at.
   */
  path(
    from: SurfacePointsInput,
    to: SurfacePointsInput,
    options?: TaskOptions,
  ): Promise<SurfacePath>;
  /**
   * Moves sites to the centroids of their regions: a state per iteration, the first that of the
   * sites given. Leaving the loop ends it.
   */
  cvt(sites: SurfacePointsInput, options?: CvtOptions): AsyncGenerator<CvtState, void, void>;
  /**
   * An isotropic remesh: the diagram of the sites moved to the centroids of their regions, with as many
   * more as it takes until its dual is valid. These move, too, in two more rounds at most, so `dual()`
   * and `remeshQuality()` of it are the remesh and how good that is. Sites given keep their labels.
   */
  remesh(sites: SurfacePointsInput, options?: RemeshOptions): Promise<Diagram>;
  dispose(): void;
}

/**
 * The library, loaded. `load()` runs it on the calling thread, `loadWorker()` in a module worker;
 * both answer through this interface, and nothing a caller sees differs.
 */
export interface GeodesicVoronoi extends Disposable {
  readonly version: string;
  mesh(source: MeshSource, options?: MeshOptions): Promise<Mesh>;
  dispose(): void;
}
