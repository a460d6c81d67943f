// SPDX-License-Identifier: MIT
//
// Random small meshes of every kind, with sites that make diagrams degenerate.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"
#include "shapes.h"

namespace gvd {

/// A mesh and sites. The sites refer to the shape's triangles, so that triangles can be removed.
struct RandomCase {
  std::string kind;  ///< of the mesh and of the sites, for messages
  shapes::Shape shape;
  std::vector<SurfacePoint> sites;

  TriangleMesh mesh() const { return shape.mesh(); }
  std::vector<SurfacePoint> sitesOn(const TriangleMesh& mesh) const;
};

/// A random case, the same on every platform up to the rounding of the C library's functions.
///
/// The mesh, of about 10 to 100 faces, is plane or not, of genus 0 to 3, open or closed, oriented
/// or not, of one or more components; it may be symmetric, strongly graded, folded flat, full of
/// needles, or a soup of triangles. Some are turned and scaled, so that ties hold only up to
/// rounding.
///
/// The sites lie on vertices, edges, midpoints of edges and of faces, all in one face, on a circle
/// around a vertex or inside a face, alike in every face, at the same place or nearly so. There are
/// few sites, or more than vertices.
RandomCase randomCase(std::uint64_t seed);

/// A mesh by `wildMesh`, with sites like those of `randomCase`. Many of these meshes are empty
/// after repair; further ones are drawn until a triangle is left.
RandomCase wildCase(std::uint64_t seed);

/// The smallest case still failing that greedy removal of sites and triangles finds.
RandomCase shrunk(RandomCase failing, const std::function<bool(const RandomCase&)>& fails);

/// The case as C++, to paste into a test.
std::string sourceOf(const RandomCase& c);

}  // namespace gvd
