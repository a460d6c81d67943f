// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "gltf/document.h"

namespace gvd::gltf {

/// A mesh where the scene has it.
struct PlacedMesh {
  int mesh;
  int node;  ///< -1 if the glTF has no nodes
  Eigen::Affine3d transform;
};

/// The meshes of the default scene, else of all root nodes, else (there are no nodes) all meshes:
/// depth first.
std::vector<PlacedMesh> placedMeshes(const Document& document);

}  // namespace gvd::gltf
