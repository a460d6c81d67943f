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

/// The end of a sentence that names the extension by which data are compressed.
inline constexpr char kNotDecompressed[] =
    ", which is not decompressed here: save the model without it";

}  // namespace gvd::gltf
