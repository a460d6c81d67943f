// SPDX-License-Identifier: MIT
//
// Results as JavaScript gets them, with the names that `src/api/results.ts` declares. Faces and
// points are those of the input.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "abi.h"
#include "gvd/diagram.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/partition.h"
#include "gvd/polygon_mesh.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::abi {

/// A diagram as traced, with the mesh that it is on.
struct DiagramOnMesh {
  std::shared_ptr<const TriangleMesh> mesh;
  std::shared_ptr<const Diagram> diagram;
};

/// `SurfacePoints`, or `PlacedPoints` with their positions, made in slices.
class PointsRecording {
 public:
  /// The mesh and the points must outlive this.
  PointsRecording(const TriangleMesh& mesh, std::span<const SurfacePoint> points, bool isPlaced);
  /// Works for `budget` units and lowers it by their number; true when all points are recorded.
  bool step(long& budget);
  /// The share of points that are recorded.
  double progress() const;
  Record take();

 private:
  const TriangleMesh& mesh_;
  const std::span<const SurfacePoint> points_;
  const bool isPlaced_;
  SlicedLoop loop_;
  std::vector<int> face_;
  std::vector<Eigen::Vector3d> bary_, position_;
};

/// `SurfacePoints`.
Record pointsRecord(const TriangleMesh& mesh, std::span<const SurfacePoint> points);
/// `PlacedPoints`.
Record placedRecord(const TriangleMesh& mesh, std::span<const SurfacePoint> points);
/// `SurfacePath`.
Record pathRecord(const TriangleMesh& mesh, std::span<const SurfacePoint> path);
/// `DiagramData`, in slices.
std::unique_ptr<SlicedWork<Record>> diagramRecording(const DiagramOnMesh& on);
/// `DiagramChange`, of the site that had or has the label.
Record changeRecord(const TriangleMesh& mesh, int label, DiagramChange change);
/// `Partition`. Its triangles name input triangles already; `points` is the record of its points,
/// and `corners` has the corners of its triangles, three each, as coordinates in these input
/// triangles.
Record partitionRecord(const TriangleMesh& mesh, Partition partition, Record points,
                       std::vector<Eigen::Vector3d> corners);
/// `PolygonMesh`; `points` is the record of its points.
Record polygonRecord(PolygonMesh polygons, Record points, PolygonTriangles cut,
                     const PolygonTopology& topology);

}  // namespace gvd::abi
