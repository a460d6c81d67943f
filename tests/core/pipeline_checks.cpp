// SPDX-License-Identifier: MIT
#include "pipeline_checks.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "diagram_checks.h"
#include "gvd/cvt.h"
#include "gvd/dual.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/partition.h"
#include "gvd/sampling.h"
#include "partition_checks.h"

namespace gvd::checks {
namespace {

using shapes::Random;
using ::testing::AssertionResult;

/// The result's words, after what it is about; empty if it is a success.
std::string complaint(const std::string& about, const AssertionResult& result) {
  return result ? "" : about + ": " + result.message();
}

SurfacePoint randomPoint(const TriangleMesh& mesh, Random& random) {
  const int face = random.below(mesh.faceCount());
  if (random.below(3) == 0) return {face, Eigen::Vector3d::Unit(random.below(3))};
  double a = random.uniform(), b = random.uniform();
  if (a + b > 1) a = 1 - a, b = 1 - b;
  return {face, {a, b, std::max(0.0, 1 - a - b)}};
}

/// The median of the least heights of the faces.
double medianHeight(const TriangleMesh& mesh) {
  std::vector<double> heights;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const auto& lengths = mesh.face(f).lengths;
    heights.push_back(2 * mesh.faceArea(f) / std::max({lengths[0], lengths[1], lengths[2]}));
  }
  const auto median = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), median, heights.end());
  return *median;
}

/// Whether distances are the same up to a share of them and to one of the longest edge.
class SameDistance {
 public:
  SameDistance(const TriangleMesh& mesh, double share, double shareOfLongestEdge)
      : share_(share), absolute_(shareOfLongestEdge * mesh.longestEdge()) {}
  bool operator()(double a, double b) const {
    return std::abs(a - b) <= share_ * std::max(a, b) + absolute_;
  }

 private:
  double share_, absolute_;
};

/// Whether each of the first sites has the distances that it has without the others.
AssertionResult haveDistancesOfOneSiteEach(const TriangleMesh& mesh,
                                           std::span<const SurfacePoint> sites,
                                           const DistanceField& field) {
  // A distance may be lowered to one that it ties with, and both to a third one: `TieTolerance`,
  // twice.
  const SameDistance isSame(mesh, 0x1p-40, 0x1p-45);
  std::vector<std::unique_ptr<DistanceField>> alone;
  constexpr size_t kMost = 8;
  for (const SurfacePoint& site : sites.first(std::min(sites.size(), kMost)))
    alone.push_back(finished(propagate(mesh, {&site, 1}, Metric::kExact)));
  for (int v = 0; v < mesh.vertexCount(); ++v)
    for (const auto& [label, distance] : field.at(v)) {
      if (label >= static_cast<int>(alone.size())) continue;
      if (const double expected = alone[label]->at(v)[0].distance; !isSame(distance, expected))
        return ::testing::AssertionFailure() << "site " << label << " is " << distance
                                             << " from vertex " << v << ", not " << expected;
    }
  return ::testing::AssertionSuccess();
}

std::string complaintAboutParts(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                Metric metric) {
  const Traced traced = trace(mesh, sites, metric);
  if (const auto result = isConsistent(mesh, traced.diagram); !result)
    return complaint("diagram", result);
  if (metric == Metric::kExact)
    if (const auto result = haveDistancesOfOneSiteEach(mesh, sites, *traced.field); !result)
      return complaint("distances", result);
  const auto [mislabelled, maxEdge] = accuracy(mesh, *traced.field, traced.diagram, 20);
  if (!(mislabelled >= 0 && mislabelled <= 1 && maxEdge > 0 && maxEdge <= 1))
    return "accuracy: " + std::to_string(mislabelled) + " and " + std::to_string(maxEdge);
  const Partition parts = partition(mesh, traced.diagram);
  if (const auto result = isSound(mesh, parts); !result) return complaint("partition", result);
  if (const auto result = hasTheAreasOf(mesh, traced.diagram, parts); !result)
    return complaint("partition", result);
  dualMesh(mesh, sites, traced.diagram);
  regionMesh(mesh, traced.diagram);
  findViolations(mesh, sites, traced.diagram);
  return {};
}

void edit(DynamicDiagram& dynamic, const TriangleMesh& mesh, Random& random) {
  const int label = random.below(std::max(1, dynamic.labelCount()));
  const bool hasSite = label < dynamic.labelCount() && dynamic.hasSite(label);
  switch (hasSite ? random.below(3) : 0) {
    case 0:
      dynamic.insertSite(randomPoint(mesh, random));
      return;
    case 1:
      dynamic.removeSite(label);
      return;
    case 2:
      dynamic.moveSite(label, randomPoint(mesh, random));
  }
}

/// Where two fields do not know the same distances, as far as `DynamicDiagram` promises: label l of
/// `a` is label `labelInB[l]` of `b`.
AssertionResult haveSameDistances(const TriangleMesh& mesh, const DistanceField& a,
                                  const DistanceField& b, std::span<const int> labelInB) {
  const SameDistance isSame(mesh, 0x1p-44, 0x1p-46);
  for (int v = 0; v < mesh.vertexCount(); ++v)
    if (!std::ranges::equal(a.at(v), b.at(v),
                            [&](const LabelledDistance& x, const LabelledDistance& y) {
                              return labelInB[x.label] == y.label && isSame(x.distance, y.distance);
                            }))
      return ::testing::AssertionFailure() << "the distances at vertex " << v << " differ";
  return ::testing::AssertionSuccess();
}

/// How far the areas of regions may differ, as a share of the mesh. If most faces are tiny or thin
/// against the longest edge, sites lie close together, and the rounding of distances moves
/// bisectors by more.
double areaTolerance(const TriangleMesh& mesh) {
  return std::max(1e-9, 0x1p-46 * mesh.longestEdge() / medianHeight(mesh));
}

std::string complaintAboutEdits(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                Random& random, const PipelineOptions& options) {
  DynamicDiagram dynamic(mesh, sites, options.metric);
  for (int i = 0; i < options.edits; ++i) edit(dynamic, mesh, random);
  const Diagram followed = dynamic.diagram();
  if (const auto result = isConsistent(mesh, followed); !result)
    return complaint("after edits", result);
  std::vector<SurfacePoint> present;
  std::vector<int> labels;
  for (int l = 0; l < dynamic.labelCount(); ++l) {
    if (!dynamic.hasSite(l)) continue;
    present.push_back(dynamic.site(l));
    labels.push_back(l);
  }
  if (present.empty()) return {};
  const Traced anew = trace(mesh, present, options.metric);
  if (const auto result = haveSameDistances(mesh, *anew.field, dynamic.distances(), labels);
      !result)
    return complaint("after edits", result);
  return complaint("after edits",
                   areSame(mesh, anew.diagram, followed, labels, areaTolerance(mesh)));
}

std::string complaintAboutTessellation(const TriangleMesh& mesh,
                                       std::span<const SurfacePoint> sites,
                                       const PipelineOptions& options) {
  CvtOptions cvtOptions;
  cvtOptions.metric = options.metric;
  cvtOptions.iterations = options.cvtIterations;
  Cvt cvt(mesh, sites, cvtOptions);
  double energy = kInfinity;
  while (!cvt.isDone()) {
    if (!cvt.step(64)) continue;  // so little that slices end everywhere
    if (!(cvt.iteration().energy <= energy * (1 + 1e-9)))
      return "the energy rises from " + std::to_string(energy) + " to " +
             std::to_string(cvt.iteration().energy);
    energy = cvt.iteration().energy;
    if (const auto result = isConsistent(mesh, *cvt.diagram()); !result)
      return complaint("tessellation", result);
  }
  return {};
}

}  // namespace

std::string complaintAboutPipeline(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                   Random& random, const PipelineOptions& options) {
  std::string what = complaintAboutParts(mesh, sites, options.metric);
  if (what.empty()) what = complaintAboutEdits(mesh, sites, random, options);
  if (what.empty()) what = complaintAboutTessellation(mesh, sites, options);
  return what;
}

}  // namespace gvd::checks
