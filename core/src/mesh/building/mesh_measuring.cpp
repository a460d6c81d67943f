// SPDX-License-Identifier: MIT
#include "mesh/building/mesh_measuring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/bucket_queue.h"
#include "base/rejection.h"
#include "gvd/surface_point.h"

namespace gvd {
namespace {

/// Between these limits, the products of four lengths in the formulas of areas neither overflow nor
/// underflow, however thin the triangles: no edge is shorter than 2^-38 of the mean edge, see
/// `kMollificationMargin`.
constexpr double kLongestDiagonal = 0x1p200;
constexpr double kShortestMeanEdge = 0x1p-200;

/// A face is a needle if its shortest side is less than this share of its longest. Around wider
/// faces, a line that winds once more is longer by at least the square of this, 1e-10 of its
/// length: far more than a tie (`kDistanceTolerance`), so its windows end by their length alone.
constexpr double kNeedle = 1e-5;

/// Faces per unit: measuring one takes three arctangents.
constexpr long kMeasuredFaces = 2;

}  // namespace

bool MeshMeasuring::step(long& budget) {
  TriangleMesh& m = mesh_;
  return sequence_.run(
      forEach(m.vertexCount(), budget, kQuickRounds, [&](int v) { box_.extend(m.position(v)); }),
      [&] { requireExtent(); },
      forEach(m.faces_, budget, kMeasuredFaces, [&](int f) { measureFace(f); }),
      [&] { requireEdgeLength(); },
      forItems(maybeFlat_, budget, kMeasuredFaces, [&](int f) { noteFlatness(f); }),
      [&](SlicedLoop& loop) {
        return m.repairs_.mollification == 0 ||
               loop.run(m.faceCount(), budget, kMeasuredFaces, [&](int f) {
                 setFace(f, lengthened(triangle(f), m.repairs_.mollification));
               });
      },
      [&] {
        m.meanEdgeLength_ += m.repairs_.mollification;
        findShortEdgeLength();
      },
      [&] { return fillInSlices(m.angleSum_, m.vertexCount(), 0., budget); },
      [&] { return fillInSlices(m.longestEdge_, m.vertexCount(), 0., budget); },
      forEach(m.faces_, budget, 8, [&](int f) { sumUp(f); }));
}

void MeshMeasuring::requireExtent() {
  const Eigen::Vector3d size = box_.diagonal();
  mesh_.boundingDiagonal_ = std::sqrt(size[0] * size[0] + size[1] * size[1] + size[2] * size[2]);
  if (!(mesh_.boundingDiagonal_ <= kLongestDiagonal))
    rejectMesh("the positions are too far apart to measure distances");
}

void MeshMeasuring::requireEdgeLength() const {
  if (!(mesh_.meanEdgeLength_ >= kShortestMeanEdge))
    rejectMesh("the positions are too close together to measure distances");
}

void MeshMeasuring::findShortEdgeLength() {
  constexpr int kSamples = 4096;
  constexpr double kLeastShare = 1.0 / 256;
  constexpr double kMostBuckets = 0x1p30;
  int step = std::max(1, mesh_.halfedgeCount() / kSamples);
  if (step % 3 == 0) ++step;  // of all sides of faces
  std::vector<double> lengths;
  for (std::int64_t h = 0; h < mesh_.halfedgeCount(); h += step)
    lengths.push_back(mesh_.length(static_cast<int>(h)));
  const auto quartile = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 4);
  std::nth_element(lengths.begin(), quartile, lengths.end());
  // No distance is longer than all edges together.
  const double longest = mesh_.meanEdgeLength_ * mesh_.halfedgeCount();
  mesh_.shortEdgeLength_ = std::max({*quartile, kLeastShare * mesh_.meanEdgeLength_,
                                     longest * kMostBucketsPerEdge / kMostBuckets});
}

/// Coordinates are not centred first: centring would round them, and their differences are as
/// accurate as the input anyway.
IntrinsicTriangle MeshMeasuring::triangle(int face) const {
  const auto& [a, b, c] = mesh_.face(face).vertices;
  return measureTriangle({mesh_.position(a), mesh_.position(b), mesh_.position(c)});
}

void MeshMeasuring::measureFace(int face) {
  const IntrinsicTriangle t = triangle(face);
  setFace(face, t);
  // The mean edge, which is not known yet, is no longer than the diagonal.
  if (t.leastExcess() < leastExcessWanted(t.longestSide(), mesh_.boundingDiagonal_))
    maybeFlat_.push_back(face);
  for (const double length : t.lengths) mesh_.meanEdgeLength_ += length / mesh_.halfedgeCount();
}

void MeshMeasuring::noteFlatness(int face) {
  const IntrinsicTriangle t = triangle(face);
  const double missing =
      leastExcessWanted(t.longestSide(), mesh_.meanEdgeLength_) - t.leastExcess();
  if (missing <= 0) return;
  MeshRepairs& repairs = mesh_.repairs_;
  ++repairs.mollifiedTriangles;
  repairs.mollification = std::max(repairs.mollification, missing);
}

void MeshMeasuring::setFace(int f, const IntrinsicTriangle& t) {
  TriangleMesh::Face& face = mesh_.faces_[f];
  face.lengths = t.lengths;
  for (int i = 0; i < 3; ++i) {
    const double product = t.lengths[i] * t.lengths[cornerBefore(i)];
    face.cosines[i] = t.dots[i] / product;
    face.sines[i] = t.twiceArea / product;
    face.angles[i] = std::atan2(t.twiceArea, t.dots[i]);
  }
  face.area = t.twiceArea / 2;
}

/// Adds a face to the sums and longest edges of its vertices, to those of the mesh, and to the
/// needles. Faces come in order.
void MeshMeasuring::sumUp(int f) {
  for (int h = 3 * f; h < 3 * f + 3; ++h) {
    mesh_.angleSum_[mesh_.tail(h)] += mesh_.cornerAngle(h);
    for (const int v : {mesh_.tail(h), mesh_.tip(h)})
      mesh_.longestEdge_[v] = std::max(mesh_.longestEdge_[v], mesh_.length(h));
  }
  mesh_.area_ += mesh_.faceArea(f);
  const auto& lengths = mesh_.faces_[f].lengths;
  const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
  mesh_.longestOfAll_ = std::max(mesh_.longestOfAll_, *longest);
  if (*shortest < kNeedle * *longest) mesh_.needles_.push_back(f);
}

}  // namespace gvd
