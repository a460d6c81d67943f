// SPDX-License-Identifier: MIT
#include "distance/exact/fan_behind.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/plane.h"
#include "mesh/building/mollification.h"

namespace gvd::exact {

using Eigen::Vector2d;

namespace {

/// How far rounding may move the ends of a fan, as a share of the sides that they lie on. Seen from
/// a vertex of a needle, whose sides are 2^36 times as long as it is wide, that may leave a gap
/// wide enough for a shortest path.
constexpr double kFanRounding = 0x1p-50;

/// The largest angle by which rounding may turn a path more sharply than the shortest one: the root
/// in `sides`, for a last piece as short as the thinnest face is wide.
const double kMostTurned = std::sqrt(2 * kFanRounding / kMollificationMargin);

}  // namespace

bool isSaddle(const TriangleMesh& mesh, int vertex) {
  // Angle sums are rounded: an inner vertex that is flat within rounding needs no virtual source. A
  // boundary vertex that is straight within rounding is one, since lines along the boundary may
  // miss the faces beyond it.
  constexpr double kRounding = 1e-12, kPi = std::numbers::pi;
  return mesh.angleSum(vertex) >
         (mesh.onBoundary(vertex) ? kPi - kMostTurned : 2 * kPi + kRounding);
}

double FanBehind::oppositeLength(int outgoing) const {
  return mesh_.face(outgoing / 3).lengths[cornerAfter(outgoing % 3)];
}

/// Where a ray from the vertex meets the opposite side, from the tip of the outgoing halfedge,
/// which is the x axis.
double FanBehind::meetOpposite(int outgoing, const Vector2d& direction) const {
  const TriangleMesh::Face& f = mesh_.face(outgoing / 3);
  const int i = outgoing % 3, j = cornerAfter(i);
  const double numerator = f.lengths[i] * direction.y();
  const double denominator = direction.x() * f.sines[j] + direction.y() * f.cosines[j];
  if (!(numerator > 0)) return 0;
  return denominator * f.lengths[j] > numerator ? numerator / denominator : f.lengths[j];
}

/// Adds up the angles of successive faces until the turn, begun with the angle of cosine and sine
/// `turned`, exceeds π.
template <class OutgoingAt>
FanBehind::Turn FanBehind::turnByPi(Vector2d turned, int steps, OutgoingAt outgoingAt) const {
  for (int step = 1; step < steps; ++step) {
    const int o = outgoingAt(step);
    const Vector2d angle(mesh_.face(o / 3).cosines[o % 3], mesh_.face(o / 3).sines[o % 3]);
    const Vector2d next = turnedBy(turned, angle);
    if (next.y() < 0) return {step, {-turned.x(), turned.y()}};
    turned = next;
  }
  return {};
}

std::span<const OppositeSide> FanBehind::sides(int vertex, int arrival, double fromFoot) {
  const std::span<const int> fan = mesh_.fan(vertex);
  const bool isClosed = !mesh_.onBoundary(vertex);
  sides_.clear();
  if (arrival < 0) {
    for (const int o : fan) sides_.push_back({o, 0, oppositeLength(o)});
    return sides_;
  }
  const int n = static_cast<int>(fan.size());
  int in = 0;  // where the path comes from
  while (fan[in] / 3 != arrival / 3) ++in;
  const auto leftwards = [&](int step) { return fan[(in + step) % n]; };
  const auto rightwards = [&](int step) { return fan[(in - step + n) % n]; };

  const TriangleMesh::Face& face = mesh_.face(fan[in] / 3);
  const int i = fan[in] % 3;
  const double c = face.cosines[i], s = face.sines[i];
  const double foot = face.lengths[i] * face.cosines[cornerAfter(i)];
  const double share = (foot + fromFoot) / face.lengths[cornerAfter(i)];
  const double toPrevious = share * face.lengths[cornerBefore(i)];
  Vector2d back((1 - share) * face.lengths[i] + toPrevious * c, toPrevious * s);
  // A path that leaves at π - a on one side is longer than the shortest one by a² / 2 times the
  // length of its last piece. Up to `angle`, that is within rounding, so the fan is wider by it.
  // None of its paths is too short.
  const double angle = std::min(kMostTurned, std::sqrt(2 * rounding_ / back.norm()));
  back.normalize();
  const auto widened = [&](double x, double y) { return Vector2d(x - angle * y, y + angle * x); };
  const Turn left =
      turnByPi(widened(c * back.x() + s * back.y(), std::max(0.0, s * back.x() - c * back.y())),
               isClosed ? n : n - in, leftwards);
  const Turn right =
      turnByPi(widened(back.x(), std::max(0.0, back.y())), isClosed ? n : in + 1, rightwards);
  const auto from = [&](int step) {
    if (step != left.step) return 0.0;
    const int o = leftwards(step);
    return std::max(0.0, meetOpposite(o, left.rest) - kFanRounding * oppositeLength(o));
  };
  const auto to = [&](int step) {  // measured from the other side of its face
    const int o = rightwards(step);
    const double length = oppositeLength(o);
    if (step != right.step) return length;
    const double cosine = mesh_.face(o / 3).cosines[o % 3], sine = mesh_.face(o / 3).sines[o % 3];
    const Vector2d& rest = right.rest;
    const Vector2d ray(cosine * rest.x() + sine * rest.y(), sine * rest.x() - cosine * rest.y());
    return std::min(length, meetOpposite(o, ray) + kFanRounding * length);
  };
  if (isClosed) {
    if (left.step < 0 || right.step < 0) return sides_;
    for (int step = left.step; step <= n - right.step; ++step)
      sides_.push_back({leftwards(step), from(step), to(n - step)});
    return sides_;
  }
  if (left.step >= 0)
    for (int step = left.step; step < n - in; ++step)
      sides_.push_back({leftwards(step), from(step), oppositeLength(leftwards(step))});
  if (right.step >= 0)
    for (int step = right.step; step <= in; ++step)
      sides_.push_back({rightwards(step), 0, to(step)});
  return sides_;
}

}  // namespace gvd::exact
