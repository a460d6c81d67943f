// SPDX-License-Identifier: MIT
/// \file
/// The geodesic Voronoi diagram: points, bisector segments, arcs, Voronoi points, outlines and
/// cells in flat arrays, and how they are traced from distances (geodesic.h).
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "gvd/geodesic.h"
#include "gvd/sliced_work.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// A list of lists of point indices in one array: list i has those from `points[offset[i]]` to
/// `points[offset[i + 1] - 1]`.
struct PointLists {
  std::vector<int> offset = {0};
  std::vector<int> points;

  int size() const { return static_cast<int>(offset.size()) - 1; }
  std::span<const int> operator[](int i) const {
    const auto first = offset.begin() + i;
    return {points.data() + first[0], points.data() + first[1]};
  }
  void add(std::span<const int> list) {
    points.insert(points.end(), list.begin(), list.end());
    close();
  }
  /// Makes a list of the points appended to `points` since the last one.
  void close() { offset.push_back(static_cast<int>(points.size())); }
};

/// The geodesic Voronoi diagram of a mesh (Melvær & Reimers 2014), traced.
///
/// Words: a *bisector segment* is a straight piece of a bisector inside one face; an *arc* a
/// maximal chain of segments of the same two labels between Voronoi points, ends on the mesh
/// boundary, or closed; a *Voronoi point* is equidistant from three or more sites; a *loop* is a
/// closed outline of a region. "Left" is as seen with the faces counterclockwise.
struct Diagram {
  static constexpr int kUnreachable = -1;  ///< label of places that no site reaches
  static constexpr int kMixed = -2;        ///< faceLabel of a face with several regions

  int siteCount = 0;  ///< labels are below this number

  /// Every point that the lists below refer to, each place once. `face` counts the mesh's faces.
  /// Points that rounding cannot tell apart are one point. On an edge or a vertex, the coordinates
  /// of the opposite corners are exactly zero. The end of a segment is given in a face of one of
  /// the segments that end there.
  std::vector<SurfacePoint> points;

  /// A bisector segment, oriented forwards: the lower label `labels[0]` is on its left,
  /// `labels[1]` on its right.
  struct Segment {
    std::array<int, 2> points;
    std::array<int, 2> labels;
    int face;
    int arc;
  };
  std::vector<Segment> segments;

  /// Arcs, oriented as their segments; a closed arc repeats its first point at the end.
  PointLists arcs;
  std::vector<std::array<int, 2>> arcLabels;  ///< of each arc, as of its segments

  struct VoronoiPoint {
    int point;
    /// Labels around the point, counterclockwise, the lowest first; a label occurs again where its
    /// region comes to the point twice. Their number is the point's degree.
    std::vector<int> labels;
  };
  std::vector<VoronoiPoint> voronoiPoints;

  /// Closed outlines, the region on the left; the first point is not repeated. They run along the
  /// mesh boundary where the region does, through every boundary vertex there. A region that is a
  /// whole closed component has none.
  PointLists loops;
  std::vector<int> loopLabel;  ///< region of each loop, ascending

  std::vector<double> regionArea;  ///< per label; sums to the area that any site reaches

  /// Per mesh face: its label if one region owns all of it (a region triangle), else `kMixed` or
  /// `kUnreachable`. If bisectors of the neighbour faces meet on a side of a face, the face is
  /// mixed even if one region owns all of it: it then has one cell, with the meeting point as a
  /// corner.
  std::vector<int> faceLabel;
  /// Region triangles on all of which two or more labels tie, given to the lowest of these labels;
  /// ascending. They lie behind saddle vertices and boundary corners at the same distance from
  /// several sites, because the shortest paths from all these sites go on alike from there.
  std::vector<int> indifferentFaces;

  /// The parts of mixed faces: convex polygons, counterclockwise, ascending by face. A point on the
  /// outline of several cells is a corner of all of them, so angles may be straight. Points that
  /// `detail` creates on the side of a region triangle are corners of the cells on the other side
  /// only.
  PointLists cells;
  std::vector<int> cellFace;
  std::vector<int> cellLabel;
};

struct DiagramOptions {
  static constexpr int kMostDetail = 10;

  /// From 0 to `kMostDetail`: how finely mixed faces are split, with distances evaluated at the new
  /// corners: until their mixed parts have no side longer than √2 · 2^-detail times the mean edge
  /// of the mesh. On a scan this splits a face in four, once per level; long thin faces are cut
  /// shorter first. With more detail the bisectors converge to the true curves, but for regions
  /// that own no corner of a face in which they lie: `subdivide` where faces are about as long as
  /// regions. 0: one straight segment per face and bisector. Each further level about doubles the
  /// points, and the time for mixed faces. With the exact metric, the sites also spread once more
  /// each time the longest sides are halved (`DistanceField::distancesAt`), which takes about as
  /// long as `propagate`.
  int detail = 0;
};

/// The diagram of the distances of `siteCount` sites. The same input gives the same diagram to the
/// last bit; permuting the sites permutes the labels, except where they tie. O(F + M log M), M the
/// number of points; for each face with k labels that are nearest or tie at a corner, O(k²) is
/// added, at worst O(k³). The distances must be known at all corners where `DistanceField` says so;
/// a field of another implementation that lacks some may end in `std::logic_error`. Throws
/// `Error(kInvalidArgument)` if the distances are those of another mesh or of more than `siteCount`
/// sites, or if `detail` is negative or more than `kMostDetail`.
Diagram traceDiagram(const TriangleMesh& mesh, const DistanceField& distances, int siteCount,
                     const DiagramOptions& options = {});

/// The same in steps; throws as `traceDiagram` does, at once or in a step. The mesh and the
/// distances must outlive the work.
std::unique_ptr<SlicedWork<Diagram>> startDiagram(const TriangleMesh& mesh,
                                                  const DistanceField& distances, int siteCount,
                                                  const DiagramOptions& options = {});

/// About the share of `propagate` in the time for distances and diagram, 0 … 1, to tell how far
/// both together are. Measured on scans and mechanical parts; it is most of the time without
/// `detail`, and little with it. Throws `Error(kInvalidArgument)` if `detail` is out of its range.
double propagationShare(const DiagramOptions& options);

/// How well a diagram keeps to its distances.
struct DiagramAccuracy {
  /// The share of the area that lies in another region than that of the nearest site, in [0, 1]: an
  /// estimate from points spread uniformly over the surface, the same at each call. A share p comes
  /// out within about √(p / samples). It is what straight bisectors and regions between the corners
  /// of faces cost; of the error of the distances themselves it says nothing. More than a hundredth
  /// means that faces are too coarse for the sites.
  double mislabelled;
  /// The `SubdivisionOptions::maxEdge` that makes faces finer: fine enough, mostly, for regions of
  /// this size, with a `detail` of 1, and the longest edges shorter by half at least.
  double maxEdge;
};

/// Compares a diagram with its distances at `samples` points. O(F), then `DistanceField::nearest`
/// per point, which takes long in fans of thousands of long triangles. Throws
/// `Error(kInvalidArgument)` if `samples` is not positive, the distances are those of another mesh,
/// or the diagram has another number of faces.
DiagramAccuracy accuracy(const TriangleMesh& mesh, const DistanceField& distances,
                         const Diagram& diagram, int samples = 1000);

/// The same in steps. Mesh, distances and diagram must outlive the work.
std::unique_ptr<SlicedWork<DiagramAccuracy>> startAccuracy(const TriangleMesh& mesh,
                                                           const DistanceField& distances,
                                                           const Diagram& diagram,
                                                           int samples = 1000);

}  // namespace gvd
