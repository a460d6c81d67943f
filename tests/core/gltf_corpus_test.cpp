// SPDX-License-Identifier: MIT
//
// The native reader's verdict on every file of the corpus, in steps as at one go.

#include "gltf_corpus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "gvd/error.h"
#include "gvd/gltf.h"
#include "gvd/triangle_mesh.h"
#include "in_steps.h"

namespace gvd {
namespace {

using Numbers = std::vector<double>;

struct Verdict {
  GltfScene scene;
  int faces = 0;
  std::string sentence;
};

/// `read` makes a scene of what `startGltf` gives.
template <class Read>
Verdict verdictOn(const GltfCase& file, Read read) {
  std::vector<GltfResource> resources;
  for (const auto& [path, bytes] : file.resources) resources.push_back({path, bytes});
  try {
    Verdict verdict;
    verdict.scene = read(startGltf(file.bytes, resources));
    const GltfScene& scene = verdict.scene;
    for (const std::string& note : scene.notes) {
      verdict.sentence += (verdict.sentence.empty() ? "" : "; ") + note;
    }
    verdict.faces = TriangleMesh(scene.positions, scene.triangles).faceCount();
    return verdict;
  } catch (const Error& error) {
    return {{}, 0, error.what()};
  }
}

/// NaN is the same as NaN.
bool areSame(const Numbers& a, const Numbers& b) {
  return std::ranges::equal(a, b, [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

void expectSame(const Verdict& a, const Verdict& b) {
  EXPECT_EQ(a.sentence, b.sentence);
  EXPECT_TRUE(areSame(a.scene.positions, b.scene.positions));
  EXPECT_EQ(a.scene.triangles, b.scene.triangles);
  EXPECT_TRUE(areSame(a.scene.normals, b.scene.normals));
  EXPECT_TRUE(areSame(a.scene.uvs, b.scene.uvs));
  EXPECT_TRUE(areSame(a.scene.density, b.scene.density));
  ASSERT_EQ(a.scene.parts.size(), b.scene.parts.size());
  for (std::size_t i = 0; i < a.scene.parts.size(); ++i) {
    EXPECT_EQ(a.scene.parts[i].firstTriangle, b.scene.parts[i].firstTriangle);
    EXPECT_EQ(a.scene.parts[i].name, b.scene.parts[i].name);
  }
}

TEST(GltfCorpus, IsReadOrRefusedAsItShouldBe) {
  for (const GltfCase& file : gltfCorpus()) {
    SCOPED_TRACE(file.name);
    const Verdict verdict = verdictOn(file, finished<GltfScene>);
    EXPECT_EQ(verdict.faces, file.faces);
    EXPECT_EQ(verdict.sentence, file.sentence);
    expectSame(verdict, verdictOn(file, checks::inSteps<GltfScene>));
  }
}

}  // namespace
}  // namespace gvd
