// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gltf/accessor_reader.h"
#include "gltf/document.h"

namespace gvd::gltf {

/// The triangles of one primitive in the space of its mesh.
struct PrimitiveTriangles {
  std::vector<double> positions;  ///< x, y, z per vertex
  /// Empty if the primitive has none that can be read.
  std::vector<double> normals, uvs, density;
  std::vector<int> triangles;  ///< three vertices of the primitive each
  int badAttributes = 0;       ///< how many of these three cannot be read
};

enum class PrimitiveKind { kTriangles, kPointsOrLines, kWithoutPositions };

/// Refuses modes that do not exist.
PrimitiveKind kindOf(const Primitive& primitive, const std::string& name);

/// What reading a primitive of triangles takes, by what its accessors say.
struct PrimitiveSize {
  std::uint64_t vertices = 0;  ///< and again for each morph target that is applied
  std::uint64_t triangles = 0;
  std::uint64_t zeroElements = 0;  ///< of accessors without a buffer view
};

/// Refuses a primitive that is compressed: without the extension its positions are zeros.
PrimitiveSize sizeOf(const Primitive& primitive, std::span<const double> weights,
                     const AccessorReader& accessors, const std::string& name);

/// Reads a primitive of triangles; `weights` are those of its morph targets.
PrimitiveTriangles readTriangles(const Primitive& primitive, std::span<const double> weights,
                                 AccessorReader& accessors, const std::string& name);

}  // namespace gvd::gltf
