// SPDX-License-Identifier: MIT
#include "gvd/geodesic.h"

#include <algorithm>
#include <utility>

#include "distance/site_distances.h"
#include "gvd/error.h"

namespace gvd {
namespace {

class SitePropagation final : public Propagation {
 public:
  SitePropagation(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric,
                  Spread spread)
      : distances_(std::make_unique<SiteDistances>(mesh, metric, spread)) {
    std::vector<SiteChange> changes;
    for (const SurfacePoint& site : sites)
      changes.push_back({static_cast<int>(changes.size()), site});
    distances_->change(changes);
  }

  bool step(long budget) override { return distances_->step(budget); }
  double progress() const override { return distances_->progress(); }
  std::unique_ptr<DistanceField> take() override { return std::move(distances_); }

 private:
  std::unique_ptr<SiteDistances> distances_;
};

}  // namespace

std::vector<double> DistanceField::distancesAt(std::span<const LabelledPoint> points) const {
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const LabelledPoint& p : points) distances.push_back(distance(p.label, p.point));
  return distances;
}

Eigen::Vector2d DistanceField::direction(int /*label*/, int /*vertex*/) const {
  return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
}

std::vector<SurfacePoint> DistanceField::path(int /*label*/, const SurfacePoint& /*p*/) const {
  return {};
}

std::unique_ptr<Propagation> propagate(const TriangleMesh& mesh,
                                       std::span<const SurfacePoint> sites, Metric metric,
                                       Spread spread) {
  const auto isThere = [](const SurfacePoint& site) { return site.face >= 0; };
  if (std::none_of(sites.begin(), sites.end(), isThere))
    throw Error(ErrorCode::kInvalidArgument, "there is no site");
  return std::make_unique<SitePropagation>(mesh, sites, metric, spread);
}

}  // namespace gvd
