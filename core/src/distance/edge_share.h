// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace gvd {

/// What other labels leave of an edge to one label, of which the distances at both ends are known.
/// Squared distances are compared: along an edge they are linear, up to what is the same for all. Ties go
/// to the lower label; they are equal exactly (`equalizeTies`).
class EdgeShare {
 public:
  EdgeShare(int label, double atTail, double atTip)
      : label_(label), atTail_(atTail), atTip_(atTip) {}

  void yieldTo(int other, double otherAtTail, double otherAtTip) {
    const bool isBehindAtTail = isBehind(atTail_, other, otherAtTail);
    const bool isBehindAtTip = isBehind(atTip_, other, otherAtTip);
    if (isBehindAtTail && isBehindAtTip) from_ = 2;
    if (isBehindAtTail == isBehindAtTip) return;
    const double leadAtTail = (otherAtTail - atTail_) * (otherAtTail + atTail_);
    const double leadAtTip = (otherAtTip - atTip_) * (otherAtTip + atTip_);
    const double tie = leadAtTail / (leadAtTail - leadAtTip);
    if (isBehindAtTail)
      from_ = std::max(from_, tie);
    else
      to_ = std::min(to_, tie);
  }

  /// False if in doubt: rounding may move the ends of a share.
  bool isEmpty() const { return from_ > to_ + kRounding; }

 private:
  static constexpr double kRounding = 1e-9;

  bool isBehind(double own, int other, double distance) const {
    return distance < own || (distance == own && other < label_);
  }

  int label_;
  double atTail_, atTip_;
  double from_ = 0, to_ = 1;  ///< as shares of the edge
};

}  // namespace gvd
