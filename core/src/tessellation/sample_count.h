// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "gvd/error.h"

namespace gvd {

/// Throws if a number of points to be sampled is negative.
inline void requireCount(int count) {
  if (count < 0)
    throw Error(ErrorCode::kInvalidArgument,
                "there cannot be " + std::to_string(count) + " sample points");
}

}  // namespace gvd
