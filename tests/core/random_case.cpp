// SPDX-License-Identifier: MIT
#include "random_case.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <utility>

#include "gvd/error.h"
#include "gvd/geodesic.h"
#include "gvd/sampling.h"
#include "mesh/face_layout.h"
#include "wild_mesh.h"

namespace gvd {
namespace {

using Eigen::Vector3d;
using shapes::centroid;
using shapes::Random;
using shapes::Shape;
using Sites = std::vector<SurfacePoint>;

// --- Meshes --------------------------------------------------------------------------------------

Vector3d onUnitCircle(int i, int n) {
  const double angle = 2 * std::numbers::pi * i / n;
  return {std::cos(angle), std::sin(angle), 0};
}

/// Two regular polygons, walls of two triangles each between them.
Shape prism(int n) {
  Shape shape;
  for (const double z : {0.0, 1.0})
    for (int i = 0; i < n; ++i) shape.addVertex(onUnitCircle(i, n) + Vector3d(0, 0, z));
  const int bottom = shape.addVertex({0, 0, 0}), top = shape.addVertex({0, 0, 1});
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    shape.addTriangle(bottom, j, i);
    shape.addTriangle(top, n + i, n + j);
    shape.addQuad(i, j, n + j, n + i);
  }
  return shape;
}

/// Both sides of a regular polygon, each a fan around a point of its own; `offset` is that of the
/// lower one's. Angles of π and of zero deficit occur all over it.
Shape coveredPolygon(int n, double offset) {
  Shape shape;
  for (int i = 0; i < n; ++i) shape.addVertex(onUnitCircle(i, n));
  const int front = shape.addVertex({0, 0, 0}), back = shape.addVertex({offset, offset / 3, 0});
  for (int i = 0; i < n; ++i) {
    shape.addTriangle(front, i, (i + 1) % n);
    shape.addTriangle(back, (i + 1) % n, i);
  }
  return shape;
}

/// A grid folded over itself along its middle: points that are far apart coincide in space, which
/// nothing may depend on. The fold's top layer is a hair above, lest vertices be welded.
Shape foldedGrid(int n) {
  Shape shape = shapes::grid(2 * n, n);
  for (int v = 0; v < shape.vertexCount(); ++v) {
    Vector3d p = shape.position(v);
    if (p.x() > 0.5) p = {1 - p.x(), p.y(), 1e-3 * (p.x() - 0.5)};
    shape.setPosition(v, p);
  }
  return shape;
}

/// Random triangles between points of a lattice: edges of many faces, faces on top of each other.
Shape soup(Random& random) {
  Shape shape;
  const int vertices = 5 + random.below(8), triangles = 6 + random.below(20);
  for (int v = 0; v < vertices; ++v)
    shape.addVertex(Vector3d(random.uniform(), random.uniform(), random.uniform()));
  while (shape.faceCount() < triangles) {
    const int a = random.below(vertices), b = random.below(vertices), c = random.below(vertices);
    if (a != b && b != c && c != a) shape.addTriangle(a, b, c);
  }
  return shape;
}

struct KindOfMesh {
  const char* name;
  Shape (*make)(Random&);
};

std::uint64_t seedFrom(Random& random) { return static_cast<std::uint64_t>(random.below(1 << 30)); }

constexpr std::array kMeshes = {
    KindOfMesh{"regular grid",
               [](Random& r) { return shapes::grid(1 + r.below(6), 1 + r.below(6)); }},
    KindOfMesh{"irregular grid",
               [](Random& r) {
                 const int columns = 2 + r.below(5), rows = 2 + r.below(5);
                 return shapes::grid(columns, rows, 0.24, seedFrom(r));
               }},
    KindOfMesh{"needles and caps",
               [](Random& r) {
                 const int points = 1 + r.below(40), flips = points < 4 ? 0 : r.below(60);
                 const double clustering = r.below(2) ? 1 : 3;
                 return shapes::randomTriangulation(points, flips, seedFrom(r), clustering);
               }},
    KindOfMesh{"graded disk",
               [](Random& r) {
                 const int rings = 2 + r.below(6), spokes = 3 + r.below(6);
                 return shapes::gradedDisk(rings, spokes, r.uniform(0.05, 0.7));
               }},
    KindOfMesh{"annulus",
               [](Random& r) { return shapes::annulus(3 + r.below(10), 1 + r.below(3)); }},
    KindOfMesh{"L", [](Random& r) { return shapes::ell(1 + r.below(3)); }},
    KindOfMesh{"cone",
               [](Random& r) {
                 const int n = 3 + r.below(22);
                 return shapes::vertexFan(n, r.uniform(0.1, 1) * 2 * std::numbers::pi);
               }},
    KindOfMesh{"flat fan",
               [](Random& r) { return shapes::vertexFan(3 + r.below(22), 2 * std::numbers::pi); }},
    KindOfMesh{"sharp saddle",
               [](Random& r) {
                 const int n = 6 + 2 * r.below(8);
                 const double most = 0.49 * n * std::numbers::pi;
                 return shapes::vertexFan(n, r.uniform(2 * std::numbers::pi, most));
               }},
    KindOfMesh{"subdivided saddle",
               [](Random& r) {
                 const int n = 6 + 2 * r.below(4);
                 const double most = 0.49 * n * std::numbers::pi;
                 return shapes::subdivided(
                     shapes::vertexFan(n, r.uniform(2 * std::numbers::pi, most)));
               }},
    KindOfMesh{"tetrahedron",
               [](Random& r) {
                 const Shape shape = shapes::tetrahedron();
                 return r.below(2) ? shapes::subdivided(shape) : shape;
               }},
    KindOfMesh{"octahedron",
               [](Random& r) {
                 const Shape shape = shapes::octahedron();
                 return r.below(2) ? shapes::subdivided(shape) : shape;
               }},
    KindOfMesh{"cube",
               [](Random& r) {
                 const Shape shape = shapes::cube();
                 return r.below(2) ? shapes::subdivided(shape) : shape;
               }},
    KindOfMesh{"icosphere", [](Random& r) { return shapes::icosphere(r.below(2)); }},
    KindOfMesh{"prism", [](Random& r) { return prism(3 + r.below(12)); }},
    KindOfMesh{"torus", [](Random& r) { return shapes::torus(3 + r.below(5), 3 + r.below(4)); }},
    KindOfMesh{"perforated plate", [](Random& r) { return shapes::perforatedPlate(r.below(4)); }},
    KindOfMesh{"bumpy surface",
               [](Random& r) {
                 const int genus = r.below(4);
                 return shapes::bumpySurface(genus, 1, r.uniform(0.1, 0.6), seedFrom(r));
               }},
    KindOfMesh{"sphere with holes",
               [](Random& r) {
                 return shapes::withoutRandomFaces(shapes::icosphere(1), 1 + r.below(30),
                                                   seedFrom(r));
               }},
    KindOfMesh{"bumpy surface with holes",
               [](Random& r) {
                 const Shape closed = shapes::bumpySurface(r.below(3), 1, 0.4, seedFrom(r));
                 return shapes::withoutRandomFaces(closed, 1 + r.below(10), seedFrom(r));
               }},
    KindOfMesh{"cylinder",
               [](Random& r) { return shapes::cylinder(3 + r.below(8), 1 + r.below(4)); }},
    KindOfMesh{"Moebius strip",
               [](Random& r) { return shapes::moebiusStrip(3 + r.below(10), 1 + r.below(3)); }},
    KindOfMesh{"covered polygon",
               [](Random& r) { return coveredPolygon(3 + r.below(10), r.below(2) ? 0.1 : 1e-6); }},
    KindOfMesh{"folded grid", [](Random& r) { return foldedGrid(1 + r.below(4)); }},
    KindOfMesh{"several components",
               [](Random& r) {
                 Shape shape = shapes::joined(shapes::octahedron(),
                                              shapes::moved(shapes::grid(2, 2), {3, 0, 0}));
                 if (r.below(2))
                   shape = shapes::joined(shape, shapes::moved(shapes::triangle(), {6, 0, 0}));
                 return shape;
               }},
    KindOfMesh{"soup", [](Random& r) { return soup(r); }},
};

/// Whether doubles tell the ends of all edges apart by more than the rounding of a position.
bool hasVisibleEdges(const TriangleMesh& mesh) {
  const double least = 1e-12 * mesh.boundingDiagonal();
  for (int h = 0; h < mesh.halfedgeCount(); ++h)  // of positions: short edges have been lengthened
    if ((mesh.position(mesh.tip(h)) - mesh.position(mesh.tail(h))).norm() < least) return false;
  return true;
}

/// Turned at random, and of a size that is no power of two.
Shape turnedAndScaled(Shape shape, Random& random) {
  const auto part = [&] { return random.uniform(-1, 1); };
  const double w = part(), x = part(), y = part(), z = part();
  const Eigen::Quaterniond turn = Eigen::Quaterniond(w, x, y, z).normalized();
  const double size = std::pow(10, random.below(13) - 6) / 3;
  for (int v = 0; v < shape.vertexCount(); ++v)
    shape.setPosition(v, size * (turn * shape.position(v)));
  return shape;
}

// --- Sites ---------------------------------------------------------------------------------------

SurfacePoint vertexSite(int h) { return {TriangleMesh::faceOf(h), Vector3d::Unit(h % 3)}; }

SurfacePoint edgeSite(int h, double share) {
  Vector3d bary = Vector3d::Zero();
  bary[h % 3] = 1 - share;
  bary[(h + 1) % 3] = share;
  return {TriangleMesh::faceOf(h), bary};
}

SurfacePoint randomInFace(int face, Random& random) {
  double a = random.uniform(), b = random.uniform();
  if (a + b > 1) a = 1 - a, b = 1 - b;
  return {face, {a, b, std::max(0.0, 1 - a - b)}};
}

/// One to twelve, few more often than many.
int fewOf(Random& random) { return 1 + random.below(1 + random.below(12)); }

Eigen::Vector2d apexOf(const TriangleMesh& mesh, int h) {
  return gvd::apexOf(mesh.face(TriangleMesh::faceOf(h)), h % 3);
}

/// Where a point at (x, y) in the coordinates of a halfedge lies.
SurfacePoint atCoordinates(const TriangleMesh& mesh, int h, double x, double y) {
  const Eigen::Vector2d apex = apexOf(mesh, h);
  Vector3d bary;
  bary[(h + 2) % 3] = y / apex.y();
  bary[(h + 1) % 3] = (x - apex.x() * bary[(h + 2) % 3]) / mesh.length(h);
  bary[h % 3] = 1 - bary[(h + 1) % 3] - bary[(h + 2) % 3];
  return {TriangleMesh::faceOf(h), bary};
}

bool isInside(const SurfacePoint& p) { return p.bary.allFinite() && p.bary.minCoeff() >= 0; }

/// In every face around a vertex, at the same distance from it.
Sites circleAroundVertex(const TriangleMesh& mesh, Random& random) {
  const int v = random.below(mesh.vertexCount());
  std::vector<int> around;
  for (int h = mesh.outgoing(v); h >= 0; h = mesh.rotate(h)) {
    around.push_back(h);
    if (mesh.rotate(h) == mesh.outgoing(v)) break;
  }
  double radius = kInfinity;
  for (const int h : around)
    radius = std::min(radius, 0.4 * apexOf(mesh, TriangleMesh::next(h)).y());
  const double place = random.below(2) ? 0.5 : random.uniform();  // where in each angle
  Sites sites;
  for (const int h : around) {
    const double angle = place * mesh.cornerAngle(h);
    const auto p = atCoordinates(mesh, h, radius * std::cos(angle), radius * std::sin(angle));
    if (isInside(p)) sites.push_back(p);
  }
  return sites;
}

/// Around the centre of a face's incircle, inside of the face.
Sites circleInFace(const TriangleMesh& mesh, Random& random) {
  const int face = random.below(mesh.faceCount());
  const double opposite[] = {mesh.length(3 * face + 1), mesh.length(3 * face + 2),
                             mesh.length(3 * face)};
  const double perimeter = opposite[0] + opposite[1] + opposite[2];
  const Eigen::Vector2d apex = apexOf(mesh, 3 * face);
  const double x = (opposite[1] * opposite[2] + opposite[2] * apex.x()) / perimeter;
  const double inradius = opposite[2] * apex.y() / perimeter, y = inradius;
  const int n = 3 + random.below(22);
  Sites sites;
  for (int i = 0; i < n; ++i) {
    const Vector3d on = 0.9 * inradius * onUnitCircle(i, n);
    const auto p = atCoordinates(mesh, 3 * face, x + on.x(), y + on.y());
    if (isInside(p)) sites.push_back(p);
  }
  return sites;
}

/// The same coordinates in every face, from every corner, or in some faces only.
Sites alikeInFaces(const TriangleMesh& mesh, Random& random) {
  constexpr std::array<std::array<double, 3>, 4> kPlaces = {
      {{0.5, 0.25, 0.25}, {1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.6, 0.4, 0}, {0.8, 0.15, 0.05}}};
  const auto& place = kPlaces[random.below(4)];
  const int corners = random.below(2) ? 3 : 1, stride = 1 + random.below(4);
  Sites sites;
  for (int f = 0; f < mesh.faceCount(); f += stride)
    for (int i = 0; i < corners; ++i)
      sites.push_back({f, {place[i], place[(i + 1) % 3], place[(i + 2) % 3]}});
  return sites;
}

/// Each of a few points again at `distance` of a face's size: 0, or too little to see.
Sites nearCoincident(const TriangleMesh& mesh, double distance, Random& random) {
  Sites sites;
  for (int i = fewOf(random); i > 0; --i) {
    const SurfacePoint p = randomInFace(random.below(mesh.faceCount()), random);
    sites.push_back(p);
    for (int copies = 1 + random.below(3); copies > 0; --copies) {
      SurfacePoint q = p;
      const double step = std::min(distance * random.uniform(0.5, 1), q.bary[0]);
      q.bary[0] -= step;
      q.bary[1] += step;
      sites.push_back(q);
    }
  }
  return sites;
}

/// A vertex from every face around it: one place, many names.
Sites oneVertexByAllNames(const TriangleMesh& mesh, Random& random) {
  const int v = random.below(mesh.vertexCount());
  Sites sites;
  for (int h = 0; h < mesh.halfedgeCount(); ++h)
    if (mesh.tail(h) == v) sites.push_back(vertexSite(h));
  return sites;
}

struct KindOfSites {
  const char* name;
  Sites (*make)(const TriangleMesh&, Random&);
};

/// A few sites, or as many as there are places of this kind, each by `place(index)`.
template <class Place>
Sites someOrAll(int count, Random& random, Place place) {
  Sites sites;
  if (random.below(5) == 0) {
    for (int i = 0; i < count; ++i) sites.push_back(place(i));
  } else {
    for (int n = fewOf(random); n > 0; --n) sites.push_back(place(random.below(count)));
  }
  return sites;
}

constexpr std::array kSites = {
    KindOfSites{"anywhere",
                [](const TriangleMesh& m, Random& r) {
                  const int count = fewOf(r);
                  return sampleUniform(m, count, seedFrom(r));
                }},
    KindOfSites{"more than vertices",
                [](const TriangleMesh& m, Random& r) {
                  return sampleUniform(m, 2 * m.vertexCount(), seedFrom(r));
                }},
    KindOfSites{"vertices",
                [](const TriangleMesh& m, Random& r) {
                  return someOrAll(m.vertexCount(), r,
                                   [&](int v) { return vertexSite(m.outgoing(v)); });
                }},
    KindOfSites{"midpoints of edges",
                [](const TriangleMesh& m, Random& r) {
                  return someOrAll(m.halfedgeCount(), r, [](int h) { return edgeSite(h, 0.5); });
                }},
    KindOfSites{"on edges",
                [](const TriangleMesh& m, Random& r) {
                  return someOrAll(m.halfedgeCount(), r,
                                   [&](int h) { return edgeSite(h, r.uniform()); });
                }},
    KindOfSites{"centroids",
                [](const TriangleMesh& m, Random& r) {
                  return someOrAll(m.faceCount(), r, [](int f) { return centroid(f); });
                }},
    KindOfSites{"all in one face",
                [](const TriangleMesh& m, Random& r) {
                  const int face = r.below(m.faceCount());
                  Sites sites;
                  for (int n = fewOf(r); n > 0; --n) sites.push_back(randomInFace(face, r));
                  return sites;
                }},
    KindOfSites{"on a circle around a vertex", circleAroundVertex},
    KindOfSites{"on a circle in a face", circleInFace},
    KindOfSites{"alike in faces", alikeInFaces},
    KindOfSites{"coincident",
                [](const TriangleMesh& m, Random& r) { return nearCoincident(m, 0, r); }},
    KindOfSites{"1e-13 apart",
                [](const TriangleMesh& m, Random& r) { return nearCoincident(m, 1e-13, r); }},
    KindOfSites{"1e-9 apart",
                [](const TriangleMesh& m, Random& r) { return nearCoincident(m, 1e-9, r); }},
    KindOfSites{"one vertex by all names", oneVertexByAllNames},
};

/// Of one kind, or of two together; never none.
Sites randomSites(const TriangleMesh& mesh, Random& random, std::string& kind) {
  Sites sites;
  for (int kinds = random.below(4) == 0 ? 2 : 1; kinds > 0; --kinds) {
    const KindOfSites& chosen = kSites[random.below(static_cast<int>(kSites.size()))];
    kind += std::string(kind.ends_with(": ") ? "" : " and ") + chosen.name;
    const Sites more = chosen.make(mesh, random);
    sites.insert(sites.end(), more.begin(), more.end());
  }
  if (sites.empty()) sites.push_back(centroid(0));
  return sites;
}

// --- Shrinking -----------------------------------------------------------------------------------

RandomCase withoutFaces(const RandomCase& c, int first, int count) {
  RandomCase result{c.kind, {c.shape.positions, {}}, {}};
  for (int f = 0; f < c.shape.faceCount(); ++f)
    if (f < first || f >= first + count)
      result.shape.addTriangle(c.shape.triangles[3 * f], c.shape.triangles[3 * f + 1],
                               c.shape.triangles[3 * f + 2]);
  for (SurfacePoint site : c.sites) {
    if (site.face >= first && site.face < first + count) continue;
    if (site.face >= first) site.face -= count;
    result.sites.push_back(site);
  }
  return result;
}

RandomCase withoutSites(const RandomCase& c, int first, int count) {
  RandomCase result = c;
  result.sites.erase(result.sites.begin() + first, result.sites.begin() + first + count);
  return result;
}

/// Removes ever smaller runs of items while the rest still fails; true if any could go.
template <class Count, class Without, class Fails>
bool removeRuns(RandomCase& c, Count countOf, Without without, const Fails& fails) {
  bool removed = false;
  for (int run = std::max(1, countOf(c) / 2);; run /= 2) {
    for (int first = 0; first + run <= countOf(c);) {
      RandomCase smaller = without(c, first, run);
      if (!smaller.sites.empty() && smaller.shape.faceCount() > 0 && fails(smaller)) {
        c = std::move(smaller);
        removed = true;
      } else {
        first += run;
      }
    }
    if (run <= 1) return removed;
  }
}

void dropUnusedVertices(Shape& shape) {
  Shape result;
  std::vector<int> copy(shape.vertexCount(), -1);
  for (const int v : shape.triangles) {
    if (copy[v] < 0) copy[v] = result.addVertex(shape.position(v));
    result.triangles.push_back(copy[v]);
  }
  shape = std::move(result);
}

}  // namespace

std::vector<SurfacePoint> RandomCase::sitesOn(const TriangleMesh& mesh) const {
  Sites result;
  for (const SurfacePoint& site : sites) result.push_back(mesh.fromInput(site));
  return result;
}

RandomCase randomCase(std::uint64_t seed) {
  Random random(seed);
  RandomCase result;
  do {
    const KindOfMesh& chosen = kMeshes[random.below(static_cast<int>(kMeshes.size()))];
    result = {std::string(chosen.name) + ": ", chosen.make(random), {}};
  } while (!hasVisibleEdges(result.mesh()));
  if (random.below(2)) result.shape = turnedAndScaled(std::move(result.shape), random);
  const TriangleMesh mesh = result.mesh();
  for (const SurfacePoint& site : randomSites(mesh, random, result.kind))
    result.sites.push_back(mesh.toInput(site));
  return result;
}

RandomCase wildCase(std::uint64_t seed) {
  Random random(seed);
  for (;;) {
    // A few are large, and so may have many components.
    const int mostTriangles = random.below(50) == 0 ? 3000 : random.below(4) == 0 ? 100 : 20;
    RandomCase result{"wild: ", wildMesh(random, mostTriangles), {}};
    try {
      const TriangleMesh mesh = result.mesh();
      for (const SurfacePoint& site : randomSites(mesh, random, result.kind))
        result.sites.push_back(mesh.toInput(site));
      return result;
    } catch (const Error&) {
    }
  }
}

RandomCase shrunk(RandomCase c, const std::function<bool(const RandomCase&)>& fails) {
  const auto sites = [](const RandomCase& c) { return static_cast<int>(c.sites.size()); };
  const auto faces = [](const RandomCase& c) { return c.shape.faceCount(); };
  for (bool smaller = true; smaller;) {
    smaller = removeRuns(c, sites, withoutSites, fails);
    smaller |= removeRuns(c, faces, withoutFaces, fails);
  }
  RandomCase compact = c;
  dropUnusedVertices(compact.shape);
  return fails(compact) ? compact : c;
}

std::string sourceOf(const RandomCase& c) {
  std::ostringstream out;
  out << std::setprecision(17) << "const shapes::Shape shape{\n    {";
  for (int v = 0; v < c.shape.vertexCount(); ++v) {
    const Vector3d p = c.shape.position(v);
    out << (v > 0 ? ",\n     " : "") << p.x() << ", " << p.y() << ", " << p.z();
  }
  out << "},\n    {";
  for (int f = 0; f < c.shape.faceCount(); ++f) {
    const int* corners = &c.shape.triangles[3 * f];
    out << (f > 0 ? ", " : "") << corners[0] << ", " << corners[1] << ", " << corners[2];
  }
  out << "}};\nconst std::vector<SurfacePoint> sites = {\n    ";
  for (size_t i = 0; i < c.sites.size(); ++i) {
    const Vector3d& b = c.sites[i].bary;
    out << (i > 0 ? ",\n    " : "") << '{' << c.sites[i].face << ", {" << b[0] << ", " << b[1]
        << ", " << b[2] << "}}";
  }
  out << "};\n";
  return out.str();
}

}  // namespace gvd
