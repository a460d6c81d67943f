// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "gvd/error.h"

namespace gvd::gltf {

[[noreturn]] inline void reject(const std::string& why) {
  throw Error(ErrorCode::kInvalidGltf, why);
}

inline std::string number(std::uint64_t n) { return std::to_string(n); }

}  // namespace gvd::gltf
