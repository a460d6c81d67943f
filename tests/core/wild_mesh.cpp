// SPDX-License-Identifier: MIT
#include "wild_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gvd {
namespace {

using Eigen::Vector3d;
using shapes::Random;
using shapes::Shape;

// --- Vertices ------------------------------------------------------------------------------------

Vector3d anywhere(Random& r) { return {r.uniform(), r.uniform(), r.uniform()}; }

/// One place of n³.
Vector3d onLattice(Random& r, int n) {
  const double x = r.below(n), y = r.below(n), z = r.below(n);
  return {x, y, z};
}

Vector3d onLine(Random& r) { return r.uniform() * Vector3d(1, 2, -3) / 7; }

/// On a line but for a distance of 1e-20 to 1.
Vector3d nearLine(Random& r) {
  const double beside = std::pow(10.0, -r.below(21));
  const Vector3d on = onLine(r);
  return on + beside * anywhere(r);
}

/// In one of four places, or beside it by rounding.
Vector3d nearPlace(Random& r) {
  const int place = r.below(4);
  const double step = r.below(2) ? 0 : (r.below(5) - 2) * 0x1p-52;
  return {0.3 * place + step, place % 2 ? 0.7 + step : 0.1, place / 2 * 0.9};
}

using MakeVertex = Vector3d (*)(Random&);
constexpr std::array<MakeVertex, 6> kVertices = {
    anywhere,
    [](Random& r) { return onLattice(r, 2); },
    [](Random& r) { return onLattice(r, 4); },
    onLine,
    nearLine,
    nearPlace,
};

/// A share of the vertices is made in another way than the rest.
void addVertices(Shape& shape, int count, Random& random) {
  const MakeVertex most = kVertices[random.below(kVertices.size())];
  const MakeVertex some = kVertices[random.below(kVertices.size())];
  const int share = random.below(4);
  for (int v = 0; v < count; ++v)
    shape.addVertex(random.below(8) < share ? some(random) : most(random));
}

// --- Triangles -----------------------------------------------------------------------------------

void addAnyTriangles(Shape& shape, int count, Random& random) {
  const int vertices = 3 + random.below(std::max(1, count));
  addVertices(shape, vertices, random);
  for (int f = 0; f < count; ++f) {
    const int a = random.below(vertices), b = random.below(vertices), c = random.below(vertices);
    shape.addTriangle(a, b, c);
  }
}

void addGrid(Shape& shape, int count, Random& random) {
  const int columns = 1 + random.below(std::max(1, static_cast<int>(std::sqrt(count / 2))));
  const int rows = std::max(1, count / 2 / columns), first = shape.vertexCount();
  addVertices(shape, (columns + 1) * (rows + 1), random);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const int v = first + i * (columns + 1) + j;
      shape.addQuad(v, v + 1, v + columns + 2, v + columns + 1);
    }
}

/// Closed: a disk, one more vertex on either side of it.
void addDoubleFan(Shape& shape, int count, Random& random) {
  const int n = std::max(3, count / 2), first = shape.vertexCount();
  addVertices(shape, n + 2, random);
  for (int i = 0; i < n; ++i) {
    const int a = first + 2 + i, b = first + 2 + (i + 1) % n;
    shape.addTriangle(first, a, b);
    shape.addTriangle(first + 1, b, a);
  }
}

void addSeparateTriangles(Shape& shape, int count, Random& random) {
  const int first = shape.vertexCount();
  addVertices(shape, 3 * count, random);
  for (int f = 0; f < count; ++f)
    shape.addTriangle(first + 3 * f, first + 3 * f + 1, first + 3 * f + 2);
}

// --- Sizes and places ----------------------------------------------------------------------------

/// Stretched along an axis, resized, moved off the origin, with single coordinates that are not
/// finite: one of these at a time, mostly none.
void distort(Shape& shape, Random& random) {
  const auto forEach = [&](auto change) {
    for (int v = 0; v < shape.vertexCount(); ++v) shape.setPosition(v, change(shape.position(v)));
  };
  switch (random.below(10)) {
    case 0: {
      // Braces: these are drawn in order, by any compiler.
      const Vector3d axes{1, std::pow(10.0, -random.below(9)), std::pow(10.0, -random.below(9))};
      return forEach([&](const Vector3d& p) -> Vector3d { return p.cwiseProduct(axes); });
    }
    case 1: {
      const double size = std::pow(10.0, random.below(119) - 59);
      return forEach([&](const Vector3d& p) -> Vector3d { return size * p; });
    }
    case 2: {
      const double far = std::pow(10.0, random.below(17));
      return forEach([&](const Vector3d& p) -> Vector3d { return p + Vector3d(far, -far, 0); });
    }
    case 3: {
      for (int n = 1 + random.below(4); n > 0; --n) {
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        constexpr std::array kOdd = {std::numeric_limits<double>::quiet_NaN(),
                                     kInfinity,
                                     -kInfinity,
                                     1e30,
                                     -1e30,
                                     1e-30,
                                     1e308,
                                     5e-324};
        shape.positions[random.below(static_cast<int>(shape.positions.size()))] =
            kOdd[random.below(kOdd.size())];
      }
      return;
    }
    default:
      return;
  }
}

}  // namespace

Shape wildMesh(Random& random, int mostTriangles) {
  constexpr std::array kParts = {addAnyTriangles, addGrid, addDoubleFan, addSeparateTriangles};
  Shape shape;
  const int count = 1 + random.below(mostTriangles);
  kParts[random.below(kParts.size())](shape, count, random);
  distort(shape, random);
  return shape;
}

}  // namespace gvd
