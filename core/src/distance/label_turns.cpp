// SPDX-License-Identifier: MIT
#include "distance/label_turns.h"

#include "base/sliced_loop.h"

namespace gvd {

void LabelTurns::clear() {
  turns_.clear();
  next_ = 0;
  hasBegun_ = false;
}

void LabelTurns::setRequired(std::span<const Requirement> requirements) {
  clear();
  std::vector<int> turnOf;  // per label
  for (const Requirement& r : requirements) {
    if (r.label >= static_cast<int>(turnOf.size())) turnOf.resize(r.label + 1, -1);
    int& turn = turnOf[r.label];
    if (turn < 0) {
      turn = static_cast<int>(turns_.size());
      turns_.push_back({r.label, Turn::kRequire, {}});
    }
    turns_[turn].faces.push_back(r.face);
  }
}

void LabelTurns::begin(long& budget) {
  auto& [label, how, faces] = turns_[next_];
  currentFaces_ = std::move(faces);
  switch (how) {
    case Turn::kStart:
      return spread_.start(label);
    case Turn::kResume:
      return spread_.resume(label);
    case Turn::kRequire:
      return beginToRequire(label, budget);
  }
}

void LabelTurns::beginToRequire(int label, long& budget) {
  budget -= 1 + spread_.require(label, currentFaces_) / kQuickRounds;
}

}  // namespace gvd
