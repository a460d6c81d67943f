// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "gvd/triangle_mesh.h"

namespace gvd::bench {

/// A mesh that is made on demand.
struct NamedMesh {
  std::string name;
  std::function<TriangleMesh()> make;
};

/// Around 100,000 faces each, drawn by formulas.
std::vector<NamedMesh> largeMeshes();
/// One shape from coarse to fine, each with four times the faces of the one before.
std::vector<NamedMesh> sizeLadder();
/// At most 6,000 faces each: shapes like the large ones, coarser, and bad triangles.
std::vector<NamedMesh> smallMeshes();
/// The mesh of a glTF file, with the name of the file.
NamedMesh fileMesh(const std::filesystem::path& gltf);
/// The same meshes, where later ones of a name get a number.
std::vector<NamedMesh> distinctlyNamed(std::vector<NamedMesh> meshes);

/// Splits every face in four, `times` times: a larger mesh of the same kind. Points halfway along
/// edges are displaced by up to a twentieth of the edge in x, y and z, the same way every time.
/// Without that, they would be flat and regular, which is too easy: fewer windows, and saddles only
/// at the old vertices.
TriangleMesh subdivided(const TriangleMesh& mesh, int times);

/// Reads a GLB, or a glTF whose buffers are all in the file. Errors begin with the path of the
/// file.
TriangleMesh readGltfMesh(const std::filesystem::path& gltf);
void writeGlb(const TriangleMesh& mesh, const std::filesystem::path& glb);

}  // namespace gvd::bench
