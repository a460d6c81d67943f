// SPDX-License-Identifier: MIT
#include "gvd/gltf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "gltf_corpus.h"
#include "gvd/error.h"

namespace gvd {
namespace {

using Triangles = std::vector<int>;
using Positions = std::vector<double>;

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
            "primitive 0 of mesh 0: the number of elements of morph targets is 2, not that of "
            "positions, 3");
}

/// There was room for the vertices once more for every morph target, in all lists.
TEST(ReadGltf, TakesNoMemoryForMorphTargets) {
  GlbWriter file;
  file.addPositions(kTriangle);
  file.addPositions({0, 0, 1, 0, 0, 1, 0, 0, 1});
  file.addMesh({R"({"attributes":{"POSITION":0,"NORMAL":1},"targets":[{"POSITION":1}]})"},
               R"(,"weights":[1])");
  const GltfScene scene = readGltf(file.glb());
  EXPECT_EQ(scene.positions.capacity(), 9);
  EXPECT_EQ(scene.normals.capacity(), 9);
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

TEST(ReadGltf, ReadsDensities) {
  GlbWriter file;
  const int positions = file.addPositions(kTriangle);
  const int density =
      file.addAccessor(file.addView(std::vector<float>{2, 0.5, 3}), kFloat, 3, "SCALAR");
  const std::string dense = R"({"attributes":{"POSITION":)" + std::to_string(positions) +
                            R"(,"_DENSITY":)" + std::to_string(density) + "}}";
  file.addMesh({GlbWriter::primitive(positions), dense, GlbWriter::primitive(positions)});
  file.addNode(R"("mesh":0)");
  EXPECT_EQ(readGltf(file.glb()).density, (Positions{1, 1, 1, 2, 0.5, 3, 1, 1, 1}));
  EXPECT_TRUE(readGltf(triangleFile().glb()).density.empty());
}

TEST(ReadGltf, PassesOverAttributesThatItCannotRead) {
  GlbWriter file;
  const int positions = file.addPositions(kTriangle);
  const int tooFew = file.addPositions({0, 0, 1});
  file.addMesh({dressed(positions, tooFew, 77)});
  const GltfScene scene = readGltf(file.glb());
  EXPECT_EQ(scene.triangles, (Triangles{0, 1, 2}));
  EXPECT_TRUE(scene.normals.empty());
  EXPECT_EQ(
      scene.notes,
      (std::vector<std::string>{
          "normals, texture coordinates or densities that cannot be read were passed over (2)"}));
}

TEST(ReadGltf, DoesNotTakeTheBinaryChunkForADataUriThatIsTooShort) {
  GlbWriter file;
  const int positions = file.addAccessor(-1, kFloat, 3, "VEC3");
  const int view = file.addView(std::vector<float>(9));
  const int normals = file.addAccessor(view, kFloat, 3, "VEC3");
  const int uvs = file.addAccessor(view, kFloat, 3, "VEC2");
  file.buffers = R"({"byteLength":36,"uri":"data:;base64,AAAA"})";
  file.addMesh({dressed(positions, normals, uvs)});
  const GltfScene scene = readGltf(file.glb());
  EXPECT_TRUE(scene.normals.empty());
  EXPECT_TRUE(scene.uvs.empty());
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

TEST(ReadGltf, ReadsEveryWayOfWritingADataUri) {
  const GlbWriter file = triangleFile();
  const Positions expected(kTriangle.begin(), kTriangle.end());
  for (const auto& [name, uri] : dataUris(file.bin))
    EXPECT_EQ(readGltf(bytesOf(file.json(uri))).positions, expected) << name;
}

// --- Errors: those of files are in gltf_corpus.h -------------------------------------------------

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
