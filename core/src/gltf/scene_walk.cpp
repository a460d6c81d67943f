// SPDX-License-Identifier: MIT
#include "gltf/scene_walk.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "gltf/gltf_error.h"

namespace gvd::gltf {
namespace {

std::vector<int> rootNodes(const Document& document) {
  if (document.defaultScene) {
    requireIndex(*document.defaultScene, document.scenes.size(), "scene", "the glTF");
    return document.scenes[*document.defaultScene];
  }
  const int count = static_cast<int>(document.nodes.size());
  std::vector<char> isChild(count, false);
  for (const Node& node : document.nodes) {
    for (int child : node.children) {
      if (child >= 0 && child < count) isChild[child] = true;
    }
  }
  std::vector<int> roots;
  for (int n = 0; n < count; ++n) {
    if (!isChild[n]) roots.push_back(n);
  }
  return roots;
}

Eigen::Affine3d localTransform(const Node& node, const std::string& name) {
  const auto require = [&](const std::vector<double>& values, std::size_t count, const char* what) {
    const bool finite =
        std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
    if (values.empty()) return false;
    if (values.size() != count || !finite) {
      reject(name + " has a " + what + " that is not " + number(count) + " finite numbers");
    }
    return true;
  };
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (require(node.matrix, 16, "matrix")) {
    transform.affine() = Eigen::Matrix4d::Map(node.matrix.data()).topRows<3>();
    return transform;
  }
  if (require(node.translation, 3, "translation")) {
    transform.translate(Eigen::Vector3d::Map(node.translation.data()));
  }
  if (require(node.rotation, 4, "rotation")) {
    const Eigen::Quaterniond rotation(node.rotation.data());  // x, y, z, w in both
    if (rotation.norm() == 0) reject(name + " has a rotation of zeros");
    transform.rotate(rotation.normalized());
  }
  if (require(node.scale, 3, "scale")) {
    transform.scale(Eigen::Vector3d::Map(node.scale.data()));
  }
  return transform;
}

/// Without recursion: files nest as deep as they like.
std::vector<PlacedMesh> walk(const Document& document, const std::vector<int>& roots) {
  struct Visit {
    int node;
    int parent;  ///< -1: the scene
    Eigen::Affine3d transform;
  };
  std::vector<PlacedMesh> placed;
  std::vector<Visit> stack;
  const auto push = [&](const std::vector<int>& nodes, int parent,
                        const Eigen::Affine3d& transform) {
    for (auto n = nodes.rbegin(); n != nodes.rend(); ++n) stack.push_back({*n, parent, transform});
  };
  const auto nameOf = [](int node) {
    return node < 0 ? "the scene" : "node " + std::to_string(node);
  };
  std::vector<char> visited(document.nodes.size(), false);
  push(roots, -1, Eigen::Affine3d::Identity());
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    requireIndex(visit.node, document.nodes.size(), "node", nameOf(visit.parent));
    const std::string name = nameOf(visit.node);
    if (visited[visit.node]) reject(name + " is in the scene twice");
    visited[visit.node] = true;

    const Node& node = document.nodes[visit.node];
    const Eigen::Affine3d transform = visit.transform * localTransform(node, name);
    if (node.mesh) {
      requireIndex(*node.mesh, document.meshes.size(), "mesh", name);
      placed.push_back({*node.mesh, visit.node, transform});
    }
    push(node.children, visit.node, transform);
  }
  return placed;
}

}  // namespace

std::vector<PlacedMesh> placedMeshes(const Document& document) {
  if (!document.nodes.empty()) return walk(document, rootNodes(document));
  std::vector<PlacedMesh> placed;
  for (int m = 0; m < static_cast<int>(document.meshes.size()); ++m) {
    placed.push_back({m, -1, Eigen::Affine3d::Identity()});
  }
  return placed;
}

}  // namespace gvd::gltf
