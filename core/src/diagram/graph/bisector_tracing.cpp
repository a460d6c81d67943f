// SPDX-License-Identifier: MIT
// This work is based on:
// Eivind Lyche Melvær, Martin Reimers. Approximating Geodesic Voronoi Diagrams on Triangulated
// Surfaces. 2014
#include "diagram/graph/bisector_tracing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <span>
#include <utility>

#include "distance/labelled_distances.h"
#include "mesh/face_metric.h"

namespace gvd {

BisectorTracing::BisectorTracing(FaceComplex& complex, IndexMap& pointOfNode, BisectorGraph& graph,
                                 Diagram& diagram)
    : mesh_(complex.mesh()),
      complex_(complex),
      graph_(graph),
      out_(diagram),
      functions_(complex),
      points_(complex, pointOfNode, graph) {}

bool BisectorTracing::step(long& budget) {
  return sequence_.run(
      [&] { return fillInSlices(out_.regionArea, out_.siteCount, 0.0, budget); },
      [&] {
        return complex_.hasFacesOnly() ||
               fillInSlices(out_.faceLabel, complex_.faceCount(), Diagram::kMixed, budget);
      },
      [&] { return points_.prepare(budget); }, [&] { reserve(); },
      // In order of elements, so that areas are always summed in the same order.
      forEach(complex_.elementCount(), budget, kQuickRounds, [&](int e) { return add(e); }),
      [&] {
        if (complex_.hasFacesOnly()) out_.faceLabel = complex_.takeSoleOwners();
      });
}

/// Reserves the usual memory: most mixed elements have two cells, and every site adds some corners
/// where its bisectors meet, which matters if there are as many sites as elements.
void BisectorTracing::reserve() {
  const int mixedCount = complex_.mixedCount();
  const size_t mixed = mixedCount, atSites = 6 * std::min(out_.siteCount, mixedCount);
  const size_t cells = 5 * mixed / 2 + atSites + complex_.partialCount();  // about as many points
  graph_.points.reserve(cells);
  graph_.places.reserve(cells);
  graph_.inner.reserve(atSites / 3);
  graph_.segments.reserve(5 * mixed / 4 + atSites);
  graph_.nextDart.reserve(5 * mixed / 2 + 2 * atSites);
  graph_.cells.offset.reserve(cells + 1);
  graph_.cells.points.reserve(8 * mixed + 6 * atSites + 4 * complex_.partialCount());
  graph_.cellFace.reserve(cells);
  graph_.cellLabel.reserve(cells);
}

/// Returns how many quick rounds it took.
long BisectorTracing::add(int element) {
  const int owner = complex_.soleOwner(element);
  if (owner == Diagram::kMixed || !complex_.isFace(element)) return kQuickRounds * divide(element);
  assign(element, owner);
  return 1;
}

/// Assigns a face to one label, or to none.
void BisectorTracing::assign(int element, int owner) {
  const int face = complex_.face(element);
  if (!complex_.hasFacesOnly()) out_.faceLabel[complex_.faceIndex(face)] = owner;
  if (owner < 0) return;
  out_.regionArea[owner] += mesh_.faceArea(face);
  if (complex_.isUndecided(element) && isIndifferent(element, owner))
    out_.indifferentFaces.push_back(face);
}

/// Whether some other label ties with the owner at all three nodes, which have ties.
bool BisectorTracing::isIndifferent(int element, int owner) const {
  const int* const node = complex_.nodesOf(element);
  const NodeLabels& nodes = complex_.nodes();
  std::array<double, 3> least;
  for (int i = 0; i < 3; ++i) least[i] = nearestOf(nodes.labels(node[i])).distance;
  return anyLabel(nodes.labels(node[0]), nodes.labels(node[1]), nodes.labels(node[2]),
                  [&](int label, const auto& at) {
                    bool isTie = label != owner;
                    for (int i = 0; i < 3; ++i) isTie &= at[i] && at[i]->distance == least[i];
                    return isTie;
                  });
}

/// Returns the units that it takes: where many labels are near, each of them is compared with the
/// cells.
long BisectorTracing::divide(int element) {
  const int face = complex_.face(element);
  const auto functions = functions_.of(element);
  envelope_.compute(functions);
  points_.make(element, envelope_);
  cellAreas_.clear();
  for (const FaceEnvelope::Cell& cell : envelope_.cells()) {
    cellAreas_.push_back(addCell(element, cell));
    graph_.closeCell(face, envelope_.label(cell.function));
  }
  for (const FaceEnvelope::Segment& segment : envelope_.segments()) addSegment(element, segment);
  points_.mergeEnds(envelope_);
  addAreas(mesh_.faceArea(face));
  return 1 + static_cast<long>(functions.size() * envelope_.cells().size() / kQuickRounds);
}

// --- Cells and segments --------------------------------------------------------------------------

/// Returns its area as a share of the face.
double BisectorTracing::addCell(int element, const FaceEnvelope::Cell& cell) {
  const std::span<const FaceEnvelope::CellSide> sides = envelope_.sides(cell);
  const bool hasAllTwins = complex_.hasAllTwins(element);
  for (const auto& [vertex, across] : sides) {
    graph_.cells.points.push_back(points_[vertex].point);
    if (hasAllTwins || !FaceEnvelope::isTriangleSide(across)) continue;
    const int side = FaceEnvelope::triangleSide(across);
    if (complex_.twin(element, side) < 0) addUnmatchedSide(element, side, vertex);
  }
  return areaShare(sides.size(), [&](size_t i) -> const Eigen::Vector3d& {
    return points_[sides[i].vertex].bary;
  });
}

void BisectorTracing::addSegment(int element, const FaceEnvelope::Segment& added) {
  const int left = envelope_.label(added.left), right = envelope_.label(added.right);
  const int from = points_[added.tail].point, to = points_[added.tip].point;
  const int segment = static_cast<int>(graph_.segments.size()), dart = 2 * segment;
  graph_.addSegment(from, to, left, right, complex_.face(element));
  if (graph_.isInner(from)) {
    join(from, left, dart, true);
    join(from, right, dart + 1, false);
  } else if (const int before = segmentAcross(from, segment); before >= 0) {
    link(before, segment);
  }
  if (graph_.isInner(to)) {
    join(to, left, dart, false);
    join(to, right, dart + 1, true);
  } else if (const int after = segmentAcross(to, segment); after >= 0) {
    link(segment, after);
  }
}

/// Notes a dart of a region that leaves an inner point or arrives there. Once both are known, the
/// one that leaves is the next of the other.
void BisectorTracing::join(int point, int label, int dart, bool leaves) {
  int& other = graph_.innerDart(point, label);
  if (other < 0)
    other = dart;
  else
    graph_.nextDart[leaves ? other : dart] = leaves ? dart : other;
}

/// The segment across the side where a new one ends, -1 if there is none yet.
int BisectorTracing::segmentAcross(int point, int added) {
  int& first = graph_.points[point].index;
  if (first >= 0) return first;
  first = added;
  return -1;
}

/// Links the darts of two segments of one bisector, the first of which ends where the second
/// begins.
void BisectorTracing::link(int first, int second) {
  graph_.nextDart[2 * first] = 2 * second;
  graph_.nextDart[2 * second + 1] = 2 * first + 1;
}

/// Adds the corners of smaller elements along a side without twin to a cell. One label owns all of
/// such a side.
void BisectorTracing::addUnmatchedSide(int element, int side, int vertex) {
  addBoundaryPoint(3 * element + side, vertex);
  for (const auto& [node, share] : complex_.innerNodes(3 * element + side)) {
    Eigen::Vector3d bary = Eigen::Vector3d::Zero();
    bary[side] = 1 - share;
    bary[cornerAfter(side)] = share;
    bary = complex_.faceBary(element, bary);
    graph_.cells.points.push_back(points_.atNode(element, node, bary));
  }
}

/// Notes a point on the mesh boundary where the owner changes.
void BisectorTracing::addBoundaryPoint(int h, int vertex) {
  const int boundary = complex_.boundaryHalfedge(h);
  if (boundary < 0) return;
  const FaceEnvelope::Vertex& v = envelope_.vertices()[vertex];
  if (v.kind != FaceEnvelope::Vertex::kOnSide) return;
  const Eigen::Vector3d start = complex_.faceBary(h / 3, Eigen::Vector3d::Unit(h % 3));
  graph_.boundary.push_back({boundary, start[cornerAfter(boundary % 3)], points_[vertex].point,
                             envelope_.label(v.functions[0]), envelope_.label(v.functions[1])});
}

/// Adds the areas of the element's cells, given as shares of the face, to those of the regions.
/// Rounding may make the area of a sliver negative; it is then set off against the largest cell.
void BisectorTracing::addAreas(double faceArea) {
  const auto isNegative = [](double area) { return area < 0; };
  if (std::any_of(cellAreas_.begin(), cellAreas_.end(), isNegative)) {
    const auto largest = std::max_element(cellAreas_.begin(), cellAreas_.end());
    for (double& area : cellAreas_)
      if (isNegative(area)) *largest += std::exchange(area, 0.0);
  }
  const auto labels = std::span(graph_.cellLabel).last(cellAreas_.size());
  for (size_t c = 0; c < labels.size(); ++c) out_.regionArea[labels[c]] += cellAreas_[c] * faceArea;
}

}  // namespace gvd
