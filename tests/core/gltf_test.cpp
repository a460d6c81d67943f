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

TEST(ReadGltf, NotesWhatItDoesNotApply) {
  GlbWriter file;
  file.addMesh({R"({"attributes":{"POSITION":0},"targets":[{"POSITION":0}]})"});
  file.addPositions(kTriangle);
  file.addNode(R"("mesh":0,"skin":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{}}})");
  EXPECT_EQ(readGltf(file.glb()).notes,
            (std::vector<std::string>{"meshes with a skin were taken unposed (1)",
                                      "primitives with morph targets were taken without them (1)",
                                      "nodes with instances were taken once (1)"}));
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

TEST(ReadGltfErrors, NameRequiredExtensions) {
  const auto error = [](const std::string& extension) {
    return errorAfter(
        [&](GlbWriter& file) { file.more = ",\"extensionsRequired\":[\"" + extension + "\"]"; });
  };
  EXPECT_EQ(error("KHR_draco_mesh_compression"),
            "the glTF requires the extension KHR_draco_mesh_compression, which has to be "
            "decompressed before it is read here");
  EXPECT_EQ(error("EXT_meshopt_compression"),
            "the glTF requires the extension EXT_meshopt_compression, which has to be decompressed "
            "before it is read here");
  EXPECT_EQ(error("VENDOR_magic"),
            "the glTF requires the extension VENDOR_magic, which is not supported");
}

TEST(ReadGltfErrors, NameACompressedPrimitiveThatRequiresNothing) {
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              file.accessors[0] = R"({"componentType":5126,"count":3,"type":"VEC3"})";
              file.meshes[0] = R"({"primitives":[{"attributes":{"POSITION":0},"extensions":{)"
                               R"("KHR_draco_mesh_compression":{"bufferView":0}}}]})";
            }),
            "primitive 0 of mesh 0 is compressed with KHR_draco_mesh_compression, which has to be "
            "decompressed before it is read here");
}

TEST(ReadGltfErrors, NameMissingBuffers) {
  const GlbWriter file = triangleFile();
  EXPECT_EQ(errorOf(bytesOf(file.json("../secret.bin"))),
            "buffer 0 is in the file \"../secret.bin\", which is missing");
  EXPECT_EQ(errorOf(file.json()), "buffer 0 has no uri, and there is no binary chunk for it");
  EXPECT_EQ(errorOf(bytesOf(file.json("data:;base64"))), "buffer 0 has a data URI without content");
  EXPECT_EQ(errorOf(bytesOf(file.json("data:;base64,AA*A"))),
            "buffer 0 has a data URI that is not base64");
  EXPECT_EQ(errorOf(bytesOf(file.json("data:;base64,AAAA"))),
            "buffer 0 should have 36 bytes but has 3");
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.buffers = R"({"byteLength":37})"; }),
            "buffer 0 should have 37 bytes but has 36");
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.buffers = R"({"byteLength":-1})"; }),
            "buffer 0 has no valid byteLength");
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.buffers = "7"; }), "buffer 0 has no valid byteLength");
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
  EXPECT_EQ(view(R"("byteLength":36,"byteOffset":18446744073709551615)"),
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
  EXPECT_EQ(accessor(R"("count":3,"byteOffset":18446744073709551612)"),
            "accessor 0 reaches past the end of buffer view 0");
  EXPECT_EQ(accessor(R"("count":1000000)"), "accessor 0 reaches past the end of buffer view 0");
  EXPECT_EQ(accessor(R"("count":9223372036854775808)"),
            "the scene has more than 16777216 vertices or triangles");
}

TEST(ReadGltfErrors, LimitWhatASmallFileCanAskFor) {
  const std::string tooMany = "the scene has more than 16777216 vertices or triangles";
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              file.accessors[0] = R"({"componentType":5126,"count":1000000000,"type":"VEC3"})";
            }),
            tooMany);
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              const int rest = file.addAccessor(-1, kFloat, (1 << 24) - 2, "VEC3");
              file.addMesh({GlbWriter::primitive(rest)});
              file.addNode(R"("mesh":1)");
            }),
            tooMany)
      << "together with the first triangle's three";
  EXPECT_EQ(errorAfter([](GlbWriter& file) {
              const int indices = file.addIndices<std::uint8_t>(kUnsignedByte, {0, 1, 2});
              file.accessors[indices] =
                  R"({"bufferView":0,"componentType":5121,"count":1000000000,"type":"SCALAR"})";
              file.meshes[0] = R"({"primitives":[)" + GlbWriter::primitive(0, indices) + "]}";
            }),
            "accessor 1 has 1000000000 elements, which is too many");
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
  EXPECT_EQ(error("-1", indices, R"("bufferView":0)"),
            "the sparse part of accessor 0 has a negative count or offset");
  EXPECT_EQ(error("1", indices, R"("bufferView":0,"byteOffset":-4)"),
            "the sparse part of accessor 0 has a negative count or offset");
  EXPECT_EQ(error("1", R"("bufferView":1,"componentType":5126)", R"("bufferView":0)"),
            "the sparse part of accessor 0 has component type 5126, which vertex indices cannot "
            "have");
  EXPECT_EQ(error("1", indices, R"("bufferView":8)"),
            "the sparse part of accessor 0 names buffer view 8, but the glTF has 2");
}

TEST(ReadGltfErrors, NameObjectsThatDoNotExist) {
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.bufferViews[0] = R"({"buffer":3,"byteLength":36})"; }),
            "buffer view 0 names buffer 3, but the glTF has 1");
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.bufferViews[0] = R"({"buffer":-1,"byteLength":36})"; }),
            "buffer view 0 names buffer -1, but the glTF has 1");
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.bufferViews.clear(); }),
            "accessor 0 names buffer view 0, but the glTF has 0");
  EXPECT_EQ(errorAfter([](GlbWriter& f) {
              f.meshes[0] = R"({"primitives":[)" + GlbWriter::primitive(5) + "]}";
            }),
            "primitive 0 of mesh 0 names accessor 5, but the glTF has 1");
  EXPECT_EQ(errorAfter([](GlbWriter& f) { f.nodes[0] = R"({"mesh":-2})"; }),
            "node 0 names mesh -2, but the glTF has 1");
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
  EXPECT_EQ(error(R"("matrix":[1,0,0])"), "node 0 has a matrix that is not 16 finite numbers");
  EXPECT_EQ(error(R"("scale":[1,1])"), "node 0 has a scale that is not 3 finite numbers");
  EXPECT_EQ(error(R"("translation":[1,2,3,4])"),
            "node 0 has a translation that is not 3 finite numbers");
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
