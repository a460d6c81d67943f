// SPDX-License-Identifier: MIT
//
// Cases about the file as a whole: GLB chunks, JSON, versions, extensions, and buffers.

#include <array>

#include "gltf_corpus.h"

namespace gvd {
namespace {

/// Of compressed data.
const std::string kRemedy = ", which is not decompressed here: save the model without it";

const std::string kNoVersion = "the JSON has no asset.version, so it is not a glTF";
const std::string kUnknownFormat = ": glTF, OBJ, OFF, PLY or STL, or a zip with one of them";

using Word = std::array<unsigned char, 4>;

/// The right file as a GLB with some bytes changed.
ByteVector changedGlb(std::size_t at, const Word& word) {
  ByteVector bytes = triangleFile().glb();
  for (std::size_t i = 0; i < word.size(); ++i) bytes[at + i] = static_cast<std::byte>(word[i]);
  return bytes;
}

void append(ByteVector& bytes, std::string_view text) {
  for (char c : text) bytes.push_back(static_cast<std::byte>(c));
}

/// A GLB of chunks, each a type and a content.
ByteVector glbOfChunks(const std::vector<std::pair<std::string, ByteVector>>& chunks) {
  const auto appendNumber = [](ByteVector& bytes, std::size_t number) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::byte>(number >> 8 * i));
  };
  ByteVector body;
  for (const auto& [type, content] : chunks) {
    appendNumber(body, content.size());
    append(body, type);
    body.insert(body.end(), content.begin(), content.end());
  }
  ByteVector bytes = bytesOf("glTF");
  appendNumber(bytes, 2);
  appendNumber(bytes, 12 + body.size());
  bytes.insert(bytes.end(), body.begin(), body.end());
  return bytes;
}

std::string nested(const std::string& open, const std::string& close, int depth) {
  std::string text;
  for (int i = 0; i < depth; ++i) text += open;
  for (int i = 0; i < depth; ++i) text += close;
  return text;
}

/// The right file as JSON, with a data URI for its buffer.
std::string embeddedJson() {
  const GlbWriter file = triangleFile();
  return file.json("data:;base64," + base64(file.bin));
}

void addGlbCases(GltfCases& cases) {
  const std::string bin("BIN\0", 4), json = "JSON";
  GlbWriter file = triangleFile();
  std::string text = file.json();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const ByteVector jsonChunk = bytesOf(text);

  cases.opens("right", 1, file.glb());
  ByteVector longer = file.glb();
  longer.resize(longer.size() + 5);
  cases.opens("GLB followed by other bytes", 1, longer);
  cases.opens("GLB with further chunks", 1,
              glbOfChunks({{json, jsonChunk}, {bin, file.bin}, {"MORE", file.bin}}));
  ByteVector zeroPadded = bytesOf(file.json());
  zeroPadded.resize(text.size() + 4);
  cases.opens("GLB whose JSON is padded with zeros", 1,
              glbOfChunks({{json, zeroPadded}, {bin, file.bin}}));
  ByteVector longerBin = file.bin;
  longerBin.resize(longerBin.size() + 100);
  cases.opens("GLB whose binary chunk is longer than its buffer", 1,
              glbOfChunks({{json, jsonChunk}, {bin, longerBin}}));
  GlbWriter elsewhere = triangleFile();
  cases.opens("GLB whose buffer is elsewhere", 1, glbOf(elsewhere.json("a.bin"), {})).resources = {
      {"a.bin", elsewhere.bin}};

  for (const unsigned char version : {1, 3}) {
    cases.refused("GLB of version " + std::to_string(version),
                  "this is GLB version " + std::to_string(version) + "; only version 2 is read",
                  changedGlb(4, {version, 0, 0, 0}));
  }
  cases.refused("GLB without chunks", "the GLB does not begin with a JSON chunk",
                changedGlb(8, {0, 0, 0, 0}));
  cases.refused("GLB whose first chunk is of another type",
                "the GLB does not begin with a JSON chunk", changedGlb(16, {'X', 'S', 'O', 'N'}));
  cases.refused("GLB that begins with its binary chunk", "the GLB does not begin with a JSON chunk",
                glbOfChunks({{bin, file.bin}, {json, jsonChunk}}));
  cases.refused("GLB with a chunk past its end", "a chunk of the GLB reaches past its end",
                changedGlb(12, {0, 0, 0, 0x7F}));
  cases.refused("GLB with a chunk of 4 GB", "a chunk of the GLB reaches past its end",
                changedGlb(12, {255, 255, 255, 255}));
  cases.refused("GLB whose binary chunk comes third",
                "buffer 0 has no uri, and there is no binary chunk for it",
                glbOfChunks({{json, jsonChunk}, {"MORE", file.bin}, {bin, file.bin}}));
  cases.refused("GLB with an empty JSON chunk", "the JSON is malformed at byte 1",
                glbOfChunks({{json, {}}, {bin, file.bin}}));
  for (const char* text : {"null", "[]  ", "1   ", "\"a\" "}) {
    cases.refused("GLB whose JSON is " + std::string(text), kNoVersion,
                  glbOfChunks({{json, bytesOf(text)}, {bin, file.bin}}));
  }
  ByteVector shorter = file.glb();
  const std::string size = std::to_string(shorter.size());
  shorter.pop_back();
  cases.refused("GLB without its last byte",
                "the GLB is truncated: it should have " + size + " bytes but has " +
                    std::to_string(shorter.size()),
                shorter);
  cases.refused("GLB of 4 GB",
                "the GLB is truncated: it should have 4294967295 bytes but has " + size,
                changedGlb(8, {255, 255, 255, 255}));
  cases.refused("GLB that ends in its header", "the GLB is truncated within its header",
                bytesOf("glTF\x02"));
}

void addJsonCases(GltfCases& cases) {
  const std::string neither = "this is neither GLB nor glTF JSON";
  cases.refused("empty", "the file is empty", ByteVector());
  for (const char* text : {"  \n", "[]", "null", "\"glTF\"", "<html></html>"}) {
    cases.refused("text: " + std::string(text), neither, bytesOf(text));
  }
  cases.refused("text in UTF-16", neither, bytesOf("\xFF\xFE{")).librarySentence =
      "the file is UTF-16 text: save it as UTF-8";
  for (const char* text :
       {"{}", R"({"asset":[]})", R"({"asset":{}})", R"({"asset":{"version":2.0}})",
        R"({"asset":{"version":null}})", R"({"version":"2.0"})"}) {
    cases.refused("JSON: " + std::string(text), kNoVersion, bytesOf(text));
  }
  const auto malformed = [&](const std::string& text, int byte) {
    cases.refused("JSON: " + text, "the JSON is malformed at byte " + std::to_string(byte),
                  bytesOf(text));
  };
  malformed(R"({"asset":)", 10);
  malformed("{\"asset\":{\"version\":\"\xFF\"}}", 22);
  malformed(R"({"asset":{"version":"2.0"},})", 28);
  malformed(R"({"asset":{"version":"2.0"}} {})", 29);
  malformed(R"({"asset":{"version":"2.0"}}])", 28);
  malformed(R"({'asset':{}})", 2);
  malformed(R"({"a":NaN})", 6);
  malformed(R"({"a":01})", 7);
  malformed(R"({"a":"\x"})", 8);
  malformed("{/* */}", 2);
  cases.refused("a number beyond doubles", "the JSON has a number that is too large",
                bytesOf(R"({"asset":{"version":1e999}})"));
  cases.refused("a number of 4097 digits", "the JSON has a number of more than 4096 characters",
                bytesOf("{\"scene\":" + std::string(4097, '9') + "}"));

  cases.opens("JSON with a data URI", 1, bytesOf(embeddedJson()));
  cases.opens("JSON after a byte order mark", 1, bytesOf("\xEF\xBB\xBF \r\n" + embeddedJson()));
  cases.opens("broken things beside the triangles", 1, [](GlbWriter& file) {
    file.more =
        R"(,"images":[{"bufferView":77},{"uri":"missing.png"},3],"materials":[{"a":[{}]}, 5],)"
        R"("textures":7,"animations":[{}],"skins":[{}],"cameras":[{"type":"x"}],)"
        R"("extensions":{"KHR_lights_punctual":{"lights":[{}]}},"samplers":[1])";
  });
  cases.opens("members whose names look like paths", 1, [](GlbWriter& file) {
    file.nodes[0] = R"({"mesh":0,"camera":-7,"extras":{"mesh":-1,"nodes[]":[{}]},)"
                    R"("nodes[].mesh":-1,"__proto__":{"mesh":7},"constructor":3,)"
                    R"("extensions":{"EXT_other":{"attributes":{"TRANSLATION":-1}}}})";
    file.more = R"(,"nodes[]":3,"":[[{"":null}]],"materials":-1,"extensions":[-1.5])";
  });
  cases.opens("a member twice: the last one counts", 1, [](GlbWriter& file) {
    file.nodes[0] = R"({"mesh":7,"mesh":0})";
    file.more = R"(,"scene":9,"scenes":[{"nodes":[8]}],"scenes":[{"nodes":[0]}],"scene":0)";
  });
  cases.opens("brackets in strings", 1, [](GlbWriter& file) {
    file.nodes[0] = R"({"mesh":0,"name":")" + nested("[", "\\\"", 300) + "\"}";
  });
  cases.opens("a string of 5000 digits after an escaped quote", 1, [](GlbWriter& file) {
    file.nodes[0] = R"({"mesh":0,"name":"\")" + std::string(5000, '7') + "\"}";
  });
  cases.opens("nested 100 levels deep", 1, [](GlbWriter& file) {
    file.nodes[0] = R"({"mesh":0,"extras":)" + nested("[", "]", 100) + "}";
  });
  for (const int depth : {1000, 100000}) {
    for (const std::string member : {"extras", "extensions", "nodes"}) {
      for (const auto& [open, close] : {std::pair("[", "]"), std::pair("{\"a\":", "}")}) {
        const std::string value = open[0] == '[' ? "" : "0";
        cases.refused(member + " nested " + std::to_string(depth) + " levels deep, " + open,
                      "the JSON is nested more than 128 levels deep",
                      bytesOf(R"({"asset":{"version":"2.0"},")" + member + "\":" +
                              nested(open, "", depth) + value + nested("", close, depth) + "}"));
      }
    }
  }
}

void addVersionCases(GltfCases& cases) {
  const auto version = [&](const std::string& asset, const std::string& named) {
    cases.refused("asset " + asset, "this is glTF version " + named + "; only version 2.0 is read",
                  [&](GlbWriter& file) { file.asset = asset; });
  };
  version(R"({"version":"1.0"})", R"("1.0")");
  version(R"({"version":"1.1"})", R"("1.1")");
  version(R"({"version":"3.0"})", R"("3.0")");
  version(R"({"version":"20"})", R"("20")");
  version(R"({"version":""})", R"("")");
  version(R"({"version":"2.1","minVersion":"2.1"})", R"("2.1")");
  cases.opens("asset of version 2.1 that 2.0 is enough for", 1,
              [](GlbWriter& file) { file.asset = R"({"version":"2.1","minVersion":"2.0"})"; });
  cases.refused("version 1.0 explains the rest",
                R"(this is glTF version "1.0"; only version 2.0 is read)",
                bytesOf(R"({"asset":{"version":"1.0"},"nodes":{},"scene":"main"})"));
}

void addExtensionCases(GltfCases& cases) {
  const auto require = [](const std::string& extension) {
    return [extension](GlbWriter& file) {
      file.more = ",\"extensionsRequired\":[\"" + extension + "\"]";
    };
  };
  for (const char* extension :
       {"KHR_materials_unlit", "KHR_texture_transform", "KHR_texture_basisu", "EXT_texture_webp",
        "KHR_lights_punctual", "KHR_mesh_quantization", "EXT_mesh_gpu_instancing"}) {
    cases.opens("requires " + std::string(extension), 1, require(extension));
  }
  for (const char* extension : {"VENDOR_magic", "khr_mesh_quantization", ""}) {
    cases.refused(
        "requires " + std::string(extension),
        "the glTF requires the extension " + std::string(extension) + ", which is not supported",
        require(extension));
  }
  cases.refused("requires a number", "extensionsRequired[0] is 5; it must be a string",
                [](GlbWriter& file) { file.more = R"(,"extensionsRequired":[5])"; });
  cases.opens("uses what it does not require", 1,
              [](GlbWriter& file) { file.more = R"(,"extensionsUsed":["VENDOR_magic",7,null])"; });
  // What is not compressed needs no decompressing, whatever the list says.
  for (const char* extension : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
    cases.opens("only says that it uses " + std::string(extension), 1, [&](GlbWriter& file) {
      file.more = ",\"extensionsUsed\":[\"" + std::string(extension) + "\"]";
    });
  }

  // The JavaScript library goes on to decompress.
  cases
      .refused("Draco, required",
               "the glTF requires the extension KHR_draco_mesh_compression" + kRemedy,
               [](GlbWriter& file) {
                 file.accessors[0] = R"({"componentType":5126,"count":3,"type":"VEC3"})";
                 file.meshes[0] = R"({"primitives":[{"attributes":{"POSITION":0},"extensions":{)"
                                  R"("KHR_draco_mesh_compression":{"bufferView":0}}}]})";
                 file.more = R"(,"extensionsRequired":["KHR_draco_mesh_compression"])";
               })
      .librarySentence = "primitive 0 of mesh 0 cannot be decompressed: its data are damaged";
  cases.refused("Draco, not said to be used",
                "primitive 0 of mesh 0 is compressed with KHR_draco_mesh_compression" + kRemedy,
                [](GlbWriter& file) {
                  file.accessors[0] = R"({"componentType":5126,"count":3,"type":"VEC3"})";
                  file.meshes[0] = R"({"primitives":[{"attributes":{"POSITION":0},"extensions":{)"
                                   R"("KHR_draco_mesh_compression":{"bufferView":0}}}]})";
                });
  cases
      .refused(
          "meshopt, required", "the glTF requires the extension EXT_meshopt_compression" + kRemedy,
          [](GlbWriter& file) {
            file.bufferViews[0] =
                R"({"buffer":0,"byteLength":36,"extensions":{"EXT_meshopt_compression":{)"
                R"("buffer":0,"byteLength":36,"byteStride":12,"count":3,"mode":"ATTRIBUTES"}}})";
            file.more = R"(,"extensionsRequired":["EXT_meshopt_compression"])";
          })
      .librarySentence = "buffer view 0 cannot be decompressed: its data are damaged";
  cases.refused("the buffer that stands for meshopt's data, without the extension",
                "buffer 1 stands for data compressed with EXT_meshopt_compression" + kRemedy,
                [](GlbWriter& file) {
                  file.buffers = R"({"byteLength":36},{"byteLength":36,"extensions":{)"
                                 R"("EXT_meshopt_compression":{"fallback":true}}})";
                  file.bufferViews[0] = R"({"buffer":1,"byteLength":36})";
                });
}

void addUriCases(GltfCases& cases) {
  const GlbWriter file = triangleFile();
  for (const auto& [name, uri] : dataUris(file.bin))
    cases.opens("data URI, " + name, 1, bytesOf(file.json(uri)));
  const std::pair<const char*, const char*> badDataUris[] = {
      {"data:;base64", "buffer 0 has a data URI without content"},
      {"data:", "buffer 0 has a data URI without content"},
      {"data:;base64,AA*A", "buffer 0 has a data URI that is not base64"},
      {"data:;base64,", "buffer 0 should have 36 bytes but has 0"},
      {"data:;base64,AAAA", "buffer 0 should have 36 bytes but has 3"}};
  for (const auto& [uri, sentence] : badDataUris) {
    cases.refused("data URI " + std::string(uri), sentence, bytesOf(file.json(uri)));
  }

  const auto named = [&](const std::string& uri) { return bytesOf(file.json(uri)); };
  ByteVector longer = file.bin;
  longer.push_back(std::byte{1});
  for (const std::string uri : {
           "my%20buffer.bin",
           "my buffer.bin",
       }) {
    cases.opens("external buffer " + uri, 1, named(uri)).resources = {{"other.bin", {}},
                                                                      {"my buffer.bin", longer}};
  }
  const auto missing = [&](const std::string& uri, const std::string& more) {
    std::string shown;  // as it is without the backslashes that JSON wants
    for (std::size_t i = 0; i < uri.size(); ++i) shown += uri[uri[i] == '\\' ? i++ : i];
    cases.refused("external buffer " + uri + ", missing",
                  "buffer 0 needs the file \"" + shown + "\", which is missing" + more, named(uri));
  };
  missing("missing.bin", "");
  missing("a..b/it%20is%.bin", "");
  const std::string outside = ": files outside the model's folder are not read";
  for (const std::string uri :
       {"../secret.bin", "a/../../secret.bin", "%2e%2e/secret.bin", "/etc/passwd", "%2Fetc/passwd",
        "..\\\\secret.bin", "C:\\\\secret.bin", "file:///etc/passwd",
        "https://example.org/a.bin"}) {
    missing(uri, outside);
  }
  ByteVector shorter = file.bin;
  shorter.pop_back();
  cases
      .refused("external buffer that is too short", "buffer 0 should have 36 bytes but has 35",
               named("a.bin"))
      .resources = {{"a.bin", shorter}};
  cases.refused("JSON whose buffer has no uri",
                "buffer 0 has no uri, and there is no binary chunk for it", bytesOf(file.json()));
}

}  // namespace

void addContainerCases(GltfCases& cases) {
  addGlbCases(cases);
  addJsonCases(cases);
  addVersionCases(cases);
  addExtensionCases(cases);
}

void addBufferCases(GltfCases& cases) {
  addUriCases(cases);
  const auto buffers = [](const std::string& objects) {
    return [objects](GlbWriter& file) { file.buffers = objects; };
  };
  cases.opens("buffers that no triangle needs", 1,
              buffers(R"({"byteLength":36},{"byteLength":9,"uri":"missing.bin"},)"
                      R"({"byteLength":0},{"byteLength":9,"uri":"../outside.bin"},)"
                      R"({"byteLength":9,"uri":"https://example.org/a.bin"},{"uri":"data:x"})"));
  cases.refused("buffer longer than the binary chunk", "buffer 0 should have 37 bytes but has 36",
                buffers(R"({"byteLength":37})"));
  cases.refused("buffer without length", "buffer 0 has no byteLength", buffers("{}"));
  cases.refused("buffer of no bytes", "buffer view 0 reaches past the end of buffer 0",
                buffers(R"({"byteLength":0})"));
  cases.refused("buffer that is no object", "buffers[0] is 7; it must be an object", buffers("7"));
  cases.refused("uri that is no string", "buffers[0].uri is 7; it must be a string",
                buffers(R"({"byteLength":36,"uri":7})"));
  cases.refused("the binary chunk is the first buffer's only",
                "buffer 1 has no uri, and there is no binary chunk for it", [](GlbWriter& file) {
                  file.buffers = R"({"byteLength":36},{"byteLength":36})";
                  file.bufferViews[0] = R"({"buffer":1,"byteLength":36})";
                });

  const auto view = [&](const std::string& members, const std::string& sentence) {
    cases.refused("buffer view {" + members + '}', sentence,
                  [&](GlbWriter& file) { file.bufferViews[0] = "{\"buffer\":0" + members + "}"; });
  };
  const std::string past = "buffer view 0 reaches past the end of buffer 0";
  view(R"(,"byteLength":37)", past);
  view(R"(,"byteLength":36,"byteOffset":1)", past);
  view(R"(,"byteLength":36,"byteOffset":4294967295)", past);
  view(R"(,"byteLength":4294967295,"byteOffset":4294967295)", past);
  view(R"(,"byteLength":4294967295)", past);
  const std::string pastView = "accessor 0 reaches past the end of buffer view 0";
  view(R"(,"byteLength":35)", pastView);
  view(R"(,"byteLength":0)", pastView);
  view(R"(,"byteLength":36,"byteStride":16)", pastView);
  view(R"(,"byteLength":36,"byteStride":252)", pastView);
  for (const char* stride : {"4", "8"}) {
    view(R"(,"byteLength":36,"byteStride":)" + std::string(stride),
         "buffer view 0 has a byteStride less than the elements of accessor 0");
  }
  for (const char* stride : {"2", "11", "-12", "1000000000", "256", "4.5", "4294967308"}) {
    view(R"(,"byteLength":36,"byteStride":)" + std::string(stride),
         "bufferViews[0].byteStride is " + std::string(stride) +
             "; it must be a multiple of 4 from 0 to 252");
  }
  for (const char* stride : {"0", "12"}) {
    cases.opens("byteStride " + std::string(stride), 1, [&](GlbWriter& file) {
      file.bufferViews[0] =
          R"({"buffer":0,"byteLength":36,"byteStride":)" + std::string(stride) + '}';
    });
  }
  cases.refused("no buffer views", "accessor 0 names buffer view 0, but the glTF has 0",
                [](GlbWriter& file) { file.bufferViews.clear(); });
  cases.refused("buffer view of a buffer that is not there",
                "buffer view 0 names buffer 3, but the glTF has 1",
                [](GlbWriter& file) { file.bufferViews[0] = R"({"buffer":3,"byteLength":36})"; });
}

}  // namespace gvd
