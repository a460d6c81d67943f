// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/lanes.h"
#include "base/tolerances.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// The vertices or other points at which the distance of a label is required although another label
/// is nearer. The label's windows go on only as far as they can still shorten one of these
/// distances.
///
/// Every window that is awake is compared with every place, so the numbers are kept in single
/// precision, four in a register: in bounding diagonals, and rounded so that a window never stops
/// too early.
///
/// A label may be required at one face after another, thousands of times along a border. Each time,
/// the places are near those from before, and few of its windows come into question. The others
/// sleep (`Waiting`): paths that miss a gain by some slack cannot gain before the places have come
/// nearer by as much in all (`travel`).
class RequiredDistances {
 public:
  /// The index of no place.
  static constexpr int kNone = 0;

  /// Paths that go on from the neighbourhood of one place.
  struct Paths {
    Eigen::Vector3f place;
    float reach;   ///< the radius of the neighbourhood, less the least length of the paths up to it
    float excess;  ///< their least excess over the nearest label's distance
  };

  explicit RequiredDistances(const TriangleMesh& mesh)
      : mesh_(mesh), scale_(1 / mesh.boundingDiagonal()) {
    clear();
  }

  void clear() {
    clearPlaces();
    recent_ = {};
    recentCount_ = 0;
    travel_ = 0;
  }
  /// Begins with other places of the same label. Some of the last ones stay the recent ones, with
  /// their distances.
  void beginNext();
  /// Whether distances of the label were required before.
  bool hasRecent() const { return recentCount_ > 0; }

  /// The position of a vertex relative to vertex 0: positions of a mesh far from the origin would
  /// round too coarsely.
  Eigen::Vector3d placeOf(int vertex) const { return mesh_.position(vertex) - mesh_.position(0); }

  /// How many quick rounds `canGain` takes.
  std::size_t cost() const { return 1 + blocks_.size() / kLanes; }

  /// `distance` is the least of the label known so far, `nearest` that of the nearest label.
  /// Returns the index of the place, the next one after `kNone`.
  int add(const Eigen::Vector3d& place, double distance, double nearest) {
    const int index = static_cast<int>(distances_.size()), lane = index % kLanes;
    if (lane == 0) blocks_.emplace_back();
    Block& block = blocks_.back();
    block.x[lane] = static_cast<float>(scale_ * place.x());
    block.y[lane] = static_cast<float>(scale_ * place.y());
    block.z[lane] = static_cast<float>(scale_ * place.z());
    distances_.push_back({distance, nearest});
    setBounds(index);
    return index;
  }
  /// The least distance of the label known so far.
  double distance(int index) const { return distances_[index].own; }
  void lower(int index, double distance) {
    if (!(distance < distances_[index].own)) return;
    distances_[index].own = distance;
    setBounds(index);
  }
  /// The largest excess over the nearest label's distance with which a path can still shorten any
  /// required distance, when `findMostExcess` was last called.
  double mostExcess() const { return mostExcess_; }
  void findMostExcess() {
    float most = 0;
    for (const Block& block : blocks_)
      for (int lane = 0; lane < kLanes; ++lane) most = std::max(most, block.excess[lane]);
    mostExcess_ = most / scale_;
  }

  /// Paths of at least `length` to points within `radius` of `place`, with some `excess` over the
  /// distance of the nearest label.
  Paths paths(const Eigen::Vector3d& place, double radius, double length, double excess) const {
    return {(scale_ * place).cast<float>(), roundedUp(scale_ * (radius - length)) + kPlaceRounding,
            -roundedUp(-scale_ * excess)};
  }
  /// Whether paths can become the shortest to a required place. The rest of a path is at least as
  /// long as the straight line in space, and its excess does not fall along the way. Ignores the
  /// places whose indices `visitIgnored` passes to the function given to it.
  template <class VisitIgnored>
  bool canGain(const Paths& paths, VisitIgnored visitIgnored) const {
    FloatMask gains = blocks_[0].gains(paths);
    for (size_t i = 1; i < blocks_.size(); ++i) gains += blocks_[i].gains(paths);
    int count = -(gains[0] + gains[1] + gains[2] + gains[3]);
    if (count == 0) return false;
    visitIgnored([&](int i) { count += blocks_[i / kLanes].gains(paths)[i % kLanes]; });
    return count > 0;
  }

  /// By how much, at most, places have come nearer to any paths in all since `clear`.
  double travel() const { return travel_; }
  /// By how much `approach` has raised it last.
  double lastApproach() const { return lastApproach_; }
  /// Adds to `travel` by how much the places are nearer than the recent ones. To be called when
  /// their distances have been lowered as far as is easily known.
  void approach();
  /// The `travel` before which paths cannot gain a place, as far as the places and the recent ones
  /// tell.
  float sleepsUntil(const Paths& paths) const;

 private:
  /// The relative rounding error of a few operations in single precision, each 2^-24.
  static constexpr double kRounding = 0x1p-21;
  /// That of the distance between two places, in bounding diagonals.
  static constexpr float kPlaceRounding = 0x1p-20F;
  /// The number of recent places. A label that is required along a border goes on at both ends of
  /// it and on both sides in turns: four places, each of which may be final at times.
  static constexpr int kRecent = 8;

  static constexpr int kLanes = 4;
  /// Four places. `bound` and `excess` are what paths must stay below.
  struct Block {
    FloatLanes x = {}, y = {}, z = {};
    FloatLanes bound = FloatLanes{} - std::numeric_limits<float>::infinity();
    FloatLanes excess = bound;

    void setLane(int lane, const Block& from, int fromLane);
    FloatLanes squaredDistance(float px, float py, float pz) const {
      const FloatLanes dx = x - px, dy = y - py, dz = z - pz;
      return dx * dx + dy * dy + dz * dz;
    }
    /// The places that paths can gain.
    FloatMask gains(const Paths& p) const {
      const FloatLanes rest = bound + p.reach;
      const FloatLanes squared = squaredDistance(p.place.x(), p.place.y(), p.place.z());
      return (rest > 0) & (squared < rest * rest) & (excess > p.excess);
    }
    /// By how much paths miss a gain, at least: in distance or in excess, whichever is more.
    float slack(const Paths& p) const;
    /// How much less, at most, the slack of any paths is at a place of `to` than at a place here
    /// (triangle inequality): the least of the bounds by the four places.
    float leastApproach(const Block& to, int lane) const;
  };

  void clearPlaces() {
    blocks_.assign(1, Block{});
    distances_.assign(1, {});
    mostExcess_ = 0;
  }

  /// Paths that tie with the distance can still become the shortest.
  void setBounds(int index) {
    const auto [own, nearest] = distances_[index];
    const double most = own * (1 + kDistanceTolerance);
    Block& block = blocks_[index / kLanes];
    block.bound[index % kLanes] = roundedUp(scale_ * most);
    block.excess[index % kLanes] = roundedUp(scale_ * (most - nearest));
  }

  /// A value in single precision, not smaller.
  static float roundedUp(double value) {
    return static_cast<float>(value + kRounding * std::abs(value));
  }

  /// Of the label, and of the nearest one.
  struct Distances {
    double own = 0, nearest = 0;
  };

  const TriangleMesh& mesh_;
  const double scale_;
  // Both by index; the first place is that of `kNone`.
  std::vector<Block> blocks_;
  std::vector<Distances> distances_;
  double mostExcess_ = 0;
  std::array<Block, kRecent / kLanes> recent_;  ///< as they were at the end
  int recentCount_ = 0;                         ///< since `clear`
  double travel_ = 0, lastApproach_ = 0;
};

}  // namespace gvd::exact
