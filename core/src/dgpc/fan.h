// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "base/prefetch.h"
#include "dgpc/dgpc_view.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Of the line from a view's source to its vertex.
enum class Side { kLeft, kRight };

/// Whether a direction lies on the given side of another one, or along it: what just passes a
/// vertex must not depend on rounding. `turn` is their cross product, `along` the dot product.
template <Side side>
bool isTowards(double turn, double along) {
  constexpr double kGrazing = 1e-12;  // of a radian
  return (side == Side::kLeft ? turn : -turn) >= -kGrazing * std::abs(along);
}

template <Side side>
bool isTowards(const Eigen::Vector2d& from, const Eigen::Vector2d& direction) {
  return isTowards<side>(cross(from, direction), from.dot(direction));
}

/// A face in the fan around a view's vertex, unfolded beside the view's own face: in the view's
/// frame, but with the vertex as the origin. The fan enters the face through a halfedge that has
/// the vertex as its inner end.
struct FanFace {
  int halfedge;
  Eigen::Vector2d outward;  ///< unit vector along the halfedge, towards its outer end
  Eigen::Vector2d outer, apex;
  /// Where the apex lies: the fan may begin before the direct line from the source to its vertex,
  /// and what lies behind that line, continued beyond the vertex, is met from the other side.
  enum class Place { kBefore, kInSight, kBehind } place;
};

/// What carries a vector of a fan to the frame of the halfedge through which it enters a face: that
/// frame's x axis.
template <Side side>
Eigen::Vector2d axisOf(const FanFace& face) {
  return side == Side::kLeft ? Eigen::Vector2d(-face.outward) : face.outward;
}

/// A point of a fan in the frame of the halfedge through which it enters a face.
template <Side side>
Eigen::Vector2d inFrameOf(const FanFace& face, const TriangleMesh& mesh,
                          const Eigen::Vector2d& point) {
  Eigen::Vector2d p = turnedBackBy(point, axisOf<side>(face));
  if (side == Side::kLeft) p.x() += mesh.length(face.halfedge);
  return p;
}

/// What a view shows through the halfedge by which a fan enters a face, without limits. `path`
/// leads from the view's source to the fan's vertex.
template <Side side>
View viewThrough(const TriangleMesh& mesh, const View& view, const Eigen::Vector2d& path,
                 const FanFace& face) {
  const Eigen::Vector2d axis = axisOf<side>(face);
  View next;
  next.source = inFrameOf<side>(face, mesh, -path);
  next.heading = view.isBent() ? view.heading : turnedBackBy(view.heading, axis);
  if (view.isBent()) next.toSite = turnedBackBy(view.toSite, axis);
  next.offset = view.offset;
  next.halfedge = face.halfedge;
  next.detour = view.detour;
  return next;
}

/// The same where the path to the face's apex bends once more, at `bend` from the view's source.
template <Side side>
View viewFromBend(const TriangleMesh& mesh, const View& view, const Eigen::Vector2d& path,
                  const FanFace& face, const Eigen::Vector2d& bend) {
  const double toBend = bend.norm();
  View next;
  next.source = inFrameOf<side>(face, mesh, bend - path);
  next.heading = view.departure(bend / toBend);
  next.toSite = turnedBackBy(view.toSite - bend, axisOf<side>(face));
  next.offset = view.offset + toBend;
  next.halfedge = face.halfedge;
  next.detour = view.detourAfter(bend, path + face.apex - bend);
  return next;
}

template <Side side>
int outerEnd(const FanFace& face, const TriangleMesh& mesh) {
  return side == Side::kLeft ? mesh.tail(face.halfedge) : mesh.tip(face.halfedge);
}

/// What of one side of a fan is in sight. Paths that bend do so at the vertex that hides the rest.
/// All vectors are from the view's source.
template <Side side>
class Sight {
 public:
  explicit Sight(const View& view) : bound_(side == Side::kLeft ? view.left : view.right) {}

  /// Takes into account a vertex that limits views.
  void limit(const Eigen::Vector2d& way) {
    if (isUnlimited() || reaches(way)) bound_ = way;
  }

  bool isUnlimited() const { return bound_ == Eigen::Vector2d(0, 0); }

  bool reaches(const Eigen::Vector2d& way) const {
    return isUnlimited() || isTowards<kInward>(bound_, way);
  }

  /// Whether it is limited by the vertex there.
  bool isAt(const Eigen::Vector2d& way) const { return bound_ == way; }

  /// Whether what is hidden is reached from the limiting vertex through a face's entry, and not
  /// beside that. From an end of the entry itself paths go on without this view.
  bool reachesAround(const FanFace& face, const Eigen::Vector2d& path,
                     const Eigen::Vector2d& way) const {
    if (isAt(path + face.outer)) return false;
    const Eigen::Vector2d axis = axisOf<side>(face);
    return cross(axis, bound_ - path) < 0 &&
           isTowards<kInward>(path + face.outer - bound_, way - bound_);
  }

  /// To the vertex that limits the sight; zero if none does.
  const Eigen::Vector2d& bound() const { return bound_; }

 private:
  static constexpr Side kInward = side == Side::kLeft ? Side::kRight : Side::kLeft;

  Eigen::Vector2d bound_;
};

/// Asks for the memory of what walkFan reads of the faces around the apex of a halfedge, and calls
/// `visit` with the vertices there, for what else is to be asked for.
template <class Visit>
void prefetchFan(const TriangleMesh& mesh, int halfedge, Visit visit) {
  constexpr int kMostFaces = 8;  // more would come too late
  const int first = TriangleMesh::previous(halfedge);
  prefetch(mesh.layout(halfedge));
  int h = first;
  for (int i = 0; i < kMostFaces; ++i) {
    prefetch(mesh.layout(h));
    visit(mesh.tip(h));
    h = mesh.rotate(h);
    if (h < 0 || h == first) return;
  }
}

/// How far one side of a fan goes: at least to a face, given by its index, or
inline constexpr int kToFirstBehind = -1;  ///< to the first face that is left behind
inline constexpr int kToBoundary = -2;     ///< to the mesh boundary

/// Visits the faces on one side of a view around its vertex: up to the first one that is left
/// behind, and on to `last`, unless the boundary is met or the fan closes. Returns the first face
/// that is left behind; kToBoundary if there is none. `path` leads from the view's source to the
/// vertex.
template <Side side, class Visit>
int walkFan(const TriangleMesh& mesh, const View& view, const Eigen::Vector2d& path, int last,
            Visit visit) {
  using Eigen::Vector2d;
  using Place = FanFace::Place;
  constexpr bool kLeft = side == Side::kLeft;
  const auto isOutward = [&](const Vector2d& point) {
    return isTowards<side>(cross(path, point), path.dot(path + point));
  };
  const TriangleMesh::Layout& own = mesh.layout(view.halfedge);
  int over = kLeft ? TriangleMesh::previous(view.halfedge) : TriangleMesh::next(view.halfedge);
  FanFace face;
  face.apex = {kLeft ? -own.x : own.length - own.x, -own.y};
  double inverse = mesh.layout(over).inverse;  // of the edge that is crossed next
  Place next = isOutward(face.apex) ? Place::kInSight : Place::kBefore;
  int firstBehind = kToBoundary;
  bool hasPassedLast = last == kToFirstBehind;
  for (;;) {
    face.halfedge = mesh.twin(over);
    if (face.halfedge < 0) return firstBehind;
    const int index = TriangleMesh::faceOf(face.halfedge);
    if (index == TriangleMesh::faceOf(view.halfedge)) return firstBehind;
    over = kLeft ? TriangleMesh::next(face.halfedge) : TriangleMesh::previous(face.halfedge);
    // Of the halfedge here that leaves the vertex: measured from there, nothing is lost where the
    // face is small. It is all that is read of the face, for memory is what this waits for.
    const TriangleMesh::Layout& l = mesh.layout(kLeft ? over : face.halfedge);
    face.outer = face.apex;
    face.outward = face.outer * (2 * (kLeft ? inverse : l.inverse));
    if (kLeft) {
      face.apex = turnedBackBy(face.outward, Vector2d(l.x, l.y) * (2 * inverse)) * l.length;
      inverse = l.inverse;
    } else {
      face.apex = {l.x * face.outward.x() - l.y * face.outward.y(),
                   l.x * face.outward.y() + l.y * face.outward.x()};
    }
    face.place = next;
    const bool apexIsOutward = isOutward(face.apex);
    if (next == Place::kBefore && apexIsOutward) next = Place::kInSight;
    if (next == Place::kInSight && face.place == next && !apexIsOutward) {
      face.place = next = Place::kBehind;
      firstBehind = index;
    }
    visit(static_cast<const FanFace&>(face));
    hasPassedLast |= index == last;
    if (next == Place::kBehind && hasPassedLast) return firstBehind;
  }
}

}  // namespace gvd
