// SPDX-License-Identifier: MIT
#pragma once

namespace gvd {

/// A vertex that a label has reached.
struct ReachedVertex {
  int vertex;
  /// Whether the distance is final: the label owns the vertex, or its distance was required there.
  /// Otherwise it is an upper bound, for the label was stopped before.
  bool isFinal;
  double distance;
};

}  // namespace gvd
