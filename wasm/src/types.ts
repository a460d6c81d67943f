// SPDX-License-Identifier: MIT
/// <reference lib="esnext.disposable" preserve="true" />

/** Polyhedral distance, exact, which is the default; or approximate and quicker. */
export type Metric = 'exact' | 'dgpc';

/** How the sites of a centroidal tessellation are found: quasi-Newton steps take fewer iterations. */
export type CvtMethod = 'lloyd' | 'lbfgs';

/**
 * How sites are placed: independently; always at the vertex farthest from those so far; or at random
 * with a distance kept.
 */
export type Sampling = 'random' | 'farthest' | 'poisson';

/**
 * A list of points on a surface. `face[i]` counts the input's triangles in scene order,
 * `bary[3i…3i+2]` are the barycentric coordinates in the order of that triangle's corners.
 */
export interface SurfacePoints {
  face: Int32Array;
  bary: Float64Array;
}

/** Points with where they are in space: x, y, z each. */
export type PlacedPoints = SurfacePoints & { position: Float64Array };

/** What functions take as a list of points: faces with barycentric coordinates, or input vertices. */
export type SurfacePointsInput =
  { face: ArrayLike<number>; bary: ArrayLike<number> } | { vertex: ArrayLike<number> };

/**
 * What the mesh builder did to the input to make a manifold of it, and triangles of all its faces;
 * all zero for a clean mesh. `core/include/gvd/triangle_mesh.h` holds the policy.
 */
export interface MeshRepairs {
  weldedVertices: number;
  isolatedVertices: number;
  nonFiniteTriangles: number;
  degenerateTriangles: number;
  duplicateTriangles: number;
  nonManifoldEdges: number;
  orientationCuts: number;
  flippedTriangles: number;
  splitVertices: number;
  /** Kept, but flat or tiny: for their sake all edges count as longer. */
  mollifiedTriangles: number;
  /** What every edge counts as longer by, in the input's units. */
  mollification: number;
}

export interface MeshInfo {
  /** Of the surface, after welding and repairs. */
  vertices: number;
  faces: number;
  edges: number;
  /** Of the input. */
  inputVertices: number;
  inputFaces: number;
  components: number;
  boundaryLoops: number;
  eulerCharacteristic: number;
  genus: number;
  area: number;
  /** Length of the bounding box's diagonal. */
  boundingDiagonal: number;
  repairs: MeshRepairs;
  /** What the glTF reader passed over, a sentence each. */
  notes: string[];
}

/** A list of lists of point indices: list i is `points[offset[i]] … points[offset[i + 1] - 1]`. */
export interface PointLists {
  offset: Int32Array;
  points: Int32Array;
}

/**
 * A geodesic Voronoi diagram as flat arrays: copies, yours to keep or to transfer. Labels are
 * indices into the list of sites; left and right are as seen with the triangles counterclockwise,
 * those that the mesh builder turned over as it turned them.
 * `core/include/gvd/diagram.h` holds the definitions.
 */
export interface DiagramData {
  siteCount: number;
  /** Every point named below, each place once. */
  points: PlacedPoints;
  /** Bisector segments: two points, the label on the left (the lower) and on the right, the face. */
  segments: { points: Int32Array; labels: Int32Array; face: Int32Array; arc: Int32Array };
  /** Maximal chains of segments of two labels between Voronoi points; two labels per arc. */
  arcs: PointLists & { labels: Int32Array };
  /** Per Voronoi point its point, and the labels around it counterclockwise. */
  voronoiPoints: { point: Int32Array; labelOffset: Int32Array; labels: Int32Array };
  /** Closed outlines with their region on the left, ascending by `label`. */
  loops: PointLists & { label: Int32Array };
  /** Per label. */
  regionArea: Float64Array;
  /**
   * Per input triangle: the label that owns all of it, -1 if no site reaches it, -2 if several
   * regions share it (see `cells`), -3 if the mesh builder dropped it.
   */
  faceLabel: Int32Array;
  /** Input triangles that several labels tie on, given to the lowest of them. */
  indifferentFaces: Int32Array;
  /** The parts of shared triangles: convex polygons, counterclockwise. */
  cells: PointLists & { face: Int32Array; label: Int32Array };
}

/**
 * What a change of one site has made different in a diagram; all else is as it was.
 * `core/include/gvd/dynamic_diagram.h` holds the definitions.
 */
export interface DiagramChange {
  /** Of the site that came, went or moved. */
  label: number;
  /** The regions that may differ, ascending. */
  labels: Int32Array;
  /** The input triangles that may differ: in each of them, all cells are given. */
  faces: Int32Array;
  /**
   * What replaces all that there was of these regions and triangles; points are numbered anew.
   * `faceLabel` is given per entry of `faces`, `regionArea` per entry of `labels`, also of a label at
   * the end that has gone.
   */
  part: Omit<DiagramData, 'siteCount'>;
}

/**
 * The distances of the nearest sites, per input vertex. A vertex that belongs to no triangle is out of
 * reach; one at which several parts of the surface touch counts to the first triangle that names it.
 */
export interface VertexDistances {
  /** The nearest site, the first one of those that tie; -1 if none reaches the vertex. */
  label: Int32Array;
  /** In the input's units; Infinity if no site reaches the vertex. */
  distance: Float64Array;
  /**
   * Two numbers each: the direction in which the shortest path leaves the site, as a unit vector; NaN
   * if there is none. With the distance, this is the logarithmic map. The x axis is the first side of
   * the site's triangle (corner 0 to 1; to corner 2 if the mesh builder turned it over), the y axis lies
   * to its left; triangles beside a site on an edge or vertex are unfolded counterclockwise. (1, 0)
   * at the site itself.
   */
  direction: Float64Array;
}

/** Distances with what they are of. */
export interface Distances extends VertexDistances {
  metric: Metric;
  /** Also of sites that were given as vertices, the triangles that directions refer to. */
  sites: SurfacePoints;
}

export interface DistancesOptions extends TaskOptions {
  /** Default 'exact'. */
  metric?: Metric;
}

/** A path on the surface; without points, and of length Infinity, if there is none. */
export interface SurfacePath {
  /**
   * The start, the crossings of edges and the vertices that the path meets, and the end; one point if the
   * two are one. Each is in terms of a triangle that the path runs through, and between two of them it is
   * straight, within a triangle.
   */
  points: PlacedPoints;
  /**
   * In the input's units. With the metric 'exact' this is the distance; that of 'dgpc' may be a little
   * more or less.
   */
  length: number;
}

export interface Located {
  /** Nearest site per point, -1 if none reaches it. */
  label: Int32Array;
  /** Its distance in the input's units, Infinity if none reaches it. */
  distance: Float64Array;
}

export interface TaskOptions {
  /** Called with the share done, 0 … 1. */
  onProgress?: (share: number) => void;
  /** Aborting rejects the promise with the signal's reason; nothing is changed. */
  signal?: AbortSignal;
}

export interface VoronoiOptions extends TaskOptions {
  /** Default 'exact'. */
  metric?: Metric;
  /** How many times faces with several regions are split in four. Default 0. */
  detail?: number;
}

export interface PartitionOptions {
  /** Leaves holes where labels tie on a whole face, instead of giving it to the lowest. */
  leaveOutIndifferent?: boolean;
  /** Leaves out the components without a site. */
  leaveOutUnreachable?: boolean;
}

/**
 * A mesh cut into the regions of a diagram: one mesh of triangles, in which regions share the points
 * on their borders, closed where the input is. Flat arrays, yours to keep or to transfer.
 * `core/include/gvd/partition.h` holds the definitions.
 */
export interface Partition {
  points: PlacedPoints;
  /**
   * Three points each, ascending by label, what no site reaches (-1) last. `face` is the input
   * triangle each is part of, and `bary` its corners in terms of it, nine numbers each: what belongs
   * to a triangle's corners is interpolated by these.
   */
  triangles: { points: Int32Array; label: Int32Array; face: Int32Array; bary: Float64Array };
  regions: PartitionRegions;
}

/** Facts of each region, by label; for a site without region zeros, and NaN for the centroid. */
export interface PartitionRegions {
  /** Those of region i are triangles `triangleOffset[i] … triangleOffset[i + 1] - 1`. */
  triangleOffset: Int32Array;
  area: Float64Array;
  /** Of the outline: borders, mesh boundary and holes left for indifferent faces. */
  perimeter: Float64Array;
  /** Of the perimeter, what has no region beyond it. */
  boundaryLength: Float64Array;
  /** In space, three numbers each: off the surface where that is bent. */
  centroid: Float64Array;
  /** The points of the regions nearest to these; face -1 for a site without region. */
  nearCentroid: SurfacePoints;
  components: Int32Array;
  /** Closed outlines. A region is a disk if components, loops and Euler characteristic are 1. */
  loops: Int32Array;
  eulerCharacteristic: Int32Array;
  genus: Int32Array;
  /** How often a region touches itself in a point; the counts take it as cut apart there. */
  selfTouchings: Int32Array;
  /** Those of region i, ascending: `label[offset[i]] … `, and how long the borders with them are. */
  neighbours: { offset: Int32Array; label: Int32Array; length: Float64Array };
}

export interface DualOptions {
  /** The regions as polygons, with the Voronoi points for corners, instead. Default false. */
  primal?: boolean;
}

/**
 * The dual of a diagram, or its regions as polygons; `core/include/gvd/dual.h` says what is done on
 * the mesh boundary. Counterclockwise as the surface is, sides straight in space.
 */
export interface PolygonMesh {
  points: PlacedPoints;
  faces: PointLists;
  /** Per point of a dual, its region: point i is site i, those after are on the boundary. */
  vertexLabel: Int32Array;
  /** Per face of the regions as polygons, its region. */
  faceLabel: Int32Array;
  /** The polygons cut along diagonals: three points each, and the polygon each is part of. */
  triangles: { points: Int32Array; face: Int32Array };
  topology: PolygonTopology;
}

/** Of the polygons welded by their points; points without a polygon do not count. */
export interface PolygonTopology {
  /** If not, boundary loops and genus mean nothing. */
  isManifold: boolean;
  vertices: number;
  edges: number;
  faces: number;
  components: number;
  boundaryLoops: number;
  eulerCharacteristic: number;
  genus: number;
}

/** Why a dual is no faithful picture of the surface, see `Violation` in `core/include/gvd/dual.h`. */
export type ViolationKind =
  | 'unreachable'
  | 'no-region'
  | 'few-runs'
  | 'closed-border'
  | 'no-disk'
  | 'touches-itself'
  | 'two-meet-twice'
  | 'three-meet-twice'
  | 'no-manifold';

export interface Violation {
  kind: ViolationKind;
  /** The regions concerned, ascending. */
  labels: number[];
  /** One sentence that names them. */
  message: string;
}

/** How good the triangles of a dual are as a remesh of the surface. */
export interface RemeshQuality {
  triangles: number;
  /** The least angle, and the mean of each triangle's least one, in degrees: 60 at best. */
  minAngle: number;
  meanMinAngle: number;
  /** Neighbours of a vertex inside: 6 at best; 0 if there is none inside. */
  minValence: number;
  maxValence: number;
  /** Of the vertices inside, the share with 6 neighbours. */
  regularShare: number;
  /** How far the two surfaces are apart at most, either way, by samples; in the input's units. */
  hausdorff: number;
}

export interface RepairOptions extends TaskOptions {
  /** How many sites may be added. Default 1000. */
  maxAdded?: number;
}

export interface CvtOptions {
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
  /** Per input vertex, not negative; default uniform. */
  density?: ArrayLike<number>;
  /** Indices of the sites that stay where they are. */
  fixedSites?: ArrayLike<number>;
  /** Whether every state comes with the arrays of its diagram. Default false. */
  data?: boolean;
  /** Whether every state comes with its diagram, to be asked and changed. Default false. */
  diagrams?: boolean;
  /** Aborting ends the iteration with the signal's reason. */
  signal?: AbortSignal;
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

/** Bytes of the files that a `.gltf` names, by the URI it uses (`gltfResourceUris` lists them). */
export type GltfResources = Record<string, Uint8Array>;

/** Bytes of a glTF, or triangles; these with normals (3) and texture coordinates (2) per vertex. */
export type MeshSource =
  | Uint8Array
  | ArrayBuffer
  | {
      positions: ArrayLike<number>;
      indices: ArrayLike<number>;
      normals?: ArrayLike<number>;
      uvs?: ArrayLike<number>;
    };

/** Where a run of input triangles came from, by the indices of the glTF; in scene order. */
export interface MeshPart {
  /** The node's name, else the mesh's, else empty. */
  name: string;
  node: number;
  mesh: number;
  primitive: number;
  firstTriangle: number;
  triangleCount: number;
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
 * changed is handed over. The first change costs about a diagram more: one that can change is made.
 * Calls are carried out in their order; `sites`, `data` and `regions` are those after the last one
 * that has resolved.
 */
export interface Diagram extends Disposable {
  readonly metric: Metric;
  /** Of a label without a site, face -1. */
  readonly sites: SurfacePoints;
  readonly data: DiagramData;
  readonly regions: readonly Region[];
  /** Adds a site, given as a list of one; it gets the lowest label that is free. */
  insertSite(site: SurfacePointsInput): Promise<DiagramChange>;
  moveSite(label: number, site: SurfacePointsInput): Promise<DiagramChange>;
  /**
   * The other sites keep their labels; this one's region is empty from then on. Labels at the end that
   * have no site do not count any more.
   */
  removeSite(label: number): Promise<DiagramChange>;
  /**
   * The nearest site by distance. Beside a bisector that may be the site beyond it: regions, as they
   * are drawn, end at bisectors that are straight within each triangle, or part of one (`detail`).
   */
  locate(points: SurfacePointsInput): Promise<Located>;
  /** The shortest path from a point, given as a list of one, to its nearest site. */
  path(point: SurfacePointsInput): Promise<SurfacePath>;
  /** The mesh cut into the regions. */
  partition(options?: PartitionOptions): Promise<Partition>;
  /**
   * The polygonal base mesh: a vertex per site, a polygon per Voronoi point. It is a manifold with
   * the topology of the surface if there are no `violations`.
   */
  dual(options?: DualOptions): Promise<PolygonMesh>;
  /** Why the dual is no faithful picture of the surface; nothing if it is. */
  violations(): Promise<Violation[]>;
  /** How good the dual is as a remesh of the surface. */
  remeshQuality(): Promise<RemeshQuality>;
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
  /** Of a glTF; empty for a mesh of arrays. */
  readonly parts: readonly MeshPart[];
  /**
   * Sites, by default independent and evenly spread by area; the same seed (an integer, default 1)
   * gives the same sites everywhere. 'farthest' gives fewer than asked for when it has come to
   * every vertex.
   */
  sampleSites(
    count: number,
    options?: { seed?: number; sampling?: Sampling },
  ): Promise<SurfacePoints>;
  voronoi(sites: SurfacePointsInput, options?: VoronoiOptions): Promise<Diagram>;
  /** The nearest site of every input vertex, how far it is, and in which direction from the site. */
  distances(sites: SurfacePointsInput, options?: DistancesOptions): Promise<Distances>;
  /** The shortest path between two points, given as a list of one each; exact. */
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
  dispose(): void;
}

/**
 * The library, loaded. `load()` runs it on the calling thread, `loadWorker()` in a module worker;
 * both answer through this interface, and nothing a caller sees differs.
 */
export interface GeodesicVoronoi extends Disposable {
  readonly version: string;
  mesh(source: MeshSource, options?: { resources?: GltfResources }): Promise<Mesh>;
  dispose(): void;
}

export type ErrorCode =
  | 'invalid-mesh'
  | 'invalid-gltf'
  | 'invalid-point'
  | 'invalid-argument'
  | 'out-of-memory'
  | 'disposed'
  | 'load-failed'
  | 'internal';
