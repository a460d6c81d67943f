// SPDX-License-Identifier: MIT
/// \file
/// The mesh cut into the regions of a diagram, and facts of each region: area, perimeter,
/// neighbours, topology.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "gvd/diagram.h"
#include "gvd/sliced_work.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// One region of a partition, as a patch of triangles. Lengths and areas are in the mesh's units.
/// Areas are those of the intrinsic surface, lengths those in space, between the points' positions:
/// where the mesh was mollified, a border across a flat triangle is longer on the surface.
///
/// A patch is cut apart where its region touches itself in a single point, which makes it a surface
/// with boundary and does not change its inside. The counts below are those of that surface;
/// `selfTouchings` counts the cuts. Non-manifold edges of the input count as cut
/// (`MeshRepairs::nonManifoldEdges`). The two sides of such a cut may have the same two points, so
/// a program that reads the triangles alone would join them again, and get other counts.
struct RegionPatch {
  struct Neighbour {
    int label;
    double length;  ///< of the border with it, all arcs together
  };

  int label = Diagram::kUnreachable;
  /// Its triangles: `firstTriangle` … `firstTriangle + triangleCount - 1`. None for a site without
  /// region (it coincides with another one); everything below is zero then, the centroid NaN, and
  /// `nearCentroid` on no face.
  int firstTriangle = 0, triangleCount = 0;

  double area = 0;
  /// The length of its outline: borders, mesh boundary, and holes left for indifferent faces.
  double perimeter = 0;
  double boundaryLength = 0;          ///< the part of the perimeter without a region beyond
  std::vector<Neighbour> neighbours;  ///< ascending by label; without what was left out

  /// The mean of its points by area (by triangle, if it has no area), in space: off the surface
  /// where the surface is bent.
  Eigen::Vector3d centroid = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  /// The point of the region that is nearest to the centroid, in space.
  SurfacePoint nearCentroid;

  int components = 0;
  int loops = 0;  ///< closed outlines
  int eulerCharacteristic = 0;
  int genus = 0;  ///< all components: (2·components - loops - eulerCharacteristic) / 2
  /// How often it touches itself in a point: at each point, the number of its fans of triangles
  /// minus one.
  int selfTouchings = 0;
};

/// A mesh cut into the regions of a diagram (Melvær & Reimers 2014, section 7.2): the mesh's own
/// triangles where one region owns all of them, and the parts of the others, triangulated. It is
/// one mesh: regions share the vertices on their borders, so the partition is closed exactly where
/// the input was. Triangles keep the side of the face they are part of.
///
/// Parts of a face are convex; of their triangulations, the Delaunay triangulation is taken, the
/// one with the largest least angle. A triangle has zero area only if its face has, or if points
/// that differ only by rounding leave no choice.
struct Partition {
  /// Vertices: those of the mesh that are in use, in their order, then the points of the diagram.
  std::vector<SurfacePoint> points;  ///< `face` counts the mesh's faces
  std::vector<Eigen::Vector3d> positions;

  /// Ascending by label, then by face; triangles that no site reaches come last.
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> triangleLabel;  ///< region, or `Diagram::kUnreachable`
  std::vector<int> triangleFace;   ///< the mesh face it is part of
  /// Per halfedge (3t + i runs from corner i of triangle t to the next, as in `TriangleMesh`), the
  /// halfedge of the neighbour that runs the other way; -1 where there is none.
  std::vector<int> twins;

  std::vector<RegionPatch> regions;  ///< one per site; `regions[l].label == l`
  RegionPatch unreachable;           ///< the part that no site reaches, as if it were a region
};

struct PartitionOptions {
  /// Leaves holes where two or more labels tie on a whole face, instead of giving it to the lowest.
  bool leaveOutIndifferent = false;
  /// Leaves out the components without a site.
  bool leaveOutUnreachable = false;
};

/// Cuts a mesh along a diagram of it. O(F + M log M), M the number of points of the diagram; for
/// each cell of k corners, O(k²) is added. Throws `Error(kInvalidArgument)` if the diagram has
/// another number of faces.
/// Source: Eivind Lyche Melvær, Martin Reimers. Approximating Geodesic Voronoi Diagrams on
/// Triangulated Surfaces. 2014.
Partition partition(const TriangleMesh& mesh, const Diagram& diagram,
                    const PartitionOptions& options = {});

/// The same in steps. Mesh and diagram must outlive the work.
std::unique_ptr<SlicedWork<Partition>> startPartition(const TriangleMesh& mesh,
                                                      const Diagram& diagram,
                                                      const PartitionOptions& options = {});

/// The corners of a triangle of a partition in terms of `triangleFace[triangle]`: column i holds
/// the barycentric coordinates of corner i. `Partition::points` gives a vertex that lies on an edge
/// or a vertex of the mesh in only one of the faces around it; use the coordinates given here to
/// interpolate values that differ from face to face, such as texture coordinates at a seam. O(1).
Eigen::Matrix3d cornersInFace(const TriangleMesh& mesh, const Partition& partition, int triangle);

}  // namespace gvd
