// SPDX-License-Identifier: MIT
//
// The quality of a remesh: angles and valences of its triangles, and distance from the surface.
#include "partition/remesh_quality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/index_pairs.h"
#include "base/sliced_loop.h"
#include "gvd/remesh.h"
#include "gvd/surface_point.h"
#include "mesh/triangle_tree.h"
#include "partition/one_sided_hausdorff.h"

namespace gvd {
namespace {

using Eigen::Vector3d;

/// The least angle of a triangle, in degrees; 0 if it has no area.
double leastAngle(const SpaceTriangle& t) {
  double least = std::numbers::pi;
  for (int i = 0; i < 3; ++i) {
    const Vector3d u = t[cornerAfter(i)] - t[i], v = t[cornerBefore(i)] - t[i];
    least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)));
  }
  return least * 180 / std::numbers::pi;
}

double perimeter(const SpaceTriangle& t) {
  const auto& [a, b, c] = t;
  return (b - a).norm() + (c - b).norm() + (a - c).norm();
}

/// Measures the triangles of a remesh.
class TriangleMeasuring final : public SequentialWork<RemeshQuality> {
 public:
  /// The remesh must outlive this.
  explicit TriangleMeasuring(const PolygonMesh& remesh)
      : remesh_(remesh),
        cutting_(startTriangulation(remesh)),
        neighbours_(remesh.positions.size()),
        triangles_(remesh.positions.size()) {}

  bool advance(long budget) override {
    return sequence_.run([&] { return cutting_->step(budget); },
                         [&] {
                           cut_ = cutting_->take().triangles;
                           inSpace_.reserve(cut_.size());
                           out_.triangles = static_cast<int>(cut_.size());
                           if (!cut_.empty()) out_.minAngle = 180;
                         },
                         [&] { return joined_.prepare(2 * cut_.size(), budget); },
                         forEach(cut_, budget, 1, [&](int t) { measure(t); }),
                         forEach(neighbours_, budget, kQuickRounds, [&](int v) { addValence(v); }),
                         [&] {
                           if (inside_ > 0)
                             out_.regularShare = static_cast<double>(regular_) / inside_;
                         });
  }
  double meanSide() const { return perimeters_ / (3 * static_cast<double>(cut_.size())); }
  std::vector<SpaceTriangle> takeInSpace() { return std::move(inSpace_); }

 private:
  void measure(int t) {
    const auto& [a, b, c] = cut_[t];
    const SpaceTriangle& triangle = inSpace_.emplace_back(
        SpaceTriangle{remesh_.positions[a], remesh_.positions[b], remesh_.positions[c]});
    const double angle = leastAngle(triangle);
    out_.minAngle = std::min(out_.minAngle, angle);
    out_.meanMinAngle += angle / out_.triangles;
    perimeters_ += perimeter(triangle);
    for (const int v : cut_[t]) ++triangles_[v];
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const int count = joined_.size();
      if (joined_.add(from, to) < count) continue;
      ++neighbours_[from];
      neighbours_[to] += from != to;
    }
  }

  /// Adds an inner vertex: one with as many triangles as neighbours.
  void addValence(int v) {
    const int valence = neighbours_[v];
    if (valence == 0 || valence != triangles_[v]) return;
    out_.minValence = inside_ == 0 ? valence : std::min(out_.minValence, valence);
    out_.maxValence = std::max(out_.maxValence, valence);
    regular_ += valence == 6;
    ++inside_;
  }

  const PolygonMesh& remesh_;
  std::unique_ptr<SlicedWork<PolygonTriangles>> cutting_;
  std::vector<std::array<int, 3>> cut_;
  std::vector<SpaceTriangle> inSpace_;
  std::vector<int> neighbours_, triangles_;  ///< how many each vertex has
  IndexPairs joined_;                        ///< neighbours
  int inside_ = 0, regular_ = 0;             ///< vertices
  double perimeters_ = 0;                    ///< of all triangles
};

class QualityMeasuring final : public SequentialWork<RemeshQuality> {
 public:
  QualityMeasuring(const TriangleMesh& surface, std::unique_ptr<SlicedWork<PolygonMesh>> remeshing)
      : surface_(surface), remeshing_(std::move(remeshing)), surfaceTree_(surface) {}
  QualityMeasuring(const TriangleMesh& surface, PolygonMesh remesh)
      : surface_(surface), remesh_(std::move(remesh)), surfaceTree_(surface) {}

  bool advance(long budget) override {
    return sequence_.run(
        [&] { return !remeshing_ || remeshing_->step(budget); },
        [&] {
          if (remeshing_) remesh_ = remeshing_->take();
        },
        [&] { return runPart(triangles_, budget, remesh_); },
        [&] {
          out_ = triangles_->take();
          // Not zero, where the remesh is as small as a point.
          const double mean = surface_.meanEdgeLength();
          resolution_ = std::max(std::min(mean, triangles_->meanSide()), mean / 64);
          remeshTree_.emplace(triangles_->takeInSpace());
        },
        [&] { return remeshTree_->step(budget); }, [&] { return surfaceTree_.step(budget); },
        [&] { return runPart(fromRemesh_, budget, *remeshTree_, surfaceTree_, 0., resolution_); },
        [&] {
          return runPart(fromSurface_, budget, surfaceTree_, *remeshTree_, fromRemesh_->distance(),
                         resolution_);
        },
        [&] { out_.hausdorff = fromSurface_->distance(); });
  }

 private:
  const TriangleMesh& surface_;
  std::unique_ptr<SlicedWork<PolygonMesh>> remeshing_;  ///< null if the remesh is given
  PolygonMesh remesh_;

  std::optional<TriangleMeasuring> triangles_;
  std::optional<TriangleTree> remeshTree_;
  TriangleTree surfaceTree_;
  double resolution_ = 0;  ///< the shorter mean edge of the two
  std::optional<OneSidedHausdorff> fromRemesh_, fromSurface_;
};

}  // namespace

std::unique_ptr<SlicedWork<RemeshQuality>> startTriangleQuality(const PolygonMesh& remesh) {
  return std::make_unique<TriangleMeasuring>(remesh);
}

std::unique_ptr<SlicedWork<RemeshQuality>> startQuality(
    const TriangleMesh& surface, std::unique_ptr<SlicedWork<PolygonMesh>> remeshing) {
  return std::make_unique<QualityMeasuring>(surface, std::move(remeshing));
}

RemeshQuality measureQuality(const TriangleMesh& surface, const PolygonMesh& remesh) {
  return finished<RemeshQuality>(std::make_unique<QualityMeasuring>(surface, remesh));
}

}  // namespace gvd
