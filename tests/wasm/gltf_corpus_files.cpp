// SPDX-License-Identifier: MIT
//
// gvd_gltf_corpus FOLDER: writes the files of the corpus to a folder and the verdicts on them, as
// JSON, to standard output. `gltf_corpus.test.mjs` has the JavaScript library read them.

#include <filesystem>
#include <fstream>
#include <iostream>

#include "gltf_corpus.h"
#include "json_writer.h"

namespace gvd {
namespace {

void write(const std::filesystem::path& path, const ByteVector& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

void writeCorpus(const std::filesystem::path& folder) {
  JsonWriter json(std::cout);
  json.beginList();
  int files = 0;
  const auto writeFile = [&](const ByteVector& bytes) {
    const std::string name = std::to_string(files++) + ".bin";
    write(folder / name, bytes);
    json.text("file", name);
  };
  for (const GltfCase& of : gltfCorpus()) {
    json.beginObject();
    json.text("name", of.name);
    json.number("faces", of.faces);
    json.text("sentence", of.sentence);
    json.text("librarySentence", of.librarySentence);
    writeFile(of.bytes);
    json.beginList("resources");
    for (const auto& [path, bytes] : of.resources) {
      json.beginObject();
      json.text("path", path);
      writeFile(bytes);
      json.endObject();
    }
    json.endList();
    json.endObject();
  }
  json.endList();
}

}  // namespace
}  // namespace gvd

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: gvd_gltf_corpus FOLDER\n";
    return 2;
  }
  gvd::writeCorpus(arguments[1]);
}
