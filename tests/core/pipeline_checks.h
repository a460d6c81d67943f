// SPDX-License-Identifier: MIT
//
// All that can be made of a mesh and sites, one after the other, and what has to hold of each.
#pragma once

#include <span>
#include <string>

#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"
#include "shapes.h"

namespace gvd::checks {

struct PipelineOptions {
  Metric metric = Metric::kExact;
  int edits = 10;
  int cvtIterations = 3;
};

/// Diagram, partition, dual, edits and tessellation. What is wrong with one of them, empty if
/// nothing is:
///  - a diagram or partition is not sound (`isConsistent`, `isSound`, `hasTheAreasOf`);
///  - a diagram that has followed its sites differs from a fresh one;
///  - the energy of a tessellation rises.
/// The edits are random. Exceptions pass.
std::string complaintAboutPipeline(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                   shapes::Random& random, const PipelineOptions& options);

}  // namespace gvd::checks
