// SPDX-License-Identifier: MIT
//
// The native reader's verdict on every file of the corpus.

#include "gltf_corpus.h"

#include <gtest/gtest.h>

#include "gvd/error.h"
#include "gvd/gltf.h"
#include "gvd/triangle_mesh.h"

namespace gvd {
namespace {

struct Verdict {
  int faces = 0;
  std::string sentence;
};

Verdict verdictOn(const GltfCase& file) {
  std::vector<GltfResource> resources;
  for (const auto& [path, bytes] : file.resources) resources.push_back({path, bytes});
  try {
    const GltfScene scene = readGltf(file.bytes, resources);
    Verdict verdict;
    for (const std::string& note : scene.notes) {
      verdict.sentence += (verdict.sentence.empty() ? "" : "; ") + note;
    }
    verdict.faces = TriangleMesh(scene.positions, scene.triangles).faceCount();
    return verdict;
  } catch (const Error& error) {
    return {0, error.what()};
  }
}

TEST(GltfCorpus, IsReadOrRefusedAsItShouldBe) {
  for (const GltfCase& file : gltfCorpus()) {
    const Verdict verdict = verdictOn(file);
    EXPECT_EQ(verdict.faces, file.faces) << file.name;
    EXPECT_EQ(verdict.sentence, file.sentence) << file.name;
  }
}

}  // namespace
}  // namespace gvd
