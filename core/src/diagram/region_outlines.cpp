// SPDX-License-Identifier: MIT
//
// Outlines of regions: rings of bisectors and mesh boundary, walked along the bisector graph.
#include "diagram/region_outlines.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include "base/grouping.h"
#include "base/sorting.h"
#include "mesh/representations.h"

namespace gvd {

PlaceOfLine placeOfLine(const BisectorGraph& graph, int from, int to, int face) {
  const bool anyFace = graph.merging.isMerged(from) && graph.merging.isMerged(to);
  return {std::min(from, to), std::max(from, to), anyFace ? -1 : face};
}

RegionOutlines::RegionOutlines(const TriangleMesh& mesh, const DistanceField& distances,
                               NodePoints& nodePoints, std::span<const char> isTraced,
                               BisectorGraph& graph)
    : mesh_(mesh),
      distances_(distances),
      nodePoints_(nodePoints),
      isTraced_(isTraced),
      graph_(graph) {}

bool RegionOutlines::step(long& budget) {
  const size_t darts = 2 * graph_.segments.size();
  return sequence_.run(
      [&] {
        orderBoundary();
        points_.reserve(darts);
      },
      [&] { return fillInSlices(isVisited_, darts, '\0', budget); },
      [&] { return traceRings(budget); }, [&] { return traceUnbrokenBoundaries(budget); },
      [&] { return loop_.run(steps_.size(), budget, 1, [&](int s) { cancelStep(s); }); },
      [&] { return forgetWaiting(budget); },
      [&] {
        return loop_.run(steps_.size(), budget, kQuickRounds, [&](int s) { collectOutline(s); });
      },
      [&] { sort(); });
}

// --- The mesh boundary ---------------------------------------------------------------------------

/// Puts the boundary points in order along their halfedges.
void RegionOutlines::orderBoundary() {
  auto& boundary = graph_.boundary;
  const auto part = [](const BisectorGraph::BoundaryPoint& b) {
    return std::pair(b.halfedge, b.start);
  };
  sortStably(std::span(boundary), [&](const auto& a, const auto& b) { return part(a) < part(b); });
  forEachRun(
      std::span(boundary), [&](const auto& a, const auto& b) { return part(a) == part(b); },
      [](std::span<BisectorGraph::BoundaryPoint> run) { chain(run); });
  for (int i = 0; i < static_cast<int>(boundary.size()); ++i)
    boundaryIndex_.push_back({boundary[i].point, i});
  sortStably(std::span(boundaryIndex_), std::less<>());
}

/// Puts boundary points at one place in the order of the exact graph, which rounding may have
/// reversed in their coordinates: the region before a point is the region after the previous one.
void RegionOutlines::chain(std::span<BisectorGraph::BoundaryPoint> points) {
  const auto isFirst = [&](const auto& p) {
    return std::none_of(points.begin(), points.end(),
                        [&](const auto& other) { return other.after == p.before; });
  };
  std::iter_swap(points.begin(), std::find_if(points.begin(), points.end(), isFirst));
  for (size_t i = 1; i < points.size(); ++i)
    std::iter_swap(points.begin() + i,
                   std::find_if(points.begin() + i, points.end(),
                                [&](const auto& p) { return p.before == points[i - 1].after; }));
}

int RegionOutlines::boundaryIndexOf(int point) const {
  const auto place =
      std::lower_bound(boundaryIndex_.begin(), boundaryIndex_.end(), std::array<int, 2>{point, 0});
  if (place == boundaryIndex_.end() || (*place)[0] != point)
    throw std::logic_error("a region's outline ends inside the mesh");
  return (*place)[1];
}

/// The first boundary point on a halfedge, -1 if there is none.
int RegionOutlines::firstOnBoundary(int halfedge) const {
  const auto& boundary = graph_.boundary;
  const auto first =
      std::lower_bound(boundary.begin(), boundary.end(), halfedge,
                       [](const auto& b, int wanted) { return b.halfedge < wanted; });
  const bool isThere = first != boundary.end() && first->halfedge == halfedge;
  return isThere ? static_cast<int>(first - boundary.begin()) : -1;
}

int RegionOutlines::vertexPoint(int vertex) {
  return nodePoints_.at(vertex, [&] {
    const SurfacePoint place = pointAtVertex(mesh_, vertex);
    return graph_.addNode(place.face, place.bary);
  });
}

/// Follows the mesh boundary forward from the point where a region reaches it to the next point
/// where the region leaves it. Returns the dart that leaves.
template <class Visit>
int RegionOutlines::followBoundary(int point, int label, Visit visit) {
  const auto& boundary = graph_.boundary;
  const int start = boundaryIndexOf(point);
  int halfedge = boundary[start].halfedge;
  visit(point, TriangleMesh::faceOf(halfedge), true);
  int index = start + 1;
  if (index == static_cast<int>(boundary.size()) || boundary[index].halfedge != halfedge)
    index = -1;
  while (index < 0) {
    const int vertex = mesh_.tip(halfedge);
    halfedge = mesh_.outgoing(vertex);
    visit(vertexPoint(vertex), TriangleMesh::faceOf(halfedge), true);
    index = firstOnBoundary(halfedge);
  }
  const int dart = graph_.dartAt(boundary[index].point, label);
  if (dart < 0) throw std::logic_error("a region's outline ends at the boundary of the mesh");
  return dart;
}

// --- Rings ---------------------------------------------------------------------------------------

bool RegionOutlines::traceRings(long& budget) {
  const int count = static_cast<int>(isVisited_.size());
  for (; nextDart_ < count; ++nextDart_) {
    if (nextDart_ % kQuickRounds == 0) --budget;
    if (budget < 0) return false;
    if (!isVisited_[nextDart_] && isTraced(graph_.labelOf(nextDart_))) traceRing(nextDart_, budget);
  }
  return true;
}

void RegionOutlines::traceRing(int start, long& budget) {
  addRing(
      graph_.labelOf(start), [&](auto visit) { walkRing(start, visit); }, budget);
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
    visit(graph_.tail(dart), graph_.segments[dart / 2].face, false);
    const int next = graph_.nextDart[dart];
    dart = next >= 0 ? next : followBoundary(graph_.tip(dart), label, visit);
  } while (dart != start);
}

/// Traces boundary loops that one region owns entirely; no dart leads to them.
bool RegionOutlines::traceUnbrokenBoundaries(long& budget) {
  const auto loops = mesh_.boundaryLoops();
  for (; nextBoundary_ < static_cast<int>(loops.size()); ++nextBoundary_) {
    if (budget <= 0) return false;
    const int start = loops[nextBoundary_];
    const int owner = nearestOf(distances_.at(mesh_.tail(start))).label;
    if (owner >= 0 && isTraced(owner)) traceUnbroken(start, owner, budget);
    --budget;
  }
  return true;
}

void RegionOutlines::traceUnbroken(int start, int owner, long& budget) {
  const auto forHalfedges = [&](auto body) {
    int h = start;
    do {
      body(h);
      h = mesh_.outgoing(mesh_.tip(h));
    } while (h != start);
  };
  long length = 0;
  bool isBroken = false;
  forHalfedges([&](int h) {
    ++length;
    isBroken |= firstOnBoundary(h) >= 0;
  });
  budget -= length / kQuickRounds;
  if (isBroken) return;
  const auto walk = [&](auto visit) {
    forHalfedges([&](int h) { visit(vertexPoint(mesh_.tail(h)), TriangleMesh::faceOf(h), true); });
  };
  addRing(owner, walk, budget);
}

/// Adds the ring that `walk` visits: as an outline if it has no merged points, otherwise as steps.
template <class Walk>
void RegionOutlines::addRing(int label, Walk walk, long& budget) {
  const int ring = ringCount_++, first = static_cast<int>(points_.size());
  bool hasMerged = false;
  walk([&](int point, int, bool) {
    const int root = graph_.merging.root(point);
    hasMerged |= graph_.merging.isMerged(root);
    points_.push_back(root);
  });
  const int count = static_cast<int>(points_.size()) - first;
  budget -= count / kQuickRounds;
  if (!hasMerged) {
    outlines_.push_back({label, ring, first, count});
    return;
  }
  points_.resize(first);
  const int firstStep = static_cast<int>(steps_.size());
  walk([&](int point, int face, bool isOnBoundary) { addStep(label, point, face, isOnBoundary); });
  closeRing(firstStep);
}

// --- Steps ---------------------------------------------------------------------------------------

void RegionOutlines::addStep(int label, int point, int face, bool isOnBoundary) {
  const int s = static_cast<int>(steps_.size());
  steps_.push_back(
      {label, ringCount_ - 1, graph_.merging.root(point), face, s - 1, s + 1, isOnBoundary, false});
}

/// Makes a ring of the steps since the first one.
void RegionOutlines::closeRing(int first) {
  const auto isMerged = [&](int point) { return graph_.merging.isMerged(point); };
  steps_[first].previous = static_cast<int>(steps_.size()) - 1;
  steps_.back().next = first;
  for (const Step& step : std::span(steps_).subspan(first))
    if (step.isOnBoundary && (isMerged(step.from) || isMerged(tip(step))))
      boundarySteps_.push_back({step.label, step.from, tip(step), step.face});
}

void RegionOutlines::cancelStep(int s) {
  Step& step = steps_[s];
  const int from = step.from, to = tip(step);
  if (from == to) {
    steps_[step.previous].next = step.next;
    steps_[step.next].previous = step.previous;
    step.isGone = true;
  } else if (graph_.merging.isMerged(from) || graph_.merging.isMerged(to)) {
    const auto [low, high, face] = placeOfLine(graph_, from, to, step.face);
    auto& others = waiting_[{step.label, low, high, face}];
    if (!others.empty() && steps_[others.back()].from == to) {
      cancel(s, others.back());
      others.pop_back();
    } else {
      others.push_back(s);
    }
  }
}

/// Frees the lists of steps that stayed uncancelled, in slices because there may be many.
bool RegionOutlines::forgetWaiting(long& budget) {
  for (; !waiting_.empty() && budget > 0; --budget) waiting_.erase(waiting_.begin());
  return waiting_.empty();
}

/// Takes out two opposite steps: the step before each is followed by the step after the other.
void RegionOutlines::cancel(int s, int opposite) {
  Step &a = steps_[s], &b = steps_[opposite];
  const Step formerA = a, formerB = b;
  steps_[formerA.previous].next = formerB.next;
  steps_[formerB.next].previous = formerA.previous;
  steps_[formerB.previous].next = formerA.next;
  steps_[formerA.next].previous = formerB.previous;
  a.isGone = b.isGone = true;
}

/// Makes an outline of the ring of a step, unless that has been done.
void RegionOutlines::collectOutline(int s) {
  const int first = static_cast<int>(points_.size());
  for (Step* step = &steps_[s]; !step->isGone; step = &steps_[step->next]) {
    points_.push_back(step->from);
    step->isGone = true;
  }
  const int count = static_cast<int>(points_.size()) - first;
  if (count > 0) outlines_.push_back({steps_[s].label, steps_[s].ring, first, count});
}

/// Sorts outlines by label, those of one label in the order of their rings.
void RegionOutlines::sort() {
  sortStably(std::span(outlines_), [](const Outline& a, const Outline& b) {
    return std::pair(a.label, a.ring) < std::pair(b.label, b.ring);
  });
}

}  // namespace gvd
