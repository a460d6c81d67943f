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

/// What reading a primitive of triangles takes, by what its accessors say.
struct PrimitiveSize {
  std::uint64_t vertices = 0;  ///< and again for each morph target that is applied
  std::uint64_t triangles = 0;
  std::uint64_t zeroElements = 0;  ///< of accessors without a buffer view
};

/// Refuses a primitive that is compressed: without the extension its positions are zeros.
PrimitiveSize sizeOf(const Primitive& primitive, std::span<const double> weights,
                     const AccessorReader& accessors, const std::string& name);

/// Reads the values of an attribute, with its morph targets applied, to the end of a list, in
/// slices.
class AttributeReading {
 public:
  /// Accessors whose count is not that of the vertices are refused. It must stay where it is.
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
  const std::size_t first_;  ///< where in the list the values begin
  std::vector<Layer> layers_;
  std::size_t next_ = 0;               ///< of these
  std::vector<double> displacements_;  ///< of the morph target at hand
  SlicedLoop loop_;
};

/// Adds a primitive of triangles to a scene, in slices: its vertices and triangles, with the
/// attributes that can be read. Vertices before it that have none get zeros, or the density 1.
class PrimitiveReading {
 public:
  /// `weights` are those of its morph targets. All but `transform` must outlive this.
  PrimitiveReading(const Primitive& primitive, std::span<const double> weights,
                   const Eigen::Affine3d& transform, AccessorReader& accessors,
                   const std::string& name, GltfScene& scene);

  bool step(long& budget);
  /// How many attributes cannot be read.
  int badAttributes() const { return badAttributes_; }

 private:
  template <class Visit>
  bool forVertices(long& budget, Visit visit);
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
  Eigen::Matrix3d cofactors_;  ///< of the transform: they turn normals
  bool isMirrored_;            ///< by the transform
  int badAttributes_ = 0;
  std::optional<AttributeReading> attribute_;  ///< the one that is read
  std::size_t sizeBefore_ = 0;                 ///< of its list
  bool isRead_ = false;                        ///< whether it has been
  std::optional<AccessorReading> indexReading_;
  std::vector<double> indices_;  ///< if it has any
  SlicedSequence sequence_;
  SlicedLoop loop_;
};

}  // namespace gvd::gltf
