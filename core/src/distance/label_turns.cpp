// SPDX-License-Identifier: MIT
#include "distance/label_turns.h"

#include "base/sliced_loop.h"

namespace gvd {

void LabelTurns::clear() {
  turns_.clear();
  faces_.clear();
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
      turns_.push_back({r.label, Turn::kRequire});
    }
    ++turns_[turn].facesEnd;  // the number of its faces, then their begin, and at last their end
  }
  size_t begin = 0;
  for (Turn& turn : turns_) begin += std::exchange(turn.facesEnd, begin);
  faces_.resize(requirements.size());
  for (const Requirement& r : requirements) faces_[turns_[turnOf[r.label]].facesEnd++] = r.face;
}

void LabelTurns::begin(long& budget) {
  const auto& [label, how, facesEnd] = turns_[next_];
  const size_t begin = next_ > 0 ? turns_[next_ - 1].facesEnd : 0;
  const auto own = std::span(faces_).subspan(begin, facesEnd - begin);
  currentFaces_.assign(own.begin(), own.end());
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
