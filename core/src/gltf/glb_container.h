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

/// Takes a GLB (version 2) apart; anything else that can be a JSON object is taken as it is.
Container openContainer(Bytes bytes);

}  // namespace gvd::gltf
