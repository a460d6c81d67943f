// SPDX-License-Identifier: MIT
#include "gvd/polygon_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/index_pairs.h"
#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "mesh/corners.h"
#include "mesh/genus.h"
#include "partition/convex_triangulation.h"

namespace gvd {
namespace {

/// Corners of faces that take one unit of the budget.
constexpr long kCornersPerUnit = 4;

/// A loop over the faces of a polygon mesh, as a part of a `SlicedSequence`.
template <class Body>
auto forFaces(const PolygonMesh& mesh, long& budget, Body body) {
  return forEach(mesh.faces.size(), budget, kCornersPerUnit, [&mesh, body](int f) {
    body(f);
    return static_cast<long>(mesh.faces[f].size()) + 1;
  });
}

// Not inlined, as the WebAssembly module would be larger.
[[gnu::noinline]] void requireVertices(const PolygonMesh& mesh, int face) {
  const int vertexCount = static_cast<int>(mesh.positions.size());
  for (const int v : mesh.faces[face])
    if (v < 0 || v >= vertexCount)
      rejectArgument("polygon " + std::to_string(face) + ": there is no vertex " +
                     std::to_string(v));
}

class Triangulating final : public SequentialWork<PolygonTriangles> {
 public:
  explicit Triangulating(const PolygonMesh& mesh) : mesh_(mesh) {}

  bool advance(long budget) override {
    // A polygon of d corners has d sides and d - 3 diagonals.
    const size_t corners = mesh_.faces.points.size();
    return sequence_.run([&] { return joined_.prepare(2 * corners, budget); },
                         forFaces(mesh_, budget, [&](int f) { joinSides(f); }),
                         forFaces(mesh_, budget, [&](int f) { cut(f); }));
  }

 private:
  void joinSides(int f) {
    requireVertices(mesh_, f);
    const auto polygon = mesh_.faces[f];
    for (size_t i = 0; i < polygon.size(); ++i)
      joined_.add(polygon[i], polygon[(i + 1) % polygon.size()]);
  }

  void cut(int f) {
    const auto polygon = mesh_.faces[f];
    if (polygon.size() < 3) return;
    const auto position = [&](size_t i) { return mesh_.positions[polygon[i % polygon.size()]]; };
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (size_t i = 0; i < polygon.size(); ++i)
      normal += (position(i) - position(0)).cross(position(i + 1) - position(0));
    const Eigen::Vector3d x = normal.unitOrthogonal(), y = normal.stableNormalized().cross(x);
    corners_.clear();
    for (size_t i = 0; i < polygon.size(); ++i)
      corners_.emplace_back(x.dot(position(i)), y.dot(position(i)));
    const auto isJoined = [&](int a, int b) { return joined_.find(polygon[a], polygon[b]) >= 0; };
    for (const auto& [a, b, c] : triangulation_.compute(corners_, isJoined)) {
      out_.triangles.push_back({polygon[a], polygon[b], polygon[c]});
      out_.face.push_back(f);
      joined_.add(polygon[a], polygon[b]);
      joined_.add(polygon[b], polygon[c]);
      joined_.add(polygon[a], polygon[c]);
    }
  }

  const PolygonMesh& mesh_;
  IndexPairs joined_;  ///< vertices with a side or a diagonal between them
  // Of the current polygon.
  std::vector<Eigen::Vector2d> corners_;
  ConvexTriangulation triangulation_;
};

/// Halfedge h leaves corner h in the list of all faces' corners.
class TopologyFinding final : public SequentialWork<PolygonTopology> {
 public:
  explicit TopologyFinding(const PolygonMesh& mesh)
      : mesh_(mesh),
        leaving_(mesh.positions.size(), -1),
        corners_(mesh.positions.size()),
        next_(mesh.faces.points.size()),
        previous_(next_.size()),
        twin_(next_.size(), -1),
        isWalked_(next_.size()) {
    out_.isManifold = true;
  }

  bool advance(long budget) override {
    return sequence_.run([&] { return sides_.prepare(next_.size(), budget); },
                         forFaces(mesh_, budget, [&](int f) { addFace(f); }),
                         forEach(leaving_, budget, kCornersPerUnit, [&](int v) { addVertex(v); }),
                         forEach(twin_, budget, kCornersPerUnit,
                                 [&](int h) {
                                   joinEnds(h);
                                   if (out_.isManifold) walkBoundaryFrom(h);
                                 }),
                         [&] { addUp(); });
  }

 private:
  int tail(int h) const { return mesh_.faces.points[h]; }
  int tip(int h) const { return tail(next_[h]); }
  /// The next halfedge that leaves the same vertex, counterclockwise; -1 past the last.
  int rotate(int h) const { return twin_[previous_[h]]; }
  int rotateBack(int h) const { return twin_[h] < 0 ? -1 : next_[twin_[h]]; }

  void addFace(int f) {
    requireVertices(mesh_, f);
    const int first = mesh_.faces.offset[f], end = mesh_.faces.offset[f + 1];
    if (first < end) ++out_.faces;
    for (int h = first; h < end; ++h) {
      next_[h] = h + 1 < end ? h + 1 : first;
      previous_[next_[h]] = h;
    }
    for (int h = first; h < end; ++h) addHalfedge(h);
    sorted_.assign(mesh_.faces[f].begin(), mesh_.faces[f].end());
    std::sort(sorted_.begin(), sorted_.end());
    if (std::adjacent_find(sorted_.begin(), sorted_.end()) != sorted_.end())
      out_.isManifold = false;
  }

  void addHalfedge(int h) {
    leaving_[tail(h)] = h;
    ++corners_[tail(h)];
    const size_t side = sides_.add(tail(h), tip(h));
    if (side == onSide_.size()) onSide_.push_back({-1, -1});
    // One per direction.
    int& own = onSide_[side][tail(h) > tip(h)];
    const int other = onSide_[side][tail(h) < tip(h)];
    if (own >= 0 || tail(h) == tip(h)) out_.isManifold = false;
    own = h;
    if (other < 0) return;
    twin_[h] = other;
    twin_[other] = h;
  }

  void addVertex(int v) {
    if (corners_[v] == 0) return;
    ++out_.vertices;
    ++out_.components;
    out_.isManifold = out_.isManifold && hasOneFan(v);
  }

  /// Whether the faces around a vertex form one fan: turning from face to face reaches all.
  bool hasOneFan(int v) const {
    int start = leaving_[v];
    for (int back = rotateBack(start); back >= 0 && back != leaving_[v]; back = rotateBack(back))
      start = back;
    int met = 1;
    for (int h = rotate(start); h >= 0 && h != start; h = rotate(h)) ++met;
    return met == corners_[v];
  }

  void walkBoundaryFrom(int start) {
    if (twin_[start] >= 0 || isWalked_[start]) return;
    ++out_.boundaryLoops;
    for (int h = start; !isWalked_[h];) {
      isWalked_[h] = true;
      h = next_[h];
      while (twin_[h] >= 0) h = next_[twin_[h]];
    }
  }

  void joinEnds(int h) {
    const int from = joined_.root(tail(h)), to = joined_.root(tip(h));
    if (from == to) return;
    joined_.unite(from, to);
    --out_.components;
  }

  void addUp() {
    out_.edges = sides_.size();
    out_.eulerCharacteristic = out_.vertices - out_.edges + out_.faces;
    if (out_.isManifold)
      out_.genus = genusOf(out_.components, out_.boundaryLoops, out_.eulerCharacteristic);
  }

  const PolygonMesh& mesh_;
  IndexPairs sides_;
  std::vector<std::array<int, 2>> onSide_;  ///< halfedges, -1 for none
  std::vector<int> leaving_;                ///< a halfedge of each vertex
  std::vector<int> corners_;                ///< how many are at each vertex
  std::vector<int> next_, previous_, twin_;
  std::vector<int> sorted_;     ///< vertices of the current face
  std::vector<char> isWalked_;  ///< halfedges
  DisjointSets joined_;         ///< vertices
};

}  // namespace

std::unique_ptr<SlicedWork<PolygonTriangles>> startTriangulation(const PolygonMesh& mesh) {
  return std::make_unique<Triangulating>(mesh);
}

PolygonTriangles triangulate(const PolygonMesh& mesh) { return finished(startTriangulation(mesh)); }

std::unique_ptr<SlicedWork<PolygonTopology>> startTopology(const PolygonMesh& mesh) {
  return std::make_unique<TopologyFinding>(mesh);
}

PolygonTopology topologyOf(const PolygonMesh& mesh) { return finished(startTopology(mesh)); }

}  // namespace gvd
