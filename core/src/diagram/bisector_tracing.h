// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "diagram/bisector_graph.h"
#include "diagram/face_complex.h"
#include "diagram/face_envelope.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Makes the graph: in every element of several regions the lower envelope.
class BisectorTracing {
 public:
  BisectorTracing(const FaceComplex& complex, int siteCount, NodePoints& nodePoints,
                  BisectorGraph& graph);
  /// True when the graph is complete.
  bool step(long& budget);

 private:
  /// A vertex of the envelope at hand.
  struct Corner {
    int point;
    Eigen::Vector3d bary;  ///< in terms of the face
    bool isInside = false;
    /// Whether it is inside, and about as near to two sides as points are merged at.
    bool isBetweenSides = false;
  };
  /// The element at hand.
  struct Element {
    int index, face;
    bool isWhole;                         ///< it is all of its face
    int firstSlot;                        ///< of its sides in firstOnSide_
    std::array<double, 3> squaredLength;  ///< of the face's sides
    double longest;                       ///< of these sides
  };

  bool fillLists(long& budget);
  void noteMixed(int element);
  void reserve();
  bool divideAll(long& budget);
  void giveUpTo(int end);
  void divideContested(int element);
  void give(int element, int owner);
  void divide(int element, int soleOwner, int firstSlot);
  bool isIndifferent(int element, int owner) const;
  void gatherFunctions(int element, int soleOwner);
  void dropHiddenFunctions(int element);
  void addPoints(const Element& element);
  void addCells(const Element& element);
  double addCell(const Element& element, const FaceEnvelope::Cell& cell);
  void addAreas(std::span<double> areas, double faceArea);
  bool hasUnmatchedSide(int element) const;
  void addCut(const Element& element, const FaceEnvelope::Cut& cut);
  void tellApartInnerPoints();
  int pointAt(const Element& element, int vertex);
  int pointOnSide(const Element& element, const FaceEnvelope::Vertex& v,
                  const Eigen::Vector3d& bary);
  void mergeOnSide(const Element& element, int side, int point, int others,
                   const Eigen::Vector3d& bary);
  static bool isApart(const Element& element, int side, double share, double distance);
  int slotOf(const Element& element, int side) const;
  int pointOfNode(const Element& element, int node, const Eigen::Vector3d& bary);
  void addUnmatchedSide(const Element& element, int side, int vertex);
  void addBoundaryPoint(int h, int vertex);
  double heightOf(const Element& element) const;
  bool isBetweenSides(const Element& element, const Eigen::Vector3d& bary) const;
  bool mayBeOne(const Corner& a, const Corner& b);
  void addSegment(const Element& element, const Corner& from, const Corner& to, int left,
                  int right);
  void leave(int point, int label, int dart);
  void arrive(int point, int label, int dart);
  double sideError(const Element& element, const FaceEnvelope::Vertex& v) const;
  double insideError(const FaceEnvelope::Vertex& v, double longest) const;
  int label(int function) const { return functions_[function].label; }
  const std::array<double, 3>& value(int function) const { return functions_[function].value; }

  const TriangleMesh& mesh_;
  const FaceComplex& complex_;
  const std::span<const int> tail_, twin_;
  NodePoints& nodePoints_;
  BisectorGraph& graph_;
  /// What distances are multiplied by in functions: a power of two, so that nothing is rounded, by
  /// which they are about 1. Determinants have products of six distances.
  const double unit_;

  enum class Stage { kLists, kNoteMixed, kDivide, kDone } stage_ = Stage::kLists;
  SlicedLoop loop_;
  size_t nextContested_ = 0;
  int next_ = 0;  ///< element
  int siteCount_, mixedCount_ = 0;
  std::vector<int> mixedIndex_;  ///< per element, -1 if it has one owner or none
  /// Per side of mixed elements, the first in a list of points of the graph, -1 for none. A side
  /// that two have in common is the one of that with the lower index.
  std::vector<int> firstOnSide_;

  // For the element at hand.
  std::vector<LabelFunction> functions_;
  FaceEnvelope envelope_;
  std::vector<Corner> corners_;  ///< per vertex of the envelope
  std::vector<double> cellAreas_;
};

}  // namespace gvd
