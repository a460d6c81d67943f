// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "dual_parts.h"
#include "gvd/error.h"

namespace gvd {
namespace {

/// One round: a diagram, what is wrong with it, and where sites would help.
class Round {
 public:
  Round(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric)
      : mesh_(mesh), field_(distances(mesh, sites, metric)) {
    diagram_ = traceDiagram(mesh, *field_, static_cast<int>(sites.size()));
    partition_ = partition(mesh, diagram_, {.leaveOutUnreachable = true});
    complex_ = buildRegionComplex(partition_);
    findings_ = inspect(mesh, diagram_, partition_, complex_);
    isTouched_.assign(sites.size(), false);
  }

  const std::vector<Finding>& findings() const { return findings_; }
  Diagram takeDiagram() { return std::move(diagram_); }

  /// One for each violation, but at most one around each region.
  std::vector<SurfacePoint> newSites() {
    std::vector<SurfacePoint> result;
    for (const Finding& finding : findings_) {
      const Violation& v = finding.violation;
      if (v.kind == Violation::kUnreachable && !result.empty()) continue;
      const bool isTouched = std::any_of(v.labels.begin(), v.labels.end(),
                                         [&](int label) { return isTouched_[label]; });
      if (isTouched) continue;
      result.push_back(v.kind == Violation::kUnreachable ? unreachablePoint()
                                                         : farthestPoint(finding));
      for (const int label : v.labels) touch(label);
    }
    return result;
  }

 private:
  static std::unique_ptr<DistanceField> distances(const TriangleMesh& mesh,
                                                  std::span<const SurfacePoint> sites,
                                                  Metric metric) {
    const auto propagation = propagate(mesh, sites, metric);
    while (!propagation->step(100000)) {
    }
    return propagation->take();
  }

  void touch(int label) {
    isTouched_[label] = true;
    for (const auto& n : partition_.regions[label].neighbours) isTouched_[n.label] = true;
  }

  SurfacePoint unreachablePoint() const {
    int f = 0;
    while (diagram_.faceLabel[f] != Diagram::kUnreachable) ++f;
    return {f, Eigen::Vector3d::Constant(1.0 / 3)};
  }

  double distanceAt(int vertex) const {
    return field_->nearest(partition_.points[vertex]).distance;
  }

  SurfacePoint farthestPoint(const Finding& finding) const {
    double most = -1;
    int farthest = finding.vertices.front();
    for (const int vertex : finding.vertices) {
      const double distance = distanceAt(vertex);
      if (distance <= most) continue;
      most = distance;
      farthest = vertex;
    }
    return partition_.points[farthest];
  }

  const TriangleMesh& mesh_;
  std::unique_ptr<DistanceField> field_;
  Diagram diagram_;
  Partition partition_;
  RegionComplex complex_;
  std::vector<Finding> findings_;
  std::vector<char> isTouched_;
};

}  // namespace

RepairedSites repair(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric,
                     const RepairOptions& options) {
  RepairedSites result{{sites.begin(), sites.end()}, 0, {}};
  for (;;) {
    Round round(mesh, result.sites, metric);
    if (round.findings().empty()) {
      result.diagram = round.takeDiagram();
      return result;
    }
    const Violation& first = round.findings().front().violation;
    for (const Finding& finding : round.findings())
      if (finding.violation.kind == Violation::kNoRegion)
        throw Error(ErrorCode::kInvalidArgument, finding.violation.message);
    if (first.kind == Violation::kNoManifold)
      throw Error(ErrorCode::kInvalidArgument, first.message);
    const auto added = round.newSites();
    if (result.added + static_cast<int>(added.size()) > options.maxAdded)
      throw Error(ErrorCode::kInvalidArgument,
                  "the dual is not valid with " + std::to_string(options.maxAdded) +
                      (options.maxAdded == 1 ? " site" : " sites") + " more: " + first.message);
    result.sites.insert(result.sites.end(), added.begin(), added.end());
    result.added += static_cast<int>(added.size());
  }
}

}  // namespace gvd
