// SPDX-License-Identifier: MIT
//
// Places of sites on some fixed meshes: the diagram by either metric is consistent.
#include <cstdio>
#include <cstdlib>

#include "diagram_checks.h"
#include "shapes.h"

namespace {

using namespace gvd;

const TriangleMesh& meshOf(int choice) {
  static const TriangleMesh meshes[] = {
      shapes::triangle().mesh(),      shapes::grid(3, 3).mesh(),
      shapes::cube().mesh(),          shapes::torus(4, 3).mesh(),
      shapes::ell(1).mesh(),          shapes::vertexFan(5, 1e-3).mesh(),
      shapes::vertexFan(8, 9).mesh(), shapes::moebiusStrip(5, 1).mesh()};
  return meshes[choice];
}

SurfacePoint placeOn(const TriangleMesh& mesh, shapes::Random& random) {
  const int face = random.below(mesh.faceCount());
  const int kind = random.below(4);
  if (kind == 0) return {face, Eigen::Vector3d::Unit(random.below(3))};
  double a = random.uniform(), b = kind == 1 ? 0 : random.uniform();
  if (a + b > 1) a = 1 - a, b = 1 - b;
  return {face, {a, b, 1 - a - b}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  shapes::Random random(std::span(data, size));
  const TriangleMesh& mesh = meshOf(random.below(8));
  const Metric metric = random.below(2) ? Metric::kExact : Metric::kDgpc;
  std::vector<SurfacePoint> sites;
  for (int n = 1 + random.below(12); n > 0; --n) sites.push_back(placeOn(mesh, random));
  const auto result = checks::isConsistent(mesh, checks::trace(mesh, sites, metric).diagram);
  if (result) return 0;
  std::fprintf(stderr, "%s\n", result.message());
  std::abort();
}
