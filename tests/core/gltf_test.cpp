// SPDX-License-Identifier: MIT
#include "gvd/gltf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "glb_writer.h"
#include "gvd/error.h"

namespace gvd {
namespace {

using Triangles = std::vector<int>;
using Positions = std::vector<double>;

const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
/// Corners of a zigzag strip: 0 2 4 above, 1 3 5 below.
const std::vector<float> kZigzag = {0, 1, 0, 0, 0, 0, 1, 1, 0, 1, 0, 0, 2, 1, 0, 2, 0, 0};

/// One triangle in one mesh, in one node.
GlbWriter triangleFile() {
  GlbWriter file;
  file.addMesh({GlbWriter::primitive(file.addPositions(kTriangle))}, R"(,"name":"mesh")");
  file.addNode(R"("mesh":0,"name":"node")");
  return file;
}

/// One primitive without a node.
GltfScene readPrimitive(GlbWriter& file, int positions, int indices = -1, int mode = kTriangles) {
  file.addMesh({GlbWriter::primitive(positions, indices, mode)});
  return readGltf(file.glb());
}

std::string errorOf(std::span<const std::byte> bytes,
                    std::span<const GltfResource> resources = {}) {
  try {
    readGltf(bytes, resources);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kInvalidGltf);
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return "";
}

std::string errorOf(std::string_view json) { return errorOf(bytesOf(json)); }

/// The error of a right file after a change that makes it wrong.
std::string errorAfter(const std::function<void(GlbWriter&)>& change) {
  GlbWriter file = triangleFile();
  change(file);
  return errorOf(file.glb());
}

// --- Primitives ----------------------------------------------------------------------------------

TEST(ReadGltf, ReadsOneTriangle) {
  const GltfScene scene = readGltf(triangleFile().glb());
  EXPECT_EQ(scene.positions, Positions(kTriangle.begin(), kTriangle.end()));
  EXPECT_EQ(scene.triangles, (Triangles{0, 1, 2}));
  ASSERT_EQ(scene.parts.size(), 1u);
  const GltfScene::Part& part = scene.parts[0];
  EXPECT_EQ(part.node, 0);
  EXPECT_EQ(part.mesh, 0);
  EXPECT_EQ(part.primitive, 0);
  EXPECT_EQ(part.firstTriangle, 0);
  EXPECT_EQ(part.triangleCount, 1);
  EXPECT_EQ(part.name, "node");
  EXPECT_TRUE(scene.notes.empty());
}

TEST(ReadGltf, ReadsEveryIndexType) {
  const auto read = [](const std::function<int(GlbWriter&)>& addIndices) {
    GlbWriter file;
    const int positions = file.addPositions(kTriangle);
    return readPrimitive(file, positions, addIndices(file)).triangles;
  };
  const Triangles expected = {2, 1, 0};
  EXPECT_EQ(read([](GlbWriter& f) {
              return f.addIndices<std::uint8_t>(kUnsignedByte, {2, 1, 0});
            }),
            expected);
  EXPECT_EQ(read([](GlbWriter& f) {
              return f.addIndices<std::uint16_t>(kUnsignedShort, {2, 1, 0});
            }),
            expected);
  EXPECT_EQ(read([](GlbWriter& f) {
              return f.addIndices<std::uint32_t>(kUnsignedInt, {2, 1, 0});
            }),
            expected);
}

TEST(ReadGltf, TurnsEveryOtherTriangleOfAStrip) {
  GlbWriter file;
  const int positions = file.addPositions(kZigzag);
  EXPECT_EQ(readPrimitive(file, positions, -1, kStrip).triangles,
            (Triangles{0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4}));
}

TEST(ReadGltf, KeepsTheDegenerateTrianglesThatJoinStrips) {
  GlbWriter file;
  const int positions = file.addPositions(kZigzag);
  const int indices = file.addIndices<std::uint8_t>(kUnsignedByte, {0, 1, 2, 2, 3});
  EXPECT_EQ(readPrimitive(file, positions, indices, kStrip).triangles,
            (Triangles{0, 1, 2, 1, 2, 2, 2, 2, 3}));
}

TEST(ReadGltf, TurnsAFanAroundItsFirstCorner) {
  GlbWriter file;
  const int positions = file.addPositions(kZigzag);
  const int indices = file.addIndices<std::uint8_t>(kUnsignedByte, {1, 3, 2, 0});
  EXPECT_EQ(readPrimitive(file, positions, indices, kFan).triangles, (Triangles{3, 2, 1, 2, 0, 1}));
}

TEST(ReadGltf, LeavesOutCornersTooFewForATriangle) {
  GlbWriter file;
  const int positions = file.addPositions(kZigzag);
  const int indices = file.addIndices<std::uint8_t>(kUnsignedByte, {0, 1, 2, 3, 4});
  EXPECT_EQ(readPrimitive(file, positions, indices).triangles, (Triangles{0, 1, 2}));
}

TEST(ReadGltf, PassesOverPointsLinesAndPrimitivesWithoutPositions) {
  GlbWriter file;
  const int positions = file.addPositions(kTriangle);
  file.addMesh({GlbWriter::primitive(positions, -1, kPoints), R"({"attributes":{"NORMAL":0}})",
                GlbWriter::primitive(positions), GlbWriter::primitive(positions, -1, kLines)});
  const GltfScene scene = readGltf(file.glb());
  EXPECT_EQ(scene.triangles, (Triangles{0, 1, 2}));
  ASSERT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(scene.parts[0].primitive, 2);
  EXPECT_EQ(scene.notes,
            (std::vector<std::string>{"primitives of points or lines were passed over (2)",
                                      "primitives without positions were passed over (1)"}));
}

// --- Scenes --------------------------------------------------------------------------------------

TEST(ReadGltf, TakesNodesDepthFirstAndPrimitivesInOrder) {
  GlbWriter file;
  const int a = file.addPositions(kTriangle);
  const int b = file.addPositions(kZigzag);
  file.addMesh({GlbWriter::primitive(a), GlbWriter::primitive(b)}, R"(,"name":"two")");
  file.addMesh({GlbWriter::primitive(b)}, R"(,"name":"one")");
  file.addNode(R"("mesh":1)");
  file.addNode(R"("mesh":0,"children":[3,0],"name":"root")");
  file.addNode(R"("mesh":1,"name":"last")");
  file.addNode(R"("children":[4])");
  file.addNode(R"("mesh":1,"name":"leaf")");
  file.scenes = {R"({"nodes":[1,2]})"};
  file.more = R"(,"scene":0)";
  const GltfScene scene = readGltf(file.glb());

  std::vector<std::string> parts;
  for (const GltfScene::Part& part : scene.parts) {
    parts.push_back(part.name + ' ' + std::to_string(part.node) + ' ' + std::to_string(part.mesh) +
                    ' ' + std::to_string(part.primitive) + ' ' +
                    std::to_string(part.firstTriangle) + '+' + std::to_string(part.triangleCount));
  }
  EXPECT_EQ(parts, (std::vector<std::string>{"root 1 0 0 0+1", "root 1 0 1 1+2", "leaf 4 1 0 3+2",
                                             "one 0 1 0 5+2", "last 2 1 0 7+2"}));
  EXPECT_EQ(scene.triangles.size(), 27u);
  EXPECT_EQ(scene.positions.size(), 3u * (3 + 4 * 6));
  EXPECT_EQ(scene.triangles[3], 3) << "the second primitive's vertices come after the first's";
}

TEST(ReadGltf, TakesTheDefaultSceneElseAllRootsElseAllMeshes) {
  GlbWriter file = triangleFile();
  file.addNode(R"("mesh":0,"children":[2])");
  file.addNode(R"("mesh":0)");
  file.scenes = {R"({"nodes":[1]})", R"({"nodes":[0]})"};
  const auto nodes = [&] {
    std::vector<int> list;
    for (const GltfScene::Part& part : readGltf(file.glb()).parts) list.push_back(part.node);
    return list;
  };
  EXPECT_EQ(nodes(), (std::vector<int>{0, 1, 2}));
  file.more = R"(,"scene":1)";
  EXPECT_EQ(nodes(), (std::vector<int>{0}));
  file.more = "";
  file.scenes.clear();
  file.nodes.clear();
  EXPECT_EQ(nodes(), (std::vector<int>{-1}));
}

TEST(ReadGltf, AppliesTheTransformsOfAllAncestors) {
  GlbWriter file = triangleFile();
  const double half = std::sqrt(0.5);
  // Scaled by 2, turned by 90° around z, moved by (0, 0, 1); then, column by column, moved by 10.
  file.nodes[0] = R"({"mesh":0,"scale":[2,2,2],"rotation":[0,0,)" + std::to_string(half) + ',' +
                  std::to_string(half) + R"(],"translation":[0,0,1]})";
  file.addNode(R"("children":[0],"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 10,0,0,1])");
  const Positions expected = {10, 0, 1, 10, 2, 1, 8, 0, 1};
  const Positions positions = readGltf(file.glb()).positions;
  ASSERT_EQ(positions.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(positions[i], expected[i], 1e-15);
}

TEST(ReadGltf, TurnsTrianglesOverUnderAMirror) {
  GlbWriter file = triangleFile();
  file.nodes[0] = R"({"mesh":0,"scale":[1,1,-1]})";
  EXPECT_EQ(readGltf(file.glb()).triangles, (Triangles{0, 2, 1}));
  file.addNode(R"("children":[0],"scale":[-2,1,1])");
  EXPECT_EQ(readGltf(file.glb()).triangles, (Triangles{0, 1, 2})) << "mirrored twice";
}

TEST(ReadGltf, WalksAHierarchyAsDeepAsItIs) {
  GlbWriter file = triangleFile();
  constexpr int kDepth = 20000;
  for (int n = 1; n <= kDepth; ++n) {
    file.addNode("\"children\":[" + std::to_string(n - 1) + R"(],"translation":[1,0,0])");
  }
  EXPECT_EQ(readGltf(file.glb()).positions[0], kDepth);
}

TEST(ReadGltf, IgnoresTheTransformOfASkinnedNode) {
  GlbWriter file = triangleFile();
  file.nodes[0] = R"({"mesh":0,"skin":0,"scale":[1,1,-7],"children":[1]})";
  file.addNode(R"("mesh":0)");
  file.addNode(R"("translation":[9,9,9],"children":[0])");
  const GltfScene scene = readGltf(file.glb());
  EXPECT_EQ(scene.positions, (Positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, 9, 10, 9, 9, 9, 10, 9}))
      << "its children's counts, though";
  EXPECT_EQ(scene.triangles, (Triangles{0, 1, 2, 3, 5, 4}));
  EXPECT_EQ(scene.notes, (std::vector<std::string>{"meshes with a skin were taken unposed (1)"}));
}

TEST(ReadGltf, AppliesMorphTargetsWithTheirDefaultWeights) {
  GlbWriter file;
  file.addPositions(kTriangle);
  file.addPositions({0, 0, 1, 0, 0, 1, 0, 0, 1});
  file.addPositions({4, 0, 0, 0, 0, 0, 0, 0, 0});
  const std::string primitive =
      R"({"attributes":{"POSITION":0},"targets":[{"POSITION":1},{"NORMAL":2,"POSITION":2},{}]})";
  const auto read = [&](const std::string& ofMesh, const std::string& ofNode) {
    file.meshes = {"{\"primitives\":[" + primitive + ']' + ofMesh + '}'};
    file.nodes = {"{\"mesh\":0" + ofNode + '}'};
    return readGltf(file.glb()).positions;
  };
  const Positions unchanged(kTriangle.begin(), kTriangle.end());
  EXPECT_EQ(read("", ""), unchanged);
  EXPECT_EQ(read(R"(,"weights":[0,0.5,1])", ""), (Positions{2, 0, 0, 1, 0, 0, 0, 1, 0}));
  EXPECT_EQ(read(R"(,"weights":[3])", ""), (Positions{0, 0, 3, 1, 0, 3, 0, 1, 3}));
  EXPECT_EQ(read(R"(,"weights":[3,3,3])", R"(,"weights":[-1,0,0])"),
            (Positions{0, 0, -1, 1, 0, -1, 0, 1, -1}))
      << "the node's weights come first";
  EXPECT_EQ(readGltf(file.glb()).notes,
            (std::vector<std::string>{
                "primitives with morph targets were taken with their default weights (1)"}));
  // What has the weight 0 is not missed.
  file.accessors[2] = R"({"bufferView":77,"componentType":5126,"count":3,"type":"VEC3"})";
  EXPECT_EQ(read("", ""), unchanged);
  file.accessors[2] = R"({"bufferView":2,"componentType":5126,"count":2,"type":"VEC3"})";
  file.meshes = {"{\"primitives\":[" + primitive + R"(],"weights":[0,1]})"};
  EXPECT_EQ(errorOf(file.glb()),
            "primitive 0 of mesh 0 has 2 elements of morph targets, but there are 3 positions");
}

TEST(ReadGltf, AppliesMorphTargetsToNormals) {
  GlbWriter file;
  file.addPositions(kTriangle);
  file.addPositions({0, 0, 1, 0, 0, 1, 0, 0, 1});
  file.addPositions({3, 0, 3, 0, 0, 0, 0, 0, -2});
  file.addMesh({R"({"attributes":{"POSITION":0,"NORMAL":1},"targets":[{"NORMAL":2}]})"},
               R"(,"weights":[1])");
  EXPECT_EQ(readGltf(file.glb()).normals, (Positions{0.6, 0, 0.8, 0, 0, 1, 0, 0, -1}));
}

TEST(ReadGltf, RepeatsTheMeshOfANodeWithInstances) {
  GlbWriter file = triangleFile();
  const int moves = file.addPositions({0, 0, 0, 5, 0, 0});
  const int turns =
      file.addAccessor(file.addView(std::vector<std::int8_t>{0, 0, 0, 127, 0, 0, 127, 0}), kByte, 2,
                       "VEC4", R"(,"normalized":true)");
  const int scales = file.addPositions({1, 1, 1, 2, 2, -2});
  file.nodes[0] = R"({"mesh":0,"translation":[0,0,1],"extensions":{"EXT_mesh_gpu_instancing":{)"
                  R"("attributes":{"TRANSLATION":)" +
                  std::to_string(moves) + R"(,"ROTATION":)" + std::to_string(turns) +
                  R"(,"SCALE":)" + std::to_string(scales) + R"(,"_COLOR":99}}}})";
  file.more = R"(,"extensionsRequired":["EXT_mesh_gpu_instancing"])";
  const GltfScene scene = readGltf(file.glb());
  EXPECT_EQ(scene.positions, (Positions{0, 0, 1, 1, 0, 1, 0, 1, 1, 5, 0, 1, 3, 0, 1, 5, -2, 1}));
  EXPECT_EQ(scene.triangles, (Triangles{0, 1, 2, 3, 5, 4}));
  EXPECT_EQ(scene.parts.size(), 2u);
  EXPECT_TRUE(scene.notes.empty());

  file.accessors[scales] = R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"})";
  EXPECT_EQ(errorOf(file.glb()), "node 0 has instances whose accessors differ in count");
  file.accessors[scales] = R"({"bufferView":0,"componentType":5126,"count":1e6,"type":"VEC3"})";
  EXPECT_EQ(errorOf(file.glb()),
            "the scene has more than 262144 primitives and morph targets, instances "
            "included; raise the limit maxObjects to read it");
}

TEST(ReadGltf, CutsNamesThatAreLong) {
  GlbWriter file = triangleFile();
  std::string name(255, 'a');
  file.nodes[0] = R"({"mesh":0,"name":")" + name + "\xC3\xA4" + std::string(5000, 'b') + "\"}";
  EXPECT_EQ(readGltf(file.glb()).parts[0].name, name);
}

TEST(ReadGltf, TakesWholeNumbersHoweverTheyAreWritten) {
  GlbWriter file = triangleFile();
  file.nodes[0] = R"({"mesh":0.0,"scale":[1.0,1e0,1]})";
  file.accessors[0] = R"({"bufferView":0,"componentType":5126,"count":0.3e1,"type":"VEC3"})";
  file.bufferViews[0] = R"({"buffer":0e5,"byteLength":36.0,"byteStride":0})";
  EXPECT_EQ(readGltf(file.glb()).triangles, (Triangles{0, 1, 2}));
}

TEST(ReadGltf, SkipsWhatTrianglesDoNotNeedWhateverItIs) {
  GlbWriter file = triangleFile();
  file.nodes[0] = R"({"mesh":0,"camera":-7,"extras":{"mesh":-1,"nodes[]":[{}]},"nodes[].mesh":-1,)"
                  R"("extensions":{"EXT_other":{"attributes":{"TRANSLATION":-1}}}})";
  file.more = R"(,"nodes[]":3,"":[[{"":null}]],"materials":-1,"extensions":[-1.5])";
  EXPECT_EQ(readGltf(file.glb()).triangles, (Triangles{0, 1, 2}));
}

TEST(ReadGltf, IsNotKeptFromTrianglesByBrokenThingsBesideThem) {
  GlbWriter file = triangleFile();
  file.more =
      R"(,"images":[{"bufferView":77},{"uri":"missing.png"},3],"materials":[{"a":[{}]}, 5],)"
      R"("textures":7,"animations":[{}],"skins":[{}],"cameras":[{"type":"x"}],)"
      R"("extensions":{"KHR_lights_punctual":{"lights":[{}]}},"samplers":[1])";
  EXPECT_EQ(readGltf(file.glb()).triangles, (Triangles{0, 1, 2}));
}

TEST(ReadGltf, PassesOnCoordinatesThatAreNotFinite) {
  GlbWriter file;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const int positions = file.addPositions({nan, 0, 0, 1, 0, 0, 0, 1, 0});
  EXPECT_TRUE(std::isnan(readPrimitive(file, positions).positions[0]));
}

/// A primitive of the triangle with these attributes besides.
std::string dressed(int positions, int normals, int uvs) {
  return R"({"attributes":{"POSITION":)" + std::to_string(positions) + R"(,"NORMAL":)" +
         std::to_string(normals) + R"(,"TEXCOORD_0":)" + std::to_string(uvs) + "}}";
}

TEST(ReadGltf, ReadsNormalsAndTextureCoordinates) {
  GlbWriter file;
  const int positions = file.addPositions(kTriangle);
  const int normals = file.addPositions({0, 0, 1, 3, 0, 4, 0, 0, 0});
  const int uvs =
      file.addAccessor(file.addView(std::vector<float>{0, 1, 2, 3, 4, 5}), kFloat, 3, "VEC2");
  file.addMesh({GlbWriter::primitive(positions), dressed(positions, normals, uvs)});
  // Flattened to half and mirrored: normals lean towards the axis, away from the other side.
  file.addNode(R"("mesh":0,"scale":[1,1,-0.5])");
  const GltfScene scene = readGltf(file.glb());
  EXPECT_EQ(scene.uvs, (Positions{0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5}));
  ASSERT_EQ(scene.normals.size(), 18u);
  const double length = std::sqrt(73.0);
  const Positions expected = {0, 0, 0,  0,          0, 0,           0, 0, 0,
                              0, 0, -1, 3 / length, 0, -8 / length, 0, 0, 0};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(scene.normals[i], expected[i], 1e-15) << i;
  EXPECT_TRUE(readGltf(triangleFile().glb()).normals.empty());
  EXPECT_TRUE(readGltf(triangleFile().glb()).uvs.empty());
}

TEST(ReadGltf, PassesOverAttributesThatItCannotRead) {
  GlbWriter file;
  const int positions = file.addPositions(kTriangle);
  const int tooFew = file.addPositions({0, 0, 1});
  file.addMesh({dressed(positions, tooFew, 77)});
  const GltfScene scene = readGltf(file.glb());
  EXPECT_EQ(scene.triangles, (Triangles{0, 1, 2}));
  EXPECT_TRUE(scene.normals.empty());
  EXPECT_EQ(scene.notes,
            (std::vector<std::string>{
                "normals or texture coordinates that cannot be read were passed over (2)"}));
}

// --- Accessors -----------------------------------------------------------------------------------

TEST(ReadGltf, ReadsInterleavedElementsFromAnOffset) {
  GlbWriter file;
  const int view =
      file.addView(std::vector<float>{9, 9, /**/ 0, 0, 0, 9, /**/ 1, 0, 0, 9, /**/ 0, 1, 0},
                   R"(,"byteStride":16)");
  const int positions = file.addAccessor(view, kFloat, 3, "VEC3", R"(,"byteOffset":8)");
  EXPECT_EQ(readPrimitive(file, positions).positions,
            Positions(kTriangle.begin(), kTriangle.end()));
}

TEST(ReadGltf, AppliesSparseElements) {
  GlbWriter file;
  const int indices = file.addView(std::vector<std::uint8_t>{1, 2});
  const int values = file.addView(std::vector<float>{5, 0, 0, 0, 6, 0});
  const std::string sparse = R"(,"sparse":{"count":2,"indices":{"bufferView":)" +
                             std::to_string(indices) + R"(,"componentType":5121},"values":{)" +
                             R"("bufferView":)" + std::to_string(values) + "}}";
  const int overZeros = file.addAccessor(-1, kFloat, 3, "VEC3", sparse);
  const int overView = file.addAccessor(file.addView(std::vector<float>{7, 7, 7, 7, 7, 7, 7, 7, 7}),
                                        kFloat, 3, "VEC3", sparse);
  file.addMesh({GlbWriter::primitive(overZeros), GlbWriter::primitive(overView)});
  EXPECT_EQ(readGltf(file.glb()).positions,
            (Positions{0, 0, 0, 5, 0, 0, 0, 6, 0, 7, 7, 7, 5, 0, 0, 0, 6, 0}));
}

TEST(ReadGltf, TakesAnAccessorWithoutBufferViewForZeros) {
  GlbWriter file;
  EXPECT_EQ(readPrimitive(file, file.addAccessor(-1, kFloat, 3, "VEC3")).positions,
            Positions(9, 0.0));
}

TEST(ReadGltf, ReadsSparseIndices) {
  GlbWriter file;
  file.addPositions(kTriangle);
  const int places = file.addView(std::vector<std::uint8_t>{1, 2});
  const int indices = file.addAccessor(
      -1, kUnsignedByte, 3, "SCALAR",
      R"(,"sparse":{"count":2,"indices":{"bufferView":)" + std::to_string(places) +
          R"(,"componentType":5121},"values":{"bufferView":)" + std::to_string(places) + "}}");
  EXPECT_EQ(readPrimitive(file, 0, indices).triangles, (Triangles{0, 1, 2}));
}

TEST(ReadGltf, ReadsQuantizedPositions) {
  const auto read = [](auto numbers, int componentType, const std::string& members) {
    GlbWriter file;
    file.more = R"(,"extensionsRequired":["KHR_mesh_quantization"])";
    const int view = file.addView(
        numbers, R"(,"byteStride":)" + std::to_string(numbers.size() / 3 * sizeof numbers[0]));
    return readPrimitive(file, file.addAccessor(view, componentType, 3, "VEC3", members)).positions;
  };
  const std::string normalized = R"(,"normalized":true)";
  EXPECT_EQ(read(std::vector<std::int8_t>{0, 127, -128, 0, -127, 64, 1, 0, 0, 0, 0, 0}, kByte,
                 normalized),
            (Positions{0, 1, -1, -1, 64 / 127.0, 1 / 127.0, 0, 0, 0}));
  EXPECT_EQ(read(std::vector<std::uint8_t>{0, 255, 51, 0, 0, 0, 0, 0, 0, 0, 0, 0}, kUnsignedByte,
                 normalized),
            (Positions{0, 1, 0.2, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(read(std::vector<std::int16_t>{-32768, 32767, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, kShort,
                 normalized),
            (Positions{-1, 1, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(
      read(std::vector<std::uint16_t>{0, 65535, 7, 0, 1, 0, 0, 0, 0, 0, 0, 0}, kUnsignedShort, ""),
      (Positions{0, 65535, 7, 1, 0, 0, 0, 0, 0}));
}

// --- Containers and buffers ----------------------------------------------------------------------

const Triangles kOneTriangle = {0, 1, 2};

TEST(ReadGltf, ReadsJsonWithADataUri) {
  EXPECT_EQ(readGltf(triangleFile().gltf()).triangles, kOneTriangle);
}

TEST(ReadGltf, ReadsEveryWayOfWritingADataUri) {
  const GlbWriter file = triangleFile();
  const std::string content = base64(file.bin);
  std::string percentEncoded, withoutPadding = content.substr(0, content.find('='));
  for (char c : content) percentEncoded += c == '=' ? std::string("%3d") : std::string(1, c);
  std::string allEncoded;
  constexpr char kHex[] = "0123456789ABCDEF";
  for (std::byte b : file.bin) {
    const int value = std::to_integer<int>(b);
    allEncoded += std::string("%") + kHex[value / 16] + kHex[value % 16];
  }
  const Positions expected(kTriangle.begin(), kTriangle.end());
  for (const std::string& uri :
       {"data:;base64," + content, "data:application/gltf-buffer;base64," + content,
        "data:text/plain;charset=utf-8;base64," + content, "DATA:;base64," + content,
        "data:;base64," + percentEncoded, "data:;base64," + withoutPadding,
        "data:;base64," + content.substr(0, 7) + " \\n" + content.substr(7),
        "data:," + allEncoded}) {
    EXPECT_EQ(readGltf(bytesOf(file.json(uri))).positions, expected) << uri;
  }
}

TEST(ReadGltf, FindsBuffersAmongTheResources) {
  const GlbWriter file = triangleFile();
  ByteVector longer = file.bin;
  longer.push_back(std::byte{1});
  const std::vector<GltfResource> resources = {{"other.bin", {}}, {"my buffer.bin", longer}};
  EXPECT_EQ(readGltf(bytesOf(file.json("my%20buffer.bin")), resources).triangles, kOneTriangle);
  EXPECT_EQ(readGltf(bytesOf(file.json("my buffer.bin")), resources).triangles, kOneTriangle);
}

TEST(ReadGltf, NeedsOnlyTheBuffersOfTriangles) {
  GlbWriter file = triangleFile();
  file.buffers = R"({"byteLength":36},{"byteLength":9,"uri":"missing.bin"},{"byteLength":0})";
  EXPECT_EQ(readGltf(file.glb()).triangles, kOneTriangle);
}

TEST(ReadGltf, PassesOverAByteOrderMarkAndSpace) {
  const std::string text = triangleFile().json("data:;base64," + base64(triangleFile().bin));
  EXPECT_EQ(readGltf(bytesOf("\xEF\xBB\xBF \r\n" + text)).triangles, kOneTriangle);
}

TEST(ReadGltf, ReadsAGlbThatIsFollowedByOtherBytes) {
  ByteVector bytes = triangleFile().glb();
  bytes.resize(bytes.size() + 5);
  EXPECT_EQ(readGltf(bytes).triangles, kOneTriangle);
}

TEST(ReadGltf, ReadsAGlbWhoseBufferIsElsewhere) {
  const GlbWriter file = triangleFile();
  const std::vector<GltfResource> resources = {{"a.bin", file.bin}};
  EXPECT_EQ(readGltf(glbOf(file.json("a.bin"), {}), resources).triangles, kOneTriangle);
}

TEST(ReadGltf, AcceptsRequiredExtensionsThatLeaveTrianglesAlone) {
  GlbWriter file = triangleFile();
  file.more = R"(,"extensionsRequired":["KHR_materials_unlit","KHR_texture_transform",)"
              R"("EXT_texture_webp","KHR_lights_punctual"])";
  EXPECT_EQ(readGltf(file.glb()).triangles, kOneTriangle);
}

// --- Errors: every one names what is wrong -------------------------------------------------------

TEST(ReadGltfErrors, NameAFileOfAnotherKind) {
  EXPECT_EQ(errorOf(""), "the file is empty");
  EXPECT_EQ(errorOf("ply\nformat ascii 1.0"), "this is neither GLB nor glTF JSON");
  EXPECT_EQ(errorOf("  \n"), "this is neither GLB nor glTF JSON");
  EXPECT_EQ(errorOf("[]"), "this is neither GLB nor glTF JSON");
  EXPECT_EQ(errorOf("{}"), "the JSON has no asset.version, so it is not a glTF");
  EXPECT_EQ(errorOf(R"({"asset":[]})"), "the JSON has no asset.version, so it is not a glTF");
  EXPECT_EQ(errorOf(R"({"asset":)"), "the JSON is malformed at byte 10");
  EXPECT_EQ(errorOf("{\"asset\":{\"version\":\"\xFF\"}}"), "the JSON is malformed at byte 22");
  EXPECT_EQ(errorOf(R"({"asset":{"version":1e999}})"), "the JSON has a number that is too large");
}

TEST(ReadGltfErrors, NameAnotherVersion) {
  EXPECT_EQ(errorOf(R"({"asset":{"version":"1.1"}})"),
            R"(this is glTF version "1.1"; only version 2.0 is read)");
  EXPECT_EQ(errorOf(R"({"asset":{"version":"2.1","minVersion":"2.1"}})"),
            R"(this is glTF version "2.1"; only version 2.0 is read)");
  ByteVector bytes = triangleFile().glb();
  bytes[4] = std::byte{1};
  EXPECT_EQ(errorOf(bytes), "this is GLB version 1; only version 2 is read");
}

TEST(ReadGltfErrors, NameATruncatedFile) {
  const ByteVector bytes = triangleFile().glb();
  const std::string size = std::to_string(bytes.size());
  EXPECT_EQ(errorOf(std::span(bytes).first(bytes.size() - 1)),
            "the GLB is truncated: it should have " + size + " bytes but has " +
                std::to_string(bytes.size() - 1));
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_NE(errorOf(std::span(bytes).first(length)), "") << length;
  }
  const ByteVector text = triangleFile().gltf();
  for (std::size_t length = 0; length < text.size(); ++length) {
    EXPECT_NE(errorOf(std::span(text).first(length)), "") << length;
  }
}

TEST(ReadGltfErrors, NameBrokenChunks) {
  ByteVector bytes = triangleFile().glb();
  bytes[16] = std::byte{'X'};
  EXPECT_EQ(errorOf(bytes), "the GLB does not begin with a JSON chunk");
  bytes = triangleFile().glb();
  bytes[15] = std::byte{0x7F};
  EXPECT_EQ(errorOf(bytes), "a chunk of the GLB reaches past its end");
  bytes = triangleFile().glb();
  for (int i = 8; i < 12; ++i) bytes[i] = std::byte{0};
  EXPECT_EQ(errorOf(bytes), "the GLB does not begin with a JSON chunk");
}

/// Of compressed data.
const std::string kRemedy =
    ", which is not decompressed here: save the model without it, or open it with the JavaScript "
    "library or the command geodesic-voronoi";

TEST(ReadGltfErrors, NameRequiredExtensions) {
  const auto error = [](const std::string& extension) {
    return errorAfter(
        [&](GlbWriter& file) { file.more = ",\"extensionsRequired\":[\"" + extension + "\"]"; });
  };
  EXPECT_EQ(error("KHR_draco_mesh_compression"),
            "the glTF requires the extension KHR_draco_mesh_compression" + kRemedy);
  EXPECT_EQ(error("EXT_meshopt_compression"),
            "the glTF requires the extension EXT_meshopt_compression" + kRemedy);
  EXPECT_EQ(error("VENDOR_magic"),
            "the glTF requires the extension VENDOR_magic, which is not supported");
}

TEST(ReadGltfErrors, NameACompressedPrimitiveThatRequiresNothing) {
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              file.accessors[0] = R"({"componentType":5126,"count":3,"type":"VEC3"})";
              file.meshes[0] = R"({"primitives":[{"attributes":{"POSITION":0},"extensions":{)"
                               R"("KHR_draco_mesh_compression":{"bufferView":0}}}]})";
            }),
            "primitive 0 of mesh 0 is compressed with KHR_draco_mesh_compression" + kRemedy);
}

TEST(ReadGltfErrors, NameMissingBuffers) {
  const GlbWriter file = triangleFile();
  EXPECT_EQ(errorOf(bytesOf(file.json("../secret.bin"))),
            "it needs the file \"../secret.bin\" (buffer 0), which is missing");
  EXPECT_EQ(errorOf(file.json()), "buffer 0 has no uri, and there is no binary chunk for it");
  EXPECT_EQ(errorOf(bytesOf(file.json("data:;base64"))), "buffer 0 has a data URI without content");
  EXPECT_EQ(errorOf(bytesOf(file.json("data:;base64,AA*A"))),
            "buffer 0 has a data URI that is not base64");
  EXPECT_EQ(errorOf(bytesOf(file.json("data:;base64,AAAA"))),
            "buffer 0 should have 36 bytes but has 3");
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.buffers = R"({"byteLength":37})"; }),
            "buffer 0 should have 37 bytes but has 36");
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.buffers = R"({"byteLength":-1})"; }),
            "buffers[0].byteLength is -1; it must be a whole number from 0 to 4294967295");
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.buffers = "{}"; }), "buffer 0 has no byteLength");
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.buffers = "7"; }),
            "buffers[0] is 7; it must be an object");
}

TEST(ReadGltfErrors, NameABufferThatStandsForCompressedData) {
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              file.buffers = R"({"byteLength":36},{"byteLength":36,"extensions":{)"
                             R"("EXT_meshopt_compression":{"fallback":true}}})";
              file.bufferViews[0] = R"({"buffer":1,"byteLength":36})";
            }),
            "buffer 1 stands for data compressed with EXT_meshopt_compression" + kRemedy);
}

TEST(ReadGltfErrors, GiveTheBinaryChunkToTheFirstBufferOnly) {
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              file.buffers = R"({"byteLength":36},{"byteLength":36})";
              file.bufferViews[0] = R"({"buffer":1,"byteLength":36})";
            }),
            "buffer 1 has no uri, and there is no binary chunk for it");
}

TEST(ReadGltfErrors, NameBytesOutOfBounds) {
  const auto view = [](const std::string& members) {
    return errorAfter(
        [&](GlbWriter& file) { file.bufferViews[0] = "{\"buffer\":0," + members + "}"; });
  };
  EXPECT_EQ(view(R"("byteLength":37)"), "buffer view 0 reaches past the end of buffer 0");
  EXPECT_EQ(view(R"("byteLength":36,"byteOffset":1)"),
            "buffer view 0 reaches past the end of buffer 0");
  EXPECT_EQ(view(R"("byteLength":36,"byteOffset":4294967295)"),
            "buffer view 0 reaches past the end of buffer 0");
  EXPECT_EQ(view(R"("byteLength":35)"), "accessor 0 reaches past the end of buffer view 0");
  EXPECT_EQ(view(R"("byteLength":36,"byteStride":16)"),
            "accessor 0 reaches past the end of buffer view 0");
  EXPECT_EQ(view(R"("byteLength":36,"byteStride":8)"),
            "buffer view 0 has a byteStride less than the elements of accessor 0");

  const auto accessor = [](const std::string& members) {
    return errorAfter([&](GlbWriter& file) {
      file.accessors[0] = R"({"bufferView":0,"componentType":5126,"type":"VEC3",)" + members + "}";
    });
  };
  EXPECT_EQ(accessor(R"("count":4)"), "accessor 0 reaches past the end of buffer view 0");
  EXPECT_EQ(accessor(R"("count":3,"byteOffset":4)"),
            "accessor 0 reaches past the end of buffer view 0");
  EXPECT_EQ(accessor(R"("count":3,"byteOffset":4294967292)"),
            "accessor 0 reaches past the end of buffer view 0");
  EXPECT_EQ(accessor(R"("count":1000000)"), "accessor 0 reaches past the end of buffer view 0");
  EXPECT_EQ(accessor(R"("count":4294967295)"),
            "the scene has more than 16777216 vertices; raise the limit maxVertices to read it");
}

TEST(ReadGltfErrors, NameNumbersThatAreNotWhatTheyMustBe) {
  struct Case {
    const char* path;
    const char* range;
    std::function<void(GlbWriter&, const std::string&)> set;
  };
  const char* index = "a whole number from 0 to 2147483647";
  const char* size = "a whole number from 0 to 4294967295";
  const auto sparse = [](const std::string& count, const std::string& ofIndices,
                         const std::string& ofValues) {
    return R"({"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":)" + count +
           R"(,"indices":{"bufferView":0,"componentType":5121)" + ofIndices +
           R"(},"values":{"bufferView":0)" + ofValues + "}}}";
  };
  const Case cases[] = {
      {"scene", index, [](GlbWriter& f, const std::string& x) { f.more = ",\"scene\":" + x; }},
      {"scenes[0].nodes[1]", index,
       [](GlbWriter& f, const std::string& x) { f.scenes = {"{\"nodes\":[0," + x + "]}"}; }},
      {"nodes[0].mesh", index,
       [](GlbWriter& f, const std::string& x) { f.nodes[0] = "{\"mesh\":" + x + '}'; }},
      {"nodes[0].skin", index,
       [](GlbWriter& f, const std::string& x) { f.nodes[0] = "{\"mesh\":0,\"skin\":" + x + '}'; }},
      {"nodes[1].children[0]", index,
       [](GlbWriter& f, const std::string& x) { f.addNode("\"children\":[" + x + ']'); }},
      {"nodes[0].extensions.EXT_mesh_gpu_instancing.attributes.SCALE", index,
       [](GlbWriter& f, const std::string& x) {
         f.nodes[0] =
             R"({"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"SCALE":)" + x + "}}}}";
       }},
      {"meshes[0].primitives[0].attributes.POSITION", index,
       [](GlbWriter& f, const std::string& x) {
         f.meshes[0] = R"({"primitives":[{"attributes":{"POSITION":)" + x + "}}]}";
       }},
      {"meshes[0].primitives[0].indices", index,
       [](GlbWriter& f, const std::string& x) {
         f.meshes[0] = R"({"primitives":[{"attributes":{"POSITION":0},"indices":)" + x + "}]}";
       }},
      {"meshes[0].primitives[0].mode", index,
       [](GlbWriter& f, const std::string& x) {
         f.meshes[0] = R"({"primitives":[{"attributes":{"POSITION":0},"mode":)" + x + "}]}";
       }},
      {"meshes[0].primitives[0].targets[0].POSITION", index,
       [](GlbWriter& f, const std::string& x) {
         f.meshes[0] =
             R"({"primitives":[{"attributes":{"POSITION":0},"targets":[{"POSITION":)" + x + "}]}]}";
       }},
      {"accessors[0].bufferView", index,
       [](GlbWriter& f, const std::string& x) {
         f.accessors[0] =
             R"({"componentType":5126,"count":3,"type":"VEC3","bufferView":)" + x + '}';
       }},
      {"accessors[0].componentType", index,
       [](GlbWriter& f, const std::string& x) {
         f.accessors[0] = R"({"bufferView":0,"count":3,"type":"VEC3","componentType":)" + x + '}';
       }},
      {"accessors[0].byteOffset", size,
       [](GlbWriter& f, const std::string& x) {
         f.accessors[0] =
             R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","byteOffset":)" + x +
             '}';
       }},
      {"accessors[0].count", size,
       [](GlbWriter& f, const std::string& x) {
         f.accessors[0] =
             R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":)" + x + '}';
       }},
      {"accessors[0].sparse.count", size,
       [&](GlbWriter& f, const std::string& x) { f.accessors[0] = sparse(x, "", ""); }},
      {"accessors[0].sparse.indices.byteOffset", size,
       [&](GlbWriter& f, const std::string& x) {
         f.accessors[0] = sparse("1", ",\"byteOffset\":" + x, "");
       }},
      {"accessors[0].sparse.values.byteOffset", size,
       [&](GlbWriter& f, const std::string& x) {
         f.accessors[0] = sparse("1", "", ",\"byteOffset\":" + x);
       }},
      {"accessors[0].sparse.values.bufferView", index,
       [&](GlbWriter& f, const std::string& x) {
         f.accessors[0] = sparse("1", "", ",\"bufferView\":" + x);
       }},
      {"bufferViews[0].buffer", index,
       [](GlbWriter& f, const std::string& x) {
         f.bufferViews[0] = R"({"byteLength":36,"buffer":)" + x + '}';
       }},
      {"bufferViews[0].byteOffset", size,
       [](GlbWriter& f, const std::string& x) {
         f.bufferViews[0] = R"({"buffer":0,"byteLength":36,"byteOffset":)" + x + '}';
       }},
      {"bufferViews[0].byteLength", size,
       [](GlbWriter& f, const std::string& x) {
         f.bufferViews[0] = R"({"buffer":0,"byteLength":)" + x + '}';
       }},
      {"buffers[0].byteLength", size,
       [](GlbWriter& f, const std::string& x) { f.buffers = "{\"byteLength\":" + x + '}'; }},
  };
  for (const Case& c : cases) {
    for (const char* value : {"-1", "-4", "4294967296", "9007199254740992", "18446744073709551615",
                              "18446744073709551616", "0.5", "-0.25", "1e300", "null", "true"}) {
      EXPECT_EQ(errorAfter([&](GlbWriter& file) { c.set(file, value); }),
                std::string(c.path) + " is " + value + "; it must be " + c.range);
    }
    EXPECT_EQ(errorAfter([&](GlbWriter& file) { c.set(file, "\"1\""); }),
              std::string(c.path) + " is a string; it must be " + c.range);
    EXPECT_EQ(errorAfter([&](GlbWriter& file) { c.set(file, "[0]"); }),
              std::string(c.path) + " is an array; it must be " + c.range);
  }
}

TEST(ReadGltfErrors, NameAStrideThatIsNone) {
  for (const char* stride : {"2", "11", "-12", "1000000000", "256", "4.5"}) {
    EXPECT_EQ(errorAfter([&](GlbWriter& file) {
                file.bufferViews[0] =
                    std::string(R"({"buffer":0,"byteLength":36,"byteStride":)") + stride + '}';
              }),
              std::string("bufferViews[0].byteStride is ") + stride +
                  "; it must be a multiple of 4 from 0 to 252");
  }
}

TEST(ReadGltfErrors, NameValuesOfAnotherKind) {
  EXPECT_EQ(errorOf(R"({"asset":{"version":"2.0"},"nodes":{}})"),
            "nodes is an object; it must be an array");
  EXPECT_EQ(errorOf(R"({"asset":{"version":"2.0"},"nodes":[{},[]]})"),
            "nodes[1] is an array; it must be an object");
  EXPECT_EQ(errorOf(R"({"asset":{"version":"2.0"},"nodes":[{"matrix":"no"}]})"),
            "nodes[0].matrix is a string; it must be an array");
  EXPECT_EQ(errorOf(R"({"asset":{"version":"2.0"},"nodes":[{},{"scale":[1,null,1]}]})"),
            "nodes[1].scale[1] is null; it must be a number");
  EXPECT_EQ(errorOf(R"({"asset":{"version":"2.0"},"accessors":[{"normalized":1}]})"),
            "accessors[0].normalized is 1; it must be true or false");
  EXPECT_EQ(errorOf(R"({"asset":{"version":"1.0"},"nodes":{},"scene":"main"})"),
            R"(this is glTF version "1.0"; only version 2.0 is read)")
      << "which is what explains the rest";
}

TEST(ReadGltfErrors, NameNumbersThatAreMisaligned) {
  const auto error = [](int ofView, int ofAccessor) {
    return errorAfter([&](GlbWriter& file) {
      file.addPositions(kTriangle);
      file.bufferViews[0] =
          R"({"buffer":0,"byteLength":40,"byteOffset":)" + std::to_string(ofView) + '}';
      file.accessors[0] =
          R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","byteOffset":)" +
          std::to_string(ofAccessor) + '}';
    });
  };
  EXPECT_EQ(error(0, 2),
            "accessor 0 begins at byte 2 of its buffer, which is not a multiple of 4, the size of "
            "its numbers");
  EXPECT_EQ(error(1, 0),
            "accessor 0 begins at byte 1 of its buffer, which is not a multiple of 4, the size of "
            "its numbers");
}

TEST(ReadGltfErrors, LimitWhatASmallFileCanAskFor) {
  const auto more = [](const char* than, const char* limit) {
    return "the scene has more than " + std::string(than) + "; raise the limit " + limit +
           " to read it";
  };
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              file.accessors[0] = R"({"componentType":5126,"count":1000000000,"type":"VEC3"})";
            }),
            more("16777216 vertices", "maxVertices"));
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              file.accessors[0] = R"({"componentType":5126,"count":50000000,"type":"VEC3"})";
              for (int n = 1; n < 5000; ++n) file.addNode(R"("mesh":0)");
            }),
            more("16777216 vertices", "maxVertices"))
      << "5,000 times 50 M zeros";
  const std::string zeros =
      more("1048576 elements in accessors without a buffer view", "maxZeroElements");
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              file.accessors[0] = R"({"componentType":5126,"count":1048577,"type":"VEC3"})";
            }),
            zeros);
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              file.accessors[0] = R"({"componentType":5126,"count":1048576,"type":"VEC3"})";
              file.addNode(R"("mesh":0)");
            }),
            zeros)
      << "two nodes together";
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              const int indices = file.addAccessor(-1, kUnsignedByte, 1048577, "SCALAR");
              file.meshes[0] = R"({"primitives":[)" + GlbWriter::primitive(0, indices) + "]}";
            }),
            zeros);
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              const int moves = file.addAccessor(-1, kFloat, 262145, "VEC3");
              file.addPositions(std::vector<float>(30));
              file.meshes[0] = R"({"primitives":[)" + GlbWriter::primitive(moves + 1) + "]}";
              file.nodes[0] = R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{)"
                              R"("TRANSLATION":1}}}})";
            }),
            more("262144 primitives and morph targets, instances included", "maxObjects"));
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              const int moves = file.addAccessor(-1, kFloat, 130000, "VEC3");
              file.addPositions(std::vector<float>(30));
              file.meshes[0] = R"({"primitives":[)" + GlbWriter::primitive(moves + 1) + "]}";
              file.nodes[0] = R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{)"
                              R"("TRANSLATION":1}}}})";
            }),
            zeros)
      << "ten vertices in 130,000 places that cost nothing";
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              const int indices = file.addIndices<std::uint8_t>(kUnsignedByte, {0, 1, 2});
              file.accessors[indices] =
                  R"({"bufferView":0,"componentType":5121,"count":1000000000,"type":"SCALAR"})";
              file.meshes[0] = R"({"primitives":[)" + GlbWriter::primitive(0, indices) + "]}";
            }),
            more("16777216 triangles", "maxTriangles"));
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              std::string primitive = R"({"attributes":{"POSITION":0},"targets":[)";
              std::string weights = "1";
              for (int t = 0; t < 99999; ++t) {
                primitive += R"({"POSITION":0},)";
                weights += ",1";
              }
              file.meshes[0] =
                  R"({"primitives":[)" + primitive + "{}]}],\"weights\":[" + weights + "]}";
              for (int n = 1; n < 60; ++n) file.addNode(R"("mesh":0)");
            }),
            more("262144 primitives and morph targets, instances included", "maxObjects"));
}

TEST(ReadGltfErrors, LimitTheJson) {
  const std::string start = R"({"asset":{"version":"2.0"},)";
  const auto repeated = [](const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text + ',';
    return '[' + all + text + ']';
  };
  const std::string tooManyObjects =
      "the glTF has more than 262144 nodes, meshes, accessors and other objects; raise "
      "the limit maxObjects to read it";
  EXPECT_EQ(errorOf(start + R"("nodes":)" + repeated("{}", 1000000) + '}'), tooManyObjects);
  EXPECT_EQ(errorOf(start + R"("meshes":[{"primitives":)" + repeated("{}", 1000000) + "}]}"),
            tooManyObjects);
  EXPECT_EQ(
      errorOf(start + R"("scenes":[{"nodes":)" + repeated("0", 9000000) + "}]}"),
      "the glTF has more than 8388608 elements of arrays; raise the limit maxObjects to read it");
  EXPECT_EQ(errorOf(start + R"("accessors":)" +
                    repeated(R"({"count":1,"type":"VEC3","byteOffset":0,"normalized":true,)"
                             R"("sparse":{"count":0,"indices":{"byteOffset":0},"values":{}}})",
                             250000) +
                    '}'),
            "the glTF has more than 2097152 members of objects; raise the limit maxObjects to "
            "read it");
  EXPECT_EQ(errorOf(start + R"("scenes":[{"nodes":)" + repeated("0", 8000000) +
                    R"(}],"nodes":[{}],"scene":0})"),
            "node 0 is in the scene twice");

  GlbWriter file = triangleFile();
  file.more =
      R"(,"materials":)" + repeated("{}", 3000000) + R"(,"extras":)" + repeated("[]", 10000);
  EXPECT_EQ(readGltf(file.glb()).triangles, kOneTriangle) << "what is skipped costs nothing";
}

TEST(ReadGltfErrors, EndWhereLimitsAreRaised) {
  GlbWriter file = triangleFile();
  file.addNode(R"("mesh":0)");
  const ByteVector bytes = file.glb();
  const auto error = [&](const GltfLimits& limits) -> std::string {
    try {
      readGltf(bytes, {}, limits);
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(error({.maxJsonBytes = 100}),
            "the JSON has " +
                std::to_string(file.json().size() + (4 - file.json().size() % 4) % 4) +
                " bytes, more than 100; raise "
                "the limit maxJsonBytes to read it");
  EXPECT_EQ(error({.maxObjects = 5}),
            "the glTF has more than 5 nodes, meshes, accessors and other objects; raise "
            "the limit maxObjects to read it");
  EXPECT_EQ(error({.maxVertices = 5}),
            "the scene has more than 5 vertices; raise the limit maxVertices to read it");
  EXPECT_EQ(error({.maxTriangles = 1}),
            "the scene has more than 1 triangles; raise the limit maxTriangles to read it");
  EXPECT_EQ(error({.maxObjects = 8, .maxVertices = 6, .maxTriangles = 2, .maxZeroElements = 0}),
            "none");
}

TEST(ReadGltfErrors, NameBrokenSparseAccessors) {
  const auto error = [](const std::string& count, const std::string& indices,
                        const std::string& values) {
    return errorAfter([&](GlbWriter& file) {
      file.addView(std::vector<std::uint8_t>{3});
      file.accessors[0] = R"({"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":)" +
                          count + ",\"indices\":{" + indices + "},\"values\":{" + values + "}}}";
    });
  };
  const std::string indices = R"("bufferView":1,"componentType":5121)";
  EXPECT_EQ(error("1", indices, R"("bufferView":0)"),
            "the sparse part of accessor 0 has the index 3 past its end");
  EXPECT_EQ(error("2", indices, R"("bufferView":0)"),
            "the sparse part of accessor 0 reaches past the end of buffer view 1");
  EXPECT_EQ(error("4", indices, R"("bufferView":0)"),
            "the sparse part of accessor 0 has more elements than the accessor itself");
  EXPECT_EQ(error("1", R"("bufferView":1,"componentType":5126)", R"("bufferView":0)"),
            "the sparse part of accessor 0 has component type 5126, which vertex indices cannot "
            "have");
  EXPECT_EQ(error("1", indices, R"("bufferView":8)"),
            "the sparse part of accessor 0 names buffer view 8, but the glTF has 2");
}

TEST(ReadGltfErrors, NameObjectsThatDoNotExist) {
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.bufferViews[0] = R"({"buffer":3,"byteLength":36})"; }),
            "buffer view 0 names buffer 3, but the glTF has 1");
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.bufferViews.clear(); }),
            "accessor 0 names buffer view 0, but the glTF has 0");
  EXPECT_EQ(errorAfter([](GlbWriter& f) {
              f.meshes[0] = R"({"primitives":[)" + GlbWriter::primitive(5) + "]}";
            }),
            "primitive 0 of mesh 0 names accessor 5, but the glTF has 1");
  EXPECT_EQ(errorAfter([](GlbWriter& f) {
              f.meshes[0] = R"({"primitives":[)" + GlbWriter::primitive(0, 5) + "]}";
            }),
            "primitive 0 of mesh 0 names accessor 5, but the glTF has 1");
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.nodes[0] = R"({"mesh":2147483647})"; }),
            "node 0 names mesh 2147483647, but the glTF has 1");
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.nodes[0] = R"({"children":[9]})"; }),
            "node 0 names node 9, but the glTF has 1");
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.more = R"(,"scene":0)"; }),
            "the glTF names scene 0, but the glTF has 0");
  EXPECT_EQ(errorAfter([](GlbWriter& f) {
              f.scenes = {R"({"nodes":[1]})"};
              f.more = R"(,"scene":0)";
            }),
            "the scene names node 1, but the glTF has 1");
}

TEST(ReadGltfErrors, NameWrongTypes) {
  const auto positions = [](const std::string& accessor) {
    return errorAfter([&](GlbWriter& file) { file.accessors[0] = accessor; });
  };
  EXPECT_EQ(positions(R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC2"})"),
            "accessor 0 has the wrong type for positions");
  EXPECT_EQ(positions(R"({"bufferView":0,"componentType":5125,"count":3,"type":"VEC3"})"),
            "accessor 0 has component type 5125, which positions cannot have");
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              file.meshes[0] = R"({"primitives":[)" + GlbWriter::primitive(0, 0) + "]}";
            }),
            "accessor 0 has the wrong type for vertex indices");
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              file.meshes[0] = R"({"primitives":[)" + GlbWriter::primitive(0, -1, 77) + "]}";
            }),
            "primitive 0 of mesh 0 has the unknown mode 77");
  EXPECT_EQ(errorAfter([](GlbWriter& file) { file.meshes[0] = R"({"primitives":[{}]})"; }),
            "the glTF is invalid: 'attributes' property is missing in Primitive");
}

TEST(ReadGltfErrors, NameAVertexIndexOutOfRange) {
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              file.addIndices<std::uint8_t>(kUnsignedByte, {0, 1, 3});
              file.meshes[0] = R"({"primitives":[)" + GlbWriter::primitive(0, 1) + "]}";
            }),
            "primitive 0 of mesh 0 has vertex index 3, but there are 3 positions");
}

TEST(ReadGltfErrors, NameBrokenTransforms) {
  const auto error = [](const std::string& member) {
    return errorAfter([&](GlbWriter& file) { file.nodes[0] = "{\"mesh\":0," + member + "}"; });
  };
  EXPECT_EQ(error(R"("matrix":[1,0,0])"), "nodes[0].matrix has 3 elements; it must have 16");
  EXPECT_EQ(error(R"("scale":[1,1])"), "nodes[0].scale has 2 elements; it must have 3");
  EXPECT_EQ(error(R"("translation":[1,2,3,4])"),
            "nodes[0].translation has 4 elements; it must have 3");
  EXPECT_EQ(error(R"("rotation":[0,0,0,0])"), "node 0 has a rotation of zeros");
}

TEST(ReadGltfErrors, NameANodeThatIsReachedTwice) {
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              file.nodes[0] = R"({"children":[1]})";
              file.addNode(R"("children":[0])");
              file.scenes = {R"({"nodes":[0]})"};
              file.more = R"(,"scene":0)";
            }),
            "node 0 is in the scene twice");
  EXPECT_EQ(errorAfter([](GlbWriter& file) { file.addNode(R"("children":[0,0])"); }),
            "node 0 is in the scene twice");
}

TEST(ReadGltfErrors, SayThatThereAreNoTriangles) {
  EXPECT_EQ(errorOf(R"({"asset":{"version":"2.0"}})"), "the scene has no triangles");
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              file.meshes[0] = R"({"primitives":[)" + GlbWriter::primitive(0, -1, kLines) + "]}";
            }),
            "the scene has no triangles; primitives of points or lines were passed over (1)");
}

TEST(ReadGltfErrors, EndDeepNestingBeforeItEndsTheStack) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "[";
    for (int i = 0; i < depth; ++i) text += "]";
    return text;
  };
  for (int depth : {1000, 100000}) {
    for (const char* member : {"extras", "extensions", "nodes"}) {
      EXPECT_EQ(errorOf(R"({"asset":{"version":"2.0"},")" + std::string(member) +
                        "\":" + nested(depth) + "}"),
                "the JSON is nested more than 128 levels deep");
    }
  }
  GlbWriter file = triangleFile();
  file.nodes[0] = R"({"mesh":0,"extras":)" + nested(100) + R"(,"extensions":{"a":)" + nested(100) +
                  R"(},"name":"[[[[\"{{{{"})";
  EXPECT_EQ(readGltf(file.glb()).parts[0].name, "[[[[\"{{{{") << "brackets in strings do not nest";
}

TEST(ReadGltfErrors, AreTheOnlyOutcomeOfAnyChangedByteButAScene) {
  GlbWriter file = triangleFile();
  file.addIndices<std::uint8_t>(kUnsignedByte, {0, 1, 2});
  file.meshes[0] = R"({"primitives":[)" + GlbWriter::primitive(0, 1) + "]}";
  file.nodes[0] = R"({"mesh":0,"scale":[1,2,3]})";
  const ByteVector bytes = file.glb();
  int scenes = 0, errors = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const char c : {'0', '9', '-', '"', '{', ']', ' ', '\xFF', '\0'}) {
      ByteVector changed = bytes;
      changed[i] = static_cast<std::byte>(c);
      try {
        readGltf(changed);
        ++scenes;
      } catch (const Error&) {
        ++errors;
      }
    }
  }
  EXPECT_GT(scenes, 0);
  EXPECT_GT(errors, 0);
}

}  // namespace
}  // namespace gvd
