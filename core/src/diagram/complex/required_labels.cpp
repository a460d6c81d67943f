// SPDX-License-Identifier: MIT
#include "diagram/complex/required_labels.h"

#include "distance/labelled_distances.h"

namespace gvd {

void RequiredLabels::add(int midpoint, int label, const SurfacePoint& p) {
  if (findLabel(nodes_.labels(midpoint), label)) return;
  const size_t index = midpoint - firstMidpoint_;
  if (index >= last_.size()) last_.resize(index + 1, -1);
  int& last = last_[index];
  for (int i = last; i >= 0; i = previous_[i])
    if (labels_[i] == label) return;
  if (last < 0) midpoints_.push_back(midpoint);
  previous_.push_back(last);
  last = static_cast<int>(required_.size());
  required_.push_back({label, p});
  labels_.push_back(label);
}

bool RequiredLabels::find(long& budget) {
  return sequence_.runRound(
      [&] { finding_ = distances_.startDistancesAt(std::move(required_)); },
      [&] { return finding_->step(budget); }, [&] { found_ = finding_->take(); },
      forItems(midpoints_, budget, 1, [&](int midpoint) { setLabels(midpoint); }),
      [&] {
        finding_.reset();
        required_.clear();
        labels_.clear();
        previous_.clear();
        midpoints_.clear();
      });
}

void RequiredLabels::setLabels(int midpoint) {
  const auto known = nodes_.labels(midpoint);
  atPoint_.assign(known.begin(), known.end());
  int& last = last_[midpoint - firstMidpoint_];
  for (int i = last; i >= 0; i = previous_[i]) {
    const LabelledDistance d{labels_[i], found_[i]};
    if (d.distance < kInfinity) insertByLabel(atPoint_, d);
  }
  last = -1;
  equalizeTies(atPoint_, ties_);
  nodes_.setLabels(midpoint, atPoint_);
}

}  // namespace gvd
