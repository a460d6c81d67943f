// SPDX-License-Identifier: MIT
//
// From bytes to triangles:
//   glb_container        GLB chunks, or the JSON itself
//   json_filter          parses the JSON and keeps what triangles need, by the table in json_rules
//   gltf_json            version, extensions, buffers
//   document             the objects (by tinygltf)
//   scene_walk           where each mesh of the scene is
//   primitive_triangles  the triangles of each primitive, by accessor_reader and buffers
// No file is opened here: buffers outside the glTF come from the caller.

#include "gvd/gltf.h"

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

/// Adds to a count; throws beyond its limit.
void addUp(std::uint64_t& sum, std::uint64_t count, std::uint64_t limit, const char* what,
           const char* limitName) {
  constexpr std::uint64_t kMost = INT32_MAX / 3;  // corners are numbered by `int`
  sum += count;
  if (sum > limit)
    reject("the scene has more than " + std::to_string(limit) + ' ' + what + toRaise(limitName));
  if (sum > kMost) reject("the scene has more than " + std::to_string(kMost) + ' ' + what);
}

/// Reads a scene in slices.
class SceneReading final : public SequentialWork<GltfScene> {
 public:
  SceneReading(std::span<const std::byte> bytes, std::span<const GltfResource> resources,
               const GltfLimits& limits)
      : bytes_(bytes), resources_(resources), limits_(limits) {}

  bool advance(long budget) override {
    return sequence_.run([&] { parse(); }, [&] { addUpSizes(); },
                         [&] { return addPrimitives(budget); }, [&] { finish(); });
  }
  double share() const override {
    return primitives_.empty() ? 0 : (next_ + adding_.progress()) / (primitives_.size() + 1);
  }

 private:
  /// A primitive of triangles at one of its places in the scene.
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

  /// Adds up the size of the scene; throws if it exceeds a limit, before anything is read.
  void addUpSizes() {
    meshes_ = placedMeshes(document_, *accessors_, limits_);
    PrimitiveSize size;
    for (const PlacedMesh& at : meshes_) {
      const int count = static_cast<int>(document_.meshes[at.mesh].primitives.size());
      for (int i = 0; i < count; ++i) addSize({&at, i}, size);
      skins_ += at.node >= 0 && document_.nodes[at.node].isSkinned;
    }
    out_.positions.reserve(3 * (size.vertices - size.countedAgain));
    out_.triangles.reserve(3 * size.triangles);
  }

  /// Adds the size of a primitive to that of the scene.
  void addSize(const Placed& placed, PrimitiveSize& size) {
    const Primitive& primitive = primitiveOf(placed);
    const std::string name = nameOf(placed);
    const PrimitiveKind kind = kindOf(primitive, name);
    linePrimitives_ += kind == PrimitiveKind::kPointsOrLines;
    emptyPrimitives_ += kind == PrimitiveKind::kWithoutPositions;
    if (kind != PrimitiveKind::kTriangles) return;
    morphs_ += !primitive.targets.empty();
    PrimitiveSize own = sizeOf(primitive, weightsOf(placed), *accessors_, name);
    if (placed.at->isFreeInstance) own.zeroElements += own.vertices;
    addUp(size.vertices, own.vertices, limits_.maxVertices, "vertices", "maxVertices");
    size.countedAgain += own.countedAgain;
    addUp(size.triangles, own.triangles, limits_.maxTriangles, "triangles", "maxTriangles");
    addUp(size.zeroElements, own.zeroElements, limits_.maxZeroElements,
          "elements in accessors without a buffer view", "maxZeroElements");
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
    return adding_.run(
        [&] {
          name_ = nameOf(placed);
          addPart(placed);
        },
        [&] {
          return runPart(reading_, budget, primitiveOf(placed), weightsOf(placed),
                         placed.at->transform, *accessors_, name_, out_);
        },
        [&] {
          badAttributes_ += reading_->badAttributes();
          reading_.reset();
          GltfScene::Part& part = out_.parts.back();
          part.triangleCount = triangleCount() - part.firstTriangle;
          if (part.triangleCount == 0) out_.parts.pop_back();
        });
  }

  /// Begins the part of a primitive; its triangles follow.
  void addPart(const Placed& placed) {
    const auto [mesh, node] = std::pair(placed.at->mesh, placed.at->node);
    const bool isNamed = node >= 0 && !document_.nodes[node].name.empty();
    out_.parts.push_back({node, mesh, placed.index, triangleCount(), 0,
                          isNamed ? document_.nodes[node].name : document_.meshes[mesh].name});
  }

  int triangleCount() const { return static_cast<int>(out_.triangles.size() / 3); }

  void finish() {
    note(linePrimitives_, "primitives of points or lines were passed over");
    note(emptyPrimitives_, "primitives without positions were passed over");
    note(badAttributes_,
         "normals, texture coordinates or densities that cannot be read were passed over");
    note(skins_, "meshes with a skin were taken unposed");
    note(morphs_, "primitives with morph targets were taken with their default weights");
    if (out_.triangles.empty()) {
      std::string why = "the scene has no triangles";
      for (const std::string& text : out_.notes) why += "; " + text;
      reject(why);
    }
    const std::size_t vertices = out_.positions.size() / 3;
    if (!out_.normals.empty()) out_.normals.resize(3 * vertices);
    if (!out_.uvs.empty()) out_.uvs.resize(2 * vertices);
    if (!out_.density.empty()) out_.density.resize(vertices, 1);
  }

  void note(int count, const std::string& text) {
    if (count > 0) out_.notes.push_back(text + " (" + std::to_string(count) + ")");
  }

  const std::span<const std::byte> bytes_;
  const std::span<const GltfResource> resources_;
  const GltfLimits limits_;
  Document document_;
  std::optional<AccessorReader> accessors_;
  std::vector<PlacedMesh> meshes_;
  std::vector<Placed> primitives_;
  int linePrimitives_ = 0, emptyPrimitives_ = 0, skins_ = 0, morphs_ = 0;
  int badAttributes_ = 0;
  SlicedSequence adding_;
  std::size_t next_ = 0;  ///< in `primitives_`

  // The current primitive.
  std::string name_;
  std::optional<PrimitiveReading> reading_;
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
