// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "dgpc_view.h"
#include "fan.h"
#include "gvd/geodesic.h"

namespace gvd {

/// Distances at the vertices; inside a face as the views of its corners give them, or as the
/// interpolation of the corners' distances does, whichever is shorter: views are limited and so err
/// towards too long, and interpolation misses what comes between the corners.
class DgpcField final : public DistanceField {
 public:
  /// The labels known at vertex v are `values[offset[v]]` up to `values[offset[v + 1]]`, ascending.
  /// The nearest, or lowest of the nearest, is seen as in `views[v]`; the paths to the others leave
  /// their sites as in `departures`, one per value.
  DgpcField(const TriangleMesh& mesh, std::vector<SurfacePoint> sites, std::vector<int> offset,
            std::vector<LabelledDistance> values, std::vector<View> views,
            std::vector<Eigen::Vector2d> departures);

  std::span<const LabelledDistance> at(int vertex) const override;
  LabelledDistance nearest(const SurfacePoint& p) const override;
  double distance(int label, const SurfacePoint& p) const override;
  Eigen::Vector2d direction(int label, int vertex) const override;

 private:
  const LabelledDistance* find(int vertex, int label) const;
  LabelledDistance owner(int vertex) const;
  double interpolate(int label, const SurfacePoint& p) const;
  double distanceSeenFrom(int corner, const SurfacePoint& p) const;
  template <Side side>
  double distanceAside(const View& view, const Eigen::Vector2d& path, const SurfacePoint& p) const;

  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> sites_;
  std::vector<int> offset_;
  std::vector<LabelledDistance> values_;
  std::vector<View> views_;
  std::vector<Eigen::Vector2d> departures_;
};

}  // namespace gvd
