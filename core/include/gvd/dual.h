// SPDX-License-Identifier: MIT
/// \file
/// The dual of a diagram, a polygonal base mesh; the conditions under which it has the topology of
/// the surface; and its repair by further sites.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gvd/diagram.h"
#include "gvd/geodesic.h"
#include "gvd/polygon_mesh.h"
#include "gvd/sliced_work.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The dual of a diagram: a polygonal base mesh. The first vertices are the sites, ascending by
/// label (`vertexLabel`): vertex l is site l, unless labels before it have no site. Every Voronoi
/// point of degree d is a d-gon of the sites around it. Where no four sites are equidistant from
/// one point, this is a geodesic Delaunay triangulation.
///
/// To extend the dual from the outermost sites to the mesh boundary, every *run*, a piece of the
/// mesh boundary in one region, gets a vertex of its own, with the region's label, numbered after
/// all sites: where it turns, if it turns in one place as at a corner, else in its middle. Where an
/// arc between the regions of A and B ends on the boundary, the dual has a quadrangle of the two
/// sites and the vertices of their two runs; where d - 1 arcs end in one point, a (d+2)-gon. So the
/// boundary of the dual lies along that of the mesh. A boundary loop that only one region touches
/// gets nothing.
///
/// A site is in no face if it has no region, or if its region has neither a Voronoi point nor an
/// arc that ends on the mesh boundary. The dual is a manifold with the topology of the surface if
/// `findViolations` has none.
///
/// Here and below, `sites` are the sites of the diagram by label, with face -1 for a label without
/// a site; throws `Error(kInvalidArgument)` if their number is not the diagram's or a label with a
/// region has none, and `Error(kInvalidPoint)` if one is not on the mesh. All functions throw
/// `Error(kInvalidArgument)` if the diagram has another number of faces than the mesh, or distances
/// are those of another mesh. Costs as much as `partition`.
PolygonMesh dualMesh(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                     const Diagram& diagram);

/// The regions as polygons: vertices are the Voronoi points and the ends of arcs on the mesh
/// boundary, then those of runs along it, as in the dual; each arc is a side, each run two, each
/// loop of a region a face. If `findViolations` returns none, there is one face per region, and the
/// mesh has the topology of the surface. Otherwise a loop may have fewer than three corners; one
/// that meets at most one other region may have none and is left out. Costs as much as `partition`.
PolygonMesh regionMesh(const TriangleMesh& mesh, const Diagram& diagram);

/// Both in steps. Here and below, arguments given by reference must outlive the work.
std::unique_ptr<SlicedWork<PolygonMesh>> startDualMesh(const TriangleMesh& mesh,
                                                       std::span<const SurfacePoint> sites,
                                                       const Diagram& diagram);
std::unique_ptr<SlicedWork<PolygonMesh>> startRegionMesh(const TriangleMesh& mesh,
                                                         const Diagram& diagram);

/// A side of a dual as a path on the surface.
struct DualPath {
  std::array<int, 2> labels;         ///< the two of the arc it crosses, the lower one first
  std::vector<SurfacePoint> points;  ///< from site to site, as `DistanceField::path` names them
};

/// Per arc of the diagram, the shortest path between its two sites that crosses it, over the arc's
/// nearest point to them. The path stays in the two regions. It is a geodesic, but has a corner if
/// the nearest point is an end of the arc. It leads over any point of the arc if
/// `DistanceField::distancesAt` knows the distances of both sites nowhere on it, as may be with
/// `detail`.
///
/// `field` holds the distances that the diagram was traced from. O(vertices) per arc.
std::vector<DualPath> dualPaths(const TriangleMesh& mesh, const Diagram& diagram,
                                const DistanceField& field);
std::unique_ptr<SlicedWork<std::vector<DualPath>>> startDualPaths(const TriangleMesh& mesh,
                                                                  const Diagram& diagram,
                                                                  const DistanceField& field);

/// A reason why a dual does not have the topology of the surface: a violation of the *closed ball
/// property* (Edelsbrunner & Shah 1997), by which every region is a disk, two regions meet in at
/// most one arc or point, and three in at most one point.
struct Violation {
  enum Kind {
    kUnreachable,     ///< a component of the mesh has no site; no labels
    kNoRegion,        ///< a site owns nothing, another one is at its place
    kFewRuns,         ///< a loop of the mesh boundary passes fewer than three runs of regions
    kClosedBorder,    ///< two regions meet along a closed curve, with no third one on it
    kNoDisk,          ///< a region has several components, no outline or several, or a handle
    kTouchesItself,   ///< a region comes to one point from two sides
    kTwoMeetTwice,    ///< two regions meet in several arcs or points
    kThreeMeetTwice,  ///< three or more regions meet in two Voronoi points
    kNoManifold,      ///< none of these, and yet the dual is no manifold of the surface's topology
  };
  Kind kind;
  std::vector<int> labels;  ///< the regions concerned, ascending
  std::string message;      ///< one sentence that names them
};

/// All violations, by kind, then by labels. None: the dual is an orientable manifold that has the
/// Euler characteristic, the genus and the boundary loops of the surface. (That is a theorem, and
/// checked nevertheless.) Costs as much as `partition`, O(d²) for a Voronoi point of degree d, and
/// O(k²) for two regions that share k Voronoi points.
/// Source: Herbert Edelsbrunner, Nimish Shah. Triangulating Topological Spaces. 1997.
std::vector<Violation> findViolations(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                      const Diagram& diagram);
std::unique_ptr<SlicedWork<std::vector<Violation>>> startViolations(
    const TriangleMesh& mesh, std::span<const SurfacePoint> sites, const Diagram& diagram);

/// The sites that one round of `repair` adds. For each violation, this is a point inside a triangle
/// of the partition, a quarter of the way from its middle to a corner: of those in triangles that
/// show the violation, the one farthest from its site. A component without a site gets one point.
/// Where two regions meet along a closed curve around a *sharp cone*, an inner vertex whose angles
/// sum to less than π, the outer one's site is added twice more, turned about this vertex by a
/// third and two thirds of that sum: points on the curve would come ever nearer to the vertex. A
/// violation is left to the next round if a region concerned is next to one that gets a new site in
/// this round, because it may then be gone. Empty if there are no violations.
///
/// `field` holds the distances that the diagram was traced from. Costs as much as `findViolations`,
/// and `DistanceField::distancesAt` three points of each triangle that shows a violation.
/// Throws `Error(kInvalidArgument)` if a site has no region because another one is at its place:
/// further sites do not help. Throws `std::logic_error` for `Violation::kNoManifold`.
std::vector<SurfacePoint> repairingSites(const TriangleMesh& mesh,
                                         std::span<const SurfacePoint> sites,
                                         const Diagram& diagram, const DistanceField& field);
std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startRepairingSites(
    const TriangleMesh& mesh, std::span<const SurfacePoint> sites, const Diagram& diagram,
    const DistanceField& field);

struct RepairOptions {
  int maxAdded = 1000;          ///< how many sites may be added; not negative
  DiagramOptions diagram = {};  ///< of the diagram that is to have no violations
};

/// Sites with a valid dual.
struct RepairedSites {
  /// The given sites by label, but for labels without a site at the end, and `added` more: each got
  /// the lowest label without a site.
  std::vector<SurfacePoint> sites;
  int added = 0;
  Diagram diagram;
};

/// Adds sites until the diagram has no violations: in each round those of `repairingSites`, which
/// are inserted into a `DynamicDiagram`. `sites` may be empty. Deterministic. Takes as long as the
/// diagram and these insertions, plus a `findViolations` per round.
///
/// Throws `Error(kTooFewSites)`, naming the first violation that is left, if more than `maxAdded`
/// would be needed, or if an added site has no region: then triangles are too long (`subdivide`).
/// `Error(kInvalidArgument)` if `maxAdded` is negative, and as `repairingSites` and
/// `DynamicDiagram` do.
RepairedSites repair(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric,
                     const RepairOptions& options = {});
/// The same in steps; the mesh must outlive them.
std::unique_ptr<SlicedWork<RepairedSites>> startRepair(const TriangleMesh& mesh,
                                                       std::span<const SurfacePoint> sites,
                                                       Metric metric,
                                                       const RepairOptions& options = {});

}  // namespace gvd
