// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "gltf/accessor_reader.h"
#include "gltf/document.h"

namespace gvd::gltf {

/// The triangles of one primitive in the space of its mesh.
struct PrimitiveTriangles {
  std::vector<double> positions;     ///< x, y, z per vertex
  std::vector<double> normals, uvs;  ///< empty if the primitive has none that can be read
  std::vector<int> triangles;        ///< three vertices of the primitive each
  int badAttributes = 0;             ///< normals or texture coordinates that cannot be read
};

/// Whether the mode of a primitive makes triangles; refuses modes that do not exist.
bool makesTriangles(const Primitive& primitive, const std::string& name);

/// A primitive with positions that makes triangles.
PrimitiveTriangles readTriangles(const Primitive& primitive, AccessorReader& accessors,
                                 const std::string& name);

/// Without the extension that decompresses them, a compressed primitive's positions are zeros.
void requireUncompressed(const Primitive& primitive, const Accessor& positions,
                         const std::string& name);

}  // namespace gvd::gltf
