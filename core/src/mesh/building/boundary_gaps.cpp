// SPDX-License-Identifier: MIT
#include "mesh/building/boundary_gaps.h"

#include <algorithm>

namespace gvd {
namespace {

/// Boundary vertices that are no farther apart nearly coincide, and lie within a boundary edge that
/// is no farther away, as a share of the bounding diagonal: sixteen times the rounding of
/// coordinates in single precision.
constexpr double kGapWidth = 1e-6;

}  // namespace

BoundaryGaps::BoundaryGaps(const TriangleMesh& mesh, std::span<const double> positions,
                           std::span<const int> boundary, MeshTopology& topology)
    : mesh_(mesh),
      positions_(positions),
      boundary_(boundary),
      width_(kGapWidth * mesh.boundingDiagonal()),
      topology_(topology) {}

bool BoundaryGaps::step(long& budget) {
  return sequence_.run(
      [&] { sample(); }, forItems(boundary_, budget, 4, [&](int v) { lookForSeam(v); }),
      forItems(boundary_, budget, 4 * kQuickRounds, [&](int v) { return lookForTJunction(v); }));
}

/// Calls `visit` with boundary vertices, evenly spaced, of which there are at most so many.
template <class Visit>
void BoundaryGaps::visitSample(std::size_t most, Visit visit) const {
  const std::size_t step = (boundary_.size() + most - 1) / most;
  for (std::size_t i = 0; i < boundary_.size(); i += step) visit(boundary_[i]);
}

void BoundaryGaps::sample() {
  if (boundary_.empty()) return;
  constexpr std::size_t kSamples = 4096, kMostPairs = std::size_t{1} << 22;
  samples_.emplace(positions_, width_, kSamples);
  visitSample(kSamples, [&](int v) { samples_->add(v); });
  visitSample(kMostPairs / boundary_.size() + 1, [&](int v) { comparedWithEdges_.push_back(v); });
}

/// Edges that were cut leave vertices at one position; these are no seam.
void BoundaryGaps::lookForSeam(int v) {
  if (topology_.hasOpenSeams) return;
  for (const int near : samples_->near(mesh_.position(v))) {
    if (mesh_.position(near) == mesh_.position(v)) continue;
    bool isJoined = false;
    mesh_.visitNeighbours(v, [&](int neighbour) { isJoined |= neighbour == near; });
    topology_.hasOpenSeams |= !isJoined;
  }
}

/// Looks for vertices within the boundary edge that leaves v, away from its ends. The third corner
/// of the edge's own face does not count: it is there if the face is flat, and joined to the edge.
/// Returns how many quick rounds it took.
long BoundaryGaps::lookForTJunction(int v) {
  if (topology_.hasTJunctions) return 1;
  const int h = mesh_.outgoing(v), apex = mesh_.tip(TriangleMesh::next(h));
  const Eigen::Vector3d tail = mesh_.position(v), edge = mesh_.position(mesh_.tip(h)) - tail;
  const double length = edge.norm();
  const auto isWithin = [&](int other) {
    const Eigen::Vector3d fromTail = mesh_.position(other) - tail;
    const double along = fromTail.dot(edge) / length;
    return other != apex && along > width_ && along < length - width_ &&
           (fromTail - along / length * edge).norm() <= width_;
  };
  topology_.hasTJunctions =
      std::any_of(comparedWithEdges_.begin(), comparedWithEdges_.end(), isWithin);
  return 1 + static_cast<long>(comparedWithEdges_.size());
}

}  // namespace gvd
