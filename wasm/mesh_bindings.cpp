// SPDX-License-Identifier: MIT
//
// Meshes for JavaScript: made from arrays, described, and sampled.

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "gvd/curvature.h"
#include "gvd/geodesic.h"
#include "gvd/sampling.h"
#include "gvd/subdivision.h"
#include "objects.h"
#include "records.h"

namespace gvd::abi {
namespace {

constexpr Named<Orientation> kOrientations[] = {{"unify", Orientation::kUnify},
                                                {"keep", Orientation::kKeep}};

enum class Sampling { kRandom, kFarthest, kPoisson };

constexpr Named<Sampling> kSamplings[] = {{"random", Sampling::kRandom},
                                          {"farthest", Sampling::kFarthest},
                                          {"poisson", Sampling::kPoisson}};

/// A sampling as points alone.
template <class Result>
Answer* pointsAnswer(const MeshHandle& handle, std::unique_ptr<SlicedWork<Result>> work) {
  return answerOf(std::move(work), [mesh = handle.mesh](const Result& result) {
    if constexpr (std::is_same_v<Result, PoissonDisk>)
      return pointsRecord(*mesh, result.points);
    else
      return pointsRecord(*mesh, result);
  });
}

/// `ClosestPoints`; the first one makes the query that finds them.
class ClosestPointLookup final : public PointLookup {
 public:
  /// The handle must outlive the steps.
  ClosestPointLookup(MeshHandle& handle, std::span<const double> places)
      : PointLookup(places.size() / 3),
        handle_(handle),
        mesh_(handle.mesh),
        places_(places.begin(), places.end()) {}

  Record result() override {
    Record out = placedRecord(*mesh_, points_);
    out.add("distance", std::move(distance_));
    return out;
  }

 private:
  bool prepare(long budget) override {
    if (*handle_.closestPoints) return true;
    if (!building_) building_ = startClosestPointQuery(*mesh_);
    if (!building_->step(budget)) return false;
    handle_.closestPoints->emplace(building_->take());
    return true;
  }
  void lookUp(std::size_t i, long& /*budget*/) override {
    const ClosestPoint closest = naming("position", i, [&] {
      return (*handle_.closestPoints)->closestTo(Eigen::Vector3d::Map(&places_[3 * i]));
    });
    points_.push_back(closest.point);
    distance_.push_back(closest.distance);
  }

  MeshHandle& handle_;
  const std::shared_ptr<const TriangleMesh> mesh_;
  const std::vector<double> places_;
  std::unique_ptr<SlicedWork<ClosestPointQuery>> building_;
  std::vector<SurfacePoint> points_;
  std::vector<double> distance_;
};

Record repairsRecord(const MeshRepairs& repairs) {
  Record out;
  out.add("weldedVertices", repairs.weldedVertices);
  out.add("joinedVertices", repairs.joinedVertices);
  out.add("isolatedVertices", repairs.isolatedVertices);
  out.add("nonFiniteTriangles", repairs.nonFiniteTriangles);
  out.add("degenerateTriangles", repairs.degenerateTriangles);
  out.add("duplicateTriangles", repairs.duplicateTriangles);
  out.add("nonManifoldEdges", repairs.nonManifoldEdges);
  out.add("orientationCuts", repairs.orientationCuts);
  out.add("flippedTriangles", repairs.flippedTriangles);
  out.add("smallComponents", repairs.smallComponents);
  out.add("smallComponentTriangles", repairs.smallComponentTriangles);
  out.add("splitVertices", repairs.splitVertices);
  out.add("mollifiedTriangles", repairs.mollifiedTriangles);
  out.add("mollification", repairs.mollification);
  return out;
}

Record infoRecord(const TriangleMesh& mesh) {
  const MeshTopology& topology = mesh.topology();
  Record out;
  out.add("vertices", mesh.vertexCount());
  out.add("faces", mesh.faceCount());
  out.add("edges", topology.edges);
  out.add("inputVertices", mesh.inputVertexCount());
  out.add("inputFaces", mesh.inputFaceCount());
  out.add("components", topology.components);
  out.add("boundaryLoops", topology.boundaryLoops);
  out.add("eulerCharacteristic", topology.eulerCharacteristic);
  out.add("genus", topology.genus);
  out.add("hasOpenSeams", topology.hasOpenSeams);
  out.add("hasTJunctions", topology.hasTJunctions);
  out.add("area", mesh.area());
  out.add("boundingDiagonal", mesh.boundingDiagonal());
  out.add("repairs", repairsRecord(mesh.repairs()));
  return out;
}

}  // namespace

GVD_ABI const char* version() { return GVD_VERSION; }

/// The input of a mesh, which arrives piece by piece: so copying does not block the thread, and
/// memory never holds it twice.
struct MeshArrays {
  std::vector<double> positions;
  std::vector<int> triangles;
};

GVD_ABI MeshArrays* newMeshArrays(int coordinates, int indices) {
  return guarded([&] {
    auto arrays = std::make_unique<MeshArrays>();
    arrays->positions.reserve(coordinates);
    arrays->triangles.reserve(indices);
    return arrays.release();
  });
}

GVD_ABI MeshArrays* appendToMeshArrays(MeshArrays* arrays, Doubles positions, Ints triangles) {
  return guarded([&] {
    const auto append = [](auto& list, const auto& piece) {
      list.insert(list.end(), piece.span().begin(), piece.span().end());
    };
    append(arrays->positions, positions);
    append(arrays->triangles, triangles);
    return arrays;
  });
}

GVD_ABI void freeMeshArrays(MeshArrays* arrays) { delete arrays; }

/// `Subdivision`. The arrays then hold the parts; they must outlive the answer.
GVD_ABI Answer* subdivideMeshArrays(MeshArrays* arrays, double maxEdge) {
  return guarded([&] {
    return answerOf(startSubdivision(std::move(arrays->positions), std::move(arrays->triangles),
                                     {.maxEdge = maxEdge}),
                    [arrays](SubdividedTriangles parts) {
                      arrays->positions = parts.positions;
                      arrays->triangles = parts.triangles;
                      Record out;
                      out.add("positions", std::move(parts.positions));
                      out.add("indices", std::move(parts.triangles));
                      out.add("parents", std::move(parts.parents));
                      out.add("ends", std::move(parts.ends));
                      return out;
                    });
  });
}

/// `MeshInfo`, but for the notes of the reader, and `mesh`: a `MeshHandle`. The arrays are empty
/// then.
GVD_ABI Answer* createMesh(MeshArrays* arrays, double weld, Text orientation, int minComponent) {
  return guarded([&] {
    const MeshOptions options = {.weld = weld,
                                 .orientation = valueOf(kOrientations, "orientation", orientation),
                                 .minComponent = minComponent};
    return answerOf(startMesh(std::move(arrays->positions), std::move(arrays->triangles), options),
                    [](TriangleMesh mesh) {
                      auto handle = std::make_unique<MeshHandle>();
                      handle->mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
                      handle->closestPoints = std::make_shared<std::optional<ClosestPointQuery>>();
                      Record out = infoRecord(*handle->mesh);
                      out.add(addressRecord("mesh", std::move(handle)));
                      return out;
                    });
  });
}

GVD_ABI void freeMesh(MeshHandle* handle) { delete handle; }

/// `SurfacePoints` at input vertices; of a mesh or a diagram.
GVD_ABI Answer* pointsAtVertices(const MeshHandle* handle, Ints vertex) {
  return answer([&] {
    std::vector<SurfacePoint> points;
    points.reserve(vertex.size);
    for (std::size_t i = 0; i < vertex.size; ++i)
      points.push_back(handle->mesh->fromInputVertex(vertex.data[i]));
    return pointsRecord(*handle->mesh, points);
  });
}

/// `ClosestPoints` to places, three numbers each.
GVD_ABI Answer* closestPoints(MeshHandle* handle, Doubles places) {
  return guarded(
      [&] { return answerOf(std::make_unique<ClosestPointLookup>(*handle, places.span())); });
}

/// `SurfacePath`: the shortest one between two points; no points and infinity if there is none.
GVD_ABI Answer* shortestPath(const MeshHandle* handle, Ints fromFace, Doubles fromBary, Ints toFace,
                             Doubles toBary) {
  return guarded([&] {
    const std::shared_ptr<const TriangleMesh> mesh = handle->mesh;
    return answerOf(
        startShortestPath(
            *mesh,
            naming("from", std::nullopt, [&] { return pointFromInput(*mesh, fromFace, fromBary); }),
            naming("to", std::nullopt, [&] { return pointFromInput(*mesh, toFace, toBary); })),
        [mesh](const std::vector<SurfacePoint>& path) { return pathRecord(*mesh, path); });
  });
}

/// `SurfacePoints`. `seed` is an integer below 2^53; `density` is one value per input vertex, for
/// random sites, or none.
GVD_ABI Answer* sampleSites(const MeshHandle* handle, int count, Text sampling, double seed,
                            Doubles density) {
  return guarded([&] {
    const TriangleMesh& mesh = *handle->mesh;
    const auto from = static_cast<std::uint64_t>(seed);
    if (density.size > 0) {
      return pointsAnswer(*handle,
                          startByDensity(mesh, densityFromInput(mesh, density), count, from));
    }
    switch (valueOf(kSamplings, "sampling", sampling)) {
      case Sampling::kFarthest:
        return pointsAnswer(*handle, startFarthest(mesh, count, from));
      case Sampling::kPoisson:
        return pointsAnswer(*handle, startPoissonDiskCount(mesh, count, from));
      default:
        return pointsAnswer(*handle, startUniform(mesh, count, from));
    }
  });
}

/// `SurfacePoints`: each in the worst region of those before.
GVD_ABI Answer* sampleSitesWorstFirst(const MeshHandle* handle, int count, Text worst,
                                      double seed) {
  return guarded([&] {
    return pointsAnswer(*handle,
                        startWorstFirst(*handle->mesh, count, static_cast<std::uint64_t>(seed),
                                        worstRegionOf(worst)));
  });
}

/// `SurfacePoints`: as many sites as the radius takes.
GVD_ABI Answer* sampleSitesByRadius(const MeshHandle* handle, double radius, Text sampling,
                                    double seed) {
  return guarded([&] {
    const TriangleMesh& mesh = *handle->mesh;
    const auto from = static_cast<std::uint64_t>(seed);
    switch (valueOf(kSamplings, "sampling", sampling)) {
      case Sampling::kFarthest: {
        constexpr int kAny = std::numeric_limits<int>::max();
        return pointsAnswer(*handle, startFarthest(mesh, kAny, from, radius));
      }
      case Sampling::kPoisson:
        return pointsAnswer(*handle, startPoissonDisk(mesh, radius, from));
      default:
        throw Error(ErrorCode::kInvalidArgument, "random sites have no radius: ask for a number");
    }
  });
}

/// `SurfacePoints`: the given ones, with at least `perComponent` on each component, and `count` in
/// all as far as that is possible (`gvd::coverComponents`).
GVD_ABI Answer* coverComponents(const MeshHandle* handle, Ints face, Doubles bary, int perComponent,
                                int count, double seed) {
  return guarded([&] {
    const TriangleMesh& mesh = *handle->mesh;
    return pointsAnswer(
        *handle, startCoverComponents(mesh, sitesFromInput(mesh, face, bary), perComponent, count,
                                      static_cast<std::uint64_t>(seed)));
  });
}

/// `BareComponents`.
GVD_ABI Answer* bareComponents(const MeshHandle* handle, Ints face, Doubles bary) {
  return guarded([&] {
    const auto mesh = handle->mesh;
    return answerOf(startBareComponents(*mesh, sitesFromInput(*mesh, face, bary)),
                    [mesh](const BareComponents& bare) {
                      Record out;
                      out.add("components", bare.components);
                      out.add("area", bare.area);
                      return out;
                    });
  });
}

/// `values`: a density per input vertex, 1 at vertices of no triangle.
GVD_ABI Answer* curvatureDensity(const MeshHandle* handle) {
  return guarded([&] {
    return answerOf(startCurvatureDensity(*handle->mesh),
                    [mesh = handle->mesh](const std::vector<double>& density) {
                      Record out;
                      out.add("values", valuesAtInput(*mesh, density, 1));
                      return out;
                    });
  });
}

}  // namespace gvd::abi
