// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "base/growing_array.h"
#include "distance/exact/window.h"
#include "distance/label_distances.h"

namespace gvd::exact {

/// The last piece of the path that gives a label's distance at a vertex.
struct LastPiece {
  double crossing;        ///< where the path crosses `arrival`, from its tail
  double sourceDistance;  ///< of the last vertex at which the path turns; 0: it runs straight
  /// If the path runs straight, the angle of `arrival` in the site's frame; otherwise the angle at
  /// which the path leaves the site.
  double direction;
  /// The halfedge across which the path enters its last face, of which the vertex is the apex; -1
  /// if the path starts at the vertex.
  int arrival;
};

/// Windows that have been added to a halfedge together: a range of the label's windows.
struct WindowBlock {
  int first, count;
  int next;  ///< in the list of the blocks of a halfedge, -1
};

/// The windows of one label that have crossed a face from the same halfedge.
struct CrossedHalfedge {
  int halfedge;
  int firstBlock;
};

/// A window that has not crossed its face, because the label was stopped there.
struct WaitingWindow {
  Window window;
  int halfedge;
};

/// All that is kept of a label.
struct LabelWindows {
  std::vector<ReachedVertex> vertices;
  std::vector<LastPiece> pieces;  ///< of each of these vertices
  GrowingArray<Window> windows;
  GrowingArray<WindowBlock> blocks;
  std::vector<CrossedHalfedge> crossed;
  // Where the label goes on when it is continued; windows of one halfedge in succession.
  std::vector<WaitingWindow> waiting;
  std::vector<int> waitingSources;  ///< vertices that would become virtual sources

  /// Calls `visit` with every window of a list of blocks.
  template <class Visit>
  void visitWindows(int firstBlock, Visit visit) const {
    for (int b = firstBlock; b >= 0; b = blocks[b].next)
      for (const Window& w : windows.subspan(blocks[b].first, blocks[b].count)) visit(w);
  }
};

}  // namespace gvd::exact
