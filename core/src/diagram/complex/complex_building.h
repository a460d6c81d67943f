// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "base/sliced_loop.h"
#include "diagram/complex/element_splitting.h"
#include "diagram/complex/face_complex.h"
#include "distance/ties.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Builds a complex of all faces of a mesh, or of one part of it after another: adds faces and
/// nodes, splits mixed faces, matches twins and finds owners.
class ComplexBuilding {
 public:
  enum class Extent { kMesh, kPart };

  /// Mixed faces are split as `DiagramOptions::detail` says, with distances at the new nodes. The
  /// mesh and the distances must outlive this.
  ComplexBuilding(const TriangleMesh& mesh, const DistanceField& distances, int detail,
                  Extent extent);
  /// Begins to replace the part by another one: some faces, given ascending. Only the nodes of
  /// these have owners. Takes time for the new faces and the previous ones only.
  void startPart(std::span<const int> faces);
  /// The complex is complete once this has returned true.
  bool step(long& budget);
  /// Whether mixed faces are split, which takes most of the time of tracing.
  bool splitsFaces() const { return detail_ > 0; }
  /// The share of the elements that splitting is expected to make; it may end below 1.
  double progress() const;

  FaceComplex& complex() { return complex_; }
  const FaceComplex& complex() const { return complex_; }

 private:
  bool addMesh(long& budget);
  void matchTwin(int h);
  void addFace(int face);
  double expectedParts(int face) const;
  void clear();
  void ownFacesAround(int vertex);
  void findOwner(int element);

  const TriangleMesh& mesh_;
  const DistanceField& distances_;
  const int detail_;
  const double longestSide_;  ///< of mixed elements, if these are split
  const TieTolerance ties_;
  FaceComplex complex_;

  SlicedSequence sequence_, adding_;
  double partsExpected_ = 0;  ///< of mixed faces
  std::optional<ElementSplitting> splitting_;
};

}  // namespace gvd
