// SPDX-License-Identifier: MIT
#include "gltf/primitive_triangles.h"

#include <algorithm>
#include <numeric>

#include "gltf/gltf_error.h"

namespace gvd::gltf {
namespace {

std::uint64_t triangleCount(int mode, std::uint64_t corners) {
  if (mode == kTriangleList) return corners / 3;
  return corners < 3 ? 0 : corners - 2;
}

/// Calls emit(i, j, k) for every triangle that a primitive of `corners` makes; corners too few for
/// a last triangle make none.
template <class Emit>
void forEachTriangle(int mode, std::uint64_t corners, Emit emit) {
  const std::uint64_t count = triangleCount(mode, corners);
  for (std::uint64_t t = 0; t < count; ++t) {
    if (mode == kTriangleList) emit(3 * t, 3 * t + 1, 3 * t + 2);
    // Every other triangle would come out turned over.
    if (mode == kTriangleStrip) emit(t, t + 1 + t % 2, t + 2 - t % 2);
    if (mode == kTriangleFan) emit(t + 1, t + 2, 0);
  }
}

/// The vertex at each corner of a primitive: as its indices say, else one after the other.
std::vector<int> cornerVertices(const Primitive& primitive, std::size_t vertexCount,
                                AccessorReader& accessors, const std::string& name) {
  std::vector<int> corners;
  if (!primitive.indices) {
    corners.resize(vertexCount);
    std::iota(corners.begin(), corners.end(), 0);
    return corners;
  }
  const std::vector<double> indices = accessors.read(*primitive.indices, kIndices, name);
  corners.reserve(indices.size());
  for (double index : indices) {
    if (index >= vertexCount) {
      reject(name + " has vertex index " + number(static_cast<std::uint64_t>(index)) +
             ", but there are " + number(vertexCount) + " positions");
    }
    corners.push_back(static_cast<int>(index));
  }
  return corners;
}

/// Calls use(accessor, weight) for the morph targets of an attribute whose weight is not 0.
template <class Use>
void forEachActiveTarget(const Primitive& primitive, std::span<const double> weights,
                         const char* semantic, Use use) {
  for (std::size_t t = 0; t < std::min(primitive.targets.size(), weights.size()); ++t) {
    const auto target = primitive.targets[t].find(semantic);
    if (weights[t] != 0 && target != primitive.targets[t].end()) use(target->second, weights[t]);
  }
}

/// The values of an attribute with its morph targets applied; refuses any whose count is not that
/// of the vertices.
std::vector<double> morphed(const Primitive& primitive, const char* semantic, const Format& format,
                            std::span<const double> weights, std::uint64_t vertexCount,
                            AccessorReader& accessors, const std::string& name) {
  const auto read = [&](int accessor, const Format& as) {
    if (const std::uint64_t count = accessors.at(accessor, name).count; count != vertexCount) {
      reject(name + " has " + number(count) + " elements of " + as.what + ", but there are " +
             number(vertexCount) + " positions");
    }
    return accessors.read(accessor, as, name);
  };
  std::vector<double> values = read(primitive.attributes.at(semantic), format);
  forEachActiveTarget(primitive, weights, semantic, [&](int accessor, double weight) {
    const std::vector<double> displacements = read(accessor, kDisplacements);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += weight * displacements[i];
  });
  return values;
}

}  // namespace

PrimitiveKind kindOf(const Primitive& primitive, const std::string& name) {
  if (primitive.mode < kPoints || primitive.mode > kTriangleFan) {
    reject(name + " has the unknown mode " + std::to_string(primitive.mode));
  }
  if (primitive.mode < kTriangleList) return PrimitiveKind::kPointsOrLines;
  return primitive.attributes.contains("POSITION") ? PrimitiveKind::kTriangles
                                                   : PrimitiveKind::kWithoutPositions;
}

PrimitiveSize sizeOf(const Primitive& primitive, std::span<const double> weights,
                     const AccessorReader& accessors, const std::string& name) {
  PrimitiveSize size;
  const auto countZeros = [&](const Accessor& accessor) {
    if (!accessor.elements) size.zeroElements += accessor.count;
  };
  const Accessor& positions = accessors.at(primitive.attributes.at("POSITION"), name);
  if (!positions.elements && !primitive.compression.empty()) {
    reject(name + " is compressed with " + primitive.compression + kDecompressFirst);
  }
  countZeros(positions);
  size.vertices = positions.count;
  size.triangles = triangleCount(primitive.mode, positions.count);
  if (primitive.indices) {
    const Accessor& indices = accessors.at(*primitive.indices, name);
    countZeros(indices);
    size.triangles = triangleCount(primitive.mode, indices.count);
  }
  forEachActiveTarget(primitive, weights, "POSITION", [&](int accessor, double) {
    size.vertices += positions.count;
    countZeros(accessors.at(accessor, name));
  });
  return size;
}

PrimitiveTriangles readTriangles(const Primitive& primitive, std::span<const double> weights,
                                 AccessorReader& accessors, const std::string& name) {
  PrimitiveTriangles read;
  const std::uint64_t vertexCount = accessors.at(primitive.attributes.at("POSITION"), name).count;
  read.positions =
      morphed(primitive, "POSITION", kPositions, weights, vertexCount, accessors, name);
  const std::vector<int> corners = cornerVertices(primitive, vertexCount, accessors, name);
  read.triangles.reserve(3 * triangleCount(primitive.mode, corners.size()));
  forEachTriangle(primitive.mode, corners.size(),
                  [&](std::uint64_t i, std::uint64_t j, std::uint64_t k) {
                    for (std::uint64_t corner : {i, j, k}) {
                      read.triangles.push_back(corners[corner]);
                    }
                  });

  // A surface needs no attribute: one that does not fit is passed over.
  const auto attribute = [&](const char* semantic, const Format& format,
                             std::span<const double> of) -> std::vector<double> {
    if (!primitive.attributes.contains(semantic)) return {};
    try {
      return morphed(primitive, semantic, format, of, vertexCount, accessors, name);
    } catch (const Error&) {
      ++read.badAttributes;
      return {};
    }
  };
  read.normals = attribute("NORMAL", kNormals, weights);
  read.uvs = attribute("TEXCOORD_0", kUvs, {});
  read.density = attribute("_DENSITY", kDensities, {});
  return read;
}

}  // namespace gvd::gltf
