// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "base/sliced_loop.h"
#include "diagram/point_merging.h"
#include "gvd/diagram.h"

namespace gvd {

/// The bisectors of a diagram as a graph, all ties broken: three segments meet at every inner
/// point, two at every crossing of an element's side, one at a crossing of the mesh boundary. Seen
/// from a region, every segment is a *dart* that has the region on its left: dart 2s of the lower
/// label of segment s, which runs forwards, and dart 2s + 1 of the higher one. At each point at
/// most one dart of a region comes and one leaves, so following darts, and the mesh boundary in
/// between, closes the region's loops without a choice to make.
///
/// As doubles see it, some of its points are one: those whose error bounds overlap. That yields the
/// Voronoi points of higher degree, those on edges and vertices, and bisectors along edges.
struct BisectorGraph {
  /// A point where bisectors meet or cross a side, or a node that the mesh boundary or a cell
  /// passes.
  struct Point {
    double error;               ///< bound on how far rounding has moved it, barycentric
    std::array<int, 3> labels;  ///< of the regions that meet here, -1 for none; a node has none
    std::array<int, 3> darts;   ///< of each, the dart that came or left here first, -1 for none
    int nextOnSide;             ///< list of the points on one side of elements
  };
  /// A point on the mesh boundary, between the regions that own what is before and after it going
  /// forward; `start` is where its element's part of the halfedge begins.
  struct BoundaryPoint {
    int halfedge;
    double start;  ///< 0 … 1 along the halfedge, exact
    int point;
    int before, after;
  };

  std::vector<Point> points;
  std::vector<SurfacePoint> places;  ///< per point
  std::vector<int> innerPoints;      ///< those of three regions, ascending
  PointMerging merging;
  std::vector<int> mergedFaces;  ///< where points have become one, some several times

  std::vector<Diagram::Segment> segments;  ///< between points of the graph, without arcs
  std::vector<int> nextDart;  ///< of the same region; -1 where it comes to the mesh boundary
  std::vector<BoundaryPoint> boundary;

  /// The cells of mixed faces, in the order of elements, with points of the graph.
  PointLists cells;
  std::vector<int> cellFace, cellLabel;

  std::vector<double> regionArea;  ///< as in `Diagram`, as are these:
  std::vector<int> faceLabel, indifferentFaces;

  int labelOf(int dart) const { return segments[dart / 2].labels[dart % 2]; }
  int tail(int dart) const { return segments[dart / 2].points[dart % 2]; }
  int tip(int dart) const { return segments[dart / 2].points[1 - dart % 2]; }
  bool isNode(int point) const { return points[point].labels[0] < 0; }
  int& dartAt(int point, int label) {
    Point& p = points[point];
    return p.darts[p.labels[0] == label ? 0 : p.labels[1] == label ? 1 : 2];
  }

  int addPoint(int face, const Eigen::Vector3d& bary, double error, int labelA, int labelB,
               int labelC);
  /// A point with the place of a node.
  int addNode(int face, const Eigen::Vector3d& bary) { return addPoint(face, bary, 0, -1, -1, -1); }
  void addSegment(int from, int to, int left, int right, int face);
  /// Makes a cell of the points added to `cells` since the last one.
  void closeCell(int face, int label) {
    cells.offset.push_back(static_cast<int>(cells.points.size()));
    cellFace.push_back(face);
    cellLabel.push_back(label);
  }
  /// Makes two points one. A node stands for all, so that a place on a vertex is exactly that; else
  /// the first, at a place on a side if there is one. Two nodes stay two, however near: region
  /// triangles have them as corners.
  void unite(int a, int b);
};

/// The points of the graph at nodes, -1 where there is none (yet). Of a caller that traces again
/// and again, who then need not make the list anew.
class NodePoints {
 public:
  /// Of at least `count` nodes; true when the list is that long.
  bool resize(size_t count, long& budget) { return fillInSlices(point_, count, -1, budget); }
  /// The point at a node, which `make` adds where there is none.
  template <class Make>
  int at(int node, Make make) {
    if (point_[node] < 0) {
      point_[node] = make();
      known_.push_back(node);
    }
    return point_[node];
  }
  /// Forgets all points, in time for their number.
  void clear() {
    for (const int node : known_) point_[node] = -1;
    known_.clear();
  }

 private:
  std::vector<int> point_;
  std::vector<int> known_;
};

// What these add is written number by number, for it was just computed so: put together first and
// copied in larger pieces, it would have to get to memory in between.

inline int BisectorGraph::addPoint(int face, const Eigen::Vector3d& bary, double error, int labelA,
                                   int labelB, int labelC) {
  Point& point = points.emplace_back();
  point.error = error;
  point.labels[0] = labelA;
  point.labels[1] = labelB;
  point.labels[2] = labelC;
  for (int i = 0; i < 3; ++i) point.darts[i] = -1;
  point.nextOnSide = -1;
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
  nextDart.push_back(-1);
  nextDart.push_back(-1);
}

}  // namespace gvd
