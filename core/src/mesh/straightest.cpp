// SPDX-License-Identifier: MIT
// This work is based on:
// Konrad Polthier, Markus Schmies. Straightest Geodesics on Polyhedral Surfaces. 1998
#include "gvd/straightest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/plane.h"
#include "base/tolerances.h"
#include "mesh/face_layout.h"
#include "mesh/given_points.h"

namespace gvd {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;

/// A walk that gets on by less than this share of the mean edge while it crosses the whole mesh is
/// kept in place by rounding: 2^22 times the rounding of an edge.
constexpr double kLeastProgress = 0x1p-30;

double angleOf(const Vector2d& v) { return std::atan2(v.y(), v.x()); }

/// Walks from face to face, in a direction in the coordinates of a side of the current face
/// (`face_layout.h`), a halfedge. The current point is on that halfedge, except at a start inside a
/// face. Points within a face are interpolated between points on its sides: nothing is divided by
/// the height of a face, which may be tiny.
class Walk {
 public:
  Walk(const TriangleMesh& mesh, const SurfacePoint& start, const Vector2d& move,
       AtBoundary atBoundary)
      : mesh_(mesh),
        atBoundary_(atBoundary),
        remaining_(move.norm()),
        halfedge_(3 * start.face),
        bary_(start.bary) {
    if (!(remaining_ > 0) || !std::isfinite(remaining_)) {
      remaining_ = 0;
      return;
    }
    direction_ = move / remaining_;
    frame_ = turnedBackBy({1, 0}, direction_);
    Eigen::Index nearest, farthest;
    if (bary_.maxCoeff(&nearest) >= 1 - kVertexSnap)
      startAtVertex(3 * start.face + static_cast<int>(nearest));
    else if (bary_.minCoeff(&farthest) <= kVertexSnap)
      startOnEdge(3 * start.face + cornerAfter(static_cast<int>(farthest)));
  }

  StraightestGeodesic run() {
    // A line that moves at all leaves the star of any vertex in this many crossings.
    const int stretch = mesh_.halfedgeCount() + 16;
    // Needed because a line may wind around a spike millions of times.
    const long most = kMostCrossings + 16L * mesh_.halfedgeCount();
    double before = -std::numeric_limits<double>::infinity();
    for (long crossings = 0; remaining_ > 0 && crossings < most; ++crossings) {
      if (crossings % stretch == 0) {
        if (walked_ - before < kLeastProgress * mesh_.meanEdgeLength()) break;
        before = walked_;
      }
      if (isAlongEdge_)
        goAlongEdge();
      else
        crossFace();
    }
    toCoordinatesOf(3 * TriangleMesh::faceOf(halfedge_));
    const Vector2d frame = turnedBy(frame_, direction_).normalized();
    return {{TriangleMesh::faceOf(halfedge_), bary_}, frame, walked_, metBoundary_};
  }

 private:
  static constexpr long kMostCrossings = 1 << 16;  ///< and more on larger meshes

  // --- Coordinates ---

  /// The direction of a side of the current face in the coordinates of the current one.
  Vector2d axisOf(int side) const {
    if (side == halfedge_) return {1, 0};
    const TriangleMesh::Face& face = mesh_.face(TriangleMesh::faceOf(halfedge_));
    const int tail = halfedge_ % 3, tip = cornerAfter(tail);
    return side % 3 == tip ? Vector2d(-face.cosines[tip], face.sines[tip])
                           : Vector2d(-face.cosines[tail], -face.sines[tail]);
  }

  void toCoordinatesOf(int side) {
    if (side == halfedge_) return;
    direction_ = turnedBackBy(direction_, axisOf(side)).normalized();
    halfedge_ = side;
  }

  // --- Steps ---

  /// Walks a length along a line to a point of the current face, or to the end of the walk if that
  /// is nearer. Returns whether the point is reached.
  bool advance(double length, const Eigen::Vector3d& to) {
    if (length >= remaining_) {
      bary_ += (remaining_ / length) * (to - bary_);
      walked_ += remaining_;
      remaining_ = 0;
      return false;
    }
    bary_ = to;
    walked_ += length;
    remaining_ -= length;
    return true;
  }

  void crossFace() {
    const TriangleMesh::Face& face = mesh_.face(TriangleMesh::faceOf(halfedge_));
    const int first = halfedge_ % 3, second = cornerAfter(first), third = cornerBefore(first);
    const std::array<Vector2d, 3> corners = {Vector2d(0, 0), Vector2d(face.lengths[first], 0),
                                             apexOf(face, first)};
    const std::array<int, 3> sides = {halfedge_, TriangleMesh::next(halfedge_),
                                      TriangleMesh::previous(halfedge_)};
    const bool isOnHalfedge = bary_[third] == 0;
    const Vector2d here = bary_[second] * corners[1] + bary_[third] * corners[2];
    std::array<double, 3> left;  // signed distances of the corners, positive left of the line
    for (int i = 0; i < 3; ++i) left[i] = cross(direction_, corners[i] - here);
    int leaving;  // the side where the line leaves the face, never the one where it enters
    if (isOnHalfedge) {
      if (direction_.y() <= kVertexSnap) return startAlongEdge(halfedge_, direction_.x() > 0);
      leaving = left[2] > 0 ? 1 : 2;
    } else {
      leaving = 0;
      while (leaving < 3 && !(left[leaving] <= 0 && left[cornerAfter(leaving)] > 0)) ++leaving;
    }
    if (leaving == 3) {
      // By rounding, all corners are on one side of the line: it leaves a thin face at the corner
      // that is farthest ahead.
      int ahead = 0;
      for (int i = 1; i < 3; ++i)
        if ((corners[i] - corners[ahead]).dot(direction_) > 0) ahead = i;
      return goToCorner(sides[ahead], corners[ahead] - here);
    }
    const int i = leaving, j = cornerAfter(i);
    const double share = left[i] / (left[i] - left[j]);
    if (share <= kVertexSnap) return goToCorner(sides[i], corners[i] - here);
    if (share >= 1 - kVertexSnap) return goToCorner(sides[j], corners[j] - here);
    const Vector2d there = corners[i] + share * (corners[j] - corners[i]);
    Eigen::Vector3d bary = Eigen::Vector3d::Zero();
    bary[sides[i] % 3] = 1 - share;
    bary[sides[j] % 3] = share;
    if (advance(std::max(0.0, (there - here).dot(direction_)), bary)) crossEdge(sides[i], share);
  }

  void goToCorner(int corner, const Vector2d& path) {
    if (!advance(path.norm(), Eigen::Vector3d::Unit(corner % 3))) return;
    toCoordinatesOf(corner);
    // Not always within the corner's angle: the line may have come in closely beside the vertex.
    const double middle = mesh_.cornerAngle(corner) / 2;
    passVertex(corner, middle + angleOf(turnedBackBy(-direction_, unitVector(middle))));
  }

  void startOnEdge(int side) {
    bary_[cornerBefore(side % 3)] = 0;
    bary_ /= bary_.sum();
    toCoordinatesOf(side);
    if (direction_.y() < -kVertexSnap) crossEdge(side, bary_[cornerAfter(side % 3)]);
  }

  void crossEdge(int side, double share) {
    toCoordinatesOf(side);
    const int twin = mesh_.twin(side);
    if (twin < 0) {
      metBoundary_ = true;
      if (atBoundary_ == AtBoundary::kStop) {
        remaining_ = 0;
        return;
      }
      const bool forward = direction_.x() > 0;
      turnTo({forward ? 1.0 : -1.0, 0}, std::abs(direction_.x()));
      startAlongEdge(side, forward);
      return;
    }
    halfedge_ = twin;
    bary_.setZero();
    bary_[twin % 3] = share;
    bary_[cornerAfter(twin % 3)] = 1 - share;
    direction_ = -direction_;
    direction_.y() = std::max(0.0, direction_.y());  // into the face, whatever rounding says
  }

  /// Turns the direction but not the carried frame, and shortens the rest of the walk.
  void turnTo(const Vector2d& direction, double factor) {
    frame_ = turnedBackBy(turnedBy(frame_, direction_), direction);
    direction_ = direction;
    remaining_ *= factor;
  }

  void startAlongEdge(int side, bool forward) {
    halfedge_ = side;
    direction_ = {forward ? 1.0 : -1.0, 0};
    isAlongEdge_ = true;
  }

  void goAlongEdge() {
    isAlongEdge_ = false;
    const bool forward = direction_.x() > 0;
    const int from = halfedge_ % 3, to = cornerAfter(from);
    const int end = forward ? to : from;
    const double length = mesh_.length(halfedge_) * (1 - bary_[end]);
    if (!advance(length, Eigen::Vector3d::Unit(end))) return;
    const int corner = forward ? TriangleMesh::next(halfedge_) : halfedge_;
    passVertex(corner, forward ? mesh_.cornerAngle(corner) : 0);
  }

  // --- Vertices ---
  // Angles are counted counterclockwise from TriangleMesh::outgoing.

  double angleBefore(int corner) const {
    double angle = 0;
    for (int h = mesh_.outgoing(mesh_.tail(corner)); h != corner; h = mesh_.rotate(h))
      angle += mesh_.cornerAngle(h);
    return angle;
  }

  void startAtVertex(int corner) {
    bary_ = Eigen::Vector3d::Unit(corner % 3);
    toCoordinatesOf(corner);
    const int vertex = mesh_.tail(corner);
    double angle = std::fmod(angleBefore(corner) + angleOf(direction_), 2 * pi);
    if (angle < 0) angle += 2 * pi;
    if (mesh_.onBoundary(vertex))
      leaveBoundaryVertex(vertex, angle);
    else
      leaveVertex(vertex, angle < mesh_.angleSum(vertex) ? angle : 0);
  }

  /// Passes a vertex; the way back is at angle `back` from the corner's halfedge.
  void passVertex(int corner, double back) {
    const int vertex = mesh_.tail(corner);
    const double from = angleBefore(corner) + back;
    if (mesh_.onBoundary(vertex)) {
      leaveBoundaryVertex(vertex, from + pi);
    } else {
      const double sum = mesh_.angleSum(vertex), straight = std::fmod(from + sum / 2, sum);
      leaveVertex(vertex, straight < 0 ? straight + sum : straight);
    }
  }

  /// Leaves at angle `straight`, or at 2π less, which is the same direction: the surface may have
  /// one of these angles, both or none.
  void leaveBoundaryVertex(int vertex, double straight) {
    const double sum = mesh_.angleSum(vertex);
    if (straight <= sum + kVertexSnap) return leaveVertex(vertex, std::min(straight, sum));
    if (straight >= 2 * pi - kVertexSnap)
      return leaveVertex(vertex, std::max(0.0, straight - 2 * pi));
    metBoundary_ = true;
    const bool toLast = straight - sum < 2 * pi - straight;
    const double turn = toLast ? sum - straight : 2 * pi - straight;
    const double factor = std::cos(turn);
    if (atBoundary_ == AtBoundary::kStop || factor <= 0) {
      remaining_ = 0;
      return;
    }
    frame_ = turnedBackBy(frame_, unitVector(turn));
    remaining_ *= factor;
    leaveVertex(vertex, toLast ? sum : 0);
  }

  void leaveVertex(int vertex, double angle) {
    int corner = mesh_.outgoing(vertex);
    const int first = corner;
    for (;;) {
      const double own = mesh_.cornerAngle(corner);
      const int next = mesh_.rotate(corner);
      if (angle < own - kVertexSnap || next < 0) break;
      angle = std::max(0.0, angle - own);
      corner = next;
      if (corner == first) break;  // rounding: once around
    }
    bary_ = Eigen::Vector3d::Unit(corner % 3);
    halfedge_ = corner;
    if (angle <= kVertexSnap) {
      startAlongEdge(corner, true);
    } else if (angle >= mesh_.cornerAngle(corner) - kVertexSnap) {
      startAlongEdge(TriangleMesh::previous(corner), false);
    } else {
      direction_ = unitVector(angle);
    }
  }

  const TriangleMesh& mesh_;
  const AtBoundary atBoundary_;
  double remaining_;
  double walked_ = 0;
  bool metBoundary_ = false;
  int halfedge_;  ///< of the current face; `direction_` is in its coordinates
  Eigen::Vector3d bary_;
  Vector2d direction_ = {1, 0};
  Vector2d frame_ = {1, 0};  ///< the start's x axis, seen with the direction as x axis
  bool isAlongEdge_ = false;
};

}  // namespace

StraightestGeodesic walkStraight(const TriangleMesh& mesh, const SurfacePoint& start,
                                 const Eigen::Vector2d& move, AtBoundary atBoundary) {
  return Walk(mesh, onMesh(mesh, start), move, atBoundary).run();
}

}  // namespace gvd
