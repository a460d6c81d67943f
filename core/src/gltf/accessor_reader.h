// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gltf/buffers.h"
#include "gltf/document.h"

namespace gvd::gltf {

/// How numbers of one component type lie in memory. `largest` is what integers are divided by where
/// they are `normalized`, and 0 where numbers are not integers.
struct ComponentType {
  int id;
  std::uint64_t size;
  double (*load)(const std::byte*);
  double largest;
};

/// What an accessor has to look like for the use that is made of it.
struct Format {
  const char* what;
  ElementType type;
  std::uint64_t components;
  std::span<const ComponentType> allowed;
};

extern const Format kIndices, kPositions, kNormals, kUvs, kDensities, kDisplacements;
/// Of EXT_mesh_gpu_instancing.
extern const Format kTranslations, kRotations, kScales;

/// Reads the numbers of accessors. All bytes are reached through `elements`, which checks the range
/// once for all elements.
class AccessorReader {
 public:
  AccessorReader(const Document& document, Buffers buffers);

  const Accessor& at(int index, const std::string& owner) const;

  /// All numbers of an accessor that `owner` names, element by element: those of its buffer view,
  /// or zeros, then the sparse ones in their places.
  std::vector<double> read(int index, const Format& format, const std::string& owner);

 private:
  /// Elements in memory, each of which lies inside its buffer view.
  struct Elements {
    const std::byte* first;
    std::uint64_t stride;
    const std::byte* at(std::uint64_t i) const { return first + i * stride; }
  };

  /// `count` elements of `components` numbers; `owner` names them.
  Elements elements(const ElementRange& range, std::uint64_t count, const ComponentType& type,
                    std::uint64_t components, const std::string& owner);

  /// Calls store(place, bytes) for every sparse element.
  template <class Store>
  void forEachSparse(const Accessor& accessor, const ComponentType& valueType,
                     std::uint64_t components, const std::string& name, Store store);

  const Document& document_;
  Buffers buffers_;
};

}  // namespace gvd::gltf
