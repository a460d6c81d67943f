// SPDX-License-Identifier: MIT
/// \file
/// Sites to begin with: random, farthest point, and Poisson disk samples.
///
/// Points are on the surface; their `face` counts the faces of `mesh`. The same arguments give the
/// same points on every platform. All functions throw `Error(kInvalidArgument)` if a count is
/// negative.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// `count` points, independent and uniform by area (by face, if all faces have zero area). The
/// first n points do not depend on `count`. O(F + count log F).
std::vector<SurfacePoint> sampleUniform(const TriangleMesh& mesh, int count, std::uint64_t seed);

/// `count` points, independent, with a probability per area in proportion to a density given at
/// each vertex of the mesh, linear in between. The first n points do not depend on `count`. Throws
/// `Error(kInvalidArgument)` if there is not one density per vertex, one is negative or not finite,
/// or the density vanishes all over the surface. O(F + count log F).
std::vector<SurfacePoint> sampleByDensity(const TriangleMesh& mesh, std::span<const double> density,
                                          int count, std::uint64_t seed);

/// Farthest point sampling: a first point at random, uniform by area, then one vertex after the
/// other, always the one that is farthest from all points so far (vertices that no point reaches
/// come first; of equals, the lowest), until there are `count` points, or no vertex is farther than
/// `coveringRadius` from them, or the points have come to every vertex. So every component gets a
/// point early, and points are at least as far apart as the last one was from the others. The first
/// n points do not depend on `count`.
///
/// Distances are geodesic, by unfolding (DGPC without angles). A point spreads only where it is
/// the nearest: O(V log V log count) for evenly spread vertices.
/// Source: Gabriel Peyré, Laurent Cohen. Geodesic Remeshing Using Front Propagation. 2006.
std::vector<SurfacePoint> sampleFarthest(const TriangleMesh& mesh, int count, std::uint64_t seed,
                                         double coveringRadius = 0);

struct PoissonDisk {
  std::vector<SurfacePoint> points;
  double radius;  ///< no two points are nearer to each other, in the mesh's units
};

/// Points of which no two are nearer to each other than `radius` (geodesic, as for
/// `sampleFarthest`), placed at random until hardly any more fit; then vertices are added, so that
/// none is farther than `radius` from a point. Throws `Error(kInvalidArgument)` if the radius is
/// not positive and finite. Source: Robert Cook. Stochastic Sampling in Computer Graphics. 1986.
PoissonDisk samplePoissonDisk(const TriangleMesh& mesh, double radius, std::uint64_t seed);

/// `count` such points: the radius falls until as many fit. Points come in order of falling radius,
/// so the first of them are a Poisson disk sample themselves, a coarser one.
/// Source: Michael McCool, Eugene Fiume. Hierarchical Poisson Disk Sampling Distributions. 1992.
PoissonDisk samplePoissonDiskCount(const TriangleMesh& mesh, int count, std::uint64_t seed);

}  // namespace gvd
