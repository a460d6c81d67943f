// SPDX-License-Identifier: MIT
//
// gltf.wasm: glTF files to plain triangles, for JavaScript. A module of its own because the parser
// is several times the size of everything else: only who opens a glTF file loads it.

#include <span>
#include <string>
#include <vector>

#include "abi.h"
#include "gvd/gltf.h"

namespace gvd::abi {
namespace {

/// A file that the glTF names: its URI and its content, as JavaScript laid them out.
struct ResourceRow {
  const char* uri;
  std::size_t uriLength;
  const std::byte* bytes;
  std::size_t byteLength;
};

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

}  // namespace

/// positions, triangles, normals, uvs, part numbers, then a text per part (its name) and per note.
GVD_ABI Arrays* readGltfScene(const std::byte* bytes, std::size_t byteLength,
                              const ResourceRow* rows, std::size_t rowCount) {
  return guarded([&] {
    std::vector<GltfResource> resources;
    for (const ResourceRow& row : std::span(rows, rowCount)) {
      resources.push_back({std::string(row.uri, row.uriLength), {row.bytes, row.byteLength}});
    }
    GltfScene scene = readGltf({bytes, byteLength}, resources);
    auto out = std::make_unique<Arrays>();
    out->add(std::move(scene.positions));
    out->add(std::move(scene.triangles));
    out->add(std::move(scene.normals));
    out->add(std::move(scene.uvs));
    out->add(partNumbers(scene.parts));
    for (GltfScene::Part& part : scene.parts) out->add(std::move(part.name));
    for (std::string& note : scene.notes) out->add(std::move(note));
    return out.release();
  });
}

}  // namespace gvd::abi
