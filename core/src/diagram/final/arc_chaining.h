// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "base/sliced_loop.h"
#include "gvd/diagram.h"

namespace gvd {

/// Chains the segments of a diagram to arcs through the points where exactly two of one bisector
/// meet.
class ArcChaining {
 public:
  explicit ArcChaining(Diagram& diagram) : out_(diagram) {}
  bool step(long& budget);

 private:
  /// The segment that arrives at a point and the one that leaves it; `kSeveral` if there are more.
  struct Ends {
    int incoming = kNone, outgoing = kNone;
  };
  static constexpr int kNone = -1, kSeveral = -2;

  void noteEnds(int segment);
  bool passes(int point) const;
  void follow(int segment);

  Diagram& out_;
  SlicedSequence sequence_;
  std::vector<Ends> ends_;  ///< per point
};

}  // namespace gvd
