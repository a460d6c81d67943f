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
#include "partition/dual_parts.h"
#include "partition/hausdorff.h"

namespace gvd {
namespace {

using Eigen::Vector3d;
using Triangles = std::vector<SpaceTriangle>;

Triangles inSpace(const PolygonMesh& mesh, const PolygonTriangles& cut) {
  Triangles triangles;
  for (const auto& [a, b, c] : cut.triangles)
    triangles.push_back({mesh.positions[a], mesh.positions[b], mesh.positions[c]});
  return triangles;
}

/// The least angle of a triangle, in degrees; 0 if it has no area.
double leastAngle(const SpaceTriangle& t) {
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

double meanSide(const Triangles& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) sum += (b - a).norm() + (c - b).norm() + (a - c).norm();
  return sum / (3 * static_cast<double>(triangles.size()));
}

class QualityMeasuring final : public SlicedWork<RemeshQuality> {
 public:
  QualityMeasuring(const TriangleMesh& surface, std::unique_ptr<SlicedWork<PolygonMesh>> remeshing)
      : surface_(surface), remeshing_(std::move(remeshing)), surfaceTree_(surface) {}
  QualityMeasuring(const TriangleMesh& surface, const PolygonMesh& remesh)
      : surface_(surface), surfaceTree_(surface) {
    measureRemesh(remesh);
  }

  bool advance(long budget) override {
    return sequence_.run(
        [&] { return !remeshing_ || remeshing_->step(budget); },
        [&] {
          if (remeshing_) measureRemesh(remeshing_->take());
        },
        [&] { return remeshTree_->step(budget); }, [&] { return surfaceTree_.step(budget); },
        [&] { return runPart(fromRemesh_, budget, *remeshTree_, surfaceTree_, 0., resolution_); },
        [&] {
          return runPart(fromSurface_, budget, surfaceTree_, *remeshTree_, fromRemesh_->distance(),
                         resolution_);
        },
        [&] { quality_.hausdorff = fromSurface_->distance(); });
  }
  double share() const override { return sequence_.progress(); }
  RemeshQuality result() override { return quality_; }

 private:
  void measureRemesh(const PolygonMesh& remesh) {
    const PolygonTriangles cut = triangulate(remesh);
    Triangles triangles = inSpace(remesh, cut);
    measureAngles(triangles, quality_);
    measureValences(cut, static_cast<int>(remesh.positions.size()), quality_);
    // Not zero, where the remesh is as small as a point.
    const double mean = surface_.meanEdgeLength();
    resolution_ = std::max(std::min(mean, meanSide(triangles)), mean / 64);
    remeshTree_.emplace(std::move(triangles));
  }

  const TriangleMesh& surface_;
  std::unique_ptr<SlicedWork<PolygonMesh>> remeshing_;  ///< null if the remesh is known

  SlicedSequence sequence_;
  std::optional<TriangleTree> remeshTree_;
  TriangleTree surfaceTree_;  ///< of the surface
  double resolution_ = 0;     ///< the shorter mean edge of the two
  std::optional<OneSidedHausdorff> fromRemesh_, fromSurface_;
  RemeshQuality quality_;
};

}  // namespace

double minAngleOf(const PolygonMesh& remesh) {
  RemeshQuality quality;
  measureAngles(inSpace(remesh, triangulate(remesh)), quality);
  return quality.minAngle;
}

std::unique_ptr<SlicedWork<RemeshQuality>> startQuality(
    const TriangleMesh& surface, std::unique_ptr<SlicedWork<PolygonMesh>> remeshing) {
  return std::make_unique<QualityMeasuring>(surface, std::move(remeshing));
}

RemeshQuality measureQuality(const TriangleMesh& surface, const PolygonMesh& remesh) {
  return finished<RemeshQuality>(std::make_unique<QualityMeasuring>(surface, remesh));
}

}  // namespace gvd
