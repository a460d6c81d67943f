// SPDX-License-Identifier: MIT
//
// core.wasm: surfaces, sites and diagrams for JavaScript. Faces, vertices and points are the
// input's on this side of the border, and a `TriangleMesh`'s behind it; the conversion happens here
// and nowhere else. `src/core.ts` reads every result in the order in which it is written here.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "abi.h"
#include "gvd/cvt.h"
#include "gvd/diagram.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/error.h"
#include "gvd/geodesic.h"
#include "gvd/sampling.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::abi {
namespace {

/// `faceLabel` of an input triangle that the mesh builder dropped.
constexpr int kDropped = -3;

/// A mesh that diagrams may outlive the caller's handle of.
struct MeshHandle {
  std::shared_ptr<const TriangleMesh> mesh;
};

/// A diagram, from the first slice of its propagation to the last point located in it. Its address
/// is that of a `MeshHandle` as well.
struct VoronoiHandle {
  MeshHandle surface;
  std::vector<SurfacePoint> sites;
  Metric metric;
  DiagramOptions options;
  std::unique_ptr<Propagation> propagation;  // until it is done
  std::unique_ptr<DistanceField> distances;  // from then on
  std::unique_ptr<DynamicDiagram> dynamic;   // instead, once sites have changed

  const DistanceField& field() const { return dynamic ? dynamic->distances() : *distances; }
};
static_assert(std::is_standard_layout_v<VoronoiHandle>);

/// A centroidal tessellation under way. Its address is that of a `MeshHandle` as well.
struct CvtHandle {
  MeshHandle surface;
  std::unique_ptr<Cvt> cvt;
};
static_assert(std::is_standard_layout_v<CvtHandle>);

/// In the order of `samplings` in `src/core.ts`.
enum Sampling { kRandom, kFarthest, kPoisson };

/// Calls `f`; its error, if any, is said to be about `what` number `index`.
template <class F>
auto naming(const char* what, int index, F&& f) -> decltype(f()) {
  try {
    return f();
  } catch (const Error& error) {
    throw Error(error.code(),
                std::string(what) + " " + std::to_string(index) + ": " + error.what());
  }
}

SurfacePoint pointFromInput(const TriangleMesh& mesh, const char* what, int i, const int* face,
                            const double* bary) {
  return naming(what, i, [&] {
    return mesh.fromInput({face[i], {bary[3 * i], bary[3 * i + 1], bary[3 * i + 2]}});
  });
}

std::vector<SurfacePoint> sitesFromInput(const TriangleMesh& mesh, const int* face,
                                         const double* bary, std::size_t count) {
  std::vector<SurfacePoint> sites;
  sites.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    sites.push_back(pointFromInput(mesh, "site", static_cast<int>(i), face, bary));
  return sites;
}

/// Values given per input vertex, per vertex of the mesh; none stay none.
std::vector<double> valuesFromInput(const TriangleMesh& mesh, std::span<const double> values) {
  if (values.empty()) return {};
  if (values.size() != static_cast<std::size_t>(mesh.inputVertexCount()))
    throw Error(ErrorCode::kInvalidArgument,
                "there are " + std::to_string(values.size()) + " densities for " +
                    std::to_string(mesh.inputVertexCount()) + " input vertices");
  std::vector<double> result(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v) result[v] = values[mesh.inputVertex(v)];
  return result;
}

std::vector<SurfacePoint> sample(const TriangleMesh& mesh, int count, Sampling sampling,
                                 std::uint64_t seed) {
  switch (sampling) {
    case kFarthest:
      return sampleFarthest(mesh, count, seed);
    case kPoisson:
      return samplePoissonDiskCount(mesh, count, seed).points;
    default:
      return sampleUniform(mesh, count, seed);
  }
}

/// Two arrays, face and bary, of points of the mesh in terms of the input.
void addPoints(Arrays& out, const TriangleMesh& mesh, std::span<const SurfacePoint> points) {
  std::vector<int> face;
  std::vector<double> bary;
  face.reserve(points.size());
  bary.reserve(3 * points.size());
  for (const SurfacePoint& p : points) {
    const SurfacePoint input = mesh.toInput(p);
    face.push_back(input.face);
    bary.insert(bary.end(), input.bary.begin(), input.bary.end());
  }
  out.add(std::move(face));
  out.add(std::move(bary));
}

std::vector<double> positionsOf(const TriangleMesh& mesh, std::span<const SurfacePoint> points) {
  std::vector<double> positions;
  positions.reserve(3 * points.size());
  for (const SurfacePoint& p : points) {
    const Eigen::Vector3d position = mesh.position(p);
    positions.insert(positions.end(), position.begin(), position.end());
  }
  return positions;
}

void addLists(Arrays& out, PointLists&& lists) {
  out.add(std::move(lists.offset));
  out.add(std::move(lists.points));
}

std::vector<int> inputFaces(const TriangleMesh& mesh, std::vector<int> faces) {
  for (int& face : faces) face = mesh.inputFace(face);
  return faces;
}

std::vector<int> flat(std::span<const std::array<int, 2>> pairs) {
  std::vector<int> values;
  values.reserve(2 * pairs.size());
  for (const auto& pair : pairs) values.insert(values.end(), pair.begin(), pair.end());
  return values;
}

void addSegments(Arrays& out, const TriangleMesh& mesh,
                 std::span<const Diagram::Segment> segments) {
  std::vector<int> points, labels, face, arc;
  points.reserve(2 * segments.size());
  labels.reserve(2 * segments.size());
  face.reserve(segments.size());
  arc.reserve(segments.size());
  for (const Diagram::Segment& segment : segments) {
    points.insert(points.end(), segment.points.begin(), segment.points.end());
    labels.insert(labels.end(), segment.labels.begin(), segment.labels.end());
    face.push_back(mesh.inputFace(segment.face));
    arc.push_back(segment.arc);
  }
  out.add(std::move(points));
  out.add(std::move(labels));
  out.add(std::move(face));
  out.add(std::move(arc));
}

void addVoronoiPoints(Arrays& out, std::span<const Diagram::VoronoiPoint> voronoiPoints) {
  std::vector<int> point, labelOffset = {0}, labels;
  for (const Diagram::VoronoiPoint& v : voronoiPoints) {
    point.push_back(v.point);
    labels.insert(labels.end(), v.labels.begin(), v.labels.end());
    labelOffset.push_back(static_cast<int>(labels.size()));
  }
  out.add(std::move(point));
  out.add(std::move(labelOffset));
  out.add(std::move(labels));
}

std::vector<int> inputFaceLabels(const TriangleMesh& mesh, std::span<const int> faceLabel) {
  std::vector<int> labels(mesh.inputFaceCount(), kDropped);
  for (int f = 0; f < mesh.faceCount(); ++f) labels[mesh.inputFace(f)] = faceLabel[f];
  return labels;
}

void addDiagram(Arrays& out, const TriangleMesh& mesh, Diagram diagram) {
  addPoints(out, mesh, diagram.points);
  out.add(positionsOf(mesh, diagram.points));
  addSegments(out, mesh, diagram.segments);
  addLists(out, std::move(diagram.arcs));
  out.add(flat(diagram.arcLabels));
  addVoronoiPoints(out, diagram.voronoiPoints);
  addLists(out, std::move(diagram.loops));
  out.add(std::move(diagram.loopLabel));
  out.add(std::move(diagram.regionArea));
  out.add(std::move(diagram.faceLabel));
  out.add(inputFaces(mesh, std::move(diagram.indifferentFaces)));
  addLists(out, std::move(diagram.cells));
  out.add(inputFaces(mesh, std::move(diagram.cellFace)));
  out.add(std::move(diagram.cellLabel));
}

std::unique_ptr<Arrays> flatten(const TriangleMesh& mesh, Diagram diagram) {
  auto out = std::make_unique<Arrays>();
  diagram.faceLabel = inputFaceLabels(mesh, diagram.faceLabel);
  addDiagram(*out, mesh, std::move(diagram));
  return out;
}

/// The diagram of which sites can change; made when the first one does.
DynamicDiagram& dynamicOf(VoronoiHandle& voronoi) {
  if (voronoi.metric != Metric::kDgpc)
    throw Error(ErrorCode::kInvalidArgument,
                "sites can be changed with the metric dgpc only; compute another diagram");
  if (!voronoi.dynamic) {
    voronoi.dynamic =
        std::make_unique<DynamicDiagram>(*voronoi.surface.mesh, voronoi.sites, voronoi.options);
    voronoi.distances.reset();
  }
  return *voronoi.dynamic;
}

/// The label of the site, labels, faces, and the part (see `addDiagram`).
std::unique_ptr<Arrays> flatten(const TriangleMesh& mesh, int label, DiagramChange change) {
  auto out = std::make_unique<Arrays>();
  out->add(std::vector<int>{label});
  out->add(std::move(change.labels));
  out->add(inputFaces(mesh, std::move(change.faces)));
  addDiagram(*out, mesh, std::move(change.part));
  return out;
}

}  // namespace

GVD_ABI const char* version() { return GVD_VERSION; }

GVD_ABI MeshHandle* createMesh(const double* positions, std::size_t positionCount,
                               const int* triangles, std::size_t triangleIndexCount) {
  return guarded([&] {
    return new MeshHandle{std::make_shared<const TriangleMesh>(
        std::span(positions, positionCount), std::span(triangles, triangleIndexCount))};
  });
}

GVD_ABI void freeMesh(MeshHandle* handle) { delete handle; }

/// Counts (as `infoCounts` and `repairCounts` in `src/core.ts` name them), then area and diameter.
GVD_ABI Arrays* meshInfo(const MeshHandle* handle) {
  return guarded([&] {
    const TriangleMesh& mesh = *handle->mesh;
    const MeshTopology& topology = mesh.topology();
    const MeshRepairs& repairs = mesh.repairs();
    auto out = std::make_unique<Arrays>();
    out->add(std::vector<int>{mesh.vertexCount(), mesh.faceCount(), topology.edges,
                              mesh.inputVertexCount(), mesh.inputFaceCount(), topology.components,
                              topology.boundaryLoops, topology.eulerCharacteristic,
                              topology.genus});
    out->add(std::vector<int>{
        repairs.weldedVertices, repairs.isolatedVertices, repairs.nonFiniteTriangles,
        repairs.degenerateTriangles, repairs.duplicateTriangles, repairs.nonManifoldEdges,
        repairs.orientationCuts, repairs.flippedTriangles, repairs.splitVertices});
    out->add(std::vector<double>{mesh.area(), mesh.diameter()});
    return out.release();
  });
}

/// face, bary of input vertices; of a mesh or a diagram.
GVD_ABI Arrays* pointsAtVertices(const MeshHandle* handle, const int* vertex, std::size_t count) {
  return guarded([&] {
    std::vector<SurfacePoint> points;
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      points.push_back(naming("point", static_cast<int>(i),
                              [&] { return handle->mesh->fromInputVertex(vertex[i]); }));
    }
    auto out = std::make_unique<Arrays>();
    addPoints(*out, *handle->mesh, points);
    return out.release();
  });
}

/// face, bary. `sampling` is a `Sampling`, `seed` an integer below 2^53.
GVD_ABI Arrays* sampleSites(const MeshHandle* handle, int count, int sampling, double seed) {
  return guarded([&] {
    auto out = std::make_unique<Arrays>();
    addPoints(*out, *handle->mesh,
              sample(*handle->mesh, count, static_cast<Sampling>(sampling),
                     static_cast<std::uint64_t>(seed)));
    return out.release();
  });
}

GVD_ABI VoronoiHandle* startVoronoi(const MeshHandle* handle, const int* face, const double* bary,
                                    std::size_t count, int metric) {
  return guarded([&] {
    const TriangleMesh& mesh = *handle->mesh;
    auto voronoi = std::make_unique<VoronoiHandle>();
    voronoi->surface = *handle;
    voronoi->sites = sitesFromInput(mesh, face, bary, count);
    voronoi->metric = static_cast<Metric>(metric);
    voronoi->propagation = propagate(mesh, voronoi->sites, voronoi->metric);
    return voronoi.release();
  });
}

/// How a slice of work ended; zero when it failed, as with every function here.
enum SliceEnd { kFailed = 0, kMoreToDo = 1, kDone = 2 };

GVD_ABI SliceEnd stepVoronoi(VoronoiHandle* voronoi, int budget) {
  return guarded([&] {
    if (!voronoi->propagation->step(budget)) return kMoreToDo;
    voronoi->distances = voronoi->propagation->take();
    voronoi->propagation.reset();
    return kDone;
  });
}

GVD_ABI double voronoiProgress(const VoronoiHandle* voronoi) {
  return voronoi->propagation ? voronoi->propagation->progress() : 1;
}

/// The diagram, see `flatten`. Only after `stepVoronoi` said it is done.
GVD_ABI Arrays* traceVoronoi(VoronoiHandle* voronoi, int detail) {
  return guarded([&] {
    const TriangleMesh& mesh = *voronoi->surface.mesh;
    voronoi->options = {.detail = detail};
    return flatten(mesh, traceDiagram(mesh, *voronoi->distances,
                                      static_cast<int>(voronoi->sites.size()), voronoi->options))
        .release();
  });
}

/// Inserts a site, see `flatten`. These three only after `traceVoronoi`.
GVD_ABI Arrays* insertSite(VoronoiHandle* voronoi, int face, double b0, double b1, double b2) {
  return guarded([&] {
    const TriangleMesh& mesh = *voronoi->surface.mesh;
    const SurfacePoint site = mesh.fromInput({face, {b0, b1, b2}});
    DynamicDiagram& dynamic = dynamicOf(*voronoi);
    const int label = dynamic.lowestFreeLabel();
    return flatten(mesh, label, dynamic.insertSite(site)).release();
  });
}

GVD_ABI Arrays* moveSite(VoronoiHandle* voronoi, int label, int face, double b0, double b1,
                         double b2) {
  return guarded([&] {
    const TriangleMesh& mesh = *voronoi->surface.mesh;
    const SurfacePoint site = mesh.fromInput({face, {b0, b1, b2}});
    return flatten(mesh, label, dynamicOf(*voronoi).moveSite(label, site)).release();
  });
}

GVD_ABI Arrays* removeSite(VoronoiHandle* voronoi, int label) {
  return guarded([&] {
    return flatten(*voronoi->surface.mesh, label, dynamicOf(*voronoi).removeSite(label)).release();
  });
}

/// label, distance per point. Only after `stepVoronoi` said it is done.
GVD_ABI Arrays* locate(const VoronoiHandle* voronoi, const int* face, const double* bary,
                       std::size_t count) {
  return guarded([&] {
    std::vector<int> label;
    std::vector<double> distance;
    label.reserve(count);
    distance.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const LabelledDistance nearest = voronoi->field().nearest(
          pointFromInput(*voronoi->surface.mesh, "point", static_cast<int>(i), face, bary));
      label.push_back(nearest.label);
      distance.push_back(nearest.distance);
    }
    auto out = std::make_unique<Arrays>();
    out->add(std::move(label));
    out->add(std::move(distance));
    return out.release();
  });
}

GVD_ABI void freeVoronoi(VoronoiHandle* voronoi) { delete voronoi; }

/// `method` is a `CvtMethod`; `density` is one value per input vertex, or none.
GVD_ABI CvtHandle* startCvt(const MeshHandle* handle, const int* face, const double* bary,
                            std::size_t count, int method, int iterations, double energyTolerance,
                            double moveTolerance, const double* density, std::size_t densityCount,
                            const int* fixed, std::size_t fixedCount) {
  return guarded([&] {
    const TriangleMesh& mesh = *handle->mesh;
    CvtOptions options;
    options.method = static_cast<CvtMethod>(method);
    options.iterations = iterations;
    options.energyTolerance = energyTolerance;
    options.moveTolerance = moveTolerance;
    options.density = valuesFromInput(mesh, {density, densityCount});
    options.fixedSites.assign(fixed, fixed + fixedCount);
    const std::vector<SurfacePoint> sites = sitesFromInput(mesh, face, bary, count);
    auto cvt = std::make_unique<CvtHandle>();
    cvt->surface = *handle;
    cvt->cvt = std::make_unique<Cvt>(mesh, sites, std::move(options));
    return cvt.release();
  });
}

/// Done: with an iteration, not with all.
GVD_ABI SliceEnd stepCvt(CvtHandle* cvt, int budget) {
  return guarded([&] { return cvt->cvt->step(budget) ? kDone : kMoreToDo; });
}

/// The last iteration: number and whether it was the last, energy and largest move, face, bary of
/// the sites. Only after `stepCvt` said it is done.
GVD_ABI Arrays* cvtIteration(const CvtHandle* cvt) {
  return guarded([&] {
    const CvtIteration& iteration = cvt->cvt->iteration();
    auto out = std::make_unique<Arrays>();
    out->add(std::vector<int>{iteration.number, cvt->cvt->isDone()});
    out->add(std::vector<double>{iteration.energy, iteration.largestMove});
    addPoints(*out, *cvt->surface.mesh, cvt->cvt->sites());
    return out.release();
  });
}

/// The diagram of the last iteration, see `flatten`.
GVD_ABI Arrays* cvtDiagram(const CvtHandle* cvt) {
  return guarded([&] { return flatten(*cvt->surface.mesh, cvt->cvt->diagram()).release(); });
}

GVD_ABI void freeCvt(CvtHandle* cvt) { delete cvt; }

}  // namespace gvd::abi
