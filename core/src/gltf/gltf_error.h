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

/// The end of a sentence that names a limit which is exceeded.
inline std::string toRaise(const char* limit) {
  return "; raise the limit " + std::string(limit) + " to read it";
}

}  // namespace gvd::gltf
