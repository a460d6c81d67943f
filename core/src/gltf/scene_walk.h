// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "gltf/accessor_reader.h"
#include "gltf/document.h"
#include "gvd/gltf.h"

namespace gvd::gltf {

/// A mesh where the scene has it.
struct PlacedMesh {
  int mesh;
  int node;  ///< -1 if the glTF has no nodes
  Eigen::Affine3d transform;
  /// One of several instances that cost the file nothing: no accessor of theirs has a buffer view.
  bool isFreeInstance = false;
};

/// The meshes of the default scene, else of all root nodes, else (there are no nodes) all meshes:
/// depth first, a mesh with instances once for each of them. No more than `maxObjects` primitives
/// and morph targets.
std::vector<PlacedMesh> placedMeshes(const Document& document, AccessorReader& accessors,
                                     const GltfLimits& limits);

}  // namespace gvd::gltf
