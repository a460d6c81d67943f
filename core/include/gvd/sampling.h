// SPDX-License-Identifier: MIT
/// \file
/// Sites to begin with: random, farthest point and Poisson disk samples, sites for the worst region
/// first, and sites on every component.
///
/// Points are on the surface; their `face` counts the faces of `mesh`. The same arguments give the
/// same points on every platform. All functions throw `Error(kInvalidArgument)` if a count is
/// negative.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "gvd/diagram.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/geodesic.h"
#include "gvd/sliced_work.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// `count` points, independent and uniform by area. The first n points do not depend on `count`.
/// O(F + count log F).
std::vector<SurfacePoint> sampleUniform(const TriangleMesh& mesh, int count, std::uint64_t seed);

/// The same in steps. The mesh must outlive it.
std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startUniform(const TriangleMesh& mesh,
                                                                    int count, std::uint64_t seed);

/// `count` points, independent, spread as the sites of a tessellation with this density are in the
/// limit of many (`CvtOptions::density`): with a probability per area in proportion to the square
/// root of the density at each vertex of the mesh, linear in between. The first n points do not
/// depend on `count`. Throws `Error(kInvalidArgument)` if there is not one density per vertex, one
/// is not as a tessellation takes it, or the density vanishes all over the surface.
/// O(F + count log F).
/// Source: Allen Gersho. Asymptotically Optimal Block Quantization. 1979.
std::vector<SurfacePoint> sampleByDensity(const TriangleMesh& mesh, std::span<const double> density,
                                          int count, std::uint64_t seed);

/// The same in steps. The mesh must outlive it.
std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startByDensity(const TriangleMesh& mesh,
                                                                      std::vector<double> density,
                                                                      int count,
                                                                      std::uint64_t seed);

/// Farthest point sampling: a first point at random, uniform by area, then one vertex after the
/// other, always the one that is farthest from all points so far (vertices that no point reaches
/// come first; of equals, the lowest), until there are `count` points, or no vertex is farther than
/// `coveringRadius` from them, or every vertex is a point. So every component gets a point early,
/// and points are at least as far apart as the last one was from the others. The first n points do
/// not depend on `count`.
///
/// Distances are geodesic, by unfolding (DGPC). A point spreads only where it is the nearest: O(V
/// log V log count) for evenly spread vertices. If a radius is given and there are fewer points
/// than `count`, exact distances of all points follow, and vertices that are farther than the
/// radius by these are added. Throws `Error(kInvalidArgument)` if the radius is negative or not a
/// number.
/// Source: Gabriel Peyré, Laurent Cohen. Geodesic Remeshing Using Front Propagation. 2006.
std::vector<SurfacePoint> sampleFarthest(const TriangleMesh& mesh, int count, std::uint64_t seed,
                                         double coveringRadius = 0);

/// The same in steps. The mesh must outlive it.
std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startFarthest(const TriangleMesh& mesh,
                                                                     int count, std::uint64_t seed,
                                                                     double coveringRadius = 0);

struct PoissonDisk {
  std::vector<SurfacePoint> points;
  double radius;  ///< no two points are nearer to each other (see below), in the mesh's units
};

/// Random points, no two of them nearer to each other than `radius` (geodesic, as for
/// `sampleFarthest`), until hardly any more fit; then vertices are added, so that by exact
/// distances no vertex is farther than `radius` from a point. How near points are to each other is
/// measured as `Metric::kDgpc` does: on well shaped triangles exactly where straight lines connect,
/// and with errors where shortest paths bend at vertices. On long thin triangles, such as those of
/// mechanical parts, a distance may come out several times too long, also along straight lines, so
/// by exact distances some points are much nearer than `radius`.
/// About 0.7 · area / radius² points; each takes time in proportion to the vertices within `radius`
/// of it, and each vertex that is added, a pass over all vertices. Throws `Error(kInvalidArgument)`
/// if the radius is not positive and finite, or if an `int` cannot count so many points.
/// Source: Robert Cook. Stochastic Sampling in Computer Graphics. 1986.
PoissonDisk samplePoissonDisk(const TriangleMesh& mesh, double radius, std::uint64_t seed);

/// `count` such points: the radius falls until as many fit. Points come in order of falling radius,
/// so the first of them are a Poisson disk sample themselves, a coarser one. The radius falls by a
/// twentieth each time that more points in a row were too near than there are points, and 100 more;
/// otherwise the time is that of `samplePoissonDisk`.
/// Source: Michael McCool, Eugene Fiume. Hierarchical Poisson Disk Sampling Distributions. 1992.
PoissonDisk samplePoissonDiskCount(const TriangleMesh& mesh, int count, std::uint64_t seed);

/// Both in steps. The mesh must outlive them.
std::unique_ptr<SlicedWork<PoissonDisk>> startPoissonDisk(const TriangleMesh& mesh, double radius,
                                                          std::uint64_t seed);
std::unique_ptr<SlicedWork<PoissonDisk>> startPoissonDiskCount(const TriangleMesh& mesh, int count,
                                                               std::uint64_t seed);

/// The measure by which a region of a diagram is the worst, and gets the next site.
enum class WorstRegion {
  kSize,  ///< by its area
  /// By the distortion of its logarithmic map u: ∫ (σ₁ - 1)² + (σ₂ - 1)² over the region, σ₁ and σ₂
  /// the singular values of du, constant on each face. It is zero if the map is an isometry: for a
  /// region that is flat, and reached by straight paths alone. A region with a handle, or one that
  /// paths reach around both sides of an obstacle, has a map that is torn, and a high value. Of
  /// regions without distortion, up to rounding, the largest is the worst.
  /// Source: Ligang Liu et al. A Local/Global Approach to Mesh Parameterization. 2008.
  kDistortion,
};

/// The regions of a diagram, and which of them is the worst, while sites are inserted, moved and
/// removed.
class WorstRegions {
 public:
  /// Takes a diagram and its distances. With `detail`, a region may have a share in a face at whose
  /// corners its label is not known; such a share counts as undistorted. The mesh and the
  /// distances, which change with the diagram, must outlive this. Throws `Error(kInvalidArgument)`
  /// if the distances or the diagram are those of another mesh. Takes O(F), and for the worst
  /// region the time of `DistanceField::nearest` at points of its outline.
  WorstRegions(const TriangleMesh& mesh, const DistanceField& distances, const Diagram& diagram,
               WorstRegion worst);
  /// The same in steps. The diagram must outlive the work.
  static std::unique_ptr<SlicedWork<WorstRegions>> start(const TriangleMesh& mesh,
                                                         const DistanceField& distances,
                                                         const Diagram& diagram, WorstRegion worst);
  /// Follows a change of the diagram; `distances` must have changed already. Takes time for the
  /// regions in `DiagramChange::labels` and the worst one, and a little for each face and label.
  void follow(const DiagramChange& change);
  /// The same in steps. The change must outlive them. `point` must not be asked for before they are
  /// done, and this is of no use if they are dropped unfinished.
  std::unique_ptr<SlicedSteps> startFollow(const DiagramChange& change);
  /// The place for one more site: in a component without a site, if there is one, otherwise the
  /// vertex or outline point of the worst region that is farthest from the sites.
  const SurfacePoint& point() const { return point_; }
  /// The criterion for the worst region.
  WorstRegion kind() const { return worst_; }

 private:
  /// A face that is wholly or in part in a region.
  struct Share {
    int face;
    double distortion;  ///< 0 if the worst is found by size
  };
  struct Region {
    double area = 0;
    double distortion = 0;
    std::vector<Share> shares;  ///< ascending by face
    std::vector<SurfacePoint> outline;
  };
  class Update;

  WorstRegions(const TriangleMesh& mesh, const DistanceField& distances, WorstRegion worst);

  const TriangleMesh* mesh_;
  const DistanceField* distances_;
  WorstRegion worst_;
  std::vector<Region> regions_;
  std::vector<int> faceLabel_;
  SurfacePoint point_;
};

/// `count` points: the first at random, uniform by area, each further one where
/// `WorstRegions::point` puts it in the diagram of the points so far, by exact distances. The first
/// n points do not depend on `count`. Takes as long as inserting the points one by one into a
/// `DynamicDiagram`, plus O(count · F).
std::vector<SurfacePoint> sampleWorstFirst(const TriangleMesh& mesh, int count, std::uint64_t seed,
                                           WorstRegion worst);
/// The same in steps. The mesh must outlive the work.
std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startWorstFirst(const TriangleMesh& mesh,
                                                                       int count,
                                                                       std::uint64_t seed,
                                                                       WorstRegion worst);

/// These points, with at least `perComponent` on each component of the mesh: missing ones are drawn
/// at random, uniform by area, and appended. While there are more than `count` points, the last
/// given point is dropped whose component has more than it needs. Labels without a site (face -1)
/// stay and do not count. Throws `Error(kInvalidArgument)` if `count` does not suffice for all
/// components, `Error(kInvalidPoint)` if a point is not on the mesh. O(F + P log F).
std::vector<SurfacePoint> coverComponents(const TriangleMesh& mesh,
                                          std::vector<SurfacePoint> points, int perComponent,
                                          int count, std::uint64_t seed);
/// The same in steps. Here and below, the mesh must outlive the work.
std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startCoverComponents(
    const TriangleMesh& mesh, std::vector<SurfacePoint> points, int perComponent, int count,
    std::uint64_t seed);

struct BareComponents {
  int components = 0;
  double area = 0;
};
/// The number of components without any of these points, and their area. Labels without a site
/// (face -1) do not count; throws `Error(kInvalidPoint)` if a point is not on the mesh. O(F).
BareComponents bareComponents(const TriangleMesh& mesh, std::span<const SurfacePoint> points);
std::unique_ptr<SlicedWork<BareComponents>> startBareComponents(
    const TriangleMesh& mesh, std::span<const SurfacePoint> points);

}  // namespace gvd
