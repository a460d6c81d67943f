// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "base/index_set.h"
#include "base/sliced_loop.h"
#include "distance/face_owners.h"
#include "distance/label_change.h"
#include "distance/label_closure.h"
#include "distance/label_lists.h"
#include "distance/label_spread.h"
#include "distance/label_turns.h"
#include "distance/nearest_bounds.h"
#include "distance/owner_finding.h"
#include "distance/reached_loop.h"
#include "distance/site_set.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The labels known at each vertex. They are found in four steps after labels have spread:
///
/// 1. *Owners* (`OwnerFinding`): a label owns part of a face if it is nearest at a corner, ties
///    included, or has its site there.
/// 2. *Required distances* (`LabelTurns`): each owner of a face spreads on to the corners that it
///    does not own.
/// 3. *Lists* (`LabelLists`): a vertex lists the owners of the faces around it.
/// 4. *Closure* (`LabelClosure`): a diagram interpolates squared distances between corners. A label
///    that is nearest somewhere on an edge by interpolation becomes an owner of the faces on both
///    sides, and goes through steps 2 to 4 there.
///
/// The result depends on the distances only, not on the changes that led to them.
class KnownLabels {
 public:
  /// `step` changes `bounds`: where labels tie, the lowest becomes the owner. `change` is the
  /// current one. All arguments must outlive this.
  KnownLabels(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds,
              LabelSpread& spread, const LabelChange& change);

  /// Makes room, in slices; true when it is there. Before anything else.
  bool prepare(long& budget) {
    return owners_.prepare(budget) && lists_.prepare(mesh_.vertexCount(), budget);
  }

  const LabelLists& lists() const { return lists_; }

  /// Forgets the previous change.
  void beginChange();
  /// Notes a label whose site changes, even if it takes no part because another one is at its
  /// place.
  void noteChanged(int label) { changedLabels_.push_back(label); }
  /// Notes what may change without a label. Call before the spread forgets the label and before its
  /// site is removed.
  void noteLeaving(int label);
  /// Notes what may change around a vertex where the distance of such a label is final.
  void noteLeavingFrom(int vertex, int label) { finding_.noteLeavingFrom(vertex, label); }
  /// Works on at most `budget` units and lowers it by their number; true when all is known. Call it
  /// after labels have spread.
  bool step(long& budget);
  double progress() const { return progress_; }

  /// See `SiteDistances`.
  const IndexSet& changedFaces() const { return changedFaces_; }
  const std::vector<int>& changedLabels() const { return changedLabels_; }

 private:
  bool allotLists(long& budget);
  bool clearLists(SlicedLoop& loop, long& budget);
  void clearList(int vertex);
  bool listLabels(long& budget);
  bool noteExtended(SlicedLoop& loop, long& budget);
  bool ownsPartAround(int label, int vertex) const;

  const TriangleMesh& mesh_;
  const SiteSet& sites_;
  const NearestBounds& bounds_;
  const LabelSpread& spread_;
  const LabelChange& change_;  ///< the current one
  FaceOwners owners_;
  LabelLists lists_;
  OwnerFinding finding_;
  LabelTurns turns_;
  LabelClosure closure_;

  // The current change.
  SlicedSequence sequence_, allotting_;
  ReachedLoop reachedLoop_;
  double progress_ = 0;
  IndexSet changedFaces_;  ///< around changed vertices
  std::vector<int> changedLabels_;
  std::vector<int> roomAt_;  ///< per vertex, the number of labels that come to it
  IndexSet atChanged_{0};    ///< labels at changed vertices, before and after the change
  std::vector<int> listed_;  ///< those that may go into the lists
};

}  // namespace gvd
