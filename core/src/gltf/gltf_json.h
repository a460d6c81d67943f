// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/gltf.h"

namespace gvd::gltf {

/// The attribute in which `readJson` stores the indices of a primitive, because tinygltf refuses
/// indices without a buffer view, which are valid.
inline constexpr char kIndicesAttribute[] = "indices";

struct BufferObject {
  std::optional<std::string> uri;
  std::optional<std::uint64_t> byteLength;
  std::string compression;  ///< the extension that the buffer is a fallback for, else empty
};

/// The JSON of a glTF, reduced to what triangles need.
struct GltfJson {
  std::string text;  ///< without `buffers`: tinygltf refuses many valid ones
  std::vector<BufferObject> buffers;
};

/// Refuses versions other than 2.0, unknown required extensions, and values that break a rule of
/// json_rules.h.
GltfJson readJson(std::string_view text, const GltfLimits& limits);

}  // namespace gvd::gltf
