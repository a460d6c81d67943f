// SPDX-License-Identifier: MIT
#include "diagram/final/outline_steps.h"

#include <algorithm>
#include <span>

namespace gvd {

PlaceOfLine placeOfLine(const BisectorGraph& graph, int from, int to, int face) {
  const bool anyFace = graph.merging.isMerged(from) && graph.merging.isMerged(to);
  return {std::min(from, to), std::max(from, to), anyFace ? -1 : face};
}

bool OutlineSteps::cancel(long& budget) {
  return sequence_.run(forEach(steps_, budget, 1, [&](int s) { cancelStep(s); }),
                       [&] { return forgetWaiting(budget); });
}

/// Makes a ring of the steps since the first one.
void OutlineSteps::closeRing(int first) {
  steps_[first].previous = size() - 1;
  steps_.back().next = first;
  for (const Step& step : std::span(steps_).subspan(first))
    if (step.isOnBoundary && (isMerged(step.from) || isMerged(tip(step))))
      boundarySteps_.push_back({step.label, step.from, tip(step), step.face});
}

void OutlineSteps::cancelStep(int s) {
  Step& step = steps_[s];
  const int from = step.from, to = tip(step);
  if (from == to) {
    steps_[step.previous].next = step.next;
    steps_[step.next].previous = step.previous;
    step.isGone = true;
  } else if (isMerged(from) || isMerged(to)) {
    const auto [low, high, face] = placeOfLine(graph_, from, to, step.face);
    auto& others = waiting_[{step.label, low, high, face}];
    if (!others.empty() && steps_[others.back()].from == to) {
      cancelPair(s, others.back());
      others.pop_back();
    } else {
      others.push_back(s);
    }
  }
}

/// Frees the lists of steps that stayed uncancelled, in slices because there may be many.
bool OutlineSteps::forgetWaiting(long& budget) {
  for (; !waiting_.empty() && budget > 0; --budget) waiting_.erase(waiting_.begin());
  return waiting_.empty();
}

/// Takes out two opposite steps: the step before each is followed by the step after the other.
void OutlineSteps::cancelPair(int s, int opposite) {
  Step &a = steps_[s], &b = steps_[opposite];
  const Step formerA = a, formerB = b;
  steps_[formerA.previous].next = formerB.next;
  steps_[formerB.next].previous = formerA.previous;
  steps_[formerB.previous].next = formerA.next;
  steps_[formerA.next].previous = formerB.previous;
  a.isGone = b.isGone = true;
}

void OutlineSteps::takeRing(int s, std::vector<int>& points) {
  for (Step* step = &steps_[s]; !step->isGone; step = &steps_[step->next]) {
    points.push_back(step->from);
    step->isGone = true;
  }
}

}  // namespace gvd
