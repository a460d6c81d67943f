// SPDX-License-Identifier: MIT
#include "gvd/triangle_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "gvd/error.h"
#include "mesh/input_map.h"
#include "mesh/mesh_orientation.h"
#include "mesh/triangle_selection.h"

namespace gvd {
namespace {

/// How far barycentric coordinates given from outside may be off.
constexpr double kBarycentricTolerance = 1e-6;

/// Squared lengths of a mesh of this size still are finite, and so are their sums.
constexpr double kMaxBoundingDiagonal = 0x1p500;

// --- Measures ----------------------------------------------------------------------------------

/// |v|, positive unless v is zero: components whose squares would underflow or overflow are scaled
/// first.
double lengthOf(const Eigen::Vector3d& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  if (0x1p-400 < largest && largest < 0x1p400) return v.norm();
  if (largest == 0) return 0;
  return largest * (v / largest).norm();
}

/// The angle between the sides a and b of a triangle with third side c: accurate for needles and
/// caps too (W. Kahan, "Miscalculating Area and Angles of a Needle-like Triangle"). Lengths that
/// rounding made break the triangle inequality count as a flat triangle.
double angleBetween(double a, double b, double c) {
  if (a < b) std::swap(a, b);
  const double mu = std::max(0.0, b >= c ? c - (a - b) : b - (a - c));
  const double nu = std::max(0.0, (a - c) + b);
  // Roots before products, which could underflow.
  return 2 *
         std::atan2(std::sqrt((a - b) + c) * std::sqrt(mu), std::sqrt(a + (b + c)) * std::sqrt(nu));
}

/// Lays a face out on each of its sides, whose lengths are known.
void layOut(std::span<TriangleMesh::Layout, 3> sides) {
  std::array<double, 3> lengths = {sides[0].length, sides[1].length, sides[2].length};
  std::sort(lengths.begin(), lengths.end());
  const auto [c, b, a] = lengths;
  // 4·area = p·q, by Heron's formula in the order of Kahan: accurate for needles, where the
  // difference of two squares would cancel, and where (a + b) - c would lose c.
  const double p = std::sqrt(a + (b + c)) * std::sqrt(std::max(0.0, c - (a - b)));
  const double q = std::sqrt(c + (a - b)) * std::sqrt(a + (b - c));
  for (int i = 0; i < 3; ++i) {
    TriangleMesh::Layout& side = sides[i];
    const double toTip = sides[(i + 1) % 3].length, toTail = sides[(i + 2) % 3].length;
    side.inverse = 1 / (2 * side.length);
    side.x = (side.length + (toTail - toTip) / side.length * (toTail + toTip)) / 2;
    side.y = p * side.inverse * q;
  }
}

// --- Points from outside ------------------------------------------------------------------------

[[noreturn]] void rejectPoint(const std::string& why) {
  throw Error(ErrorCode::kInvalidPoint, why);
}

/// Non-negative coordinates of sum 1 from such that may be off by the tolerance.
Eigen::Vector3d cleanBarycentric(const Eigen::Vector3d& bary) {
  for (double b : bary) {
    if (!std::isfinite(b)) rejectPoint("a barycentric coordinate is not a finite number");
    if (b < -kBarycentricTolerance) {
      rejectPoint("the barycentric coordinate " + std::to_string(b) + " is negative");
    }
  }
  if (std::abs(bary.sum() - 1) > kBarycentricTolerance) {
    rejectPoint("the barycentric coordinates sum to " + std::to_string(bary.sum()) + ", not 1");
  }
  const Eigen::Vector3d clamped = bary.cwiseMax(0.0);
  return clamped / clamped.sum();
}

}  // namespace

// --- Construction ------------------------------------------------------------------------------

TriangleMesh::TriangleMesh(std::span<const double> positions, std::span<const int> triangles) {
  requireIndexedTriangles(positions, triangles);
  const int inputVertexCount = static_cast<int>(positions.size() / 3);
  const std::vector<int> representative = findRepresentatives(positions);
  const std::vector<Corners> welded = weldCorners(triangles, representative);
  Selection selection = selectTriangles(welded, inputVertexCount, repairs_);

  twin_ = matchHalfedges(selection.corners, inputVertexCount, repairs_);
  Orientation orientation = orientTriangles(selection.corners, twin_, repairs_);
  Fans fans = splitFans(selection.corners, twin_, inputVertexCount, repairs_);
  tail_ = std::move(fans.tail);
  vertexHalfedge_ = std::move(fans.outgoing);
  inputVertex_ = std::move(fans.representative);
  inputFace_ = std::move(selection.input);
  flipped_ = std::move(orientation.flipped);
  component_ = std::move(orientation.component);
  copyPositions(positions);
  measure();
  countTopology(orientation.components);

  faceOfInput_ = mapInputCorners(welded, selection.corners, std::move(selection.kept));
  vertexOfInput_ = mapInputVertices(triangles, representative, faceOfInput_);
  countInputVertices(vertexOfInput_, representative, repairs_);
}

void TriangleMesh::copyPositions(std::span<const double> positions) {
  positions_.resize(3, vertexCount());
  for (int v = 0; v < vertexCount(); ++v) {
    positions_.col(v) =
        Eigen::Vector3d::Map(&positions[3 * static_cast<std::size_t>(inputVertex_[v])]);
  }
  if (!(boundingDiagonal() <= kMaxBoundingDiagonal)) {
    throw Error(ErrorCode::kInvalidMesh, "the positions are too far apart to measure distances");
  }
}

void TriangleMesh::measure() {
  layout_.resize(halfedgeCount());
  angle_.resize(halfedgeCount());
  angleSum_.assign(vertexCount(), 0);
  for (int h = 0; h < halfedgeCount(); ++h) {
    // The same bits for both halfedges: a difference turned around changes its signs only.
    layout_[h].length = lengthOf(position(tip(h)) - position(tail(h)));
  }
  for (int h = 0; h < halfedgeCount(); ++h) {
    angle_[h] = angleBetween(length(h), length(previous(h)), length(next(h)));
    angleSum_[tail(h)] += angle_[h];
  }
  for (int f = 0; f < faceCount(); ++f) {
    layOut(std::span<Layout, 3>(&layout_[3 * f], 3));
  }
  faceArea_.resize(faceCount());
  for (int f = 0; f < faceCount(); ++f) {
    const Eigen::Vector3d a = position(tail(3 * f));
    const Eigen::Vector3d ab = position(tail(3 * f + 1)) - a, ac = position(tail(3 * f + 2)) - a;
    faceArea_[f] = ab.cross(ac).norm() / 2;
    area_ += faceArea_[f];
  }
  for (const Layout& layout : layout_) meanEdgeLength_ += layout.length / halfedgeCount();
}

void TriangleMesh::countTopology(int components) {
  const int boundaryEdges = static_cast<int>(std::count(twin_.begin(), twin_.end(), -1));
  topology_.edges = (halfedgeCount() + boundaryEdges) / 2;
  topology_.components = components;
  topology_.eulerCharacteristic = vertexCount() - topology_.edges + faceCount();

  std::vector<char> seen(vertexCount(), false);
  for (int start = 0; start < vertexCount(); ++start) {
    if (!onBoundary(start) || seen[start]) continue;
    boundaryLoops_.push_back(outgoing(start));
    for (int v = start; !seen[v]; v = tip(outgoing(v))) seen[v] = true;
  }
  topology_.boundaryLoops = static_cast<int>(boundaryLoops_.size());
  topology_.genus = (2 * components - topology_.boundaryLoops - topology_.eulerCharacteristic) / 2;
}

// --- Measures of the surface -------------------------------------------------------------------

Eigen::Vector3d TriangleMesh::position(const SurfacePoint& p) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) sum += p.bary[i] * position(tail(3 * p.face + i));
  return sum;
}

double TriangleMesh::boundingDiagonal() const {
  return lengthOf(positions_.rowwise().maxCoeff() - positions_.rowwise().minCoeff());
}

// --- To and from the input ---------------------------------------------------------------------

SurfacePoint TriangleMesh::toInput(const SurfacePoint& p) const {
  SurfacePoint input{inputFace_[p.face], p.bary};
  if (isFlipped(p.face)) std::swap(input.bary[1], input.bary[2]);
  return input;
}

SurfacePoint TriangleMesh::fromInput(const SurfacePoint& p) const {
  if (p.face < 0 || p.face >= inputFaceCount()) {
    rejectPoint("there is no triangle " + std::to_string(p.face));
  }
  const std::array<int, 3>& halfedges = faceOfInput_[p.face];
  if (halfedges[0] < 0) {
    rejectPoint("triangle " + std::to_string(p.face) +
                " was dropped and no other triangle has its points");
  }
  const Eigen::Vector3d bary = cleanBarycentric(p.bary);
  SurfacePoint q{faceOf(halfedges[0]), Eigen::Vector3d::Zero()};
  for (int i = 0; i < 3; ++i) q.bary[halfedges[i] % 3] += bary[i];
  return q;
}

SurfacePoint TriangleMesh::fromInputVertex(int inputVertex) const {
  if (inputVertex < 0 || inputVertex >= inputVertexCount()) {
    rejectPoint("there is no vertex " + std::to_string(inputVertex));
  }
  const int h = vertexOfInput_[inputVertex];
  if (h < 0) rejectPoint("no triangle of the surface uses vertex " + std::to_string(inputVertex));
  return {faceOf(h), Eigen::Vector3d::Unit(h % 3)};
}

}  // namespace gvd
