// SPDX-License-Identifier: MIT
//
// `sampleUniform` and `sampleByDensity`: independent random points.
#include <Eigen/Core>
#include <cmath>
#include <memory>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "base/random.h"
#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "gvd/sampling.h"
#include "mesh/random_points.h"
#include "tessellation/density.h"

namespace gvd {
namespace {

/// Draws faces by the integrals of the square root of the density, and points within a face by
/// rejection. Without a density, faces are drawn by their areas, and no point is rejected.
class RandomSampling final : public SequentialWork<std::vector<SurfacePoint>> {
 public:
  RandomSampling(const TriangleMesh& mesh, std::vector<double> density, int count,
                 std::uint64_t seed)
      : mesh_(mesh), density_(std::move(density)), count_(count), random_(seed) {
    requireCount(count);
  }

  bool advance(long budget) override {
    return sequence_.run(
        [&] {
          sums_.reserve(mesh_.faceCount());
          out_.reserve(count_);  // what does not fit is not tried
        },
        forEach(mesh_.faceCount(), budget, 8,
                [&](int f) {
                  sum_ += mesh_.faceArea(f) * (density_.empty() ? 1 : rootsOf(f).sum());
                  sums_.push_back(sum_);
                }),
        [&] {
          if (!(sum_ > 0)) rejectArgument("the density is zero all over the surface");
        },
        forEach(count_, budget, 1, [&](int) { out_.push_back(draw()); }));
  }

 private:
  Eigen::Vector3d rootsOf(int face) const {
    Eigen::Vector3d roots;
    for (int i = 0; i < 3; ++i) roots[i] = std::sqrt(density_[mesh_.tail(3 * face + i)]);
    return roots;
  }

  SurfacePoint draw() {
    SurfacePoint p = drawPoint(random_, sums_);
    if (density_.empty()) return p;
    const Eigen::Vector3d roots = rootsOf(p.face);
    while (drawUniform(random_) * roots.maxCoeff() > p.bary.dot(roots))
      p.bary = drawBarycentric(random_);
    return p;
  }

  const TriangleMesh& mesh_;
  const std::vector<double> density_;
  const int count_;
  std::mt19937_64 random_;
  std::vector<double> sums_;  ///< per face, of the integrals up to it
  double sum_ = 0;
};

}  // namespace

std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startUniform(const TriangleMesh& mesh,
                                                                    int count, std::uint64_t seed) {
  return std::make_unique<RandomSampling>(mesh, std::vector<double>(), count, seed);
}

std::vector<SurfacePoint> sampleUniform(const TriangleMesh& mesh, int count, std::uint64_t seed) {
  return finished(startUniform(mesh, count, seed));
}

std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startByDensity(const TriangleMesh& mesh,
                                                                      std::vector<double> density,
                                                                      int count,
                                                                      std::uint64_t seed) {
  requireDensity(mesh, density);
  return std::make_unique<RandomSampling>(mesh, std::move(density), count, seed);
}

std::vector<SurfacePoint> sampleByDensity(const TriangleMesh& mesh, std::span<const double> density,
                                          int count, std::uint64_t seed) {
  return finished(startByDensity(mesh, {density.begin(), density.end()}, count, seed));
}

}  // namespace gvd
