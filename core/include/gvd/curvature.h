// SPDX-License-Identifier: MIT
/// \file
/// Curvature at vertices, and densities that follow it: for samplings and tessellations that are
/// finer where the surface bends more.
#pragma once

#include <memory>
#include <vector>

#include "gvd/sliced_work.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// Curvatures at every vertex: integrals over the part of the surface that belongs to the vertex,
/// divided by the area of that part, a third of the faces around the vertex.
struct VertexCurvatures {
  /// Gaussian: the angle defect 2π - Σ angles over the area, in 1 / length².
  std::vector<double> gaussian;
  /// Mean: half the length of the gradient of area (the cotangent formula) over the area, in
  /// 1 / length. Without sign. A flat face has the normal of the face across its longest side.
  std::vector<double> mean;
};

/// The curvatures at all vertices. Boundary vertices, where neither formula holds, get the mean of
/// their inner neighbours, or zero if there is none. O(F).
/// Source: Mark Meyer, Mathieu Desbrun, Peter Schröder, Alan Barr. Discrete Differential-Geometry
/// Operators for Triangulated 2-Manifolds. 2003.
VertexCurvatures vertexCurvatures(const TriangleMesh& mesh);

struct CurvatureDensityOptions {
  /// How often the squared curvature at each vertex is averaged with that of its neighbours. The
  /// noise of one vertex is spread over as many edges as the square root of this.
  int smoothing = 4;
  /// Added to the squared curvature everywhere, as a share of its mean, so that flat parts get
  /// sites too: the least density is floor / (1 + floor) of the mean. Positive.
  double floor = 0.1;
};

/// A density for centroidal Voronoi tessellations and sampling that follows curvature: κ₁² + κ₂² =
/// 4 H² - 2 K, smoothed, raised by the floor, and scaled to the mean 1 over the surface; 1 all over
/// where there is no curvature. The regions of a centroidal tessellation become as wide as ρ^(-1/4)
/// (Du, Faber, Gunzburger 1999, for large numbers of sites), here κ^(-1/2): then the distance
/// between the surface and its chords, κ h² / 8, is the same everywhere. Throws
/// `Error(kInvalidArgument)` if smoothing is negative or the floor is not positive and finite.
/// O(smoothing · F).
std::vector<double> curvatureDensity(const TriangleMesh& mesh,
                                     const CurvatureDensityOptions& options = {});
/// The same in steps. The mesh must outlive the work.
std::unique_ptr<SlicedWork<std::vector<double>>> startCurvatureDensity(
    const TriangleMesh& mesh, const CurvatureDensityOptions& options = {});

}  // namespace gvd
