// SPDX-License-Identifier: MIT
//
// Invariants of every diagram of every mesh, checked independently of how it was traced.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "gvd/diagram.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd::checks {

/// The distance field and the diagram of some sites.
struct Traced {
  std::unique_ptr<DistanceField> field;
  Diagram diagram;
};
Traced trace(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
             Metric metric = Metric::kExact, int detail = 0);
/// The same by brute force (`BruteForce`).
Traced traceByBruteForce(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                         Metric metric = Metric::kExact);

/// Distances of a class that is not the library's, which knows none.
class NoDistances : public DistanceField {
 public:
  std::span<const LabelledDistance> at(int /*vertex*/) const override { return {}; }
  LabelledDistance nearest(const SurfacePoint& /*p*/, long& /*budget*/) const override {
    return {};
  }
  double distance(int /*label*/, const SurfacePoint& /*p*/) const override { return kInfinity; }
  std::unique_ptr<SlicedWork<std::vector<double>>> startDistancesAt(
      std::vector<LabelledPoint> /*points*/) const override {
    return nullptr;
  }
  Eigen::Vector2d direction(int /*label*/, int /*vertex*/) const override { return {1, 0}; }
  std::vector<SurfacePoint> path(int /*label*/, const SurfacePoint& /*p*/) const override {
    return {};
  }
};

/// The distances of another field, which must outlive this: to watch what is asked of it.
class SameDistances : public DistanceField {
 public:
  explicit SameDistances(const DistanceField& field) : field_(field) {}
  std::span<const LabelledDistance> at(int vertex) const override { return field_.at(vertex); }
  LabelledDistance nearest(const SurfacePoint& p, long& budget) const override {
    return field_.nearest(p, budget);
  }
  double distance(int label, const SurfacePoint& p) const override {
    return field_.distance(label, p);
  }
  std::unique_ptr<SlicedWork<std::vector<double>>> startDistancesAt(
      std::vector<LabelledPoint> points) const override {
    return field_.startDistancesAt(std::move(points));
  }
  Eigen::Vector2d direction(int label, int vertex) const override {
    return field_.direction(label, vertex);
  }
  std::vector<SurfacePoint> path(int label, const SurfacePoint& p) const override {
    return field_.path(label, p);
  }

 private:
  const DistanceField& field_;
};

/// Success if
///  - the areas of the regions sum to the area of the components with sites (1e-12 relative);
///  - every segment is used exactly twice by loops: forwards by its lower label, backwards by its
///    higher one, and every other step of a loop runs along the mesh boundary;
///  - at detail 0, the cells and region triangles form a closed complex: each of their sides is
///    used once in each direction, except along the mesh boundary, and V - E + F is the mesh's;
///  - every point is on the surface, on a segment, a loop or a cell, and if segments end there, in
///    a face of one of them;
///  - every arc is a chain of its segments, and every Voronoi point has three or more labels.
::testing::AssertionResult isConsistent(const TriangleMesh& mesh, const Diagram& diagram,
                                        int detail = 0);

/// Success if `nearest` gives the least known distance at every vertex and, with the exact metric,
/// distances are zero at their sites and nowhere less than the straight line in space. Inside
/// faces, `nearest` is more exact than the diagram, whose bisectors are straight there.
::testing::AssertionResult agreesWithField(const TriangleMesh& mesh, const Traced& traced,
                                           std::span<const SurfacePoint> sites, Metric metric);

/// Success if brute force (`everywhere`) finds no more than `traced`: in the middle of every cell
/// and region triangle, the nearest site is equally far. Only for the exact metric: DGPC stops a
/// label where another one is nearer at both ends of an edge. If that one comes around an obstacle,
/// the stopped label may lose an area that it would own.
::testing::AssertionResult spreadsFarEnough(const TriangleMesh& mesh, const Traced& traced,
                                            const DistanceField& everywhere);

/// Success if two diagrams of one mesh are the same, where label l of a is label `labelInB[l]` of
/// b: they have the same region triangles, numbers of loops, segments and Voronoi points with their
/// labels, and the same region areas to `tolerance` times the mesh area.
::testing::AssertionResult areSame(const TriangleMesh& mesh, const Diagram& a, const Diagram& b,
                                   std::span<const int> labelInB, double tolerance);

std::vector<int> identity(int count);

}  // namespace gvd::checks
