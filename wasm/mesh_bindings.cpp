// SPDX-License-Identifier: MIT
//
// Meshes for JavaScript: made from arrays, described, and sampled.

#include <cstdint>
#include <memory>
#include <vector>

#include "gvd/sampling.h"
#include "objects.h"
#include "records.h"

namespace gvd::abi {
namespace {

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
  out.add("splitVertices", repairs.splitVertices);
  out.add("mollifiedTriangles", repairs.mollifiedTriangles);
  out.add("mollification", repairs.mollification);
  return out;
}

}  // namespace

GVD_ABI const char* version() { return GVD_VERSION; }

GVD_ABI MeshHandle* createMesh(Doubles positions, Ints triangles) {
  return guarded([&] {
    return new MeshHandle{std::make_shared<const TriangleMesh>(positions.span(), triangles.span())};
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

/// `SurfacePoints` at input vertices; of a mesh or a diagram.
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

/// `SurfacePoints`. `seed` is an integer below 2^53.
GVD_ABI Answer* sampleSites(const MeshHandle* handle, int count, Text sampling, double seed) {
  return answer([&] {
    const TriangleMesh& mesh = *handle->mesh;
    return pointsRecord(mesh, sample(mesh, count, valueOf(kSamplings, "sampling", toView(sampling)),
                                     static_cast<std::uint64_t>(seed)));
  });
}

}  // namespace gvd::abi
