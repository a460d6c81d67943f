// SPDX-License-Identifier: MIT
//
// The lower envelope on a triangle, built by inserting one linear function after another: each cuts
// its cell out of the existing ones.
#include "diagram/graph/face_envelope.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/predicates.h"

namespace gvd {

/// The common zero of b - a and c - a is their cross product, up to scale. It is computed with a
/// bounded relative error, because it cancels almost entirely if the functions are almost equal
/// along a line, as for two sites next to each other: rounding would put the place anywhere on the
/// line and fold cells over each other. No coordinate is negative and not all are zero: the place
/// is in the triangle, and raising functions to break ties does not change the sum of the
/// coordinates.
void FaceEnvelope::setInnerBary(const Vertex& v, Eigen::Vector3d& bary) const {
  const auto &a = value(v.functions[0]), &b = value(v.functions[1]), &c = value(v.functions[2]);
  for (int i = 0; i < 3; ++i) {
    const int j = cornerAfter(i), k = cornerBefore(i);
    bary[i] = determinant({a[j], a[k]}, {b[j], b[k]}, {c[j], c[k]});
  }
  bary /= bary.sum();
}

/// Whether f is less than the envelope at a vertex. f has a higher label than everything inserted
/// so far, hence a tie means no.
bool FaceEnvelope::isBelow(int f, const Vertex& v) const {
  if (v.kind == Vertex::kGone) return false;
  const auto &a = value(v.functions[0]), &c = value(f);
  if (v.kind == Vertex::kCorner) return c[v.place] < a[v.place];
  const auto& b = value(v.functions[1]);
  if (v.kind == Vertex::kOnSide) {
    const int i = v.place, j = cornerAfter(i);
    return orientation({a[i], a[j]}, {b[i], b[j]}, {c[i], c[j]}) < 0;
  }
  return orientation(a, b, value(v.functions[2]), c) < 0;
}

/// Most triangles have one cell or two; `cut_` finds these without any lists.
void FaceEnvelope::compute(std::span<const LabelFunction> functions) {
  functions_ = functions;
  const int count = static_cast<int>(functions.size());
  cut_ = {};
  int f = 1;
  while (f < count && !cutTriangle(f)) ++f;
  for (++f; f < count && !isBelowCut(f);) ++f;
  buildCut();
  if (f >= count) return;
  for (; f < count; ++f) insert(f);
  findSegments();
}

/// Updates `cut_` by f while one function, `cut_.low`, has all of the triangle: f may replace it,
/// or take a part.
bool FaceEnvelope::cutTriangle(int f) {
  const auto &a = value(cut_.low), &c = value(f);
  const std::array<bool, 3> isBelow = {c[0] < a[0], c[1] < a[1], c[2] < a[2]};
  const int count = isBelow[0] + isBelow[1] + isBelow[2];
  if (count == 0) return false;
  if (count == 3) {
    cut_.low = f;
    return false;
  }
  cut_.high = f;
  cut_.isHigh = isBelow;
  return true;
}

/// Whether f is below the envelope anywhere, while `cut_` is all of the envelope.
bool FaceEnvelope::isBelowCut(int f) const {
  bool isBelowAnywhere = false;
  for (int i = 0; i < 3; ++i) {
    const int here = cut_.functionAt(i), next = cut_.functionAt(cornerAfter(i));
    isBelowAnywhere |= value(f)[i] < value(here)[i];
    if (here != next) isBelowAnywhere |= isBelow(f, {Vertex::kOnSide, i, {here, next, -1}});
  }
  return isBelowAnywhere;
}

/// Turns `cut_` into lists: walks around the triangle and adds each corner and crossing to the
/// cells that have it.
void FaceEnvelope::buildCut() {
  const bool isCut = cut_.high >= 0;
  const auto [low, high, isHigh] = cut_;
  const int ofLow = isCut ? 5 - isHigh[0] - isHigh[1] - isHigh[2] : 3;  // sides
  vertices_.resize(isCut ? 5 : 3);
  sides_.resize(isCut ? 7 : 3);
  cells_.resize(isCut ? 2 : 1);
  segments_.resize(isCut ? 1 : 0);
  std::array<CellSide*, 2> next = {sides_.data(), sides_.data() + ofLow};
  int crossing = 3;
  for (int i = 0; i < 3; ++i) {
    const bool ofHigh = isHigh[i];
    const int here = ofHigh ? high : low, after = ofHigh ? low : high;
    vertices_[i] = {Vertex::kCorner, i, {here, -1, -1}};
    *next[ofHigh]++ = {i, across(i)};
    if (isHigh[cornerAfter(i)] == ofHigh) continue;
    vertices_[crossing] = {Vertex::kOnSide, i, {here, after, -1}};
    *next[ofHigh]++ = {crossing, after};
    *next[!ofHigh]++ = {crossing, across(i)};
    if (!ofHigh) segments_[0] = {crossing, 7 - crossing, low, high};
    ++crossing;
  }
  cells_[0] = {low, 0, ofLow};
  if (isCut) cells_[1] = {high, ofLow, 7};
}

/// Each segment is a side of two cells, of which the first has the lower label.
void FaceEnvelope::findSegments() {
  segments_.clear();
  for (const Cell& cell : cells_) {
    const std::span<const CellSide> sides = this->sides(cell);
    for (size_t i = 0; i < sides.size(); ++i)
      if (const auto [vertex, across] = sides[i]; across > cell.function) {
        const int next = sides[i + 1 < sides.size() ? i + 1 : 0].vertex;
        segments_.push_back({vertex, next, cell.function, across});
      }
  }
}

/// The new vertex where f's cell cuts the side of `cell` that goes from `from` to `to`; one vertex
/// for both cells of the side.
int FaceEnvelope::cutVertex(const Cell& cell, const CellSide& from, const CellSide& to,
                            bool toIsBelow, int f) {
  const int other = from.across;
  if (isTriangleSide(other)) {
    const int before = toIsBelow ? cell.function : f, after = toIsBelow ? f : cell.function;
    vertices_.push_back({Vertex::kOnSide, triangleSide(other), {before, after, -1}});
    return static_cast<int>(vertices_.size()) - 1;
  }
  for (const CutSide& cut : cuts_)
    if (cut.from == to.vertex && cut.to == from.vertex) return cut.vertex;
  // `cell` is on the left of the side and `other` on its right; f takes over ahead or behind.
  if (toIsBelow)
    vertices_.push_back({Vertex::kInside, -1, {f, cell.function, other}});
  else
    vertices_.push_back({Vertex::kInside, -1, {f, other, cell.function}});
  const int vertex = static_cast<int>(vertices_.size()) - 1;
  cuts_.push_back({from.vertex, to.vertex, vertex});
  return vertex;
}

/// Cuts f's cell from another one: a convex cell gives up one run of its vertices, and the cut
/// closes both parts.
void FaceEnvelope::cutCell(const Cell& cell, int f) {
  const std::span<const CellSide> sides = this->sides(cell);
  int entry = -1, exit = -1;  // where the outline of the part given up starts and ends
  for (size_t s = 0; s < sides.size(); ++s) {
    const CellSide from = sides[s], to = sides[s + 1 < sides.size() ? s + 1 : 0];
    const bool fromBelow = below_[from.vertex], toBelow = below_[to.vertex];
    if (!fromBelow) kept_.push_back(from);
    int start = from.vertex, end = to.vertex;
    if (fromBelow != toBelow) {
      const int vertex = cutVertex(cell, from, to, toBelow, f);
      if (toBelow) {
        entry = start = vertex;
        kept_.push_back({vertex, f});
      } else {
        exit = end = vertex;
        kept_.push_back({vertex, from.across});
      }
    }
    if ((fromBelow || toBelow) && isTriangleSide(from.across))
      links_.push_back({start, end, from.across});
  }
  if (entry >= 0) links_.push_back({exit, entry, cell.function});
}

/// Adds one function, whose cell is cut from the others.
void FaceEnvelope::insert(int f) {
  below_.clear();
  for (const Vertex& v : vertices_) below_.push_back(static_cast<char>(isBelow(f, v)));
  if (std::find(below_.begin(), below_.end(), true) == below_.end()) return;

  links_.clear();
  cuts_.clear();
  kept_.clear();
  size_t remaining = 0;
  for (const Cell& cell : cells_) {
    const int begin = static_cast<int>(kept_.size());
    cutCell(cell, f);
    const int end = static_cast<int>(kept_.size());
    if (begin < end) cells_[remaining++] = {cell.function, begin, end};
  }
  cells_.resize(remaining);
  std::swap(sides_, kept_);
  for (size_t v = 0; v < below_.size(); ++v) {
    if (!below_[v]) continue;
    if (vertices_[v].kind == Vertex::kCorner)
      vertices_[v].functions[0] = f;
    else
      vertices_[v].kind = Vertex::kGone;
  }
  addCellOfLinks(f);
}

void FaceEnvelope::addCellOfLinks(int f) {
  const int begin = static_cast<int>(sides_.size());
  int at = links_[0].from;
  for (size_t i = 0; i < links_.size(); ++i) {
    const auto link =
        std::find_if(links_.begin(), links_.end(), [&](const Link& l) { return l.from == at; });
    if (vertices_[at].kind != Vertex::kGone) sides_.push_back({at, link->across});
    at = link->to;
  }
  cells_.push_back({f, begin, static_cast<int>(sides_.size())});
}

}  // namespace gvd
