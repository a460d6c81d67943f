// SPDX-License-Identifier: MIT
//
// core.wasm: surfaces, sites and diagrams for JavaScript. Faces, vertices and points are the
// input's on this side of the border, and a `TriangleMesh`'s behind it; the conversion happens here
// and nowhere else. `src/core.ts` reads every result in the order in which it is written here.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "abi.h"
#include "gvd/cvt.h"
#include "gvd/diagram.h"
#include "gvd/dual.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/error.h"
#include "gvd/geodesic.h"
#include "gvd/partition.h"
#include "gvd/remesh.h"
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
  std::unique_ptr<Propagation> propagation;        // until it is done
  std::shared_ptr<const DistanceField> distances;  // from then on
  std::optional<DiagramTracing> tracing;           // while it goes on
  std::optional<Diagram> diagram;                  // once it is traced
  std::unique_ptr<DynamicDiagram> dynamic;         // instead, once sites have changed

  const DistanceField& field() const { return dynamic ? dynamic->distances() : *distances; }
};
static_assert(std::is_standard_layout_v<VoronoiHandle>);

/// A centroidal tessellation under way. Its address is that of a `MeshHandle` as well.
struct CvtHandle {
  MeshHandle surface;
  Metric metric;
  std::unique_ptr<Cvt> cvt;
};
static_assert(std::is_standard_layout_v<CvtHandle>);

/// In the order of `metrics` in `src/core.ts`.
constexpr std::array kMetrics = {Metric::kExact, Metric::kDgpc};
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

/// The vertex at the place of an input vertex, -1 if that is isolated.
int vertexOfInput(const TriangleMesh& mesh, int inputVertex) {
  try {
    const SurfacePoint place = mesh.fromInputVertex(inputVertex);
    for (int i = 0; i < 3; ++i)
      if (place.bary[i] == 1) return mesh.tail(3 * place.face + i);
  } catch (const Error&) {
  }
  return -1;
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
  if (!voronoi.dynamic) {
    voronoi.dynamic = std::make_unique<DynamicDiagram>(*voronoi.surface.mesh, voronoi.sites,
                                                       voronoi.metric, voronoi.options);
    voronoi.distances.reset();
    voronoi.diagram.reset();
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

template <class T>
std::vector<T> flat(std::span<const std::array<T, 3>> triples) {
  std::vector<T> values;
  values.reserve(3 * triples.size());
  for (const auto& triple : triples) values.insert(values.end(), triple.begin(), triple.end());
  return values;
}

std::vector<double> flat(std::span<const Eigen::Vector3d> positions) {
  std::vector<double> values;
  values.reserve(3 * positions.size());
  for (const Eigen::Vector3d& p : positions) values.insert(values.end(), p.begin(), p.end());
  return values;
}

/// Corners, labels, input faces, and the corners in terms of these.
void addTriangles(Arrays& out, const TriangleMesh& mesh, const Partition& partition) {
  std::vector<double> bary;
  bary.reserve(9 * partition.triangles.size());
  for (int t = 0; t < static_cast<int>(partition.triangles.size()); ++t) {
    const Eigen::Matrix3d corners = cornersInFace(mesh, partition, t);
    for (int i = 0; i < 3; ++i) {
      const SurfacePoint corner = mesh.toInput({partition.triangleFace[t], corners.col(i)});
      bary.insert(bary.end(), corner.bary.begin(), corner.bary.end());
    }
  }
  out.add(flat<int>(partition.triangles));
  out.add(std::vector(partition.triangleLabel));
  out.add(inputFaces(mesh, partition.triangleFace));
  out.add(std::move(bary));
}

/// What is told of each region: a list per fact.
void addRegions(Arrays& out, const TriangleMesh& mesh, const Partition& partition) {
  std::vector<int> triangleOffset = {0}, nearFace, components, loops, euler, genus, touchings;
  std::vector<double> area, perimeter, boundaryLength, nearBary, neighbourLength;
  std::vector<Eigen::Vector3d> centroid;
  std::vector<int> neighbourOffset = {0}, neighbours;
  for (const RegionPatch& region : partition.regions) {
    triangleOffset.push_back(triangleOffset.back() + region.triangleCount);
    area.push_back(region.area);
    perimeter.push_back(region.perimeter);
    boundaryLength.push_back(region.boundaryLength);
    centroid.push_back(region.centroid);
    const SurfacePoint near =
        region.triangleCount > 0 ? mesh.toInput(region.nearCentroid) : SurfacePoint();
    nearFace.push_back(near.face);
    nearBary.insert(nearBary.end(), near.bary.begin(), near.bary.end());
    components.push_back(region.components);
    loops.push_back(region.loops);
    euler.push_back(region.eulerCharacteristic);
    genus.push_back(region.genus);
    touchings.push_back(region.selfTouchings);
    for (const auto& neighbour : region.neighbours) {
      neighbours.push_back(neighbour.label);
      neighbourLength.push_back(neighbour.length);
    }
    neighbourOffset.push_back(static_cast<int>(neighbours.size()));
  }
  out.add(std::move(triangleOffset));
  for (auto* values : {&area, &perimeter, &boundaryLength}) out.add(std::move(*values));
  out.add(flat(centroid));
  out.add(std::move(nearFace));
  out.add(std::move(nearBary));
  for (auto* values :
       {&components, &loops, &euler, &genus, &touchings, &neighbourOffset, &neighbours})
    out.add(std::move(*values));
  out.add(std::move(neighbourLength));
}

std::unique_ptr<Arrays> flatten(const TriangleMesh& mesh, const Partition& partition) {
  auto out = std::make_unique<Arrays>();
  addPoints(*out, mesh, partition.points);
  out->add(flat(partition.positions));
  addTriangles(*out, mesh, partition);
  addRegions(*out, mesh, partition);
  return out;
}

std::unique_ptr<Arrays> flatten(const TriangleMesh& mesh, PolygonMesh polygons) {
  auto out = std::make_unique<Arrays>();
  addPoints(*out, mesh, polygons.points);
  out->add(flat(polygons.positions));
  PolygonTriangles cut = triangulate(polygons);
  const PolygonTopology t = topologyOf(polygons);
  addLists(*out, std::move(polygons.faces));
  out->add(std::move(polygons.vertexLabel));
  out->add(std::move(polygons.faceLabel));
  out->add(flat<int>(cut.triangles));
  out->add(std::move(cut.face));
  out->add(std::vector<int>{t.isManifold, t.vertices, t.edges, t.faces, t.components,
                            t.boundaryLoops, t.eulerCharacteristic, t.genus});
  return out;
}

/// Labels are less than this: those at the end that are free do not count.
int labelCount(const DynamicDiagram& diagram) {
  int count = diagram.labelCount();
  while (count > 0 && !diagram.hasSite(count - 1)) --count;
  return count;
}

/// The diagram of the sites there are.
Diagram diagramOf(const VoronoiHandle& voronoi) {
  if (!voronoi.dynamic) return *voronoi.diagram;
  Diagram diagram = voronoi.dynamic->diagram();
  diagram.siteCount = labelCount(*voronoi.dynamic);
  diagram.regionArea.resize(diagram.siteCount);
  return diagram;
}

/// The sites by label; every label has one, or there is no dual.
std::vector<SurfacePoint> sitesOf(const VoronoiHandle& voronoi) {
  if (!voronoi.dynamic) return voronoi.sites;
  std::vector<SurfacePoint> sites;
  for (int label = 0; label < labelCount(*voronoi.dynamic); ++label) {
    if (!voronoi.dynamic->hasSite(label))
      throw Error(ErrorCode::kInvalidArgument,
                  "site " + std::to_string(label) +
                      " has been removed: compute a diagram of the sites that are left");
    sites.push_back(voronoi.dynamic->site(label));
  }
  return sites;
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

/// Counts (as `infoCounts` and `repairCounts` in `src/core.ts` name them), then area, bounding
/// diagonal and mollification.
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
    out->add(std::vector<int>{repairs.weldedVertices, repairs.isolatedVertices,
                              repairs.nonFiniteTriangles, repairs.degenerateTriangles,
                              repairs.duplicateTriangles, repairs.nonManifoldEdges,
                              repairs.orientationCuts, repairs.flippedTriangles,
                              repairs.splitVertices, repairs.mollifiedTriangles});
    out->add(std::vector<double>{mesh.area(), mesh.boundingDiagonal(), repairs.mollification});
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
    voronoi->metric = kMetrics.at(metric);
    voronoi->propagation = propagate(mesh, voronoi->sites, voronoi->metric);
    return voronoi.release();
  });
}

/// How a slice of work ended; zero when it failed, as with every function here.
enum SliceEnd { kFailed = 0, kMoreToDo = 1, kDone = 2 };

/// Works on the distances.
GVD_ABI SliceEnd stepDistances(VoronoiHandle* voronoi, int budget) {
  return guarded([&] {
    if (!voronoi->propagation->step(budget)) return kMoreToDo;
    voronoi->distances = voronoi->propagation->take();
    voronoi->propagation.reset();
    return kDone;
  });
}

/// Of the distances.
GVD_ABI double voronoiProgress(const VoronoiHandle* voronoi) {
  return voronoi->propagation ? voronoi->propagation->progress() : 1;
}

/// label, distance, direction per input vertex. This and what follows only after `stepDistances`
/// said it is done.
GVD_ABI Arrays* distancesAtVertices(const VoronoiHandle* voronoi) {
  return guarded([&] {
    const TriangleMesh& mesh = *voronoi->surface.mesh;
    const DistanceField& field = voronoi->field();
    const int count = mesh.inputVertexCount();
    std::vector<int> label(count, -1);
    std::vector<double> distance(count, kInfinity);
    std::vector<double> direction(2 * count, std::numeric_limits<double>::quiet_NaN());
    for (int i = 0; i < count; ++i) {
      const int vertex = vertexOfInput(mesh, i);
      if (vertex < 0) continue;
      const LabelledDistance nearest = nearestOf(field.at(vertex));
      if (nearest.label < 0) continue;
      label[i] = nearest.label;
      distance[i] = nearest.distance;
      const Eigen::Vector2d towards = field.direction(nearest.label, vertex);
      direction[2 * i] = towards.x();
      direction[2 * i + 1] = towards.y();
    }
    auto out = std::make_unique<Arrays>();
    out->add(std::move(label));
    out->add(std::move(distance));
    out->add(std::move(direction));
    return out.release();
  });
}

/// face, bary, position of the points of the shortest path from a point to its nearest site, then
/// its length; no points and infinity if no site reaches it.
GVD_ABI Arrays* pathToSite(const VoronoiHandle* voronoi, int face, double b0, double b1,
                           double b2) {
  return guarded([&] {
    const TriangleMesh& mesh = *voronoi->surface.mesh;
    const DistanceField& field = voronoi->field();
    const SurfacePoint from = mesh.fromInput({face, {b0, b1, b2}});
    const int label = field.nearest(from).label;
    std::vector<SurfacePoint> path;
    if (label >= 0) path = field.path(label, from);
    auto out = std::make_unique<Arrays>();
    addPoints(*out, mesh, path);
    out->add(positionsOf(mesh, path));
    out->add(std::vector<double>{path.empty() ? kInfinity : lengthOf(mesh, path)});
    return out.release();
  });
}

/// Begins the diagram.
GVD_ABI SliceEnd startTracing(VoronoiHandle* voronoi, int detail) {
  return guarded([&] {
    voronoi->options = {.detail = detail};
    voronoi->tracing.emplace(*voronoi->surface.mesh, *voronoi->distances,
                             static_cast<int>(voronoi->sites.size()), voronoi->options);
    return kMoreToDo;
  });
}

/// Works on the diagram.
GVD_ABI SliceEnd stepTracing(VoronoiHandle* voronoi, int budget) {
  return guarded([&] {
    if (!voronoi->tracing->step(budget)) return kMoreToDo;
    voronoi->diagram = voronoi->tracing->take();
    voronoi->tracing.reset();
    return kDone;
  });
}

/// The diagram, see `flatten`. This and what follows only after `stepTracing` said it is done.
GVD_ABI Arrays* voronoiDiagram(const VoronoiHandle* voronoi) {
  return guarded([&] { return flatten(*voronoi->surface.mesh, *voronoi->diagram).release(); });
}

/// The partition, see `flatten`.
GVD_ABI Arrays* partitionVoronoi(const VoronoiHandle* voronoi, int leaveOutIndifferent,
                                 int leaveOutUnreachable) {
  return guarded([&] {
    const TriangleMesh& mesh = *voronoi->surface.mesh;
    return flatten(mesh, partition(mesh, diagramOf(*voronoi),
                                   {.leaveOutIndifferent = leaveOutIndifferent != 0,
                                    .leaveOutUnreachable = leaveOutUnreachable != 0}))
        .release();
  });
}

/// The dual, or if `primal` the regions themselves, see `flatten`.
GVD_ABI Arrays* dualVoronoi(const VoronoiHandle* voronoi, int primal) {
  return guarded([&] {
    const TriangleMesh& mesh = *voronoi->surface.mesh;
    const Diagram diagram = diagramOf(*voronoi);
    return flatten(mesh,
                   primal ? regionMesh(mesh, diagram) : dualMesh(mesh, sitesOf(*voronoi), diagram))
        .release();
  });
}

/// Kinds, offsets of the labels, labels, then a text each.
GVD_ABI Arrays* dualViolations(const VoronoiHandle* voronoi) {
  return guarded([&] {
    sitesOf(*voronoi);  // all there?
    std::vector<int> kinds, offset = {0}, labels;
    auto violations = findViolations(*voronoi->surface.mesh, diagramOf(*voronoi));
    for (const Violation& violation : violations) {
      kinds.push_back(violation.kind);
      labels.insert(labels.end(), violation.labels.begin(), violation.labels.end());
      offset.push_back(static_cast<int>(labels.size()));
    }
    auto out = std::make_unique<Arrays>();
    out->add(std::move(kinds));
    out->add(std::move(offset));
    out->add(std::move(labels));
    for (Violation& violation : violations) out->add(std::move(violation.message));
    return out.release();
  });
}

/// The numbers of `RemeshQuality` for the dual, in their order.
GVD_ABI Arrays* dualQuality(const VoronoiHandle* voronoi) {
  return guarded([&] {
    const TriangleMesh& mesh = *voronoi->surface.mesh;
    const RemeshQuality quality =
        measureQuality(mesh, dualMesh(mesh, sitesOf(*voronoi), diagramOf(*voronoi)));
    auto out = std::make_unique<Arrays>();
    out->add(std::vector<double>{static_cast<double>(quality.triangles), quality.minAngle,
                                 quality.meanMinAngle, static_cast<double>(quality.minValence),
                                 static_cast<double>(quality.maxValence), quality.regularShare,
                                 quality.hausdorff});
    return out.release();
  });
}

/// face, bary of the sites that one round of repair adds.
GVD_ABI Arrays* repairingSites(const VoronoiHandle* voronoi) {
  return guarded([&] {
    const TriangleMesh& mesh = *voronoi->surface.mesh;
    sitesOf(*voronoi);  // all there?
    auto out = std::make_unique<Arrays>();
    addPoints(*out, mesh, repairingSites(mesh, diagramOf(*voronoi), voronoi->field()));
    return out.release();
  });
}

/// Inserts a site, see `flatten`. The first change makes the diagram anew, as one that can change.
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

/// label, distance per point.
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

/// `method` is a `CvtMethod`, `metric` a `Metric`; `density` is one value per input vertex, or
/// none.
GVD_ABI CvtHandle* startCvt(const MeshHandle* handle, const int* face, const double* bary,
                            std::size_t count, int method, int metric, int iterations,
                            double energyTolerance, double moveTolerance, const double* density,
                            std::size_t densityCount, const int* fixed, std::size_t fixedCount) {
  return guarded([&] {
    const TriangleMesh& mesh = *handle->mesh;
    CvtOptions options;
    options.method = static_cast<CvtMethod>(method);
    options.metric = kMetrics.at(metric);
    options.iterations = iterations;
    options.energyTolerance = energyTolerance;
    options.moveTolerance = moveTolerance;
    options.density = valuesFromInput(mesh, {density, densityCount});
    options.fixedSites.assign(fixed, fixed + fixedCount);
    const std::vector<SurfacePoint> sites = sitesFromInput(mesh, face, bary, count);
    auto cvt = std::make_unique<CvtHandle>();
    cvt->surface = *handle;
    cvt->metric = options.metric;
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

/// The same diagram as an object, for what needs `stepTracing` otherwise.
GVD_ABI VoronoiHandle* cvtVoronoi(const CvtHandle* handle) {
  return guarded([&] {
    const Cvt& cvt = *handle->cvt;
    auto voronoi = std::make_unique<VoronoiHandle>();
    voronoi->surface = handle->surface;
    voronoi->sites.assign(cvt.sites().begin(), cvt.sites().end());
    voronoi->metric = handle->metric;
    voronoi->distances = cvt.distances();
    voronoi->diagram = cvt.diagram();
    return voronoi.release();
  });
}

GVD_ABI void freeCvt(CvtHandle* cvt) { delete cvt; }

}  // namespace gvd::abi
