// SPDX-License-Identifier: MIT
#include "gltf/scene_walk.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "gltf/gltf_error.h"

namespace gvd::gltf {
namespace {

[[noreturn]] void rejectForPrimitives(std::size_t most) {
  reject("the scene has more than " + std::to_string(most) +
         " primitives and morph targets, instances included" + toRaise("maxObjects"));
}

std::vector<int> rootNodes(const Document& document) {
  if (document.defaultScene) {
    requireIndex(*document.defaultScene, document.scenes.size(), "scene", "the glTF");
    return document.scenes[*document.defaultScene];
  }
  const int count = static_cast<int>(document.nodes.size());
  std::vector<char> isChild(count, false);
  for (const Node& node : document.nodes) {
    for (int child : node.children)
      if (child >= 0 && child < count) isChild[child] = true;
  }
  std::vector<int> roots;
  for (int n = 0; n < count; ++n)
    if (!isChild[n]) roots.push_back(n);
  return roots;
}

void rotate(Eigen::Affine3d& transform, const double* xyzw, const std::string& name) {
  const Eigen::Quaterniond rotation(xyzw);  // x, y, z, w in both
  if (rotation.norm() == 0) reject(name + " has a rotation of zeros");
  transform.rotate(rotation.normalized());
}

Eigen::Affine3d localTransform(const Node& node, const std::string& name) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (!node.matrix.empty()) {
    constexpr double kRounding = 1e-6;  // of numbers of single precision
    const Eigen::Matrix4d matrix = Eigen::Matrix4d::Map(node.matrix.data());
    if (!matrix.row(3).isApprox(Eigen::RowVector4d::UnitW(), kRounding))
      reject(name + " has a matrix whose last row is not 0, 0, 0, 1");
    transform.affine() = matrix.topRows<3>();
    return transform;
  }
  if (!node.translation.empty()) transform.translate(Eigen::Vector3d::Map(node.translation.data()));
  if (!node.rotation.empty()) rotate(transform, node.rotation.data(), name);
  if (!node.scale.empty()) transform.scale(Eigen::Vector3d::Map(node.scale.data()));
  return transform;
}

/// The transforms of a node's instances relative to the node; the identity if it has none.
std::vector<Eigen::Affine3d> instanceTransforms(const Node& node, const std::string& name,
                                                AccessorReader& accessors, std::size_t most) {
  std::optional<std::uint64_t> count;
  const auto read = [&](const char* semantic, const Format& format) -> std::vector<double> {
    const auto found = node.instances.find(semantic);
    if (found == node.instances.end()) return {};
    const std::uint64_t has = accessors.at(found->second, name).count;
    if (has > most) rejectForPrimitives(most);
    if (count.value_or(has) != has) reject(name + " has instances whose accessors differ in count");
    count = has;
    return accessors.read(found->second, format, name);
  };
  const std::vector<double> translations = read("TRANSLATION", kTranslations);
  const std::vector<double> rotations = read("ROTATION", kRotations);
  const std::vector<double> scales = read("SCALE", kScales);

  std::vector<Eigen::Affine3d> transforms(count.value_or(1), Eigen::Affine3d::Identity());
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    Eigen::Affine3d& transform = transforms[i];
    if (!translations.empty()) transform.translate(Eigen::Vector3d::Map(&translations[3 * i]));
    if (!rotations.empty())
      rotate(transform, &rotations[4 * i], "instance " + std::to_string(i) + " of " + name);
    if (!scales.empty()) transform.scale(Eigen::Vector3d::Map(&scales[3 * i]));
  }
  return transforms;
}

/// Collects the meshes of a scene, without recursion, because files may nest arbitrarily deep.
class SceneWalk {
 public:
  SceneWalk(const Document& document, AccessorReader& accessors, const GltfLimits& limits)
      : document_(document),
        accessors_(accessors),
        most_(limits.maxObjects),
        reached_(document.nodes.size(), false) {
    for (const Mesh& mesh : document.meshes) {
      std::size_t objects = 0;
      for (const Primitive& primitive : mesh.primitives) objects += 1 + primitive.targets.size();
      objectsIn_.push_back(std::max<std::size_t>(objects, 1));
    }
  }

  std::vector<PlacedMesh> walk(const std::vector<int>& roots) {
    push(roots, "the scene", Eigen::Affine3d::Identity());
    while (!stack_.empty()) {
      const auto [index, parentTransform] = stack_.back();
      stack_.pop_back();
      const Node& node = document_.nodes[index];
      const std::string name = "node " + std::to_string(index);
      const Eigen::Affine3d transform = parentTransform * localTransform(node, name);
      if (node.mesh) {
        requireIndex(*node.mesh, document_.meshes.size(), "mesh", name);
        const Eigen::Affine3d base = node.isSkinned ? Eigen::Affine3d::Identity() : transform;
        const bool areFree =
            !node.instances.empty() &&
            std::none_of(node.instances.begin(), node.instances.end(), [&](const auto& attribute) {
              return accessors_.at(attribute.second, name).elements.has_value();
            });
        for (const Eigen::Affine3d& instance : instanceTransforms(node, name, accessors_, most_))
          place({*node.mesh, index, base * instance, areFree});
      }
      push(node.children, name, transform);
    }
    if (!document_.defaultScene) requireAllReached();
    return std::move(placed_);
  }

  std::vector<PlacedMesh> allMeshes() {
    for (int m = 0; m < static_cast<int>(document_.meshes.size()); ++m)
      place({m, -1, Eigen::Affine3d::Identity()});
    return std::move(placed_);
  }

 private:
  struct Visit {
    int node;
    Eigen::Affine3d parentTransform;
  };

  void push(const std::vector<int>& nodes, const std::string& parent,
            const Eigen::Affine3d& transform) {
    for (auto n = nodes.rbegin(); n != nodes.rend(); ++n) {
      requireIndex(*n, document_.nodes.size(), "node", parent);
      if (reached_[*n]) reject("node " + std::to_string(*n) + " is in the scene twice");
      reached_[*n] = true;
      stack_.push_back({*n, transform});
    }
  }

  /// If there is no default scene, all roots are walked: only the nodes of a cycle and those below
  /// it remain unreached.
  void requireAllReached() const {
    const auto left = std::find(reached_.begin(), reached_.end(), false);
    if (left == reached_.end()) return;
    reject("node " + std::to_string(left - reached_.begin()) +
           " has no root above it: the nodes above it form a cycle");
  }

  void place(const PlacedMesh& placed) {
    objects_ += objectsIn_[placed.mesh];
    if (objects_ > most_) rejectForPrimitives(most_);
    placed_.push_back(placed);
  }

  const Document& document_;
  AccessorReader& accessors_;
  const std::size_t most_;
  std::vector<char> reached_;
  std::vector<Visit> stack_;
  std::vector<PlacedMesh> placed_;
  std::vector<std::size_t> objectsIn_;  ///< a mesh's primitives and morph targets
  std::size_t objects_ = 0;
};

}  // namespace

std::vector<PlacedMesh> placedMeshes(const Document& document, AccessorReader& accessors,
                                     const GltfLimits& limits) {
  SceneWalk scene(document, accessors, limits);
  return document.nodes.empty() ? scene.allMeshes() : scene.walk(rootNodes(document));
}

}  // namespace gvd::gltf
