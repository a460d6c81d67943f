// SPDX-License-Identifier: MIT
#include "distance/label_turns.h"

#include <algorithm>
#include <numeric>

#include "base/sliced_loop.h"

namespace gvd {

void LabelTurns::clear() {
  turns_.clear();
  faces_.clear();
  next_ = 0;
  hasBegun_ = false;
}

void LabelTurns::addRequired(std::span<const Requirement> requirements) {
  int labelCount = 0;
  for (const Requirement& r : requirements) labelCount = std::max(labelCount, r.label + 1);
  std::vector<int> turnOf(labelCount, -1);
  std::vector<size_t> first;  // of each turn's faces, and behind the last one
  const size_t turnCount = turns_.size();
  for (const Requirement& r : requirements) {
    if (turnOf[r.label] < 0) {
      turnOf[r.label] = static_cast<int>(first.size());
      first.push_back(0);
      turns_.push_back({r.label, Turn::kRequire, 0});
    }
    ++first[turnOf[r.label]];
  }
  std::exclusive_scan(first.begin(), first.end(), first.begin(), faces_.size());
  for (size_t i = 0; i < first.size(); ++i) turns_[turnCount + i].firstFace = first[i];
  faces_.resize(faces_.size() + requirements.size());
  for (const Requirement& r : requirements) faces_[first[turnOf[r.label]]++] = r.face;
}

void LabelTurns::begin(long& budget) {
  const auto& [label, how, firstFace] = turns_[next_];
  const size_t end = next_ + 1 < turns_.size() ? turns_[next_ + 1].firstFace : faces_.size();
  const auto own = std::span(faces_).subspan(firstFace, end - firstFace);
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
