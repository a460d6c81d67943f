// SPDX-License-Identifier: MIT
#include "gvd/diagram.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "diagram_checks.h"
#include "gvd/sampling.h"
#include "shapes.h"
#include "tolerances.h"

namespace gvd {
namespace {

using checks::areSame;
using checks::identity;
using checks::isConsistent;
using checks::trace;

/// A random mesh of many kinds: genus 0 to 3, with and without boundary, plane and not.
TriangleMesh randomMesh(std::uint64_t seed) {
  shapes::Random random(seed);
  const int kind = static_cast<int>(seed % 8);
  switch (kind) {
    case 0: return shapes::randomTriangulation(5 + random.below(60), 40, seed).mesh();
    case 1: return shapes::bumpySurface(0, 2, 0.3, seed).mesh();
    case 2: return shapes::bumpySurface(1, 1 + random.below(2), 0.3, seed).mesh();
    case 3: return shapes::bumpySurface(2, 1, 0.4, seed).mesh();
    case 4: return shapes::bumpySurface(3, 1, 0.4, seed).mesh();
    case 5:
      return shapes::withoutRandomFaces(shapes::bumpySurface(1, 2, 0.3, seed), 10, seed).mesh();
    case 6: return shapes::withoutRandomFaces(shapes::icosphere(2), 20, seed).mesh();
    default: return shapes::gradedDisk(4 + random.below(8), 6 + random.below(6), 0.6).mesh();
  }
}

int randomSiteCount(const TriangleMesh& mesh, std::uint64_t seed) {
  shapes::Random random(seed + 1000);
  // Few, some, and up to twice as many as there are vertices.
  const int most = seed % 5 == 0 ? 2 * mesh.vertexCount() : seed % 2 == 0 ? 20 : 5;
  return 1 + random.below(most);
}

/// Every site's distances on the whole mesh, each from a sweep of its own: nothing is stopped early.
class WholeMaps final : public DistanceField {
 public:
  WholeMaps(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric)
      : at_(mesh.vertexCount()) {
    for (size_t l = 0; l < sites.size(); ++l) {
      const auto single = trace(mesh, sites.subspan(l, 1), metric).field;
      for (int v = 0; v < mesh.vertexCount(); ++v)
        for (const LabelledDistance& d : single->at(v))
          at_[v].push_back({static_cast<int>(l), d.distance});
    }
    for (auto& here : at_) equalizeTies(here);
  }
  std::span<const LabelledDistance> at(int vertex) const override { return at_[vertex]; }
  LabelledDistance nearest(const SurfacePoint&) const override { return {}; }
  double distance(int, const SurfacePoint&) const override { return kInfinity; }

 private:
  std::vector<std::vector<LabelledDistance>> at_;
};

class RandomMeshes : public ::testing::TestWithParam<int> {};

TEST_P(RandomMeshes, GiveConsistentDiagrams) {
  const auto mesh = randomMesh(GetParam());
  const auto sites = sampleUniform(mesh, randomSiteCount(mesh, GetParam()), GetParam());
  const auto traced = trace(mesh, sites);
  EXPECT_TRUE(isConsistent(mesh, traced.diagram));
}

TEST_P(RandomMeshes, GiveTheDiagramOfWholeMaps) {
  const auto mesh = randomMesh(GetParam());
  const auto sites = sampleUniform(mesh, randomSiteCount(mesh, GetParam()), GetParam());
  const auto traced = trace(mesh, sites);
  const WholeMaps maps(mesh, sites, Metric::kDgpc);
  const Diagram expected = traceDiagram(mesh, maps, static_cast<int>(sites.size()));
  EXPECT_TRUE(areSame(mesh, expected, traced.diagram, identity(expected.siteCount), 1e-11));
}

TEST_P(RandomMeshes, KnowNothingOfTheOrderOfSites) {
  const auto mesh = randomMesh(GetParam());
  const auto sites = sampleUniform(mesh, randomSiteCount(mesh, GetParam()), GetParam());
  std::vector<int> order = identity(static_cast<int>(sites.size()));
  shapes::Random random(GetParam());
  for (size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.below(static_cast<int>(i))]);
  std::vector<SurfacePoint> permuted(sites.size());
  for (size_t i = 0; i < sites.size(); ++i) permuted[order[i]] = sites[i];
  const Diagram a = trace(mesh, sites).diagram, b = trace(mesh, permuted).diagram;
  EXPECT_TRUE(areSame(mesh, a, b, order, 1e-12));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomMeshes, ::testing::Range(0, 208));

}  // namespace
}  // namespace gvd
