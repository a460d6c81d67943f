// SPDX-License-Identifier: MIT
//
// Repair of a dual: adds sites at its violations until there are none.
#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "distance/site_distances.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/error.h"
#include "partition/dual_parts.h"

namespace gvd {
namespace {

/// One round of the repair: finds the sites to add for the violations of a diagram.
class RepairRound {
 public:
  RepairRound(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, const Diagram& diagram,
              const DistanceField& field, const Partition& partition)
      : mesh_(mesh),
        sites_(sites),
        diagram_(diagram),
        field_(field),
        partition_(partition),
        isTouched_(diagram.siteCount, false) {}

  std::vector<SurfacePoint> newSites(const RegionComplex& complex) {
    const auto findings = inspect(mesh_, sites_, diagram_, partition_, complex);
    std::vector<SurfacePoint> result;
    for (const Finding& finding : findings) {
      const Violation& v = finding.violation;
      if (v.kind == Violation::kNoRegion || v.kind == Violation::kNoManifold)
        throw Error(ErrorCode::kInvalidArgument, v.message);
      if (v.kind == Violation::kUnreachable) {
        if (result.empty()) result = unreachablePoints();
        continue;
      }
      const bool isTouched = std::any_of(v.labels.begin(), v.labels.end(),
                                         [&](int label) { return isTouched_[label]; });
      if (isTouched) continue;
      result.push_back(farthestPoint(finding));
      for (const int label : v.labels) touch(label);
    }
    return result;
  }

 private:
  void touch(int label) {
    isTouched_[label] = true;
    for (const auto& n : partition_.regions[label].neighbours) isTouched_[n.label] = true;
  }

  /// A point in each component without a site.
  std::vector<SurfacePoint> unreachablePoints() const {
    std::vector<SurfacePoint> points;
    std::set<int> components;
    for (int f = 0; f < mesh_.faceCount(); ++f)
      if (diagram_.faceLabel[f] == Diagram::kUnreachable &&
          components.insert(mesh_.component(f)).second)
        points.push_back({f, Eigen::Vector3d::Constant(1.0 / 3)});
    return points;
  }

  double distanceAt(int point) const { return field_.nearest(partition_.points[point]).distance; }

  SurfacePoint farthestPoint(const Finding& finding) const {
    double most = -1;
    int farthest = finding.points.front();
    for (const int point : finding.points) {
      const double distance = distanceAt(point);
      if (distance <= most) continue;
      most = distance;
      farthest = point;
    }
    return partition_.points[farthest];
  }

  const TriangleMesh& mesh_;
  const std::span<const SurfacePoint> sites_;
  const Diagram& diagram_;
  const DistanceField& field_;
  const Partition& partition_;
  std::vector<char> isTouched_;  ///< regions that a new site may change
};

}  // namespace

std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startRepairingSites(
    const TriangleMesh& mesh, std::span<const SurfacePoint> sites, const Diagram& diagram,
    const DistanceField& field) {
  requireMesh(mesh, field);
  return fromRegions(mesh, diagram,
                     [&mesh, sites = sitesOf(mesh, diagram, sites), &diagram, &field](
                         const Partition& partition, const RegionComplex& complex) {
                       return RepairRound(mesh, sites, diagram, field, partition).newSites(complex);
                     });
}

std::vector<SurfacePoint> repairingSites(const TriangleMesh& mesh,
                                         std::span<const SurfacePoint> sites,
                                         const Diagram& diagram, const DistanceField& field) {
  return finished(startRepairingSites(mesh, sites, diagram, field));
}

RepairedSites repair(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric,
                     const RepairOptions& options) {
  if (options.maxAdded < 0)
    throw Error(ErrorCode::kInvalidArgument,
                "maxAdded is " + std::to_string(options.maxAdded) + ", not a number from 0");
  auto dynamic = DynamicDiagram::fromDistances(mesh, finished(propagate(mesh, sites, metric)));
  for (int added = 0;;) {
    RepairedSites repaired{dynamic.sites(), added, dynamic.diagram()};
    const auto more = repairingSites(mesh, repaired.sites, repaired.diagram, dynamic.distances());
    if (more.empty()) return repaired;
    added += static_cast<int>(more.size());
    if (added > options.maxAdded)
      throw Error(ErrorCode::kInvalidArgument,
                  "the dual is not valid with " + std::to_string(options.maxAdded) +
                      (options.maxAdded == 1 ? " site" : " sites") + " more: " +
                      findViolations(mesh, repaired.sites, repaired.diagram).front().message);
    for (const SurfacePoint& site : more) dynamic.insertSite(site);
  }
}

}  // namespace gvd
