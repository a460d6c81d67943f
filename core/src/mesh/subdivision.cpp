// SPDX-License-Identifier: MIT
#include "gvd/subdivision.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "base/index_pairs.h"
#include "base/number_text.h"
#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "gvd/surface_point.h"
#include "mesh/face_metric.h"
#include "mesh/given_triangles.h"

namespace gvd {
namespace {

using Eigen::Vector3d;

void requireValid(const SubdivisionOptions& options) {
  if (!(options.maxEdge > 0 && options.maxEdge <= 1))
    rejectArgument("maxEdge is " + numberText(options.maxEdge) + ", not above 0 and at most 1");
  if (options.maxTriangles < 1)
    rejectArgument("maxTriangles is " + std::to_string(options.maxTriangles) + ", not positive");
}

/// Subdivides twice: first the parts are only counted, so that there is room for them, or an error,
/// before the first of them is made.
class Subdivision final : public SequentialWork<SubdividedTriangles> {
 public:
  Subdivision(std::vector<double> positions, std::vector<int> triangles,
              const SubdivisionOptions& options)
      : options_(options), triangles_(std::move(triangles)) {
    requireValid(options);
    requireTriples(positions.size(), triangles_.size());
    out_.positions = std::move(positions);
  }

  bool advance(long budget) override {
    return sequence_.run(
        forEach(triangles_.size() / 3, budget, kQuickRounds,
                [&](int t) {
                  requireVertices(triangles_, t, vertexCount());
                  for (int i = 0; i < 3; ++i)
                    if (const Vector3d p = place(triangles_[3 * t + i]); p.allFinite())
                      box_.extend(p);
                }),
        [&] { findLongest(); }, [&] { return splitAll(budget); }, [&] { reserve(); },
        [&] { return midpoints_.prepare(addedParts(), budget); }, [&] { hasRoom_ = true; },
        [&] { return splitAll(budget); });
  }
  SubdividedTriangles result() override {
    out_.ends = midpoints_.take();
    return std::move(out_);
  }

 private:
  struct Corner {
    Vector3d place;
    int vertex;  ///< -1 while parts are only counted
  };
  using Part = std::array<Corner, 3>;

  /// Not below a multiple of what coordinates are rounded by: there, halves may be as long as a
  /// side.
  void findLongest() {
    constexpr double kResolution = 0x1p-48;
    const double farthest = box_.min().cwiseAbs().cwiseMax(box_.max().cwiseAbs()).maxCoeff();
    longest_ = std::max({options_.maxEdge * box_.diagonal().norm(), kResolution * farthest,
                         std::numeric_limits<double>::min()});
  }

  int vertexCount() const { return static_cast<int>(out_.positions.size() / 3); }
  Vector3d place(int v) const { return positionOf(out_.positions, v); }

  /// Counts the parts of all triangles, or makes them once there is room.
  bool splitAll(long& budget) {
    constexpr int kPartsPerUnit = 4;
    const int triangles = static_cast<int>(triangles_.size() / 3);
    while (next_ < triangles || !open_.empty()) {
      if (budget-- <= 0) return false;
      for (int i = 0; i < kPartsPerUnit && (next_ < triangles || !open_.empty()); ++i) {
        if (open_.empty()) open_.push_back(given(next_++));
        const Part part = open_.back();
        open_.pop_back();
        if (split(part)) continue;
        if (hasRoom_)
          add(part);
        else
          count();
      }
    }
    next_ = 0;
    return true;
  }

  Part given(int t) const {
    const int* const v = &triangles_[3 * static_cast<std::size_t>(t)];
    return {Corner{place(v[0]), v[0]}, Corner{place(v[1]), v[1]}, Corner{place(v[2]), v[2]}};
  }

  /// Replaces a part that has long sides by smaller ones; false if it has none, or a corner is not
  /// finite.
  bool split(const Part& part) {
    std::array<bool, 3> isSplit;
    for (int i = 0; i < 3; ++i) {
      const double length = (part[cornerAfter(i)].place - part[i].place).norm();
      if (!std::isfinite(length)) return false;
      isSplit[i] = length > longest_;
    }
    const int splits = isSplit[0] + isSplit[1] + isSplit[2];
    if (splits == 0) return false;
    // Side i is the only long one, or the only short one.
    int i = 0;
    while (splits < 3 && isSplit[i] != (splits == 1)) ++i;
    const Corner &a = part[i], &b = part[cornerAfter(i)], &c = part[cornerBefore(i)];
    if (splits == 1) {
      const Corner ab = halve(a, b);
      push({Part{a, ab, c}, Part{ab, b, c}});
    } else if (splits == 2) {
      const Corner bc = halve(b, c), ca = halve(c, a);
      const bool isFromA = isFirstDiagonalTaken((bc.place - a.place).squaredNorm(),
                                                (ca.place - b.place).squaredNorm());
      push({Part{a, b, isFromA ? bc : ca}, Part{isFromA ? a : b, bc, ca}, Part{ca, bc, c}});
    } else {
      const Corner ab = halve(a, b), bc = halve(b, c), ca = halve(c, a);
      push({Part{a, ab, ca}, Part{ab, b, bc}, Part{ab, bc, ca}, Part{ca, bc, c}});
    }
    return true;
  }
  void push(std::initializer_list<Part> parts) {
    open_.insert(open_.end(), std::rbegin(parts), std::rend(parts));
  }

  void count() {
    if (partCount_++ < options_.maxTriangles) return;
    rejectArgument("with no edge longer than " + numberText(options_.maxEdge) +
                   " of the diagonal, there would be more than " +
                   std::to_string(options_.maxTriangles) + " triangles");
  }

  /// Makes room for the parts, and for a midpoint each, of which there are about half as many.
  void reserve() {
    const std::size_t parts = partCount_, added = addedParts();
    out_.triangles.reserve(3 * parts);
    out_.parents.reserve(parts);
    out_.positions.reserve(out_.positions.size() + 3 * added);
  }
  std::size_t addedParts() const { return partCount_ - triangles_.size() / 3; }

  /// The middle of a side: the same bits from both ends, and so in all triangles of the side.
  /// Halves are added, because the sum of the ends may overflow.
  Corner halve(const Corner& a, const Corner& b) {
    const Vector3d p = a.place / 2 + b.place / 2;
    return {p, hasRoom_ ? midpointOf(a.vertex, b.vertex, p) : -1};
  }

  /// The vertex at a midpoint, added if it is not there yet.
  int midpointOf(int a, int b, const Vector3d& p) {
    const int count = midpoints_.size(), given = vertexCount() - count;
    const int midpoint = midpoints_.add(a, b);
    if (midpoint == count) out_.positions.insert(out_.positions.end(), p.begin(), p.end());
    return given + midpoint;
  }

  void add(const Part& part) {
    for (const Corner& corner : part) out_.triangles.push_back(corner.vertex);
    out_.parents.push_back(next_ - 1);
  }

  const SubdivisionOptions options_;
  const std::vector<int> triangles_;  ///< as given

  Eigen::AlignedBox3d box_;
  double longest_ = 0;      ///< sides longer than this are halved
  int next_ = 0;            ///< triangle
  std::vector<Part> open_;  ///< parts of the last triangle, not looked at yet, the next one last
  int partCount_ = 0;
  bool hasRoom_ = false;
  IndexPairs midpoints_;  ///< by the ends of their sides
};

}  // namespace

std::unique_ptr<SlicedWork<SubdividedTriangles>> startSubdivision(
    std::vector<double> positions, std::vector<int> triangles, const SubdivisionOptions& options) {
  return std::make_unique<Subdivision>(std::move(positions), std::move(triangles), options);
}

SubdividedTriangles subdivide(std::vector<double> positions, std::vector<int> triangles,
                              const SubdivisionOptions& options) {
  return finished(startSubdivision(std::move(positions), std::move(triangles), options));
}

}  // namespace gvd
