// SPDX-License-Identifier: MIT
#include "gltf/document.h"

#include <utility>

#include "gltf/gltf_error.h"

namespace gvd::gltf {
namespace {

using nlohmann::json;

/// A member of an object, null if there is none. Of `nullptr`, too.
const json* find(const json* object, const char* name) {
  if (!object) return nullptr;
  const auto member = object->find(name);
  return member == object->end() ? nullptr : &*member;
}

/// Keeps what there is already where the member is absent. The rules have seen to its type.
template <class Value>
void read(const json* object, const char* name, Value& value) {
  if (const json* member = find(object, name)) member->get_to(value);
}

void read(const json* object, const char* name, std::optional<int>& value) {
  if (const json* member = find(object, name)) value = member->get<int>();
}

const json& require(const json& object, const char* name, const std::string& owner) {
  const json* member = find(&object, name);
  if (!member) reject(owner + " has no " + name);
  return *member;
}

/// The objects of a list, each with what errors call it: "accessor 3".
template <class Object, class Convert>
std::vector<Object> readList(const json* owner, const char* name, const std::string& kind,
                             const std::string& suffix, Convert convert) {
  std::vector<Object> objects;
  const json* list = find(owner, name);
  if (!list) return objects;
  for (const json& object : *list) {
    objects.push_back(convert(object, kind + ' ' + number(objects.size()) + suffix));
  }
  return objects;
}

BufferView toBufferView(const json& from, const std::string& name) {
  BufferView to;
  require(from, "buffer", name).get_to(to.buffer);
  require(from, "byteLength", name).get_to(to.byteLength);
  read(&from, "byteOffset", to.byteOffset);
  read(&from, "byteStride", to.byteStride);
  return to;
}

ElementType toElementType(const std::string& type, const std::string& name) {
  if (type == "SCALAR") return ElementType::kScalar;
  if (type == "VEC2") return ElementType::kVec2;
  if (type == "VEC3") return ElementType::kVec3;
  if (type == "VEC4") return ElementType::kVec4;
  if (type.starts_with("MAT")) return ElementType::kMatrix;
  reject(name + " has the unknown type \"" + type.substr(0, 40) + '"');
}

/// One of the two ranges of a sparse accessor.
ElementRange toRange(const json& from, int componentType, const std::string& name) {
  ElementRange to;
  to.componentType = componentType;
  require(from, "bufferView", name).get_to(to.bufferView);
  read(&from, "byteOffset", to.byteOffset);
  return to;
}

Accessor toAccessor(const json& from, const std::string& name) {
  Accessor to;
  require(from, "componentType", name).get_to(to.componentType);
  require(from, "count", name).get_to(to.count);
  to.type = toElementType(require(from, "type", name).get_ref<const std::string&>(), name);
  read(&from, "normalized", to.normalized);
  if (const json* view = find(&from, "bufferView")) {
    to.elements = {view->get<int>(), 0, to.componentType};
    read(&from, "byteOffset", to.elements->byteOffset);
  }
  if (const json* sparse = find(&from, "sparse")) {
    const std::string part = "the sparse part of " + name;
    const json& indices = require(*sparse, "indices", part);
    const json& values = require(*sparse, "values", part);
    to.sparse = {require(*sparse, "count", part).get<std::uint64_t>(),
                 toRange(indices, require(indices, "componentType", part).get<int>(), part),
                 toRange(values, to.componentType, part)};
  }
  return to;
}

Primitive toPrimitive(const json& from, const std::string& name) {
  Primitive to;
  require(from, "attributes", name).get_to(to.attributes);
  read(&from, "mode", to.mode);
  read(&from, "indices", to.indices);
  read(&from, "targets", to.targets);
  // The rules let no other extension through than one that compresses.
  const json* extensions = find(&from, "extensions");
  if (extensions && !extensions->empty()) to.compression = extensions->begin().key();
  return to;
}

/// Every part of a scene has a copy of its name.
std::string shortened(std::string name) {
  constexpr std::size_t kMost = 256;
  if (name.size() <= kMost) return name;
  std::size_t end = kMost;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;  // UTF-8
  return name.substr(0, end);
}

Mesh toMesh(const json& from, const std::string& name) {
  Mesh to;
  read(&from, "name", to.name);
  to.name = shortened(std::move(to.name));
  read(&from, "weights", to.weights);
  to.primitives = readList<Primitive>(&from, "primitives", "primitive", " of " + name, toPrimitive);
  return to;
}

Node toNode(const json& from, const std::string&) {
  Node to;
  read(&from, "name", to.name);
  to.name = shortened(std::move(to.name));
  read(&from, "children", to.children);
  read(&from, "mesh", to.mesh);
  to.isSkinned = find(&from, "skin") != nullptr;
  read(&from, "weights", to.weights);
  read(find(find(&from, "extensions"), "EXT_mesh_gpu_instancing"), "attributes", to.instances);
  read(&from, "matrix", to.matrix);
  read(&from, "translation", to.translation);
  read(&from, "rotation", to.rotation);
  read(&from, "scale", to.scale);
  return to;
}

std::vector<int> toScene(const json& from, const std::string&) {
  std::vector<int> nodes;
  read(&from, "nodes", nodes);
  return nodes;
}

}  // namespace

Document toDocument(const json& from) {
  Document to;
  to.bufferViews = readList<BufferView>(&from, "bufferViews", "buffer view", "", toBufferView);
  to.accessors = readList<Accessor>(&from, "accessors", "accessor", "", toAccessor);
  to.meshes = readList<Mesh>(&from, "meshes", "mesh", "", toMesh);
  to.nodes = readList<Node>(&from, "nodes", "node", "", toNode);
  to.scenes = readList<std::vector<int>>(&from, "scenes", "scene", "", toScene);
  read(&from, "scene", to.defaultScene);
  return to;
}

void requireIndex(int index, std::size_t count, const std::string& what, const std::string& owner) {
  if (index >= 0 && static_cast<std::size_t>(index) < count) return;
  reject(owner + " names " + what + " " + std::to_string(index) + ", but the glTF has " +
         number(count));
}

}  // namespace gvd::gltf
