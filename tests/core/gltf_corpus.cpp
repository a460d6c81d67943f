// SPDX-License-Identifier: MIT
#include "gltf_corpus.h"

namespace gvd {

const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::vector<float> kZigzag = {0, 1, 0, 0, 0, 0, 1, 1, 0, 1, 0, 0, 2, 1, 0, 2, 0, 0};

std::vector<std::pair<std::string, std::string>> dataUris(const ByteVector& buffer) {
  const std::string content = base64(buffer);
  const std::string withoutPadding = content.substr(0, content.find('='));
  std::string percentEncoded, allEncoded;
  for (char c : content) percentEncoded += c == '=' ? std::string("%3d") : std::string(1, c);
  constexpr char kHex[] = "0123456789ABCDEF";
  for (std::byte b : buffer) {
    const int value = std::to_integer<int>(b);
    allEncoded += std::string("%") + kHex[value / 16] + kHex[value % 16];
  }
  return {{"short", "data:;base64," + content},
          {"with a media type", "data:application/gltf-buffer;base64," + content},
          {"with a character set", "data:text/plain;charset=utf-8;base64," + content},
          {"in capitals", "DATA:;BASE64," + content},
          {"percent-encoded", "data:;base64," + percentEncoded},
          {"without padding", "data:;base64," + withoutPadding},
          {"with spaces", "data:;base64," + content.substr(0, 7) + " \\n" + content.substr(7)},
          {"not base64", "data:," + allEncoded}};
}

GlbWriter triangleFile() {
  GlbWriter file;
  file.addMesh({GlbWriter::primitive(file.addPositions(kTriangle))}, R"(,"name":"mesh")");
  file.addNode(R"("mesh":0,"name":"node")");
  return file;
}

GltfCase& GltfCases::opens(const std::string& name, int faces, ByteVector bytes) {
  return cases_.emplace_back(GltfCase{name, std::move(bytes), faces, {}, {}, {}});
}

GltfCase& GltfCases::opens(const std::string& name, int faces, const Change& change) {
  GlbWriter file = triangleFile();
  change(file);
  return opens(name, faces, file.glb());
}

GltfCase& GltfCases::refused(const std::string& name, const std::string& sentence,
                             ByteVector bytes) {
  return cases_.emplace_back(GltfCase{name, std::move(bytes), 0, sentence, {}, {}});
}

GltfCase& GltfCases::refused(const std::string& name, const std::string& sentence,
                             const Change& change) {
  GlbWriter file = triangleFile();
  change(file);
  return refused(name, sentence, file.glb());
}

GltfCases::Change primitives(const std::string& list) {
  return [list](GlbWriter& file) { file.meshes[0] = R"({"primitives":[)" + list + "]}"; };
}

GltfCases::Change node(const std::string& members) {
  return [members](GlbWriter& file) { file.nodes[0] = '{' + members + '}'; };
}

GltfCases::Change accessor(const std::string& members) {
  return [members](GlbWriter& file) { file.accessors[0] = '{' + members + '}'; };
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text + ',';
  return '[' + all + text + ']';
}

std::vector<GltfCase> gltfCorpus() {
  GltfCases cases;
  addContainerCases(cases);
  addBufferCases(cases);
  addNumberCases(cases);
  addAccessorCases(cases);
  addPrimitiveCases(cases);
  addSceneCases(cases);
  addSurfaceCases(cases);
  addLimitCases(cases);
  return cases.take();
}

}  // namespace gvd
