// SPDX-License-Identifier: MIT
//
// The objects of a glTF that triangles are made of. Their values obey the rules of json_rules.h,
// but an index may be out of range, and a range may reach past its end: check before following one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gvd::gltf {

struct BufferView {
  int buffer = -1;
  std::uint64_t byteOffset = 0, byteLength = 0;
  std::uint64_t byteStride = 0;  ///< 0: the elements follow one another
};

/// Places in a buffer view that hold the numbers of an accessor.
struct ElementRange {
  int bufferView = -1;
  std::uint64_t byteOffset = 0;
};

struct SparseElements {
  std::uint64_t count = 0;
  int indexType = 0;  ///< like `Accessor::componentType`
  ElementRange indices, values;
};

struct Accessor {
  std::uint64_t components = 1;  ///< of an element: 1 to 4; 0 if it is a matrix
  int componentType = 0;         ///< the number that glTF gives it
  bool normalized = false;
  std::uint64_t count = 0;
  std::optional<ElementRange> elements;  ///< none: all elements are zero
  std::optional<SparseElements> sparse;
};

using Attributes = std::map<std::string, int>;  ///< accessors by semantic

/// The values of `Primitive::mode`.
enum Mode { kPoints = 0, kTriangleList = 4, kTriangleStrip = 5, kTriangleFan = 6 };

struct Primitive {
  int mode = kTriangleList;
  Attributes attributes;
  std::optional<int> indices;
  std::vector<Attributes> targets;
  std::string compression;  ///< the extension that compresses it, else empty
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
  std::vector<double> weights;  ///< of morph targets; missing ones are 0
};

struct Node {
  std::string name;
  std::vector<int> children;
  std::optional<int> mesh;
  bool isSkinned = false;
  std::vector<double> weights;                               ///< override the mesh's, unless empty
  Attributes instances;                                      ///< of EXT_mesh_gpu_instancing
  std::vector<double> matrix, translation, rotation, scale;  ///< empty where the file has none
};

struct Document {
  std::vector<BufferView> bufferViews;
  std::vector<Accessor> accessors;
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;
  std::vector<std::vector<int>> scenes;  ///< the root nodes of each
  std::optional<int> defaultScene;
};

/// Parses the text that `readJson` returns.
Document parseDocument(const std::string& text);

/// Refuses an index of `owner` if there is no such object; `what` is its kind ("accessor", "mesh",
/// …).
void requireIndex(int index, std::size_t count, const std::string& what, const std::string& owner);

}  // namespace gvd::gltf
