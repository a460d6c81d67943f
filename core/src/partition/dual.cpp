// SPDX-License-Identifier: MIT
//
// The dual: a vertex per site and per run of the boundary, a polygon per Voronoi point.
#include "gvd/dual.h"

#include <algorithm>

#include "diagram/given_diagram.h"
#include "gvd/partition.h"
#include "mesh/corners.h"
#include "partition/dual_building.h"

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

DualBuilding::DualBuilding(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                           const RegionComplex& complex)
    : mesh_(mesh),
      sites_(sites),
      complex_(complex),
      vertexOfLabel_(sites.size(), -1),
      vertexOfRun_(complex.borders.size(), -1) {}

bool DualBuilding::step(long& budget) {
  return sequence_.run(forEach(sites_, budget, 4, [&](int l) { addSite(l); }),
                       forEach(complex_.borders, budget, 8, [&](int b) { addRun(b); }),
                       forEach(complex_.vertices, budget, 4, [&](int v) { addPolygon(v); }));
}

void DualBuilding::addSite(int label) {
  if (sites_[label].face < 0) return;
  vertexOfLabel_[label] = addVertex(mesh_, sites_[label], out_);
  out_.vertexLabel.push_back(label);
}

void DualBuilding::addRun(int b) {
  const RegionComplex::Border& border = complex_.borders[b];
  if (!isRun(border)) return;
  vertexOfRun_[b] = addVertex(mesh_, pointOfRun(mesh_, complex_.partition, border), out_);
  out_.vertexLabel.push_back(border.label);
}

void DualBuilding::addPolygon(int v) {
  const RegionComplex::Vertex& vertex = complex_.vertices[v];
  std::vector<int> polygon = complex_.labelsAt(v);
  for (int& corner : polygon) corner = vertexOfLabel_[corner];
  if (vertex.isOnBoundary()) {
    polygon.insert(polygon.begin(), vertexOfRun_[vertex.borders.front()]);
    polygon.push_back(vertexOfRun_[vertex.arrivingRun]);
  }
  out_.faces.add(polygon);
}

namespace {

/// Builds the mesh of the regions themselves, in slices.
class RegionMeshBuilding {
 public:
  RegionMeshBuilding(const TriangleMesh& mesh, const RegionComplex& complex)
      : mesh_(mesh), complex_(complex) {}

  bool step(long& budget) {
    return sequence_.run(forItems(complex_.vertices, budget, 4,
                                  [&](const RegionComplex::Vertex& vertex) {
                                    addVertex(mesh_, complex_.partition.points[vertex.point], out_);
                                  }),
                         forItems(complex_.loops, budget, 1,
                                  [&](const RegionComplex::Loop& loop) { addPolygon(loop); }));
  }
  PolygonMesh take() { return std::move(out_); }

 private:
  void addPolygon(const RegionComplex::Loop& loop) {
    std::vector<int> polygon;
    for (int b = loop.firstBorder; b < loop.firstBorder + loop.borderCount; ++b) {
      const RegionComplex::Border& border = complex_.borders[b];
      if (border.fromVertex >= 0) polygon.push_back(border.fromVertex);
      if (isRun(border))
        polygon.push_back(addVertex(mesh_, pointOfRun(mesh_, complex_.partition, border), out_));
    }
    if (polygon.empty()) return;
    out_.faces.add(polygon);
    out_.faceLabel.push_back(loop.label);
  }

  const TriangleMesh& mesh_;
  const RegionComplex& complex_;
  SlicedSequence sequence_;
  PolygonMesh out_;
};

}  // namespace

std::unique_ptr<SlicedWork<PolygonMesh>> startDualMesh(const TriangleMesh& mesh,
                                                       std::span<const SurfacePoint> sites,
                                                       const Diagram& diagram) {
  return fromRegions(mesh, diagram,
                     [&mesh, sites = sitesOf(mesh, diagram, sites)](const RegionComplex& complex) {
                       return DualBuilding(mesh, sites, complex);
                     });
}

PolygonMesh dualMesh(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                     const Diagram& diagram) {
  return finished(startDualMesh(mesh, sites, diagram));
}

std::unique_ptr<SlicedWork<PolygonMesh>> startRegionMesh(const TriangleMesh& mesh,
                                                         const Diagram& diagram) {
  return fromRegions(mesh, diagram, [&mesh](const RegionComplex& complex) {
    return RegionMeshBuilding(mesh, complex);
  });
}

PolygonMesh regionMesh(const TriangleMesh& mesh, const Diagram& diagram) {
  return finished(startRegionMesh(mesh, diagram));
}

}  // namespace gvd
