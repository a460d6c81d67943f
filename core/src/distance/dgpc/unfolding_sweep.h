// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/bucket_queue.h"
#include "base/plane.h"
#include "base/sliced_loop.h"
#include "gvd/geodesic.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"
#include "mesh/face_layout.h"

namespace gvd::dgpc {

/// How far rounding may move an unfolded point beyond an end or the line of a halfedge, as a share
/// of lengths.
inline constexpr double kUnfoldingRounding = 1e-12;

/// A virtual source, given by the vectors from it to the corners of a face.
struct Unfolding {
  Eigen::Vector2d toTail, toTip, toApex;
};

/// The virtual source behind a halfedge of a given length, by its distances from the two ends, in
/// the coordinates of the halfedge (y <= 0). None if a distance is unknown, or if they violate the
/// triangle inequality by more than rounding.
inline std::optional<Eigen::Vector2d> virtualSource(double length, double atTail, double atTip) {
  if (!(atTail < kInfinity && atTip < kInfinity)) return std::nullopt;
  const double x = ((atTail - atTip) * (atTail + atTip) + length * length) / (2 * length);
  const double squaredY = atTail * atTail - x * x;
  if (squaredY < -kUnfoldingRounding * atTail * atTail) return std::nullopt;
  return Eigen::Vector2d(x, -std::sqrt(std::max(squaredY, 0.0)));
}

/// Whether the virtual source behind a side, if there is one, sees the apex through the side: at
/// each end, the angles of source and apex to the side add up to at most 180 degrees, so their
/// cosines to at least 0. The law of cosines gives the one of the source; the sums are multiplied
/// by twice the side and the distance, which needs no quotient. A path past an end is longer than
/// one over it by the square of the angle between them, so rounding matters no more here than in
/// distances. False where a distance is infinite.
inline bool seesApex(const TriangleMesh::Face& face, int side, double atTail, double atTip) {
  const double length = face.lengths[side], square = length * length;
  const double difference = (atTail - atTip) * (atTail + atTip);
  return face.cosines[side] * atTail * (2 * length) + (square + difference) >= 0 &&
         face.cosines[cornerAfter(side)] * atTip * (2 * length) + (square - difference) >= 0;
}

/// Whether the virtual source behind a side, if there is one, is nearer to the apex than
/// `distance`, up to rounding. Source and apex lie on opposite sides of the side's line. If they
/// are d apart along it and y and a away from it, their squared distance is d² + y² + a² + 2ya.
/// `left` is `distance`² less the first three terms, times the length. Unless it is positive, the
/// source is not nearer: for half of the sides that see their apex, that saves the quotients. Else
/// it is compared with the last term, both squared, which saves the root. No product has more than
/// four lengths as factors: it might overflow.
inline bool isNearer(const TriangleMesh::Face& face, int side, double atTail, double atTip,
                     double distance) {
  const double length = face.lengths[side], toApex = face.lengths[cornerBefore(side)];
  const double twiceX = (atTail - atTip) * (atTail + atTip) + length * length;  // times the length
  const double left = toApex * face.cosines[side] * twiceX -
                      (atTail * atTail + toApex * toApex - distance * distance) * length;
  if (!(left > 0)) return false;
  const double x = twiceX / (2 * length), height = toApex * face.sines[side], rest = left / length;
  return !(4 * (atTail * atTail - x * x) * height * height >= rest * rest);
}

/// The virtual source behind a side of a face, by its distances from the side's ends, in the
/// coordinates of the side. None unless it exists, sees the apex through the side, and is nearer to
/// it than `distance`.
inline std::optional<Unfolding> unfold(const TriangleMesh::Face& face, int side, double atTail,
                                       double atTip, double distance) {
  if (!seesApex(face, side, atTail, atTip) || !isNearer(face, side, atTail, atTip, distance))
    return std::nullopt;
  const auto source = virtualSource(face.lengths[side], atTail, atTip);
  if (!source) return std::nullopt;
  return Unfolding{-*source, Eigen::Vector2d(face.lengths[side], 0) - *source,
                   apexOf(face, side) - *source};
}

/// Geodesic polar coordinates of one site after another (Melvær & Reimers 2012): at each vertex a
/// distance and the direction at the site. Both are computed from the values at the other two
/// corners of a face by unfolding a virtual source, or else along an edge. A vertex that has passed
/// on its distance may get a shorter one and pass it on again (label-correcting). This makes
/// distances exact in the plane where the straight line is free, obtuse triangles included. A site
/// costs time only for the part of the mesh that it reaches.
///
/// Where paths bend, virtual sources are inconsistent, and neighbouring vertices could lower each
/// other's distances forever, a little each time. So the relative improvement that a vertex
/// requires doubles with each improvement, from 2^-41 on (`kDistanceTolerance`), which allows at
/// most 41.
class UnfoldingSweep {
 public:
  explicit UnfoldingSweep(const TriangleMesh& mesh)
      : mesh_(mesh), queue_(kBucketsPerEdge / mesh.shortEdgeLength()) {}
  /// Allocates the working memory, in slices; true when it is there. Before anything else.
  bool prepare(long& budget) {
    return fillInSlices(vertices_, mesh_.vertexCount(), Vertex(), budget);
  }

  /// Sets the distance up to which sites spread on from a vertex; infinity at first.
  void setReach(int vertex, double reach) { vertices_[vertex].reach = reach; }
  /// Begins with a site and forgets the previous one. A `reach` given here is that of all vertices,
  /// in place of their own.
  void start(const SurfacePoint& site, std::optional<double> reach = std::nullopt);
  /// The reach given to `start`.
  const std::optional<double>& reach() const { return reach_; }
  /// Passes on the distances of at most `budget` vertices and lowers it by their number. True when
  /// none is queued any more.
  bool step(long& budget);

  /// The vertices that the site has reached, including those beyond their reach.
  const std::vector<int>& reached() const { return reached_; }
  /// Infinite at vertices that the site has not reached.
  double distance(int vertex) const { return vertices_[vertex].distance; }
  /// The direction of the path at the site (`DistanceField::direction`); for reached vertices only.
  const Eigen::Vector2d& direction(int vertex) const { return vertices_[vertex].direction; }

 private:
  /// Buckets of the queue per short edge. Within a bucket, vertices come in the order of queueing;
  /// a distance that was passed on too early is passed on again once it falls.
  static constexpr double kBucketsPerEdge = kMostBucketsPerEdge;

  struct alignas(64) Vertex {
    double distance = kInfinity;
    double improvesBelow = kInfinity;  ///< for rounding, a little below the distance
    double reach = kInfinity;  ///< the largest distance that is passed on, whatever the site
    Eigen::Vector2d direction;
    std::uint8_t improvements;  ///< how often the distance has fallen
    bool isQueued;              ///< whether the distance is still to be passed on
  };

  void startInFace(const SurfacePoint& site, const Eigen::Vector2d& firstSide);
  void startAcross(const SurfacePoint& site, int side);
  /// Inlined, because most offers are no improvement.
  void offer(int vertex, double distance, const Eigen::Vector2d& direction) {
    if (distance < vertices_[vertex].improvesBelow) improve(vertex, distance, direction);
  }
  void improve(int vertex, double distance, const Eigen::Vector2d& direction);
  void passOn(int vertex);
  int nearestNeighbour(std::span<const int> fan) const;
  void unfoldAcross(int h);
  static Eigen::Vector2d directionToApex(const Unfolding& unfolding, const Vertex& tail,
                                         const Vertex& tip);

  const TriangleMesh& mesh_;
  std::optional<double> reach_;  ///< of all vertices, in place of their own
  std::vector<Vertex> vertices_;
  std::vector<int> reached_;
  BucketQueue queue_;  ///< vertices by distance
};

}  // namespace gvd::dgpc
