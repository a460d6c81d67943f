// SPDX-License-Identifier: MIT
//
// What is derived from a diagram, for JavaScript: the partition of the mesh, the dual, how valid
// and how good that is.

#include <string>
#include <utility>
#include <vector>

#include "gvd/dual.h"
#include "gvd/partition.h"
#include "gvd/remesh.h"
#include "objects.h"
#include "records.h"

namespace gvd::abi {
namespace {

constexpr Named<Violation::Kind> kViolationKinds[] = {
    {"unreachable", Violation::kUnreachable},
    {"no-region", Violation::kNoRegion},
    {"few-runs", Violation::kFewRuns},
    {"closed-border", Violation::kClosedBorder},
    {"no-disk", Violation::kNoDisk},
    {"touches-itself", Violation::kTouchesItself},
    {"two-meet-twice", Violation::kTwoMeetTwice},
    {"three-meet-twice", Violation::kThreeMeetTwice},
    {"no-manifold", Violation::kNoManifold},
};

}  // namespace

/// `Partition`.
GVD_ABI Answer* partition(const VoronoiHandle* voronoi, bool leaveOutIndifferent,
                          bool leaveOutUnreachable) {
  return guarded([&] {
    const Surface on = voronoi->snapshot();
    return answerOf(startPartition(*on.mesh, *on.diagram,
                                   {.leaveOutIndifferent = leaveOutIndifferent,
                                    .leaveOutUnreachable = leaveOutUnreachable}),
                    [on](const Partition& result) { return partitionRecord(*on.mesh, result); });
  });
}

/// `PolygonMesh`: the dual, or if `primal` the regions themselves.
GVD_ABI Answer* dual(const VoronoiHandle* voronoi, bool primal) {
  return guarded([&] {
    const Surface on = voronoi->snapshot();
    return answerOf(
        primal ? startRegionMesh(*on.mesh, *on.diagram)
               : startDualMesh(*on.mesh, voronoi->sitesByLabel(), *on.diagram),
        [on](PolygonMesh result) { return polygonRecord(*on.mesh, std::move(result)); });
  });
}

/// `DualPaths`.
GVD_ABI Answer* dualPaths(const VoronoiHandle* voronoi) {
  return guarded([&] {
    const Surface on = voronoi->snapshot();
    return answerOf(startDualPaths(*on.mesh, *on.diagram, voronoi->field()),
                    [on](const std::vector<DualPath>& paths) {
                      std::vector<int> labels, offset = {0};
                      std::vector<SurfacePoint> points;
                      for (const DualPath& path : paths) {
                        labels.insert(labels.end(), path.labels.begin(), path.labels.end());
                        points.insert(points.end(), path.points.begin(), path.points.end());
                        offset.push_back(static_cast<int>(points.size()));
                      }
                      Record out;
                      out.add("labels", std::move(labels));
                      out.add("offset", std::move(offset));
                      out.add("points", placedRecord(*on.mesh, points));
                      return out;
                    });
  });
}

/// Per violation of the dual its kind and its message, and a list of labels.
GVD_ABI Answer* dualViolations(const VoronoiHandle* voronoi) {
  return guarded([&] {
    const Surface on = voronoi->snapshot();
    return answerOf(startViolations(*on.mesh, voronoi->sitesByLabel(), *on.diagram),
                    [on](const std::vector<Violation>& violations) {
                      std::vector<std::string> kinds, messages;
                      std::vector<int> offset = {0}, labels;
                      for (const Violation& violation : violations) {
                        kinds.emplace_back(nameOf(kViolationKinds, violation.kind));
                        labels.insert(labels.end(), violation.labels.begin(),
                                      violation.labels.end());
                        offset.push_back(static_cast<int>(labels.size()));
                        messages.push_back(violation.message);
                      }
                      Record out;
                      out.add("kind", std::move(kinds));
                      out.add("labelOffset", std::move(offset));
                      out.add("labels", std::move(labels));
                      out.add("message", std::move(messages));
                      return out;
                    });
  });
}

/// `RemeshQuality` of the dual.
GVD_ABI Answer* dualQuality(const VoronoiHandle* voronoi) {
  return guarded([&] {
    const Surface on = voronoi->snapshot();
    return answerOf(
        startQuality(*on.mesh, startDualMesh(*on.mesh, voronoi->sitesByLabel(), *on.diagram)),
        [on](const RemeshQuality& quality) {
          Record out;
          out.add("triangles", quality.triangles);
          out.add("minAngle", quality.minAngle);
          out.add("meanMinAngle", quality.meanMinAngle);
          out.add("minValence", quality.minValence);
          out.add("maxValence", quality.maxValence);
          out.add("regularShare", quality.regularShare);
          out.add("hausdorff", quality.hausdorff);
          return out;
        });
  });
}

/// `SurfacePoints`: the sites that one round of repair adds.
GVD_ABI Answer* repairingSites(const VoronoiHandle* voronoi) {
  return guarded([&] {
    const Surface on = voronoi->snapshot();
    return answerOf(
        startRepairingSites(*on.mesh, voronoi->sitesByLabel(), *on.diagram, voronoi->field()),
        [on](const std::vector<SurfacePoint>& sites) { return pointsRecord(*on.mesh, sites); });
  });
}

}  // namespace gvd::abi
