// SPDX-License-Identifier: MIT
//
// The two-loop recursion of L-BFGS.
#include "tessellation/lbfgs.h"

#include <vector>

namespace gvd {

using Eigen::VectorXd;

void LbfgsMemory::learn(const VectorXd& step, const VectorXd& change) {
  constexpr double kLeastCosine = 1e-8;  // between a step and the change: the root of the rounding
  const double curvature = step.dot(change);
  if (!(curvature > kLeastCosine * step.stableNorm() * change.stableNorm())) return;
  if (steps_.size() == kSteps) steps_.pop_front();
  steps_.push_back({step, change, curvature});
}

VectorXd LbfgsMemory::direction(const VectorXd& gradient, const VectorXd& inverseDiagonal) const {
  VectorXd result = -gradient;
  std::vector<double> share(steps_.size());
  for (size_t i = steps_.size(); i-- > 0;) {
    share[i] = steps_[i].step.dot(result) / steps_[i].curvature;
    result -= share[i] * steps_[i].change;
  }
  result = result.cwiseProduct(inverseDiagonal);
  if (!steps_.empty()) {
    const Step& last = steps_.back();
    result *= last.curvature / last.change.dot(last.change.cwiseProduct(inverseDiagonal));
  }
  for (size_t i = 0; i < steps_.size(); ++i)
    result += (share[i] - steps_[i].change.dot(result) / steps_[i].curvature) * steps_[i].step;
  return result;
}

}  // namespace gvd
