// SPDX-License-Identifier: MIT
#include "pipeline_checks.h"

#include <algorithm>
#include <vector>

#include "base/tolerances.h"
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

std::string complaintAboutParts(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                Metric metric) {
  const Traced traced = trace(mesh, sites, metric);
  if (const auto result = isConsistent(mesh, traced.diagram); !result)
    return complaint("diagram", result);
  const Partition parts = partition(mesh, traced.diagram);
  if (const auto result = isSound(mesh, parts); !result) return complaint("partition", result);
  if (const auto result = hasTheAreasOf(mesh, traced.diagram, parts); !result)
    return complaint("partition", result);
  dualMesh(mesh, sites, traced.diagram);
  regionMesh(mesh, traced.diagram);
  findViolations(mesh, traced.diagram);
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

/// The share of the mesh by which areas may differ that follow from the same distances in other
/// ways: a bisector of sites s and s' moves by up to `kDistanceTolerance` d² / |s - s'|.
double shareOfRounding(const TriangleMesh& mesh, std::span<const SurfacePoint> sites) {
  std::vector<Eigen::Vector3d> places;
  for (const SurfacePoint& site : sites) places.push_back(mesh.position(site));
  std::sort(places.begin(), places.end(),
            [](const auto& a, const auto& b) { return a.x() < b.x(); });
  double nearest = kInfinity;  // of sites that are not in one place
  for (size_t i = 0; i < places.size(); ++i)
    for (size_t j = i + 1; j < places.size() && places[j].x() - places[i].x() < nearest; ++j)
      if (const double apart = (places[i] - places[j]).norm(); apart > 0)
        nearest = std::min(nearest, apart);
  return std::max(1e-9, kDistanceTolerance * mesh.boundingDiagonal() / nearest);
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
  return complaint("after edits",
                   areSame(mesh, anew.diagram, followed, labels, shareOfRounding(mesh, present)));
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
    if (!cvt.step(1 << 20)) continue;
    if (!(cvt.iteration().energy <= energy * (1 + 1e-9)))
      return "the energy rises from " + std::to_string(energy) + " to " +
             std::to_string(cvt.iteration().energy);
    energy = cvt.iteration().energy;
    if (const auto result = isConsistent(mesh, cvt.diagram()); !result)
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
