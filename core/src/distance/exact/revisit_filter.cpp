// SPDX-License-Identifier: MIT
// This work is based on:
// Micha Sharir, Amir Schorr. On Shortest Paths in Polyhedral Spaces. 1986
#include "distance/exact/revisit_filter.h"

#include <algorithm>

#include "distance/straight_line.h"

namespace gvd::exact {
namespace {

/// A line followed back ends at its virtual source up to rounding: a share of the line's length. A
/// face rounds by a few 2^-53, so this is enough for a million faces.
constexpr double kLineRounding = 1e-9;

}  // namespace

RevisitFilter::RevisitFilter(const TriangleMesh& mesh) : mesh_(mesh) {
  if (!mesh.needles().empty()) isNeedle_.resize(mesh.faceCount(), false);
  for (const int f : mesh.needles()) isNeedle_[f] = true;
}

bool RevisitFilter::dropsSuspicious(const Window& w, int halfedge) {
  if (backtracksLeft_ <= 0 && random_() % static_cast<unsigned long>(lastBacktracks_) != 0)
    return false;
  const long before = crossedBack_;
  const bool isDropped = entersAgain(w, halfedge);
  lastBacktracks_ = crossedBack_ - before;
  backtracksLeft_ -= lastBacktracks_;
  return isDropped;
}

/// All lines of a window have crossed the same faces, so it is enough to follow the middle one
/// backwards, and only for twice the longest side of the face: a line that comes back after a
/// longer way is longer than the way over a corner of the face, and ends by its length alone.
bool RevisitFilter::entersAgain(const Window& w, int halfedge) {
  StraightLine line{halfedge, (w.begin + w.end) / 2, {w.x, w.y}};
  const auto& [a, b, c] = mesh_.face(halfedge / 3).lengths;
  const double length = line.length();
  const double least = std::max(kLineRounding * length, length - 2 * std::max({a, b, c}));
  for (int crossed = 0; crossed < mesh_.faceCount(); ++crossed) {
    ++crossedBack_;
    if (!line.enterFace(mesh_) || line.length() < least) return false;
    if (line.halfedge / 3 == halfedge / 3) return true;
    if (!line.crossFace(mesh_)) return false;
  }
  return true;
}

}  // namespace gvd::exact
