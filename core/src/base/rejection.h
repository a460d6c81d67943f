// SPDX-License-Identifier: MIT
//
// The errors that many functions throw. Not inlined, as the WebAssembly module would be larger.
#pragma once

#include <string>

#include "gvd/error.h"

namespace gvd {

[[noreturn, gnu::noinline]] inline void rejectArgument(const std::string& why) {
  throw Error(ErrorCode::kInvalidArgument, why);
}

[[noreturn, gnu::noinline]] inline void rejectMesh(const std::string& why) {
  throw Error(ErrorCode::kInvalidMesh, why);
}

[[noreturn, gnu::noinline]] inline void rejectPoint(const std::string& why) {
  throw Error(ErrorCode::kInvalidPoint, why);
}

}  // namespace gvd
