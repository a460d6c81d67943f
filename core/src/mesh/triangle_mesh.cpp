// SPDX-License-Identifier: MIT
#include "gvd/triangle_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "gvd/error.h"

namespace gvd {
namespace {

/// The corners of a triangle: input vertices, or *places*, a place being the first of the input
/// vertices at one position.
using Corners = std::array<int, 3>;

/// How far barycentric coordinates given from outside may be off.
constexpr double kBarycentricTolerance = 1e-6;

/// Squared lengths of a mesh of this size still are finite, and so are their sums.
constexpr double kMaxBoundingDiagonal = 0x1p500;

// --- Small tools -------------------------------------------------------------------------------

std::vector<int> range(int count) {
  std::vector<int> items(count);
  std::iota(items.begin(), items.end(), 0);
  return items;
}

/// `items` ascending by key(item), which is in [0, keyCount); items of one key keep their order.
template <class Key>
std::vector<int> countingSort(const std::vector<int>& items, int keyCount, Key key) {
  std::vector<int> position(keyCount + 1, 0);
  for (int item : items) ++position[key(item) + 1];
  std::partial_sum(position.begin(), position.end(), position.begin());
  std::vector<int> sorted(items.size());
  for (int item : items) sorted[position[key(item)]++] = item;
  return sorted;
}

/// Calls visit(run) for every maximal run of items that are the same as the run's first.
template <class Same, class Visit>
void forEachRun(const std::vector<int>& items, Same same, Visit visit) {
  const int* const end = items.data() + items.size();
  for (const int* first = items.data(); first != end;) {
    const int* last = std::find_if(first, end, [&](int item) { return !same(*first, item); });
    visit(std::span(first, last));
    first = last;
  }
}

// --- Steps 1 to 3: which triangles stay --------------------------------------------------------

[[noreturn]] void rejectMesh(const std::string& why) { throw Error(ErrorCode::kInvalidMesh, why); }

void requireIndexedTriangles(std::span<const double> positions, std::span<const int> triangles) {
  const auto requireTriples = [](std::size_t count, const std::string& what) {
    if (count % 3 != 0) {
      rejectMesh("there are " + std::to_string(count) + " " + what + ", not a multiple of three");
    }
    if (count > std::numeric_limits<int>::max()) rejectMesh("there are too many " + what);
  };
  requireTriples(positions.size(), "coordinates");
  requireTriples(triangles.size(), "vertex indices");
  const int vertexCount = static_cast<int>(positions.size() / 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (triangles[i] >= 0 && triangles[i] < vertexCount) continue;
    rejectMesh("triangle " + std::to_string(i / 3) + " has vertex index " +
               std::to_string(triangles[i]) + ", but there are " + std::to_string(vertexCount) +
               " vertices");
  }
}

Eigen::Vector3d positionOf(std::span<const double> positions, int vertex) {
  return Eigen::Vector3d::Map(&positions[3 * static_cast<std::size_t>(vertex)]);
}

/// For every input vertex the first one at the same position; -1 where it is not finite.
std::vector<int> findPlaces(std::span<const double> positions) {
  struct Vertex {
    double x, y, z;
    int index;
    bool operator<(const Vertex& o) const {
      if (x != o.x) return x < o.x;
      if (y != o.y) return y < o.y;
      if (z != o.z) return z < o.z;
      return index < o.index;
    }
    bool samePosition(const Vertex& o) const { return x == o.x && y == o.y && z == o.z; }
  };
  std::vector<Vertex> vertices;
  vertices.reserve(positions.size() / 3);
  for (int v = 0; v < static_cast<int>(positions.size() / 3); ++v) {
    const Eigen::Vector3d p = positionOf(positions, v);
    if (p.allFinite()) vertices.push_back({p.x(), p.y(), p.z(), v});
  }
  std::sort(vertices.begin(), vertices.end());

  std::vector<int> place(positions.size() / 3, -1);
  const Vertex* first = nullptr;
  for (const Vertex& vertex : vertices) {
    if (!first || !vertex.samePosition(*first)) first = &vertex;
    place[vertex.index] = first->index;
  }
  return place;
}

/// The triangles that stay, in the input's order, and what became of each input triangle.
struct Selection {
  std::vector<int> input;        ///< of each kept triangle, the input triangle
  std::vector<Corners> corners;  ///< of each kept triangle, the places
  std::vector<int> kept;  ///< of each input triangle, the kept one of the same corners, or -1
};

/// For each of `candidates` (ascending) the first one that has the same three corners, in whichever
/// order.
std::vector<int> findOriginals(const std::vector<Corners>& corners,
                               const std::vector<int>& candidates, int vertexCount) {
  std::vector<Corners> sorted = corners;
  for (Corners& c : sorted) std::sort(c.begin(), c.end());
  std::vector<int> order = candidates;
  for (int i : {2, 1, 0}) {
    order = countingSort(order, vertexCount, [&](int t) { return sorted[t][i]; });
  }
  std::vector<int> original(corners.size(), -1);
  forEachRun(
      order, [&](int s, int t) { return sorted[s] == sorted[t]; },
      [&](std::span<const int> run) {
        for (int t : run) original[t] = run.front();
      });
  return original;
}

bool isFinite(const Corners& places) { return std::min({places[0], places[1], places[2]}) >= 0; }

bool isDegenerate(const Corners& places) {
  return places[0] == places[1] || places[1] == places[2] || places[2] == places[0];
}

std::vector<Corners> cornersAtPlaces(std::span<const int> triangles,
                                     const std::vector<int>& place) {
  std::vector<Corners> corners(triangles.size() / 3);
  for (std::size_t t = 0; t < corners.size(); ++t) {
    for (int i = 0; i < 3; ++i) corners[t][i] = place[triangles[3 * t + i]];
  }
  return corners;
}

std::string whyNothingIsLeft(int count, const MeshRepairs& repairs) {
  if (count == 0) return "there are no triangles";
  return "no triangle is left: of " + std::to_string(count) + " triangles " +
         std::to_string(repairs.nonFiniteTriangles) + " have a corner that is not finite and " +
         std::to_string(repairs.degenerateTriangles) + " have two corners at one position";
}

Selection selectTriangles(const std::vector<Corners>& corners, int vertexCount,
                          MeshRepairs& repairs) {
  const int count = static_cast<int>(corners.size());
  std::vector<int> candidates;
  candidates.reserve(count);
  for (int t = 0; t < count; ++t) {
    if (!isFinite(corners[t])) {
      ++repairs.nonFiniteTriangles;
    } else if (isDegenerate(corners[t])) {
      ++repairs.degenerateTriangles;
    } else {
      candidates.push_back(t);
    }
  }
  const std::vector<int> original = findOriginals(corners, candidates, vertexCount);

  Selection selection;
  selection.kept.assign(count, -1);
  for (int t : candidates) {
    if (original[t] == t) {
      selection.kept[t] = static_cast<int>(selection.input.size());
      selection.input.push_back(t);
      selection.corners.push_back(corners[t]);
    } else {
      selection.kept[t] = selection.kept[original[t]];
      ++repairs.duplicateTriangles;
    }
  }
  if (selection.input.empty()) rejectMesh(whyNothingIsLeft(count, repairs));
  return selection;
}

// --- Steps 4 and 5: neighbours and orientation -------------------------------------------------

/// Halfedge h of the triangles is side h % 3 of triangle h / 3, as in the mesh to be made.
int tailOf(const std::vector<Corners>& triangles, int h) { return triangles[h / 3][h % 3]; }
int tipOf(const std::vector<Corners>& triangles, int h) { return triangles[h / 3][(h + 1) % 3]; }

/// The halfedge on the other side of each edge of exactly two triangles, whichever way it runs;
/// -1 on all other edges.
std::vector<int> matchHalfedges(const std::vector<Corners>& triangles, int vertexCount,
                                MeshRepairs& repairs) {
  const int halfedgeCount = 3 * static_cast<int>(triangles.size());
  std::vector<std::pair<int, int>> ends(halfedgeCount);
  for (int h = 0; h < halfedgeCount; ++h) {
    ends[h] = std::minmax({tailOf(triangles, h), tipOf(triangles, h)});
  }
  std::vector<int> order = range(halfedgeCount);
  order = countingSort(order, vertexCount, [&](int h) { return ends[h].second; });
  order = countingSort(order, vertexCount, [&](int h) { return ends[h].first; });

  std::vector<int> twin(halfedgeCount, -1);
  forEachRun(
      order, [&](int g, int h) { return ends[g] == ends[h]; },
      [&](std::span<const int> run) {
        if (run.size() == 2) {
          twin[run[0]] = run[1];
          twin[run[1]] = run[0];
        } else if (run.size() > 2) {
          ++repairs.nonManifoldEdges;
        }
      });
  return twin;
}

struct Orientation {
  std::vector<int> component;  ///< of each triangle, numbered in order of the first triangle
  std::vector<char> flipped;   ///< whether the triangle has to be turned over
  int components = 0;
};

/// Spreads the orientation of each component's first triangle breadth first, then turns the whole
/// component over if that suits the majority better.
Orientation orient(const std::vector<Corners>& triangles, const std::vector<int>& twin,
                   MeshRepairs& repairs) {
  const int count = static_cast<int>(triangles.size());
  Orientation result{std::vector<int>(count, -1), std::vector<char>(count, false)};
  std::vector<int> queue;
  queue.reserve(count);
  for (int root = 0; root < count; ++root) {
    if (result.component[root] >= 0) continue;
    const std::size_t begin = queue.size();
    result.component[root] = result.components;
    queue.push_back(root);
    int flips = 0;
    for (std::size_t i = begin; i < queue.size(); ++i) {
      const int f = queue[i];
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        if (twin[h] < 0 || result.component[twin[h] / 3] >= 0) continue;
        const int neighbour = twin[h] / 3;
        const bool disagree = tailOf(triangles, h) == tailOf(triangles, twin[h]);
        result.component[neighbour] = result.components;
        result.flipped[neighbour] = result.flipped[f] != disagree;
        flips += result.flipped[neighbour];
        queue.push_back(neighbour);
      }
    }
    const int members = static_cast<int>(queue.size() - begin);
    if (2 * static_cast<std::int64_t>(flips) > members) {
      for (std::size_t i = begin; i < queue.size(); ++i) result.flipped[queue[i]] ^= 1;
      flips = members - flips;
    }
    repairs.flippedTriangles += flips;
    ++result.components;
  }
  return result;
}

/// Cuts the edges whose two triangles still disagree.
void cutWhereOrientationsDisagree(const std::vector<Corners>& triangles,
                                  const Orientation& orientation, std::vector<int>& twin,
                                  MeshRepairs& repairs) {
  for (int h = 0; h < static_cast<int>(twin.size()); ++h) {
    if (twin[h] < h) continue;  // no twin, or seen from there
    const bool disagreed = tailOf(triangles, h) == tailOf(triangles, twin[h]);
    if ((orientation.flipped[h / 3] != orientation.flipped[twin[h] / 3]) == disagreed) continue;
    twin[twin[h]] = -1;
    twin[h] = -1;
    ++repairs.orientationCuts;
  }
}

/// Turns the flipped triangles over: (a, b, c) becomes (a, c, b), so that side i becomes side 2 -
/// i. The sides keep their neighbours.
void turnOver(const std::vector<char>& flipped, std::vector<Corners>& triangles,
              std::vector<int>& twin) {
  const auto moved = [&](int h) { return flipped[h / 3] ? h - h % 3 + (2 - h % 3) : h; };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!flipped[t]) continue;
    std::swap(triangles[t][1], triangles[t][2]);
    std::swap(twin[3 * t], twin[3 * t + 2]);
  }
  for (int& h : twin) {
    if (h >= 0) h = moved(h);
  }
}

// --- Measures ----------------------------------------------------------------------------------

/// |v|, positive unless v is zero: components whose squares would underflow or overflow are scaled
/// first.
double lengthOf(const Eigen::Vector3d& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  if (0x1p-400 < largest && largest < 0x1p400) return v.norm();
  if (largest == 0) return 0;
  return largest * (v / largest).norm();
}

/// The angle between the sides a and b of a triangle with third side c: accurate for needles and
/// caps too (W. Kahan, "Miscalculating Area and Angles of a Needle-like Triangle"). Lengths that
/// rounding made break the triangle inequality count as a flat triangle.
double angleBetween(double a, double b, double c) {
  if (a < b) std::swap(a, b);
  const double mu = std::max(0.0, b >= c ? c - (a - b) : b - (a - c));
  const double nu = std::max(0.0, (a - c) + b);
  // Roots before products, which could underflow.
  return 2 *
         std::atan2(std::sqrt((a - b) + c) * std::sqrt(mu), std::sqrt(a + (b + c)) * std::sqrt(nu));
}

/// Lays a face out on each of its sides, whose lengths are known.
void layOut(std::span<TriangleMesh::Layout, 3> sides) {
  std::array<double, 3> lengths = {sides[0].length, sides[1].length, sides[2].length};
  std::sort(lengths.begin(), lengths.end());
  const auto [c, b, a] = lengths;
  // 4·area = p·q, by Heron's formula in the order of Kahan: accurate for needles, where the
  // difference of two squares would cancel, and where (a + b) - c would lose c.
  const double p = std::sqrt(a + (b + c)) * std::sqrt(std::max(0.0, c - (a - b)));
  const double q = std::sqrt(c + (a - b)) * std::sqrt(a + (b - c));
  for (int i = 0; i < 3; ++i) {
    TriangleMesh::Layout& side = sides[i];
    const double toTip = sides[(i + 1) % 3].length, toTail = sides[(i + 2) % 3].length;
    side.inverse = 1 / (2 * side.length);
    side.x = (side.length + (toTail - toTip) / side.length * (toTail + toTip)) / 2;
    side.y = p * side.inverse * q;
  }
}

// --- Where the input went ----------------------------------------------------------------------

/// For each degenerate triangle, a face with corners at all of its places, or -1; the other entries
/// of `face` stay.
void findFacesOfDegenerateTriangles(const std::vector<Corners>& triangles,
                                    const std::vector<Corners>& faces, std::vector<int>& face) {
  const auto isSought = [&](int t) { return isFinite(triangles[t]) && isDegenerate(triangles[t]); };
  const auto ends = [&](int t) {
    const auto [low, high] = std::minmax_element(triangles[t].begin(), triangles[t].end());
    return std::pair(*low, *high);
  };
  std::map<std::pair<int, int>, int> faceWith;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    if (isSought(t)) faceWith.emplace(ends(t), -1);
  }
  if (faceWith.empty()) return;

  const auto offer = [&](int a, int b, int f) {
    const auto sought = faceWith.find(std::minmax(a, b));
    if (sought != faceWith.end() && sought->second < 0) sought->second = f;
  };
  for (int h = 0; h < 3 * static_cast<int>(faces.size()); ++h) {
    offer(tailOf(faces, h), tailOf(faces, h), h / 3);
    offer(tailOf(faces, h), tipOf(faces, h), h / 3);
  }
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    if (isSought(t)) face[t] = faceWith.at(ends(t));
  }
}

/// For every corner of every input triangle the halfedge that leaves its place on the triangle's
/// face, or -1 if it has none. `triangles` and `faces` are made of places.
std::vector<Corners> mapInputCorners(const std::vector<Corners>& triangles,
                                     const std::vector<Corners>& faces,
                                     const std::vector<int>& face) {
  std::vector<Corners> halfedges(triangles.size(), {-1, -1, -1});
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (face[t] < 0) continue;
    const Corners& corners = faces[face[t]];
    for (int i = 0; i < 3; ++i) {
      const auto at = std::find(corners.begin(), corners.end(), triangles[t][i]);
      halfedges[t][i] = 3 * face[t] + static_cast<int>(at - corners.begin());
    }
  }
  return halfedges;
}

/// For every input vertex a halfedge that leaves it: on the first triangle that names the vertex
/// and has a face, else anywhere at its place; -1 if there is none.
std::vector<int> mapInputVertices(std::span<const int> triangles, const std::vector<int>& place,
                                  const std::vector<Corners>& halfedgesOfInput) {
  std::vector<int> ofVertex(place.size(), -1), ofPlace(place.size(), -1);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const int h = halfedgesOfInput[i / 3][i % 3];
    if (h < 0) continue;
    for (int* slot : {&ofVertex[triangles[i]], &ofPlace[place[triangles[i]]]}) {
      if (*slot < 0) *slot = h;
    }
  }
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (ofVertex[v] < 0 && place[v] >= 0) ofVertex[v] = ofPlace[place[v]];
  }
  return ofVertex;
}

void countInputVertices(const std::vector<int>& halfedgeOfInput, const std::vector<int>& place,
                        MeshRepairs& repairs) {
  for (int v = 0; v < static_cast<int>(place.size()); ++v) {
    if (halfedgeOfInput[v] < 0) {
      ++repairs.isolatedVertices;
    } else if (place[v] != v) {
      ++repairs.weldedVertices;
    }
  }
}

// --- Points from outside ------------------------------------------------------------------------

[[noreturn]] void rejectPoint(const std::string& why) {
  throw Error(ErrorCode::kInvalidPoint, why);
}

/// Non-negative coordinates of sum 1 from such that may be off by the tolerance.
Eigen::Vector3d cleanBarycentric(const Eigen::Vector3d& bary) {
  for (double b : bary) {
    if (!std::isfinite(b)) rejectPoint("a barycentric coordinate is not a finite number");
    if (b < -kBarycentricTolerance) {
      rejectPoint("the barycentric coordinate " + std::to_string(b) + " is negative");
    }
  }
  if (std::abs(bary.sum() - 1) > kBarycentricTolerance) {
    rejectPoint("the barycentric coordinates sum to " + std::to_string(bary.sum()) + ", not 1");
  }
  const Eigen::Vector3d clamped = bary.cwiseMax(0.0);
  return clamped / clamped.sum();
}

}  // namespace

// --- Construction ------------------------------------------------------------------------------

TriangleMesh::TriangleMesh(std::span<const double> positions, std::span<const int> triangles) {
  requireIndexedTriangles(positions, triangles);
  const int inputVertexCount = static_cast<int>(positions.size() / 3);
  const std::vector<int> place = findPlaces(positions);
  const std::vector<Corners> inputCorners = cornersAtPlaces(triangles, place);
  Selection selection = selectTriangles(inputCorners, inputVertexCount, repairs_);

  twin_ = matchHalfedges(selection.corners, inputVertexCount, repairs_);
  Orientation orientation = orient(selection.corners, twin_, repairs_);
  cutWhereOrientationsDisagree(selection.corners, orientation, twin_, repairs_);
  turnOver(orientation.flipped, selection.corners, twin_);

  inputFace_ = std::move(selection.input);
  flipped_ = std::move(orientation.flipped);
  component_ = std::move(orientation.component);
  for (const Corners& c : selection.corners) tail_.insert(tail_.end(), c.begin(), c.end());
  splitFans(inputVertexCount);
  copyPositions(positions);
  measure();
  countTopology(orientation.components);

  std::vector<int>& faceOf = selection.kept;
  findFacesOfDegenerateTriangles(inputCorners, selection.corners, faceOf);
  faceOfInput_ = mapInputCorners(inputCorners, selection.corners, faceOf);
  vertexOfInput_ = mapInputVertices(triangles, place, faceOfInput_);
  countInputVertices(vertexOfInput_, place, repairs_);
}

/// Step 6. `tail_` holds places before and vertices after. Vertices keep the order of their places;
/// the copies for further fans come last.
void TriangleMesh::splitFans(int inputVertexCount) {
  std::vector<int> vertexAt(inputVertexCount, -1);
  for (int place : tail_) vertexAt[place] = 0;
  for (int place = 0; place < inputVertexCount; ++place) {
    if (vertexAt[place] < 0) continue;
    vertexAt[place] = static_cast<int>(inputVertex_.size());
    inputVertex_.push_back(place);
  }

  vertexHalfedge_.assign(inputVertex_.size(), -1);
  std::vector<int> vertex(tail_.size(), -1);
  for (int h = 0; h < halfedgeCount(); ++h) {
    if (vertex[h] >= 0) continue;
    int v = vertexAt[tail_[h]];
    if (vertexHalfedge_[v] >= 0) {  // another fan has it already
      v = vertexCount();
      vertexHalfedge_.push_back(-1);
      inputVertex_.push_back(tail_[h]);
      ++repairs_.splitVertices;
    }
    int first = h;
    while (twin_[first] >= 0 && next(twin_[first]) != h) first = next(twin_[first]);
    if (twin_[first] >= 0) first = h;  // a full turn: an inner vertex
    vertexHalfedge_[v] = first;
    int g = first;
    do {
      vertex[g] = v;
      g = rotate(g);
    } while (g >= 0 && g != first);
  }
  tail_ = std::move(vertex);
}

void TriangleMesh::copyPositions(std::span<const double> positions) {
  positions_.resize(3, vertexCount());
  for (int v = 0; v < vertexCount(); ++v) {
    positions_.col(v) = positionOf(positions, inputVertex_[v]);
  }
  if (!(boundingDiagonal() <= kMaxBoundingDiagonal)) {
    rejectMesh("the positions are too far apart to measure distances");
  }
}

void TriangleMesh::measure() {
  layout_.resize(halfedgeCount());
  angle_.resize(halfedgeCount());
  angleSum_.assign(vertexCount(), 0);
  for (int h = 0; h < halfedgeCount(); ++h) {
    // The same bits for both halfedges: a difference turned around changes its signs only.
    layout_[h].length = lengthOf(position(tip(h)) - position(tail(h)));
  }
  for (int h = 0; h < halfedgeCount(); ++h) {
    angle_[h] = angleBetween(length(h), length(previous(h)), length(next(h)));
    angleSum_[tail(h)] += angle_[h];
  }
  for (int f = 0; f < faceCount(); ++f) {
    layOut(std::span<Layout, 3>(&layout_[3 * f], 3));
  }
  faceArea_.resize(faceCount());
  for (int f = 0; f < faceCount(); ++f) {
    const Eigen::Vector3d a = position(tail(3 * f));
    const Eigen::Vector3d ab = position(tail(3 * f + 1)) - a, ac = position(tail(3 * f + 2)) - a;
    faceArea_[f] = ab.cross(ac).norm() / 2;
    area_ += faceArea_[f];
  }
  for (const Layout& layout : layout_) meanEdgeLength_ += layout.length / halfedgeCount();
}

void TriangleMesh::countTopology(int components) {
  const int boundaryEdges = static_cast<int>(std::count(twin_.begin(), twin_.end(), -1));
  topology_.edges = (halfedgeCount() + boundaryEdges) / 2;
  topology_.components = components;
  topology_.eulerCharacteristic = vertexCount() - topology_.edges + faceCount();

  std::vector<char> seen(vertexCount(), false);
  for (int start = 0; start < vertexCount(); ++start) {
    if (!onBoundary(start) || seen[start]) continue;
    boundaryLoops_.push_back(outgoing(start));
    for (int v = start; !seen[v]; v = tip(outgoing(v))) seen[v] = true;
  }
  topology_.boundaryLoops = static_cast<int>(boundaryLoops_.size());
  topology_.genus = (2 * components - topology_.boundaryLoops - topology_.eulerCharacteristic) / 2;
}

// --- Measures of the surface -------------------------------------------------------------------

Eigen::Vector3d TriangleMesh::position(const SurfacePoint& p) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) sum += p.bary[i] * position(tail(3 * p.face + i));
  return sum;
}

double TriangleMesh::boundingDiagonal() const {
  return lengthOf(positions_.rowwise().maxCoeff() - positions_.rowwise().minCoeff());
}

// --- To and from the input ---------------------------------------------------------------------

SurfacePoint TriangleMesh::toInput(const SurfacePoint& p) const {
  SurfacePoint input{inputFace_[p.face], p.bary};
  if (isFlipped(p.face)) std::swap(input.bary[1], input.bary[2]);
  return input;
}

SurfacePoint TriangleMesh::fromInput(const SurfacePoint& p) const {
  if (p.face < 0 || p.face >= inputFaceCount()) {
    rejectPoint("there is no triangle " + std::to_string(p.face));
  }
  const Corners& halfedges = faceOfInput_[p.face];
  if (halfedges[0] < 0) {
    rejectPoint("triangle " + std::to_string(p.face) +
                " was dropped and no other triangle has its points");
  }
  const Eigen::Vector3d bary = cleanBarycentric(p.bary);
  SurfacePoint q{faceOf(halfedges[0]), Eigen::Vector3d::Zero()};
  for (int i = 0; i < 3; ++i) q.bary[halfedges[i] % 3] += bary[i];
  return q;
}

SurfacePoint TriangleMesh::fromInputVertex(int inputVertex) const {
  if (inputVertex < 0 || inputVertex >= inputVertexCount()) {
    rejectPoint("there is no vertex " + std::to_string(inputVertex));
  }
  const int h = vertexOfInput_[inputVertex];
  if (h < 0) rejectPoint("no triangle of the surface uses vertex " + std::to_string(inputVertex));
  return {faceOf(h), Eigen::Vector3d::Unit(h % 3)};
}

}  // namespace gvd
