// SPDX-License-Identifier: MIT
#pragma once

namespace gvd {

/// The sum of the genera of all components of a surface.
inline int genusOf(int components, int boundaryLoops, int eulerCharacteristic) {
  return (2 * components - boundaryLoops - eulerCharacteristic) / 2;
}

}  // namespace gvd
