// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "diagram/bisector_graph.h"
#include "diagram/face_complex.h"
#include "diagram/face_envelope.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Makes the points of the graph for the vertices of envelopes, each with an error bound for
/// rounding. Neighbouring elements share the points on their common side and at its ends. Points on
/// one side whose error bounds overlap are merged here.
class ElementPoints {
 public:
  /// A vertex of an envelope.
  struct PlacedVertex {
    int point = -1;        ///< -1: no cell has the vertex any more
    Eigen::Vector3d bary;  ///< in the face
    bool isInside = false;
    /// Whether it is inside and so near to a corner of the element that it could be merged with it.
    bool isNearCorner = false;
  };

  ElementPoints(const FaceComplex& complex, NodePoints& nodePoints, BisectorGraph& graph);
  /// Allocates the lists, before any point is made; true when done.
  bool prepare(long& budget);
  /// The points of an element, per vertex of its envelope; valid until the next call.
  std::span<const PlacedVertex> of(int element, const FaceEnvelope& envelope);
  /// The point at a node, which lies at `bary` in an element's face.
  int atNode(int element, int node, const Eigen::Vector3d& bary);

 private:
  using Vertex = FaceEnvelope::Vertex;

  int make(int element, const FaceEnvelope& envelope, const Vertex& v, const Eigen::Vector3d& bary);
  int makeOnSide(int element, const FaceEnvelope& envelope, const Vertex& v,
                 const Eigen::Vector3d& bary);
  void mergeOnSide(int element, int side, int point, int others, const Eigen::Vector3d& bary);
  bool isNearCorner(int element, const Eigen::Vector3d& bary) const;
  void tellApartInnerPoints(int face);
  int sideOf(int element, int side) const;

  const TriangleMesh& mesh_;
  const FaceComplex& complex_;
  NodePoints& nodePoints_;
  BisectorGraph& graph_;

  SlicedSequence sequence_;
  /// The first point in the list of each side (`Point::nextOnSide`), by the lower of the side's two
  /// halfedges; -1 for none.
  std::vector<int> firstOnSide_;
  // Of the current element.
  std::vector<PlacedVertex> placed_;
  std::vector<Eigen::Vector3d> places_;  ///< that have a point
};

}  // namespace gvd
