// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "distance/face_owners.h"
#include "distance/label_lists.h"
#include "distance/nearest_bounds.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Finds labels known at two corners of a face that have to be known at the third as well.
///
/// A diagram interpolates squared distances linearly within a face. If a label owns part of an edge
/// by interpolation, it has to be known at all corners of the faces on both sides.
///
/// `LabelCompletion` applies the same rule to the elements of a refined diagram. No label can
/// spread to their corners, so it unfolds the missing distance from the two known ones.
class LabelClosure {
 public:
  /// Adds to `owners`. All arguments must outlive this.
  LabelClosure(const TriangleMesh& mesh, const LabelLists& lists, const NearestBounds& bounds,
               FaceOwners& owners)
      : mesh_(mesh), lists_(lists), bounds_(bounds), owners_(owners) {}

  /// Adds to `required` the labels that are known at two corners of a face and required at the
  /// third.
  void closeFace(int face, std::vector<Requirement>& required);
  /// The same for one label, newly known at a vertex, in all faces around the vertex.
  void closeAround(int vertex, int label, std::vector<Requirement>& required);

 private:
  void requireAcross(int halfedge, int label, std::vector<Requirement>& required);
  bool ownsPartOfEdge(int label, int halfedge) const;

  const TriangleMesh& mesh_;
  const LabelLists& lists_;
  const NearestBounds& bounds_;
  FaceOwners& owners_;
};

}  // namespace gvd
