// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/sliced_loop.h"
#include "gltf/accessor_reader.h"
#include "gltf/document.h"
#include "gvd/gltf.h"

namespace gvd::gltf {

enum class PrimitiveKind { kTriangles, kPointsOrLines, kWithoutPositions };

/// Refuses modes that do not exist.
PrimitiveKind kindOf(const Primitive& primitive, const std::string& name);

/// The cost of reading a primitive of triangles, according to its accessors.
struct PrimitiveSize {
  std::uint64_t vertices = 0;      ///< and as many for each morph target applied
  std::uint64_t countedAgain = 0;  ///< of these, those for morph targets
  std::uint64_t triangles = 0;
  std::uint64_t zeroElements = 0;  ///< in accessors without a buffer view
};

/// Refuses a compressed primitive without uncompressed positions, which would be read as zeros.
PrimitiveSize sizeOf(const Primitive& primitive, std::span<const double> weights,
                     const AccessorReader& accessors, const std::string& name);

/// Appends the values of an attribute, with its morph targets applied, to a list, in slices.
class AttributeReading {
 public:
  /// Refuses accessors whose count is not `vertexCount`. Cannot be copied, because the layers point
  /// into it.
  AttributeReading(const Primitive& primitive, const char* semantic, const Format& format,
                   std::span<const double> weights, std::uint64_t vertexCount,
                   AccessorReader& accessors, const std::string& name, std::vector<double>& to);
  AttributeReading(const AttributeReading&) = delete;
  AttributeReading& operator=(const AttributeReading&) = delete;

  bool step(long& budget);

 private:
  /// The attribute's own values, or a morph target's.
  struct Layer {
    AccessorReading reading;
    double weight;
  };

  std::vector<double>& to_;
  const std::size_t first_;  ///< index of the first value in the list
  std::vector<Layer> layers_;
  std::size_t next_ = 0;               ///< in `layers_`
  std::vector<double> displacements_;  ///< of the current morph target
  SlicedLoop loop_;
};

/// Adds a primitive of triangles to a scene, in slices: its vertices, triangles and readable
/// attributes. If earlier vertices lack an attribute, it is padded with zeros, the density with 1.
class PrimitiveReading {
 public:
  /// `weights` are of the morph targets. All but `transform` must outlive this.
  PrimitiveReading(const Primitive& primitive, std::span<const double> weights,
                   const Eigen::Affine3d& transform, AccessorReader& accessors,
                   const std::string& name, GltfScene& scene);

  bool step(long& budget);
  /// The number of attributes that cannot be read.
  int badAttributes() const { return badAttributes_; }

 private:
  template <class Visit>
  bool forVertices(SlicedLoop& loop, long& budget, Visit visit);
  bool readOptional(const char* semantic, const Format& format, std::span<const double> weights,
                    std::vector<double>& values, double padding, long& budget);
  void requireVertex(double index) const;
  void addTriangle(std::uint64_t t);
  void turnNormal(std::size_t vertex);

  const Primitive& primitive_;
  const std::span<const double> weights_;
  const Eigen::Affine3d transform_;
  AccessorReader& accessors_;
  const std::string& name_;
  GltfScene& scene_;
  const std::size_t firstVertex_, vertexCount_;
  Eigen::Matrix3d cofactors_;  ///< of the transform, for normals
  bool isMirrored_;            ///< whether the transform mirrors
  int badAttributes_ = 0;
  std::optional<AttributeReading> attribute_;  ///< the current one
  std::size_t sizeBefore_ = 0;                 ///< of the list it is read to
  bool isRead_ = false;                        ///< whether the primitive has it, readable
  std::optional<AccessorReading> indexReading_;
  std::vector<double> indices_;  ///< empty if the primitive has none
  SlicedSequence sequence_;
};

}  // namespace gvd::gltf
