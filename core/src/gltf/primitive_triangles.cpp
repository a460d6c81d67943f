// SPDX-License-Identifier: MIT
#include "gltf/primitive_triangles.h"

#include <numeric>

#include "gltf/gltf_error.h"

namespace gvd::gltf {
namespace {

/// Calls emit(i, j, k) for every triangle that a primitive of `count` corners makes; corners too
/// few for a last triangle make none.
template <class Emit>
void forEachTriangle(int mode, int count, Emit emit) {
  switch (mode) {
    case kTriangleList:
      for (int i = 0; i + 2 < count; i += 3) emit(i, i + 1, i + 2);
      break;
    case kTriangleStrip:  // every other triangle would come out turned over
      for (int i = 0; i + 2 < count; ++i) emit(i, i + 1 + i % 2, i + 2 - i % 2);
      break;
    case kTriangleFan:
      for (int i = 1; i + 1 < count; ++i) emit(i, i + 1, 0);
      break;
  }
}

/// The vertex at each corner of a primitive: as its indices say, else one after the other.
std::vector<int> cornerVertices(const Primitive& primitive, int vertexCount,
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
             ", but there are " + std::to_string(vertexCount) + " positions");
    }
    corners.push_back(static_cast<int>(index));
  }
  return corners;
}

}  // namespace

bool makesTriangles(const Primitive& primitive, const std::string& name) {
  if (primitive.mode < kPoints || primitive.mode > kTriangleFan) {
    reject(name + " has the unknown mode " + std::to_string(primitive.mode));
  }
  return primitive.mode >= kTriangleList;
}

PrimitiveTriangles readTriangles(const Primitive& primitive, AccessorReader& accessors,
                                 const std::string& name) {
  PrimitiveTriangles read;
  read.positions = accessors.read(primitive.attributes.at("POSITION"), kPositions, name);
  const std::size_t vertexCount = read.positions.size() / 3;
  const std::vector<int> corners =
      cornerVertices(primitive, static_cast<int>(vertexCount), accessors, name);
  forEachTriangle(primitive.mode, static_cast<int>(corners.size()), [&](int i, int j, int k) {
    read.triangles.insert(read.triangles.end(), {corners[i], corners[j], corners[k]});
  });

  // A surface needs no attribute: one that does not fit is passed over.
  const auto attribute = [&](const char* semantic, const Format& format) -> std::vector<double> {
    const auto found = primitive.attributes.find(semantic);
    if (found == primitive.attributes.end()) return {};
    try {
      std::vector<double> values = accessors.read(found->second, format, name);
      if (values.size() == vertexCount * format.components) return values;
    } catch (const Error&) {
    }
    ++read.badAttributes;
    return {};
  };
  read.normals = attribute("NORMAL", kNormals);
  read.uvs = attribute("TEXCOORD_0", kUvs);
  return read;
}

void requireUncompressed(const Primitive& primitive, const Accessor& positions,
                         const std::string& name) {
  if (positions.elements || primitive.compression.empty()) return;
  reject(name + " is compressed with " + primitive.compression +
         ", which has to be decompressed before it is read here");
}

}  // namespace gvd::gltf
