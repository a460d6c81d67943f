// SPDX-License-Identifier: MIT
//
// Computes everything from a mesh and sites, step by step, and checks each result.
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

/// Computes diagram, partition, dual, edits and tessellation. Returns the first complaint, empty
/// if there is none:
///  - a site has other distances than it has alone, by the exact metric;
///  - a diagram or partition is not sound (`isConsistent`, `isSound`, `hasTheAreasOf`);
///  - a diagram updated by edits differs from a new one;
///  - the energy of a tessellation rises.
/// The edits are random. Exceptions pass.
std::string complaintAboutPipeline(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                   shapes::Random& random, const PipelineOptions& options);

}  // namespace gvd::checks
