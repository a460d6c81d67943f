// SPDX-License-Identifier: MIT
//
// Outlines of regions: rings of bisectors and mesh boundary, walked along the bisector graph.
#include "diagram/final/region_outlines.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/grouping.h"
#include "base/sorting.h"
#include "mesh/incidence.h"

namespace gvd {
namespace {

using BoundaryPoint = BisectorGraph::BoundaryPoint;

/// The next of a dart that arrives at the first boundary point. One less is at the second, and so
/// on.
constexpr int kFirstBoundaryPoint = -2;

/// Puts boundary points at one place in the order of the exact graph, which rounding may have
/// reversed in their coordinates: the region before a point is the region after the previous one.
void chain(std::span<BoundaryPoint> points) {
  const auto isFirst = [&](const BoundaryPoint& p) {
    return std::none_of(points.begin(), points.end(),
                        [&](const BoundaryPoint& other) { return other.after == p.before; });
  };
  std::iter_swap(points.begin(), std::find_if(points.begin(), points.end(), isFirst));
  for (size_t i = 1; i < points.size(); ++i)
    std::iter_swap(points.begin() + i,
                   std::find_if(points.begin() + i, points.end(), [&](const BoundaryPoint& p) {
                     return p.before == points[i - 1].after;
                   }));
}

}  // namespace

RegionOutlines::RegionOutlines(const FaceComplex& complex, const DistanceField& distances,
                               IndexMap& pointOfNode, const IndexSet* labels, BisectorGraph& graph)
    : mesh_(complex.mesh()),
      complex_(complex),
      distances_(distances),
      pointOfNode_(pointOfNode),
      labels_(labels),
      graph_(graph),
      steps_(graph) {}

bool RegionOutlines::step(long& budget) {
  const size_t darts = 2 * graph_.segments.size();
  const auto boundaryLoops = mesh_.boundaryLoops();
  return sequence_.run(
      [&] {
        orderBoundary();
        points_.reserve(darts);
      },
      [&] { return fillInSlices(isVisited_, darts, '\0', budget); },
      forEach(darts, budget, kQuickRounds,
              [&](int dart) { return isVisited_[dart] ? 1L : traceRing(dart); }),
      forItems(boundaryLoops, budget, kQuickRounds,
               [&](int start) { return traceBoundary(start); }),
      [&] { return steps_.cancel(budget); },
      forEach(steps_, budget, kQuickRounds, [&](int s) { collectOutline(s); }), [&] { sort(); });
}

// --- The mesh boundary ---------------------------------------------------------------------------

int RegionOutlines::vertexPoint(int vertex) {
  if (pointOfNode_[vertex] < 0) {
    const SurfacePoint place = pointAtVertex(mesh_, vertex);
    pointOfNode_.add(vertex, graph_.addNode(place.face, place.bary));
  }
  return pointOfNode_[vertex];
}

/// Puts the boundary points of the graph in order along their halfedges, and makes each the next of
/// the dart that arrives there.
void RegionOutlines::orderBoundary() {
  const std::span boundary(graph_.boundary);
  const auto part = [](const BoundaryPoint& b) { return std::pair(b.halfedge, b.start); };
  sortStably(boundary, [&](const auto& a, const auto& b) { return part(a) < part(b); });
  forEachRun(
      boundary, [&](const auto& a, const auto& b) { return part(a) == part(b); }, chain);
  for (int i = 0; i < static_cast<int>(boundary.size()); ++i)
    if (const int dart = graph_.dartAt(boundary[i].point, boundary[i].after); dart >= 0)
      graph_.nextDart[dart] = kFirstBoundaryPoint - i;
}

/// The index of the first boundary point on a halfedge or on a later one.
int RegionOutlines::firstFrom(int halfedge) const {
  const auto first =
      std::lower_bound(graph_.boundary.begin(), graph_.boundary.end(), halfedge,
                       [](const BoundaryPoint& b, int wanted) { return b.halfedge < wanted; });
  return static_cast<int>(first - graph_.boundary.begin());
}

bool RegionOutlines::isOn(int boundaryPoint, int halfedge) const {
  return boundaryPoint < static_cast<int>(graph_.boundary.size()) &&
         graph_.boundary[boundaryPoint].halfedge == halfedge;
}

/// Adds merged points on a halfedge to the way along the mesh boundary: those at nodes whose share
/// of the halfedge's length is above `after` and at most `upTo`. Where a region has no width, its
/// outline returns through the same points, and the two ways cancel.
void RegionOutlines::addMerged(int halfedge, double after, double upTo) {
  inner_.clear();
  complex_.appendNodesOnBoundary(halfedge, inner_);
  for (const auto& [node, share] : inner_) {
    const int point = pointOfNode_[node];
    if (share > after && share <= upTo && point >= 0 &&
        graph_.merging.isMerged(graph_.merging.root(point)))
      way_.push_back({point, TriangleMesh::faceOf(halfedge)});
  }
}

/// Makes the way along the mesh boundary, forward from a boundary point where a region reaches it
/// to the next one, where the region leaves it. Returns the dart that leaves.
int RegionOutlines::followBoundary(int start, int label) {
  const auto& boundary = graph_.boundary;
  int halfedge = boundary[start].halfedge, next = start + 1;
  double after = boundary[start].start;
  way_.assign(1, {boundary[start].point, TriangleMesh::faceOf(halfedge)});
  while (!isOn(next, halfedge)) {
    addMerged(halfedge, std::exchange(after, 0.0), 1);
    const int vertex = mesh_.tip(halfedge);
    halfedge = mesh_.outgoing(vertex);
    way_.push_back({vertexPoint(vertex), TriangleMesh::faceOf(halfedge)});
    next = firstFrom(halfedge);
  }
  addMerged(halfedge, after, boundary[next].start);
  const int dart = graph_.dartAt(boundary[next].point, label);
  if (dart < 0) throw std::logic_error("a region's outline ends at the boundary of the mesh");
  return dart;
}

// --- Rings ---------------------------------------------------------------------------------------

/// Adds the ring of a dart. Returns how many quick rounds it took.
long RegionOutlines::traceRing(int dart) {
  const int label = graph_.labelOf(dart);
  if (!isTraced(label)) return 1;
  return addRing(label, [&](auto visit) { walkRing(dart, visit); });
}

/// Calls visit(point, face, isOnBoundary) for each step of a ring: its first point and its face.
template <class Visit>
void RegionOutlines::walkRing(int start, Visit visit) {
  const int label = graph_.labelOf(start);
  int dart = start;
  size_t count = 0;
  do {
    if (++count > isVisited_.size())
      throw std::logic_error("a region's outline does not come back to where it begins");
    isVisited_[dart] = true;
    visit(graph_.tail(dart), graph_.segments[dart >> 1].face, false);
    const int next = graph_.nextDart[dart];
    if (next == BisectorGraph::kNoDart)
      throw std::logic_error("a region's outline ends inside the mesh");
    if (next >= 0) {
      dart = next;
    } else {
      dart = followBoundary(kFirstBoundaryPoint - next, label);
      for (const auto& [point, face] : way_) visit(point, face, true);
    }
  } while (dart != start);
}

/// Adds a boundary loop if one region owns all of it: no dart leads to it. Returns how many quick
/// rounds it took.
long RegionOutlines::traceBoundary(int start) {
  const int owner = nearestOf(distances_.at(mesh_.tail(start))).label;
  if (owner < 0 || !isTraced(owner)) return 1;
  int h = start;
  long length = 0;
  do {
    ++length;
    if (isOn(firstFrom(h), h)) return length;
    h = mesh_.outgoing(mesh_.tip(h));
  } while (h != start);
  way_.clear();
  do {
    way_.push_back({vertexPoint(mesh_.tail(h)), TriangleMesh::faceOf(h)});
    addMerged(h, 0, 1);
    h = mesh_.outgoing(mesh_.tip(h));
  } while (h != start);
  return length + addRing(owner, [&](auto visit) {
           for (const auto& [point, face] : way_) visit(point, face, true);
         });
}

/// Adds the ring that `walk` visits: as an outline if it has no merged points, otherwise as steps.
/// Returns the number of its points.
template <class Walk>
long RegionOutlines::addRing(int label, Walk walk) {
  const int ring = ringCount_++, first = static_cast<int>(points_.size());
  bool hasMerged = false;
  walk([&](int point, int, bool) {
    const int root = graph_.merging.root(point);
    hasMerged |= graph_.merging.isMerged(root);
    points_.push_back(root);
  });
  const int count = static_cast<int>(points_.size()) - first;
  if (hasMerged) {
    points_.resize(first);
    steps_.addRing(label, ring, walk);
  } else {
    outlines_.push_back({label, ring, first, count});
  }
  return count;
}

/// Makes an outline of the ring of a step, unless that has been done.
void RegionOutlines::collectOutline(int s) {
  const int first = static_cast<int>(points_.size());
  steps_.takeRing(s, points_);
  const int count = static_cast<int>(points_.size()) - first;
  if (count > 0) outlines_.push_back({steps_.label(s), steps_.ring(s), first, count});
}

/// Sorts outlines by label, those of one label in the order of their rings.
void RegionOutlines::sort() {
  sortStably(std::span(outlines_), [](const Outline& a, const Outline& b) {
    return std::pair(a.label, a.ring) < std::pair(b.label, b.ring);
  });
}

}  // namespace gvd
