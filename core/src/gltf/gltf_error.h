// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "gvd/error.h"

namespace gvd::gltf {

[[noreturn]] inline void reject(const std::string& why) {
  throw Error(ErrorCode::kInvalidGltf, why);
}

/// The end of a sentence that names an exceeded limit.
inline std::string toRaise(const char* limit) {
  return "; raise the limit " + std::string(limit) + " to read it";
}

/// Advice on compressed files: only the JavaScript library decompresses, before it hands a file to
/// this reader.
inline constexpr char kDecompressFirst[] =
    ", which is not decompressed here: save the model without it, or open it with the JavaScript "
    "library or the command geodesic-voronoi";

}  // namespace gvd::gltf
