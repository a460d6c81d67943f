// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "gvd/partition.h"

namespace gvd {

/// The regions of a partition as a complex: its faces are the regions, its edges the *borders*
/// between two of them, or of one with the outside, its vertices the *nodes*: where three or more
/// of these meet around a point. Borders are seen from a region, which is on their left, so each
/// arc between two regions is there twice, and a *run* of a region along the mesh boundary once.
struct RegionComplex {
  static constexpr int kOutside = -1;

  struct Node {
    int vertex;  ///< of the partition
    /// The borders that leave it, counterclockwise, each the first of a sector of the region to its
    /// left. On the mesh boundary the first is a run, and the sectors do not close.
    std::vector<int> borders;
    /// The run that comes to it; -1 inside.
    int arrivingRun = -1;

    bool isOnBoundary() const { return arrivingRun >= 0; }
  };

  struct Border {
    int label, beyond;      ///< to the left, to the right
    int fromNode, toNode;   ///< -1 if it is closed and meets no node
    std::vector<int> path;  ///< the halfedges of the partition along it
  };

  struct Loop {
    int label;
    int firstBorder, borderCount;
  };

  std::vector<Node> nodes;
  std::vector<Border> borders;
  std::vector<Loop> loops;  ///< ascending by label

  /// The regions around a node, counterclockwise.
  std::vector<int> labelsAt(int node) const;
};

/// Of a partition without what no site reaches.
RegionComplex buildRegionComplex(const Partition& partition);

}  // namespace gvd
