// SPDX-License-Identifier: MIT
//
// The sides of a dual as paths on the surface.

#include <algorithm>

#include "distance/path_points.h"
#include "gvd/dual.h"

namespace gvd {
namespace {

/// A point of a bisector and its squared distance from either site.
struct Crossing {
  SurfacePoint point;
  double squaredDistance = kInfinity;
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
  /// Where the path to the virtual source is the same all along a segment, the squared distance is a
  /// quadratic function: the one through three of its values has its least value at the same place.
  void visit(const Diagram::Segment& segment) {
    const SurfacePoint begin = inFace(mesh_, diagram_.points[segment.points[0]], segment.face);
    const SurfacePoint end = inFace(mesh_, diagram_.points[segment.points[1]], segment.face);
    if (begin.face != end.face) return;
    const auto at = [&](double t) -> SurfacePoint {
      return {begin.face, (1 - t) * begin.bary + t * end.bary};
    };
    const auto squared = [&](double t) {
      const double distance = field_.distance(segment.labels[0], at(t));
      return distance * distance;
    };
    const double first = squared(0), middle = squared(0.5), last = squared(1);
    const double curvature = 2 * (first - 2 * middle + last);
    double t = first < last ? 0 : 1;
    if (curvature > 0) t = std::clamp(0.5 + (first - last) / (2 * curvature), 0.0, 1.0);
    const double least = squared(t);
    Crossing& nearest = nearest_[segment.arc];
    if (least < nearest.squaredDistance) nearest = {at(t), least};
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
