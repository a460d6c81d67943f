// SPDX-License-Identifier: MIT
/// <reference lib="esnext.disposable" preserve="true" />
//
// The objects of the library.

import type {
  AccuracyOptions,
  CvtOptions,
  DistancesOptions,
  DualOptions,
  MeshOptions,
  MeshSource,
  PartitionOptions,
  RemeshOptions,
  RepairOptions,
  SampleOptions,
  SurfacePointsInput,
  TaskOptions,
  VoronoiOptions,
} from './options.js';
import type {
  BareComponents,
  ClosestPoints,
  DiagramAccuracy,
  DiagramChange,
  DiagramData,
  Distances,
  DualPaths,
  Located,
  MeshInfo,
  MeshPart,
  Metric,
  Partition,
  PolygonMesh,
  RemeshQuality,
  SurfacePath,
  SurfacePoints,
  Violation,
  WorstRegion,
} from './results.js';

/** A centroidal tessellation after an iteration. */
export interface CvtState {
  /** 0 for the sites given. */
  iteration: number;
  /**
   * Σ ∫ ρ d² over all regions, ρ the density, d the distance to the site. It never rises by more
   * than rounding.
   */
  energy: number;
  /** The farthest that a site moved in this iteration, in the input's units. */
  largestMove: number;
  sites: SurfacePoints;
  /** The arrays of the diagram of these sites, if `data` or `diagrams` is set. */
  data?: DiagramData;
  /** The diagram of these sites, if `diagrams` is set. It is yours: it outlives the iteration. */
  diagram?: Diagram;
}

/** A state if `data` is set. */
export type CvtStateWithData = CvtState & { data: DiagramData };
/** A state if `diagrams` is set. */
export type CvtStateWithDiagram = CvtStateWithData & { diagram: Diagram };

/** One region of a diagram. */
export interface Region {
  readonly label: number;
  /** In the input's units, squared. */
  readonly area: number;
  /** The closed outlines, the region on their left: lists of indices into `DiagramData.points`. */
  readonly loops: Int32Array[];
  /** Labels of the regions it shares an arc with, ascending. */
  readonly neighbours: number[];
}

/**
 * A geodesic Voronoi diagram. Sites can be inserted, moved and removed: only their surroundings are
 * computed anew, and each change returns only what became different. The first change traces the
 * whole diagram once more; in a diagram that a tessellation gave, it computes the distances once
 * more, too.
 *
 * Calls are carried out one after the other, in their order, whether awaited or not: each is about
 * the diagram as the calls before it leave it. Arguments are checked and copied at the call. `sites`,
 * `data` and `regions` are as the last change that has resolved left them.
 */
export interface Diagram extends Disposable {
  readonly metric: Metric;
  /**
   * The sites by label. A label whose site has been removed has face -1 and coordinates 0. Every
   * function that takes sites takes this list as it is, and keeps its labels.
   */
  readonly sites: SurfacePoints;
  /** All arrays. When first read after changes, they are merged on the calling thread. */
  readonly data: DiagramData;
  readonly regions: readonly Region[];
  /**
   * Resolves to `data` after all changes asked for before. The engine puts the arrays together, so
   * with `loadWorker()` the calling thread is spared the work; `data` and `regions` are up to date
   * then.
   */
  fetchData(options?: TaskOptions): Promise<DiagramData>;
  /**
   * Adds a site; it gets the lowest label that is free. If there is not enough memory for a change,
   * this one or another, the diagram is disposed.
   */
  insertSite(site: SurfacePointsInput, options?: TaskOptions): Promise<DiagramChange>;
  /** Moves a site to a point; it keeps its label. */
  moveSite(label: number, site: SurfacePointsInput, options?: TaskOptions): Promise<DiagramChange>;
  /**
   * Removes a site; the others keep their labels. The label then has an empty region, and
   * everything made of the diagram leaves it out. Labels without a site are dropped from the end of
   * `sites`.
   */
  removeSite(label: number, options?: TaskOptions): Promise<DiagramChange>;
  /**
   * The nearest site of each point, by distance. Close to a bisector this may be the site on its
   * other side, because bisectors are drawn straight within each triangle, or each part of one
   * (`detail`). Time per point grows with the number of triangles that its shortest path crosses.
   */
  locate(points: SurfacePointsInput, options?: TaskOptions): Promise<Located>;
  /**
   * How much of the surface lies in another region than that of its nearest site, and how short triangles
   * should be where that is too much. Compares the regions with the distances at some points. Takes about as
   * long as `locate` at these.
   */
  accuracy(options?: AccuracyOptions): Promise<DiagramAccuracy>;
  /**
   * The place for one more site, a list of one: on a component without a site if there is one, else
   * in the worst region, far from its site.
   */
  worstRegionPoint(worst: WorstRegion, options?: TaskOptions): Promise<SurfacePoints>;
  /**
   * The shortest path from a point to its nearest site. With `dgpc` it follows from the distances at
   * vertices; if it would be longer than the distance by more than a tenth, it is the exact one.
   */
  path(point: SurfacePointsInput, options?: TaskOptions): Promise<SurfacePath>;
  /** The mesh cut into the regions. */
  partition(options?: PartitionOptions): Promise<Partition>;
  /**
   * The polygonal base mesh: a vertex per site, ascending by label (see `vertexLabel`), and a
   * polygon per Voronoi point. It is a manifold with the topology of the surface if there are no
   * `violations`.
   */
  dual(options?: DualOptions): Promise<PolygonMesh>;
  /** The sides of the dual as paths on the surface, one per arc. */
  dualPaths(options?: TaskOptions): Promise<DualPaths>;
  /** The reasons why the dual does not have the topology of the surface; empty if it does. */
  violations(options?: TaskOptions): Promise<Violation[]>;
  /** How good the dual is as a remesh of the surface. */
  remeshQuality(options?: TaskOptions): Promise<RemeshQuality>;
  /**
   * A diagram without violations, of these sites and as few more as a greedy choice finds: a new one,
   * to be disposed of like any other. A diagram that has no violations is returned itself.
   */
  repair(options?: RepairOptions): Promise<Diagram>;
  dispose(): void;
}

/** A surface, made from a file or from arrays. */
export interface Mesh extends Disposable {
  readonly info: MeshInfo;
  /**
   * The input in world space: x, y, z per input vertex, three vertices per input triangle. With
   * `maxEdge`, vertices and triangles are those after subdivision, here and everywhere. These arrays
   * and those below are the mesh's own: copy them before they are transferred.
   */
  readonly positions: Float64Array;
  readonly indices: Int32Array;
  /** With `maxEdge`: per triangle, ascending, the one of the file or the arrays that it is part of. */
  readonly parents: Int32Array;
  /** Normals (3 numbers) and texture coordinates (2) per input vertex; empty without. */
  readonly normals: Float64Array;
  readonly uvs: Float64Array;
  /** Per input vertex: _DENSITY of a glTF, `density` of a PLY or of arrays; empty without. */
  readonly density: Float64Array;
  /** The primitives of a glTF that the triangles came from; empty for other meshes. */
  readonly parts: readonly MeshPart[];
  /**
   * Samples sites on the surface, by default independently and uniformly by area. The same seed
   * (an integer, default 1) gives the same sites everywhere. 'farthest' gives fewer than asked for
   * once it has used every vertex. A radius, in the input's units, instead of a count gives as many
   * sites as it takes for every vertex to be within that radius of a site; with 'poisson', no two
   * sites are nearer to each other than the radius, either, by approximate distances.
   */
  sampleSites(count: number | { radius: number }, options?: SampleOptions): Promise<SurfacePoints>;
  /** The components that have none of these sites, so that no site reaches them. */
  bareComponents(sites: SurfacePointsInput, options?: TaskOptions): Promise<BareComponents>;
  /**
   * A density per input vertex, of mean 1 over the surface, that follows curvature: with it, regions are smaller
   * where the surface bends more: the sum of the squared principal curvatures, smoothed, and raised
   * where it is so small that flat parts would get no sites.
   */
  curvatureDensity(options?: TaskOptions): Promise<Float64Array<ArrayBuffer>>;
  /**
   * The points of the surface closest to places in space, given as x, y, z each in the frame and
   * the unit of `positions`. The result can be passed as sites. Of points that are equally close up
   * to rounding, any one is given; of triangles at the very same distance, the first. The first
   * call builds a tree of the triangles, in O(n log n); a place near the surface then takes
   * O(log n), a few microseconds.
   */
  closestPoints(positions: ArrayLike<number>, options?: TaskOptions): Promise<ClosestPoints>;
  /**
   * The points in a JSON file, parsed: a list of points in any form, places also as
   * `[[x, y, z], …]`, or the sites of a result. Refuses those that the file says belong to another
   * mesh. With `maxEdge`, points of the mesh before subdivision, as the file says, are put where they
   * were.
   */
  readPoints(json: unknown, options?: TaskOptions): Promise<SurfacePoints>;
  /**
   * Where points of the surface are: x, y, z each, in the frame and the unit of `positions`. NaN for
   * a label without a site (`Diagram.sites`).
   */
  positionsOf(
    points: SurfacePointsInput,
    options?: TaskOptions,
  ): Promise<Float64Array<ArrayBuffer>>;
  /**
   * The diagram of sites, at least one, labelled by their order. Several may lie in one place: the
   * first of them gets the region, the others an empty one. A site that is nearest on n vertices takes
   * about O(n) with `dgpc`; with `exact` O(n²) at worst, about O(n^1.5) on most meshes.
   */
  voronoi(sites: SurfacePointsInput, options?: VoronoiOptions): Promise<Diagram>;
  /**
   * For every input vertex: its nearest site, the distance, and the direction from the site. At least
   * one site is needed; the time is that of `voronoi`.
   */
  distances(sites: SurfacePointsInput, options?: DistancesOptions): Promise<Distances>;
  /**
   * The exact shortest path between two points, whatever the metric of diagrams. The search keeps to
   * an ellipse around them.
   */
  path(
    from: SurfacePointsInput,
    to: SurfacePointsInput,
    options?: TaskOptions,
  ): Promise<SurfacePath>;
  /**
   * Moves sites to the centroids of their regions. Yields a state per iteration, the first one for
   * the sites given. Leaving the loop ends the computation.
   */
  cvt(
    sites: SurfacePointsInput,
    options: CvtOptions & { diagrams: true },
  ): AsyncGenerator<CvtStateWithDiagram, void, void>;
  cvt(
    sites: SurfacePointsInput,
    options: CvtOptions & { data: true },
  ): AsyncGenerator<CvtStateWithData, void, void>;
  cvt(sites: SurfacePointsInput, options?: CvtOptions): AsyncGenerator<CvtState, void, void>;
  /**
   * An isotropic remesh: a diagram whose `dual()` is the remesh, and whose `remeshQuality()` says
   * how good that is. The sites move to the centroids of their regions, then sites are added until
   * the dual is valid; after that all move again, in two more rounds at most, each of which adds no
   * more than half as many sites as the one before. Sites that the last round added move on while
   * the least angle grows and the dual stays valid. Sites given keep their labels.
   */
  remesh(sites: SurfacePointsInput, options?: RemeshOptions): Promise<Diagram>;
  dispose(): void;
}

/**
 * The library, loaded. `load()` runs it on the calling thread, `loadWorker()` in a module worker;
 * both have this interface and give the same results.
 */
export interface GeodesicVoronoi extends Disposable {
  readonly version: string;
  /** Opens a model, or makes a mesh of triangles. */
  mesh(source: MeshSource, options?: MeshOptions): Promise<Mesh>;
  dispose(): void;
}
