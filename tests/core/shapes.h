// SPDX-License-Identifier: MIT
//
// The meshes of the tests. Faces are counterclockwise seen from outside. Random shapes depend only
// on their seed, on every platform.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::shapes {

/// Positions and triangles as `TriangleMesh` takes them.
struct Shape {
  std::vector<double> positions;
  std::vector<int> triangles;

  int vertexCount() const { return static_cast<int>(positions.size() / 3); }
  int faceCount() const { return static_cast<int>(triangles.size() / 3); }
  Eigen::Vector3d position(int v) const { return Eigen::Vector3d::Map(&positions[3 * v]); }
  void setPosition(int v, const Eigen::Vector3d& p) { Eigen::Vector3d::Map(&positions[3 * v]) = p; }
  int addVertex(const Eigen::Vector3d& p);
  void addTriangle(int a, int b, int c);
  /// Two triangles, cut along a-c.
  void addQuad(int a, int b, int c, int d);

  TriangleMesh mesh(const MeshOptions& options = {}) const {
    return TriangleMesh(positions, triangles, options);
  }
};

/// Random numbers that are the same on all platforms, unlike those of the standard library's
/// distributions.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  /// Takes numbers from bytes, as long as there are any: one or two bytes for most numbers, so that
  /// a fuzzer changes one choice by changing a byte. The bytes must outlive this.
  explicit Random(std::span<const std::uint8_t> bytes) : bytes_(bytes), bits_(bytes.size()) {}

  /// In [0, 1).
  double uniform() {
    if (!bytes_.empty()) return static_cast<double>(take(2)) / 65536;
    return static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  int below(int n) {
    const std::uint64_t any = bytes_.empty() ? bits_() : take(n <= 256 ? 1 : 4);
    return static_cast<int>(any % static_cast<std::uint64_t>(n));
  }

 private:
  std::uint64_t take(std::size_t count) {
    std::uint64_t value = 0;
    for (; count > 0 && !bytes_.empty(); --count, bytes_ = bytes_.subspan(1))
      value = value << 8 | bytes_.front();
    return value;
  }

  std::span<const std::uint8_t> bytes_;
  std::mt19937_64 bits_;
};

// --- Plane: distances are Euclidean where the outline is convex ----------------------------------

/// The right triangle (0,0) (1,0) (0,1).
Shape triangle();
/// The unit square in columns × rows cells of two triangles; inner vertices are moved by up to
/// `jitter` cells in x and y (below 0.25 no triangle turns over).
Shape grid(int columns, int rows, double jitter = 0, std::uint64_t seed = 0);
/// The unit square with `points` random inner points, each inserted into the triangle that contains
/// it, without improvement; then `flips` random edges are flipped if the mesh stays plane. Any
/// angle and valence occurs, above all needles and caps (area ≥ 1e-7). With `clustering` c above 1,
/// points crowd towards the middle of the left side: distances to it are uniform^c.
Shape randomTriangulation(int points, int flips, std::uint64_t seed, double clustering = 1);
/// The disk of radius 1 in rings × spokes cells, each ring `ratio` times the size of the next: at
/// 0.5 and 30 rings the faces at the centre are 2^-30 times the size of those at the rim.
Shape gradedDisk(int rings, int spokes, double ratio);
/// The ring between radius 0.5 and 1.
Shape annulus(int spokes, int rings);
/// An L of three unit squares of n × n cells: plane, but not convex; (1,1) is its inner corner.
Shape ell(int n);
/// A plane band that winds around the origin, `n` quads long and three wide, a tenth of a radian
/// each. It is simply connected, and every path along it bends at its inner side, again and again.
Shape spiral(int n);

// --- One special vertex --------------------------------------------------------------------------

/// `n` isosceles triangles with legs of length 1 around vertex 0, whose corner angles there sum to
/// `angleSum`: a cone below 2π, flat at 2π, and above (n even, angleSum < nπ/2) a saddle.
Shape vertexFan(int n, double angleSum);

// --- Closed surfaces -----------------------------------------------------------------------------

Shape tetrahedron();  ///< regular, edges 2√2
Shape octahedron();   ///< vertices at distance 1 on the axes
Shape cube();         ///< [0,1]³, 12 faces
inline SurfacePoint centroid(int face) { return {face, Eigen::Vector3d::Constant(1.0 / 3)}; }
/// The middles of a cube's sides, on the edges that cut them in two faces.
std::vector<SurfacePoint> middlesOfSides(const TriangleMesh& cube);
Shape icosphere(int subdivisions);  ///< unit sphere, 20·4ⁿ faces
/// `major` × `minor` cells around the axis z and around the tube.
Shape torus(int major, int minor, double majorRadius = 1, double minorRadius = 0.4);
/// A plate of unit cubes, 3 wide and 1 thick, with `genus` square holes, each square in n × n
/// cells.
Shape perforatedPlate(int genus, int n = 1);
/// A smoothed perforated plate whose vertices are moved at random by up to `roughness` times their
/// shortest edge.
Shape bumpySurface(int genus, int n, double roughness, std::uint64_t seed);

// --- Surfaces with boundary ----------------------------------------------------------------------

/// Open at both ends, axis z.
Shape cylinder(int around, int along, double radius = 1, double height = 2);
/// One half twist: one boundary loop, no orientation.
Shape moebiusStrip(int around, int across = 1);

// --- Changes -------------------------------------------------------------------------------------

/// Splits every triangle in four, with new vertices in the middle of the edges.
Shape subdivided(const Shape& shape);
Shape moved(Shape shape, const Eigen::Vector3d& offset);
Shape scaled(Shape shape, double factor);
/// Both shapes in one, sharing nothing.
Shape joined(Shape a, const Shape& b);
/// Without `count` random triangles; their vertices stay.
Shape withoutRandomFaces(Shape shape, int count, std::uint64_t seed);
Shape withFaceTurnedOver(Shape shape, int face);
/// Stretched or compressed along each axis.
Shape scaled(Shape shape, const Eigen::Vector3d& axes);
/// Every triangle with three vertices of its own.
Shape unwelded(const Shape& shape);
/// Vertices and triangles in random order, corners of each triangle rotated at random.
Shape shuffled(const Shape& shape, std::uint64_t seed);
/// With every coordinate off by up to `most`.
Shape jittered(Shape shape, double most, std::uint64_t seed);

// --- Any of them ---------------------------------------------------------------------------------

/// A random mesh of many kinds: genus 0 to 3, with and without boundary, plane and not.
TriangleMesh randomMesh(std::uint64_t seed);
/// The number of sites to test on a mesh: few, some, or up to twice as many as vertices.
int randomSiteCount(const TriangleMesh& mesh, std::uint64_t seed);

}  // namespace gvd::shapes
