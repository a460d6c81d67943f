// SPDX-License-Identifier: MIT
//
// What the library answers with: plain data, copies, yours to keep or to transfer. `records.cpp` and
// the bindings beside it fill in these fields by their names.

/** Polyhedral distance, exact, which is the default; or approximate and quicker. */
export type Metric = (typeof metrics)[number];
export const metrics = ['exact', 'dgpc'] as const;

/** How the sites of a centroidal tessellation are found: quasi-Newton steps take fewer iterations. */
export type CvtMethod = (typeof cvtMethods)[number];
export const cvtMethods = ['lloyd', 'lbfgs'] as const;

/**
 * How sites are placed: independently; always at the vertex farthest from those so far; at random
 * with a distance kept; or always in the worst region of those so far.
 */
export type Sampling = (typeof samplings)[number] | WorstRegion;
export const samplings = ['random', 'farthest', 'poisson'] as const;

/**
 * Which region is the worst: the largest; or the one of which the logarithmic map is most distorted,
 * since it is bent or torn. `core/include/gvd/sampling.h` holds the definitions.
 */
export type WorstRegion = (typeof worstRegions)[number];
export const worstRegions = ['size', 'distortion'] as const;

/**
 * What becomes of the sides of triangles: those of a component are turned over to agree with its
 * majority; or all are kept, and edges cut where they disagree.
 */
export type Orientation = (typeof orientations)[number];
export const orientations = ['unify', 'keep'] as const;

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

/** The points of a surface closest to places in space, in the order of these. */
export type ClosestPoints = PlacedPoints & {
  /** How far each is from its place, along a straight line, in the input's units. */
  distance: Float64Array;
};

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
  /** With fewer triangles than `minComponent`, dropped, and the triangles of these. */
  smallComponents: number;
  smallComponentTriangles: number;
  splitVertices: number;
  /** Kept, but flat or tiny: for their sake all edges count as longer. */
  mollifiedTriangles: number;
  /** What every edge counts as longer by, in the input's units. */
  mollification: number;
}

/** The components of a mesh without a site. */
export interface BareComponents {
  components: number;
  /** In the input's units, squared. */
  area: number;
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
  origin: MeshOrigin;
  /** What the reader of a file passed over or changed, a sentence each. */
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

/**
 * The dual of a diagram, or its regions as polygons; `core/include/gvd/dual.h` says what is done on
 * the mesh boundary. Counterclockwise as the surface is, sides straight in space.
 */
export interface PolygonMesh {
  points: PlacedPoints;
  faces: PointLists;
  /**
   * Per point of a dual, its region. The sites come first, ascending by label: point i is site i, unless
   * sites before it have been removed. Points after them are on the boundary.
   */
  vertexLabel: Int32Array;
  /** Per face of the regions as polygons, its region. */
  faceLabel: Int32Array;
  /** The polygons cut along diagonals: three points each, and the polygon each is part of. */
  triangles: { points: Int32Array; face: Int32Array };
  topology: PolygonTopology;
}

/**
 * Per arc of a diagram, in no certain order, the shortest path between its two sites that crosses it.
 * `core/include/gvd/dual.h` holds the definition.
 */
export interface DualPaths {
  /** Two per path: those of the arc, the lower one first. */
  labels: Int32Array;
  /** Those of path i are points `offset[i] … offset[i + 1] - 1`, from site to site. */
  offset: Int32Array;
  points: PlacedPoints;
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

export type MeshFormat = 'arrays' | 'glTF' | 'OBJ' | 'PLY' | 'STL';

/** What a mesh was made from. */
export interface MeshOrigin {
  format: MeshFormat;
  /** Path of the model among its files or in the zip; empty if it came without. */
  file: string;
}

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
