// SPDX-License-Identifier: MIT
//
// From bytes to triangles:
//   glb_container        GLB chunks, or the JSON itself
//   gltf_json            checks the JSON, keeps what triangles need
//   document             the objects (by tinygltf)
//   scene_walk           where each mesh of the scene is
//   primitive_triangles  the triangles of each primitive, by accessor_reader, buffers, data_uri
// No file is opened here: buffers outside the glTF come from the caller.

#include "gvd/gltf.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <utility>

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

/// Vertices, and triangles, of a scene: a small file can ask for any number of them. As surfaces,
/// more would not fit into the 4 GB of a WebAssembly memory.
constexpr std::uint64_t kMaxElements = std::uint64_t{1} << 24;

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

class SceneBuilder {
 public:
  SceneBuilder(const Document& document, Buffers buffers)
      : document_(document), accessors_(document, std::move(buffers)) {}

  GltfScene build() {
    for (const PlacedMesh& placed : placedMeshes(document_)) addMesh(placed);
    note(linePrimitives_, "primitives of points or lines were passed over");
    note(emptyPrimitives_, "primitives without positions were passed over");
    note(badAttributes_, "normals or texture coordinates that cannot be read were passed over");
    note(skins_, "meshes with a skin were taken unposed");
    note(morphs_, "primitives with morph targets were taken without them");
    note(instances_, "nodes with instances were taken once");
    if (scene_.triangles.empty()) {
      std::string why = "the scene has no triangles";
      for (const std::string& text : scene_.notes) why += "; " + text;
      reject(why);
    }
    if (hasNormals_) scene_.normals.resize(scene_.positions.size());
    if (hasUvs_) scene_.uvs.resize(scene_.positions.size() / 3 * 2);
    return std::move(scene_);
  }

 private:
  void addMesh(const PlacedMesh& placed) {
    if (placed.node >= 0) {
      skins_ += document_.nodes[placed.node].isSkinned;
      instances_ += document_.nodes[placed.node].isInstanced;
    }
    const int count = static_cast<int>(document_.meshes[placed.mesh].primitives.size());
    for (int p = 0; p < count; ++p) addPrimitive(placed, p);
  }

  void addPrimitive(const PlacedMesh& placed, int primitiveIndex) {
    const Mesh& mesh = document_.meshes[placed.mesh];
    const Primitive& primitive = mesh.primitives[primitiveIndex];
    const std::string name =
        "primitive " + std::to_string(primitiveIndex) + " of mesh " + std::to_string(placed.mesh);
    if (!makesTriangles(primitive, name)) {
      ++linePrimitives_;
      return;
    }
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) {
      ++emptyPrimitives_;
      return;
    }
    morphs_ += !primitive.targets.empty();
    requireIndex(position->second, document_.accessors.size(), "accessor", name);
    const Accessor& positions = document_.accessors[position->second];
    requireUncompressed(primitive, positions, name);
    requireRoom(scene_.positions.size() / 3 + positions.count);

    GltfScene::Part part{placed.node, placed.mesh, primitiveIndex, triangleCount(), 0, mesh.name};
    if (placed.node >= 0 && !document_.nodes[placed.node].name.empty()) {
      part.name = document_.nodes[placed.node].name;
    }
    append(readTriangles(primitive, accessors_, name), placed.transform);
    part.triangleCount = triangleCount() - part.firstTriangle;
    if (part.triangleCount > 0) scene_.parts.push_back(std::move(part));
    requireRoom(scene_.triangles.size() / 3);
  }

  static void requireRoom(std::uint64_t elements) {
    if (elements <= kMaxElements) return;
    reject("the scene has more than " + number(kMaxElements) + " vertices or triangles");
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
      scene_.normals.resize(3 * firstVertex);
      scene_.normals.insert(scene_.normals.end(), primitive.normals.begin(),
                            primitive.normals.end());
    }
    if (!primitive.uvs.empty()) {
      for (double& x : primitive.uvs) {
        if (!std::isfinite(x)) x = 0;
      }
      hasUvs_ = true;
      scene_.uvs.resize(2 * firstVertex);
      scene_.uvs.insert(scene_.uvs.end(), primitive.uvs.begin(), primitive.uvs.end());
    }
  }

  int triangleCount() const { return static_cast<int>(scene_.triangles.size() / 3); }

  void note(int count, const std::string& text) {
    if (count > 0) scene_.notes.push_back(text + " (" + std::to_string(count) + ")");
  }

  const Document& document_;
  AccessorReader accessors_;
  GltfScene scene_;
  int linePrimitives_ = 0, emptyPrimitives_ = 0, skins_ = 0, morphs_ = 0, instances_ = 0;
  int badAttributes_ = 0;
  bool hasNormals_ = false, hasUvs_ = false;
};

}  // namespace
}  // namespace gltf

GltfScene readGltf(std::span<const std::byte> bytes, std::span<const GltfResource> resources) {
  const gltf::Container container = gltf::openContainer(bytes);
  gltf::GltfJson json = gltf::readJson(container.json);
  const gltf::Document document = gltf::parseDocument(json.text);
  gltf::Buffers buffers(std::move(json.buffers), container.bin, resources);
  return gltf::SceneBuilder(document, std::move(buffers)).build();
}

}  // namespace gvd
