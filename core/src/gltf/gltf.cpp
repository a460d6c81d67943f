// SPDX-License-Identifier: MIT
//
// From bytes to triangles:
//   glb_container        GLB chunks, or the JSON itself
//   gltf_json            checks the JSON and keeps what triangles need (json_filter parses it by
//                        the table in json_rules); version and extensions
//   document             the objects (by tinygltf)
//   scene_walk           where each mesh of the scene is
//   primitive_triangles  the triangles of each primitive, by accessor_reader, buffers, data_uri
// No file is opened here: buffers outside the glTF come from the caller.

#include "gvd/gltf.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gltf/accessor_reader.h"
#include "gltf/buffers.h"
#include "gltf/document.h"
#include "gltf/glb_container.h"
#include "gltf/gltf_error.h"
#include "gltf/gltf_json.h"
#include "gltf/primitive_triangles.h"
#include "gltf/scene_walk.h"

namespace gvd {
namespace gltf {
namespace {

/// The cofactors of a matrix turn normals as it turns surfaces, singular or not.
void transformNormals(const Eigen::Matrix3d& m, std::vector<double>& normals) {
  Eigen::Matrix3d cofactors;
  for (int i = 0; i < 3; ++i) cofactors.col(i) = m.col((i + 1) % 3).cross(m.col((i + 2) % 3));
  if (m.determinant() < 0) cofactors = -cofactors;
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    auto normal = Eigen::Vector3d::Map(&normals[i]);
    normal = (cofactors * normal).stableNormalized();
    if (!normal.allFinite()) normal.setZero();
  }
}

/// The work that a scene asks for; refuses what is beyond the limits before any of it is done.
class SceneSize {
 public:
  explicit SceneSize(const GltfLimits& limits) : limits_(limits) {}

  void add(const PrimitiveSize& primitive) {
    add(vertices_, primitive.vertices, limits_.maxVertices, "vertices", "maxVertices");
    add(triangles_, primitive.triangles, limits_.maxTriangles, "triangles", "maxTriangles");
    add(zeroElements_, primitive.zeroElements, limits_.maxZeroElements,
        "elements in accessors without a buffer view", "maxZeroElements");
  }

  std::uint64_t vertices() const { return vertices_; }
  std::uint64_t triangles() const { return triangles_; }

 private:
  static void add(std::uint64_t& sum, std::uint64_t count, std::uint64_t limit, const char* what,
                  const char* name) {
    constexpr std::uint64_t kMost = INT32_MAX / 3;  // corners are numbered by `int`
    sum += count;
    if (sum > limit)
      reject("the scene has more than " + number(limit) + ' ' + what + toRaise(name));
    if (sum > kMost) reject("the scene has more than " + number(kMost) + ' ' + what);
  }

  const GltfLimits& limits_;
  std::uint64_t vertices_ = 0, triangles_ = 0, zeroElements_ = 0;
};

class SceneBuilder {
 public:
  SceneBuilder(const Document& document, Buffers buffers, const GltfLimits& limits)
      : document_(document), accessors_(document, std::move(buffers)), limits_(limits) {}

  GltfScene build() {
    const std::vector<PlacedMesh> meshes = placedMeshes(document_, accessors_, limits_);
    SceneSize size(limits_);
    forEachPrimitive(meshes, [&](const Placed& placed) {
      const PrimitiveKind kind = kindOf(placed.primitive, placed.name);
      linePrimitives_ += kind == PrimitiveKind::kPointsOrLines;
      emptyPrimitives_ += kind == PrimitiveKind::kWithoutPositions;
      if (kind != PrimitiveKind::kTriangles) return;
      morphs_ += !placed.primitive.targets.empty();
      PrimitiveSize primitive = sizeOf(placed.primitive, placed.weights, accessors_, placed.name);
      if (placed.at.isFreeInstance) primitive.zeroElements += primitive.vertices;
      size.add(primitive);
    });
    for (const PlacedMesh& mesh : meshes) {
      skins_ += mesh.node >= 0 && document_.nodes[mesh.node].isSkinned;
    }
    scene_.positions.reserve(3 * size.vertices());
    scene_.triangles.reserve(3 * size.triangles());
    forEachPrimitive(meshes, [&](const Placed& placed) {
      if (kindOf(placed.primitive, placed.name) == PrimitiveKind::kTriangles) add(placed);
    });
    return finished();
  }

 private:
  struct Placed {
    const PlacedMesh& at;
    int index;
    const Primitive& primitive;
    std::span<const double> weights;
    std::string name;
  };

  template <class Use>
  void forEachPrimitive(std::span<const PlacedMesh> meshes, Use use) const {
    for (const PlacedMesh& at : meshes) {
      const Mesh& mesh = document_.meshes[at.mesh];
      std::span<const double> weights = mesh.weights;
      if (at.node >= 0 && !document_.nodes[at.node].weights.empty()) {
        weights = document_.nodes[at.node].weights;
      }
      for (int p = 0; p < static_cast<int>(mesh.primitives.size()); ++p) {
        use(Placed{at, p, mesh.primitives[p], weights,
                   "primitive " + std::to_string(p) + " of mesh " + std::to_string(at.mesh)});
      }
    }
  }

  void add(const Placed& placed) {
    const auto& [meshIndex, node, transform, isFreeInstance] = placed.at;
    GltfScene::Part part{node, meshIndex, placed.index, triangleCount(), 0, {}};
    part.name = node >= 0 && !document_.nodes[node].name.empty() ? document_.nodes[node].name
                                                                 : document_.meshes[meshIndex].name;
    append(readTriangles(placed.primitive, placed.weights, accessors_, placed.name), transform);
    part.triangleCount = triangleCount() - part.firstTriangle;
    if (part.triangleCount > 0) scene_.parts.push_back(std::move(part));
  }

  void append(PrimitiveTriangles primitive, const Eigen::Affine3d& transform) {
    const std::size_t firstVertex = scene_.positions.size() / 3;
    const bool mirrored = transform.linear().determinant() < 0;
    for (std::size_t t = 0; t < primitive.triangles.size(); t += 3) {
      if (mirrored) std::swap(primitive.triangles[t + 1], primitive.triangles[t + 2]);
    }
    for (int vertex : primitive.triangles) {
      scene_.triangles.push_back(static_cast<int>(firstVertex) + vertex);
    }
    for (std::size_t i = 0; i < primitive.positions.size(); i += 3) {
      const Eigen::Vector3d p = transform * Eigen::Vector3d::Map(&primitive.positions[i]);
      scene_.positions.insert(scene_.positions.end(), p.begin(), p.end());
    }
    badAttributes_ += primitive.badAttributes;
    if (!primitive.normals.empty()) {
      transformNormals(transform.linear(), primitive.normals);
      hasNormals_ = true;
      scene_.normals.reserve(scene_.positions.capacity());
      scene_.normals.resize(3 * firstVertex);
      scene_.normals.insert(scene_.normals.end(), primitive.normals.begin(),
                            primitive.normals.end());
    }
    if (!primitive.uvs.empty()) {
      for (double& x : primitive.uvs) {
        if (!std::isfinite(x)) x = 0;
      }
      hasUvs_ = true;
      scene_.uvs.reserve(scene_.positions.capacity() / 3 * 2);
      scene_.uvs.resize(2 * firstVertex);
      scene_.uvs.insert(scene_.uvs.end(), primitive.uvs.begin(), primitive.uvs.end());
    }
  }

  GltfScene finished() {
    note(linePrimitives_, "primitives of points or lines were passed over");
    note(emptyPrimitives_, "primitives without positions were passed over");
    note(badAttributes_, "normals or texture coordinates that cannot be read were passed over");
    note(skins_, "meshes with a skin were taken unposed");
    note(morphs_, "primitives with morph targets were taken with their default weights");
    if (scene_.triangles.empty()) {
      std::string why = "the scene has no triangles";
      for (const std::string& text : scene_.notes) why += "; " + text;
      reject(why);
    }
    if (hasNormals_) scene_.normals.resize(scene_.positions.size());
    if (hasUvs_) scene_.uvs.resize(scene_.positions.size() / 3 * 2);
    return std::move(scene_);
  }

  int triangleCount() const { return static_cast<int>(scene_.triangles.size() / 3); }

  void note(int count, const std::string& text) {
    if (count > 0) scene_.notes.push_back(text + " (" + std::to_string(count) + ")");
  }

  const Document& document_;
  AccessorReader accessors_;
  const GltfLimits& limits_;
  GltfScene scene_;
  int linePrimitives_ = 0, emptyPrimitives_ = 0, skins_ = 0, morphs_ = 0;
  int badAttributes_ = 0;
  bool hasNormals_ = false, hasUvs_ = false;
};

}  // namespace
}  // namespace gltf

GltfScene readGltf(std::span<const std::byte> bytes, std::span<const GltfResource> resources,
                   const GltfLimits& limits) {
  const gltf::Container container = gltf::openContainer(bytes);
  gltf::GltfJson json = gltf::readJson(container.json, limits);
  const gltf::Document document = gltf::parseDocument(json.text);
  gltf::Buffers buffers(std::move(json.buffers), container.bin, resources);
  return gltf::SceneBuilder(document, std::move(buffers), limits).build();
}

}  // namespace gvd
