// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "gltf/accessor_reader.h"
#include "gltf/document.h"
#include "gvd/gltf.h"

namespace gvd::gltf {

/// A mesh at one of its places in the scene.
struct PlacedMesh {
  int mesh;
  int node;  ///< -1 if the glTF has no nodes
  Eigen::Affine3d transform;
  /// Whether it is an instance that costs the file nothing: no accessor of the instances has a
  /// buffer view.
  bool isFreeInstance = false;
};

/// The meshes of the default scene, or, if there is none, of all root nodes, or, if there are no
/// nodes, all meshes. Depth first; a mesh with instances comes once per instance. At most
/// `maxObjects` primitives and morph targets.
std::vector<PlacedMesh> placedMeshes(const Document& document, AccessorReader& accessors,
                                     const GltfLimits& limits);

}  // namespace gvd::gltf
