// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"
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

/// Reads the values of an attribute, with its morph targets applied, in slices.
class AttributeReading {
 public:
  /// Accessors whose count is not that of the vertices are refused.
  AttributeReading(const Primitive& primitive, const char* semantic, const Format& format,
                   std::span<const double> weights, std::uint64_t vertexCount,
                   AccessorReader& accessors, const std::string& name);

  bool step(long& budget);
  std::vector<double> take() { return std::move(values_); }

 private:
  /// The attribute's own values, or a morph target's.
  struct Layer {
    AccessorReading reading;
    double weight;
  };

  std::vector<Layer> layers_;
  std::size_t next_ = 0;  ///< of these
  std::vector<double> values_;
  SlicedLoop loop_;
};

/// Reads a primitive of triangles in slices.
class PrimitiveReading {
 public:
  /// `weights` are those of its morph targets. All of these must outlive this.
  PrimitiveReading(const Primitive& primitive, std::span<const double> weights,
                   AccessorReader& accessors, const std::string& name);

  bool step(long& budget);
  PrimitiveTriangles take() { return std::move(read_); }

 private:
  bool readOptional(const char* semantic, const Format& format, std::span<const double> weights,
                    std::vector<double>& values, long& budget);
  void requireVertex(double index) const;
  void addTriangle(std::uint64_t t);

  const Primitive& primitive_;
  const std::span<const double> weights_;
  AccessorReader& accessors_;
  const std::string& name_;
  const std::uint64_t vertexCount_;
  PrimitiveTriangles read_;
  std::optional<AttributeReading> attribute_;  ///< the one that is read
  std::optional<AccessorReading> indexReading_;
  std::vector<double> indices_;  ///< if it has any
  SlicedSequence sequence_;
  SlicedLoop loop_;
};

}  // namespace gvd::gltf
