// SPDX-License-Identifier: MIT
//
// The sides of a dual as paths on the surface.

#include <algorithm>

#include "distance/path_points.h"
#include "gvd/dual.h"

namespace gvd {
namespace {

/// A point of a bisector, and how long the way from site to site over it is.
struct Crossing {
  SurfacePoint point;
  double length = kInfinity;
};

/// A point in terms of a face that has it.
SurfacePoint inFace(const TriangleMesh& mesh, const SurfacePoint& p, int face) {
  SurfacePoint result = p;
  visitPlaces(mesh, p, [&](const SurfacePoint& place) {
    if (place.face == face) result = place;
  });
  return result;
}

class NearestCrossing {
 public:
  NearestCrossing(const TriangleMesh& mesh, const Diagram& diagram, const DistanceField& field)
      : mesh_(mesh), diagram_(diagram), field_(field), nearest_(diagram.arcLabels.size()) {
    for (const Diagram::Segment& segment : diagram.segments) visit(segment);
  }

  /// Of an arc; without a face if the distances of its sites are not known there.
  const SurfacePoint& of(int arc) const { return nearest_[arc].point; }

 private:
  /// Where the paths to the virtual sources are the same all along a segment, the sum of the
  /// squared distances is a quadratic function: the one through three of its values has its least
  /// value at the same place. Elsewhere an end of the segment may be nearer.
  void visit(const Diagram::Segment& segment) {
    const SurfacePoint begin = inFace(mesh_, diagram_.points[segment.points[0]], segment.face);
    const SurfacePoint end = inFace(mesh_, diagram_.points[segment.points[1]], segment.face);
    if (begin.face != end.face) return;
    const auto at = [&](double t) -> SurfacePoint {
      return {begin.face, (1 - t) * begin.bary + t * end.bary};
    };
    const auto distances = [&](double t) {
      return Eigen::Vector2d(field_.distance(segment.labels[0], at(t)),
                             field_.distance(segment.labels[1], at(t)));
    };
    const Eigen::Vector2d first = distances(0), middle = distances(0.5), last = distances(1);
    const double slope = first.squaredNorm() - last.squaredNorm();
    const double curvature = first.squaredNorm() - 2 * middle.squaredNorm() + last.squaredNorm();
    const double t = curvature > 0 ? std::clamp(0.5 + slope / (4 * curvature), 0.0, 1.0) : 0.5;
    Crossing& nearest = nearest_[segment.arc];
    const auto offer = [&](double place, const Eigen::Vector2d& both) {
      if (both.sum() < nearest.length) nearest = {at(place), both.sum()};
    };
    offer(t, distances(t));
    offer(0, first);
    offer(1, last);
  }

  const TriangleMesh& mesh_;
  const Diagram& diagram_;
  const DistanceField& field_;
  std::vector<Crossing> nearest_;
};

}  // namespace

std::vector<DualPath> dualPaths(const TriangleMesh& mesh, const Diagram& diagram,
                                const DistanceField& field) {
  const NearestCrossing crossings(mesh, diagram, field);
  std::vector<DualPath> paths(diagram.arcLabels.size());
  for (size_t arc = 0; arc < paths.size(); ++arc) {
    DualPath& path = paths[arc];
    path.labels = diagram.arcLabels[arc];
    const SurfacePoint& crossing = crossings.of(static_cast<int>(arc));
    if (crossing.face < 0) continue;
    path.points = field.path(path.labels[0], crossing);
    const auto rest = field.path(path.labels[1], crossing);
    std::reverse(path.points.begin(), path.points.end());
    if (rest.empty() || path.points.empty())
      path.points.clear();
    else
      path.points.insert(path.points.end(), rest.begin() + 1, rest.end());
  }
  return paths;
}

}  // namespace gvd
