// SPDX-License-Identifier: MIT
#include "diagram/bisector_graph.h"

#include <utility>

namespace gvd {
namespace {

bool isOnSide(const SurfacePoint& p) { return p.bary.minCoeff() == 0; }

}  // namespace

// What these add is written number by number, for it was just computed so: put together first and
// copied in larger pieces, it would have to get to memory in between.

int BisectorGraph::addPoint(int face, const Eigen::Vector3d& bary, double error, int labelA,
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

void BisectorGraph::addSegment(int from, int to, int left, int right, int face) {
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

void BisectorGraph::unite(int a, int b) {
  a = merging.root(a);
  b = merging.root(b);
  if (a == b || (isNode(a) && isNode(b))) return;
  if (isNode(b) || (!isNode(a) && b < a)) std::swap(a, b);
  mergedFaces.insert(mergedFaces.end(), {places[a].face, places[b].face});
  if (!isOnSide(places[a]) && isOnSide(places[b])) places[a] = places[b];
  merging.unite(a, b);
}

}  // namespace gvd
