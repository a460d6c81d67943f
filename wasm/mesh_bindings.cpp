// SPDX-License-Identifier: MIT
//
// Meshes for JavaScript: made from arrays, described, and sampled.

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "gvd/curvature.h"
#include "gvd/sampling.h"
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

std::vector<SurfacePoint> sample(const TriangleMesh& mesh, int count, Sampling sampling,
                                 std::uint64_t seed) {
  switch (sampling) {
    case Sampling::kFarthest:
      return sampleFarthest(mesh, count, seed);
    case Sampling::kPoisson:
      return samplePoissonDiskCount(mesh, count, seed).points;
    default:
      return sampleUniform(mesh, count, seed);
  }
}

std::vector<SurfacePoint> sampleByRadius(const TriangleMesh& mesh, double radius, Sampling sampling,
                                         std::uint64_t seed) {
  constexpr int kAny = std::numeric_limits<int>::max();
  switch (sampling) {
    case Sampling::kFarthest:
      return sampleFarthest(mesh, kAny, seed, radius);
    case Sampling::kPoisson:
      return samplePoissonDisk(mesh, radius, seed).points;
    default:
      throw Error(ErrorCode::kInvalidArgument, "random sites have no radius: ask for a number");
  }
}

Record repairsRecord(const MeshRepairs& repairs) {
  Record out;
  out.add("weldedVertices", repairs.weldedVertices);
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

}  // namespace

GVD_ABI const char* version() { return GVD_VERSION; }

GVD_ABI MeshHandle* createMesh(Doubles positions, Ints triangles, double weld, Text orientation,
                               int minComponent) {
  return guarded([&] {
    const MeshOptions options = {
        .weld = weld,
        .orientation = valueOf(kOrientations, "orientation", toView(orientation)),
        .minComponent = minComponent};
    return new MeshHandle{
        std::make_shared<const TriangleMesh>(positions.span(), triangles.span(), options), {}};
  });
}

GVD_ABI void freeMesh(MeshHandle* handle) { delete handle; }

/// `MeshInfo`, but for the notes of the glTF reader.
GVD_ABI Answer* meshInfo(const MeshHandle* handle) {
  return answer([&] {
    const TriangleMesh& mesh = *handle->mesh;
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
    out.add("area", mesh.area());
    out.add("boundingDiagonal", mesh.boundingDiagonal());
    out.add("repairs", repairsRecord(mesh.repairs()));
    return out;
  });
}

/// `SurfacePoints` at input vertices.
GVD_ABI Answer* pointsAtVertices(const MeshHandle* handle, Ints vertex) {
  return answer([&] {
    std::vector<SurfacePoint> points;
    points.reserve(vertex.size);
    for (std::size_t i = 0; i < vertex.size; ++i) {
      points.push_back(
          naming("point", i, [&] { return handle->mesh->fromInputVertex(vertex.data[i]); }));
    }
    return pointsRecord(*handle->mesh, points);
  });
}

/// `ClosestPoints` to places, three numbers each. The first call makes what finds them.
GVD_ABI Answer* closestPoints(MeshHandle* handle, Doubles places) {
  return answer([&] {
    const TriangleMesh& mesh = *handle->mesh;
    if (!handle->closestPoints)
      handle->closestPoints = std::make_shared<const ClosestPointQuery>(mesh);
    std::vector<SurfacePoint> points;
    std::vector<double> distance;
    for (std::size_t i = 0; i + 2 < places.size; i += 3) {
      const double* p = places.data + i;
      const ClosestPoint closest = naming("position", i / 3, [&] {
        return handle->closestPoints->closestTo({p[0], p[1], p[2]});
      });
      points.push_back(closest.point);
      distance.push_back(closest.distance);
    }
    Record out = placedRecord(mesh, points);
    out.add("distance", std::move(distance));
    return out;
  });
}

/// `SurfacePoints`. `seed` is an integer below 2^53.
GVD_ABI Answer* sampleSites(const MeshHandle* handle, int count, Text sampling, double seed) {
  return answer([&] {
    const TriangleMesh& mesh = *handle->mesh;
    return pointsRecord(mesh, sample(mesh, count, valueOf(kSamplings, "sampling", toView(sampling)),
                                     static_cast<std::uint64_t>(seed)));
  });
}

/// The same, as many as the radius takes.
GVD_ABI Answer* sampleSitesByRadius(const MeshHandle* handle, double radius, Text sampling,
                                    double seed) {
  return answer([&] {
    const TriangleMesh& mesh = *handle->mesh;
    return pointsRecord(
        mesh, sampleByRadius(mesh, radius, valueOf(kSamplings, "sampling", toView(sampling)),
                             static_cast<std::uint64_t>(seed)));
  });
}

/// `SurfacePoints`: these, with at least so many on each component, and no more than `count` unless
/// there were.
GVD_ABI Answer* coverComponents(const MeshHandle* handle, Ints face, Doubles bary, int perComponent,
                                int count, double seed) {
  return answer([&] {
    const TriangleMesh& mesh = *handle->mesh;
    return pointsRecord(
        mesh, gvd::coverComponents(mesh, pointsFromInput(mesh, "site", face, bary), perComponent,
                                   count, static_cast<std::uint64_t>(seed)));
  });
}

/// `BareComponents`.
GVD_ABI Answer* bareComponents(const MeshHandle* handle, Ints face, Doubles bary) {
  return answer([&] {
    const TriangleMesh& mesh = *handle->mesh;
    const BareComponents bare = gvd::bareComponents(mesh, sitesFromInput(mesh, face, bary));
    Record out;
    out.add("components", bare.components);
    out.add("area", bare.area);
    return out;
  });
}

/// `values`: a density per input vertex; of one that is on no triangle, 1.
GVD_ABI Answer* curvatureDensity(const MeshHandle* handle) {
  return answer([&] {
    const TriangleMesh& mesh = *handle->mesh;
    Record out;
    out.add("values", valuesAtInput(mesh, gvd::curvatureDensity(mesh), 1));
    return out;
  });
}

}  // namespace gvd::abi
