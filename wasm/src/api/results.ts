// SPDX-License-Identifier: MIT
//
// The results of the library: plain data, yours to keep. `records.cpp` and the bindings beside it fill
// in these fields by their names.

/** 'exact', the default, is the polyhedral distance; 'dgpc' is approximate, and quicker. */
export type Metric = (typeof metrics)[number];
export const metrics = ['exact', 'dgpc'] as const;

/** How a tessellation moves sites: by Lloyd's method, or by quasi-Newton steps, of which it needs fewer. */
export type CvtMethod = (typeof cvtMethods)[number];
export const cvtMethods = ['lloyd', 'lbfgs'] as const;

/**
 * How sites are placed. 'random': independently; 'farthest': each at the vertex farthest from those
 * before; 'poisson': at random, but no two nearer than a radius; a `WorstRegion`: each in the worst
 * region of those before.
 */
export type Sampling = (typeof samplings)[number] | WorstRegion;
export const samplings = ['random', 'farthest', 'poisson'] as const;

/**
 * Which region is the worst. 'size': the largest; 'distortion': the one whose logarithmic map is
 * most distorted, because the surface is bent or the map torn.
 */
export type WorstRegion = (typeof worstRegions)[number];
export const worstRegions = ['size', 'distortion'] as const;

/**
 * 'unify' turns triangles over to agree with the majority of their component; 'keep' turns none
 * over, and cuts edges whose two triangles disagree.
 */
export type Orientation = (typeof orientations)[number];
export const orientations = ['unify', 'keep'] as const;

/**
 * A list of points on a surface. `face[i]` counts the input's triangles in scene order,
 * `bary[3i…3i+2]` are the barycentric coordinates in the order of that triangle's corners.
 */
export interface SurfacePoints {
  face: Int32Array<ArrayBuffer>;
  bary: Float64Array<ArrayBuffer>;
}

/** Surface points with their places in space: x, y, z each. */
export type PlacedPoints = SurfacePoints & { position: Float64Array<ArrayBuffer> };

/** The points of a surface closest to places in space, in the order of the places. */
export type ClosestPoints = PlacedPoints & {
  /** The straight distance of each from its place, in the input's units. */
  distance: Float64Array<ArrayBuffer>;
};

/**
 * What the mesh builder did to make a manifold of the input, and to give every triangle a height;
 * all zero for a clean mesh. In this order: triangles with a corner that is not finite are dropped,
 * vertices are welded, degenerate and duplicate triangles dropped, T-junctions joined, edges of three
 * or more triangles cut, components oriented and closed again along these edges, small ones dropped,
 * and vertices of several fans split.
 */
export interface MeshRepairs {
  /** Vertices merged into an earlier one at their place. */
  weldedVertices: number;
  /** Vertices joined to a side that they lie within, each by a flat triangle (T-junctions). */
  joinedVertices: number;
  /** Vertices at whose place no kept triangle has a corner. */
  isolatedVertices: number;
  /** Dropped: a corner is NaN or infinite. */
  nonFiniteTriangles: number;
  /** Dropped: two corners at one place. */
  degenerateTriangles: number;
  /** Dropped: the same three corners as an earlier triangle. */
  duplicateTriangles: number;
  /** Edges of three or more triangles, where components are cut apart. */
  nonManifoldEdges: number;
  /** Edges cut because their two triangles disagree in orientation. */
  orientationCuts: number;
  /** Turned over to agree with the majority of their component. */
  flippedTriangles: number;
  /** Components dropped because they have fewer triangles than `minComponent`. */
  smallComponents: number;
  /** The triangles of these components. */
  smallComponentTriangles: number;
  /** Copies made of vertices at which several fans of triangles touch. */
  splitVertices: number;
  /** Kept, but flat or tiny: because of them, all edges count as longer by `mollification`. */
  mollifiedTriangles: number;
  /** The length added to every edge, in the input's units. */
  mollification: number;
}

/** The components of a mesh without a site. */
export interface BareComponents {
  components: number;
  /** In the input's units, squared. */
  area: number;
}

export interface MeshInfo {
  /** Counts of the surface, after welding and repairs. */
  vertices: number;
  faces: number;
  edges: number;
  /** Counts of the input, with `maxEdge` after subdivision. */
  inputVertices: number;
  inputFaces: number;
  components: number;
  boundaryLoops: number;
  eulerCharacteristic: number;
  genus: number;
  /**
   * Whether boundary vertices nearly coincide: within 1e-6 of the bounding diagonal, not joined by
   * an edge. Mostly rounding has made two of one, and `weld` joins them.
   */
  hasOpenSeams: boolean;
  /**
   * Whether boundary vertices lie within boundary edges (T-junctions, as programs that cut solids
   * often leave). No path leads across, unless `weld` joins them.
   */
  hasTJunctions: boolean;
  /** In the input's units, squared. */
  area: number;
  /** Length of the bounding box's diagonal. */
  boundingDiagonal: number;
  repairs: MeshRepairs;
  origin: MeshOrigin;
  /** A sentence for each thing that was passed over, changed or found suspicious. */
  notes: string[];
}

/** A list of lists of point indices: list i is `points[offset[i]] … points[offset[i + 1] - 1]`. */
export interface PointLists {
  offset: Int32Array<ArrayBuffer>;
  points: Int32Array<ArrayBuffer>;
}

/**
 * A geodesic Voronoi diagram as flat arrays. Those of a `Diagram` are its own: copy them before they
 * are transferred. Labels are indices into the list of sites. Left and right are as seen from the side
 * on which triangles are counterclockwise, after the mesh builder has turned some over.
 */
export interface DiagramData {
  siteCount: number;
  /** The points that the fields below refer to by index, each place once. */
  points: PlacedPoints;
  /** Per bisector segment: two points, its left (lower) and right label, its face and its arc. */
  segments: {
    points: Int32Array<ArrayBuffer>;
    labels: Int32Array<ArrayBuffer>;
    face: Int32Array<ArrayBuffer>;
    arc: Int32Array<ArrayBuffer>;
  };
  /** Maximal chains of segments with the same two labels, as lists of points; two labels each. */
  arcs: PointLists & { labels: Int32Array<ArrayBuffer> };
  /** Per Voronoi point its index in `points`, and the labels around it, counterclockwise. */
  voronoiPoints: {
    point: Int32Array<ArrayBuffer>;
    labelOffset: Int32Array<ArrayBuffer>;
    labels: Int32Array<ArrayBuffer>;
  };
  /** Closed outlines with their region on the left, ascending by `label`. */
  loops: PointLists & { label: Int32Array<ArrayBuffer> };
  /** The area of each region, by label, in the input's units, squared. */
  regionArea: Float64Array<ArrayBuffer>;
  /**
   * Per input triangle: the label that owns all of it, -1 if no site reaches it, -2 if several
   * regions share it (see `cells`), -3 if the mesh builder dropped it.
   */
  faceLabel: Int32Array<ArrayBuffer>;
  /** Input triangles on which several labels tie; they go to the lowest of these. */
  indifferentFaces: Int32Array<ArrayBuffer>;
  /** The parts of triangles that several regions share: convex polygons, counterclockwise. */
  cells: PointLists & { face: Int32Array<ArrayBuffer>; label: Int32Array<ArrayBuffer> };
}

/**
 * How a change of one site has changed a diagram; everything not listed is as it was. The diagram
 * reads these arrays when it merges them into its own: copy them before they are transferred.
 */
export interface DiagramChange {
  /** The label of the site that came, went or moved. */
  label: number;
  /** The regions that may differ, ascending. */
  labels: Int32Array<ArrayBuffer>;
  /** The input triangles that may differ, ascending; `part` has all cells of each. */
  faces: Int32Array<ArrayBuffer>;
  /**
   * The arrays that replace everything the diagram had of these regions and triangles. Points have
   * numbers of their own here. `faceLabel` has an entry for each of `faces`, `regionArea` for each
   * of `labels`, even if that label has been dropped from the end of the list.
   */
  part: Omit<DiagramData, 'siteCount'>;
}

/**
 * The nearest site of every input vertex. A vertex without a triangle is out of reach. Where
 * several parts of the surface touch in a vertex, the part of the first triangle that names it
 * counts.
 */
export interface VertexDistances {
  /** The nearest site, the first one of those that tie; -1 if none reaches the vertex. */
  label: Int32Array<ArrayBuffer>;
  /** In the input's units; Infinity if no site reaches the vertex. */
  distance: Float64Array<ArrayBuffer>;
  /**
   * Two numbers per vertex: the direction in which the shortest path leaves the site, as a unit
   * vector; NaN if there is none. Times the distance, it is the logarithmic map. The x axis is the
   * first side of the site's triangle (corner 0 to 1), the y axis lies to its left, seen from where
   * the corners run counterclockwise; triangles beside a site on an edge or vertex are unfolded
   * around it. Without a meaning at the site itself.
   */
  direction: Float64Array<ArrayBuffer>;
}

/** Distances, with the metric and the sites that they belong to. */
export interface Distances extends VertexDistances {
  metric: Metric;
  /** The sites with the triangles that directions refer to, even if they were given as vertices. */
  sites: SurfacePoints;
}

/** A path on the surface. If there is none, it has no points, and its length is Infinity. */
export interface SurfacePath {
  /**
   * The start, the crossings of edges, the vertices on the way, and the end; one point if start and
   * end are one. Each point is given in a triangle that the path runs through. Between two points
   * the path is straight, within one triangle.
   */
  points: PlacedPoints;
  /**
   * In the input's units. With the metric 'exact' this is the distance; the distance by 'dgpc' may
   * be a little more or less.
   */
  length: number;
}

/** The share of mislabelled area, 0 … 1, above which triangles are too coarse for the sites. */
export const mostMislabelled = 0.01;

/** How well a diagram keeps to its distances: see `Diagram.accuracy`. */
export interface DiagramAccuracy {
  /**
   * The share of the area, 0 … 1, that lies in another region than that of the nearest site: an estimate, from
   * the same points at each call. It is what bisectors cost that are straight within each triangle, and regions
   * between the corners of triangles; of the error of `dgpc` it says nothing. More than
   * `mostMislabelled` means that triangles are too coarse for the sites.
   */
  mislabelled: number;
  /**
   * The option `maxEdge` of a mesh that makes triangles finer, to one digit: fine enough, mostly, for regions of
   * this size, with `detail: 1`, and small enough for the longest edges to be halved at least.
   */
  maxEdge: number;
}

export interface Located {
  /**
   * The nearest site per point; -1 if none reaches it. Of those that tie, the first one whose distances the
   * diagram has all around the point, else the first one.
   */
  label: Int32Array<ArrayBuffer>;
  /** Its distance in the input's units, Infinity if none reaches it. */
  distance: Float64Array<ArrayBuffer>;
}

/**
 * A mesh cut into the regions of a diagram: one mesh of triangles, in which regions share the
 * points on their borders, closed where the input is. Flat arrays, yours to keep or to transfer.
 */
export interface Partition {
  points: PlacedPoints;
  /**
   * Three points per triangle, ascending by label; triangles that no site reaches (-1) come last.
   * `face` is the input triangle that each is part of, and `bary` gives its three corners in that
   * triangle (nine numbers), to interpolate values that input triangles have at their corners.
   */
  triangles: {
    points: Int32Array<ArrayBuffer>;
    label: Int32Array<ArrayBuffer>;
    face: Int32Array<ArrayBuffer>;
    bary: Float64Array<ArrayBuffer>;
  };
  regions: PartitionRegions;
}

/** Facts of each region, by label: zeros for a site without a region, and NaN as its centroid. */
export interface PartitionRegions {
  /** Region i has the triangles `triangleOffset[i] … triangleOffset[i + 1] - 1`. */
  triangleOffset: Int32Array<ArrayBuffer>;
  area: Float64Array<ArrayBuffer>;
  /** The length of the outline: borders, mesh boundary and holes left for indifferent faces. */
  perimeter: Float64Array<ArrayBuffer>;
  /** The part of the perimeter with no region beyond it. */
  boundaryLength: Float64Array<ArrayBuffer>;
  /** The mean of the region's points in space, x, y, z each: off the surface where it bends. */
  centroid: Float64Array<ArrayBuffer>;
  /** The point of each region nearest to its centroid; face -1 for a site without a region. */
  nearCentroid: SurfacePoints;
  components: Int32Array<ArrayBuffer>;
  /** Closed outlines. A region is a disk if components, loops and Euler characteristic are 1. */
  loops: Int32Array<ArrayBuffer>;
  eulerCharacteristic: Int32Array<ArrayBuffer>;
  genus: Int32Array<ArrayBuffer>;
  /** How often a region touches itself in a point; the other counts see it cut apart there. */
  selfTouchings: Int32Array<ArrayBuffer>;
  /** The neighbours of region i from `label[offset[i]]` on, ascending; lengths of the borders. */
  neighbours: {
    offset: Int32Array<ArrayBuffer>;
    label: Int32Array<ArrayBuffer>;
    length: Float64Array<ArrayBuffer>;
  };
}

/**
 * The dual of a diagram, or its regions as polygons. Polygons are counterclockwise, as the surface
 * is, with straight sides. On the mesh boundary, every piece of it in one region gets a point, at its
 * corner if it has one, else in its middle, and the polygons reach to these points.
 */
export interface PolygonMesh {
  points: PlacedPoints;
  faces: PointLists;
  /**
   * In a dual, the region of each point. The sites come first, ascending by label: point i is site
   * i, unless an earlier site has been removed. The points after them are on the boundary.
   */
  vertexLabel: Int32Array<ArrayBuffer>;
  /** In regions as polygons, the region of each face. */
  faceLabel: Int32Array<ArrayBuffer>;
  /** The polygons cut along diagonals: per triangle three points, and the polygon it is part of. */
  triangles: { points: Int32Array<ArrayBuffer>; face: Int32Array<ArrayBuffer> };
  topology: PolygonTopology;
}

/**
 * Per arc of a diagram, in no particular order, the shortest path between its two sites across the
 * arc, over the point of the arc nearest to both. With `detail`, the path of a short arc may have no
 * points: a site that owns no corner of a face has no distances in it from which one could be found.
 */
export interface DualPaths {
  /** Two per path: the labels of the arc, the lower one first. */
  labels: Int32Array<ArrayBuffer>;
  /** Path i has the points `offset[i] … offset[i + 1] - 1`, from site to site. */
  offset: Int32Array<ArrayBuffer>;
  points: PlacedPoints;
}

/** Topology of the polygons, joined at the points they share; points of no polygon do not count. */
export interface PolygonTopology {
  /** If false, boundary loops and genus mean nothing. */
  isManifold: boolean;
  vertices: number;
  edges: number;
  faces: number;
  components: number;
  boundaryLoops: number;
  eulerCharacteristic: number;
  genus: number;
}

/** Reasons why a dual lacks the surface's topology. */
export type ViolationKind =
  /** A component of the mesh has no site. */
  | 'unreachable'
  /** A site owns nothing: another one is at its place. */
  | 'no-region'
  /** A loop of the mesh boundary passes fewer than three runs of regions. */
  | 'few-runs'
  /** Two regions meet along a closed curve, with no third one on it. */
  | 'closed-border'
  /** A region has several components, no outline or several, or a handle. */
  | 'no-disk'
  /** A region comes to one point from two sides. */
  | 'touches-itself'
  /** Two regions meet in several arcs or points. */
  | 'two-meet-twice'
  /** Three or more regions meet in two Voronoi points. */
  | 'three-meet-twice'
  /** None of these, and yet the dual is no manifold of the surface's topology. */
  | 'no-manifold';

export interface Violation {
  kind: ViolationKind;
  /** The regions concerned, ascending. */
  labels: number[];
  /** One sentence that names the regions. */
  message: string;
}

/** How good the triangles of a dual are as a remesh of the surface. */
export interface RemeshQuality {
  triangles: number;
  /** The least angle, and the mean of every triangle's least angle, in degrees: 60 at best. */
  minAngle: number;
  meanMinAngle: number;
  /** The fewest and the most neighbours of an inner vertex: 6 at best; 0 without inner vertices. */
  minValence: number;
  maxValence: number;
  /** The share of inner vertices with 6 neighbours. */
  regularShare: number;
  /** The Hausdorff distance of dual and surface, in the input's units: at most 1 % too low, unless it is tiny. */
  hausdorff: number;
}

export type MeshFormat = 'arrays' | 'glTF' | 'OBJ' | 'OFF' | 'PLY' | 'STL';

/** What a mesh was made from. */
export interface MeshOrigin {
  format: MeshFormat;
  /** The path of the model among its files or in the zip; empty if it had none. */
  file: string;
}

/** The node and the primitive of a glTF that a run of triangles came from; in scene order. */
export interface MeshPart {
  /** The node's name, else the mesh's, else empty. */
  name: string;
  node: number;
  mesh: number;
  primitive: number;
  firstTriangle: number;
  triangleCount: number;
}
