// SPDX-License-Identifier: MIT
#include "objects.h"

#include <string>
#include <utility>

#include "gvd/error.h"

namespace gvd::abi {
namespace {

constexpr Named<Metric> kMetrics[] = {{"exact", Metric::kExact}, {"dgpc", Metric::kDgpc}};

/// Labels are less than this: those at the end that are free do not count.
int labelCount(const DynamicDiagram& diagram) {
  int count = diagram.labelCount();
  while (count > 0 && !diagram.hasSite(count - 1)) --count;
  return count;
}

}  // namespace

Metric metricOf(std::string_view name) { return valueOf(kMetrics, "metric", name); }

Diagram VoronoiHandle::diagram() const {
  if (!dynamic) return *traced;
  Diagram diagram = dynamic->diagram();
  diagram.siteCount = labelCount(*dynamic);
  diagram.regionArea.resize(diagram.siteCount);
  return diagram;
}

Surface VoronoiHandle::snapshot() const {
  return {surface.mesh, dynamic ? std::make_shared<const Diagram>(diagram()) : traced};
}

std::vector<SurfacePoint> VoronoiHandle::allSites() const {
  if (!dynamic) return sites;
  std::vector<SurfacePoint> all;
  for (int label = 0; label < labelCount(*dynamic); ++label) {
    if (!dynamic->hasSite(label))
      throw Error(ErrorCode::kInvalidArgument,
                  "site " + std::to_string(label) +
                      " has been removed: compute a diagram of the sites that are left");
    all.push_back(dynamic->site(label));
  }
  return all;
}

DynamicDiagram& VoronoiHandle::changing() {
  if (!dynamic) {
    dynamic = std::make_unique<DynamicDiagram>(
        distances ? DynamicDiagram::fromDistances(mesh(), std::move(distances), options)
                  : DynamicDiagram(mesh(), sites, metric, options));
    sharedDistances.reset();
    traced.reset();
  }
  return *dynamic;
}

std::vector<SurfacePoint> pointsFromInput(const TriangleMesh& mesh, const char* what, Ints face,
                                          Doubles bary) {
  std::vector<SurfacePoint> points;
  points.reserve(face.size);
  for (std::size_t i = 0; i < face.size; ++i) {
    const double* b = bary.data + 3 * i;
    points.push_back(naming(what, i, [&] {
      return mesh.fromInput({face.data[i], {b[0], b[1], b[2]}});
    }));
  }
  return points;
}

SurfacePoint pointFromInput(const TriangleMesh& mesh, Ints face, Doubles bary) {
  return mesh.fromInput({face.data[0], {bary.data[0], bary.data[1], bary.data[2]}});
}

std::vector<double> valuesFromInput(const TriangleMesh& mesh, const char* what,
                                    std::span<const double> values) {
  if (values.empty()) return {};
  if (values.size() != static_cast<std::size_t>(mesh.inputVertexCount()))
    throw Error(ErrorCode::kInvalidArgument,
                "there are " + std::to_string(values.size()) + " " + what + " for " +
                    std::to_string(mesh.inputVertexCount()) + " input vertices");
  std::vector<double> result(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v) result[v] = values[mesh.inputVertex(v)];
  return result;
}

int vertexOfInput(const TriangleMesh& mesh, int inputVertex) {
  try {
    const SurfacePoint place = mesh.fromInputVertex(inputVertex);
    for (int i = 0; i < 3; ++i)
      if (place.bary[i] == 1) return mesh.tail(3 * place.face + i);
  } catch (const Error&) {
  }
  return -1;
}

std::vector<double> valuesAtInput(const TriangleMesh& mesh, std::span<const double> values,
                                  double otherwise) {
  std::vector<double> result(mesh.inputVertexCount(), otherwise);
  for (int i = 0; i < mesh.inputVertexCount(); ++i)
    if (const int vertex = vertexOfInput(mesh, i); vertex >= 0) result[i] = values[vertex];
  return result;
}

}  // namespace gvd::abi
