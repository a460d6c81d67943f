// SPDX-License-Identifier: MIT
/// \file
/// Centroidal Voronoi tessellations: sites that move until each is at the centroid of its region.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gvd/diagram.h"
#include "gvd/geodesic.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// How the sites of a centroidal Voronoi tessellation are found.
enum class CvtMethod {
  kLloyd,  ///< every site to the centroid of its region (Lloyd 1982)
  kLbfgs,  ///< quasi-Newton, its first step Lloyd's (Liu et al. 2009)
};

struct CvtOptions {
  CvtMethod method = CvtMethod::kLbfgs;
  Metric metric = Metric::kExact;  ///< of the distances
  int iterations = 50;             ///< at most
  /// Done when an iteration has lowered the energy by no more than this share of it.
  double energyTolerance = 0;
  /// Done when no site has moved by more than this, in the mesh's units.
  double moveTolerance = 0;
  /// The density ρ at each vertex of the mesh, linear in between: not negative, and small enough
  /// for ∫ ρ d² to be finite. Empty: 1.
  std::vector<double> density = {};
  /// Labels of the sites that stay where they are.
  std::vector<int> fixedSites = {};
};

/// The result of one iteration.
struct CvtIteration {
  int number = 0;     ///< 0: the initial sites
  double energy = 0;  ///< Σ over the labels of ∫ ρ d² over the label's region
  /// The largest distance that a site has moved along the surface, in the mesh's units. A site that
  /// moved to a random place does not count, and no tolerance ends such an iteration.
  double largestMove = 0;
};

/// A centroidal Voronoi tessellation of a mesh: moves sites so that the energy E = Σ ∫ ρ d² falls,
/// d the geodesic distance to the nearest site, until every site is at the centroid of its region,
/// where the mean of the logarithmic map vanishes. The result is a local minimum, not a global one.
///
///     Cvt cvt(mesh, sites);
///     while (!cvt.isDone())
///       if (cvt.step(100000)) show(cvt.iteration().energy, *cvt.diagram());
///
/// The energy never rises by more than rounding: a step that does not lower it is shortened, and if
/// no length helps, the tessellation is done. The energy is integrated over the regions as traced,
/// the cells of mixed faces included; components without a site do not count. Where faces are about
/// as long as regions, the energy may be less than half of the true one: `subdivide` such a mesh
/// first.
///
/// Two kinds of sites have no gradient, and are moved in other ways unless they are fixed. A site
/// without region (it coincides with another one, or ρ is zero around it) moves to a random point,
/// drawn with a probability in proportion to the energy there. A site on a vertex is moved off it
/// by 1e-7 of a side: at a vertex, directions are not unique.
///
/// A site may be best at a saddle vertex, where the energy has a kink and the gradient beside it
/// does not vanish. Once no step lowers the energy, such sites are held, and the others move on.
///
/// Deterministic. An iteration costs one diagram and its integrals, more where a step is shortened.
///
/// Sources: Qiang Du, Vance Faber, Max Gunzburger. Centroidal Voronoi Tessellations: Applications
/// and Algorithms. 1999. Yang Liu et al. On Centroidal Voronoi Tessellation: Energy Smoothness and
/// Fast Computation. 2009.
class Cvt {
 public:
  /// `sites` are given in the mesh's faces, one label each; face -1 is a label without a site and
  /// stays so. The mesh must outlive this. Throws `Error(kInvalidArgument)` if there is no site or
  /// an option does not fit mesh and sites, `Error(kInvalidPoint)` if a site is not on the mesh.
  Cvt(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, CvtOptions options = {});
  ~Cvt();
  Cvt(Cvt&&) noexcept;
  Cvt& operator=(Cvt&&) noexcept;

  /// Works for `budget` units of about a microsecond, as `SlicedWork::step`, but not beyond the end
  /// of an iteration. True when an iteration has ended, of which the functions below then give the
  /// results. Iteration 0 evaluates the initial sites. If no step lowers the energy, the
  /// tessellation is done without a further iteration.
  bool step(long budget);
  bool isDone() const;

  /// The results of the last finished iteration; valid after `step` has first returned true.
  const CvtIteration& iteration() const;
  std::span<const SurfacePoint> sites() const;
  /// Distances and diagram stay valid as long as the pointers are kept: further iterations make new
  /// ones.
  std::shared_ptr<const DistanceField> distances() const;
  std::shared_ptr<const Diagram> diagram() const;

 private:
  class Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace gvd
