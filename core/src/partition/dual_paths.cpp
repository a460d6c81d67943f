// SPDX-License-Identifier: MIT
//
// The sides of a dual as paths on the surface.

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <vector>

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

/// First the point of each arc at which the way from site to site is shortest, then the paths to
/// it.
class DualPathFinding final : public SlicedWork<std::vector<DualPath>> {
 public:
  DualPathFinding(const TriangleMesh& mesh, const Diagram& diagram, const DistanceField& field)
      : mesh_(mesh), diagram_(diagram), field_(field), nearest_(diagram.arcLabels.size()) {}

  bool step(long budget) override {
    constexpr int kSegmentsAtATime = 64;
    constexpr long kSegmentUnits = 16, kPathUnits = 1000;
    for (; nextSegment_ < diagram_.segments.size(); nextSegment_ += kSegmentsAtATime) {
      if (budget <= 0) return false;
      const std::size_t left = diagram_.segments.size() - nextSegment_;
      offerSegments(std::span(diagram_.segments)
                        .subspan(nextSegment_, std::min<std::size_t>(left, kSegmentsAtATime)));
      budget -= kSegmentUnits * kSegmentsAtATime;
    }
    for (; paths_.size() < nearest_.size(); budget -= kPathUnits) {
      if (budget <= 0) return false;
      addPath(static_cast<int>(paths_.size()));
    }
    return true;
  }
  double progress() const override {
    const double all = diagram_.segments.size() + nearest_.size();
    return all > 0 ? std::min(1.0, (nextSegment_ + paths_.size()) / all) : 1;
  }
  std::vector<DualPath> take() override { return std::move(paths_); }

 private:
  /// A point of a segment, by its share of the way.
  struct Place {
    const Diagram::Segment* segment;
    double share;
  };

  /// Distances at all points in question are asked for at once.
  void offerSegments(std::span<const Diagram::Segment> segments) {
    // Where the paths to the virtual sources are the same all along a segment, the sum of the
    // squared distances is a quadratic function: the one through three of its values has its least
    // value at the same place. Elsewhere an end of the segment may be nearer.
    const std::array shares = {0.0, 0.5, 1.0};
    std::vector<Place> places;
    for (const Diagram::Segment& segment : segments)
      for (const double share : shares) places.push_back({&segment, share});
    const std::vector<Eigen::Vector2d> distances = offer(places);
    std::vector<Place> least;
    for (size_t i = 0; i < places.size(); i += shares.size()) {
      const double first = distances[i].squaredNorm(), middle = distances[i + 1].squaredNorm(),
                   last = distances[i + 2].squaredNorm();
      const double curvature = first - 2 * middle + last;
      const double share = 0.5 + (first - last) / (4 * curvature);
      if (curvature > 0 && share > 0 && share < 1) least.push_back({places[i].segment, share});
    }
    offer(least);
  }

  SurfacePoint pointAt(const Place& place) const {
    const Diagram::Segment& segment = *place.segment;
    SurfacePoint begin = inFace(mesh_, diagram_.points[segment.points[0]], segment.face);
    const SurfacePoint end = inFace(mesh_, diagram_.points[segment.points[1]], segment.face);
    if (begin.face != end.face) return begin;
    return {begin.face, (1 - place.share) * begin.bary + place.share * end.bary};
  }

  /// Takes the places as crossings if they are nearer; returns the distances of both sites there.
  std::vector<Eigen::Vector2d> offer(const std::vector<Place>& places) {
    std::vector<LabelledPoint> points;
    for (const Place& place : places)
      for (const int label : place.segment->labels) points.push_back({label, pointAt(place)});
    const std::vector<double> distances = field_.distancesAt(points);
    std::vector<Eigen::Vector2d> both;
    for (size_t i = 0; i < places.size(); ++i) {
      both.emplace_back(distances[2 * i], distances[2 * i + 1]);
      Crossing& nearest = nearest_[places[i].segment->arc];
      if (both[i].sum() < nearest.length) nearest = {points[2 * i].point, both[i].sum()};
    }
    return both;
  }

  /// Without points if the distances of its sites are not known on the arc.
  void addPath(int arc) {
    DualPath& path = paths_.emplace_back();
    path.labels = diagram_.arcLabels[arc];
    const SurfacePoint& crossing = nearest_[arc].point;
    if (crossing.face < 0) return;
    path.points = field_.path(path.labels[0], crossing);
    const auto rest = field_.path(path.labels[1], crossing);
    std::reverse(path.points.begin(), path.points.end());
    if (rest.empty() || path.points.empty())
      path.points.clear();
    else
      path.points.insert(path.points.end(), rest.begin() + 1, rest.end());
  }

  const TriangleMesh& mesh_;
  const Diagram& diagram_;
  const DistanceField& field_;
  std::size_t nextSegment_ = 0;
  std::vector<Crossing> nearest_;
  std::vector<DualPath> paths_;
};

}  // namespace

std::unique_ptr<SlicedWork<std::vector<DualPath>>> startDualPaths(const TriangleMesh& mesh,
                                                                  const Diagram& diagram,
                                                                  const DistanceField& field) {
  return std::make_unique<DualPathFinding>(mesh, diagram, field);
}

std::vector<DualPath> dualPaths(const TriangleMesh& mesh, const Diagram& diagram,
                                const DistanceField& field) {
  return finished(startDualPaths(mesh, diagram, field));
}

}  // namespace gvd
