// SPDX-License-Identifier: MIT
//
// Meshes, diagrams and points as JavaScript names them, looked up.
#include "objects.h"

#include <string>
#include <utility>

#include "gvd/error.h"

namespace gvd::abi {
namespace {

constexpr Named<Metric> kMetrics[] = {{"exact", Metric::kExact}, {"dgpc", Metric::kDgpc}};
constexpr Named<WorstRegion> kWorstRegions[] = {{"size", WorstRegion::kSize},
                                                {"distortion", WorstRegion::kDistortion}};

}  // namespace

bool PointLookup::advance(long budget) {
  constexpr long kUnitsPerLookUp = 16;
  if (!prepare(budget)) return false;
  for (; next_ < count_; budget -= kUnitsPerLookUp) {
    if (budget <= 0) return false;
    lookUp(next_++, budget);
  }
  return true;
}

Metric metricOf(Text name) { return valueOf(kMetrics, "metric", name); }

WorstRegion worstRegionOf(Text name) { return valueOf(kWorstRegions, "worst", name); }

bool DiagramWork::advance(long budget) {
  if (!work_) {
    if (!join(budget)) return false;
    work_ = start_({voronoi_.surface.mesh, voronoi_.traced});
  }
  return work_->step(budget);
}

/// True when the handle has the diagram of the present sites.
bool DiagramWork::join(long budget) {
  if (voronoi_.traced) return true;
  if (!joining_) joining_ = voronoi_.dynamic->startDiagram();
  if (!joining_->step(budget)) return false;
  Diagram diagram = joining_->take();
  diagram.siteCount = static_cast<int>(voronoi_.sitesByLabel().size());
  diagram.regionArea.resize(diagram.siteCount);
  voronoi_.traced = std::make_shared<const Diagram>(std::move(diagram));
  return true;
}

std::vector<SurfacePoint> DiagramHandle::sitesByLabel() const {
  if (!dynamic) return sites;
  std::vector<SurfacePoint> all = dynamic->sites();
  while (!all.empty() && all.back().face < 0) all.pop_back();
  return all;
}

std::unique_ptr<SlicedWork<DynamicDiagram>> DiagramHandle::startDynamic() const {
  return distances ? DynamicDiagram::startFromDistances(mesh(), distances, options)
                   : DynamicDiagram::start(mesh(), sites, metric, options);
}

/// Only now the former state is given up, because making the new one may have thrown.
void DiagramHandle::takeDynamic(DynamicDiagram made) {
  dynamic = std::make_unique<DynamicDiagram>(std::move(made));
  worstRegions.reset();  // of the former distances
  distances.reset();
  sharedDistances.reset();
}

std::vector<SurfacePoint> sitesFromInput(const TriangleMesh& mesh, Ints face, Doubles bary) {
  std::vector<SurfacePoint> sites;
  sites.reserve(face.size);
  for (std::size_t i = 0; i < face.size; ++i) {
    const double* b = bary.data + 3 * i;
    const bool isFree = face.data[i] == -1 && b[0] == 0 && b[1] == 0 && b[2] == 0;
    sites.push_back(naming("site", i, [&] {
      return isFree ? SurfacePoint() : pointFromInput(mesh, face.data[i], b);
    }));
  }
  return sites;
}

SurfacePoint pointFromInput(const TriangleMesh& mesh, int face, const double* bary) {
  return mesh.fromInput({face, {bary[0], bary[1], bary[2]}});
}

SurfacePoint pointFromInput(const TriangleMesh& mesh, Ints face, Doubles bary) {
  return pointFromInput(mesh, face.data[0], bary.data);
}

std::vector<double> densityFromInput(const TriangleMesh& mesh, Doubles density) {
  if (density.size == 0) return {};
  if (density.size != static_cast<std::size_t>(mesh.inputVertexCount()))
    throw Error(ErrorCode::kInvalidArgument,
                "the number of densities is " + std::to_string(density.size) +
                    ", not that of input vertices, " + std::to_string(mesh.inputVertexCount()));
  std::vector<double> result(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v) result[v] = density.data[mesh.inputVertex(v)];
  return result;
}

std::vector<double> valuesAtInput(const TriangleMesh& mesh, std::span<const double> values,
                                  double otherwise) {
  std::vector<double> result(mesh.inputVertexCount(), otherwise);
  for (int i = 0; i < mesh.inputVertexCount(); ++i)
    if (const int vertex = mesh.vertexOfInput(i); vertex >= 0) result[i] = values[vertex];
  return result;
}

}  // namespace gvd::abi
