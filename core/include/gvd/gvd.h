// SPDX-License-Identifier: MIT
/// \file
/// All headers of the library but gltf.h, and what to read first.
///
/// \mainpage Reading guide
///
/// 1. triangle_mesh.h: a surface from positions and triangles. surface_point.h: a point on it.
///    sampling.h: sites at random.
/// 2. geodesic.h: `propagate` computes the distances of many sites.
/// 3. diagram.h: `traceDiagram` makes the Voronoi diagram of these distances.
///
/// That is all that a diagram takes:
///
///     const gvd::TriangleMesh mesh(positions, triangles);
///     const std::vector<gvd::SurfacePoint> sites = gvd::sampleUniform(mesh, 100, 1);
///     const auto distances = gvd::finished(gvd::propagate(mesh, sites, gvd::Metric::kExact));
///     const gvd::Diagram diagram = gvd::traceDiagram(mesh, *distances, int(sites.size()));
///
/// Long computations can be done in steps (sliced_work.h), with progress and an end at any time:
/// `propagate` returns such work, and so do the functions that begin with `start`, each declared
/// beside the one that returns the same result at once. `finished` does such work at one go.
///
/// Then, as needed, in any order:
///  - subdivision.h: smaller triangles, where those of a model are about as long as regions
///  - sampling.h: sites in other ways; curvature.h: densities for them; closest_point.h: points on
///    the surface for places in space
///  - dynamic_diagram.h: sites that are inserted, removed and moved
///  - cvt.h: sites at the centroids of their regions; straightest.h: how they are moved there
///  - partition.h: the mesh cut into regions, and facts of each region
///  - dual.h, polygon_mesh.h, remesh.h: polygonal base meshes, remeshes and their quality
///  - gltf.h: triangles from a file; error.h: what is thrown on bad input
///
/// Faces and vertices are those of a `TriangleMesh`; `TriangleMesh::toInput` and `fromInput`
/// convert to and from the triangles it was made of. Lengths are in the unit of the positions.
///
/// Bad input throws `Error`. Not checked are the indices of vertices, faces and halfedges that a
/// function reads at (`TriangleMesh::tail`, `DistanceField::at`, …), as with `std::vector`. Nor is
/// anything but the number of faces, where a diagram and a mesh are given that must belong
/// together. An object that was moved from can only be assigned to or destroyed. Results that refer
/// to a mesh say so: it must outlive them, at the same address.
///
/// Nothing keeps global state: threads that share no object are independent of one another. A mesh,
/// a diagram and a `ClosestPointQuery` may be read by several threads; so may distances at
/// vertices, but not at other points (geodesic.h). Work may be begun by one thread and continued by
/// another. The same input gives the same bits with one build; builds, native or WebAssembly,
/// differ by rounding (1e-12), not in decisions.
#pragma once

#include "gvd/closest_point.h"
#include "gvd/curvature.h"
#include "gvd/cvt.h"
#include "gvd/diagram.h"
#include "gvd/dual.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/error.h"
#include "gvd/geodesic.h"
#include "gvd/partition.h"
#include "gvd/polygon_mesh.h"
#include "gvd/remesh.h"
#include "gvd/sampling.h"
#include "gvd/sliced_work.h"
#include "gvd/straightest.h"
#include "gvd/subdivision.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"
