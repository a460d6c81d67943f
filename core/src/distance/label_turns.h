// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "distance/label_spread.h"

namespace gvd {

/// A label whose distances are required at all corners of a face.
struct Requirement {
  int label, face;
};

/// Labels that spread one after another, each in its turn.
class LabelTurns {
 public:
  explicit LabelTurns(LabelSpread& spread) : spread_(spread) {}

  /// Gives up all turns.
  void clear();
  /// A turn to spread from the label's site.
  void addStart(int label) { turns_.push_back({label, Turn::kStart, {}}); }
  /// A turn to spread on from where the label stopped.
  void addResume(int label) { turns_.push_back({label, Turn::kResume, {}}); }
  /// Replaces all turns by one for each required label, to spread on to its faces. Labels come in
  /// the order of their first faces, so that the memory they touch is still in the cache.
  void setRequired(std::span<const Requirement> requirements);

  bool isEmpty() const { return turns_.empty(); }
  /// The share of turns that are over; 0 if there are none.
  double progress() const {
    return isEmpty() ? 0 : static_cast<double>(next_) / static_cast<double>(turns_.size());
  }

  /// Works on at most `budget` units and lowers it by their number; true when all turns are over.
  /// Calls `then(label, faces)` when a label has spread, with the faces that it was required at;
  /// `then` returns other faces, to which the label spreads on before its turn is over.
  template <class Then>
  bool step(long& budget, Then then) {
    for (; next_ < turns_.size(); ++next_) {
      if (!std::exchange(hasBegun_, true)) begin(budget);
      const int label = turns_[next_].label;
      for (;;) {
        // `LabelSpread::step` does not look at the budget when nothing is left to spread.
        if (budget <= 0 || !spread_.step(budget)) return false;
        std::vector<int> others = then(label, currentFaces_);
        if (others.empty()) break;
        currentFaces_ = std::move(others);
        beginToRequire(label, budget);
      }
      hasBegun_ = false;
    }
    return true;
  }
  bool step(long& budget) {
    return step(budget, [](int /*label*/, const auto& /*faces*/) { return std::vector<int>(); });
  }

 private:
  struct Turn {
    int label;
    enum { kStart, kResume, kRequire } how;
    std::vector<int> faces;  ///< to spread on to; empty once the turn has begun
  };

  void begin(long& budget);
  void beginToRequire(int label, long& budget);

  LabelSpread& spread_;
  std::vector<Turn> turns_;
  size_t next_ = 0;  ///< the current turn
  bool hasBegun_ = false;
  std::vector<int> currentFaces_;
};

}  // namespace gvd
