// SPDX-License-Identifier: MIT
#include "gvd/sampling.h"

#include <algorithm>
#include <random>
#include <string>

#include "gvd/error.h"

namespace gvd {
namespace {

/// Uniform in [0, 1), a multiple of 2^-53. The distributions of the standard library may differ
/// from one to the next; the generator may not.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

/// The areas of faces 0 … f, summed up; if there is no area at all, their number.
std::vector<double> cumulativeAreas(const TriangleMesh& mesh) {
  const bool hasArea = mesh.area() > 0;
  std::vector<double> sums(mesh.faceCount());
  double sum = 0;
  for (int f = 0; f < mesh.faceCount(); ++f) sums[f] = sum += hasArea ? mesh.faceArea(f) : 1;
  return sums;
}

/// Folds the unit square onto the triangle below its diagonal. Multiples of 2^-53 are exact here,
/// and the coordinates sum to 1 exactly.
Eigen::Vector3d uniformBarycentric(std::mt19937_64& random) {
  double u = uniform(random), v = uniform(random);
  if (v > 1 - u) {
    u = 1 - u;
    v = 1 - v;
  }
  return {1 - u - v, u, v};
}

}  // namespace

std::vector<SurfacePoint> sampleUniform(const TriangleMesh& mesh, int count, std::uint64_t seed) {
  if (count < 0) {
    throw Error(ErrorCode::kInvalidArgument,
                "there cannot be " + std::to_string(count) + " sample points");
  }
  const std::vector<double> sums = cumulativeAreas(mesh);
  std::mt19937_64 random(seed);
  std::vector<SurfacePoint> points(count);
  for (SurfacePoint& p : points) {
    // u < 1 makes u · total < total, rounded too; so there is a face, and it has an area.
    const double area = uniform(random) * sums.back();
    p.face = static_cast<int>(std::upper_bound(sums.begin(), sums.end(), area) - sums.begin());
    p.bary = uniformBarycentric(random);
  }
  return points;
}

}  // namespace gvd
