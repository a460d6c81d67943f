// SPDX-License-Identifier: MIT
//
// Cases about all of a glTF: scenes, the surfaces they make, and how much of each a file may have.

#include <cstdint>
#include <limits>

#include "gltf_corpus.h"

namespace gvd {

void addSceneCases(GltfCases& cases) {
  const auto scenes = [](const std::string& list, const std::string& more) {
    return [=](GlbWriter& file) {
      file.scenes = {list};
      file.more = more;
    };
  };
  cases.opens("no scene: all roots", 2,
              [](GlbWriter& file) { file.addNode("\"mesh\":0,\"translation\":[9,0,0]"); });
  cases.opens("no node: all meshes", 1, [](GlbWriter& file) { file.nodes.clear(); });
  cases.opens("the default scene", 1, [](GlbWriter& file) {
    file.addNode("\"mesh\":0,\"translation\":[9,0,0]");
    file.scenes = {R"({"nodes":[]},{"nodes":[1]})"};
    file.more = R"(,"scene":1)";
  });
  cases.refused("empty scene", "the scene has no triangles", scenes("{}", R"(,"scene":0)"));
  cases.refused("only an asset", "the scene has no triangles",
                bytesOf(R"({"asset":{"version":"2.0"}})"));
  cases.refused("scene that is not there", "the glTF names scene 0, but the glTF has 0",
                [](GlbWriter& file) { file.more = R"(,"scene":0)"; });
  cases.refused("node of the scene that is not there", "the scene names node 1, but the glTF has 1",
                scenes(R"({"nodes":[1]})", R"(,"scene":0)"));
  cases.refused("mesh that is not there", "node 0 names mesh 2147483647, but the glTF has 1",
                node(R"("mesh":2147483647)"));
  cases.refused("child that is not there", "node 0 names node 9, but the glTF has 1",
                node(R"("children":[9])"));
  cases.refused("root twice", "node 0 is in the scene twice",
                scenes(R"({"nodes":[0,0]})", R"(,"scene":0)"));
  cases.refused("child twice", "node 0 is in the scene twice",
                [](GlbWriter& file) { file.addNode(R"("children":[0,0])"); });
  cases.refused("two parents", "node 0 is in the scene twice", [](GlbWriter& file) {
    file.addNode(R"("children":[0])");
    file.addNode(R"("children":[0])");
  });
  const auto cycle = [](GlbWriter& file) {
    file.nodes[0] = R"({"mesh":0,"children":[1]})";
    file.addNode(R"("children":[0])");
  };
  cases.refused("cycle in the scene", "node 0 is in the scene twice", [&](GlbWriter& file) {
    cycle(file);
    scenes(R"({"nodes":[0]})", R"(,"scene":0)")(file);
  });
  cases.refused("own child", "node 0 has no root above it: the nodes above it form a cycle",
                node(R"("mesh":0,"children":[0])"));
  cases.refused("cycle and no scene",
                "node 0 has no root above it: the nodes above it form a cycle", cycle);
  cases.refused("cycle beside a root",
                "node 1 has no root above it: the nodes above it form a cycle",
                [](GlbWriter& file) {
                  file.addNode(R"("children":[2])");
                  file.addNode(R"("children":[1],"mesh":0)");
                });
  cases.opens("cycle that the default scene does not reach", 1, [](GlbWriter& file) {
    file.addNode(R"("children":[2])");
    file.addNode(R"("children":[1],"mesh":0)");
    file.scenes = {R"({"nodes":[0]})"};
    file.more = R"(,"scene":0)";
  });
  cases.opens("20,000 nodes one below the other", 1, [](GlbWriter& file) {
    for (int n = 1; n <= 20000; ++n) {
      file.addNode("\"children\":[" + std::to_string(n - 1) + R"(],"translation":[1,0,0])");
    }
  });

  const auto transform = [&](const std::string& member, const std::string& sentence) {
    cases.refused(member, sentence, node("\"mesh\":0," + member));
  };
  transform(R"("matrix":[1,0,0])", "nodes[0].matrix has 3 elements; it must have 16");
  transform(R"("matrix":[])", "nodes[0].matrix has 0 elements; it must have 16");
  transform(R"("matrix":)" + repeated("0", 16), "nodes[0].matrix has 17 elements; it must have 16");
  transform(R"("matrix":[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]])",
            "nodes[0].matrix[0] is an array; it must be a number");
  transform(R"("matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2])",
            "node 0 has a matrix whose last row is not 0, 0, 0, 1");
  transform(R"("matrix":[1,0,0,0.5,0,1,0,0,0,0,1,0,0,0,0,1])",
            "node 0 has a matrix whose last row is not 0, 0, 0, 1");
  transform(R"("scale":[1,1])", "nodes[0].scale has 2 elements; it must have 3");
  transform(R"("scale":2)", "nodes[0].scale is 2; it must be an array");
  transform(R"("translation":[1,2,3,4])", "nodes[0].translation has 4 elements; it must have 3");
  transform(R"("rotation":[0,0,0])", "nodes[0].rotation has 3 elements; it must have 4");
  transform(R"("rotation":[0,0,0,0])", "node 0 has a rotation of zeros");
  const std::string none =
      "no triangle is left of 1: 0 with a corner that is not finite, 1 with two corners at one "
      "position";
  transform(R"("scale":[0,0,0])", none);
  transform(R"("scale":[1e300,1e300,1],"translation":[1e300,0,0])",
            "the positions are too far apart to measure distances");
  cases.opens("mirror", 1, node(R"("mesh":0,"scale":[1,1,-1])"));
  cases.opens("rotation that is not of unit length", 1, node(R"("mesh":0,"rotation":[3,0,0,4])"));
  cases.opens("matrix whose last row is rounded", 1,
              node(R"("mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,5,5,5,0.99999994])"));
  cases.opens("skin", 1, node(R"("mesh":0,"skin":7,"scale":[0,0,0])")).sentence =
      "meshes with a skin were taken unposed (1)";

  const auto instances = [](const std::string& attributes) {
    return [=](GlbWriter& file) {
      file.addPositions({0, 0, 0, 5, 0, 0});
      file.addPositions({1, 1, 1, 2, 2, -2, 3, 3, 3});
      file.nodes[0] = R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{)" +
                      attributes + "}}}}";
    };
  };
  cases.opens("instances", 2, instances(R"("TRANSLATION":1,"_COLOR":99)"));
  cases.opens("instances of no attribute", 1, instances(""));
  cases.refused("instances whose accessors differ",
                "node 0 has instances whose accessors differ in count",
                instances(R"("TRANSLATION":1,"SCALE":2)"));
  cases.refused("instances whose accessor is not there",
                "node 0 names accessor 9, but the glTF has 3", instances(R"("TRANSLATION":9)"));
  cases.refused("instances of another type", "accessor 1 has the wrong type for rotations",
                instances(R"("ROTATION":1)"));
}

void addSurfaceCases(GltfCases& cases) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const auto surface = [](const std::vector<float>& positions,
                          const std::vector<std::uint8_t>& indices) {
    return [=](GlbWriter& file) {
      const int places = file.addPositions(positions);
      primitives(GlbWriter::primitive(places, file.addIndices(kUnsignedByte, indices)))(file);
    };
  };
  const std::vector<float> square = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  for (const auto& [name, bad] : {std::pair("NaN", nan), std::pair("infinite", infinity)}) {
    std::vector<float> positions = square;
    positions[9] = bad;
    cases.opens("one vertex " + std::string(name), 1, surface(positions, {0, 1, 2, 0, 2, 3}));
    cases.refused(
        "all " + std::string(name),
        "no triangle is left of 1: 1 with a corner that is not finite, 0 with two corners at "
        "one position",
        surface({bad, 0, 0, bad, 1, 0, 0, 0, bad}, {0, 1, 2}));
  }
  cases.opens(
      "seams", 2,
      surface({0, 0, 0, 1, 0, 0, 1, 1, 0, -0.0f, 0, 0, 1, 1, -0.0f, 0, 1, 0}, {0, 1, 2, 3, 4, 5}));
  cases.opens("the same face twice, and turned over", 1,
              surface(square, {0, 1, 2, 0, 1, 2, 1, 0, 2}));
  cases.opens("faces of two corners", 1, surface(square, {0, 1, 2, 1, 1, 3}));
  cases.opens("a face without area", 2,
              surface({0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0}, {0, 1, 3, 0, 2, 1}));
  cases.opens("three faces at an edge", 3,
              surface({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1}, {0, 1, 2, 1, 0, 3, 0, 1, 4}));
  cases.opens("two fans at a vertex", 2,
              surface({0, 0, 0, 1, 0, 0, 1, 1, 0, -1, 0, 0, -1, -1, 0}, {0, 1, 2, 0, 3, 4}));
  cases.opens("opposed faces", 2, surface(square, {0, 1, 2, 0, 3, 2}));
  cases.opens("a Möbius strip", 6,
              surface({2, 0, 0, 3, 0, 1, -1, 2, 0, -2, 2, 1, -1, -2, 0, -2, -2, 1},
                      {0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4, 4, 5, 1, 5, 0, 1}));
  cases.opens("as small as floats are", 1,
              surface({0, 0, 0, 1e-38f, 0, 0, 0, 1e-38f, 0}, {0, 1, 2}));
  cases.opens("as large as floats are", 1, surface({0, 0, 0, 3e38f, 0, 0, 0, 3e38f, 0}, {0, 1, 2}));
  cases.opens("far from the origin", 1,
              surface({1e7f, 0, 0, 1e7f + 1, 0, 0, 1e7f, 1, 0}, {0, 1, 2}));
}

void addLimitCases(GltfCases& cases) {
  const auto more = [](const std::string& than, const std::string& limit) {
    return "the scene has more than " + than + "; raise the limit " + limit + " to read it";
  };
  const std::string vertices = more("16777216 vertices", "maxVertices");
  const std::string zeros =
      more("1048576 elements in accessors without a buffer view", "maxZeroElements");
  const std::string objects =
      more("262144 primitives and morph targets, instances included", "maxObjects");
  const auto zerosOf = [](int count) {
    return accessor(R"("componentType":5126,"type":"VEC3","count":)" + std::to_string(count));
  };
  cases.refused("10⁹ zeros", vertices, zerosOf(1000000000));
  cases.refused(
      "4 G positions", vertices,
      accessor(R"("bufferView":0,"componentType":5126,"type":"VEC3","count":4294967295)"));
  cases.refused("5,000 times 50 M zeros", vertices, [&](GlbWriter& file) {
    zerosOf(50000000)(file);
    for (int n = 1; n < 5000; ++n) file.addNode(R"("mesh":0)");
  });
  cases.refused("more zeros than are read", zeros, zerosOf(1048577));
  cases.refused("more zeros in two nodes", zeros, [&](GlbWriter& file) {
    zerosOf(1048576)(file);
    file.addNode(R"("mesh":0)");
  });
  cases.refused("more zeros as indices", zeros, [](GlbWriter& file) {
    primitives(GlbWriter::primitive(0, file.addAccessor(-1, kUnsignedByte, 1048577, "SCALAR")))(
        file);
  });
  const auto instancesFree = [](int count) {
    return [=](GlbWriter& file) {
      const int moves = file.addAccessor(-1, kFloat, count, "VEC3");
      primitives(GlbWriter::primitive(file.addPositions(std::vector<float>(30))))(file);
      file.nodes[0] = R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{)"
                      R"("TRANSLATION":)" +
                      std::to_string(moves) + "}}}}";
    };
  };
  cases.refused("more instances than objects", objects, instancesFree(262145));
  cases.refused("ten vertices in 130,000 places that cost nothing", zeros, instancesFree(130000));
  cases.refused("a million instances", objects, [](GlbWriter& file) {
    file.nodes[0] = R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{)"
                    R"("SCALE":1}}}})";
    file.accessors.push_back(
        R"({"bufferView":0,"componentType":5126,"count":1000000,"type":"VEC3"})");
  });
  cases.refused("10⁹ indices", more("16777216 triangles", "maxTriangles"), [](GlbWriter& file) {
    file.accessors.push_back(
        R"({"bufferView":0,"componentType":5121,"count":1000000000,"type":"SCALAR"})");
    primitives(GlbWriter::primitive(0, 1))(file);
  });
  cases.refused("60 times 100,000 morph targets", objects, [](GlbWriter& file) {
    file.meshes[0] = R"({"primitives":[{"attributes":{"POSITION":0},"targets":)" +
                     repeated(R"({"POSITION":0})", 99999) + R"(}],"weights":)" +
                     repeated("1", 99999) + '}';
    for (int n = 1; n < 60; ++n) file.addNode(R"("mesh":0)");
  });

  cases.refused("1000 normals with 100,000 morph targets", vertices, [&](GlbWriter& file) {
    zerosOf(1000)(file);
    file.meshes[0] = R"({"primitives":[{"attributes":{"POSITION":0,"NORMAL":0},"targets":)" +
                     repeated(R"({"NORMAL":0})", 99999) + R"(}],"weights":)" +
                     repeated("1", 99999) + '}';
  });

  const std::string start = R"({"asset":{"version":"2.0"},)";
  const std::string tooMany =
      "the glTF has more than 262144 nodes, meshes, accessors and other objects; raise the limit "
      "maxObjects to read it";
  cases.refused("a million nodes", tooMany,
                bytesOf(start + "\"nodes\":" + repeated("{}", 1000000) + '}'));
  cases.refused("a million primitives", tooMany,
                bytesOf(start + R"("meshes":[{"primitives":)" + repeated("{}", 1000000) + "}]}"));
  cases.refused(
      "five million elements",
      "the glTF has more than 4194304 elements of arrays; raise the limit maxObjects to read it",
      bytesOf(start + R"("scenes":[{"nodes":)" + repeated("0", 5000000) + "}]}"));
  cases.refused(
      "two million members",
      "the glTF has more than 2097152 members of objects; raise the limit maxObjects to read it",
      bytesOf(start + R"("accessors":)" +
              repeated(R"({"count":1,"type":"VEC3","byteOffset":0,"normalized":true,)"
                       R"("sparse":{"count":0,"indices":{"byteOffset":0},"values":{}}})",
                       250000) +
              '}'));
  cases.refused("four million times the same node", "node 0 is in the scene twice",
                bytesOf(start + R"("scenes":[{"nodes":)" + repeated("0", 4000000) +
                        R"(}],"nodes":[{}],"scene":0})"));
  cases.opens("millions of things that are skipped", 1, [](GlbWriter& file) {
    file.more =
        R"(,"materials":)" + repeated("{}", 3000000) + R"(,"extras":)" + repeated("[]", 10000);
  });
}

}  // namespace gvd
