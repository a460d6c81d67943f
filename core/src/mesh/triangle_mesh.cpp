// SPDX-License-Identifier: MIT
#include "gvd/triangle_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/number_text.h"
#include "base/rejection.h"
#include "base/tolerances.h"
#include "mesh/given_points.h"

namespace gvd {
namespace {

// --- Points from outside ------------------------------------------------------------------------

/// The fault of barycentric coordinates, beyond the tolerance; empty if there is none.
std::string faultOf(const Eigen::Vector3d& bary) {
  for (const double b : bary) {
    if (!std::isfinite(b)) return "a barycentric coordinate is not a finite number";
    if (b < -kBarycentricTolerance)
      return "the barycentric coordinate " + numberText(b) + " is negative";
  }
  if (std::abs(bary.sum() - 1) > kBarycentricTolerance)
    return "the barycentric coordinates sum to " + numberText(bary.sum()) + ", not 1";
  return {};
}

}  // namespace

// --- Measures of the surface -------------------------------------------------------------------

Eigen::Vector3d TriangleMesh::position(const SurfacePoint& p) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) sum += p.bary[i] * position(tail(3 * p.face + i));
  return sum;
}

// --- To and from the input ---------------------------------------------------------------------

SurfacePoint TriangleMesh::toInput(const SurfacePoint& p) const {
  if (p.face < 0) return p;
  SurfacePoint input{inputFace(p.face), p.bary};
  if (isFlipped(p.face)) std::swap(input.bary[1], input.bary[2]);
  if (isJoining(p.face))
    input.bary = joining_[inputFace_[p.face] - inputFaceCount_].corners * input.bary;
  return input;
}

std::string TriangleMesh::faultOfPoint(const SurfacePoint& p) const {
  if (p.face < 0 || p.face >= faceCount()) return "there is no face " + std::to_string(p.face);
  return faultOf(p.bary);
}

/// A halfedge that leaves each corner of an input triangle, all on one face; -1 if there is none.
std::array<int, 3> TriangleMesh::halfedgesOfInput(int triangle) const {
  // At most all that were dropped came before it, so few places are left if few were.
  const auto begin = inputFace_.begin();
  const int first = std::max(0, triangle - static_cast<int>(droppedFace_.size()));
  const auto face =
      std::lower_bound(begin + first, begin + std::min(triangle, faceCount()), triangle);
  const int f = static_cast<int>(face - inputFace_.begin());
  if (face != inputFace_.end() && *face == triangle)
    return isFlipped(f) ? std::array{3 * f, 3 * f + 2, 3 * f + 1}
                        : std::array{3 * f, 3 * f + 1, 3 * f + 2};
  const int dropped = triangle - f;  // f triangles before it became faces
  if (droppedFace_[dropped] < 0) return {-1, -1, -1};
  const int corner = 3 * droppedFace_[dropped], corners = droppedCorners_[dropped];
  return {corner + (corners & 3), corner + (corners >> 2 & 3), corner + (corners >> 4)};
}

SurfacePoint TriangleMesh::fromInput(const SurfacePoint& p) const {
  if (p.face < 0 || p.face >= inputFaceCount())
    rejectPoint("there is no triangle " + std::to_string(p.face));
  const std::array<int, 3> halfedges = halfedgesOfInput(p.face);
  if (halfedges[0] < 0)
    rejectPoint("triangle " + std::to_string(p.face) +
                " was dropped and no other triangle has its points");
  if (const std::string fault = faultOf(p.bary); !fault.empty()) rejectPoint(fault);
  const Eigen::Vector3d bary = cleanBarycentric(p.bary);
  SurfacePoint q{faceOf(halfedges[0]), Eigen::Vector3d::Zero()};
  for (int i = 0; i < 3; ++i) q.bary[halfedges[i] % 3] += bary[i];
  return q;
}

SurfacePoint TriangleMesh::fromInputVertex(int inputVertex) const {
  if (inputVertex < 0 || inputVertex >= inputVertexCount())
    rejectPoint("there is no vertex " + std::to_string(inputVertex));
  const int h = vertexOfInput_[inputVertex];
  if (h < 0) rejectPoint("no triangle of the surface uses vertex " + std::to_string(inputVertex));
  return {faceOf(h), Eigen::Vector3d::Unit(h % 3)};
}

}  // namespace gvd
