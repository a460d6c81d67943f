// SPDX-License-Identifier: MIT
//
// Distances of a label that are required time and again, and how long windows sleep.
#include "distance/exact/required_distances.h"

#include <algorithm>
#include <cmath>

namespace gvd::exact {

void RequiredDistances::beginNext() {
  const int end = static_cast<int>(distances_.size());
  for (int i = std::max(kNone + 1, end - kRecent); i < end; ++i) {
    const int to = recentCount_++ % kRecent;
    recent_[to / kLanes].setLane(to % kLanes, blocks_[i / kLanes], i % kLanes);
  }
  clearPlaces();
}

void RequiredDistances::approach() {
  double most = 0;
  for (int i = kNone + 1; i < static_cast<int>(distances_.size()); ++i) {
    const Block& block = blocks_[i / kLanes];
    float least = std::numeric_limits<float>::infinity();
    for (const Block& recent : recent_)
      least = std::min(least, recent.leastApproach(block, i % kLanes));
    most = std::max(most, least + kRounding * block.bound[i % kLanes]);
  }
  lastApproach_ = most + kPlaceRounding;
  travel_ += lastApproach_;
}

float RequiredDistances::sleepsUntil(const Paths& paths) const {
  float slack = std::numeric_limits<float>::infinity();
  for (const Block& block : blocks_) slack = std::min(slack, block.slack(paths));
  for (const Block& block : recent_) slack = std::min(slack, block.slack(paths));
  return static_cast<float>((1 - kRounding) * (travel_ + std::max(slack, 0.0F)));
}

void RequiredDistances::Block::setLane(int lane, const Block& from, int fromLane) {
  x[lane] = from.x[fromLane];
  y[lane] = from.y[fromLane];
  z[lane] = from.z[fromLane];
  bound[lane] = from.bound[fromLane];
  excess[lane] = from.excess[fromLane];
}

float RequiredDistances::Block::slack(const Paths& p) const {
  const FloatLanes rest = bound + p.reach, missing = p.excess - excess;
  const FloatLanes squared = squaredDistance(p.place.x(), p.place.y(), p.place.z());
  float least = std::numeric_limits<float>::infinity();
  for (int i = 0; i < kLanes; ++i)
    least = std::min(least, std::max(std::sqrt(squared[i]) - rest[i], missing[i]));
  return least;
}

float RequiredDistances::Block::leastApproach(const Block& to, int lane) const {
  const FloatLanes squared = squaredDistance(to.x[lane], to.y[lane], to.z[lane]);
  float least = std::numeric_limits<float>::infinity();
  for (int i = 0; i < kLanes; ++i)
    least = std::min(least, std::max(std::sqrt(squared[i]) + to.bound[lane] - bound[i],
                                     to.excess[lane] - excess[i]));
  return least;
}

}  // namespace gvd::exact
