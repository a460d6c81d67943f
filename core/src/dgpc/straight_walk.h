// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <utility>

#include "base/plane.h"
#include "gvd/triangle_mesh.h"
#include "mesh/unfolding.h"

namespace gvd {

/// Where the apex of a halfedge is, in the halfedge's frame.
inline Eigen::Vector2d apexOf(const TriangleMesh& mesh, int halfedge) {
  const TriangleMesh::Layout& l = mesh.layout(halfedge);
  return {l.x, l.y};
}

/// Whether two directions are the same but for rounding: on which side of one the other lies then
/// must not matter. Of their cross and dot products, or of themselves.
inline bool isGrazing(double turn, double along) {
  constexpr double kGrazing = 1e-12;  // of a radian
  return std::abs(turn) <= kGrazing * std::abs(along);
}

inline bool isGrazing(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return isGrazing(cross(a, b), a.dot(b));
}

/// A face that a walk comes to, laid out as seen from where the walk begins.
struct WalkStep {
  int entry;                          ///< the face's halfedge that it is entered through
  Eigen::Vector2d left, right, apex;  ///< the ends of that one, as seen on the way, and its apex
  Eigen::Vector2d leftBound, rightBound;  ///< of what is seen through all that was passed

  bool isInSight(const Eigen::Vector2d& place) const {
    return cross(rightBound, place) >= 0 && cross(place, leftBound) >= 0;
  }
};

/// Where a line leads through a vertex, it may be led past on either side.
enum class AtVertex { kStop, kPass };

/// Walks along a straight line from the apex of a halfedge, given in the halfedge's frame, up to
/// the first face of which `isEnd` says so, by the halfedge that it is entered through and the apex
/// of that. Nothing if the line ends before, or at the boundary. `goThrough` is told of the
/// halfedges that the walk leaves faces through, the one it ends at included.
template <class GoThrough, class IsEnd>
std::optional<WalkStep> walkStraight(const TriangleMesh& mesh, int halfedge,
                                     const Eigen::Vector2d& line, AtVertex atVertex,
                                     GoThrough goThrough, IsEnd isEnd) {
  using Eigen::Vector2d;
  const double length = line.squaredNorm();
  if (!(length > 0)) return std::nullopt;
  Vector2d right = -apexOf(mesh, halfedge);
  Vector2d left = right + Vector2d(mesh.length(halfedge), 0);
  int over = halfedge;
  // Where the line leaves beside the halfedge, it does so through another face around the vertex.
  const Vector2d here(0, 0);
  const bool isRightOf = cross(right, line) < 0;
  while (isRightOf ? cross(right, line) < 0 : cross(line, left) < 0) {
    const int side = isRightOf ? TriangleMesh::previous(over) : TriangleMesh::next(over);
    const int entry = mesh.twin(side);
    if (entry < 0 || TriangleMesh::faceOf(entry) == TriangleMesh::faceOf(halfedge))
      return std::nullopt;
    goThrough(side);
    if (isRightOf)
      left = std::exchange(right, apexBeside(mesh, entry, right, here));
    else
      right = std::exchange(left, apexBeside(mesh, entry, here, left));
    over = isRightOf ? TriangleMesh::previous(entry) : TriangleMesh::next(entry);
  }
  Vector2d leftBound = left, rightBound = right;
  constexpr double kBeyond = 1.2;  // the line may be a little short of where it leads
  bool isLeftBeyond = false, isRightBeyond = false;
  for (int steps = 0; steps < mesh.faceCount(); ++steps) {
    const int entry = mesh.twin(over);
    if (entry < 0) return std::nullopt;
    goThrough(over);
    const Vector2d apex = apexBeside(mesh, entry, left, right);
    if (isEnd(entry, apex)) return WalkStep{entry, left, right, apex, leftBound, rightBound};
    const double turn = cross(line, apex), along = line.dot(apex);
    if (atVertex == AtVertex::kStop && isGrazing(turn, along)) return std::nullopt;
    const bool isBeyond = along > kBeyond * length;
    if (turn > 0) {
      left = apex;
      if (cross(left, leftBound) > 0) leftBound = left;
      isLeftBeyond = isBeyond;
      over = TriangleMesh::next(entry);
    } else {
      right = apex;
      if (cross(rightBound, right) > 0) rightBound = right;
      isRightBeyond = isBeyond;
      over = TriangleMesh::previous(entry);
    }
    if (isLeftBeyond && isRightBeyond) return std::nullopt;
  }
  return std::nullopt;
}

/// The same for those who need not know what the walk goes through.
template <class IsEnd>
std::optional<WalkStep> walkStraight(const TriangleMesh& mesh, int halfedge,
                                     const Eigen::Vector2d& line, AtVertex atVertex, IsEnd isEnd) {
  return walkStraight(
      mesh, halfedge, line, atVertex, [](int) {}, isEnd);
}

}  // namespace gvd
