// SPDX-License-Identifier: MIT
#pragma once

namespace gvd {

/// Throws unless so many sites may be added by `repair` or `remesh`.
void requireMaxAdded(int count);

}  // namespace gvd
