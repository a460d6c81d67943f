// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <span>
#include <utility>
#include <vector>

#include "base/index_set.h"
#include "base/sliced_loop.h"
#include "distance/face_owners.h"
#include "distance/label_change.h"
#include "distance/label_lists.h"
#include "distance/label_spread.h"
#include "distance/label_turns.h"
#include "distance/nearest_bounds.h"
#include "distance/reached_loop.h"
#include "distance/site_set.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Finds the owners of faces (`FaceOwners`) after labels have spread: labels that are nearest at a
/// corner, ties included, or have their site there. After a change, only in the faces where they
/// may differ from before.
class OwnerFinding {
 public:
  /// `step` changes `bounds`: where labels tie, the lowest becomes the owner of the vertex. It
  /// marks the distances of owners in `spread` as final, and reads in `lists` what was known
  /// before. `change` is the current one. All arguments must outlive this.
  OwnerFinding(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds,
               LabelSpread& spread, const LabelChange& change, const LabelLists& lists,
               FaceOwners& owners)
      : mesh_(mesh),
        sites_(sites),
        bounds_(bounds),
        spread_(spread),
        change_(change),
        lists_(lists),
        owners_(owners),
        affectedFaces_(mesh.faceCount()),
        changedVertices_(mesh.vertexCount()) {}

  /// Forgets the previous change.
  void beginChange();
  /// Notes that the owners of the faces that a label's site is in may change.
  void addFacesOfSite(int label);
  /// Notes the faces around a vertex that a label owns a part of: their owners may change without
  /// it. Call before the site of the label is removed.
  void noteLeavingFrom(int vertex, int label);
  /// Works on at most `budget` units and lowers it by their number; true when all are found. Call
  /// it after labels have spread.
  bool step(long& budget);

  /// The distances that have to be known because of the owners found.
  const std::vector<Requirement>& requirements() const { return requirements_; }
  /// The vertices where other labels may be known than before, or other distances.
  const IndexSet& changedVertices() const { return changedVertices_; }

 private:
  struct LabelAtVertex {
    int vertex, label;
  };
  bool markFinal(std::span<const int> labels, long& budget);
  void noteTie(int vertex, int label);
  bool affectAll(long& budget);
  bool findAffected(long& budget);
  void doubt(int vertex, int label);
  void doubtInterpolated(int vertex);
  bool dropDoubtful(long& budget);
  long findTies(int vertex);
  void addTie(const LabelAtVertex& tie);

  const TriangleMesh& mesh_;
  const SiteSet& sites_;
  NearestBounds& bounds_;
  LabelSpread& spread_;
  const LabelChange& change_;  ///< the current one
  const LabelLists& lists_;
  FaceOwners& owners_;

  // The current change.
  SlicedSequence sequence_, affecting_;
  ReachedLoop reachedLoop_;
  std::vector<int> newlyFinal_;      ///< vertices where a distance has become final
  std::vector<LabelAtVertex> ties_;  ///< labels that are as near as the owner
  IndexSet affectedFaces_;           ///< faces whose owners may have changed
  IndexSet changedVertices_;
  std::vector<LabelAtVertex> doubtful_;  ///< labels that may not be known any more
  std::set<std::pair<int, int>> isDoubtful_;
  std::size_t droppedCount_ = 0;  ///< of `doubtful_`, those dropped already
  std::vector<Requirement> requirements_;
};

}  // namespace gvd
