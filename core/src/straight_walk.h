// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "gvd/triangle_mesh.h"
#include "plane.h"
#include "unfolding.h"

namespace gvd {

/// Where the apex of a halfedge is, in the halfedge's frame.
inline Eigen::Vector2d apexOf(const TriangleMesh& mesh, int halfedge) {
  const TriangleMesh::Layout& l = mesh.layout(halfedge);
  return {l.x, l.y};
}

/// Whether two directions are the same but for rounding: on which side of one the other lies then
/// must not matter.
inline bool isGrazing(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  constexpr double kGrazing = 1e-12;  // of a radian
  return std::abs(cross(a, b)) <= kGrazing * std::abs(a.dot(b));
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

/// Walks along a straight line from the apex of a halfedge, given in the halfedge's frame, and
/// notes what it goes through, up to the first face of which `isEnd` says so, by the halfedge that
/// it is entered through and the apex of that. Nothing if the line ends before, or at the boundary.
template <class IsEnd>
std::optional<WalkStep> walkStraight(const TriangleMesh& mesh, int halfedge,
                                     const Eigen::Vector2d& line, AtVertex atVertex,
                                     std::vector<int>& through, IsEnd isEnd) {
  using Eigen::Vector2d;
  through.clear();
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
    through.push_back(side);
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
    through.push_back(over);
    const Vector2d apex = apexBeside(mesh, entry, left, right);
    if (isEnd(entry, apex)) return WalkStep{entry, left, right, apex, leftBound, rightBound};
    if (atVertex == AtVertex::kStop && isGrazing(line, apex)) return std::nullopt;
    const bool isBeyond = line.dot(apex) > kBeyond * length;
    if (cross(line, apex) > 0) {
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

}  // namespace gvd
