// SPDX-License-Identifier: MIT
//
// Cases about the objects that a mesh is made of: numbers, accessors and primitives.

#include "gltf_corpus.h"

namespace gvd {
namespace {

/// A place in a glTF where a whole number has to be.
struct NumberPlace {
  const char* path;
  const char* range;
  std::function<void(GlbWriter&, const std::string&)> set;
};

std::string sparseAccessor(const std::string& count, const std::string& ofIndices,
                           const std::string& ofValues) {
  return R"({"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":)" + count +
         R"(,"indices":{"bufferView":0,"componentType":5121)" + ofIndices +
         R"(},"values":{"bufferView":0)" + ofValues + "}}}";
}

std::vector<NumberPlace> numberPlaces() {
  const char* index = "from 0 to 2147483647";
  const char* size = "from 0 to 4294967295";
  // R"(…)" around the number, of an accessor without it.
  const auto ofAccessor = [](const std::string& others, const std::string& name) {
    return [=](GlbWriter& file, const std::string& x) {
      file.accessors[0] = '{' + others + ",\"" + name + "\":" + x + '}';
    };
  };
  const auto ofPrimitive = [](const std::string& before, const std::string& after = "") {
    return [=](GlbWriter& file, const std::string& x) {
      file.meshes[0] = "{\"primitives\":[{" + before + x + after + "}]}";
    };
  };
  const auto ofView = [](const std::string& others, const std::string& name) {
    return [=](GlbWriter& file, const std::string& x) {
      file.bufferViews[0] = '{' + others + ",\"" + name + "\":" + x + '}';
    };
  };
  return {
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
       ofPrimitive(R"("attributes":{"POSITION":)", "}")},
      {"meshes[0].primitives[0].indices", index,
       ofPrimitive(R"("attributes":{"POSITION":0},"indices":)")},
      {"meshes[0].primitives[0].mode", index,
       ofPrimitive(R"("attributes":{"POSITION":0},"mode":)")},
      {"meshes[0].primitives[0].targets[0].POSITION", index,
       ofPrimitive(R"("attributes":{"POSITION":0},"targets":[{"POSITION":)", "}]")},
      {"accessors[0].bufferView", index,
       ofAccessor(R"("componentType":5126,"count":3,"type":"VEC3")", "bufferView")},
      {"accessors[0].componentType", "from 5120 to 5126",
       ofAccessor(R"("bufferView":0,"count":3,"type":"VEC3")", "componentType")},
      {"accessors[0].byteOffset", size,
       ofAccessor(R"("bufferView":0,"componentType":5126,"count":3,"type":"VEC3")", "byteOffset")},
      {"accessors[0].count", size,
       ofAccessor(R"("bufferView":0,"componentType":5126,"type":"VEC3")", "count")},
      {"accessors[0].sparse.count", size,
       [](GlbWriter& f, const std::string& x) { f.accessors[0] = sparseAccessor(x, "", ""); }},
      {"accessors[0].sparse.indices.byteOffset", size,
       [](GlbWriter& f, const std::string& x) {
         f.accessors[0] = sparseAccessor("1", ",\"byteOffset\":" + x, "");
       }},
      {"accessors[0].sparse.values.byteOffset", size,
       [](GlbWriter& f, const std::string& x) {
         f.accessors[0] = sparseAccessor("1", "", ",\"byteOffset\":" + x);
       }},
      {"accessors[0].sparse.values.bufferView", index,
       [](GlbWriter& f, const std::string& x) {
         f.accessors[0] = sparseAccessor("1", "", ",\"bufferView\":" + x);
       }},
      {"bufferViews[0].buffer", index, ofView(R"("byteLength":36)", "buffer")},
      {"bufferViews[0].byteOffset", size, ofView(R"("buffer":0,"byteLength":36)", "byteOffset")},
      {"bufferViews[0].byteLength", size, ofView(R"("buffer":0)", "byteLength")},
      {"buffers[0].byteLength", size,
       [](GlbWriter& f, const std::string& x) { f.buffers = "{\"byteLength\":" + x + '}'; }},
  };
}

}  // namespace

void addNumberCases(GltfCases& cases) {
  struct Value {
    const char* json;
    const char* shown;
  };
  const Value values[] = {{"-1", "-1"},
                          {"-4", "-4"},
                          {"4294967296", "4294967296"},
                          {"9007199254740992", "9007199254740992"},
                          {"18446744073709551615", "18446744073709551615"},
                          {"18446744073709551616", "18446744073709551616"},
                          {"0.5", "0.5"},
                          {"-0.25", "-0.25"},
                          {"1e300", "1e300"},
                          {"null", "null"},
                          {"true", "true"},
                          {"\"1\"", "a string"},
                          {"[0]", "an array"},
                          {"{}", "an object"}};
  for (const NumberPlace& place : numberPlaces()) {
    for (const Value& value : values) {
      cases.refused(std::string(place.path) + ' ' + value.json,
                    std::string(place.path) + " is " + value.shown +
                        "; it must be a whole number " + place.range,
                    [&](GlbWriter& file) { place.set(file, value.json); });
    }
  }
  cases.opens("whole numbers written as others are", 1, [](GlbWriter& file) {
    file.nodes[0] = R"({"mesh":0.0,"scale":[1.0,1e0,1]})";
    file.accessors[0] = R"({"bufferView":0,"componentType":5126,"count":0.3e1,"type":"VEC3"})";
    file.bufferViews[0] = R"({"buffer":0e5,"byteLength":36.0,"byteStride":0})";
  });
  const auto wrong = [&](const std::string& members, const std::string& sentence) {
    cases.refused(members, sentence, bytesOf(R"({"asset":{"version":"2.0"},)" + members + '}'));
  };
  wrong(R"("nodes":{})", "nodes is an object; it must be an array");
  wrong(R"("nodes":[{},[]])", "nodes[1] is an array; it must be an object");
  wrong(R"("nodes":[{"matrix":"no"}])", "nodes[0].matrix is a string; it must be an array");
  wrong(R"("nodes":[{},{"scale":[1,null,1]}])", "nodes[1].scale[1] is null; it must be a number");
  wrong(R"("accessors":[{"normalized":1}])",
        "accessors[0].normalized is 1; it must be true or false");
  wrong(R"("meshes":[{"primitives":{}}])",
        "meshes[0].primitives is an object; it must be an array");
  wrong(R"("meshes":[{"primitives":[7]}])", "meshes[0].primitives[0] is 7; it must be an object");
  wrong(R"("scenes":[7])", "scenes[0] is 7; it must be an object");
}

void addAccessorCases(GltfCases& cases) {
  const auto positions = [&](const std::string& members, const std::string& sentence) {
    cases.refused("accessor {" + members + '}', sentence, accessor(members));
  };
  const std::string floats = R"("bufferView":0,"componentType":5126,"type":"VEC3",)";
  const std::string past = "accessor 0 reaches past the end of buffer view 0";
  positions(floats + R"("count":4)", past);
  positions(floats + R"("count":1000000)", past);
  positions(floats + R"("count":3,"byteOffset":4)", past);
  positions(floats + R"("count":3,"byteOffset":4294967292)", past);
  const std::string misaligned =
      " of its buffer, which is not a multiple of 4, the size of its numbers";
  positions(floats + R"("count":2,"byteOffset":2)", "accessor 0 begins at byte 2" + misaligned);
  cases.refused("misaligned buffer view", "accessor 0 begins at byte 1" + misaligned,
                [](GlbWriter& file) {
                  file.addPositions(kTriangle);
                  file.bufferViews[0] = R"({"buffer":0,"byteLength":40,"byteOffset":1})";
                });
  positions(floats + R"("count":0)", "the scene has no triangles");
  const std::pair<const char*, const char*> incomplete[] = {
      {R"("bufferView":0,"componentType":5126,"type":"VEC3")", "count"},
      {R"("bufferView":0,"count":3,"type":"VEC3")", "componentType"},
      {R"("bufferView":0,"componentType":5126,"count":3)", "type"}};
  for (const auto& [members, missing] : incomplete) {
    positions(members, "accessors[0] has no " + std::string(missing));
  }
  for (const char* type : {"VEC5", "vec3", ""}) {
    positions(R"("bufferView":0,"componentType":5126,"count":3,"type":")" + std::string(type) + '"',
              "accessors[0].type is \"" + std::string(type) +
                  "\"; it must be one of SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4");
  }
  for (const char* type : {"VEC2", "VEC4", "SCALAR", "MAT3", "MAT4"}) {
    positions(R"("bufferView":0,"componentType":5126,"count":3,"type":")" + std::string(type) + '"',
              "accessor 0 has the wrong type for positions");
  }
  for (const char* type : {"5124", "5125"}) {
    positions(
        R"("bufferView":0,"count":3,"type":"VEC3","componentType":)" + std::string(type),
        "accessor 0 has component type " + std::string(type) + ", which positions cannot have");
  }
  for (const char* type : {"5130", "0", "1"}) {
    positions(R"("bufferView":0,"count":3,"type":"VEC3","componentType":)" + std::string(type),
              "accessors[0].componentType is " + std::string(type) +
                  "; it must be a whole number from 5120 to 5126");
  }
  cases.refused(
      "positions without their buffer view: zeros",
      "no triangle is left of 1: 0 with a corner that is not finite, 1 with two corners at "
      "one position",
      accessor(R"("componentType":5126,"count":3,"type":"VEC3")"));
  cases.opens("interleaved, from an offset", 1, [](GlbWriter& file) {
    const int view =
        file.addView(std::vector<float>{9, 9, /**/ 0, 0, 0, 9, /**/ 1, 0, 0, 9, /**/ 0, 1, 0},
                     R"(,"byteStride":16)");
    file.addAccessor(view, kFloat, 3, "VEC3", R"(,"byteOffset":8)");
    primitives(GlbWriter::primitive(1))(file);
  });
  cases.opens("normalized floats are floats", 1,
              accessor(floats + R"("count":3,"normalized":true)"));
  cases.opens("minima and maxima that are wrong", 1,
              accessor(floats + R"("count":3,"min":[7,7,7],"max":[-1,"a",null])"));
  for (const auto& [name, type, stride] :
       {std::tuple("bytes", kByte, 4), std::tuple("unsigned bytes", kUnsignedByte, 4),
        std::tuple("shorts", kShort, 8), std::tuple("unsigned shorts", kUnsignedShort, 8)}) {
    cases.opens("quantized as " + std::string(name), 1,
                [&, type = type, stride = stride](GlbWriter& file) {
                  std::vector<std::uint8_t> bytes(3 * stride);
                  bytes[stride] = 100;
                  bytes[2 * stride + stride / 4] = 100;
                  const int view = file.addView(bytes, ",\"byteStride\":" + std::to_string(stride));
                  file.addAccessor(view, type, 3, "VEC3", R"(,"normalized":true)");
                  primitives(GlbWriter::primitive(1))(file);
                });
  }

  const auto sparse = [&](const std::string& count, const std::string& indices,
                          const std::string& values, const std::string& sentence) {
    const auto change = [&](GlbWriter& file) {
      file.addView(std::vector<std::uint8_t>{2});
      file.accessors[0] = R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",)"
                          R"("sparse":{"count":)" +
                          count + ",\"indices\":{" + indices + "},\"values\":{" + values + "}}}";
    };
    const std::string name = "sparse " + count + " {" + indices + "} {" + values + '}';
    if (sentence.empty()) {
      cases.opens(name, 1, change);
    } else {
      cases.refused(name, sentence, change);
    }
  };
  const std::string indices = R"("bufferView":1,"componentType":5121)";
  const std::string values = R"("bufferView":0,"byteOffset":24)";
  const std::string owner = "the sparse part of accessor 0";
  sparse("1", indices, values, "");
  sparse("0", indices, values, "");
  sparse("2", indices, values, owner + " reaches past the end of buffer view 1");
  sparse("4", indices, values, owner + " has more elements than the accessor itself");
  sparse("1", indices, R"("bufferView":0,"byteOffset":28)",
         owner + " reaches past the end of buffer view 0");
  sparse("1", indices, R"("bufferView":0,"byteOffset":2147483648)",
         owner + " reaches past the end of buffer view 0");
  sparse("1", indices, R"("bufferView":0,"byteOffset":2)",
         owner +
             " begins at byte 2 of its buffer, which is not a multiple of 4, the size of its "
             "numbers");
  sparse("1", indices, R"("bufferView":8)", owner + " names buffer view 8, but the glTF has 2");
  sparse("1", R"("bufferView":8,"componentType":5121)", values,
         owner + " names buffer view 8, but the glTF has 2");
  sparse("1", R"("bufferView":1,"componentType":5126)", values,
         owner + " has component type 5126, which vertex indices cannot have");
  sparse("1", R"("bufferView":1,"componentType":5120)", values,
         owner + " has component type 5120, which vertex indices cannot have");
  sparse("1", R"("bufferView":0,"componentType":5121,"byteOffset":14)", values,
         owner + " has the index 128 past its end");
}

void addPrimitiveCases(GltfCases& cases) {
  const auto zigzag = [](int mode, std::vector<std::uint8_t> indices = {}) {
    return [=](GlbWriter& file) {
      const int positions = file.addPositions(kZigzag);
      const int list = indices.empty() ? -1 : file.addIndices(kUnsignedByte, indices);
      primitives(GlbWriter::primitive(positions, list, mode))(file);
    };
  };
  cases.opens("strip", 4, zigzag(kStrip));
  cases.opens("strips joined by triangles without extent", 2,
              zigzag(kStrip, {0, 1, 2, 2, 3, 3, 4, 5}));
  cases.opens("fan", 2, zigzag(kFan, {1, 3, 2, 0}));
  cases.opens("corners too few for the last triangle", 1, zigzag(kTriangles, {0, 1, 2, 3, 4}));
  cases.refused("strip of two corners", "the scene has no triangles", zigzag(kStrip, {0, 1}));
  cases.opens("indices of 16 bits", 1, [](GlbWriter& file) {
    const int indices = file.addIndices<std::uint16_t>(kUnsignedShort, {2, 1, 0});
    primitives(GlbWriter::primitive(0, indices))(file);
  });
  cases.opens("indices of 32 bits", 1, [](GlbWriter& file) {
    const int indices = file.addIndices<std::uint32_t>(kUnsignedInt, {2, 1, 0});
    primitives(GlbWriter::primitive(0, indices))(file);
  });
  cases.opens("sparse indices", 1, [](GlbWriter& file) {
    const int places = file.addView(std::vector<std::uint8_t>{1, 2});
    const int indices = file.addAccessor(
        -1, kUnsignedByte, 3, "SCALAR",
        R"(,"sparse":{"count":2,"indices":{"bufferView":)" + std::to_string(places) +
            R"(,"componentType":5121},"values":{"bufferView":)" + std::to_string(places) + "}}");
    primitives(GlbWriter::primitive(0, indices))(file);
  });
  cases
      .opens("a mode for everything but triangles", 1,
             primitives(GlbWriter::primitive(0, -1, kPoints) + R"(,{"attributes":{"NORMAL":0}},)" +
                        GlbWriter::primitive(0) + ',' + GlbWriter::primitive(0, -1, 2) + ',' +
                        GlbWriter::primitive(0, -1, 3)))
      .sentence =
      "primitives of points or lines were passed over (3); primitives without positions "
      "were passed over (1)";
  cases.refused("lines only",
                "the scene has no triangles; primitives of points or lines were passed over (1)",
                primitives(GlbWriter::primitive(0, -1, kLines)));
  for (const int mode : {7, 77, 2147483647}) {
    cases.refused("mode " + std::to_string(mode),
                  "primitive 0 of mesh 0 has the unknown mode " + std::to_string(mode),
                  primitives(GlbWriter::primitive(0, -1, mode)));
  }
  cases.refused("no attributes", "meshes[0].primitives[0] has no attributes", primitives("{}"));
  cases.refused("no primitives", "the scene has no triangles", primitives(""));
  cases.refused("positions that are not there",
                "primitive 0 of mesh 0 names accessor 5, but the glTF has 1",
                primitives(GlbWriter::primitive(5)));
  cases.refused("indices that are not there",
                "primitive 0 of mesh 0 names accessor 5, but the glTF has 1",
                primitives(GlbWriter::primitive(0, 5)));
  cases.refused("positions for indices", "accessor 0 has the wrong type for vertex indices",
                primitives(GlbWriter::primitive(0, 0)));
  for (const auto& [name, componentType] :
       {std::pair("signed bytes", kByte), std::pair("floats", kFloat)}) {
    cases.refused("indices that are " + std::string(name),
                  "accessor 1 has component type " + std::to_string(componentType) +
                      ", which vertex indices cannot have",
                  [&, type = componentType](GlbWriter& file) {
                    file.addAccessor(0, type, 3, "SCALAR");
                    primitives(GlbWriter::primitive(0, 1))(file);
                  });
  }
  // 255 would begin a strip anew in WebGL; glTF does not allow it.
  for (const int index : {3, 255}) {
    cases.refused(
        "vertex index " + std::to_string(index),
        "primitive 0 of mesh 0 has vertex index " + std::to_string(index) +
            ", but the number of positions is 3",
        [&](GlbWriter& file) {
          file.addIndices<std::uint8_t>(kUnsignedByte, {0, 1, static_cast<std::uint8_t>(index)});
          primitives(GlbWriter::primitive(0, 1))(file);
        });
  }
  cases
      .opens("attributes that cannot be read", 1,
             primitives(R"({"attributes":{"POSITION":0,"NORMAL":99,"TEXCOORD_0":0}})"))
      .sentence =
      "normals, texture coordinates or densities that cannot be read were passed over (2)";

  const auto morphs = [&](const std::string& targets, const std::string& weights) {
    return [=](GlbWriter& file) {
      file.addPositions({0, 0, 1, 0, 0, 1, 0, 0, 1});
      file.addPositions({0, 0, 1});
      file.meshes[0] = R"({"primitives":[{"attributes":{"POSITION":0},"targets":[)" + targets +
                       "]}]" + weights + '}';
    };
  };
  const std::string noted =
      "primitives with morph targets were taken with their default weights (1)";
  cases.opens("morph target without weights", 1, morphs(R"({"POSITION":1},{})", "")).sentence =
      noted;
  cases
      .opens("more weights than morph targets", 1,
             morphs(R"({"POSITION":1})", R"(,"weights":[1,2,3])"))
      .sentence = noted;
  cases
      .opens("morph target of weight 0 that is not there", 1,
             morphs(R"({"POSITION":77})", R"(,"weights":[0])"))
      .sentence = noted;
  cases.refused("morph target that is not there",
                "primitive 0 of mesh 0 names accessor 77, but the glTF has 3",
                morphs(R"({"POSITION":77})", R"(,"weights":[1])"));
  cases.refused("morph target of fewer vertices",
                "primitive 0 of mesh 0: the number of elements of morph targets is 1, not that of "
                "positions, 3",
                morphs(R"({"POSITION":2})", R"(,"weights":[1])"));
}

}  // namespace gvd
