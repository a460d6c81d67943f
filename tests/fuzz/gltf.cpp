// SPDX-License-Identifier: MIT
//
// glTF bytes: read, or refused by an `Error`.
#include "gvd/gltf.h"

#include "gvd/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Less than by default, so that what is slow or large is so by a fault.
  const gvd::GltfLimits limits{.maxVertices = 1 << 16, .maxTriangles = 1 << 16};
  try {
    gvd::readGltf(std::as_bytes(std::span(data, size)), {}, limits);
  } catch (const gvd::Error&) {
  }
  return 0;
}
