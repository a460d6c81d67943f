// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "base/sliced_loop.h"
#include "diagram/complex/node_labels.h"
#include "distance/ties.h"
#include "gvd/geodesic.h"

namespace gvd {

/// Labels that are required at midpoints. Their distances are computed together: for a label, many
/// points take hardly longer than one.
class RequiredLabels {
 public:
  RequiredLabels(const DistanceField& distances, const TieTolerance& ties, NodeLabels& nodes)
      : distances_(distances), ties_(ties), nodes_(nodes), firstMidpoint_(nodes.count()) {}
  /// Requires a label at a midpoint, which is at `p`, unless it is known or required there.
  void add(int midpoint, int label, const SurfacePoint& p);
  /// Adds what was required to the labels of the midpoints; true when done.
  bool find(long& budget);
  /// The share of the distances found; 0 while none are being found.
  double progress() const { return finding_ ? finding_->progress() : 0; }

 private:
  void setLabels(int midpoint);

  const DistanceField& distances_;
  const TieTolerance& ties_;
  NodeLabels& nodes_;
  const int firstMidpoint_;  ///< midpoints are numbered from here

  std::vector<LabelledPoint> required_;
  std::vector<int> labels_;     ///< of each
  std::vector<int> previous_;   ///< of each, in the list of its midpoint; -1 for none
  std::vector<int> last_;       ///< in the list of each midpoint; -1 for none
  std::vector<int> midpoints_;  ///< with a list
  SlicedSequence sequence_;
  std::unique_ptr<SlicedWork<std::vector<double>>> finding_;
  std::vector<double> found_;              ///< the required distances
  std::vector<LabelledDistance> atPoint_;  ///< of the current midpoint
};

}  // namespace gvd
