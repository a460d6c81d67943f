// SPDX-License-Identifier: MIT
#include "gltf/gltf_json.h"

#include <utility>
#if __has_include(<nlohmann/json.hpp>)
#include <nlohmann/json.hpp>
#else  // beside tinygltf
#include <json.hpp>
#endif

#include "gltf/gltf_error.h"

namespace gvd::gltf {
namespace {

using nlohmann::json;

/// tinygltf descends into `extras` and `extensions` recursively; real files nest a dozen levels.
constexpr int kMaxJsonDepth = 128;

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

/// Takes the buffers out of the document.
std::vector<BufferObject> takeBuffers(json& document) {
  std::vector<BufferObject> buffers;
  const auto list = document.find("buffers");
  if (list == document.end()) return buffers;
  for (json& object : *list) {
    BufferObject& buffer = buffers.emplace_back();
    const auto uri = object.find("uri"), length = object.find("byteLength");
    if (uri != object.end() && uri->is_string())
      buffer.uri = std::move(uri->get_ref<std::string&>());
    if (length != object.end() && length->is_number_unsigned()) {
      buffer.byteLength = length->get<std::uint64_t>();
    }
  }
  document.erase(list);
  return buffers;
}

}  // namespace

GltfJson readJson(std::string_view text) {
  json document = trimmed(parseJson(text));
  requireVersion2(document);
  requireKnownExtensions(document);
  std::vector<BufferObject> buffers = takeBuffers(document);
  return {document.dump(-1, ' ', false, json::error_handler_t::replace), std::move(buffers)};
}

}  // namespace gvd::gltf
