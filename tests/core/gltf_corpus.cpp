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
