// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "base/disjoint_sets.h"
#include "gvd/diagram.h"

namespace gvd {

/// The bisectors of a diagram as a graph, all ties broken: three segments meet at every inner
/// point, two at every crossing of an element's side, one at a crossing of the mesh boundary. Every
/// segment s has two *darts*, each with its region on the left: dart 2s belongs to the lower label
/// and runs forwards, dart 2s + 1 to the higher one. At most one dart of a region arrives at a
/// point and one leaves it, so the loops of a region follow from its darts, and the mesh boundary
/// in between, without any choice.
///
/// Points whose error bounds overlap are merged. Merging yields Voronoi points of higher degree,
/// Voronoi points on edges and vertices, and bisectors along edges.
struct BisectorGraph {
  /// A point where bisectors meet or cross a side, or a node that is a corner of a cell or of an
  /// outline on the mesh boundary.
  struct Point {
    static constexpr int kNode = -1, kInside = -2;

    int side;    ///< that it is on: the lower of the two halfedges there; else `kNode`, `kInside`
    int next;    ///< in the list of the side's element (`ElementPoints`), -1 for none
    int before;  ///< on a side: the label of the region that ends here, going along that halfedge
    /// On a side: the first segment that ends here, -1 for none. Inside: the index in `inner`.
    int index;
  };
  /// What belongs to an inner point, where three regions meet.
  struct InnerPoint {
    std::array<int, 3> labels;             ///< counterclockwise
    std::array<int, 3> darts{-1, -1, -1};  ///< per label, the first dart added here, -1 for none
  };
  /// A point on the mesh boundary where, going forward, the region `before` ends and `after`
  /// begins; `start` is where its element's part of the halfedge begins.
  struct BoundaryPoint {
    int halfedge;
    double start;  ///< 0 … 1 along the halfedge, exact
    int point;
    int before, after;
  };

  static constexpr int kNoDart = -1;

  std::vector<Point> points;
  std::vector<SurfacePoint> places;  ///< per point
  std::vector<InnerPoint> inner;
  DisjointSets merging;
  std::vector<int> mergedFaces;  ///< faces with merged points, with repetitions

  std::vector<Diagram::Segment> segments;  ///< between points of the graph, without arcs
  /// Next of the region; `kNoDart` where a dart ends at the mesh boundary. There `RegionOutlines`
  /// names the boundary point instead, by a lower number.
  std::vector<int> nextDart;
  std::vector<BoundaryPoint> boundary;

  /// The cells of mixed faces, in the order of elements, with points of the graph.
  PointLists cells;
  std::vector<int> cellFace, cellLabel;

  int labelOf(int dart) const { return segments[dart >> 1].labels[dart & 1]; }
  int tail(int dart) const { return segments[dart >> 1].points[dart & 1]; }
  int tip(int dart) const { return segments[dart >> 1].points[~dart & 1]; }
  bool isNode(int point) const { return points[point].side == Point::kNode; }
  bool isInner(int point) const { return points[point].side == Point::kInside; }
  /// The first dart of a region that was added at an inner point, -1 for none.
  int& innerDart(int point, int label) {
    InnerPoint& p = inner[points[point].index];
    return p.darts[p.labels[0] == label ? 0 : p.labels[1] == label ? 1 : 2];
  }
  /// The dart of a region at a point on the mesh boundary, -1 if there is none.
  int dartAt(int point, int label) const {
    const int dart = 2 * points[point].index;
    return labelOf(dart) == label ? dart : labelOf(dart + 1) == label ? dart + 1 : -1;
  }

  /// `side`, `before` and `index` as in `Point`.
  int addPoint(int face, const Eigen::Vector3d& bary, int side, int before = -1, int index = -1);
  int addInner(int face, const Eigen::Vector3d& bary, const std::array<int, 3>& labels) {
    inner.push_back({labels});
    return addPoint(face, bary, Point::kInside, -1, static_cast<int>(inner.size()) - 1);
  }
  /// A point with the place of a node.
  int addNode(int face, const Eigen::Vector3d& bary) { return addPoint(face, bary, Point::kNode); }
  void addSegment(int from, int to, int left, int right, int face);
  /// Makes a cell of the points added to `cells` since the last one.
  void closeCell(int face, int label) {
    cells.close();
    cellFace.push_back(face);
    cellLabel.push_back(label);
  }
  /// Merges two points. A node becomes the root, so that a merged point on a vertex has exactly its
  /// place; otherwise the lower number does, with a place on a side if either has one. Two nodes
  /// are never merged, however near, because region triangles have them as corners. Returns whether
  /// the points were apart, and are one now.
  bool unite(int a, int b);
};

// The functions below write number by number. The numbers are still in registers; assembling a
// struct first and copying it in larger pieces would have to wait for memory.

inline int BisectorGraph::addPoint(int face, const Eigen::Vector3d& bary, int side, int before,
                                   int index) {
  Point& point = points.emplace_back();
  point.side = side;
  point.next = -1;
  point.before = before;
  point.index = index;
  SurfacePoint& place = places.emplace_back();
  place.face = face;
  for (int i = 0; i < 3; ++i) place.bary[i] = bary[i];
  return static_cast<int>(points.size()) - 1;
}

inline void BisectorGraph::addSegment(int from, int to, int left, int right, int face) {
  Diagram::Segment& segment = segments.emplace_back();
  segment.points[0] = from;
  segment.points[1] = to;
  segment.labels[0] = left;
  segment.labels[1] = right;
  segment.face = face;
  segment.arc = -1;
  nextDart.push_back(kNoDart);
  nextDart.push_back(kNoDart);
}

}  // namespace gvd
