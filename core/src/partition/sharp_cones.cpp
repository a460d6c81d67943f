// SPDX-License-Identifier: MIT
#include "partition/sharp_cones.h"

#include <cmath>
#include <numbers>

#include "base/plane.h"
#include "distance/site_frame.h"
#include "gvd/geodesic.h"
#include "gvd/straightest.h"
#include "mesh/face_layout.h"
#include "mesh/incidence.h"

namespace gvd {
namespace {

/// The sharp cone with the least angle sum in a region; -1 if there is none.
int sharpestConeIn(const TriangleMesh& mesh, const Partition& partition,
                   const RegionPatch& region) {
  int sharpest = -1;
  double least = std::numbers::pi;
  for (int t = region.firstTriangle; t < region.firstTriangle + region.triangleCount; ++t)
    for (const int p : partition.triangles[t]) {
      const int v = vertexAt(mesh, partition.points[p]);
      if (v < 0 || mesh.onBoundary(v) || mesh.angleSum(v) >= least) continue;
      sharpest = v;
      least = mesh.angleSum(v);
    }
  return sharpest;
}

/// The direction in which a path leaves a vertex, as an angle from `TriangleMesh::outgoing`.
double angleOfPath(const TriangleMesh& mesh, int vertex, std::span<const SurfacePoint> path) {
  double angle = 0;
  for (const int h : mesh.fan(vertex)) {
    if (const auto next = pointInFace(mesh, path[1], TriangleMesh::faceOf(h))) {
      const Eigen::Vector2d way = layOut(mesh.face(next->face), h % 3, next->bary);
      return angle + std::atan2(way.y(), way.x());
    }
    angle += mesh.cornerAngle(h);
  }
  return angle;
}

/// A site turned about a cone, by a third and by two thirds of the angle sum. Empty if the mesh
/// ends before.
std::vector<SurfacePoint> turnedAbout(const TriangleMesh& mesh, int cone,
                                      const SurfacePoint& site) {
  const SurfacePoint start = pointAtVertex(mesh, cone);
  const auto path = shortestPath(mesh, start, site);
  if (path.size() < 2) return {};
  const double radius = lengthOf(mesh, path), sum = mesh.angleSum(cone);
  const double outgoing = angleOfOutgoing(mesh, start, mesh.outgoing(cone));
  const double angle = angleOfPath(mesh, cone, path);
  std::vector<SurfacePoint> turned;
  for (const int thirds : {1, 2}) {
    const double direction = outgoing + std::fmod(angle + thirds * sum / 3, sum);
    const auto way = walkStraight(mesh, start, radius * unitVector(direction));
    if (way.metBoundary) return {};
    turned.push_back(way.end);
  }
  return turned;
}

}  // namespace

std::vector<SurfacePoint> sitesAroundCone(const TriangleMesh& mesh,
                                          std::span<const SurfacePoint> sites,
                                          const Partition& partition, const Violation& violation) {
  if (violation.kind != Violation::kClosedBorder) return {};
  for (const int side : {0, 1}) {
    const RegionPatch& region = partition.regions[violation.labels[side]];
    if (region.components != 1 || region.loops != 1 || region.genus != 0) continue;
    const int cone = sharpestConeIn(mesh, partition, region);
    if (cone >= 0) return turnedAbout(mesh, cone, sites[violation.labels[1 - side]]);
  }
  return {};
}

}  // namespace gvd
