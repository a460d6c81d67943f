// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd::checks {

/// The distances of some sites, each spread alone over its whole component: all labels that reach a
/// vertex are known there. What `propagate` knows, where labels stop each other, must be part of
/// it.
class BruteForce final : public DistanceField {
 public:
  BruteForce(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric);

  std::span<const LabelledDistance> at(int vertex) const override { return known_[vertex]; }
  LabelledDistance nearest(const SurfacePoint& p, long& budget) const override;
  double distance(int label, const SurfacePoint& p) const override;
  std::unique_ptr<SlicedWork<std::vector<double>>> startDistancesAt(
      std::vector<LabelledPoint> points) const override;
  Eigen::Vector2d direction(int label, int vertex) const override;
  std::vector<SurfacePoint> path(int label, const SurfacePoint& p) const override;

 private:
  std::vector<std::unique_ptr<DistanceField>> alone_;  ///< per label
  std::vector<std::vector<LabelledDistance>> known_;   ///< per vertex
};

}  // namespace gvd::checks
