// SPDX-License-Identifier: MIT
//
// The memory of a quasi-Newton method.
#pragma once

#include <Eigen/Core>
#include <deque>

namespace gvd {

/// The limited-memory approximation of an inverse Hessian from the last steps taken (Nocedal &
/// Wright, Numerical Optimization, 2006, algorithm 7.4), with a diagonal preconditioner.
class LbfgsMemory {
 public:
  void clear() { steps_.clear(); }
  bool empty() const { return steps_.empty(); }

  /// Records that `step` has changed the gradient by `change`. Ignores steps without positive
  /// curvature, which would make the approximation indefinite.
  void learn(const Eigen::VectorXd& step, const Eigen::VectorXd& change);

  /// The search direction: the approximate inverse Hessian times -gradient. The approximation
  /// starts from the given diagonal, and is that diagonal if no step is recorded.
  Eigen::VectorXd direction(const Eigen::VectorXd& gradient,
                            const Eigen::VectorXd& inverseDiagonal) const;

 private:
  static constexpr size_t kSteps = 7;  // as Liu et al. 2009

  struct Step {
    Eigen::VectorXd step, change;
    double curvature;  ///< step · change
  };
  std::deque<Step> steps_;  ///< the last one at the back
};

}  // namespace gvd
