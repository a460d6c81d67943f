// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace gvd {

/// What a change of sites means for labels.
struct LabelChange {
  std::vector<int> started;        ///< labels that spread from their sites
  std::vector<int> resumed;        ///< labels that spread on from where they had stopped
  std::vector<char> hasStarted;    ///< per label
  bool startsAll = false;          ///< whether all labels start: nothing is known from before
  std::vector<int> resetVertices;  ///< the owner was removed or exceeds the edge bound
};

}  // namespace gvd
