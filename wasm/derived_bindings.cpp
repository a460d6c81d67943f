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
  return answer([&] {
    const PartitionOptions options = {.leaveOutIndifferent = leaveOutIndifferent,
                                      .leaveOutUnreachable = leaveOutUnreachable};
    const TriangleMesh& mesh = voronoi->mesh();
    return partitionRecord(mesh, gvd::partition(mesh, voronoi->diagram(), options));
  });
}

/// `PolygonMesh`: the dual, or if `primal` the regions themselves.
GVD_ABI Answer* dual(const VoronoiHandle* voronoi, bool primal) {
  return answer([&] {
    const TriangleMesh& mesh = voronoi->mesh();
    const Diagram diagram = voronoi->diagram();
    return polygonRecord(mesh, primal ? regionMesh(mesh, diagram)
                                      : dualMesh(mesh, voronoi->sitesByLabel(), diagram));
  });
}

/// `DualPaths`.
GVD_ABI Answer* dualPaths(const VoronoiHandle* voronoi) {
  return answer([&] {
    const TriangleMesh& mesh = voronoi->mesh();
    std::vector<int> labels, offset = {0};
    std::vector<SurfacePoint> points;
    for (const DualPath& path : gvd::dualPaths(mesh, voronoi->diagram(), voronoi->field())) {
      labels.insert(labels.end(), path.labels.begin(), path.labels.end());
      points.insert(points.end(), path.points.begin(), path.points.end());
      offset.push_back(static_cast<int>(points.size()));
    }
    Record out;
    out.add("labels", std::move(labels));
    out.add("offset", std::move(offset));
    out.add("points", placedRecord(mesh, points));
    return out;
  });
}

/// Per violation of the dual its kind and its message, and a list of labels.
GVD_ABI Answer* dualViolations(const VoronoiHandle* voronoi) {
  return answer([&] {
    std::vector<std::string> kinds, messages;
    std::vector<int> offset = {0}, labels;
    for (const Violation& violation :
         findViolations(voronoi->mesh(), voronoi->sitesByLabel(), voronoi->diagram())) {
      kinds.emplace_back(nameOf(kViolationKinds, violation.kind));
      labels.insert(labels.end(), violation.labels.begin(), violation.labels.end());
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
}

/// `RemeshQuality` of the dual.
GVD_ABI Answer* dualQuality(const VoronoiHandle* voronoi) {
  return answer([&] {
    const TriangleMesh& mesh = voronoi->mesh();
    const RemeshQuality quality =
        measureQuality(mesh, dualMesh(mesh, voronoi->sitesByLabel(), voronoi->diagram()));
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
}

/// `SurfacePoints`: the sites that one round of repair adds.
GVD_ABI Answer* repairingSites(const VoronoiHandle* voronoi) {
  return answer([&] {
    const TriangleMesh& mesh = voronoi->mesh();
    return pointsRecord(mesh, gvd::repairingSites(mesh, voronoi->sitesByLabel(), voronoi->diagram(),
                                                  voronoi->field()));
  });
}

}  // namespace gvd::abi
