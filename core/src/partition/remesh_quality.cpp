// SPDX-License-Identifier: MIT
//
// The quality of a remesh: angles and valences of its triangles, and distance from the surface.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/remesh.h"
#include "gvd/surface_point.h"
#include "mesh/triangle_tree.h"

namespace gvd {
namespace {

using Eigen::Vector3d;
using Triangles = std::vector<TriangleTree::Triangle>;

/// The least angle of a triangle, in degrees; 0 if it has no area.
double leastAngle(const TriangleTree::Triangle& t) {
  double least = std::numbers::pi;
  for (int i = 0; i < 3; ++i) {
    const Vector3d u = t[cornerAfter(i)] - t[i], v = t[cornerBefore(i)] - t[i];
    least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)));
  }
  return least * 180 / std::numbers::pi;
}

void measureAngles(const Triangles& triangles, RemeshQuality& quality) {
  quality.triangles = static_cast<int>(triangles.size());
  if (triangles.empty()) return;
  quality.minAngle = 180;
  for (const auto& triangle : triangles) {
    const double angle = leastAngle(triangle);
    quality.minAngle = std::min(quality.minAngle, angle);
    quality.meanMinAngle += angle / quality.triangles;
  }
}

/// Measures the inner vertices: those with as many triangles as neighbours.
void measureValences(const PolygonTriangles& cut, int vertexCount, RemeshQuality& quality) {
  std::vector<std::set<int>> neighbours(vertexCount);
  std::vector<int> around(vertexCount, 0);
  for (const auto& triangle : cut.triangles)
    for (int i = 0; i < 3; ++i) {
      ++around[triangle[i]];
      neighbours[triangle[i]].insert({triangle[cornerAfter(i)], triangle[cornerBefore(i)]});
    }
  int inside = 0, regular = 0;
  for (int v = 0; v < vertexCount; ++v) {
    const int valence = static_cast<int>(neighbours[v].size());
    if (valence == 0 || valence != around[v]) continue;
    quality.minValence = inside == 0 ? valence : std::min(quality.minValence, valence);
    quality.maxValence = std::max(quality.maxValence, valence);
    regular += valence == 6;
    ++inside;
  }
  if (inside > 0) quality.regularShare = static_cast<double>(regular) / inside;
}

class QualityMeasuring final : public SlicedWork<RemeshQuality> {
 public:
  QualityMeasuring(const TriangleMesh& surface, std::unique_ptr<SlicedWork<PolygonMesh>> remeshing)
      : surface_(surface), remeshing_(std::move(remeshing)), fine_(surface) {}

  bool advance(long budget) override {
    const int vertices = surface_.vertexCount(), faces = surface_.faceCount();
    return sequence_.run(
        [&] { return remeshing_->step(budget); }, [&] { measureRemesh(remeshing_->take()); },
        [&] { return runPart(coarse_, budget, triangles_); }, [&] { return fine_.step(budget); },
        forEach(vertices, budget, 1, [&](int v) { note(coarse_->distance(surface_.position(v))); }),
        forEach(faces, budget, 1,
                [&](int f) {
                  note(coarse_->distance(surface_.position({f, Vector3d::Constant(1.0 / 3)})));
                }),
        [&] { return visitRemesh(budget); });
  }
  double progress() const override { return sequence_.progress(); }
  RemeshQuality result() override { return quality_; }

 private:
  void measureRemesh(const PolygonMesh& remesh) {
    const PolygonTriangles cut = triangulate(remesh);
    for (const auto& [a, b, c] : cut.triangles)
      triangles_.push_back({remesh.positions[a], remesh.positions[b], remesh.positions[c]});
    measureAngles(triangles_, quality_);
    measureValences(cut, static_cast<int>(remesh.positions.size()), quality_);
  }

  void note(double distance) { quality_.hausdorff = std::max(quality_.hausdorff, distance); }

  /// Notes the distances of a regular grid of points on each triangle, row by row. The grid is no
  /// wider than the surface's mean edge, or has 64 rows.
  bool visitRemesh(long& budget) {
    constexpr int kMostSteps = 64;
    for (; triangle_ < triangles_.size(); ++triangle_, row_ = 0) {
      const auto& [a, b, c] = triangles_[triangle_];
      const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
      const int steps = static_cast<int>(
          std::clamp(std::ceil(longest / surface_.meanEdgeLength()), 1.0, double{kMostSteps}));
      for (; row_ <= steps; ++row_) {
        if (budget <= 0) return false;
        for (int k = 0; row_ + k <= steps; ++k, --budget)
          note(fine_.distance((row_ * a + k * b + (steps - row_ - k) * c) / steps));
      }
    }
    return true;
  }

  const TriangleMesh& surface_;
  std::unique_ptr<SlicedWork<PolygonMesh>> remeshing_;

  SlicedSequence sequence_;
  Triangles triangles_;  ///< of the remesh
  std::optional<TriangleTree> coarse_;
  TriangleTree fine_;         ///< of the surface
  std::size_t triangle_ = 0;  ///< of the remesh, to be visited next
  int row_ = 0;               ///< of that triangle
  RemeshQuality quality_;
};

/// Work whose result is known already.
template <class Result>
class Ready final : public SlicedWork<Result> {
 public:
  explicit Ready(Result result) : result_(std::move(result)) {}
  bool advance(long /*budget*/) override { return true; }
  double progress() const override { return 1; }
  Result result() override { return std::move(result_); }

 private:
  Result result_;
};

}  // namespace

std::unique_ptr<SlicedWork<RemeshQuality>> startQuality(
    const TriangleMesh& surface, std::unique_ptr<SlicedWork<PolygonMesh>> remeshing) {
  return std::make_unique<QualityMeasuring>(surface, std::move(remeshing));
}

RemeshQuality measureQuality(const TriangleMesh& surface, const PolygonMesh& remesh) {
  return finished(startQuality(surface, std::make_unique<Ready<PolygonMesh>>(remesh)));
}

}  // namespace gvd
