// SPDX-License-Identifier: MIT
#include "gltf/primitive_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "gltf/gltf_error.h"

namespace gvd::gltf {
namespace {

std::uint64_t triangleCount(int mode, std::uint64_t corners) {
  if (mode == kTriangleList) return corners / 3;
  return corners < 3 ? 0 : corners - 2;
}

/// The corners of triangle t of a primitive. Left-over corners at the end make no triangle.
std::array<std::uint64_t, 3> cornersOf(int mode, std::uint64_t t) {
  if (mode == kTriangleFan) return {t + 1, t + 2, 0};
  // Swaps two corners of every other triangle of a strip, which would be turned over.
  if (mode == kTriangleStrip) return {t, t + 1 + t % 2, t + 2 - t % 2};
  return {3 * t, 3 * t + 1, 3 * t + 2};
}

/// Calls use(target, weight) for the morph targets whose weight is not 0.
template <class Use>
void forEachActiveTarget(const Primitive& primitive, std::span<const double> weights, Use use) {
  for (std::size_t t = 0; t < std::min(primitive.targets.size(), weights.size()); ++t)
    if (weights[t] != 0) use(primitive.targets[t], weights[t]);
}

}  // namespace

PrimitiveKind kindOf(const Primitive& primitive, const std::string& name) {
  if (primitive.mode < kPoints || primitive.mode > kTriangleFan)
    reject(name + " has the unknown mode " + std::to_string(primitive.mode));
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
  if (!positions.elements && !primitive.compression.empty())
    reject(name + " is compressed with " + primitive.compression + kNotDecompressed);
  countZeros(positions);
  size.vertices = positions.count;
  size.triangles = triangleCount(primitive.mode, positions.count);
  if (primitive.indices) {
    const Accessor& indices = accessors.at(*primitive.indices, name);
    countZeros(indices);
    size.triangles = triangleCount(primitive.mode, indices.count);
  }
  forEachActiveTarget(primitive, weights, [&](const Attributes& target, double) {
    size.vertices += positions.count;
    size.countedAgain += positions.count;
    if (const auto moved = target.find("POSITION"); moved != target.end())
      countZeros(accessors.at(moved->second, name));
  });
  return size;
}

// --- One attribute -----------------------------------------------------------------------------

AttributeReading::AttributeReading(const Primitive& primitive, const char* semantic,
                                   const Format& format, std::span<const double> weights,
                                   std::uint64_t vertexCount, AccessorReader& accessors,
                                   const std::string& name, std::vector<double>& to)
    : to_(to), first_(to.size()) {
  const auto addLayer = [&](int accessor, const Format& as, double weight) {
    if (const std::uint64_t count = accessors.at(accessor, name).count; count != vertexCount)
      reject(name + ": the number of elements of " + as.what + " is " + std::to_string(count) +
             ", not that of positions, " + std::to_string(vertexCount));
    std::vector<double>& values = layers_.empty() ? to_ : displacements_;
    layers_.push_back({accessors.start(accessor, as, name, values), weight});
  };
  addLayer(primitive.attributes.at(semantic), format, 1);
  forEachActiveTarget(primitive, weights, [&](const Attributes& target, double weight) {
    if (const auto moved = target.find(semantic); moved != target.end())
      addLayer(moved->second, kDisplacements, weight);
  });
}

bool AttributeReading::step(long& budget) {
  for (; next_ < layers_.size(); ++next_) {
    Layer& layer = layers_[next_];
    if (!layer.reading.step(budget)) return false;
    const auto add = [&](int i) { to_[first_ + i] += layer.weight * displacements_[i]; };
    if (!loop_.run(displacements_.size(), budget, kQuickRounds, add)) return false;
    displacements_.clear();
  }
  return true;
}

// --- The primitive -----------------------------------------------------------------------------

PrimitiveReading::PrimitiveReading(const Primitive& primitive, std::span<const double> weights,
                                   const Eigen::Affine3d& transform, AccessorReader& accessors,
                                   const std::string& name, GltfScene& scene)
    : primitive_(primitive),
      weights_(weights),
      transform_(transform),
      accessors_(accessors),
      name_(name),
      scene_(scene),
      firstVertex_(scene.positions.size() / 3),
      vertexCount_(accessors.at(primitive.attributes.at("POSITION"), name).count) {
  const Eigen::Matrix3d m = transform.linear();
  for (int i = 0; i < 3; ++i) cofactors_.col(i) = m.col((i + 1) % 3).cross(m.col((i + 2) % 3));
  isMirrored_ = m.determinant() < 0;
  if (isMirrored_) cofactors_ = -cofactors_;
}

bool PrimitiveReading::step(long& budget) {
  const bool hasIndices = primitive_.indices.has_value();
  return sequence_.run(
      [&] {
        return runPart(attribute_, budget, primitive_, "POSITION", kPositions, weights_,
                       vertexCount_, accessors_, name_, scene_.positions);
      },
      [&] { attribute_.reset(); },
      [&](SlicedLoop& loop) {
        return forVertices(loop, budget, [&](std::size_t v) {
          auto position = Eigen::Vector3d::Map(&scene_.positions[3 * v]);
          position = transform_ * Eigen::Vector3d(position);
        });
      },
      [&] {
        if (hasIndices)
          indexReading_ = accessors_.start(*primitive_.indices, kIndices, name_, indices_);
      },
      [&] { return !hasIndices || indexReading_->step(budget); },
      forItems(indices_, budget, kQuickRounds, [&](double index) { requireVertex(index); }),
      [&](SlicedLoop& loop) {
        constexpr long kTrianglesPerUnit = 16;
        const std::size_t corners = hasIndices ? indices_.size() : vertexCount_;
        return loop.run(triangleCount(primitive_.mode, corners), budget, kTrianglesPerUnit,
                        [&](int t) { addTriangle(t); });
      },
      [&] { release(indices_); },
      [&] { return readOptional("NORMAL", kNormals, weights_, scene_.normals, 0, budget); },
      [&](SlicedLoop& loop) {
        return !isRead_ || forVertices(loop, budget, [&](std::size_t v) { turnNormal(v); });
      },
      [&] { return readOptional("TEXCOORD_0", kUvs, {}, scene_.uvs, 0, budget); },
      [&](SlicedLoop& loop) {
        return !isRead_ || forVertices(loop, budget, [&](std::size_t v) {
          for (const std::size_t i : {2 * v, 2 * v + 1})
            if (!std::isfinite(scene_.uvs[i])) scene_.uvs[i] = 0;
        });
      },
      [&] { return readOptional("_DENSITY", kDensities, {}, scene_.density, 1, budget); });
}

/// Calls `visit` with the indices of the primitive's vertices in the scene.
template <class Visit>
bool PrimitiveReading::forVertices(SlicedLoop& loop, long& budget, Visit visit) {
  constexpr long kVerticesPerUnit = 16;
  return loop.run(vertexCount_, budget, kVerticesPerUnit, [&](int v) { visit(firstVertex_ + v); });
}

void PrimitiveReading::requireVertex(double index) const {
  if (index < vertexCount_) return;
  reject(name_ + " has vertex index " + std::to_string(static_cast<std::uint64_t>(index)) +
         ", but the number of positions is " + std::to_string(vertexCount_));
}

/// Adds a triangle, with two corners swapped if the transform mirrors, so that it is not turned
/// over.
void PrimitiveReading::addTriangle(std::uint64_t t) {
  auto corners = cornersOf(primitive_.mode, t);
  if (isMirrored_) std::swap(corners[1], corners[2]);
  for (const std::uint64_t corner : corners) {
    const auto vertex = static_cast<std::size_t>(primitive_.indices ? indices_[corner]
                                                                    : static_cast<double>(corner));
    scene_.triangles.push_back(static_cast<int>(firstVertex_ + vertex));
  }
}

/// Transforms a normal by the cofactor matrix, which also works for singular transforms.
void PrimitiveReading::turnNormal(std::size_t vertex) {
  auto normal = Eigen::Vector3d::Map(&scene_.normals[3 * vertex]);
  normal = (cofactors_ * normal).stableNormalized();
  if (!normal.allFinite()) normal.setZero();
}

/// Reads an optional attribute; skips one that does not fit, because a surface needs none.
bool PrimitiveReading::readOptional(const char* semantic, const Format& format,
                                    std::span<const double> weights, std::vector<double>& values,
                                    double padding, long& budget) {
  isRead_ = primitive_.attributes.contains(semantic);
  if (!isRead_) return true;
  if (!attribute_) {
    sizeBefore_ = values.size();
    values.reserve(scene_.positions.capacity() / 3 * format.components);
    values.resize(firstVertex_ * format.components, padding);
  }
  try {
    if (!runPart(attribute_, budget, primitive_, semantic, format, weights, vertexCount_,
                 accessors_, name_, values))
      return false;
  } catch (const Error&) {
    values.resize(sizeBefore_);
    isRead_ = false;
    ++badAttributes_;
  }
  attribute_.reset();
  return true;
}

}  // namespace gvd::gltf
