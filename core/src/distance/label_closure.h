// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "base/index_set.h"
#include "base/sliced_loop.h"
#include "distance/face_owners.h"
#include "distance/label_lists.h"
#include "distance/label_turns.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Finds labels known at two corners of a face that have to be known at the third as well, and lets
/// them spread there.
///
/// A diagram interpolates squared distances linearly within a face. If a label owns part of an edge
/// by interpolation, it has to be known at all corners of the faces on both sides. A label added at
/// one vertex may be required at others, so each label goes on until no more is required of it.
///
/// Compares distances as labels have found them: how far `equalizeTies` lowers them depends on the
/// labels known at a vertex, and so on the order of adding. The label in question gets the least
/// distance that a tie may give it, so that it is not missed.
///
/// `LabelCompletion` applies the same rule to the elements of a refined diagram. No label can
/// spread to their corners, so it unfolds the missing distance from the two known ones.
class LabelClosure {
 public:
  /// Adds to `lists` and `owners`. All arguments must outlive this.
  LabelClosure(const TriangleMesh& mesh, LabelSpread& spread, FaceOwners& owners, LabelLists& lists,
               const IndexSet& changedFaces)
      : mesh_(mesh),
        owners_(owners),
        lists_(lists),
        changedFaces_(changedFaces),
        turns_(spread),
        spread_(spread),
        extended_(mesh.vertexCount()) {}

  /// Forgets the previous change.
  void beginChange();
  /// Works on at most `budget` units and lowers it by their number; true when the changed faces are
  /// closed.
  bool step(long& budget);
  /// The vertices to whose lists labels were added.
  const std::vector<int>& extended() const { return extended_.list(); }

 private:
  long closeFace(int face);
  void closeAround(int vertex, int label);
  void requireAcross(int halfedge, int label);
  bool ownsPartOfEdge(int label, int halfedge) const;
  std::vector<int> listRequired(int label, std::span<const int> faces);

  const TriangleMesh& mesh_;
  FaceOwners& owners_;
  LabelLists& lists_;
  const IndexSet& changedFaces_;
  LabelTurns turns_;
  const LabelSpread& spread_;

  // The current change.
  SlicedSequence sequence_;
  std::vector<Requirement> found_;  ///< by the last look at faces
  std::vector<int> added_;          ///< the vertices where the current label was listed last
  IndexSet extended_;
};

}  // namespace gvd
