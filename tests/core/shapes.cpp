// SPDX-License-Identifier: MIT
#include "shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace gvd::shapes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

Vector3d onCircle(double radius, double turns, double z) {
  return {radius * std::cos(2 * pi * turns), radius * std::sin(2 * pi * turns), z};
}

/// (columns + 1) × (rows + 1) vertices, row by row, at(column, row).
Shape lattice(int columns, int rows, const std::function<Vector3d(int, int)>& at) {
  Shape shape;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) shape.addVertex(at(i, j));
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int v = j * (columns + 1) + i, above = v + columns + 1;
      shape.addQuad(v, v + 1, above + 1, above);
    }
  }
  return shape;
}

/// `columns` × (rows + 1) vertices, row by row; the last column meets the first.
Shape tube(int columns, int rows, const std::function<Vector3d(int, int)>& at) {
  Shape shape;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i < columns; ++i) shape.addVertex(at(i, j));
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int v = j * columns + i, right = j * columns + (i + 1) % columns;
      shape.addQuad(v, right, right + columns, v + columns);
    }
  }
  return shape;
}

Shape fromLists(const std::vector<Vector3d>& positions,
                const std::vector<std::array<int, 3>>& triangles) {
  Shape shape;
  for (const Vector3d& p : positions) shape.addVertex(p);
  for (const auto& [a, b, c] : triangles) shape.addTriangle(a, b, c);
  return shape;
}

// --- Random triangulations -----------------------------------------------------------------------

/// A triangulation of the unit square that never gets a triangle smaller than `kMinArea`: so small
/// a limit leaves needles and caps, and is large enough for the orientations computed here to be
/// the true ones.
class PlaneTriangulation {
 public:
  static constexpr double kMinArea = 1e-7;

  int triangleCount() const { return static_cast<int>(triangles_.size()); }

  /// Splits the triangle around p in three; false if there is none or a part would be too small.
  bool insert(const Vector2d& p) {
    const int i = static_cast<int>(points_.size());
    points_.push_back(p);
    for (auto& triangle : triangles_) {
      const auto [a, b, c] = triangle;
      if (!isLarge(a, b, i) || !isLarge(b, c, i) || !isLarge(c, a, i)) continue;
      triangle = {a, b, i};
      triangles_.insert(triangles_.end(), {{b, c, i}, {c, a, i}});
      return true;
    }
    points_.pop_back();
    return false;
  }

  /// Replaces side `side` of triangle t by the other diagonal of the quadrangle around it:
  ///
  ///        c                c
  ///       / \              /|\        false if ab is on the outline
  ///      a---b     →      a | b       or a triangle would be too small
  ///       \ /              \|/        (the quadrangle is not convex).
  ///        d                d
  bool flip(int t, int side) {
    const int a = triangles_[t][side], b = triangles_[t][(side + 1) % 3],
              c = triangles_[t][(side + 2) % 3];
    for (auto& neighbour : triangles_) {
      for (int i = 0; i < 3; ++i) {
        if (neighbour[i] != b || neighbour[(i + 1) % 3] != a) continue;
        const int d = neighbour[(i + 2) % 3];
        if (!isLarge(a, d, c) || !isLarge(d, b, c)) return false;
        triangles_[t] = {a, d, c};
        neighbour = {d, b, c};
        return true;
      }
    }
    return false;
  }

  Shape shape() const {
    Shape shape;
    for (const Vector2d& p : points_) shape.addVertex({p.x(), p.y(), 0});
    for (const auto& [a, b, c] : triangles_) shape.addTriangle(a, b, c);
    return shape;
  }

 private:
  bool isLarge(int a, int b, int c) const {
    const Vector2d u = points_[b] - points_[a], v = points_[c] - points_[a];
    return u.x() * v.y() - u.y() * v.x() >= 2 * kMinArea;
  }

  std::vector<Vector2d> points_ = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<std::array<int, 3>> triangles_ = {{0, 1, 2}, {0, 2, 3}};
};

// --- Smoothing and roughening --------------------------------------------------------------------

/// Calls visit(a, b) for every side of every triangle.
template <class Visit>
void forEachSide(const Shape& shape, Visit visit) {
  for (int h = 0; h < 3 * shape.faceCount(); ++h) {
    visit(shape.triangles[h], shape.triangles[TriangleMesh::next(h)]);
  }
}

/// Moves every vertex of a closed shape to the mean of its neighbours.
void smooth(Shape& shape) {
  std::vector<Vector3d> sum(shape.vertexCount(), Vector3d::Zero());
  std::vector<int> valence(shape.vertexCount(), 0);
  forEachSide(shape, [&](int a, int b) {  // every edge once in each direction
    sum[a] += shape.position(b);
    ++valence[a];
  });
  for (int v = 0; v < shape.vertexCount(); ++v) shape.setPosition(v, sum[v] / valence[v]);
}

void roughen(Shape& shape, double roughness, std::uint64_t seed) {
  std::vector<double> shortest(shape.vertexCount(), std::numeric_limits<double>::infinity());
  forEachSide(shape, [&](int a, int b) {
    const double length = (shape.position(b) - shape.position(a)).norm();
    shortest[a] = std::min(shortest[a], length);
    shortest[b] = std::min(shortest[b], length);
  });
  Random random(seed);
  const auto offset = [&](double size) { return random.uniform(-size, size) / std::sqrt(3.0); };
  for (int v = 0; v < shape.vertexCount(); ++v) {
    const double size = roughness * shortest[v];
    const double x = offset(size), y = offset(size), z = offset(size);
    shape.setPosition(v, shape.position(v) + Vector3d(x, y, z));
  }
}

/// The surface of a set of unit cubes: the squares between a cube and no cube.
Shape voxelSurface(const std::vector<std::array<int, 3>>& cubes) {
  Shape shape;
  std::map<std::array<int, 3>, int> vertexAt;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [entry, isNew] = vertexAt.try_emplace(at, shape.vertexCount());
    if (isNew) shape.addVertex(Vector3d(at[0], at[1], at[2]));
    return entry->second;
  };
  for (const auto& cube : cubes) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int side : {-1, 1}) {
        auto neighbour = cube;
        neighbour[axis] += side;
        if (std::find(cubes.begin(), cubes.end(), neighbour) != cubes.end()) continue;
        // Counterclockwise around the axis, as seen from its positive side; the other way on the
        // negative side.
        std::array<int, 4> corners;
        for (int i = 0; i < 4; ++i) {
          auto at = cube;
          at[axis] += side > 0;
          at[(axis + 1) % 3] += i == 1 || i == 2;
          at[(axis + 2) % 3] += i >= 2;
          corners[side > 0 ? i : 3 - i] = vertex(at);
        }
        shape.addQuad(corners[0], corners[1], corners[2], corners[3]);
      }
    }
  }
  return shape;
}

}  // namespace

// --- Shape ---------------------------------------------------------------------------------------

int Shape::addVertex(const Vector3d& p) {
  positions.insert(positions.end(), p.begin(), p.end());
  return vertexCount() - 1;
}

void Shape::addTriangle(int a, int b, int c) { triangles.insert(triangles.end(), {a, b, c}); }

void Shape::addQuad(int a, int b, int c, int d) {
  addTriangle(a, b, c);
  addTriangle(a, c, d);
}

// --- Plane ---------------------------------------------------------------------------------------

Shape triangle() { return fromLists({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}); }

Shape grid(int columns, int rows, double jitter, std::uint64_t seed) {
  Random random(seed);
  return lattice(columns, rows, [&](int i, int j) {
    const double dx = random.uniform(-jitter, jitter), dy = random.uniform(-jitter, jitter);
    const bool isInner = i > 0 && i < columns && j > 0 && j < rows;
    return Vector3d((i + isInner * dx) / columns, (j + isInner * dy) / rows, 0);
  });
}

Shape randomTriangulation(int points, int flips, std::uint64_t seed, double clustering) {
  Random random(seed);
  PlaneTriangulation triangulation;
  for (int inserted = 0; inserted < points;) {
    const Vector2d p(random.uniform(), random.uniform());
    const Vector2d middle(0, 0.5);
    const Vector2d ray = p - middle;
    inserted += triangulation.insert(middle + ray * std::pow(ray.norm(), clustering - 1));
  }
  for (int flipped = 0; flipped < flips;) {
    const int t = random.below(triangulation.triangleCount()), side = random.below(3);
    flipped += triangulation.flip(t, side);
  }
  return triangulation.shape();
}

Shape gradedDisk(int rings, int spokes, double ratio) {
  Shape shape;
  const int centre = shape.addVertex(Vector3d::Zero());
  for (int j = 0; j < rings; ++j) {
    const double radius = std::pow(ratio, rings - 1 - j);
    for (int i = 0; i < spokes; ++i) shape.addVertex(onCircle(radius, double(i) / spokes, 0));
  }
  const auto vertex = [&](int ring, int spoke) { return 1 + ring * spokes + spoke % spokes; };
  for (int i = 0; i < spokes; ++i) shape.addTriangle(centre, vertex(0, i), vertex(0, i + 1));
  for (int j = 0; j + 1 < rings; ++j) {
    for (int i = 0; i < spokes; ++i) {
      shape.addQuad(vertex(j, i), vertex(j + 1, i), vertex(j + 1, i + 1), vertex(j, i + 1));
    }
  }
  return shape;
}

Shape annulus(int spokes, int rings) {
  return tube(spokes, rings,
              [&](int i, int j) { return onCircle(1 - 0.5 * j / rings, double(i) / spokes, 0); });
}

Shape ell(int n) {
  Shape shape = lattice(2 * n, 2 * n,
                        [&](int i, int j) { return Vector3d(double(i) / n, double(j) / n, 0); });
  Shape result;
  std::vector<int> copy(shape.vertexCount(), -1);
  for (int f = 0; f < shape.faceCount(); ++f) {
    const int* corners = &shape.triangles[3 * f];
    const Vector3d centre =
        (shape.position(corners[0]) + shape.position(corners[1]) + shape.position(corners[2])) / 3;
    if (centre.x() > 1 && centre.y() > 1) continue;
    for (int i = 0; i < 3; ++i) {
      int& v = copy[corners[i]];
      if (v < 0) v = result.addVertex(shape.position(corners[i]));
      result.triangles.push_back(v);
    }
  }
  return result;
}

Shape spiral(int n) {
  return lattice(n, 3, [&](int i, int j) {
    const double angle = 0.1 * i, radius = 5 + 0.3 * angle + 0.3 * j;
    return Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0);
  });
}

// --- One special vertex --------------------------------------------------------------------------

Shape vertexFan(int n, double angleSum) {
  // The rim lies at distance 1 from the apex, at radius r and height ±h (r² + h² = 1), and
  // neighbours on it e apart: on one level below 2π, on alternating levels above, where
  // e² = 2r²(1 - cos(2π/n)) + 4h².
  const double e = 2 * std::sin(angleSum / (2 * n));
  const bool isSaddle = angleSum > 2 * pi;
  const double squaredRadius = isSaddle ? (4 - e * e) / (2 + 2 * std::cos(2 * pi / n))
                                        : std::pow(e / (2 * std::sin(pi / n)), 2);
  const double radius = std::sqrt(squaredRadius);
  const double height = std::sqrt(std::max(0.0, 1 - squaredRadius));
  Shape shape;
  const int apex = shape.addVertex(Vector3d::Zero());
  for (int i = 0; i < n; ++i) {
    shape.addVertex(onCircle(radius, double(i) / n, isSaddle && i % 2 == 1 ? height : -height));
  }
  for (int i = 0; i < n; ++i) shape.addTriangle(apex, 1 + i, 1 + (i + 1) % n);
  return shape;
}

// --- Closed surfaces -----------------------------------------------------------------------------

Shape tetrahedron() {
  return fromLists({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                   {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
}

Shape octahedron() {
  return fromLists(
      {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
}

Shape cube() { return voxelSurface({{0, 0, 0}}); }

std::vector<SurfacePoint> middlesOfSides(const TriangleMesh& cube) {
  constexpr double kBetweenEdgeAndDiagonal = 1.2;
  std::vector<SurfacePoint> middles;
  for (int h = 0; h < cube.halfedgeCount(); ++h) {
    if (cube.length(h) < kBetweenEdgeAndDiagonal || cube.twin(h) < h) continue;
    Eigen::Vector3d bary = Eigen::Vector3d::Constant(0.5);
    bary[(h + 2) % 3] = 0;
    middles.push_back({TriangleMesh::faceOf(h), bary});
  }
  return middles;
}

Shape icosphere(int subdivisions) {
  const double g = std::numbers::phi;
  Shape shape = fromLists(
      {{-1, g, 0},
       {1, g, 0},
       {-1, -g, 0},
       {1, -g, 0},
       {0, -1, g},
       {0, 1, g},
       {0, -1, -g},
       {0, 1, -g},
       {g, 0, -1},
       {g, 0, 1},
       {-g, 0, -1},
       {-g, 0, 1}},
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}});
  for (int i = 0; i < subdivisions; ++i) shape = subdivided(shape);
  for (int v = 0; v < shape.vertexCount(); ++v) {
    shape.setPosition(v, shape.position(v).normalized());
  }
  return shape;
}

Shape torus(int major, int minor, double majorRadius, double minorRadius) {
  Shape shape;
  for (int j = 0; j < minor; ++j) {
    const double turn = 2 * pi * j / minor;
    for (int i = 0; i < major; ++i) {
      shape.addVertex(onCircle(majorRadius + minorRadius * std::cos(turn), double(i) / major,
                               minorRadius * std::sin(turn)));
    }
  }
  const auto vertex = [&](int i, int j) { return j % minor * major + i % major; };
  for (int j = 0; j < minor; ++j) {
    for (int i = 0; i < major; ++i) {
      shape.addQuad(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  }
  return shape;
}

Shape perforatedPlate(int genus, int n) {
  std::vector<std::array<int, 3>> cubes;
  for (int x = 0; x < n * (2 * genus + 1); ++x) {
    for (int y = 0; y < 3 * n; ++y) {
      const bool isHole = x / n % 2 == 1 && y / n == 1;
      for (int z = 0; z < n && !isHole; ++z) cubes.push_back({x, y, z});
    }
  }
  return scaled(voxelSurface(cubes), 1.0 / n);
}

Shape bumpySurface(int genus, int n, double roughness, std::uint64_t seed) {
  Shape shape = perforatedPlate(genus, n);
  for (int i = 0; i < 3; ++i) smooth(shape);
  roughen(shape, roughness, seed);
  return shape;
}

// --- Surfaces with boundary ----------------------------------------------------------------------

Shape cylinder(int around, int along, double radius, double height) {
  return tube(around, along, [&](int i, int j) {
    return onCircle(radius, double(i) / around, height * j / along);
  });
}

Shape moebiusStrip(int around, int across) {
  Shape shape;
  for (int i = 0; i < around; ++i) {
    const double turns = double(i) / around;
    for (int j = 0; j <= across; ++j) {
      const double offset = double(j) / across - 0.5;
      shape.addVertex(
          onCircle(1 + offset * std::cos(pi * turns), turns, offset * std::sin(pi * turns)));
    }
  }
  const auto vertex = [&](int i, int j) {  // after one turn, the sides are exchanged
    return i < around ? i * (across + 1) + j : across - j;
  };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      shape.addQuad(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  }
  return shape;
}

// --- Changes -------------------------------------------------------------------------------------

Shape subdivided(const Shape& shape) {
  Shape result{shape.positions, {}};
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [entry, isNew] = middles.try_emplace(std::minmax(a, b), result.vertexCount());
    if (isNew) result.addVertex((shape.position(a) + shape.position(b)) / 2);
    return entry->second;
  };
  for (int f = 0; f < shape.faceCount(); ++f) {
    const int a = shape.triangles[3 * f], b = shape.triangles[3 * f + 1],
              c = shape.triangles[3 * f + 2];
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    result.addTriangle(a, ab, ca);
    result.addTriangle(ab, b, bc);
    result.addTriangle(ca, bc, c);
    result.addTriangle(ab, bc, ca);
  }
  return result;
}

Shape moved(Shape shape, const Vector3d& offset) {
  for (int v = 0; v < shape.vertexCount(); ++v) shape.setPosition(v, shape.position(v) + offset);
  return shape;
}

Shape scaled(Shape shape, double factor) {
  for (double& x : shape.positions) x *= factor;
  return shape;
}

Shape joined(Shape a, const Shape& b) {
  const int offset = a.vertexCount();
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (int v : b.triangles) a.triangles.push_back(offset + v);
  return a;
}

Shape withoutRandomFaces(Shape shape, int count, std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const auto first = shape.triangles.begin() + 3 * random.below(shape.faceCount());
    shape.triangles.erase(first, first + 3);
  }
  return shape;
}

Shape withFaceTurnedOver(Shape shape, int face) {
  std::swap(shape.triangles[3 * face + 1], shape.triangles[3 * face + 2]);
  return shape;
}

Shape unwelded(const Shape& shape) {
  Shape result;
  for (int v : shape.triangles) result.triangles.push_back(result.addVertex(shape.position(v)));
  return result;
}

Shape scaled(Shape shape, const Vector3d& axes) {
  for (int v = 0; v < shape.vertexCount(); ++v)
    shape.setPosition(v, shape.position(v).cwiseProduct(axes));
  return shape;
}

Shape jittered(Shape shape, double most, std::uint64_t seed) {
  Random random(seed);
  for (double& x : shape.positions) x += random.uniform(-most, most);
  return shape;
}

Shape shuffled(const Shape& shape, std::uint64_t seed) {
  Random random(seed);
  const auto permutation = [&](int count) {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    for (int i = count - 1; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
    return order;
  };
  Shape result{std::vector<double>(shape.positions.size()), {}};
  const std::vector<int> newVertex = permutation(shape.vertexCount());
  for (int v = 0; v < shape.vertexCount(); ++v) {
    result.setPosition(newVertex[v], shape.position(v));
  }
  for (int f : permutation(shape.faceCount())) {
    const int first = random.below(3);
    for (int i = 0; i < 3; ++i) {
      result.triangles.push_back(newVertex[shape.triangles[3 * f + (first + i) % 3]]);
    }
  }
  return result;
}

TriangleMesh randomMesh(std::uint64_t seed) {
  Random random(seed);
  const int kind = static_cast<int>(seed % 8);
  switch (kind) {
    case 0:
      return randomTriangulation(5 + random.below(60), 40, seed).mesh();
    case 1:
      return bumpySurface(0, 2, 0.3, seed).mesh();
    case 2:
      return bumpySurface(1, 1 + random.below(2), 0.3, seed).mesh();
    case 3:
      return bumpySurface(2, 1, 0.4, seed).mesh();
    case 4:
      return bumpySurface(3, 1, 0.4, seed).mesh();
    case 5:
      return withoutRandomFaces(bumpySurface(1, 2, 0.3, seed), 10, seed).mesh();
    case 6:
      return withoutRandomFaces(icosphere(2), 20, seed).mesh();
    default:
      return gradedDisk(4 + random.below(8), 6 + random.below(6), 0.6).mesh();
  }
}

int randomSiteCount(const TriangleMesh& mesh, std::uint64_t seed) {
  Random random(seed + 1000);
  // Few, some, and up to twice as many as there are vertices.
  const int most = seed % 5 == 0 ? 2 * mesh.vertexCount() : seed % 2 == 0 ? 20 : 5;
  return 1 + random.below(most);
}

}  // namespace gvd::shapes
