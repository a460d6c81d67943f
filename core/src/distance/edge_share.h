// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace gvd {

/// How far rounding may move the place on an edge where two squared distances are equal, as a share
/// of the edge. The place is a quotient of their differences, which are exact where they are small,
/// so it rounds by a few 2^-53.
inline constexpr double kEdgeShareRounding = 1e-14;

/// The part of an edge that one label keeps when others take what they own. All labels have
/// distances at both ends. Squared distances are compared, because along an edge they are linear up
/// to a term common to all labels. The squares are rounded as in the tracer, which treats them as
/// exact. Ties go to the lower label.
class EdgeShare {
 public:
  EdgeShare(int label, double atTail, double atTip)
      : label_(label), atTail_(atTail * atTail), atTip_(atTip * atTip) {}

  void yieldTo(int other, double otherAtTail, double otherAtTip) {
    const double lagAtTail = atTail_ - otherAtTail * otherAtTail;
    const double lagAtTip = atTip_ - otherAtTip * otherAtTip;
    const bool isBehindAtTail = isBehind(lagAtTail, other);
    const bool isBehindAtTip = isBehind(lagAtTip, other);
    if (isBehindAtTail && isBehindAtTip) from_ = 2;  // beyond the tip: nothing is left
    if (isBehindAtTail == isBehindAtTip) return;
    const double tie = lagAtTail / (lagAtTail - lagAtTip);
    if (isBehindAtTail)
      from_ = std::max(from_, tie);
    else
      to_ = std::min(to_, tie);
  }

  /// Errs towards false, because rounding may move the ends of the part.
  bool isEmpty() const { return from_ > to_ + kEdgeShareRounding; }

 private:
  bool isBehind(double lag, int other) const { return lag > 0 || (lag == 0 && other < label_); }

  int label_;
  double atTail_, atTip_;     ///< squared
  double from_ = 0, to_ = 1;  ///< as shares of the edge
};

}  // namespace gvd
