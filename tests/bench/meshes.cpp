// SPDX-License-Identifier: MIT
#include "meshes.h"

#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <map>
#include <span>
#include <stdexcept>
#include <utility>

#include "glb_writer.h"
#include "gvd/error.h"
#include "gvd/gltf.h"
#include "shapes.h"

namespace gvd::bench {
namespace {

using shapes::Shape;

/// What a GLB can carry: so the same mesh can be given to others.
TriangleMesh inSinglePrecision(Shape shape) {
  for (double& x : shape.positions) x = static_cast<float>(x);
  return shape.mesh();
}

/// A sphere with hills and valleys, some of them steep.
Shape bumpySphere(int subdivisions) {
  Shape shape = shapes::icosphere(subdivisions);
  for (int v = 0; v < shape.vertexCount(); ++v) {
    const Eigen::Vector3d p = shape.position(v);
    const double bumps = std::sin(7 * p.x()) * std::sin(8 * p.y()) * std::sin(9 * p.z());
    const double ripples = std::sin(40 * p.z() + 10 * p.x());
    shape.setPosition(v, (1 + 0.2 * bumps + 0.01 * ripples) * p);
  }
  return shape;
}

/// A rough surface of genus 3, every face of it `times` split in four.
Shape genus3(int n, int times) {
  Shape shape = shapes::bumpySurface(3, n, 0.3, 1);
  for (int i = 0; i < times; ++i) shape = shapes::subdivided(shape);
  return shape;
}

Shape toShape(const TriangleMesh& mesh) {
  Shape shape;
  for (int v = 0; v < mesh.vertexCount(); ++v) shape.addVertex(mesh.position(v));
  for (int h = 0; h < mesh.halfedgeCount(); ++h) shape.triangles.push_back(mesh.tail(h));
  return shape;
}

/// Every face in four; the points halfway along edges displaced by up to `displacement` edges in x,
/// y and z.
Shape subdividedOnce(const TriangleMesh& mesh, double displacement, shapes::Random& random) {
  Shape shape;
  for (int v = 0; v < mesh.vertexCount(); ++v) shape.addVertex(mesh.position(v));
  std::vector<int> middle(mesh.halfedgeCount());
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const int twin = mesh.twin(h);
    if (twin >= 0 && twin < h) {
      middle[h] = middle[twin];
      continue;
    }
    const double most = displacement * mesh.length(h);
    Eigen::Vector3d p = (mesh.position(mesh.tail(h)) + mesh.position(mesh.tip(h))) / 2;
    for (double& x : p) x += random.uniform(-most, most);
    middle[h] = shape.addVertex(p);
  }
  for (int h = 0; h < mesh.halfedgeCount(); h += 3) {
    for (int i = h; i < h + 3; ++i)
      shape.addTriangle(mesh.tail(i), middle[i], middle[TriangleMesh::previous(i)]);
    shape.addTriangle(middle[h], middle[h + 1], middle[h + 2]);
  }
  return shape;
}

std::vector<std::byte> readFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw std::runtime_error("cannot read " + path.string());
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::vector<NamedMesh> largeMeshes() {
  return {
      {"bumpy-sphere", [] { return inSinglePrecision(bumpySphere(6)); }},
      {"torus", [] { return inSinglePrecision(shapes::torus(320, 160)); }},
      {"genus-3", [] { return inSinglePrecision(genus3(7, 2)); }},
  };
}

std::vector<NamedMesh> sizeLadder() {
  std::vector<NamedMesh> meshes;
  for (const int subdivisions : {3, 4, 5, 6, 7, 8})
    meshes.push_back({"bumpy-sphere-" + std::to_string(subdivisions),
                      [subdivisions] { return inSinglePrecision(bumpySphere(subdivisions)); }});
  return meshes;
}

std::vector<NamedMesh> smallMeshes() {
  return {
      {"bumpy-sphere-small", [] { return inSinglePrecision(bumpySphere(4)); }},
      {"torus-small", [] { return inSinglePrecision(shapes::torus(60, 40)); }},
      {"genus-3-small", [] { return inSinglePrecision(genus3(6, 0)); }},
      {"genus-3-coarse", [] { return inSinglePrecision(genus3(2, 0)); }},
      {"needles", [] { return inSinglePrecision(shapes::torus(150, 8)); }},
      {"holes",
       [] {
         const Shape shape = shapes::bumpySurface(1, 5, 0.3, 2);
         return inSinglePrecision(shapes::withoutRandomFaces(shape, 60, 2));
       }},
  };
}

NamedMesh fileMesh(const std::filesystem::path& gltf) {
  return {gltf.stem().string(), [gltf] { return readGltfMesh(gltf); }};
}

std::vector<NamedMesh> distinctlyNamed(std::vector<NamedMesh> meshes) {
  std::map<std::string, int> uses;
  for (NamedMesh& mesh : meshes)
    if (const int use = ++uses[mesh.name]; use > 1)
      mesh.name.append("-").append(std::to_string(use));
  return meshes;
}

TriangleMesh subdivided(const TriangleMesh& mesh, int times) {
  constexpr double kDisplacement = 0.05;
  shapes::Random random(1);
  Shape shape = toShape(mesh);
  for (int i = 0; i < times; ++i) shape = subdividedOnce(shape.mesh(), kDisplacement, random);
  return inSinglePrecision(std::move(shape));
}

TriangleMesh readGltfMesh(const std::filesystem::path& gltf) {
  try {
    const GltfScene scene = readGltf(readFile(gltf));
    return TriangleMesh(scene.positions, scene.triangles);
  } catch (const Error& error) {
    throw Error(error.code(), gltf.string() + ": " + error.what());
  }
}

void writeGlb(const TriangleMesh& mesh, const std::filesystem::path& glb) {
  std::vector<float> positions;
  for (int v = 0; v < mesh.vertexCount(); ++v)
    for (const double x : mesh.position(v)) positions.push_back(static_cast<float>(x));
  std::vector<unsigned> indices;
  for (int h = 0; h < mesh.halfedgeCount(); ++h) indices.push_back(mesh.tail(h));
  GlbWriter writer;
  const int positionAccessor = writer.addPositions(positions);
  const int indexAccessor = writer.addIndices(kUnsignedInt, indices);
  const int object = writer.addMesh({GlbWriter::primitive(positionAccessor, indexAccessor)});
  writer.addNode("\"mesh\":" + std::to_string(object));
  const ByteVector bytes = writer.glb();
  std::ofstream file(glb, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  if (!file) throw std::runtime_error("cannot write " + glb.string());
}

}  // namespace gvd::bench
