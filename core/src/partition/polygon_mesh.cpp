// SPDX-License-Identifier: MIT
#include "gvd/polygon_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/grouping.h"
#include "base/rejection.h"
#include "mesh/corners.h"
#include "partition/convex_triangulation.h"

namespace gvd {
namespace {

/// The halfedges of a polygon mesh: halfedge h leaves corner h in the list of all faces' corners.
class PolygonHalfedges {
 public:
  explicit PolygonHalfedges(const PolygonMesh& mesh)
      : tail_(mesh.faces.points), next_(tail_.size()), previous_(tail_.size()) {
    for (int f = 0; f < mesh.faces.size(); ++f) {
      const int first = mesh.faces.offset[f], end = mesh.faces.offset[f + 1];
      for (int h = first; h < end; ++h) {
        next_[h] = h + 1 < end ? h + 1 : first;
        previous_[next_[h]] = h;
      }
    }
    findTwins();
  }

  int count() const { return static_cast<int>(tail_.size()); }
  int tail(int h) const { return tail_[h]; }
  int tip(int h) const { return tail_[next_[h]]; }
  int twin(int h) const { return twin_[h]; }
  int next(int h) const { return next_[h]; }
  /// The next halfedge that leaves the same vertex, counterclockwise; -1 past the last.
  int rotate(int h) const { return twin_[previous_[h]]; }
  int rotateBack(int h) const { return twin_[h] < 0 ? -1 : next_[twin_[h]]; }
  /// Whether every side has two different ends, and no side occurs twice in one direction.
  bool isOriented() const { return isOriented_; }

 private:
  void findTwins() {
    twin_.assign(tail_.size(), -1);
    std::vector<KeyedItem> byEnds;
    for (int h = 0; h < count(); ++h) {
      isOriented_ &= tail(h) != tip(h);
      byEnds.push_back({tail(h), tip(h), h});
    }
    visitSame(byEnds, [&](std::span<const KeyedItem> run) { isOriented_ &= run.size() == 1; });
    for (int h = 0; h < count(); ++h) {
      const auto other = std::lower_bound(byEnds.begin(), byEnds.end(), KeyedItem{tip(h), tail(h)});
      if (other != byEnds.end() && (*other)[0] == tip(h) && (*other)[1] == tail(h))
        twin_[h] = (*other)[2];
    }
  }

  const std::vector<int>& tail_;
  std::vector<int> next_, previous_, twin_;
  bool isOriented_ = true;
};

// Not inlined, as the WebAssembly module would be larger.
[[gnu::noinline]] void requireVertices(const PolygonMesh& mesh) {
  const int vertexCount = static_cast<int>(mesh.positions.size());
  for (int f = 0; f < mesh.faces.size(); ++f)
    for (const int v : mesh.faces[f])
      if (v < 0 || v >= vertexCount)
        rejectArgument("polygon " + std::to_string(f) + ": there is no vertex " +
                       std::to_string(v));
}

bool hasRepeatedCorner(const PolygonMesh& mesh) {
  std::vector<int> corners;
  for (int f = 0; f < mesh.faces.size(); ++f) {
    corners.assign(mesh.faces[f].begin(), mesh.faces[f].end());
    std::sort(corners.begin(), corners.end());
    if (std::adjacent_find(corners.begin(), corners.end()) != corners.end()) return true;
  }
  return false;
}

/// Whether the faces around each vertex form one fan: turning from face to face reaches all.
bool hasOneFanPerVertex(const PolygonHalfedges& halfedges, int vertexCount) {
  std::vector<int> corners(vertexCount, 0), leaving(vertexCount, -1);
  for (int h = 0; h < halfedges.count(); ++h) {
    ++corners[halfedges.tail(h)];
    leaving[halfedges.tail(h)] = h;
  }
  for (int v = 0; v < vertexCount; ++v) {
    if (corners[v] == 0) continue;
    int start = leaving[v];
    for (int back = halfedges.rotateBack(start); back >= 0 && back != leaving[v];
         back = halfedges.rotateBack(back))
      start = back;
    int met = 1;
    for (int h = halfedges.rotate(start); h >= 0 && h != start; h = halfedges.rotate(h)) ++met;
    if (met != corners[v]) return false;
  }
  return true;
}

/// The pairs of vertices that are joined by a side.
std::set<std::pair<int, int>> sidesOf(const PolygonHalfedges& halfedges) {
  std::set<std::pair<int, int>> sides;
  for (int h = 0; h < halfedges.count(); ++h)
    sides.insert(std::minmax({halfedges.tail(h), halfedges.tip(h)}));
  return sides;
}

/// The components of some vertices, joined by the sides between them.
int countComponents(const PolygonHalfedges& halfedges, int vertices) {
  DisjointSets joined;
  for (int h = 0; h < halfedges.count(); ++h) {
    const int tail = joined.root(halfedges.tail(h)), tip = joined.root(halfedges.tip(h));
    if (tail == tip) continue;
    joined.unite(tail, tip);
    --vertices;
  }
  return vertices;
}

/// Holds for manifolds only.
int countBoundaryLoops(const PolygonHalfedges& halfedges) {
  std::vector<char> isWalked(halfedges.count(), false);
  int loops = 0;
  for (int start = 0; start < halfedges.count(); ++start) {
    if (halfedges.twin(start) >= 0 || isWalked[start]) continue;
    ++loops;
    for (int h = start; !isWalked[h];) {
      isWalked[h] = true;
      h = halfedges.next(h);
      while (halfedges.twin(h) >= 0) h = halfedges.next(halfedges.twin(h));
    }
  }
  return loops;
}

}  // namespace

PolygonTriangles triangulate(const PolygonMesh& mesh) {
  requireVertices(mesh);
  std::set<std::pair<int, int>> joined = sidesOf(PolygonHalfedges(mesh));
  PolygonTriangles result;
  ConvexTriangulation triangulation;
  std::vector<Eigen::Vector2d> corners;
  for (int f = 0; f < mesh.faces.size(); ++f) {
    const auto polygon = mesh.faces[f];
    if (polygon.size() < 3) continue;
    const auto position = [&](size_t i) { return mesh.positions[polygon[i % polygon.size()]]; };
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (size_t i = 0; i < polygon.size(); ++i)
      normal += (position(i) - position(0)).cross(position(i + 1) - position(0));
    const Eigen::Vector3d x = normal.unitOrthogonal(), y = normal.stableNormalized().cross(x);
    corners.clear();
    for (size_t i = 0; i < polygon.size(); ++i)
      corners.emplace_back(x.dot(position(i)), y.dot(position(i)));
    const auto pair = [&](int a, int b) {
      return std::pair<int, int>(std::minmax(polygon[a], polygon[b]));
    };
    const auto isJoined = [&](int a, int b) { return joined.contains(pair(a, b)); };
    for (const auto& [a, b, c] : triangulation.compute(corners, isJoined)) {
      result.triangles.push_back({polygon[a], polygon[b], polygon[c]});
      result.face.push_back(f);
      joined.insert({pair(a, b), pair(b, c), pair(a, c)});
    }
  }
  return result;
}

PolygonTopology topologyOf(const PolygonMesh& mesh) {
  requireVertices(mesh);
  const int vertexCount = static_cast<int>(mesh.positions.size());
  const PolygonHalfedges halfedges(mesh);
  PolygonTopology topology;
  std::vector<char> isUsed(vertexCount, false);
  for (int h = 0; h < halfedges.count(); ++h) isUsed[halfedges.tail(h)] = true;
  topology.edges = static_cast<int>(sidesOf(halfedges).size());
  topology.vertices = static_cast<int>(std::count(isUsed.begin(), isUsed.end(), true));
  topology.faces = mesh.faces.size();
  topology.eulerCharacteristic = topology.vertices - topology.edges + topology.faces;
  topology.components = countComponents(halfedges, topology.vertices);
  topology.isManifold = halfedges.isOriented() && !hasRepeatedCorner(mesh) &&
                        hasOneFanPerVertex(halfedges, vertexCount);
  if (!topology.isManifold) return topology;
  topology.boundaryLoops = countBoundaryLoops(halfedges);
  topology.genus =
      genusOf(topology.components, topology.boundaryLoops, topology.eulerCharacteristic);
  return topology;
}

}  // namespace gvd
