// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/gltf.h"

namespace gvd::gltf {

struct BufferObject {
  std::optional<std::string> uri;
  std::optional<std::uint64_t> byteLength;
  std::string compression;  ///< the extension whose fallback it is, else empty
};

/// The JSON of a glTF, reduced to what triangles need.
struct GltfJson {
  nlohmann::json document;
  std::vector<BufferObject> buffers;
};

/// Refuses other versions than 2.0, required extensions that are not known, and values that break
/// a rule of json_rules.h.
GltfJson readJson(std::string_view text, const GltfLimits& limits);

}  // namespace gvd::gltf
