// SPDX-License-Identifier: MIT
//
// The only file that uses tinygltf. tinygltf parses the objects of a glTF, but checks few of them
// and reads no accessor. It is given only what triangles need, because an undecodable image or a
// strange material must not keep a mesh from being read, and its results are copied into structures
// of our own.

#include "gltf/document.h"

#include <fstream>  // tinygltf needs it but does not include it with TINYGLTF_NO_FS
#include <utility>

#include "gltf/gltf_error.h"
#include "gltf/gltf_json.h"

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

namespace gvd::gltf {
namespace {

tinygltf::Model parseModel(const std::string& text) {
  tinygltf::Model model;
  tinygltf::TinyGLTF parser;
  std::string error, warning;
  constexpr unsigned int kRequireNothing = 0;
  const bool parsed =
      parser.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                 static_cast<unsigned int>(text.size()), "", kRequireNothing);
  // tinygltf leaves out faulty objects, which would shift the indices of those after them.
  if (!parsed || !error.empty())
    reject("the glTF is invalid: " + error.substr(0, error.find_last_not_of(".\n") + 1));
  return model;
}

/// tinygltf stores -1 for an absent index.
std::optional<int> optionalIndex(int index) {
  return index == -1 ? std::nullopt : std::optional(index);
}

/// The number of components of a scalar or a vector; 0 of a matrix.
std::uint64_t componentsOf(int type) {
  if (type == TINYGLTF_TYPE_SCALAR) return 1;
  return type <= TINYGLTF_TYPE_VEC4 ? type : 0;  // 2, 3, 4
}

Accessor converted(const tinygltf::Accessor& from) {
  Accessor to;
  to.components = componentsOf(from.type);
  to.componentType = from.componentType;
  to.normalized = from.normalized;
  to.count = from.count;
  if (from.bufferView != -1) to.elements = {from.bufferView, from.byteOffset};
  if (!from.sparse.isSparse) return to;
  const auto& sparse = from.sparse;
  // tinygltf stores these as int, which wraps from 2^31 on.
  const auto offset = [](int x) { return static_cast<std::uint32_t>(x); };
  to.sparse = {offset(sparse.count),
               sparse.indices.componentType,
               {sparse.indices.bufferView, offset(sparse.indices.byteOffset)},
               {sparse.values.bufferView, offset(sparse.values.byteOffset)}};
  return to;
}

Primitive converted(tinygltf::Primitive& from) {
  Primitive to;
  to.mode = from.mode;
  to.attributes = std::move(from.attributes);
  if (const auto indices = to.attributes.find(kIndicesAttribute); indices != to.attributes.end()) {
    to.indices = indices->second;
    to.attributes.erase(indices);
  }
  to.targets = std::move(from.targets);
  for (const auto& [extension, value] : from.extensions)
    if (extension.find("compression") != std::string::npos) to.compression = extension;
  return to;
}

/// Shortens a name, because every part of a scene has a copy of it.
std::string shortened(std::string name) {
  constexpr std::size_t kMost = 256;
  if (name.size() <= kMost) return name;
  std::size_t end = kMost;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;  // UTF-8
  return name.substr(0, end);
}

Mesh converted(tinygltf::Mesh& from) {
  Mesh to;
  to.name = shortened(std::move(from.name));
  to.weights = std::move(from.weights);
  for (tinygltf::Primitive& primitive : from.primitives)
    to.primitives.push_back(converted(primitive));
  return to;
}

Node converted(tinygltf::Node& from) {
  Node to;
  to.name = shortened(std::move(from.name));
  to.children = std::move(from.children);
  to.mesh = optionalIndex(from.mesh);
  to.isSkinned = from.skin >= 0;
  to.weights = std::move(from.weights);
  const auto instancing = from.extensions.find("EXT_mesh_gpu_instancing");
  if (instancing != from.extensions.end() && instancing->second.Has("attributes")) {
    const tinygltf::Value& attributes = instancing->second.Get("attributes");
    for (const std::string& semantic : attributes.Keys())
      to.instances[semantic] = attributes.Get(semantic).GetNumberAsInt();
  }
  to.matrix = std::move(from.matrix);
  to.translation = std::move(from.translation);
  to.rotation = std::move(from.rotation);
  to.scale = std::move(from.scale);
  return to;
}

}  // namespace

Document parseDocument(const std::string& text) {
  tinygltf::Model model = parseModel(text);
  Document document;
  for (const tinygltf::BufferView& view : model.bufferViews)
    document.bufferViews.push_back(
        {view.buffer, view.byteOffset, view.byteLength, view.byteStride});
  for (const tinygltf::Accessor& accessor : model.accessors)
    document.accessors.push_back(converted(accessor));
  for (tinygltf::Mesh& mesh : model.meshes) document.meshes.push_back(converted(mesh));
  for (tinygltf::Node& node : model.nodes) document.nodes.push_back(converted(node));
  for (tinygltf::Scene& scene : model.scenes) document.scenes.push_back(std::move(scene.nodes));
  document.defaultScene = optionalIndex(model.defaultScene);
  return document;
}

void requireIndex(int index, std::size_t count, const std::string& what, const std::string& owner) {
  if (index >= 0 && static_cast<std::size_t>(index) < count) return;
  reject(owner + " names " + what + " " + std::to_string(index) + ", but the glTF has " +
         std::to_string(count));
}

}  // namespace gvd::gltf
