// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "gvd/triangle_mesh.h"

namespace gvd::bench {

/// A mesh that is made when its turn comes.
struct NamedMesh {
  std::string name;
  std::function<TriangleMesh()> make;
};

/// Around 100,000 faces each, drawn by formulas.
std::vector<NamedMesh> largeMeshes();
/// At most 6,000 faces each: shapes like the large ones, coarser, and bad triangles.
std::vector<NamedMesh> smallMeshes();
/// Of a GLB, named like the file.
NamedMesh modelMesh(const std::filesystem::path& glb);

TriangleMesh readGlb(const std::filesystem::path& glb);
void writeGlb(const TriangleMesh& mesh, const std::filesystem::path& glb);

}  // namespace gvd::bench
