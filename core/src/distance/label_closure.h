// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "distance/face_owners.h"
#include "distance/label_lists.h"
#include "distance/nearest_bounds.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Which labels have to be known at the third corner of a face, since they are at the other two.
///
/// A diagram takes squared distances as linear within a face, up to what all labels have in common.
/// If by that a label owns part of an edge, the faces on both sides have to know it at all corners.
///
/// `LabelCompletion` keeps the same rule on the parts of faces that a finer diagram is traced on.
/// It has no spread to require distances of, and unfolds them from the two corners instead.
class LabelClosure {
 public:
  /// All must outlive this, which adds owners of faces.
  LabelClosure(const TriangleMesh& mesh, const LabelLists& lists, const NearestBounds& bounds,
               FaceOwners& owners)
      : mesh_(mesh), lists_(lists), bounds_(bounds), owners_(owners) {}

  /// Adds to `required` what labels known at two corners of a face require at the third.
  void closeFace(int face, std::vector<Requirement>& required);
  /// The same of the faces around a vertex at which a label has become known.
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
