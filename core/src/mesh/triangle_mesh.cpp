// SPDX-License-Identifier: MIT
#include "gvd/triangle_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/number_text.h"
#include "gvd/error.h"
#include "mesh/input_map.h"
#include "mesh/mesh_orientation.h"
#include "mesh/mollification.h"
#include "mesh/triangle_selection.h"

namespace gvd {
namespace {

/// How far barycentric coordinates given from outside may be off.
constexpr double kBarycentricTolerance = 1e-6;

/// The products of four lengths that areas are made of neither overflow nor underflow between these
/// limits, however thin the triangles: no edge is shorter than 2^-38 of the mean one, see
/// `kMollificationMargin`.
constexpr double kLongestDiagonal = 0x1p200;
constexpr double kShortestMeanEdge = 0x1p-200;

// --- Points from outside ------------------------------------------------------------------------

[[noreturn]] void rejectPoint(const std::string& why) {
  throw Error(ErrorCode::kInvalidPoint, why);
}

/// What is wrong with barycentric coordinates that may be off by the tolerance; empty if nothing
/// is.
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

/// Non-negative coordinates of sum 1 from such that may be off by the tolerance.
Eigen::Vector3d cleanBarycentric(const Eigen::Vector3d& bary) {
  if (const std::string fault = faultOf(bary); !fault.empty()) rejectPoint(fault);
  const Eigen::Vector3d clamped = bary.cwiseMax(0.0);
  return clamped / clamped.sum();
}

}  // namespace

// --- Construction ------------------------------------------------------------------------------

TriangleMesh::TriangleMesh(std::span<const double> positions, std::span<const int> triangles,
                           const MeshOptions& options) {
  requireValid(options);
  requireIndexedTriangles(positions, triangles);
  const int inputVertexCount = static_cast<int>(positions.size() / 3);
  const std::vector<int> representative = findRepresentatives(positions, triangles, options.weld);
  const std::vector<Corners> welded = weldCorners(triangles, representative);
  Selection selection = selectTriangles(welded, inputVertexCount, repairs_);

  twin_ = matchHalfedges(selection.corners, inputVertexCount, repairs_);
  OrientedComponents oriented =
      orientTriangles(selection.corners, twin_, options.orientation, repairs_);
  dropSmallComponents(options.minComponent, selection, twin_, oriented, repairs_);
  Fans fans = splitFans(selection.corners, twin_, inputVertexCount, repairs_);
  tail_ = std::move(fans.tail);
  vertexHalfedge_ = std::move(fans.outgoing);
  inputVertex_ = std::move(fans.representative);
  inputFace_ = std::move(selection.input);
  flipped_ = std::move(oriented.flipped);
  component_ = std::move(oriented.component);
  repairs_.flippedTriangles = static_cast<int>(std::count(flipped_.begin(), flipped_.end(), true));
  copyPositions(positions);
  measureFaces();
  countTopology(oriented.components);

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
  if (!(boundingDiagonal() <= kLongestDiagonal)) {
    throw Error(ErrorCode::kInvalidMesh, "the positions are too far apart to measure distances");
  }
}

/// Step 8, and everything that follows from edge lengths.
void TriangleMesh::measureFaces() {
  // Coordinates are not centred first: their differences are as good as the input already, and
  // centring would round it.
  const auto triangle = [&](int f) {
    return measureTriangle(
        {position(tail_[3 * f]), position(tail_[3 * f + 1]), position(tail_[3 * f + 2])});
  };
  faces_.resize(faceCount());
  faceArea_.resize(faceCount());
  std::vector<double> leastExcess(faceCount());
  for (int f = 0; f < faceCount(); ++f) {
    const IntrinsicTriangle t = triangle(f);
    setFace(f, t);
    leastExcess[f] = t.leastExcess();
    for (const double length : t.lengths) meanEdgeLength_ += length / halfedgeCount();
  }
  if (!(meanEdgeLength_ >= kShortestMeanEdge)) {
    throw Error(ErrorCode::kInvalidMesh,
                "the positions are too close together to measure distances");
  }

  for (int f = 0; f < faceCount(); ++f) {
    const double longest = *std::max_element(faces_[f].lengths.begin(), faces_[f].lengths.end());
    const double missing = leastExcessWanted(longest, meanEdgeLength_) - leastExcess[f];
    if (missing <= 0) continue;
    ++repairs_.mollifiedTriangles;
    repairs_.mollification = std::max(repairs_.mollification, missing);
  }
  if (repairs_.mollification > 0) {
    for (int f = 0; f < faceCount(); ++f) {
      setFace(f, lengthened(triangle(f), repairs_.mollification));
    }
    meanEdgeLength_ += repairs_.mollification;
  }

  angleSum_.assign(vertexCount(), 0);
  for (int h = 0; h < halfedgeCount(); ++h) angleSum_[tail_[h]] += cornerAngle(h);
  for (const double area : faceArea_) area_ += area;
}

void TriangleMesh::setFace(int f, const IntrinsicTriangle& t) {
  Face& face = faces_[f];
  face.lengths = t.lengths;
  for (int i = 0; i < 3; ++i) {
    const int h = 3 * f + i;
    const double product = t.lengths[i] * t.lengths[previous(i)];
    face.cosines[i] = t.dots[i] / product;
    face.sines[i] = t.twiceArea / product;
    face.vertices[i] = tail_[h];
    face.twins[i] = twin_[h];
    face.angles[i] = std::atan2(t.twiceArea, t.dots[i]);
  }
  faceArea_[f] = t.twiceArea / 2;
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
  return (positions_.rowwise().maxCoeff() - positions_.rowwise().minCoeff()).norm();
}

// --- To and from the input ---------------------------------------------------------------------

SurfacePoint TriangleMesh::toInput(const SurfacePoint& p) const {
  if (p.face < 0) return p;
  SurfacePoint input{inputFace_[p.face], p.bary};
  if (isFlipped(p.face)) std::swap(input.bary[1], input.bary[2]);
  return input;
}

std::string TriangleMesh::faultOfPoint(const SurfacePoint& p) const {
  if (p.face < 0 || p.face >= faceCount()) return "there is no face " + std::to_string(p.face);
  return faultOf(p.bary);
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
