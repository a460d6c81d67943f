// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "base/tolerances.h"

namespace gvd {

/// What other labels leave of an edge to one label, of which the distances at both ends are known.
/// Squared distances are compared: along an edge they are linear, up to what is the same for all.
/// They are rounded as those that a diagram is traced from, which takes the rounded ones for exact.
/// Ties go to the lower label.
class EdgeShare {
 public:
  EdgeShare(int label, double atTail, double atTip)
      : label_(label), atTail_(atTail * atTail), atTip_(atTip * atTip) {}

  void yieldTo(int other, double otherAtTail, double otherAtTip) {
    const double lagAtTail = atTail_ - otherAtTail * otherAtTail;
    const double lagAtTip = atTip_ - otherAtTip * otherAtTip;
    const bool isBehindAtTail = isBehind(lagAtTail, other);
    const bool isBehindAtTip = isBehind(lagAtTip, other);
    if (isBehindAtTail && isBehindAtTip) from_ = 2;
    if (isBehindAtTail == isBehindAtTip) return;
    const double tie = lagAtTail / (lagAtTail - lagAtTip);
    if (isBehindAtTail)
      from_ = std::max(from_, tie);
    else
      to_ = std::min(to_, tie);
  }

  /// False if in doubt: rounding may move the ends of a share.
  bool isEmpty() const { return from_ > to_ + kEdgeShareRounding; }

 private:
  bool isBehind(double lag, int other) const { return lag > 0 || (lag == 0 && other < label_); }

  int label_;
  double atTail_, atTip_;     ///< squared
  double from_ = 0, to_ = 1;  ///< as shares of the edge
};

}  // namespace gvd
