// SPDX-License-Identifier: MIT
// This work is based on:
// Min Tang, Minkyoung Lee, Young Kim. Interactive Hausdorff Distance Computation for General
// Polygonal Models. 2009
//
// The quality of a remesh: angles and valences of its triangles, and distance from the surface.
#include "partition/remesh_quality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "base/index_pairs.h"
#include "base/sliced_loop.h"
#include "gvd/geodesic.h"
#include "gvd/remesh.h"
#include "gvd/surface_point.h"
#include "mesh/triangle_tree.h"

namespace gvd {
namespace {

using Eigen::Vector3d;

// --- Triangles -----------------------------------------------------------------------------------

/// The least angle of a triangle, in degrees; 0 if it has no area.
double leastAngle(const SpaceTriangle& t) {
  double least = std::numbers::pi;
  for (int i = 0; i < 3; ++i) {
    const Vector3d u = t[cornerAfter(i)] - t[i], v = t[cornerBefore(i)] - t[i];
    least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)));
  }
  return least * 180 / std::numbers::pi;
}

double perimeter(const SpaceTriangle& t) {
  const auto& [a, b, c] = t;
  return (b - a).norm() + (c - b).norm() + (a - c).norm();
}

/// Measures the triangles of a remesh.
class TriangleMeasuring final : public SequentialWork<RemeshQuality> {
 public:
  /// The remesh must outlive this.
  explicit TriangleMeasuring(const PolygonMesh& remesh)
      : remesh_(remesh),
        cutting_(startTriangulation(remesh)),
        neighbours_(remesh.positions.size()),
        triangles_(remesh.positions.size()) {}

  bool advance(long budget) override {
    return sequence_.run([&] { return cutting_->step(budget); },
                         [&] {
                           cut_ = cutting_->take().triangles;
                           inSpace_.reserve(cut_.size());
                           out_.triangles = static_cast<int>(cut_.size());
                           if (!cut_.empty()) out_.minAngle = 180;
                         },
                         [&] { return joined_.prepare(2 * cut_.size(), budget); },
                         forEach(cut_, budget, 1, [&](int t) { measure(t); }),
                         forEach(neighbours_, budget, kQuickRounds, [&](int v) { addValence(v); }),
                         [&] {
                           if (inside_ > 0)
                             out_.regularShare = static_cast<double>(regular_) / inside_;
                         });
  }
  double meanSide() const { return perimeters_ / (3 * static_cast<double>(cut_.size())); }
  std::vector<SpaceTriangle> takeInSpace() { return std::move(inSpace_); }

 private:
  void measure(int t) {
    const auto& [a, b, c] = cut_[t];
    const SpaceTriangle& triangle = inSpace_.emplace_back(
        SpaceTriangle{remesh_.positions[a], remesh_.positions[b], remesh_.positions[c]});
    const double angle = leastAngle(triangle);
    out_.minAngle = std::min(out_.minAngle, angle);
    out_.meanMinAngle += angle / out_.triangles;
    perimeters_ += perimeter(triangle);
    for (const int v : cut_[t]) ++triangles_[v];
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const int count = joined_.size();
      if (joined_.add(from, to) < count) continue;
      ++neighbours_[from];
      neighbours_[to] += from != to;
    }
  }

  /// Adds an inner vertex: one with as many triangles as neighbours.
  void addValence(int v) {
    const int valence = neighbours_[v];
    if (valence == 0 || valence != triangles_[v]) return;
    out_.minValence = inside_ == 0 ? valence : std::min(out_.minValence, valence);
    out_.maxValence = std::max(out_.maxValence, valence);
    regular_ += valence == 6;
    ++inside_;
  }

  const PolygonMesh& remesh_;
  std::unique_ptr<SlicedWork<PolygonTriangles>> cutting_;
  std::vector<std::array<int, 3>> cut_;
  std::vector<SpaceTriangle> inSpace_;
  std::vector<int> neighbours_, triangles_;  ///< how many each vertex has
  IndexPairs joined_;                        ///< neighbours
  int inside_ = 0, regular_ = 0;             ///< vertices
  double perimeters_ = 0;                    ///< of all triangles
};

// --- Distance ------------------------------------------------------------------------------------

/// The largest distance of three points from a triangle.
double farthestFrom(const SpaceTriangle& triangle, const SpaceTriangle& points) {
  double most = 0;
  for (const Vector3d& p : points)
    most = std::max(most, nearestOnTriangle(p, triangle).squaredDistance);
  return std::sqrt(most);
}

/// The one-sided Hausdorff distance: the largest distance of a point of some triangles from others,
/// by branch and bound. Triangles and their parts are halved, at their longest sides, as long as
/// one may have a point that is farther by a hundredth than the farthest one found so far, the one
/// with the largest bound first. The distance from one triangle is convex, so no point of a
/// part is farther from it than a corner is: of the triangles nearest to the corners, the best one
/// gives the bound.
class OneSidedHausdorff {
 public:
  /// Trees that are built, and must outlive this. The search is for distances above `least`. Where
  /// both surfaces are the same, it would never end: there are no more than 4096 halvings, and four
  /// for each square of side `resolution` that the triangles' area is worth, up to 4096 squares of
  /// one triangle.
  OneSidedHausdorff(const TriangleTree& from, const TriangleTree& to, double least,
                    double resolution)
      : from_(from),
        to_(to),
        resolution_(resolution),
        distance_(to.triangles().empty() ? kInfinity : least) {}

  bool step(long& budget) {
    constexpr long kUnitsPerPart = 8;  // most of it to search the tree
    for (; distance_ < kInfinity; budget -= kUnitsPerPart) {
      const bool areAllEntered = next_ == from_.triangles().size();
      if (areAllEntered && !isAnyToHalve()) return true;
      if (budget <= 0) return false;
      if (areAllEntered)
        halveNext();
      else
        enter(from_.triangles()[next_++]);
    }
    return true;
  }

  /// The distance of the farthest point found, or `least`; infinite if there is no triangle to
  /// measure from, or a position is not finite.
  double distance() const { return distance_; }

 private:
  /// A few milliseconds' worth: small meshes are searched to the end.
  static constexpr double kLeastHalvings = 4096;

  struct Corner {
    Vector3d position;
    int nearest;  ///< of the other triangles
  };
  struct Part {
    std::array<Corner, 3> corners;
    double bound;  ///< no point is farther
    /// In the order in which parts were made; of equal bounds, the first comes first.
    std::int64_t number;

    bool operator<(const Part& other) const {
      return std::pair(bound, other.number) < std::pair(other.bound, number);
    }
  };

  /// Adds a triangle, unless the one that was nearest last shows that no point of it is farther:
  /// neighbours mostly follow one another, and are near the same.
  void enter(const SpaceTriangle& triangle) {
    constexpr double kHalvingsPerSquare = 4, kMostSquares = 4096;
    const auto& [a, b, c] = triangle;
    if ((a + b + c).allFinite() &&
        !mayBeFarther(farthestFrom(to_.triangles()[lastNearest_], triangle)))
      return;
    const double area = (b - a).cross(c - a).norm() / 2;
    halvingsLeft_ +=
        kHalvingsPerSquare * std::min(kMostSquares, area / (resolution_ * resolution_));
    add({cornerAt(a), cornerAt(b), cornerAt(c)});
  }

  bool isAnyToHalve() const {
    return !parts_.empty() && mayBeFarther(parts_.top().bound) && halvingsLeft_ > 0;
  }

  void halveNext() {
    const std::array<Corner, 3> corners = parts_.top().corners;
    parts_.pop();
    --halvingsLeft_;
    const auto& [a, b, c] = corners;
    const int from = longestSide({a.position, b.position, c.position}), to = cornerAfter(from);
    const Corner middle = cornerAt((corners[from].position + corners[to].position) / 2);
    for (const int replaced : {from, to}) {
      std::array<Corner, 3> half = corners;
      half[replaced] = middle;
      add(half);
    }
  }

  /// Keeps a part that may be farther than the farthest point so far.
  void add(const std::array<Corner, 3>& corners) {
    if (distance_ == kInfinity) return;
    const auto& [a, b, c] = corners;
    double bound = kInfinity;
    for (const Corner& corner : corners) {
      bound = std::min(bound, farthestFrom(to_.triangles()[corner.nearest],
                                           {a.position, b.position, c.position}));
      if (!mayBeFarther(bound)) return;
    }
    parts_.push({corners, bound, partCount_++});
  }

  Corner cornerAt(const Vector3d& position) {
    const NearestOfTriangles nearest = to_.nearest(position);
    distance_ = std::max(distance_, std::sqrt(nearest.squaredDistance));
    if (nearest.triangle >= 0) lastNearest_ = nearest.triangle;
    return {position, nearest.triangle};
  }

  /// Whether a bound exceeds the farthest distance so far by more than the tolerance.
  bool mayBeFarther(double bound) const {
    constexpr double kTolerance = 0.01;
    return bound > (1 + kTolerance) * distance_;
  }

  const TriangleTree& from_;
  const TriangleTree& to_;
  const double resolution_;
  double distance_;
  std::size_t next_ = 0;             ///< triangle
  std::priority_queue<Part> parts_;  ///< by bound
  std::int64_t partCount_ = 0;
  double halvingsLeft_ = kLeastHalvings;
  int lastNearest_ = 0;  ///< of the other triangles, to the last corner
};

// --- Both ----------------------------------------------------------------------------------------

class QualityMeasuring final : public SequentialWork<RemeshQuality> {
 public:
  QualityMeasuring(const TriangleMesh& surface, std::unique_ptr<SlicedWork<PolygonMesh>> remeshing)
      : surface_(surface), remeshing_(std::move(remeshing)), surfaceTree_(surface) {}
  QualityMeasuring(const TriangleMesh& surface, PolygonMesh remesh)
      : surface_(surface), remesh_(std::move(remesh)), surfaceTree_(surface) {}

  bool advance(long budget) override {
    return sequence_.run(
        [&] { return !remeshing_ || remeshing_->step(budget); },
        [&] {
          if (remeshing_) remesh_ = remeshing_->take();
        },
        [&] { return runPart(triangles_, budget, remesh_); },
        [&] {
          out_ = triangles_->take();
          // Not zero, where the remesh is as small as a point.
          const double mean = surface_.meanEdgeLength();
          resolution_ = std::max(std::min(mean, triangles_->meanSide()), mean / 64);
          remeshTree_.emplace(triangles_->takeInSpace());
        },
        [&] { return remeshTree_->step(budget); }, [&] { return surfaceTree_.step(budget); },
        [&] { return runPart(fromRemesh_, budget, *remeshTree_, surfaceTree_, 0., resolution_); },
        [&] {
          return runPart(fromSurface_, budget, surfaceTree_, *remeshTree_, fromRemesh_->distance(),
                         resolution_);
        },
        [&] { out_.hausdorff = fromSurface_->distance(); });
  }

 private:
  const TriangleMesh& surface_;
  std::unique_ptr<SlicedWork<PolygonMesh>> remeshing_;  ///< null if the remesh is given
  PolygonMesh remesh_;

  std::optional<TriangleMeasuring> triangles_;
  std::optional<TriangleTree> remeshTree_;
  TriangleTree surfaceTree_;
  double resolution_ = 0;  ///< the shorter mean edge of the two
  std::optional<OneSidedHausdorff> fromRemesh_, fromSurface_;
};

}  // namespace

std::unique_ptr<SlicedWork<RemeshQuality>> startTriangleQuality(const PolygonMesh& remesh) {
  return std::make_unique<TriangleMeasuring>(remesh);
}

std::unique_ptr<SlicedWork<RemeshQuality>> startQuality(
    const TriangleMesh& surface, std::unique_ptr<SlicedWork<PolygonMesh>> remeshing) {
  return std::make_unique<QualityMeasuring>(surface, std::move(remeshing));
}

RemeshQuality measureQuality(const TriangleMesh& surface, const PolygonMesh& remesh) {
  return finished<RemeshQuality>(std::make_unique<QualityMeasuring>(surface, remesh));
}

}  // namespace gvd
