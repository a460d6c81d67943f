// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "base/tolerances.h"

namespace gvd {

/// Whether one label has a place before another one: it is nearer, or as near and lower.
inline bool isAhead(int label, double distance, int other, double otherDistance) {
  return distance < otherDistance * (1 - kDistanceTolerance) ||
         (label < other && distance <= otherDistance * (1 + kDistanceTolerance));
}

/// What other labels leave of an edge to one label, of which the distances at both ends are known.
/// Squared distances are compared: along an edge they are linear, up to what is the same for all.
class EdgeShare {
 public:
  EdgeShare(int label, double atTail, double atTip)
      : label_(label), atTail_(atTail), atTip_(atTip) {}

  void yieldTo(int other, double otherAtTail, double otherAtTip) {
    const bool isAheadAtTail = isAhead(other, otherAtTail, label_, atTail_);
    const bool isAheadAtTip = isAhead(other, otherAtTip, label_, atTip_);
    if (isAheadAtTail && isAheadAtTip) from_ = 2;
    if (isAheadAtTail == isAheadAtTip) return;
    const double leadAtTail = (otherAtTail - atTail_) * (otherAtTail + atTail_);
    const double leadAtTip = (otherAtTip - atTip_) * (otherAtTip + atTip_);
    const double tie = leadAtTail / (leadAtTail - leadAtTip);
    if (isAheadAtTail)
      from_ = std::max(from_, tie);
    else
      to_ = std::min(to_, tie);
  }

  /// False if in doubt: rounding may move the ends of a share.
  bool isEmpty() const { return from_ > to_ + kRounding; }

 private:
  static constexpr double kRounding = 1e-9;

  int label_;
  double atTail_, atTip_;
  double from_ = 0, to_ = 1;  ///< as shares of the edge
};

}  // namespace gvd
