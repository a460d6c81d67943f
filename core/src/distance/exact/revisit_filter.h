// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "distance/exact/window.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// Finds windows whose lines have already crossed the face that they are about to enter. None of
/// these lines is a shortest path, since there is a shorter way within the face (Sharir & Schorr
/// 1986). Without the filter, windows wind around spikes and thin tubes as often as the faces there
/// are longer than a turn.
///
/// To follow every window back would take longer than to let it spread. Windows are followed back
/// where they enter needles, and with labels that cross far more faces than usual: at first all;
/// later, one in n by chance, where n faces were crossed for the last one that was followed. So
/// that takes about as long as spreading. Windows that wind come in turn with others, so a regular
/// choice may always miss them.
class RevisitFilter {
 public:
  explicit RevisitFilter(const TriangleMesh& mesh);

  /// Begins with another label, or with a search from a point. Searches are many and short, since
  /// known distances bound them, so they get no first backtracks.
  void begin(bool isSearch) {
    crossedCount_ = 0;
    isSuspicious_ = false;
    backtracksLeft_ = isSearch ? 0 : kFirstBacktracks;
    lastBacktracks_ = 1;
    random_.seed();
  }
  /// Notes that the label crosses a face, having reached some vertices so far.
  void noteCrossing(size_t reachedCount) {
    isSuspicious_ = ++crossedCount_ > kMostCrossingsPerVertex * reachedCount;
  }
  /// The number of faces across which windows were followed back since the last call.
  long takeCrossedBack() { return std::exchange(crossedBack_, 0); }
  /// Whether a window at a halfedge has been found to enter its face again.
  bool drops(const Window& w, int halfedge) {
    const bool isAtNeedle = !isNeedle_.empty() && isNeedle_[halfedge / 3];
    return (isAtNeedle || isSuspicious_) && dropsSuspicious(w, halfedge);
  }

 private:
  /// A label that crosses more halfedges per vertex than this may wind around something. Over a
  /// scanned surface, one label crosses 3.5 per vertex.
  static constexpr size_t kMostCrossingsPerVertex = 30;
  /// All windows are followed back until so many faces were crossed for them: enough for all
  /// windows of a label, but on meshes with thousands of needles beside each other, where millions
  /// of windows tie.
  static constexpr long kFirstBacktracks = 1 << 17;

  bool dropsSuspicious(const Window& w, int halfedge);
  bool entersAgain(const Window& w, int halfedge);

  const TriangleMesh& mesh_;
  /// Per face; empty if none is. Around a spike of needles, a line ties with lines that wind around
  /// it fewer times; the number of turns would depend on rounding and on when another label stops
  /// the window.
  std::vector<char> isNeedle_;
  size_t crossedCount_ = 0;  ///< of batches
  bool isSuspicious_ = false;
  long crossedBack_ = 0;     ///< what `takeCrossedBack` returns next
  long backtracksLeft_ = 0;  ///< of the first ones
  /// Faces across which the last window was followed back. One in so many windows comes next.
  long lastBacktracks_ = 1;
  std::minstd_rand random_;  ///< the same numbers for each label
};

}  // namespace gvd::exact
