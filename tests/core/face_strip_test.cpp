// SPDX-License-Identifier: MIT
#include "dgpc/face_strip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <queue>
#include <vector>

#include "gvd/geodesic.h"
#include "shapes.h"

namespace gvd {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;
using namespace shapes;

/// Over the fewest edges from a face at a vertex to another face.
FaceStrip shortestStrip(const TriangleMesh& mesh, int vertex, int goal) {
  std::vector<int> through(mesh.faceCount(), -1);  // by which halfedge, on the way to the goal
  std::vector<char> isKnown(mesh.faceCount());
  std::queue<int> faces({goal});
  isKnown[goal] = true;
  while (!faces.empty()) {
    const int face = faces.front();
    faces.pop();
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      const int twin = mesh.twin(h);
      if (twin < 0 || isKnown[TriangleMesh::faceOf(twin)]) continue;
      isKnown[TriangleMesh::faceOf(twin)] = true;
      through[TriangleMesh::faceOf(twin)] = twin;
      faces.push(TriangleMesh::faceOf(twin));
    }
  }
  FaceStrip strip(mesh);
  strip.start(TriangleMesh::faceOf(mesh.outgoing(vertex)));
  while (strip.lastFace() != goal) strip.goThrough(through[strip.lastFace()]);
  return strip;
}

bool hasCorner(const TriangleMesh& mesh, int face, int vertex) {
  return mesh.tail(3 * face) == vertex || mesh.tail(3 * face + 1) == vertex ||
         mesh.tail(3 * face + 2) == vertex;
}

SurfacePoint middleOf(int face) { return {face, Eigen::Vector3d::Constant(1.0 / 3)}; }

TEST(FaceStrip, IsStraightInThePlane) {
  const TriangleMesh mesh = grid(9, 7, 0.3, 5).mesh();
  for (int face = 0; face < mesh.faceCount(); face += 5) {
    const SurfacePoint site = middleOf(face);
    const Eigen::Vector3d x =
        mesh.position(mesh.tip(3 * face)) - mesh.position(mesh.tail(3 * face));
    for (int v = 0; v < mesh.vertexCount(); v += 3) {
      const auto path = shortestStrip(mesh, v, face).straighten(v, site);
      ASSERT_TRUE(path);
      const Eigen::Vector3d way = mesh.position(v) - mesh.position(site);
      EXPECT_NEAR(path->length, way.norm(), 1e-12);
      // Counterclockwise from the first side, as the faces of a grid are.
      const double along = way.dot(x.normalized());
      const double beside = x.normalized().cross(way).z();
      EXPECT_NEAR((path->departure - Vector2d(along, beside) / way.norm()).norm(), 0, 1e-10);
    }
  }
}

TEST(FaceStrip, GoesAroundAnInnerCornerOfTheBoundary) {
  const TriangleMesh mesh = ell(4).mesh();
  const Eigen::Vector3d corner(1, 1, 0);
  for (int face = 0; face < mesh.faceCount(); ++face) {
    const SurfacePoint site = middleOf(face);
    const Eigen::Vector3d from = mesh.position(site);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const Eigen::Vector3d to = mesh.position(v);
      const auto path = shortestStrip(mesh, v, face).straighten(v, site);
      ASSERT_TRUE(path);
      const double straight = (to - from).norm();
      const double around = (corner - from).norm() + (to - corner).norm();
      EXPECT_GE(path->length, straight - 1e-12);
      EXPECT_LE(path->length, around + 1e-12);
      EXPECT_LE(std::min(path->length - straight, around - path->length), 1e-12);
    }
  }
}

/// Each piece of a path is a path of its own, straight and as long; two that meet leave no angle of
/// less than π on the surface.
TEST(FaceStrip, IsMadeOfStraightPieces) {
  for (const Shape& shape : {ell(4), perforatedPlate(2), spiral(40), bumpySurface(2, 5, 0.4, 3)}) {
    const TriangleMesh mesh = shape.mesh();
    const SurfacePoint site = middleOf(0);
    int bent = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      FaceStrip strip = shortestStrip(mesh, v, site.face);
      const auto path = strip.straighten(v, site);
      ASSERT_TRUE(path);
      const auto pieces = strip.pieces();
      double length = 0;
      for (size_t i = 0; i < pieces.size(); ++i) {
        const FaceStrip::Piece& piece = pieces[i];
        const bool isLast = i + 1 == pieces.size();
        EXPECT_EQ(piece.vertex == v, i == 0);
        ASSERT_TRUE(hasCorner(mesh, piece.firstFace, piece.vertex));
        FaceStrip own(mesh);
        own.start(piece.firstFace, piece.crossed);
        const SurfacePoint end = isLast ? site : mesh.fromInputVertex(pieces[i + 1].vertex);
        const auto straight = own.straighten(piece.vertex, end);
        ASSERT_TRUE(straight);
        EXPECT_EQ(own.pieces().size(), 1u);
        EXPECT_NEAR(straight->length, piece.length, 1e-12);
        length += piece.length;
        if (isLast) continue;
        ++bent;
        const int bend = pieces[i + 1].vertex;
        const double between = std::abs(own.angleAtEnd() - pieces[i + 1].angle);
        EXPECT_GE(between, pi - 1e-9);
        if (!mesh.onBoundary(bend)) {
          EXPECT_LE(between, mesh.angleSum(bend) - pi + 1e-9);
        }
      }
      EXPECT_NEAR(length, path->length, 1e-12 * path->length);
    }
    EXPECT_GT(bent, 0);
  }
}

/// Opposite corners of a saddle see each other across its apex only.
TEST(FaceStrip, BendsAtASaddle) {
  constexpr int kSpokes = 10;
  const TriangleMesh mesh = vertexFan(kSpokes, 3 * pi).mesh();
  const SurfacePoint site = mesh.fromInputVertex(1);
  const auto path =
      shortestStrip(mesh, 1 + kSpokes / 2, site.face).straighten(1 + kSpokes / 2, site);
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->length, 2, 1e-12);
}

/// The strip leads around one side of a cone's apex, and the shorter way is on the other side.
TEST(FaceStrip, PassesAConesApexOnTheShorterSide) {
  constexpr int kSpokes = 12;
  const TriangleMesh mesh = vertexFan(kSpokes, 1.5 * pi).mesh();
  const int site = 1, vertex = 1 + 4;  // a third of the way round: 1.5π / 3 apart
  const SurfacePoint end = mesh.fromInputVertex(site);
  FaceStrip strip(mesh);
  int h = mesh.outgoing(0);
  while (mesh.tip(h) != vertex) h = mesh.rotate(h);
  strip.start(TriangleMesh::faceOf(h));
  // The long way round, face by face.
  while (!hasCorner(mesh, strip.lastFace(), site)) {
    strip.goThrough(TriangleMesh::previous(h));
    h = mesh.rotate(h);
  }
  const auto path = strip.straighten(vertex, end);
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->length, 2 * std::sin(1.5 * pi / 6), 1e-12);
}

/// Whatever strip one starts from, what comes out is the length of some path: no less than the
/// distance; and on these surfaces mostly the distance.
TEST(FaceStrip, IsNeverShorterThanTheDistance) {
  for (const Shape& shape : {icosphere(2), torus(16, 10), cube(), perforatedPlate(2)}) {
    const TriangleMesh mesh = shape.mesh();
    const SurfacePoint site = middleOf(mesh.faceCount() / 3);
    const auto propagation =
        propagate(mesh, std::vector<SurfacePoint>{site}, Metric::kExact, Spread::kEverywhere);
    while (!propagation->step(1L << 40)) {
    }
    const auto field = propagation->take();
    int equal = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const auto path = shortestStrip(mesh, v, site.face).straighten(v, site);
      ASSERT_TRUE(path);
      const double distance = field->at(v)[0].distance;
      EXPECT_GE(path->length, distance * (1 - 1e-12));
      if (path->length <= distance * (1 + 1e-12)) ++equal;
    }
    EXPECT_GT(equal, 0.5 * mesh.vertexCount());
  }
}

}  // namespace
}  // namespace gvd
