// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/partition.h"
#include "partition/convex_triangulation.h"
#include "partition/side_points.h"

namespace gvd {

/// Cuts the faces of a mesh into pieces, in slices. A vertex of the mesh keeps its number, and
/// point i of the diagram has the number `vertexCount() + i` unless it is at a vertex.
class FaceCutting {
 public:
  /// A triangle in a face, of one region.
  struct Piece {
    std::array<int, 3> vertices;
    int label, face;
    double area;
  };

  /// All must outlive this.
  FaceCutting(const TriangleMesh& mesh, const Diagram& diagram, const PartitionOptions& options)
      : mesh_(mesh), diagram_(diagram), options_(options) {}

  bool step(long& budget);

  /// Ascending by face.
  std::vector<Piece> takePieces() { return std::move(pieces_); }
  /// Per face the piece that is all of it; -1 if there is none.
  std::vector<int> takeUncut() { return std::move(uncut_); }

 private:
  void cutFace(int f);
  bool isLeftOut(int f) const;
  void measurePieces(size_t first);
  void addFaceWithSidePoints(int face, std::span<const SidePoints::Point> points);
  void addCell(int cell);
  void triangulate(std::span<const int> polygon, int label, int face);
  Eigen::Vector3d baryOf(int vertex, int face) const;

  const TriangleMesh& mesh_;
  const Diagram& diagram_;
  const PartitionOptions& options_;

  SlicedSequence sequence_;
  std::vector<int> vertexOfPoint_;
  SidePoints sidePoints_{mesh_, diagram_, vertexOfPoint_};
  int nextCell_ = 0;
  std::vector<Piece> pieces_;
  std::vector<int> uncut_;
  // Of the current polygon.
  std::vector<int> polygon_;
  std::vector<Eigen::Vector2d> corners_;
  ConvexTriangulation triangulation_;
};

}  // namespace gvd
