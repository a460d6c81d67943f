// SPDX-License-Identifier: MIT
//
// `sampleUniform` and `sampleByDensity`: independent random points.
#include <Eigen/Core>
#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "base/random.h"
#include "gvd/error.h"
#include "gvd/sampling.h"
#include "mesh/point_drawing.h"
#include "mesh/surface_geometry.h"
#include "tessellation/density.h"
#include "tessellation/sample_count.h"

namespace gvd {

std::vector<SurfacePoint> sampleUniform(const TriangleMesh& mesh, int count, std::uint64_t seed) {
  requireCount(count);
  const std::vector<double> sums = cumulative(faceAreas(mesh));
  std::mt19937_64 random(seed);
  std::vector<SurfacePoint> points(count);
  for (SurfacePoint& p : points) p = drawPoint(random, sums);
  return points;
}

std::vector<SurfacePoint> sampleByDensity(const TriangleMesh& mesh, std::span<const double> density,
                                          int count, std::uint64_t seed) {
  requireCount(count);
  requireDensity(mesh, density);
  std::vector<double> sums = faceAreas(mesh);
  std::vector<Eigen::Vector3d> corners(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int i = 0; i < 3; ++i) corners[f][i] = std::sqrt(density[mesh.tail(3 * f + i)]);
    sums[f] *= corners[f].sum();
  }
  sums = cumulative(sums);
  if (!(sums.back() > 0))
    throw Error(ErrorCode::kInvalidArgument, "the density is zero all over the surface");
  std::mt19937_64 random(seed);
  std::vector<SurfacePoint> points(count);
  for (SurfacePoint& p : points) {
    p.face = drawIndex(random, sums);
    const Eigen::Vector3d& root = corners[p.face];
    do {
      p.bary = drawBarycentric(random);
    } while (drawUniform(random) * root.maxCoeff() > p.bary.dot(root));
  }
  return points;
}

}  // namespace gvd
