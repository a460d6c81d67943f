// SPDX-License-Identifier: MIT
/// \file
/// Polygons with corners on a surface: what duals (dual.h) are made of.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "gvd/diagram.h"
#include "gvd/sliced_work.h"
#include "gvd/surface_point.h"

namespace gvd {

/// A mesh of polygons with corners on a surface, counterclockwise as that is. Sides are straight in
/// space, so they leave the surface where it is bent. The functions below throw
/// `Error(kInvalidArgument)` if a face has a vertex without a position. They and `measureQuality`
/// read positions and faces only, so a mesh made by the caller needs no other members.
struct PolygonMesh {
  std::vector<SurfacePoint> points;  ///< vertices; `face` counts the faces of the triangle mesh
  std::vector<Eigen::Vector3d> positions;
  PointLists faces;
  std::vector<int> vertexLabel;  ///< region of each vertex; empty in a mesh of regions
  std::vector<int> faceLabel;    ///< region of each face; empty in a dual mesh
};

/// A polygon mesh cut into triangles, without more vertices.
struct PolygonTriangles {
  std::vector<std::array<int, 3>> triangles;  ///< vertices; ascending by `face`
  std::vector<int> face;                      ///< the face each is part of
};

/// Cuts every polygon along diagonals: as a Delaunay triangulation of its projection to the plane
/// of its mean normal, where that is convex. No diagonal joins two vertices that a side or an
/// earlier diagonal joins, where there is another choice: there is one in a dual without
/// violations. Sides and orientation stay, and so does the topology then. In a dual, a site may
/// have two polygons only, as its region is cut off by another one, together with a run of the
/// boundary: both could get the same diagonal. O(n + d²) for n corners in all, and for a polygon
/// of d corners, three or more; those with fewer have no triangle.
PolygonTriangles triangulate(const PolygonMesh& mesh);
/// The same in steps. Here and below, the mesh must outlive the work.
std::unique_ptr<SlicedWork<PolygonTriangles>> startTriangulation(const PolygonMesh& mesh);

/// The topology of the surface that the faces of a polygon mesh make, joined at the vertices they
/// share. Vertices without a face and faces without corners do not count.
struct PolygonTopology {
  /// Whether the faces are a surface, oriented: no corner occurs twice in a face, no side twice in
  /// one direction, and the faces around each vertex form one fan. If not, the numbers of boundary
  /// loops and the genus mean nothing.
  bool isManifold = false;
  int vertices = 0, edges = 0, faces = 0;
  int components = 0;
  int boundaryLoops = 0;
  int eulerCharacteristic = 0;  ///< V - E + F
  int genus = 0;  ///< all components: (2·components - boundaryLoops - eulerCharacteristic) / 2
};

/// O(n log n) for n corners of faces.
PolygonTopology topologyOf(const PolygonMesh& mesh);
std::unique_ptr<SlicedWork<PolygonTopology>> startTopology(const PolygonMesh& mesh);

}  // namespace gvd
