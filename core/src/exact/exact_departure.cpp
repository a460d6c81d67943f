// SPDX-License-Identifier: MIT
#include "exact/exact_departure.h"

#include <cmath>

#include "base/plane.h"
#include "distance/site_frame.h"

namespace gvd::exact {
namespace {

using Eigen::Vector2d;

/// A direction in a face, in the coordinates of one of its halfedges.
class Direction {
 public:
  Direction(std::span<const Frame> frames, int halfedge, const Vector2d& vector)
      : frames_(frames), halfedge_(halfedge), vector_(vector) {}

  /// In the coordinates of another halfedge of the face.
  void turnTo(int halfedge) {
    const Frame& frame = frames_[halfedge_ / 3];
    while (halfedge_ != halfedge) {
      halfedge_ = TriangleMesh::next(halfedge_);
      const int corner = halfedge_ % 3;
      vector_ = turnedBy(-vector_, {frame.cosine[corner], frame.sine[corner]});
    }
  }

  /// In the face on the other side of the halfedge.
  void cross() {
    halfedge_ = frames_[halfedge_ / 3].twin[halfedge_ % 3];
    vector_ = -vector_;
  }

  int halfedge() const { return halfedge_; }
  const Vector2d& vector() const { return vector_; }

 private:
  std::span<const Frame> frames_;
  int halfedge_;
  Vector2d vector_;
};

/// From a place on a side of a face to the corner across from it, in the coordinates of the side.
Vector2d toApex(const Frame& frame, int i, double place) {
  return {frame.apexX(i) - place, frame.apexY(i)};
}

/// From the source of a window to where the path that an entry stands for passes the window.
Vector2d throughWindow(const Window& w, const Entry& e) {
  // A path that bends at an end of the window goes on along the halfedge, and arrives across one of
  // the two others.
  const double place = e.arrival == w.halfedge                       ? e.crossing
                       : e.arrival == TriangleMesh::next(w.halfedge) ? w.begin
                                                                     : w.end;
  return {place - w.x, -w.y};
}

/// The halfedge of a face that leaves one of its vertices.
int outgoing(const Frame& frame, int face, int vertex) {
  int i = 0;
  while (frame.vertex[i] != vertex) ++i;
  return 3 * face + i;
}

/// In the frame of a site at a vertex; the direction is in the coordinates of a halfedge that
/// leaves the vertex.
Vector2d inFrameOfVertex(const TriangleMesh& mesh, const SurfacePoint& site,
                         const Direction& direction) {
  return turnedBy(direction.vector(),
                  unitVector(angleOfOutgoing(mesh, site, direction.halfedge())));
}

/// In the frame of a site in a face, or on a side: then the direction may be in the face beside it.
Vector2d inFrameOfFace(std::span<const Frame> frames, const SurfacePoint& site,
                       Direction direction) {
  if (direction.halfedge() / 3 != site.face) {
    direction.turnTo(frames[site.face].twin[placeOf(site.bary).side]);
    direction.cross();
  }
  direction.turnTo(3 * site.face);
  return direction.vector();
}

}  // namespace

Vector2d departure(const TriangleMesh& mesh, const SurfacePoint& site,
                   std::span<const Frame> frames, const WindowPool& windows,
                   const VertexTable& table, int entry) {
  for (;;) {
    const Entry& e = table[entry];
    if (e.arrival < 0) return {1, 0};
    // The last piece of the path, up to where it bends or starts.
    const bool isThroughWindow = e.origin >= 0;
    int origin = e.origin;
    Direction direction(frames, e.arrival,
                        toApex(frames[e.arrival / 3], e.arrival % 3, e.crossing));
    if (isThroughWindow) {
      direction = Direction(frames, windows[origin].halfedge, throughWindow(windows[origin], e));
      for (;;) {
        origin = windows[origin].origin;
        direction.cross();
        if (origin < 0) break;
        direction.turnTo(windows[origin].halfedge);
      }
    }
    if (origin == kFromSite) return inFrameOfFace(frames, site, direction).normalized();
    const Entry& source = table[entryOf(origin)];
    if (source.arrival < 0) {
      direction.turnTo(
          outgoing(frames[direction.halfedge() / 3], direction.halfedge() / 3, source.vertex));
      return inFrameOfVertex(mesh, site, direction).normalized();
    }
    entry = entryOf(origin);
  }
}

}  // namespace gvd::exact
