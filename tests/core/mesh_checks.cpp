// SPDX-License-Identifier: MIT
#include "mesh_checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "mesh/face_layout.h"

namespace gvd::checks {

using shapes::Shape;
using std::numbers::pi;

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

}  // namespace

void expectInvariants(const TriangleMesh& mesh) {
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    EXPECT_GT(mesh.length(h), 0);
    EXPECT_TRUE(std::isfinite(mesh.length(h)));
    const int twin = mesh.twin(h);
    if (twin < 0) continue;
    ASSERT_EQ(mesh.twin(twin), h);
    EXPECT_EQ(mesh.tail(twin), mesh.tip(h));
    EXPECT_EQ(mesh.tip(twin), mesh.tail(h));
    EXPECT_EQ(mesh.length(twin), mesh.length(h));
    EXPECT_EQ(mesh.component(twin / 3), mesh.component(h / 3));
  }

  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const Eigen::Vector2d apex = apexOf(mesh.face(h / 3), h % 3);
    const double toTip = mesh.length(mesh.next(h)), toTail = mesh.length(mesh.previous(h));
    const double rounding = 8 * kEpsilon * (mesh.length(h) + toTip + toTail);
    EXPECT_GT(apex.y(), 0);
    EXPECT_NEAR(apex.norm(), toTail, rounding);
    EXPECT_NEAR((apex - Eigen::Vector2d(mesh.length(h), 0)).norm(), toTip, rounding);
  }

  std::vector<int> corners(mesh.vertexCount(), 0);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) ++corners[mesh.tail(h)];
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const int first = mesh.outgoing(v);
    int met = 0;
    double angles = 0;
    int h = first;
    do {
      ASSERT_EQ(mesh.tail(h), v);
      angles += mesh.cornerAngle(h);
      ++met;
      h = mesh.rotate(h);
    } while (h >= 0 && h != first && met <= corners[v]);
    EXPECT_EQ(met, corners[v]) << "vertex " << v << " has one fan";
    EXPECT_EQ(h < 0, mesh.onBoundary(v));
    EXPECT_EQ(mesh.twin(first) < 0, mesh.onBoundary(v));
    EXPECT_NEAR(mesh.angleSum(v), angles, 1e-13 * met);
  }

  double area = 0;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const TriangleMesh::Face& face = mesh.face(f);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(face.lengths[i], mesh.length(3 * f + i));
      EXPECT_EQ(face.vertices[i], mesh.tail(3 * f + i));
      EXPECT_EQ(face.twins[i], mesh.twin(3 * f + i));
      const double angle = mesh.cornerAngle(3 * f + i);
      EXPECT_NEAR(face.cosines[i], std::cos(angle), 8 * kEpsilon);
      EXPECT_NEAR(face.sines[i], std::sin(angle), 8 * kEpsilon);
      EXPECT_GT(face.sines[i], 0);
    }
    EXPECT_GT(mesh.faceArea(f), 0);
    EXPECT_NEAR(mesh.faceArea(f), face.lengths[0] * apexOf(face, 0).y() / 2,
                8 * kEpsilon * mesh.faceArea(f));
    area += mesh.faceArea(f);

    double sum = 0;
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      EXPECT_GT(mesh.cornerAngle(h), 0);
      EXPECT_LT(mesh.cornerAngle(h), pi);
      sum += mesh.cornerAngle(h);
    }
    EXPECT_NEAR(sum, pi, 8 * kEpsilon);
  }

  EXPECT_EQ(mesh.area(), area);

  const MeshRepairs& r = mesh.repairs();
  EXPECT_EQ(r.mollification > 0, r.mollifiedTriangles > 0);
  EXPECT_EQ(mesh.inputFaceCount() + r.joinedVertices,
            mesh.faceCount() + r.nonFiniteTriangles + r.degenerateTriangles + r.duplicateTriangles +
                r.smallComponentTriangles);
  EXPECT_EQ(r.smallComponents > 0, r.smallComponentTriangles > 0);
  EXPECT_EQ(mesh.inputVertexCount(),
            mesh.vertexCount() - r.splitVertices + r.weldedVertices + r.isolatedVertices);
}

void expectTrueToInput(const Shape& shape, const TriangleMesh& mesh) {
  for (int t = 0; t < shape.faceCount(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const SurfacePoint corner = mesh.fromInput({t, Eigen::Vector3d::Unit(i)});
      EXPECT_EQ(mesh.position(corner), shape.position(shape.triangles[3 * t + i]));
    }
  }
  const Eigen::Vector3d bary(0.5, 0.375, 0.125);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    if (mesh.isJoining(f)) continue;
    const SurfacePoint input = mesh.toInput({f, bary});
    EXPECT_EQ(input.face, mesh.inputFace(f));
    const SurfacePoint back = mesh.fromInput(input);
    EXPECT_EQ(back.face, f);
    EXPECT_EQ(back.bary, bary);
  }
}

int repairCount(const MeshRepairs& r) {
  return r.weldedVertices + r.joinedVertices + r.isolatedVertices + r.nonFiniteTriangles +
         r.degenerateTriangles + r.duplicateTriangles + r.nonManifoldEdges + r.orientationCuts +
         r.flippedTriangles + r.smallComponents + r.splitVertices + r.mollifiedTriangles;
}

TriangleMesh cleanMesh(const Shape& shape) {
  TriangleMesh mesh = shape.mesh();
  EXPECT_EQ(repairCount(mesh.repairs()), 0);
  expectInvariants(mesh);
  expectTrueToInput(shape, mesh);
  return mesh;
}

TriangleMesh repairedMesh(const Shape& shape, const MeshOptions& options) {
  TriangleMesh mesh = shape.mesh(options);
  EXPECT_GT(repairCount(mesh.repairs()), 0);
  expectInvariants(mesh);
  return mesh;
}

}  // namespace gvd::checks
