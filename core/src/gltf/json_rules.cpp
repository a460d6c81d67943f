// SPDX-License-Identifier: MIT
#include "gltf/json_rules.h"

#include <unordered_map>

#include "gltf/gltf_error.h"

namespace gvd::gltf {
namespace {

using enum JsonKind;

/// Indices are stored as `int`.
constexpr std::uint64_t kMostIndex = INT32_MAX;
/// For offsets and counts: larger ones would be truncated if `size_t` has 32 bits, as in
/// WebAssembly.
constexpr std::uint64_t kMostBytes = UINT32_MAX;

constexpr JsonRule required(JsonRule rule) {
  rule.isRequired = true;
  return rule;
}

/// The numbers that glTF gives component types.
constexpr std::uint64_t kLeastType = 5120, kMostType = 5126;

constexpr JsonRule kRules[] = {
    {"", kObject},
    {"asset", kObject},
    {"asset.version", kText},
    {"asset.minVersion", kText},
    {"extensionsRequired", kArray},
    {"extensionsRequired[]", kText},
    {"scene", kWholeNumber, 0, kMostIndex},
    {"scenes", kArray},
    {"scenes[]", kObject},
    {"scenes[].nodes", kArray},
    {"scenes[].nodes[]", kWholeNumber, 0, kMostIndex},

    {"nodes", kArray},
    {"nodes[]", kObject},
    {"nodes[].name", kText},
    {"nodes[].mesh", kWholeNumber, 0, kMostIndex},
    {"nodes[].skin", kWholeNumber, 0, kMostIndex},
    {"nodes[].children", kArray},
    {"nodes[].children[]", kWholeNumber, 0, kMostIndex},
    {"nodes[].matrix", kArray, 16, 16},
    {"nodes[].matrix[]", kNumber},
    {"nodes[].translation", kArray, 3, 3},
    {"nodes[].translation[]", kNumber},
    {"nodes[].rotation", kArray, 4, 4},
    {"nodes[].rotation[]", kNumber},
    {"nodes[].scale", kArray, 3, 3},
    {"nodes[].scale[]", kNumber},
    {"nodes[].weights", kArray},
    {"nodes[].weights[]", kNumber},
    {"nodes[].extensions", kObject},
    {"nodes[].extensions.EXT_mesh_gpu_instancing", kObject},
    {"nodes[].extensions.EXT_mesh_gpu_instancing.attributes", kObject},
    {"nodes[].extensions.EXT_mesh_gpu_instancing.attributes.TRANSLATION", kWholeNumber, 0,
     kMostIndex},
    {"nodes[].extensions.EXT_mesh_gpu_instancing.attributes.ROTATION", kWholeNumber, 0, kMostIndex},
    {"nodes[].extensions.EXT_mesh_gpu_instancing.attributes.SCALE", kWholeNumber, 0, kMostIndex},

    {"meshes", kArray},
    {"meshes[]", kObject},
    {"meshes[].name", kText},
    {"meshes[].weights", kArray},
    {"meshes[].weights[]", kNumber},
    required({"meshes[].primitives", kArray}),
    {"meshes[].primitives[]", kObject},
    {"meshes[].primitives[].mode", kWholeNumber, 0, kMostIndex},
    {"meshes[].primitives[].indices", kWholeNumber, 0, kMostIndex},
    required({"meshes[].primitives[].attributes", kObject}),
    {"meshes[].primitives[].attributes.POSITION", kWholeNumber, 0, kMostIndex},
    {"meshes[].primitives[].attributes.NORMAL", kWholeNumber, 0, kMostIndex},
    {"meshes[].primitives[].attributes.TEXCOORD_0", kWholeNumber, 0, kMostIndex},
    {"meshes[].primitives[].attributes._DENSITY", kWholeNumber, 0, kMostIndex},
    {"meshes[].primitives[].targets", kArray},
    {"meshes[].primitives[].targets[]", kObject},
    {"meshes[].primitives[].targets[].POSITION", kWholeNumber, 0, kMostIndex},
    {"meshes[].primitives[].targets[].NORMAL", kWholeNumber, 0, kMostIndex},
    {"meshes[].primitives[].extensions", kObject},
    {"meshes[].primitives[].extensions.KHR_draco_mesh_compression", kObject},

    {"accessors", kArray},
    {"accessors[]", kObject},
    {"accessors[].bufferView", kWholeNumber, 0, kMostIndex},
    {"accessors[].byteOffset", kWholeNumber, 0, kMostBytes},
    required({"accessors[].componentType", kWholeNumber, kLeastType, kMostType}),
    required({"accessors[].count", kWholeNumber, 0, kMostBytes}),
    required({"accessors[].type", kText, 0, UINT64_MAX, 1, false,
              "SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4"}),
    {"accessors[].normalized", kBoolean},
    {"accessors[].sparse", kObject},
    required({"accessors[].sparse.count", kWholeNumber, 0, kMostBytes}),
    required({"accessors[].sparse.indices", kObject}),
    required({"accessors[].sparse.indices.bufferView", kWholeNumber, 0, kMostIndex}),
    {"accessors[].sparse.indices.byteOffset", kWholeNumber, 0, kMostBytes},
    required({"accessors[].sparse.indices.componentType", kWholeNumber, kLeastType, kMostType}),
    required({"accessors[].sparse.values", kObject}),
    required({"accessors[].sparse.values.bufferView", kWholeNumber, 0, kMostIndex}),
    {"accessors[].sparse.values.byteOffset", kWholeNumber, 0, kMostBytes},

    {"bufferViews", kArray},
    {"bufferViews[]", kObject},
    required({"bufferViews[].buffer", kWholeNumber, 0, kMostIndex}),
    {"bufferViews[].byteOffset", kWholeNumber, 0, kMostBytes},
    required({"bufferViews[].byteLength", kWholeNumber, 0, kMostBytes}),
    // Some exporters write 0 for no stride.
    {"bufferViews[].byteStride", kWholeNumber, 0, 252, 4},

    {"buffers", kArray},
    {"buffers[]", kObject},
    {"buffers[].uri", kText},
    {"buffers[].byteLength", kWholeNumber, 0, kMostBytes},
    {"buffers[].extensions", kObject},
    {"buffers[].extensions.EXT_meshopt_compression", kObject},
    {"buffers[].extensions.KHR_meshopt_compression", kObject},
};

}  // namespace

const JsonRule* findRule(std::string_view path) {
  static const auto rules = [] {
    std::unordered_map<std::string_view, const JsonRule*> byPath;
    for (const JsonRule& rule : kRules) byPath[rule.path] = &rule;
    return byPath;
  }();
  const auto found = rules.find(path);
  return found == rules.end() ? nullptr : found->second;
}

std::span<const JsonRule> jsonRules() { return kRules; }

bool isAllowed(const JsonRule& rule, std::string_view text) {
  std::string_view rest = rule.oneOf;
  while (!rest.empty()) {
    const std::size_t comma = rest.find(", ");
    if (rest.substr(0, comma) == text) return true;
    if (comma == std::string_view::npos) return false;
    rest.remove_prefix(comma + 2);
  }
  return rule.oneOf.empty();
}

std::string expectation(const JsonRule& rule) {
  switch (rule.kind) {
    case kObject:
      return "an object";
    case kArray:
      return "an array";
    case kNumber:
      return "a number";
    case kText:
      return rule.oneOf.empty() ? "a string" : "one of " + std::string(rule.oneOf);
    case kBoolean:
      return "true or false";
    case kWholeNumber:
      break;
  }
  return (rule.multipleOf == 1 ? "a whole number"
                               : "a multiple of " + std::to_string(rule.multipleOf)) +
         " from " + std::to_string(rule.least) + " to " + std::to_string(rule.most);
}

}  // namespace gvd::gltf
