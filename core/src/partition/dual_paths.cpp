// SPDX-License-Identifier: MIT
//
// The sides of a dual as paths on the surface.

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "diagram/given_diagram.h"
#include "distance/site_distances.h"
#include "gvd/dual.h"
#include "mesh/incidence.h"

namespace gvd {
namespace {

/// A point of a bisector, and the length of the path from site to site through it.
struct Crossing {
  SurfacePoint point;
  double length = kInfinity;
};

/// Finds the point of each arc where the path from site to site is shortest, then the paths to it.
/// If all straight paths from each of the two sites to a segment cross the same faces, the sum of
/// the squared distances is quadratic along the segment. As both distances are equal there, their
/// sum is least at the same place: at the vertex of the parabola through three values. Otherwise an
/// end of the segment may be nearer.
class DualPathFinding final : public SequentialWork<std::vector<DualPath>> {
 public:
  DualPathFinding(const TriangleMesh& mesh, const Diagram& diagram, const DistanceField& field)
      : mesh_(mesh), diagram_(diagram), field_(field), nearest_(diagram.arcLabels.size()) {
    requireFaces(mesh, diagram);
    requireMesh(mesh, field);
  }

  bool advance(long budget) override {
    constexpr long kPathUnits = 1000;
    const auto forSegments = [&](auto body) {
      return forEach(diagram_.segments, budget, kPlacesPerUnit, body);
    };
    return sequence_.run(
        forSegments([&](int i) { addEvenPlaces(i); }), [&] { return offerPlaces(budget); },
        forSegments([&](int i) { addLeastPlace(i); }), [&] { return offerPlaces(budget); },
        [&] {
          for (; out_.size() < nearest_.size(); budget -= kPathUnits) {
            if (budget <= 0) return false;
            addPath(static_cast<int>(out_.size()));
          }
          return true;
        });
  }
  double share() const override {
    const double ofPaths =
        nearest_.empty() ? 1 : static_cast<double>(out_.size()) / nearest_.size();
    constexpr double kShareOfPaths = 0.2;  // the last of five parts
    return sequence_.progress() + kShareOfPaths * ofPaths;
  }

 private:
  /// A point of a segment, by its position along the segment.
  struct Place {
    const Diagram::Segment* segment;
    double share;
  };

  /// Adds the places on a segment where the squared sums are evaluated first.
  void addEvenPlaces(int segment) {
    for (const double share : kEvenShares) places_.push_back({&diagram_.segments[segment], share});
  }

  /// Adds the place on a segment where its parabola is least, if that is inside.
  void addLeastPlace(int segment) {
    const auto* const values = &squaredSums_[kEvenShares.size() * segment];
    const double curvature = values[0] - 2 * values[1] + values[2];
    const double share = 0.5 + (values[0] - values[2]) / (4 * curvature);
    if (curvature > 0 && share > 0 && share < 1)
      places_.push_back({&diagram_.segments[segment], share});
  }

  SurfacePoint pointAt(const Place& place) const {
    const Diagram::Segment& segment = *place.segment;
    const auto end = [&](int i) {
      return baryInFace(mesh_, diagram_.points[segment.points[i]], segment.face);
    };
    return {segment.face, (1 - place.share) * end(0) + place.share * end(1)};
  }

  /// Makes the nearest places the crossings of their arcs. The distances at all places are
  /// requested at once.
  bool offerPlaces(long& budget) {
    return round_.runRound([&] { points_.reserve(2 * places_.size()); },
                           forEach(places_, budget, kPlacesPerUnit,
                                   [&](int i) {
                                     for (const int label : places_[i].segment->labels)
                                       points_.push_back({label, pointAt(places_[i])});
                                   }),
                           [&] { atPoints_ = field_.startDistancesAt(std::move(points_)); },
                           [&] { return atPoints_->step(budget); },
                           [&] {
                             distances_ = atPoints_->take();
                             squaredSums_.clear();
                             squaredSums_.reserve(places_.size());
                           },
                           forEach(places_, budget, kPlacesPerUnit, [&](int i) { offer(i); }),
                           [&] {
                             points_.clear();
                             places_.clear();
                           });
  }

  void offer(int place) {
    const Eigen::Vector2d both(distances_[2 * place], distances_[2 * place + 1]);
    squaredSums_.push_back(both.squaredNorm());
    Crossing& nearest = nearest_[places_[place].segment->arc];
    if (both.sum() < nearest.length || nearest.point.face < 0)
      nearest = {pointAt(places_[place]), both.sum()};
  }

  /// Adds the path of an arc; without points if there is none.
  void addPath(int arc) {
    DualPath& path = out_.emplace_back();
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

  static constexpr std::array kEvenShares = {0.0, 0.5, 1.0};
  /// Places that take one unit of the budget to add.
  static constexpr long kPlacesPerUnit = 8;

  const TriangleMesh& mesh_;
  const Diagram& diagram_;
  const DistanceField& field_;
  SlicedSequence round_;
  std::vector<Place> places_;
  std::vector<LabelledPoint> points_;  ///< both labels at each place
  std::unique_ptr<SlicedWork<std::vector<double>>> atPoints_;
  std::vector<double> distances_;    ///< of both labels at each place
  std::vector<double> squaredSums_;  ///< of the two distances at each place
  std::vector<Crossing> nearest_;    ///< of each arc
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
