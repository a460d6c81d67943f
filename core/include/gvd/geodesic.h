// SPDX-License-Identifier: MIT
/// \file
/// Geodesic distances of many sites at once: the first of the two steps to a diagram. The second
/// one is in diagram.h.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "gvd/sliced_work.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// How geodesic distance is measured.
enum class Metric {
  kExact,  ///< polyhedral distance, exact: continuous Dijkstra over windows (Mitchell et al. 1987)
  kDgpc,   ///< approximate; quicker with few sites: DGPC, from vertex to vertex by unfolding
           ///< triangles (Melvær & Reimers 2012)
};

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The distance of one site at a place. A label is the index of a site in the list of sites.
struct LabelledDistance {
  int label = -1;               ///< -1: no site reaches this place
  double distance = kInfinity;  ///< in the mesh's units
};

/// A point of the surface, and the label whose distance is wanted there.
struct LabelledPoint {
  int label;
  SurfacePoint point;
};

/// The nearest of some sites; of sites that tie, the first. Label -1 if there is none.
inline LabelledDistance nearestOf(std::span<const LabelledDistance> sites) {
  LabelledDistance nearest;
  for (const LabelledDistance& d : sites)
    if (d.distance < nearest.distance) nearest = d;
  return nearest;
}

/// The distances of all sites, each known where a Voronoi diagram needs it. A site is known at all
/// three corners of a face if
///  - it is the nearest site at one of the corners,
///  - it lies in the face, or
///  - it is the nearest site somewhere on a side of the face, with squared distances interpolated
///    linearly between the ends of the side, as diagrams are traced. (Not if the side is one of
///    the two of a single edge that is cut: these share their ends, but not what is near them.)
///
/// With `kDgpc`, the distance at a corner that another site owns may be extended from the vertices
/// around it instead of being propagated to it. And distances depend on the order in which vertices
/// are reached, which follows from the edges of all components (`shortEdgeLength`): mostly in the
/// last bits, but where triangles are steep, single ones by tens of percent.
///
/// Distances at a vertex tie if they differ by no more than rounding: 2^-41 of their length plus
/// 2^-46 of the longest edge. All are then listed as the least of them, and the lowest label is the
/// nearest. At other points, too, the lowest of the labels that tie is the nearest, but labels
/// known at all corners of the point's face, or at both ends of its edge, are preferred. With the
/// exact metric, ties at distances beyond eight bounding diagonals may be missed.
///
/// Points are in terms of the mesh's faces; `Error(kInvalidPoint)` if one is not on the mesh. A
/// vertex that is asked for must exist; a label may be any number, and is not known anywhere if no
/// site has it. Queries at points share working memory: several threads may call `at` and
/// `direction` at the same time, but no other function, and none that takes the field and asks it
/// about points (tracing with `detail`, `accuracy`, `dualPaths`, `repairingSites`, `WorstRegions`).
class DistanceField {
 public:
  virtual ~DistanceField() = default;
  /// The labels known at vertex v, ascending by label; empty if no site reaches v. O(1).
  virtual std::span<const LabelledDistance> at(int vertex) const = 0;
  /// The nearest site at a point and its distance; label -1 and infinity if no site reaches it.
  /// With the exact metric, O(faces that the shortest path crosses) where they are well shaped;
  /// with DGPC, O(labels known at the corners of its face).
  LabelledDistance nearest(const SurfacePoint& p) const {
    long budget = std::numeric_limits<long>::max();
    return nearest(p, budget);
  }
  /// The same as a part of sliced work: lowers the budget by about as many microseconds as the
  /// search takes, also below zero.
  virtual LabelledDistance nearest(const SurfacePoint& p, long& budget) const = 0;
  /// The distance of one site at a point; infinity where it is not known. For the nearest site as
  /// quick as `nearest`, for another one as slow as `distancesAt`.
  virtual double distance(int label, const SurfacePoint& p) const = 0;
  /// Starts to find distances at many points: infinity where a label is neither the nearest nor
  /// known at the corners of the point's face, or at both ends of its edge. With the exact metric,
  /// each of the sites spreads once more, as far as it is nearest and on to its points, which takes
  /// about as long as the first time, and a point where its label is not known, as long as
  /// `nearest`. Distances that were found are kept until their site is removed. A point that is not
  /// on the mesh throws `Error(kInvalidPoint)` in a step. The field must outlive the work, and
  /// sites must not change until it is done.
  virtual std::unique_ptr<SlicedWork<std::vector<double>>> startDistancesAt(
      std::vector<LabelledPoint> points) const = 0;
  /// The same without steps.
  std::vector<double> distancesAt(std::vector<LabelledPoint> points) const {
    return finished(startDistancesAt(std::move(points)));
  }
  /// The direction in which the shortest path from a site to a vertex leaves the site, as a unit
  /// vector: together with the distance, geodesic polar coordinates (the logarithmic map). With the
  /// exact metric it is also the negative gradient of the distance with respect to the site. The
  /// x axis is the first side of the site's face, the y axis lies to its left; faces beside a site
  /// on an edge or vertex are unfolded counterclockwise, around a vertex beginning with
  /// `TriangleMesh::outgoing`. So at a site on a saddle vertex, where the angles add up to more
  /// than 2π, two paths may have one direction. (1, 0) at the site itself; not a number where it is
  /// not known. O(log k) for k labels known at the vertex.
  virtual Eigen::Vector2d direction(int label, int vertex) const = 0;
  /// The shortest path from a point to a site: the point, every crossing of an edge, every vertex
  /// that the path turns at or passes, the site as it was given. Crossings have an exact zero,
  /// vertices are unit vectors; each is given in a face that the path runs through. Two points in
  /// succession have a face in common, in which the path between them is straight. One point if `p`
  /// is at the site; empty if the site does not reach it. With the exact metric the path is as long
  /// as the distance (`lengthOf`), up to rounding: a path that passes a vertex within 1e-12 of an
  /// edge's length leads through it. With DGPC the path follows from the distances at vertices, and
  /// its length may differ from the distance; if it would be longer by more than a tenth, or if
  /// these distances lead nowhere, the path is the shortest one by the exact metric. O(vertices
  /// that the site has reached), then O(faces around the points of the path), or the time of
  /// `shortestPath` in that last case and where `distance` is infinite.
  virtual std::vector<SurfacePoint> path(int label, const SurfacePoint& p) const = 0;
};

/// Distances of sites, computed in steps. The field refers to the mesh, which must outlive it.
using Propagation = SlicedWork<std::unique_ptr<DistanceField>>;

/// Starts to find the distances of all `sites`, given in the mesh's faces, one label each. Sites
/// may share a face, lie on edges or vertices, and outnumber the vertices. Of sites at one place,
/// only the one with the lowest label takes part; the others are not known anywhere. A site with
/// face -1 is a label without a site. Throws `Error(kInvalidArgument)` if there is no site,
/// `Error(kInvalidPoint)` if one is not on the mesh.
///
/// Each site spreads about as far as it is nearest. For a site that is nearest on n vertices, this
/// takes about O(n) with DGPC; with the exact metric O(n²) at worst, about O(n^1.5) on most meshes.
/// O(F) is added, and O(k²) for k sites in one face.
std::unique_ptr<Propagation> propagate(const TriangleMesh& mesh,
                                       std::span<const SurfacePoint> sites, Metric metric);

/// The length of a path of straight pieces within faces, by the intrinsic lengths of edges;
/// infinity if two points in succession have no face in common. Throws `Error(kInvalidPoint)` if a
/// point is not on the mesh. O(points), and O(k) for each vertex with k faces around it.
double lengthOf(const TriangleMesh& mesh, std::span<const SurfacePoint> path);

/// Starts to find the shortest path between two points by the exact metric, as
/// `DistanceField::path` gives it from `from` to a site at `to`; empty if the points are in
/// different components. Windows spread from `to` only while they can still be part of a path that
/// is no longer than the shortest one along edges: O(vertices) to begin with, then the time of
/// distances in an ellipse around the two points. Throws `Error(kInvalidPoint)` if a point is not
/// on the mesh, which must outlive the work.
std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startShortestPath(const TriangleMesh& mesh,
                                                                         const SurfacePoint& from,
                                                                         const SurfacePoint& to);
/// The same without steps.
std::vector<SurfacePoint> shortestPath(const TriangleMesh& mesh, const SurfacePoint& from,
                                       const SurfacePoint& to);

}  // namespace gvd
