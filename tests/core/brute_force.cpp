// SPDX-License-Identifier: MIT
#include "brute_force.h"

#include <utility>

#include "distance/ties.h"

namespace gvd::checks {
namespace {

/// Work that was done when it began.
class Done final : public SlicedWork<std::vector<double>> {
 public:
  explicit Done(std::vector<double> result) : result_(std::move(result)) {}
  bool advance(long /*budget*/) override { return true; }
  double share() const override { return 1; }
  std::vector<double> result() override { return std::move(result_); }

 private:
  std::vector<double> result_;
};

}  // namespace

BruteForce::BruteForce(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric)
    : known_(mesh.vertexCount()) {
  for (const SurfacePoint& site : sites) {
    const int label = static_cast<int>(alone_.size());
    alone_.push_back(finished(propagate(mesh, {&site, 1}, metric)));
    for (int v = 0; v < mesh.vertexCount(); ++v)
      for (const LabelledDistance& d : alone_.back()->at(v))
        known_[v].push_back({label, d.distance});
  }
  const TieTolerance ties(mesh);
  for (std::vector<LabelledDistance>& here : known_) equalizeTies(here, ties);
}

LabelledDistance BruteForce::nearest(const SurfacePoint& p, long& /*budget*/) const {
  LabelledDistance nearest;
  for (int label = 0; label < static_cast<int>(alone_.size()); ++label)
    if (const double here = distance(label, p); here < nearest.distance) nearest = {label, here};
  return nearest;
}

double BruteForce::distance(int label, const SurfacePoint& p) const {
  return alone_[label]->distance(0, p);
}

/// The points of a label are asked for at once, since its site spreads again whenever it is asked.
std::unique_ptr<SlicedWork<std::vector<double>>> BruteForce::startDistancesAt(
    std::vector<LabelledPoint> points) const {
  std::vector<std::vector<LabelledPoint>> ofLabel(alone_.size());
  for (const auto& [label, point] : points) ofLabel[label].push_back({0, point});
  std::vector<std::vector<double>> found;
  for (size_t label = 0; label < alone_.size(); ++label)
    found.push_back(alone_[label]->distancesAt(std::move(ofLabel[label])));
  std::vector<double> distances;
  std::vector<size_t> next(alone_.size());
  for (const auto& [label, point] : points) distances.push_back(found[label][next[label]++]);
  return std::make_unique<Done>(std::move(distances));
}

Eigen::Vector2d BruteForce::direction(int label, int vertex) const {
  return alone_[label]->direction(0, vertex);
}

std::vector<SurfacePoint> BruteForce::path(int label, const SurfacePoint& p) const {
  return alone_[label]->path(0, p);
}

}  // namespace gvd::checks
