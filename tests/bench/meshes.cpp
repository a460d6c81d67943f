// SPDX-License-Identifier: MIT
#include "meshes.h"

#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "glb_writer.h"
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

std::vector<std::byte> readFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string());
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

NamedMesh modelMesh(const std::filesystem::path& glb) {
  return {glb.stem().string(), [glb] { return readGlb(glb); }};
}

TriangleMesh readGlb(const std::filesystem::path& glb) {
  const GltfScene scene = readGltf(readFile(glb));
  return TriangleMesh(scene.positions, scene.triangles);
}

void writeGlb(const TriangleMesh& mesh, const std::filesystem::path& glb) {
  std::vector<float> positions;
  for (int v = 0; v < mesh.vertexCount(); ++v)
    for (const double x : mesh.position(v)) positions.push_back(static_cast<float>(x));
  const std::vector<unsigned> indices(mesh.tails().begin(), mesh.tails().end());
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
