// SPDX-License-Identifier: MIT
//
// gvd_read_gltf FILE: reads a glTF and says in a line what came of it. `hostile.mjs` measures it.

#include <fstream>
#include <iostream>
#include <span>
#include <string>

#include "gvd/error.h"
#include "gvd/gltf.h"

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: gvd_read_gltf FILE\n";
    return 2;
  }
  std::ifstream file(arguments[1], std::ios::binary | std::ios::ate);
  std::string bytes(static_cast<std::size_t>(file.tellg()), '\0');
  file.seekg(0);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  try {
    const gvd::GltfScene scene = gvd::readGltf(std::as_bytes(std::span(bytes)));
    std::cout << scene.triangles.size() / 3 << " triangles\n";
  } catch (const gvd::Error& error) {
    std::cout << error.what() << '\n';
    return 1;
  }
}
