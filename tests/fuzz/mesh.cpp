// SPDX-License-Identifier: MIT
//
// Vertices, triangles and options: a mesh that keeps what `TriangleMesh` promises, or an `Error`.
#include <cmath>
#include <cstdlib>

#include "gvd/error.h"
#include "gvd/subdivision.h"
#include "wild_mesh.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

void check(const gvd::TriangleMesh& mesh) {
  const gvd::MeshRepairs& r = mesh.repairs();
  require(mesh.inputFaceCount() + r.joinedVertices ==
          mesh.faceCount() + r.nonFiniteTriangles + r.degenerateTriangles + r.duplicateTriangles +
              r.smallComponentTriangles);
  require(mesh.inputVertexCount() ==
          mesh.vertexCount() - r.splitVertices + r.weldedVertices + r.isolatedVertices);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    require(mesh.length(h) > 0 && mesh.cornerAngle(h) > 0);
    const int twin = mesh.twin(h);
    if (twin < 0) continue;
    require(mesh.twin(twin) == h && mesh.tail(twin) == mesh.tip(h));
    require(mesh.length(twin) == mesh.length(h));
  }
  for (int f = 0; f < mesh.faceCount(); ++f)
    require(mesh.faceArea(f) > 0 && std::isfinite(mesh.faceArea(f)));
  require(mesh.topology().genus >= 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gvd::shapes::Random random(std::span(data, size));
  try {
    const gvd::shapes::Shape shape = gvd::wildMesh(random, 60);
    check(shape.mesh());
    check(shape.mesh(
        {.weld = random.uniform() * random.uniform(),
         .orientation = random.below(2) ? gvd::Orientation::kKeep : gvd::Orientation::kUnify,
         .minComponent = random.below(5)}));
    const auto parts = gvd::subdivide(shape.positions, shape.triangles,
                                      {.maxEdge = random.uniform(), .maxTriangles = 2000});
    check(gvd::TriangleMesh(parts.positions, parts.triangles));
  } catch (const gvd::Error&) {
  }
  return 0;
}
