// SPDX-License-Identifier: MIT
//
// gltf.wasm: glTF files to plain triangles, for JavaScript. A module of its own because the parser
// is several times the size of everything else: only who opens a glTF file loads it.

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "abi.h"
#include "gvd/gltf.h"

namespace gvd::abi {
namespace {

/// The default limits, with the named ones replaced. The names are those of `GltfLimits`.
GltfLimits toLimits(std::span<const Array<char>> names, std::span<const double> values) {
  using Limit = std::size_t GltfLimits::*;
  constexpr Named<Limit> kLimits[] = {
      {"maxJsonBytes", &GltfLimits::maxJsonBytes},
      {"maxObjects", &GltfLimits::maxObjects},
      {"maxVertices", &GltfLimits::maxVertices},
      {"maxTriangles", &GltfLimits::maxTriangles},
      {"maxZeroElements", &GltfLimits::maxZeroElements},
  };
  GltfLimits limits;
  for (std::size_t i = 0; i < names.size(); ++i)
    limits.*valueOf(kLimits, "limit", names[i]) = static_cast<std::size_t>(values[i]);
  return limits;
}

/// Five numbers per part: node, mesh, primitive, first triangle, triangle count.
std::vector<int> partNumbers(std::span<const GltfScene::Part> parts) {
  std::vector<int> numbers;
  numbers.reserve(5 * parts.size());
  for (const GltfScene::Part& part : parts) {
    numbers.insert(numbers.end(),
                   {part.node, part.mesh, part.primitive, part.firstTriangle, part.triangleCount});
  }
  return numbers;
}

Record recordOf(GltfScene scene) {
  std::vector<std::string> names;
  for (GltfScene::Part& part : scene.parts) names.push_back(std::move(part.name));
  Record out;
  out.add("positions", std::move(scene.positions));
  out.add("indices", std::move(scene.triangles));
  out.add("normals", std::move(scene.normals));
  out.add("uvs", std::move(scene.uvs));
  out.add("density", std::move(scene.density));
  out.add("partNumbers", partNumbers(scene.parts));
  out.add("partNames", std::move(names));
  out.add("notes", std::move(scene.notes));
  return out;
}

}  // namespace

/// `uris[i]` names the file that `files[i]` is the content of; `limitNames[i]` is set to
/// `limitValues[i]`. All bytes must outlive the answer.
GVD_ABI Answer* readGltfScene(Bytes bytes, const Array<Array<char>>& uris,
                              const Array<Array<std::byte>>& files,
                              const Array<Array<char>>& limitNames, Doubles limitValues) {
  return guarded([&] {
    auto resources = std::make_unique<std::vector<GltfResource>>();
    for (std::size_t i = 0; i < uris.size; ++i)
      resources->push_back({toString(uris.data[i]), files.data[i].span()});
    auto reading =
        startGltf(bytes.span(), *resources, toLimits(limitNames.span(), limitValues.span()));
    return answerOf(std::move(reading), [resources = std::move(resources)](GltfScene scene) {
      return recordOf(std::move(scene));
    });
  });
}

}  // namespace gvd::abi
