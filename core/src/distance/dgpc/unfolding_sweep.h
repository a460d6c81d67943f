// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "base/plane.h"
#include "base/tolerances.h"
#include "distance/face_layout.h"
#include "gvd/geodesic.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::dgpc {

/// A virtual source, given by the ways from it to the corners of a face.
struct Unfolding {
  Eigen::Vector2d toTail, toTip, toApex;
};

/// The virtual source behind a halfedge of a length, from the ends of which it has these distances,
/// in the coordinates of the halfedge (y <= 0); nothing if there is none.
inline std::optional<Eigen::Vector2d> virtualSource(double length, double atTail, double atTip) {
  if (!(atTail < kInfinity && atTip < kInfinity)) return std::nullopt;
  const double x = ((atTail - atTip) * (atTail + atTip) + length * length) / (2 * length);
  const double squaredY = atTail * atTail - x * x;
  if (squaredY < -kUnfoldingRounding * atTail * atTail) return std::nullopt;
  return Eigen::Vector2d(x, -std::sqrt(std::max(squaredY, 0.0)));
}

/// Whether that source may be nearer to the apex than a distance; false only if it is not. Let the
/// two be d apart along the side, and y and a away from its line: they lie on opposite sides of it,
/// so their squared distance is d² + (y + a)². What is compared is d² + y² + a², times the side's
/// length: without a root or a quotient.
inline bool mayBeNearer(const TriangleMesh::Face& face, int side, double atTail, double atTip,
                        double distance) {
  const double length = face.lengths[side], toApex = face.lengths[cornerBefore(side)];
  const double twiceX = (atTail - atTip) * (atTail + atTip) + length * length;  // times the length
  return (atTail * atTail + toApex * toApex - distance * distance) * length <
         toApex * face.cosines[side] * twiceX;
}

/// The virtual source behind a side of a face that has these distances from its two ends,
/// in the coordinates of the side; nothing unless it exists and sees the apex through the side.
inline std::optional<Unfolding> unfold(const TriangleMesh::Face& face, int side, double atTail,
                                       double atTip) {
  const double length = face.lengths[side];
  const auto source = virtualSource(length, atTail, atTip);
  if (!source) return std::nullopt;
  const Unfolding u = {-*source, Eigen::Vector2d(length, 0) - *source,
                       apexOf(face, side) - *source};
  // The line from the source to the apex crosses the side's line between its ends.
  const double slack = kUnfoldingRounding * length * u.toApex.y();
  if (cross(u.toApex, u.toTail) < -slack || cross(u.toTip, u.toApex) < -slack) return std::nullopt;
  return u;
}

/// Geodesic polar coordinates of one site after another (Melvær & Reimers 2012): at each vertex a
/// distance and the direction at the site. Both follow from those at two other corners of a face,
/// by unfolding a virtual source, or else along an edge. A vertex that has passed its distance on
/// may get a better one and pass that on again (label-correcting), which makes the distances exact
/// in the plane where the way is free, obtuse triangles included. What one site costs depends on
/// how far it spreads only.
///
/// Where paths bend, virtual sources contradict each other, and two vertices next to each other
/// could lower their distances by turns, a little each time. So a distance does not go back to a
/// vertex that it came from; and the least share by which a vertex's distance has to improve
/// doubles each time, which ends longer cycles as well, after at most 41 improvements.
class UnfoldingSweep {
 public:
  /// Up to which distance a site spreads on from a vertex; not asked for again before the next site
  /// starts.
  using Reach = std::function<double(int vertex)>;

  UnfoldingSweep(const TriangleMesh& mesh, Reach reach)
      : mesh_(mesh),
        reach_(std::move(reach)),
        bucketsPerUnit_(kBucketsPerEdge / mesh.meanEdgeLength()),
        vertices_(mesh.vertexCount()) {}

  /// Begins with a site; what the last one has reached is forgotten.
  void start(const SurfacePoint& site);
  /// Passes on at most `budget` distances and lowers it by their number. True when there is none
  /// left.
  bool run(long& budget);

  /// The vertices that the site has reached; it may not have spread on from them.
  const std::vector<int>& reached() const { return reached_; }
  /// Infinite where the site has not come to.
  double distance(int vertex) const {
    return isReached(vertex) ? vertices_[vertex].distance : kInfinity;
  }
  /// The direction of the path at the site (`DistanceField::direction`), where the site has come
  /// to.
  const Eigen::Vector2d& direction(int vertex) const { return vertices_[vertex].direction; }

 private:
  /// Buckets of the queue per mean edge: what is passed on in the wrong order within a bucket is
  /// passed on again.
  static constexpr double kBucketsPerEdge = 8;

  /// The two ends of the side, or twice the vertex, that a distance follows from; -1 for a site.
  using Origin = std::array<int, 2>;

  struct alignas(64) Vertex {
    double distance;
    double limit;  ///< what a distance has to fall below to be an improvement
    double reach;  ///< up to which distance it is passed on
    Eigen::Vector2d direction;
    Origin origin;              ///< what the distance follows from
    int epoch = 0;              ///< of the site that this is about
    std::uint8_t improvements;  ///< how often the distance has become less
    bool isQueued;              ///< whether it still passes on its distance

    /// Whether the distance follows from that of another vertex.
    bool followsFrom(int other) const { return origin[0] == other || origin[1] == other; }
  };

  void startInFace(const SurfacePoint& site, const Eigen::Vector2d& firstSide);
  bool isReached(int vertex) const { return vertices_[vertex].epoch == epoch_; }
  double limit(int vertex) const { return isReached(vertex) ? vertices_[vertex].limit : kInfinity; }
  void offer(int vertex, double distance, const Eigen::Vector2d& direction, const Origin& origin);
  void passOn(int vertex);
  void unfoldAcross(const TriangleMesh::Face& face, int side);
  static Eigen::Vector2d directionToApex(const Unfolding& unfolding, const Vertex& tail,
                                         const Vertex& tip);

  const TriangleMesh& mesh_;
  const Reach reach_;
  const double bucketsPerUnit_;
  int epoch_ = 0;
  std::vector<Vertex> vertices_;
  std::vector<int> reached_;
  std::vector<std::vector<int>> buckets_;  ///< vertices by distance
  size_t bucket_ = 0, cursor_ = 0;
};

}  // namespace gvd::dgpc
