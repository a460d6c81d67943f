// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"
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

/// Elements in memory, each of which lies inside its buffer view.
struct Elements {
  const std::byte* first;
  std::uint64_t stride;
  const std::byte* at(std::uint64_t i) const { return first + i * stride; }
};

/// Reads the numbers of one accessor to the end of a list, in slices, element by element: those of
/// its buffer view, or zeros, then the sparse ones in their places.
class AccessorReading {
 public:
  /// True when all numbers are there.
  bool step(long& budget);

 private:
  friend class AccessorReader;

  /// Elements that replace others.
  struct Sparse {
    std::uint64_t count;
    const ComponentType* placeType;
    Elements places, values;
    std::string name;
  };

  AccessorReading() = default;
  void store(std::uint64_t element, const std::byte* bytes);
  void storeSparse(std::uint64_t i);

  std::uint64_t count_ = 0, components_ = 0;
  const ComponentType* type_ = nullptr;
  bool isNormalized_ = false;
  std::optional<Elements> elements_;  ///< none: all are zero
  std::optional<Sparse> sparse_;
  std::vector<double>* to_ = nullptr;
  std::size_t first_ = 0;  ///< where in the list the numbers begin
  SlicedSequence sequence_;
  SlicedLoop loop_;
};

/// The accessors of a document. All bytes are reached through `elements`, which checks the range
/// once for all elements.
class AccessorReader {
 public:
  AccessorReader(const Document& document, Buffers buffers);

  const Accessor& at(int index, const std::string& owner) const;

  /// Begins to read an accessor that `owner` names to the end that the list has at the first step.
  AccessorReading start(int index, const Format& format, const std::string& owner,
                        std::vector<double>& to);
  /// The same at one go.
  std::vector<double> read(int index, const Format& format, const std::string& owner);

 private:
  /// `count` elements of `components` numbers; `owner` names them.
  Elements elements(const ElementRange& range, std::uint64_t count, const ComponentType& type,
                    std::uint64_t components, const std::string& owner);

  const Document& document_;
  Buffers buffers_;
};

}  // namespace gvd::gltf
