// SPDX-License-Identifier: MIT
#include "gltf_corpus.h"

namespace gvd {

const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};

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
