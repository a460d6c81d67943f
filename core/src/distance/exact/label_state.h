// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "distance/exact/window.h"
#include "distance/label_spread.h"

namespace gvd::exact {

/// The last piece of the path that gives a label's distance at a vertex.
struct LastPiece {
  /// Where the path crosses `arrival`, from the foot of the vertex on it: so the piece has a
  /// precise direction even if it is much shorter than the halfedge.
  double fromFoot = 0;
  double sourceDistance = 0;  ///< of the last vertex at which the path turns; 0: it runs straight
  /// If the path runs straight, the angle of `arrival` in the site's frame; otherwise the angle at
  /// which the path leaves the site.
  double direction = 0;
  /// The halfedge across which the path enters its last face, of which the vertex is the apex; -1
  /// if the site is at the vertex.
  int arrival = -1;
  PathKind kind = PathKind::kStraight;  ///< of this piece

  /// Whether the site is at the vertex.
  bool isAtSite() const { return arrival < 0; }
  /// Whether the path runs straight from the site.
  bool isFromSite() const { return sourceDistance == 0; }
};

/// A window that has not crossed its face, because the label was stopped there.
struct WaitingWindow {
  Window window;
  int halfedge;
  float sleepsUntil = 0;  ///< the `RequiredDistances::travel` before which it cannot gain
};

/// Where a label was stopped, and can go on.
struct Waiting {
  std::vector<WaitingWindow> windows;  ///< those that sleep come first, as a heap
  std::size_t asleep = 0;              ///< the number of windows that sleep
  std::vector<int> sources;            ///< vertices that would become virtual sources

  /// Windows of one halfedge often follow one another.
  std::span<WaitingWindow> awake() { return std::span(windows).subspan(asleep); }
  /// Wakes the windows that sleep no longer than until `travel`.
  void wake(double travel);
  /// Puts the windows to sleep that sleep longer than until `travel`.
  void sleep(double travel);

  void clear() {
    windows.clear();
    asleep = 0;
    sources.clear();
  }
  void append(const Waiting& more) {
    windows.reserve(windows.size() + more.windows.size());
    windows.insert(windows.end(), more.windows.begin(), more.windows.end());
    sources.insert(sources.end(), more.sources.begin(), more.sources.end());
  }
};

/// The state of a label after it has spread. Windows that have crossed their faces are not kept:
/// they would take several times the memory of everything else.
struct LabelState {
  std::vector<ReachedVertex> vertices;
  std::vector<LastPiece> pieces;  ///< of each entry of `vertices`
  Waiting waiting;
};

}  // namespace gvd::exact
