// SPDX-License-Identifier: MIT
#include "gltf/accessor_reader.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "gltf/gltf_error.h"

namespace gvd::gltf {
namespace {

template <class T>
double load(const std::byte* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

constexpr ComponentType kInt8 = {5120, 1, load<std::int8_t>, 127};
constexpr ComponentType kUint8 = {5121, 1, load<std::uint8_t>, 255};
constexpr ComponentType kInt16 = {5122, 2, load<std::int16_t>, 32767};
constexpr ComponentType kUint16 = {5123, 2, load<std::uint16_t>, 65535};
constexpr ComponentType kUint32 = {5125, 4, load<std::uint32_t>, 4294967295};
constexpr ComponentType kFloat = {5126, 4, load<float>, 0};

constexpr ComponentType kIndexTypes[] = {kUint8, kUint16, kUint32};
/// KHR_mesh_quantization allows the integers.
constexpr ComponentType kPositionTypes[] = {kInt8, kUint8, kInt16, kUint16, kFloat};
constexpr ComponentType kRotationTypes[] = {kInt8, kInt16, kFloat};
constexpr ComponentType kFloatOnly[] = {kFloat};

const ComponentType& componentType(int id, const Format& format, const std::string& owner) {
  for (const ComponentType& type : format.allowed)
    if (type.id == id) return type;
  reject(owner + " has component type " + std::to_string(id) + ", which " + format.what +
         " cannot have");
}

}  // namespace

const Format kIndices = {"vertex indices", 1, kIndexTypes};
const Format kPositions = {"positions", 3, kPositionTypes};
const Format kNormals = {"normals", 3, kPositionTypes};
const Format kUvs = {"texture coordinates", 2, kPositionTypes};
const Format kDensities = {"densities", 1, kFloatOnly};
const Format kDisplacements = {"morph targets", 3, kPositionTypes};
const Format kTranslations = {"translations", 3, kFloatOnly};
const Format kRotations = {"rotations", 4, kRotationTypes};
const Format kScales = {"scales", 3, kFloatOnly};

AccessorReader::AccessorReader(const Document& document, Buffers buffers)
    : document_(document), buffers_(std::move(buffers)) {}

const Accessor& AccessorReader::at(int index, const std::string& owner) const {
  requireIndex(index, document_.accessors.size(), "accessor", owner);
  return document_.accessors[index];
}

AccessorReading AccessorReader::start(int index, const Format& format, const std::string& owner,
                                      std::vector<double>& to) {
  const Accessor& accessor = at(index, owner);
  const std::string name = "accessor " + std::to_string(index);
  if (accessor.components != format.components)
    reject(name + " has the wrong type for " + format.what);
  const ComponentType& type = componentType(accessor.componentType, format, name);

  AccessorReading reading;
  reading.to_ = &to;
  reading.count_ = accessor.count;
  reading.components_ = format.components;
  reading.type_ = &type;
  reading.isNormalized_ = accessor.normalized && type.largest > 0;
  if (accessor.elements)
    reading.elements_ = elements(*accessor.elements, accessor.count, type, format.components, name);
  if (accessor.sparse) {
    const SparseElements& sparse = *accessor.sparse;
    const std::string part = "the sparse part of " + name;
    if (sparse.count > accessor.count) reject(part + " has more elements than the accessor itself");
    const ComponentType& placeType = componentType(sparse.indexType, kIndices, part);
    reading.sparse_ = {sparse.count, &placeType,
                       elements(sparse.indices, sparse.count, placeType, 1, part),
                       elements(sparse.values, sparse.count, type, format.components, part), part};
  }
  return reading;
}

std::vector<double> AccessorReader::read(int index, const Format& format,
                                         const std::string& owner) {
  std::vector<double> values;
  AccessorReading reading = start(index, format, owner, values);
  long budget = kUnlimited;
  reading.step(budget);
  return values;
}

bool AccessorReading::step(long& budget) {
  constexpr long kElementsPerUnit = 8;
  const std::size_t stored = elements_ ? count_ : 0, replaced = sparse_ ? sparse_->count : 0;
  return sequence_.run(
      [&] { first_ = to_->size(); },
      [&] { return fillInSlices(*to_, first_ + count_ * components_, 0., budget); },
      forEach(stored, budget, kElementsPerUnit, [&](int i) { store(i, elements_->at(i)); }),
      forEach(replaced, budget, kElementsPerUnit, [&](int i) { storeSparse(i); }));
}

void AccessorReading::store(std::uint64_t element, const std::byte* bytes) {
  for (std::uint64_t c = 0; c < components_; ++c) {
    const double value = type_->load(bytes + c * type_->size);
    // The least signed integer stands for -1, as does the one after it.
    (*to_)[first_ + element * components_ + c] =
        isNormalized_ ? std::max(value / type_->largest, -1.0) : value;
  }
}

void AccessorReading::storeSparse(std::uint64_t i) {
  const auto index = static_cast<std::uint64_t>(sparse_->placeType->load(sparse_->places.at(i)));
  if (index >= count_)
    reject(sparse_->name + " has the index " + std::to_string(index) + " past its end");
  store(index, sparse_->values.at(i));
}

Elements AccessorReader::elements(const ElementRange& range, std::uint64_t count,
                                  const ComponentType& type, std::uint64_t components,
                                  const std::string& owner) {
  requireIndex(range.bufferView, document_.bufferViews.size(), "buffer view", owner);
  const BufferView& view = document_.bufferViews[range.bufferView];
  const std::string name = "buffer view " + std::to_string(range.bufferView);
  const Bytes buffer = buffers_.at(view.buffer, name);
  if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset)
    reject(name + " reaches past the end of buffer " + std::to_string(view.buffer));
  const std::uint64_t size = components * type.size;
  const std::uint64_t stride = view.byteStride == 0 ? size : view.byteStride;
  if (stride < size) reject(name + " has a byteStride less than the elements of " + owner);
  // Differences, because the sum offset + stride·(count - 1) + size could overflow.
  const std::uint64_t offset = range.byteOffset, length = view.byteLength;
  const bool fits = count == 0 || (offset <= length && size <= length - offset &&
                                   count - 1 <= (length - offset - size) / stride);
  if (!fits) reject(owner + " reaches past the end of " + name);
  if (const std::uint64_t first = view.byteOffset + offset; first % type.size != 0)
    reject(owner + " begins at byte " + std::to_string(first) +
           " of its buffer, which is not a multiple of " + std::to_string(type.size) +
           ", the size of its numbers");
  return {buffer.data() + view.byteOffset + (count == 0 ? 0 : offset), stride};
}

}  // namespace gvd::gltf
