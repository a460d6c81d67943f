// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace gvd::gltf {

using Bytes = std::span<const std::byte>;

struct Container {
  std::string_view json;
  std::optional<Bytes> bin;  ///< the binary chunk of a GLB
};

/// Splits a GLB (version 2) into its chunks; any other text that may be a JSON object is returned
/// as it is, without a byte order mark.
Container openContainer(Bytes bytes);

}  // namespace gvd::gltf
