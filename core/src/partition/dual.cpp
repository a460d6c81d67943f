// SPDX-License-Identifier: MIT
//
// The dual: a vertex per site and per run of the boundary, a polygon per Voronoi point.
#include "gvd/dual.h"

#include <algorithm>

#include "gvd/partition.h"
#include "mesh/corners.h"
#include "partition/dual_parts.h"

namespace gvd {
namespace {

int addVertex(const TriangleMesh& mesh, const SurfacePoint& p, PolygonMesh& result) {
  result.points.push_back(p);
  result.positions.push_back(mesh.position(p));
  return static_cast<int>(result.points.size()) - 1;
}

bool isRun(const RegionComplex::Border& border) {
  return border.beyond == RegionComplex::kOutside && border.fromVertex >= 0;
}

/// The point at a share of a halfedge of a partition.
SurfacePoint pointOn(const TriangleMesh& mesh, const Partition& p, int h, double share) {
  const Eigen::Matrix3d corners = cornersInFace(mesh, p, h / 3);
  return {p.triangleFace[h / 3],
          (1 - share) * corners.col(h % 3) + share * corners.col(cornerAfter(h % 3))};
}

/// The point of a run that stands for it as a vertex: its middle, by length, or where it turns, if
/// it turns in one place, so that a corner of the mesh boundary is kept. It does if the way from
/// end to end over a point of it is longer than the straight line, and not shorter than the run.
SurfacePoint pointOfRun(const TriangleMesh& mesh, const Partition& p,
                        const RegionComplex::Border& run) {
  constexpr double kLonger = 1.05;  // as over a turn by 36° halfway
  const auto tail = [&](int h) { return p.positions[tailOf(p.triangles, h)]; };
  const auto tip = [&](int h) { return p.positions[tipOf(p.triangles, h)]; };
  const auto lengthOf = [&](int h) { return (tip(h) - tail(h)).norm(); };
  const Eigen::Vector3d from = tail(run.path.front()), to = tip(run.path.back());
  int turn = run.path.front();
  double longest = 0, length = 0;
  for (const int h : run.path) {
    length += lengthOf(h);
    const double way = (tail(h) - from).norm() + (to - tail(h)).norm();
    if (way > longest) turn = h;
    longest = std::max(longest, way);
  }
  if (longest > kLonger * (to - from).norm() && length < kLonger * longest)
    return pointOn(mesh, p, turn, 0);
  double rest = length / 2;
  size_t i = 0;
  for (; i + 1 < run.path.size() && rest > lengthOf(run.path[i]); ++i)
    rest -= lengthOf(run.path[i]);
  const int h = run.path[i];
  const double whole = lengthOf(h);
  return pointOn(mesh, p, h, whole > 0 ? std::clamp(rest / whole, 0.0, 1.0) : 0.5);
}

}  // namespace

PolygonMesh buildDual(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                      const Partition& partition, const RegionComplex& complex) {
  PolygonMesh result;
  std::vector<int> vertexOfLabel(sites.size(), -1);
  for (size_t l = 0; l < sites.size(); ++l) {
    if (sites[l].face < 0) continue;
    vertexOfLabel[l] = addVertex(mesh, sites[l], result);
    result.vertexLabel.push_back(static_cast<int>(l));
  }
  std::vector<int> vertexOfRun(complex.borders.size(), -1);
  for (size_t b = 0; b < complex.borders.size(); ++b) {
    const RegionComplex::Border& border = complex.borders[b];
    if (!isRun(border)) continue;
    vertexOfRun[b] = addVertex(mesh, pointOfRun(mesh, partition, border), result);
    result.vertexLabel.push_back(border.label);
  }
  std::vector<int> polygon;
  for (size_t v = 0; v < complex.vertices.size(); ++v) {
    const RegionComplex::Vertex& vertex = complex.vertices[v];
    polygon = complex.labelsAt(static_cast<int>(v));
    for (int& corner : polygon) corner = vertexOfLabel[corner];
    if (vertex.isOnBoundary()) {
      polygon.insert(polygon.begin(), vertexOfRun[vertex.borders.front()]);
      polygon.push_back(vertexOfRun[vertex.arrivingRun]);
    }
    result.faces.add(polygon);
  }
  return result;
}

namespace {

PolygonMesh buildRegions(const TriangleMesh& mesh, const Partition& partition,
                         const RegionComplex& complex) {
  PolygonMesh result;
  for (const RegionComplex::Vertex& vertex : complex.vertices)
    addVertex(mesh, partition.points[vertex.point], result);
  std::vector<int> polygon;
  for (const RegionComplex::Loop& loop : complex.loops) {
    polygon.clear();
    for (int b = loop.firstBorder; b < loop.firstBorder + loop.borderCount; ++b) {
      const RegionComplex::Border& border = complex.borders[b];
      if (border.fromVertex >= 0) polygon.push_back(border.fromVertex);
      if (isRun(border))
        polygon.push_back(addVertex(mesh, pointOfRun(mesh, partition, border), result));
    }
    if (polygon.empty()) continue;
    result.faces.add(polygon);
    result.faceLabel.push_back(loop.label);
  }
  return result;
}

}  // namespace

std::unique_ptr<SlicedWork<PolygonMesh>> startDualMesh(const TriangleMesh& mesh,
                                                       std::span<const SurfacePoint> sites,
                                                       const Diagram& diagram) {
  return fromRegions(mesh, diagram,
                     [&mesh, sites = sitesOf(mesh, diagram, sites)](const Partition& partition,
                                                                    const RegionComplex& complex) {
                       return buildDual(mesh, sites, partition, complex);
                     });
}

PolygonMesh dualMesh(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                     const Diagram& diagram) {
  return finished(startDualMesh(mesh, sites, diagram));
}

std::unique_ptr<SlicedWork<PolygonMesh>> startRegionMesh(const TriangleMesh& mesh,
                                                         const Diagram& diagram) {
  return fromRegions(mesh, diagram,
                     [&mesh](const Partition& partition, const RegionComplex& complex) {
                       return buildRegions(mesh, partition, complex);
                     });
}

PolygonMesh regionMesh(const TriangleMesh& mesh, const Diagram& diagram) {
  return finished(startRegionMesh(mesh, diagram));
}

}  // namespace gvd
