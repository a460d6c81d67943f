// SPDX-License-Identifier: MIT
//
// Writes valid and deliberately invalid glTF files for tests: the objects are JSON texts that a
// test may replace before the file is put together.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gvd {

using ByteVector = std::vector<std::byte>;

/// The values of component types and modes in glTF.
enum Gltf {
  kByte = 5120,
  kUnsignedByte = 5121,
  kShort = 5122,
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126,
  kPoints = 0,
  kLines = 1,
  kTriangles = 4,
  kStrip = 5,
  kFan = 6,
};

struct GlbWriter {
  ByteVector bin;
  std::vector<std::string> bufferViews, accessors, meshes, nodes, scenes;
  std::string asset = R"({"version":"2.0"})";
  std::string buffers;  ///< empty: one buffer, in the binary chunk or a data URI
  std::string more;     ///< further members of the document, each after a comma

  /// Adds a buffer view of these numbers, aligned to four bytes; returns its index.
  template <class T>
  int addView(const std::vector<T>& numbers, const std::string& members = "") {
    return addBytes(std::as_bytes(std::span(numbers)), members);
  }
  int addBytes(std::span<const std::byte> bytes, const std::string& members = "");

  /// `view` -1: none. `members`: further ones, each after a comma.
  int addAccessor(int view, int componentType, int count, const std::string& type,
                  const std::string& members = "");
  int addPositions(const std::vector<float>& xyz);
  template <class Index>
  int addIndices(int componentType, const std::vector<Index>& indices) {
    return addAccessor(addView(indices), componentType, static_cast<int>(indices.size()), "SCALAR");
  }

  /// A primitive; `indices` -1: none.
  static std::string primitive(int positions, int indices = -1, int mode = kTriangles);
  int addMesh(const std::vector<std::string>& primitives, const std::string& members = "");
  /// `members`: of the node, e.g. R"("mesh":0,"scale":[1,1,-1])".
  int addNode(const std::string& members);

  std::string json(const std::string& bufferUri = "") const;
  ByteVector glb() const;
  /// glTF JSON with the buffer as a data URI.
  ByteVector gltf() const;
};

ByteVector glbOf(std::string_view json, std::span<const std::byte> bin);
ByteVector bytesOf(std::string_view text);
std::string base64(std::span<const std::byte> bytes);

}  // namespace gvd
