// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/sliced_work.h"
#include "gvd/triangle_mesh.h"
#include "mesh/input_map.h"
#include "mesh/manifold_building.h"
#include "mesh/mollification.h"
#include "mesh/point_grid.h"
#include "mesh/triangle_selection.h"
#include "mesh/vertex_welding.h"

namespace gvd {

/// Builds a manifold from any list of triangles, by the steps listed at `TriangleMesh`.
/// Each step writes into the faces of the mesh, and intermediate results are freed as soon as no
/// later step needs them, so that building takes no more memory than the finished mesh.
class MeshBuilding final : public SlicedWork<TriangleMesh> {
 public:
  MeshBuilding(std::vector<double> positions, std::vector<int> triangles,
               const MeshOptions& options);
  bool advance(long budget) override;
  double progress() const override;
  TriangleMesh result() override { return std::move(mesh_); }

 private:
  bool makeManifold(long& budget);
  bool placeVertices(long& budget);
  bool measure(long& budget);
  bool findBoundary(long& budget);

  int inputVertexCount() const { return static_cast<int>(positions_.size() / 3); }
  void takeFaces();
  void takeFans();
  void listFan(int vertex);
  void takePosition(int vertex);
  void requireExtent();
  void findShortEdgeLength();
  void requireEdgeLength() const;
  void measureFace(int face);
  void noteFlatness(int face, double leastExcess);
  void setFace(int face, const IntrinsicTriangle& triangle);
  IntrinsicTriangle triangle(int face) const;
  void sumUp(int face);
  void followLoopFrom(int vertex);
  void sampleBoundary();
  void lookForSeam(int vertex);
  void countTopology();

  std::vector<double> positions_;  ///< the input's, later the mesh's
  std::vector<int> triangles_;     ///< the input's
  const MeshOptions options_;
  TriangleMesh mesh_;

  SlicedSequence making_, placing_, measuring_, finding_;  ///< the stages
  SlicedLoop loop_;
  std::optional<VertexWelding> welding_;
  std::vector<int> representative_;
  std::optional<TriangleSelection> selecting_;
  Selection selection_;
  std::optional<HalfedgeMatching> matching_;
  std::optional<TriangleOrienting> orienting_;
  OrientedComponents oriented_;
  std::optional<SmallComponents> dropping_;
  std::optional<FanSplitting> splitting_;
  Fans fans_;
  int firstCopy_ = 0;  ///< vertices from this one on are copies for further fans
  std::optional<InputMap> mapping_;
  Eigen::AlignedBox3d box_;
  /// The least excess of the faces that may turn out to be flat.
  std::vector<std::pair<int, double>> maybeFlat_;
  std::vector<char> isOnFoundLoop_;  ///< vertices
  std::vector<int> boundary_;        ///< vertices, along the loops
  std::optional<PointGrid> boundarySamples_;
};

}  // namespace gvd
