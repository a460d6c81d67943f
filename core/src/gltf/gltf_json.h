// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gvd::gltf {

struct BufferObject {
  std::optional<std::string> uri;
  std::optional<std::uint64_t> byteLength;
};

/// The JSON of a glTF, reduced to what triangles need.
struct GltfJson {
  std::string text;  ///< without `buffers`: tinygltf refuses many valid ones
  std::vector<BufferObject> buffers;
};

/// Refuses other versions than 2.0 and required extensions that are not known.
GltfJson readJson(std::string_view text);

}  // namespace gvd::gltf
