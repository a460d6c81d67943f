// SPDX-License-Identifier: MIT
#include "gltf/primitive_triangles.h"

#include <algorithm>
#include <array>

#include "gltf/gltf_error.h"

namespace gvd::gltf {
namespace {

std::uint64_t triangleCount(int mode, std::uint64_t corners) {
  if (mode == kTriangleList) return corners / 3;
  return corners < 3 ? 0 : corners - 2;
}

/// The corners of a triangle that a primitive makes; corners too few for a last triangle make none.
std::array<std::uint64_t, 3> cornersOf(int mode, std::uint64_t t) {
  if (mode == kTriangleFan) return {t + 1, t + 2, 0};
  // Every other triangle would come out turned over.
  if (mode == kTriangleStrip) return {t, t + 1 + t % 2, t + 2 - t % 2};
  return {3 * t, 3 * t + 1, 3 * t + 2};
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

// --- One attribute -----------------------------------------------------------------------------

AttributeReading::AttributeReading(const Primitive& primitive, const char* semantic,
                                   const Format& format, std::span<const double> weights,
                                   std::uint64_t vertexCount, AccessorReader& accessors,
                                   const std::string& name) {
  const auto addLayer = [&](int accessor, const Format& as, double weight) {
    if (const std::uint64_t count = accessors.at(accessor, name).count; count != vertexCount) {
      reject(name + " has " + number(count) + " elements of " + as.what + ", but there are " +
             number(vertexCount) + " positions");
    }
    layers_.push_back({accessors.start(accessor, as, name), weight});
  };
  addLayer(primitive.attributes.at(semantic), format, 1);
  forEachActiveTarget(primitive, weights, semantic, [&](int accessor, double weight) {
    addLayer(accessor, kDisplacements, weight);
  });
}

bool AttributeReading::step(long& budget) {
  for (; next_ < layers_.size(); ++next_) {
    Layer& layer = layers_[next_];
    if (!layer.reading.step(budget)) return false;
    const auto add = [&](int i) { values_[i] += layer.weight * layer.reading.values()[i]; };
    if (!loop_.run(values_.size(), budget, kQuickRounds, add)) return false;
    std::vector<double> values = layer.reading.take();
    if (next_ == 0) values_ = std::move(values);
  }
  return true;
}

// --- The primitive -----------------------------------------------------------------------------

PrimitiveReading::PrimitiveReading(const Primitive& primitive, std::span<const double> weights,
                                   AccessorReader& accessors, const std::string& name)
    : primitive_(primitive),
      weights_(weights),
      accessors_(accessors),
      name_(name),
      vertexCount_(accessors.at(primitive.attributes.at("POSITION"), name).count) {}

bool PrimitiveReading::step(long& budget) {
  const bool hasIndices = primitive_.indices.has_value();
  const auto triangles = [&] {
    return triangleCount(primitive_.mode, hasIndices ? indices_.size() : vertexCount_);
  };
  return sequence_.run(
      [&] {
        return runPart(attribute_, budget, primitive_, "POSITION", kPositions, weights_,
                       vertexCount_, accessors_, name_);
      },
      [&] { read_.positions = taken(attribute_); },
      [&] {
        if (hasIndices) indexReading_ = accessors_.start(*primitive_.indices, kIndices, name_);
      },
      [&] { return !hasIndices || indexReading_->step(budget); },
      [&] {
        if (hasIndices) indices_ = taken(indexReading_);
      },
      [&] {
        return loop_.run(indices_.size(), budget, kQuickRounds,
                         [&](int i) { requireVertex(indices_[i]); });
      },
      [&] { read_.triangles.reserve(3 * triangles()); },
      [&] {
        constexpr long kTrianglesPerUnit = 16;
        return loop_.run(triangles(), budget, kTrianglesPerUnit, [&](int t) { addTriangle(t); });
      },
      [&] { release(indices_); },
      [&] { return readOptional("NORMAL", kNormals, weights_, read_.normals, budget); },
      [&] { return readOptional("TEXCOORD_0", kUvs, {}, read_.uvs, budget); },
      [&] { return readOptional("_DENSITY", kDensities, {}, read_.density, budget); });
}

void PrimitiveReading::requireVertex(double index) const {
  if (index < vertexCount_) return;
  reject(name_ + " has vertex index " + number(static_cast<std::uint64_t>(index)) +
         ", but there are " + number(vertexCount_) + " positions");
}

void PrimitiveReading::addTriangle(std::uint64_t t) {
  for (const std::uint64_t corner : cornersOf(primitive_.mode, t)) {
    read_.triangles.push_back(
        static_cast<int>(primitive_.indices ? indices_[corner] : static_cast<double>(corner)));
  }
}

/// A surface needs no attribute: one that does not fit is passed over.
bool PrimitiveReading::readOptional(const char* semantic, const Format& format,
                                    std::span<const double> weights, std::vector<double>& values,
                                    long& budget) {
  if (!primitive_.attributes.contains(semantic)) return true;
  try {
    if (!runPart(attribute_, budget, primitive_, semantic, format, weights, vertexCount_,
                 accessors_, name_))
      return false;
    values = taken(attribute_);
  } catch (const Error&) {
    attribute_.reset();
    ++read_.badAttributes;
  }
  return true;
}

}  // namespace gvd::gltf
