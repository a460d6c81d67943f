// SPDX-License-Identifier: MIT
//
// Results as JavaScript gets them, with the names that `src/results.ts` declares. Faces and points
// are those of the input.
#pragma once

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

/// `SurfacePoints`.
Record pointsRecord(const TriangleMesh& mesh, std::span<const SurfacePoint> points);
/// `PlacedPoints`.
Record placedRecord(const TriangleMesh& mesh, std::span<const SurfacePoint> points);
/// `SurfacePath`.
Record pathRecord(const TriangleMesh& mesh, std::span<const SurfacePoint> path);
/// `DiagramData`.
Record diagramRecord(const TriangleMesh& mesh, Diagram diagram);
/// `DiagramChange`, of the site that had or has the label.
Record changeRecord(const TriangleMesh& mesh, int label, DiagramChange change);
/// `Partition`; `corners` are those of its triangles, three each, in terms of the input triangles
/// that these are part of.
Record partitionRecord(const TriangleMesh& mesh, Partition partition,
                       std::vector<Eigen::Vector3d> corners);
/// `PolygonMesh`.
Record polygonRecord(const TriangleMesh& mesh, PolygonMesh polygons);

}  // namespace gvd::abi
