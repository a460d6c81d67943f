// SPDX-License-Identifier: MIT
//
// tinygltf parses the objects of a glTF; it checks few of them and reads no accessor. So this file
//  - takes the container apart (GLB chunks, JSON, data URIs) and gives tinygltf only what triangles
//    need: an undecodable image or a strange material must not keep a mesh from being read;
//  - believes no index, offset or count that tinygltf hands back: all bytes are reached through
//    `SceneReader::elements`, which checks the range once for all elements.
// No file is opened here: buffers outside the glTF come from the caller.

#include "gvd/gltf.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>  // tinygltf needs it and with TINYGLTF_NO_FS does not include it
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "gvd/error.h"

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

namespace gvd {
namespace {

using Bytes = std::span<const std::byte>;
using nlohmann::json;

static_assert(std::endian::native == std::endian::little, "glTF is read as it lies in memory");

/// tinygltf descends into `extras` and `extensions` recursively; real files nest a dozen levels.
constexpr int kMaxJsonDepth = 128;

/// Vertices, and triangles, of a scene: a small file can ask for any number of them. As surfaces,
/// more would not fit into the 4 GB of a WebAssembly memory.
constexpr std::uint64_t kMaxElements = std::uint64_t{1} << 24;

[[noreturn]] void reject(const std::string& why) { throw Error(ErrorCode::kInvalidGltf, why); }

std::string number(std::uint64_t n) { return std::to_string(n); }

// --- The container -----------------------------------------------------------------------------

struct Container {
  std::string_view json;
  std::optional<Bytes> bin;  ///< the binary chunk of a GLB
};

std::string_view asText(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::uint32_t uint32At(Bytes bytes, std::size_t offset) {
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

struct Chunk {
  std::uint32_t type = 0;
  Bytes content;
};

/// The chunk that `rest` begins with (length, type, content), taken off it; none if it is at its
/// end.
Chunk takeChunk(Bytes& rest) {
  constexpr std::size_t kHeaderSize = 8;
  if (rest.size() < kHeaderSize) return {};
  const std::uint32_t length = uint32At(rest, 0), type = uint32At(rest, 4);
  rest = rest.subspan(kHeaderSize);
  if (length > rest.size()) reject("a chunk of the GLB reaches past its end");
  const Bytes content = rest.first(length);
  rest = rest.subspan(length);
  return {type, content};
}

/// Header (magic, version, length), then chunks: the first is the JSON, the second may be binary,
/// others are to be ignored.
Container openGlb(Bytes bytes) {
  constexpr std::size_t kHeaderSize = 12;
  constexpr std::uint32_t kJson = 0x4E4F534A, kBin = 0x004E4942;

  if (bytes.size() < kHeaderSize) reject("the GLB is truncated within its header");
  const std::uint32_t version = uint32At(bytes, 4), length = uint32At(bytes, 8);
  if (version != 2) reject("this is GLB version " + number(version) + "; only version 2 is read");
  if (length > bytes.size()) {
    reject("the GLB is truncated: it should have " + number(length) + " bytes but has " +
           number(bytes.size()));
  }
  Bytes rest = bytes.first(length).subspan(std::min<std::size_t>(kHeaderSize, length));
  const Chunk json = takeChunk(rest), bin = takeChunk(rest);
  if (json.type != kJson) reject("the GLB does not begin with a JSON chunk");
  if (bin.type != kBin) return {asText(json.content), std::nullopt};
  return {asText(json.content), bin.content};
}

Container openContainer(Bytes bytes) {
  const std::string_view text = asText(bytes);
  if (text.empty()) reject("the file is empty");
  if (text.starts_with("glTF")) return openGlb(bytes);
  const std::string_view withoutMark = text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
  const std::size_t first = withoutMark.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || withoutMark[first] != '{') {
    reject("this is neither GLB nor glTF JSON");
  }
  return {withoutMark, std::nullopt};
}

// --- The JSON ----------------------------------------------------------------------------------

void requireShallow(std::string_view text) {
  int depth = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inString) {
      if (c == '\\') ++i;
      if (c == '"') inString = false;
    } else if (c == '"') {
      inString = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kMaxJsonDepth) {
        reject("the JSON is nested more than " + number(kMaxJsonDepth) + " levels deep");
      }
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
}

json parseJson(std::string_view text) {
  requireShallow(text);
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    reject("the JSON is malformed at byte " + number(error.byte));
  } catch (const json::out_of_range&) {
    reject("the JSON has a number that is too large");
  }
}

/// The part of a document that triangles need.
json trimmed(json document) {
  json needed = json::object();
  for (const char* key : {"asset", "extensionsRequired", "scene", "scenes", "nodes", "meshes",
                          "accessors", "bufferViews", "buffers"}) {
    const auto member = document.find(key);
    if (member != document.end()) needed[key] = std::move(*member);
  }
  return needed;
}

void requireVersion2(const json& document) {
  const json asset = document.value("asset", json());
  const json version = asset.is_object() ? asset.value("version", json()) : json();
  if (!version.is_string()) reject("the JSON has no asset.version, so it is not a glTF");
  const json minVersion = asset.value("minVersion", json("2.0"));
  if (!version.get<std::string>().starts_with("2.") || minVersion != "2.0") {
    const json& needed = minVersion == "2.0" ? version : minVersion;
    reject("this is glTF version " + needed.dump() + "; only version 2.0 is read");
  }
}

/// Whether triangles can be read without knowing the extension.
bool isHarmless(const std::string& extension) {
  for (const char* prefix :
       {"KHR_mesh_quantization", "KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_",
        "KHR_lights_", "EXT_lights_", "KHR_animation_", "KHR_xmp"}) {
    if (extension.starts_with(prefix)) return true;
  }
  return false;
}

void requireKnownExtensions(const json& document) {
  const auto list = document.find("extensionsRequired");
  if (list == document.end()) return;
  for (const json& entry : *list) {
    const std::string extension = entry.is_string() ? entry.get<std::string>() : entry.dump();
    if (isHarmless(extension)) continue;
    const bool compression = extension.find("compression") != std::string::npos;
    reject("the glTF requires the extension " + extension +
           (compression ? ", which has to be decompressed before it is read here"
                        : ", which is not supported"));
  }
}

/// A document without buffers: those are read here, for tinygltf refuses many valid ones.
tinygltf::Model parseModel(const json& document) {
  const std::string text = document.dump(-1, ' ', false, json::error_handler_t::replace);
  tinygltf::Model model;
  tinygltf::TinyGLTF parser;
  std::string error, warning;
  constexpr unsigned int kRequireNothing = 0;
  const bool parsed =
      parser.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                 static_cast<unsigned int>(text.size()), "", kRequireNothing);
  // An object that tinygltf leaves out for a fault would shift the numbers of those after it.
  if (!parsed || !error.empty()) {
    reject("the glTF is invalid: " + error.substr(0, error.find_last_not_of(".\n") + 1));
  }
  return model;
}

// --- Buffers -----------------------------------------------------------------------------------

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string percentDecoded(std::string_view text) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int high = i + 2 < text.size() && text[i] == '%' ? hexDigit(text[i + 1]) : -1;
    const int low = high >= 0 ? hexDigit(text[i + 2]) : -1;
    if (low >= 0) {
      decoded += static_cast<char>(16 * high + low);
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

/// The value of each base64 digit, -1 for other characters.
constexpr std::array<signed char, 256> kBase64Value = [] {
  std::array<signed char, 256> values{};
  values.fill(-1);
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < kDigits.size(); ++i) {
    values[static_cast<unsigned char>(kDigits[i])] = static_cast<signed char>(i);
  }
  return values;
}();

/// Padding may be missing; white space may stand anywhere.
std::optional<std::string> base64Decoded(std::string_view text) {
  std::string decoded;
  decoded.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int bitCount = 0;
  for (const char c : text.substr(0, text.find('='))) {
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
    const int value = kBase64Value[static_cast<unsigned char>(c)];
    if (value < 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    bitCount += 6;
    if (bitCount < 8) continue;
    bitCount -= 8;
    decoded += static_cast<char>(bits >> bitCount & 0xFF);
  }
  return decoded;
}

bool isDataUri(std::string_view uri) {
  constexpr std::string_view kScheme = "data:";
  return uri.size() >= kScheme.size() &&
         std::equal(kScheme.begin(), kScheme.end(), uri.begin(),
                    [](char a, char b) { return a == (b | 0x20) || a == b; });
}

/// The content of `data:<media type>[;base64],<content>`.
std::string dataUriContent(std::string_view uri, const std::string& owner) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) reject(owner + " has a data URI without content");
  std::string content = percentDecoded(uri.substr(comma + 1));
  if (!uri.substr(0, comma).ends_with(";base64")) return content;
  std::optional<std::string> decoded = base64Decoded(content);
  if (!decoded) reject(owner + " has a data URI that is not base64");
  return *std::move(decoded);
}

void requireIndex(int index, std::size_t count, const std::string& what, const std::string& owner) {
  if (index >= 0 && static_cast<std::size_t>(index) < count) return;
  reject(owner + " names " + what + " " + std::to_string(index) + ", but the glTF has " +
         number(count));
}

/// The buffers of a document, each found when it is first asked for: files name buffers that no
/// triangle needs.
class Buffers {
 public:
  /// Takes the buffers out of the document.
  Buffers(json& document, std::optional<Bytes> bin, std::span<const GltfResource> resources)
      : bin_(bin), resources_(resources) {
    const auto list = document.find("buffers");
    if (list == document.end()) return;
    for (json& buffer : *list) buffers_.push_back({std::move(buffer), {}, {}});
    document.erase(list);
  }

  /// The `byteLength` bytes of a buffer that `owner` names.
  Bytes at(int index, const std::string& owner) {
    requireIndex(index, buffers_.size(), "buffer", owner);
    Buffer& buffer = buffers_[index];
    if (!buffer.bytes) buffer.bytes = load(buffer, index);
    return *buffer.bytes;
  }

 private:
  struct Buffer {
    json object;
    std::string decoded;  ///< what a data URI holds
    std::optional<Bytes> bytes;
  };

  Bytes load(Buffer& buffer, int index) {
    const std::string name = "buffer " + std::to_string(index);
    const auto length = buffer.object.find("byteLength");
    if (length == buffer.object.end() || !length->is_number_unsigned()) {
      reject(name + " has no valid byteLength");
    }
    const Bytes bytes = content(buffer, index, name);
    if (length->get<std::uint64_t>() > bytes.size()) {
      reject(name + " should have " + length->dump() + " bytes but has " + number(bytes.size()));
    }
    return bytes.first(length->get<std::size_t>());
  }

  Bytes content(Buffer& buffer, int index, const std::string& name) {
    const auto uri = buffer.object.find("uri");
    if (uri == buffer.object.end() || !uri->is_string()) {
      if (index == 0 && bin_) return *bin_;
      reject(name + " has no uri, and there is no binary chunk for it");
    }
    const std::string& text = uri->get_ref<const std::string&>();
    if (isDataUri(text)) {
      buffer.decoded = dataUriContent(text, name);
      return std::as_bytes(std::span(buffer.decoded));
    }
    for (const GltfResource& resource : resources_) {
      if (percentDecoded(resource.uri) == percentDecoded(text)) return resource.bytes;
    }
    reject(name + " is in the file \"" + text + "\", which is missing");
  }

  std::optional<Bytes> bin_;
  std::span<const GltfResource> resources_;
  std::vector<Buffer> buffers_;
};

// --- Numbers -----------------------------------------------------------------------------------

template <class T>
double load(const std::byte* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// How numbers of one component type lie in memory. Integers that are `normalized` stand for
/// themselves over `largest`; 0: no integers.
struct ComponentType {
  int id;
  std::uint64_t size;
  double (*load)(const std::byte*);
  double largest;
};

constexpr ComponentType kInt8 = {TINYGLTF_COMPONENT_TYPE_BYTE, 1, load<std::int8_t>, 127};
constexpr ComponentType kUint8 = {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, 1, load<std::uint8_t>,
                                  255};
constexpr ComponentType kInt16 = {TINYGLTF_COMPONENT_TYPE_SHORT, 2, load<std::int16_t>, 32767};
constexpr ComponentType kUint16 = {TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, 2, load<std::uint16_t>,
                                   65535};
constexpr ComponentType kUint32 = {TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, 4, load<std::uint32_t>,
                                   4294967295};
constexpr ComponentType kFloat = {TINYGLTF_COMPONENT_TYPE_FLOAT, 4, load<float>, 0};

/// What an accessor has to look like for the use that is made of it.
struct Format {
  const char* what;
  int type;  ///< SCALAR, VEC3, …
  std::uint64_t components;
  std::span<const ComponentType> allowed;
};

constexpr ComponentType kIndexTypes[] = {kUint8, kUint16, kUint32};
/// The integers are those of KHR_mesh_quantization.
constexpr ComponentType kPositionTypes[] = {kInt8, kUint8, kInt16, kUint16, kFloat};

constexpr Format kIndices = {"vertex indices", TINYGLTF_TYPE_SCALAR, 1, kIndexTypes};
constexpr Format kPositions = {"positions", TINYGLTF_TYPE_VEC3, 3, kPositionTypes};
constexpr Format kNormals = {"normals", TINYGLTF_TYPE_VEC3, 3, kPositionTypes};
constexpr Format kUvs = {"texture coordinates", TINYGLTF_TYPE_VEC2, 2, kPositionTypes};

const ComponentType& componentType(int id, const Format& format, const std::string& owner) {
  for (const ComponentType& type : format.allowed) {
    if (type.id == id) return type;
  }
  reject(owner + " has component type " + std::to_string(id) + ", which " + format.what +
         " cannot have");
}

// --- The scene ---------------------------------------------------------------------------------

/// Calls emit(i, j, k) for every triangle that a primitive of `count` corners makes; corners too
/// few for a last triangle make none.
template <class Emit>
void forEachTriangle(int mode, int count, Emit emit) {
  switch (mode) {
    case TINYGLTF_MODE_TRIANGLES:
      for (int i = 0; i + 2 < count; i += 3) emit(i, i + 1, i + 2);
      break;
    case TINYGLTF_MODE_TRIANGLE_STRIP:  // every other triangle would come out turned over
      for (int i = 0; i + 2 < count; ++i) emit(i, i + 1 + i % 2, i + 2 - i % 2);
      break;
    case TINYGLTF_MODE_TRIANGLE_FAN:
      for (int i = 1; i + 1 < count; ++i) emit(i, i + 1, 0);
      break;
  }
}

class SceneReader {
 public:
  SceneReader(const tinygltf::Model& model, Buffers buffers)
      : model_(model), buffers_(std::move(buffers)) {}

  GltfScene read() {
    if (model_.nodes.empty()) {
      for (int m = 0; m < static_cast<int>(model_.meshes.size()); ++m) {
        addMesh(m, -1, Eigen::Affine3d::Identity());
      }
    } else {
      walk(rootNodes());
    }
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
  // Nodes

  std::vector<int> rootNodes() const {
    if (model_.defaultScene != -1) {
      requireIndex(model_.defaultScene, model_.scenes.size(), "scene", "the glTF");
      return model_.scenes[model_.defaultScene].nodes;
    }
    const int count = static_cast<int>(model_.nodes.size());
    std::vector<char> isChild(count, false);
    for (const tinygltf::Node& node : model_.nodes) {
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

  /// Depth first, without recursion: files nest as deep as they like.
  void walk(const std::vector<int>& roots) {
    struct Visit {
      int node;
      std::string parent;
      Eigen::Affine3d transform;
    };
    std::vector<Visit> stack;
    const auto push = [&](const std::vector<int>& nodes, const std::string& parent,
                          const Eigen::Affine3d& transform) {
      for (auto n = nodes.rbegin(); n != nodes.rend(); ++n) {
        stack.push_back({*n, parent, transform});
      }
    };
    std::vector<char> visited(model_.nodes.size(), false);
    push(roots, "the scene", Eigen::Affine3d::Identity());
    while (!stack.empty()) {
      const Visit visit = std::move(stack.back());
      stack.pop_back();
      requireIndex(visit.node, model_.nodes.size(), "node", visit.parent);
      const std::string name = "node " + std::to_string(visit.node);
      if (visited[visit.node]) reject(name + " is in the scene twice");
      visited[visit.node] = true;

      const tinygltf::Node& node = model_.nodes[visit.node];
      const Eigen::Affine3d transform = visit.transform * localTransform(node, name);
      if (node.mesh != -1) {
        requireIndex(node.mesh, model_.meshes.size(), "mesh", name);
        skins_ += node.skin >= 0;
        instances_ += node.extensions.count("EXT_mesh_gpu_instancing") > 0;
        addMesh(node.mesh, visit.node, transform);
      }
      push(node.children, name, transform);
    }
  }

  static Eigen::Affine3d localTransform(const tinygltf::Node& node, const std::string& name) {
    const auto require = [&](const std::vector<double>& values, std::size_t count,
                             const char* what) {
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

  // Meshes

  void addMesh(int mesh, int node, const Eigen::Affine3d& transform) {
    for (int p = 0; p < static_cast<int>(model_.meshes[mesh].primitives.size()); ++p) {
      addPrimitive(mesh, p, node, transform);
    }
  }

  void addPrimitive(int meshIndex, int primitiveIndex, int node, const Eigen::Affine3d& transform) {
    const tinygltf::Mesh& mesh = model_.meshes[meshIndex];
    const tinygltf::Primitive& primitive = mesh.primitives[primitiveIndex];
    const std::string name =
        "primitive " + std::to_string(primitiveIndex) + " of mesh " + std::to_string(meshIndex);
    if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
      reject(name + " has the unknown mode " + std::to_string(primitive.mode));
    }
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
      ++linePrimitives_;
      return;
    }
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) {
      ++emptyPrimitives_;
      return;
    }
    morphs_ += !primitive.targets.empty();
    requireIndex(position->second, model_.accessors.size(), "accessor", name);
    requireUncompressed(primitive, model_.accessors[position->second], name);
    requireRoom(scene_.positions.size() / 3 + model_.accessors[position->second].count);
    const std::vector<double> positions = numbers(position->second, kPositions, name);
    const std::vector<int> corners =
        cornerVertices(primitive, static_cast<int>(positions.size() / 3), name);

    GltfScene::Part part{node, meshIndex, primitiveIndex, triangleCount(), 0, {}};
    part.name = node >= 0 && !model_.nodes[node].name.empty() ? model_.nodes[node].name : mesh.name;
    const int firstVertex = static_cast<int>(scene_.positions.size() / 3);
    const bool mirrored = transform.linear().determinant() < 0;
    forEachTriangle(primitive.mode, static_cast<int>(corners.size()), [&](int i, int j, int k) {
      if (mirrored) std::swap(j, k);
      for (int corner : {i, j, k}) scene_.triangles.push_back(firstVertex + corners[corner]);
    });
    addVertices(positions, transform);
    addAttributes(primitive, positions.size() / 3, transform, name);
    part.triangleCount = triangleCount() - part.firstTriangle;
    if (part.triangleCount > 0) scene_.parts.push_back(std::move(part));
    requireRoom(scene_.triangles.size() / 3);
  }

  static void requireRoom(std::uint64_t elements) {
    if (elements <= kMaxElements) return;
    reject("the scene has more than " + number(kMaxElements) + " vertices or triangles");
  }

  /// The vertex at each corner of a primitive: as its indices say, else one after the other.
  std::vector<int> cornerVertices(const tinygltf::Primitive& primitive, int vertexCount,
                                  const std::string& name) {
    std::vector<int> corners;
    if (primitive.indices == -1) {
      corners.resize(vertexCount);
      std::iota(corners.begin(), corners.end(), 0);
      return corners;
    }
    const std::vector<double> indices = numbers(primitive.indices, kIndices, name);
    corners.reserve(indices.size());
    for (double index : indices) {
      if (index >= vertexCount) {
        reject(name + " has vertex index " + number(static_cast<std::uint64_t>(index)) +
               ", but there are " + std::to_string(vertexCount) + " positions");
      }
      corners.push_back(static_cast<int>(index));
    }
    return corners;
  }

  /// Without its extension, what a compressed primitive has for positions is zeros.
  static void requireUncompressed(const tinygltf::Primitive& primitive,
                                  const tinygltf::Accessor& positions, const std::string& name) {
    if (positions.bufferView >= 0) return;
    for (const auto& [extension, value] : primitive.extensions) {
      if (extension.find("compression") == std::string::npos) continue;
      reject(name + " is compressed with " + extension +
             ", which has to be decompressed before it is read here");
    }
  }

  void addVertices(const std::vector<double>& positions, const Eigen::Affine3d& transform) {
    scene_.positions.reserve(scene_.positions.size() + positions.size());
    for (std::size_t i = 0; i < positions.size(); i += 3) {
      const Eigen::Vector3d p = transform * Eigen::Vector3d::Map(&positions[i]);
      scene_.positions.insert(scene_.positions.end(), p.begin(), p.end());
    }
  }

  /// Of the last `count` vertices.
  void addAttributes(const tinygltf::Primitive& primitive, std::size_t count,
                     const Eigen::Affine3d& transform, const std::string& name) {
    const std::size_t first = scene_.positions.size() / 3 - count;
    std::vector<double> normals = attribute(primitive, "NORMAL", kNormals, count, name);
    if (!normals.empty()) {
      // The cofactors of a matrix turn normals as it turns surfaces, singular or not.
      const Eigen::Matrix3d m = transform.linear();
      Eigen::Matrix3d cofactors;
      for (int i = 0; i < 3; ++i) cofactors.col(i) = m.col((i + 1) % 3).cross(m.col((i + 2) % 3));
      if (m.determinant() < 0) cofactors = -cofactors;
      for (std::size_t i = 0; i < normals.size(); i += 3) {
        auto normal = Eigen::Vector3d::Map(&normals[i]);
        normal = (cofactors * normal).stableNormalized();
        if (!normal.allFinite()) normal.setZero();
      }
      hasNormals_ = true;
      scene_.normals.resize(3 * first);
      scene_.normals.insert(scene_.normals.end(), normals.begin(), normals.end());
    }
    std::vector<double> uvs = attribute(primitive, "TEXCOORD_0", kUvs, count, name);
    if (!uvs.empty()) {
      for (double& x : uvs)
        if (!std::isfinite(x)) x = 0;
      hasUvs_ = true;
      scene_.uvs.resize(2 * first);
      scene_.uvs.insert(scene_.uvs.end(), uvs.begin(), uvs.end());
    }
  }

  /// Empty if the primitive has none that fits. A surface needs none: a bad one is passed over.
  std::vector<double> attribute(const tinygltf::Primitive& primitive, const char* semantic,
                                const Format& format, std::size_t count, const std::string& name) {
    const auto found = primitive.attributes.find(semantic);
    if (found == primitive.attributes.end()) return {};
    try {
      std::vector<double> values = numbers(found->second, format, name);
      if (values.size() == count * format.components) return values;
    } catch (const Error&) {
    }
    ++badAttributes_;
    return {};
  }

  int triangleCount() const { return static_cast<int>(scene_.triangles.size() / 3); }

  // Accessors

  /// All numbers of an accessor, element by element: those of its buffer view, or zeros, then the
  /// sparse ones in their places.
  std::vector<double> numbers(int index, const Format& format, const std::string& owner) {
    requireIndex(index, model_.accessors.size(), "accessor", owner);
    const tinygltf::Accessor& accessor = model_.accessors[index];
    const std::string name = "accessor " + std::to_string(index);
    if (accessor.type != format.type) reject(name + " has the wrong type for " + format.what);
    const ComponentType& type = componentType(accessor.componentType, format, name);
    if (accessor.count > 3 * kMaxElements) {
      reject(name + " has " + number(accessor.count) + " elements, which is too many");
    }

    const bool normalized = accessor.normalized && type.largest > 0;
    const std::uint64_t size = format.components * type.size;
    std::vector<double> values;
    const auto store = [&](std::uint64_t element, const std::byte* bytes) {
      for (std::uint64_t c = 0; c < format.components; ++c) {
        const double value = type.load(bytes + c * type.size);
        // The least of the signed integers stands for -1 as the next one does.
        values[element * format.components + c] =
            normalized ? std::max(value / type.largest, -1.0) : value;
      }
    };
    if (accessor.bufferView != -1) {
      const Elements source =
          elements(accessor.bufferView, accessor.byteOffset, accessor.count, size, name);
      values.resize(accessor.count * format.components);
      for (std::uint64_t i = 0; i < accessor.count; ++i) store(i, source.at(i));
    } else {
      values.resize(accessor.count * format.components);
    }
    if (accessor.sparse.isSparse) {
      forEachSparse(accessor, size, "the sparse part of " + name, store);
    }
    return values;
  }

  template <class Store>
  void forEachSparse(const tinygltf::Accessor& accessor, std::uint64_t size,
                     const std::string& name, Store store) {
    const int count = accessor.sparse.count;
    const auto& indices = accessor.sparse.indices;
    const auto& values = accessor.sparse.values;
    if (count < 0 || indices.byteOffset < 0 || values.byteOffset < 0) {
      reject(name + " has a negative count or offset");
    }
    const ComponentType& type = componentType(indices.componentType, kIndices, name);
    const Elements places =
        elements(indices.bufferView, indices.byteOffset, count, type.size, name);
    const Elements source = elements(values.bufferView, values.byteOffset, count, size, name);
    for (int i = 0; i < count; ++i) {
      const auto place = static_cast<std::uint64_t>(type.load(places.at(i)));
      if (place >= accessor.count) {
        reject(name + " has the index " + number(place) + " past its end");
      }
      store(place, source.at(i));
    }
  }

  /// Elements in memory, each of which lies inside its buffer view.
  struct Elements {
    const std::byte* first;
    std::uint64_t stride;
    const std::byte* at(std::uint64_t i) const { return first + i * stride; }
  };

  /// `count` elements of `size` bytes from `offset` on in a buffer view; `owner` names them.
  Elements elements(int viewIndex, std::uint64_t offset, std::uint64_t count, std::uint64_t size,
                    const std::string& owner) {
    requireIndex(viewIndex, model_.bufferViews.size(), "buffer view", owner);
    const tinygltf::BufferView& view = model_.bufferViews[viewIndex];
    const std::string name = "buffer view " + std::to_string(viewIndex);
    const Bytes buffer = buffers_.at(view.buffer, name);
    if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset) {
      reject(name + " reaches past the end of buffer " + std::to_string(view.buffer));
    }
    const std::uint64_t stride = view.byteStride == 0 ? size : view.byteStride;
    if (stride < size) reject(name + " has a byteStride less than the elements of " + owner);
    // The sum offset + stride·(count - 1) + size could overflow; these differences cannot.
    const std::uint64_t length = view.byteLength;
    const bool fits = count == 0 || (offset <= length && size <= length - offset &&
                                     count - 1 <= (length - offset - size) / stride);
    if (!fits) reject(owner + " reaches past the end of " + name);
    return {buffer.data() + view.byteOffset + offset, stride};
  }

  void note(int count, const std::string& text) {
    if (count > 0) scene_.notes.push_back(text + " (" + std::to_string(count) + ")");
  }

  const tinygltf::Model& model_;
  Buffers buffers_;
  GltfScene scene_;
  int linePrimitives_ = 0, emptyPrimitives_ = 0, skins_ = 0, morphs_ = 0, instances_ = 0;
  int badAttributes_ = 0;
  bool hasNormals_ = false, hasUvs_ = false;
};

}  // namespace

GltfScene readGltf(std::span<const std::byte> bytes, std::span<const GltfResource> resources) {
  const Container container = openContainer(bytes);
  json document = trimmed(parseJson(container.json));
  requireVersion2(document);
  requireKnownExtensions(document);
  Buffers buffers(document, container.bin, resources);
  const tinygltf::Model model = parseModel(document);
  return SceneReader(model, std::move(buffers)).read();
}

}  // namespace gvd
