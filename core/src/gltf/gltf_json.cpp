// SPDX-License-Identifier: MIT
#include "gltf/gltf_json.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "gltf/gltf_error.h"
#include "gltf/json_filter.h"

namespace gvd::gltf {
namespace {

using nlohmann::json;

void requireVersion2(const json& document) {
  const json asset = document.is_object() ? document.value("asset", json()) : json();
  const json version = asset.is_object() ? asset.value("version", json()) : json();
  if (!version.is_string()) reject("the JSON has no asset.version, so it is not a glTF");
  const json minVersion = asset.value("minVersion", json("2.0"));
  if (!version.get<std::string>().starts_with("2.") || minVersion != "2.0") {
    const json& needed = minVersion == "2.0" ? version : minVersion;
    reject("this is glTF version " + needed.dump() + "; only version 2.0 is read");
  }
}

/// Whether triangles can be read: the extension is implemented here, or does not affect them.
bool isReadable(const std::string& extension) {
  for (const char* prefix :
       {"KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "KHR_materials_", "KHR_texture_",
        "EXT_texture_", "MSFT_texture_", "KHR_lights_", "EXT_lights_", "KHR_animation_", "KHR_xmp"})
    if (extension.starts_with(prefix)) return true;
  return false;
}

void requireKnownExtensions(const json& document) {
  const auto list = document.find("extensionsRequired");
  if (list == document.end()) return;
  for (const json& entry : *list) {
    const auto& extension = entry.get_ref<const std::string&>();
    if (isReadable(extension)) continue;
    const bool isCompression = extension.ends_with("_compression");
    reject("the glTF requires the extension " + extension +
           (isCompression ? kNotDecompressed : ", which is not supported"));
  }
}

/// Moves the buffers out of the document.
std::vector<BufferObject> takeBuffers(json& document) {
  std::vector<BufferObject> buffers;
  const auto list = document.find("buffers");
  if (list == document.end()) return buffers;
  for (json& object : *list) {
    BufferObject& buffer = buffers.emplace_back();
    const auto uri = object.find("uri"), length = object.find("byteLength");
    if (uri != object.end()) buffer.uri = std::move(uri->get_ref<std::string&>());
    if (length != object.end()) buffer.byteLength = length->get<std::uint64_t>();
    const auto extensions = object.find("extensions");
    if (extensions != object.end() && !extensions->empty())
      buffer.compression = extensions->begin().key();
  }
  document.erase(list);
  return buffers;
}

void moveIndicesToAttributes(json& document) {
  const auto meshes = document.find("meshes");
  if (meshes == document.end()) return;
  for (json& mesh : *meshes) {
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end()) continue;
    for (json& primitive : *primitives) {
      const auto indices = primitive.find("indices"), attributes = primitive.find("attributes");
      if (indices == primitive.end() || attributes == primitive.end()) continue;
      (*attributes)[kIndicesAttribute] = std::move(*indices);
      primitive.erase(indices);
    }
  }
}

}  // namespace

GltfJson readJson(std::string_view text, const GltfLimits& limits) {
  auto [document, fault] = filterJson(text, limits);
  // Checked before the fault, because a file of another version, or with an unknown required
  // extension, may well break the rules.
  requireVersion2(document);
  requireKnownExtensions(document);
  if (!fault.empty()) reject(fault);
  std::vector<BufferObject> buffers = takeBuffers(document);
  moveIndicesToAttributes(document);
  return {document.dump(-1, ' ', false, json::error_handler_t::replace), std::move(buffers)};
}

}  // namespace gvd::gltf
