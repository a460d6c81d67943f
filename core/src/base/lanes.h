// SPDX-License-Identifier: MIT
#pragma once

namespace gvd {

// Numbers side by side in one register of the processor: operators work on all of them at once,
// comparisons give masks, and `mask ? a : b` chooses for each without a branch. An extension of GCC
// and Clang.

/// Two numbers.
using Lanes = double __attribute__((vector_size(16)));

/// Four numbers of single precision.
using FloatLanes = float __attribute__((vector_size(16)));
/// What comparisons of these give: -1 where it is true, or 0.
using FloatMask = int __attribute__((vector_size(16)));

/// The same number twice.
inline Lanes both(double value) { return Lanes{value, value}; }

}  // namespace gvd
