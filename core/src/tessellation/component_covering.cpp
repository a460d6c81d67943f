// SPDX-License-Identifier: MIT
//
// `coverComponents` and `bareComponents`: sites on every component.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/random.h"
#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "gvd/sampling.h"
#include "mesh/given_points.h"
#include "mesh/random_points.h"

namespace gvd {
namespace {

constexpr long kPointsPerUnit = 8, kFacesPerUnit = 16;

/// Counts a point of a list on its component, and cleans its coordinates.
void countPoint(const TriangleMesh& mesh, SurfacePoint& p, std::size_t index,
                std::vector<int>& counts) {
  if (p.face == -1) return;
  p = onMesh(mesh, p, "point", index);
  ++counts[mesh.component(p.face)];
}

/// Draws points on the components that have fewer than `perComponent`, as many as they lack, and
/// drops given ones, from the last to the first, while there are too many.
class ComponentCovering final : public SequentialWork<std::vector<SurfacePoint>> {
 public:
  ComponentCovering(const TriangleMesh& mesh, std::vector<SurfacePoint> points, int perComponent,
                    int count, std::uint64_t seed)
      : mesh_(mesh),
        given_(std::move(points)),
        counts_(mesh.topology().components),
        lacking_(counts_.size()),
        perComponent_(perComponent),
        count_(count),
        random_(seed) {
    requireCount(perComponent);
    const int components = mesh.topology().components;
    const std::int64_t needed = static_cast<std::int64_t>(perComponent) * components;
    if (needed > count)
      rejectArgument(std::to_string(perComponent) + " per component, of which the mesh has " +
                     std::to_string(components) + ", makes " + std::to_string(needed) +
                     " sites, more than the " + std::to_string(count) + " in all");
  }

  bool advance(long budget) override {
    return sequence_.run(
        forEach(given_, budget, kPointsPerUnit,
                [&](int i) { countPoint(mesh_, given_[i], i, counts_); }),
        forEach(mesh_.faceCount(), budget, kFacesPerUnit, [&](int f) { listFace(f); }),
        forEach(lacking_, budget, kPointsPerUnit, [&](int c) { return drawOn(c) + 1L; }),
        // The list is filled from the last point to the first, and reversed in the end.
        [&] {
          surplus_ = static_cast<std::int64_t>(missing_.size()) - count_;
          for (const int count : counts_) surplus_ += count;
          out_.assign(missing_.rbegin(), missing_.rend());
        },
        forEach(given_, budget, kPointsPerUnit,
                [&](int i) { keepOrDrop(given_[given_.size() - 1 - i]); }),
        [&] { std::reverse(out_.begin(), out_.end()); });
  }

 private:
  /// The faces of a component that lacks points, and the cumulative sums of their areas.
  struct FaceAreas {
    std::vector<int> faces;
    std::vector<double> sums;
  };

  void listFace(int f) {
    const int c = mesh_.component(f);
    if (counts_[c] >= perComponent_) return;
    auto& [faces, sums] = lacking_[c];
    faces.push_back(f);
    sums.push_back((sums.empty() ? 0 : sums.back()) + mesh_.faceArea(f));
  }

  /// Draws the points that a component lacks; returns how many.
  int drawOn(int c) {
    const int lack = std::max(0, perComponent_ - counts_[c]);
    for (int i = 0; i < lack; ++i) {
      missing_.push_back(drawPoint(random_, lacking_[c].sums));
      missing_.back().face = lacking_[c].faces[missing_.back().face];
    }
    return lack;
  }

  void keepOrDrop(const SurfacePoint& p) {
    if (surplus_ > 0 && p.face != -1 && counts_[mesh_.component(p.face)] > perComponent_) {
      --counts_[mesh_.component(p.face)];
      --surplus_;
    } else {
      out_.push_back(p);
    }
  }

  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> given_;
  std::vector<int> counts_;         ///< of the given points, per component
  std::vector<FaceAreas> lacking_;  ///< per component
  const int perComponent_, count_;
  std::mt19937_64 random_;
  std::vector<SurfacePoint> missing_;
  std::int64_t surplus_ = 0;
};

class BareCounting final : public SequentialWork<BareComponents> {
 public:
  BareCounting(const TriangleMesh& mesh, std::span<const SurfacePoint> points)
      : mesh_(mesh), points_(points.begin(), points.end()), counts_(mesh.topology().components) {}

  bool advance(long budget) override {
    return sequence_.run(
        forEach(points_, budget, kPointsPerUnit,
                [&](int i) { countPoint(mesh_, points_[i], i, counts_); }),
        [&] { out_.components = static_cast<int>(std::count(counts_.begin(), counts_.end(), 0)); },
        forEach(mesh_.faceCount(), budget, kFacesPerUnit, [&](int f) {
          if (counts_[mesh_.component(f)] == 0) out_.area += mesh_.faceArea(f);
        }));
  }

 private:
  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> points_;
  std::vector<int> counts_;  ///< of the points, per component
};

}  // namespace

std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startCoverComponents(
    const TriangleMesh& mesh, std::vector<SurfacePoint> points, int perComponent, int count,
    std::uint64_t seed) {
  return std::make_unique<ComponentCovering>(mesh, std::move(points), perComponent, count, seed);
}

std::vector<SurfacePoint> coverComponents(const TriangleMesh& mesh,
                                          std::vector<SurfacePoint> points, int perComponent,
                                          int count, std::uint64_t seed) {
  return finished(startCoverComponents(mesh, std::move(points), perComponent, count, seed));
}

std::unique_ptr<SlicedWork<BareComponents>> startBareComponents(
    const TriangleMesh& mesh, std::span<const SurfacePoint> points) {
  return std::make_unique<BareCounting>(mesh, points);
}

BareComponents bareComponents(const TriangleMesh& mesh, std::span<const SurfacePoint> points) {
  return finished(startBareComponents(mesh, points));
}

}  // namespace gvd
