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
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"
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

/// Reads a scene in slices.
class SceneReading final : public SlicedWork<GltfScene> {
 public:
  SceneReading(std::span<const std::byte> bytes, std::span<const GltfResource> resources,
               const GltfLimits& limits)
      : bytes_(bytes), resources_(resources), limits_(limits) {}

  bool step(long budget) override {
    return sequence_.run([&] { parse(); }, [&] { measure(); },
                         [&] { return addPrimitives(budget); }, [&] { finish(); });
  }
  double progress() const override {
    return primitives_.empty() ? 0 : (next_ + adding_.progress()) / (primitives_.size() + 1);
  }
  GltfScene take() override { return std::move(scene_); }

 private:
  /// A primitive of triangles where the scene has it.
  struct Placed {
    const PlacedMesh* at;
    int index;  ///< in its mesh
  };

  void parse() {
    const Container container = openContainer(bytes_);
    GltfJson json = readJson(container.json, limits_);
    document_ = parseDocument(json.text);
    accessors_.emplace(document_, Buffers(std::move(json.buffers), container.bin, resources_));
  }

  /// Refuses what is beyond the limits before any of it is read.
  void measure() {
    meshes_ = placedMeshes(document_, *accessors_, limits_);
    SceneSize size(limits_);
    for (const PlacedMesh& at : meshes_) {
      const int count = static_cast<int>(document_.meshes[at.mesh].primitives.size());
      for (int i = 0; i < count; ++i) measure({&at, i}, size);
      skins_ += at.node >= 0 && document_.nodes[at.node].isSkinned;
    }
    scene_.positions.reserve(3 * size.vertices());
    scene_.triangles.reserve(3 * size.triangles());
  }

  void measure(const Placed& placed, SceneSize& size) {
    const Primitive& primitive = primitiveOf(placed);
    const std::string name = nameOf(placed);
    const PrimitiveKind kind = kindOf(primitive, name);
    linePrimitives_ += kind == PrimitiveKind::kPointsOrLines;
    emptyPrimitives_ += kind == PrimitiveKind::kWithoutPositions;
    if (kind != PrimitiveKind::kTriangles) return;
    morphs_ += !primitive.targets.empty();
    PrimitiveSize asked = sizeOf(primitive, weightsOf(placed), *accessors_, name);
    if (placed.at->isFreeInstance) asked.zeroElements += asked.vertices;
    size.add(asked);
    primitives_.push_back(placed);
  }

  const Primitive& primitiveOf(const Placed& placed) const {
    return document_.meshes[placed.at->mesh].primitives[placed.index];
  }

  std::span<const double> weightsOf(const Placed& placed) const {
    const auto [mesh, node] = std::pair(placed.at->mesh, placed.at->node);
    const bool hasOwn = node >= 0 && !document_.nodes[node].weights.empty();
    return hasOwn ? document_.nodes[node].weights : document_.meshes[mesh].weights;
  }

  static std::string nameOf(const Placed& placed) {
    return "primitive " + std::to_string(placed.index) + " of mesh " +
           std::to_string(placed.at->mesh);
  }

  bool addPrimitives(long& budget) {
    for (; next_ < primitives_.size(); ++next_) {
      if (!add(primitives_[next_], budget)) return false;
      adding_ = {};
    }
    return true;
  }

  bool add(const Placed& placed, long& budget) {
    const Eigen::Affine3d& transform = placed.at->transform;
    return adding_.run([&] { name_ = nameOf(placed); },
                       [&] {
                         return runPart(reading_, budget, primitiveOf(placed), weightsOf(placed),
                                        *accessors_, name_);
                       },
                       [&] {
                         primitive_ = taken(reading_);
                         firstVertex_ = static_cast<int>(scene_.positions.size() / 3);
                         addPart(placed);
                       },
                       [&] { return addTriangles(transform.linear().determinant() < 0, budget); },
                       [&] { return addPositions(transform, budget); },
                       [&] { return addNormals(transform.linear(), budget); },
                       [&] { return addUvs(budget); }, [&] { addDensity(); },
                       [&] { primitive_ = {}; });
  }

  void addPart(const Placed& placed) {
    const auto [mesh, node] = std::pair(placed.at->mesh, placed.at->node);
    const int first = static_cast<int>(scene_.triangles.size() / 3);
    const int count = static_cast<int>(primitive_.triangles.size() / 3);
    badAttributes_ += primitive_.badAttributes;
    if (count == 0) return;
    const bool isNamed = node >= 0 && !document_.nodes[node].name.empty();
    scene_.parts.push_back({node, mesh, placed.index, first, count,
                            isNamed ? document_.nodes[node].name : document_.meshes[mesh].name});
  }

  bool addTriangles(bool isMirrored, long& budget) {
    const std::vector<int>& own = primitive_.triangles;
    return loop_.run(own.size() / 3, budget, kPerUnit, [&](int t) {
      const int* const corners = &own[3 * static_cast<std::size_t>(t)];
      const int second = isMirrored ? 2 : 1;
      for (const int i : {0, second, 3 - second})
        scene_.triangles.push_back(firstVertex_ + corners[i]);
    });
  }

  bool addPositions(const Eigen::Affine3d& transform, long& budget) {
    return loop_.run(primitive_.positions.size() / 3, budget, kPerUnit, [&](int v) {
      const Eigen::Vector3d p = transform * vectorAt(primitive_.positions, v);
      for (const double x : p) scene_.positions.push_back(x);
    });
  }

  /// The cofactors of a matrix turn normals as it turns surfaces, singular or not.
  bool addNormals(const Eigen::Matrix3d& m, long& budget) {
    if (primitive_.normals.empty()) return true;
    if (!std::exchange(hasNormals_, true)) scene_.normals.reserve(scene_.positions.capacity());
    const std::size_t before = 3 * static_cast<std::size_t>(firstVertex_);
    if (scene_.normals.size() < before) scene_.normals.resize(before);
    Eigen::Matrix3d cofactors;
    for (int i = 0; i < 3; ++i) cofactors.col(i) = m.col((i + 1) % 3).cross(m.col((i + 2) % 3));
    if (m.determinant() < 0) cofactors = -cofactors;
    return loop_.run(primitive_.normals.size() / 3, budget, kPerUnit, [&](int v) {
      Eigen::Vector3d normal = (cofactors * vectorAt(primitive_.normals, v)).stableNormalized();
      if (!normal.allFinite()) normal.setZero();
      for (const double x : normal) scene_.normals.push_back(x);
    });
  }

  bool addUvs(long& budget) {
    if (primitive_.uvs.empty()) return true;
    if (!std::exchange(hasUvs_, true)) scene_.uvs.reserve(scene_.positions.capacity() / 3 * 2);
    const std::size_t before = 2 * static_cast<std::size_t>(firstVertex_);
    if (scene_.uvs.size() < before) scene_.uvs.resize(before);
    return loop_.run(primitive_.uvs.size(), budget, kQuickRounds, [&](int i) {
      const double x = primitive_.uvs[i];
      scene_.uvs.push_back(std::isfinite(x) ? x : 0);
    });
  }

  void addDensity() {
    if (primitive_.density.empty()) return;
    hasDensity_ = true;
    scene_.density.resize(firstVertex_, 1);
    scene_.density.insert(scene_.density.end(), primitive_.density.begin(),
                          primitive_.density.end());
  }

  static Eigen::Vector3d vectorAt(const std::vector<double>& numbers, int vertex) {
    return Eigen::Vector3d::Map(&numbers[3 * static_cast<std::size_t>(vertex)]);
  }

  void finish() {
    note(linePrimitives_, "primitives of points or lines were passed over");
    note(emptyPrimitives_, "primitives without positions were passed over");
    note(badAttributes_,
         "normals, texture coordinates or densities that cannot be read were passed over");
    note(skins_, "meshes with a skin were taken unposed");
    note(morphs_, "primitives with morph targets were taken with their default weights");
    if (scene_.triangles.empty()) {
      std::string why = "the scene has no triangles";
      for (const std::string& text : scene_.notes) why += "; " + text;
      reject(why);
    }
    if (hasNormals_) scene_.normals.resize(scene_.positions.size());
    if (hasUvs_) scene_.uvs.resize(scene_.positions.size() / 3 * 2);
    if (hasDensity_) scene_.density.resize(scene_.positions.size() / 3, 1);
  }

  void note(int count, const std::string& text) {
    if (count > 0) scene_.notes.push_back(text + " (" + std::to_string(count) + ")");
  }

  /// Triangles or vertices per unit of work.
  static constexpr long kPerUnit = 16;

  const std::span<const std::byte> bytes_;
  const std::span<const GltfResource> resources_;
  const GltfLimits limits_;
  Document document_;
  std::optional<AccessorReader> accessors_;
  std::vector<PlacedMesh> meshes_;
  std::vector<Placed> primitives_;
  GltfScene scene_;
  int linePrimitives_ = 0, emptyPrimitives_ = 0, skins_ = 0, morphs_ = 0;
  int badAttributes_ = 0;
  bool hasNormals_ = false, hasUvs_ = false, hasDensity_ = false;
  SlicedSequence sequence_, adding_;
  SlicedLoop loop_;
  std::size_t next_ = 0;  ///< of `primitives_`

  // The primitive at hand.
  std::string name_;
  std::optional<PrimitiveReading> reading_;
  PrimitiveTriangles primitive_;
  int firstVertex_ = 0;  ///< its first one in the scene
};

}  // namespace
}  // namespace gltf

std::unique_ptr<SlicedWork<GltfScene>> startGltf(std::span<const std::byte> bytes,
                                                 std::span<const GltfResource> resources,
                                                 const GltfLimits& limits) {
  return std::make_unique<gltf::SceneReading>(bytes, resources, limits);
}

GltfScene readGltf(std::span<const std::byte> bytes, std::span<const GltfResource> resources,
                   const GltfLimits& limits) {
  return finished(startGltf(bytes, resources, limits));
}

}  // namespace gvd
