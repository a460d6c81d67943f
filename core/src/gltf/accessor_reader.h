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

/// How numbers of one component type are stored. `largest` is the divisor of `normalized` integers,
/// 0 for types that are not integers.
struct ComponentType {
  int id;
  std::uint64_t size;
  double (*load)(const std::byte*);
  double largest;
};

/// What an accessor must be like for a given use.
struct Format {
  const char* what;
  std::uint64_t components;
  std::span<const ComponentType> allowed;
};

extern const Format kIndices, kPositions, kNormals, kUvs, kDensities, kDisplacements;
/// For EXT_mesh_gpu_instancing.
extern const Format kTranslations, kRotations, kScales;

/// Elements in memory, all of them inside their buffer view.
struct Elements {
  const std::byte* first;
  std::uint64_t stride;
  const std::byte* at(std::uint64_t i) const { return first + i * stride; }
};

/// Appends the numbers of one accessor to a list, in slices: first those of its buffer view, or
/// zeros, then the sparse ones, which replace some of them.
class AccessorReading {
 public:
  /// Returns true when all numbers are read.
  bool step(long& budget);

 private:
  friend class AccessorReader;

  /// The sparse elements, which replace elements of the buffer view.
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
  std::size_t first_ = 0;  ///< index of the first number in the list
  SlicedSequence sequence_;
};

/// The accessors of a document. All bytes are reached through `elements`, which checks the range
/// once for all elements.
class AccessorReader {
 public:
  AccessorReader(const Document& document, Buffers buffers);

  const Accessor& at(int index, const std::string& owner) const;

  /// Begins to read an accessor that `owner` names. The first step notes where the list ends;
  /// numbers are appended there.
  AccessorReading start(int index, const Format& format, const std::string& owner,
                        std::vector<double>& to);
  /// Reads all of an accessor at one go.
  std::vector<double> read(int index, const Format& format, const std::string& owner);

 private:
  /// `count` elements of `components` numbers, in a range that `owner` names.
  Elements elements(const ElementRange& range, std::uint64_t count, const ComponentType& type,
                    std::uint64_t components, const std::string& owner);

  const Document& document_;
  Buffers buffers_;
};

}  // namespace gvd::gltf
