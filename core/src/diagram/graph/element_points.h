// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "base/index_map.h"
#include "base/sliced_loop.h"
#include "diagram/complex/face_complex.h"
#include "diagram/graph/bisector_graph.h"
#include "diagram/graph/face_envelope.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Makes the points of the graph for the vertices of envelopes, each of which has an error bound
/// for rounding. Neighbouring elements share the points on their common side and at its ends.
/// Points whose error bounds overlap are merged here, if they are on one side or at the ends of one
/// segment.
class ElementPoints {
 public:
  /// A vertex of an envelope.
  struct PlacedVertex {
    int point = -1;        ///< -1: no cell has the vertex any more
    Eigen::Vector3d bary;  ///< in the face
  };

  /// Adds points to `graph`, and to `pointOfNode` those at nodes.
  ElementPoints(const FaceComplex& complex, IndexMap& pointOfNode, BisectorGraph& graph);
  /// Allocates the lists, before any point is made; true when done.
  bool prepare(long& budget);
  /// Makes the points of an element, or finds those that its neighbours have made.
  void make(int element, const FaceEnvelope& envelope);
  /// A vertex of the envelope given last.
  const PlacedVertex& operator[](int vertex) const { return placed_[vertex]; }
  /// The point at a node, which lies at `bary` in an element's face. Inlined, because most nodes
  /// have one already.
  int atNode(int element, int node, const Eigen::Vector3d& bary) {
    if (pointOfNode_[node] < 0)
      pointOfNode_.add(node, graph_.addNode(complex_.face(element), bary));
    return pointOfNode_[node];
  }
  /// Merges the points at the ends of segments within their error bounds, if one of them is inside.
  void mergeEnds(const FaceEnvelope& envelope);

 private:
  using Vertex = FaceEnvelope::Vertex;

  int makeOnSide(int element, const FaceEnvelope& envelope, const Vertex& v,
                 const Eigen::Vector3d& bary);
  void mergeOnSide(int element, const FaceEnvelope& envelope, const Vertex& v, int point,
                   const Eigen::Vector3d& bary);
  bool mergeEnds(const FaceEnvelope& envelope, const FaceEnvelope::Segment& segment);
  bool isNearCorner(const FaceEnvelope& envelope, const Vertex& v) const;
  bool areNear(std::span<const Vertex> vertices);
  void tellApartInnerPoints(int face, std::span<const Vertex> vertices);

  const TriangleMesh& mesh_;
  const FaceComplex& complex_;
  IndexMap& pointOfNode_;  ///< in the graph
  BisectorGraph& graph_;

  /// Per element, the first point in the list of those on its sides (`Point::side`), -1 for none.
  std::vector<int> firstPoint_;
  // Of the current element's envelope.
  std::vector<PlacedVertex> placed_;    ///< per vertex
  std::vector<Eigen::Vector3d> inner_;  ///< places of the inner vertices, by one coordinate
};

}  // namespace gvd
