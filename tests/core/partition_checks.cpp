// SPDX-License-Identifier: MIT
#include "partition_checks.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace gvd::checks {
namespace {

using Eigen::Vector3d;
using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

int tailOf(const Partition& p, int h) { return p.triangles[h / 3][h % 3]; }
int tipOf(const Partition& p, int h) { return tailOf(p, TriangleMesh::next(h)); }

class Classes {
 public:
  explicit Classes(int count) : parent_(count), count_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(int i, int j) {
    i = root(i);
    j = root(j);
    count_ -= i != j;
    parent_[i] = j;
  }
  int count() const { return count_; }

 private:
  std::vector<int> parent_;
  int count_;
};

/// Some consecutive triangles of a partition, welded where both sides of an edge are among them.
struct Surface {
  int fans = 0;  ///< of triangles around a point: vertices, if points are cut apart between them
  int points = 0;
  int eulerCharacteristic = 0, components = 0, boundaryLoops = 0;

  Surface(const Partition& p, int first, int count) {
    const auto twin = [&](int h) {
      const int other = p.twins[h];
      return other >= 3 * first && other < 3 * (first + count) ? other - 3 * first : -1;
    };
    Classes corners(3 * count), triangles(count);
    int open = 0;
    std::set<int> used;
    for (int h = 0; h < 3 * count; ++h) {
      used.insert(tailOf(p, 3 * first + h));
      const int other = twin(3 * first + h);
      open += other < 0;
      if (other < 0) continue;
      corners.unite(h, TriangleMesh::next(other));
      triangles.unite(h / 3, other / 3);
    }
    fans = corners.count();
    points = static_cast<int>(used.size());
    components = triangles.count();
    eulerCharacteristic = fans - (3 * count + open) / 2 + count;
    std::vector<char> isWalked(3 * count, false);
    for (int start = 0; start < 3 * count; ++start) {
      if (isWalked[start] || twin(3 * first + start) >= 0) continue;
      ++boundaryLoops;
      for (int h = start; !isWalked[h];) {
        isWalked[h] = true;
        h = TriangleMesh::next(h);
        for (int other = twin(3 * first + h); other >= 0; other = twin(3 * first + h))
          h = TriangleMesh::next(other);
      }
    }
  }
};

AssertionResult isTheSurface(const TriangleMesh& mesh, const Partition& p) {
  const Surface surface(p, 0, static_cast<int>(p.triangles.size()));
  const MeshTopology& expected = mesh.topology();
  if (surface.fans != surface.points || surface.points != static_cast<int>(p.points.size()))
    return AssertionFailure() << "no manifold: " << surface.fans << " fans around "
                              << surface.points << " of " << p.points.size() << " points";
  if (surface.eulerCharacteristic != expected.eulerCharacteristic)
    return AssertionFailure() << "V - E + F is " << surface.eulerCharacteristic << ", not "
                              << expected.eulerCharacteristic;
  if (surface.boundaryLoops != expected.boundaryLoops)
    return AssertionFailure() << surface.boundaryLoops << " boundary loops, not "
                              << expected.boundaryLoops;
  if (surface.components != expected.components)
    return AssertionFailure() << surface.components << " components";
  return AssertionSuccess();
}

AssertionResult hasItsPlaces(const TriangleMesh& mesh, const Partition& p) {
  // Far from the origin, places are rounded as coordinates are.
  double farthest = 0;
  for (const Vector3d& position : p.positions)
    farthest = std::max(farthest, position.lpNorm<Eigen::Infinity>());
  const double near = 1e-8 * mesh.boundingDiagonal() + 0x1p-50 * farthest;
  for (size_t v = 0; v < p.points.size(); ++v)
    if (!((mesh.position(p.points[v]) - p.positions[v]).norm() <= 1e-14 * mesh.boundingDiagonal()))
      return AssertionFailure() << "vertex " << v << " is not at its surface point";
  for (int t = 0; t < static_cast<int>(p.triangles.size()); ++t) {
    const Eigen::Matrix3d corners = cornersInFace(mesh, p, t);
    for (int i = 0; i < 3; ++i) {
      const Vector3d at = mesh.position({p.triangleFace[t], corners.col(i)});
      if (!((at - p.positions[p.triangles[t][i]]).norm() <= near))
        return AssertionFailure() << "triangle " << t << " is off its face";
    }
    if (t > 0 &&
        static_cast<unsigned>(p.triangleLabel[t]) < static_cast<unsigned>(p.triangleLabel[t - 1]))
      return AssertionFailure() << "the triangles are not ascending by label";
  }
  return AssertionSuccess();
}

AssertionResult hasAllOfTheArea(const TriangleMesh& mesh, const Partition& p) {
  double sum = p.unreachable.area;
  for (const RegionPatch& region : p.regions) sum += region.area;
  if (!(std::abs(sum - mesh.area()) <= 1e-12 * mesh.area()))
    return AssertionFailure() << "the areas sum to " << sum << ", not to " << mesh.area()
                              << ": off by " << sum / mesh.area() - 1;
  return AssertionSuccess();
}

AssertionResult describesItsRegions(const Partition& p) {
  std::map<std::pair<int, int>, double> borders;
  int first = 0;
  for (const RegionPatch& region : p.regions) {
    if (region.triangleCount > 0 && region.firstTriangle != first)
      return AssertionFailure() << "region " << region.label << " is not where it says";
    first += region.triangleCount;
    double lengths = region.boundaryLength;
    for (const auto& n : region.neighbours) {
      borders[{region.label, n.label}] = n.length;
      lengths += n.length;
    }
    if (!(std::abs(lengths - region.perimeter) <= 1e-12 * region.perimeter))
      return AssertionFailure() << "region " << region.label << " has perimeter "
                                << region.perimeter << ", in parts " << lengths;
    if (region.triangleCount == 0) continue;
    const Surface patch(p, region.firstTriangle, region.triangleCount);
    if (patch.eulerCharacteristic != region.eulerCharacteristic ||
        patch.components != region.components || patch.boundaryLoops != region.loops ||
        patch.fans - patch.points != region.selfTouchings || region.genus < 0 ||
        2 * region.genus != 2 * region.components - region.loops - region.eulerCharacteristic)
      return AssertionFailure() << "region " << region.label << " has another topology";
  }
  for (const auto& [labels, length] : borders) {
    const auto other = borders.find({labels.second, labels.first});
    if (other == borders.end() || !(std::abs(other->second - length) <= 1e-12 * length))
      return AssertionFailure() << labels.first << "|" << labels.second
                                << " is not as long from both sides";
  }
  return AssertionSuccess();
}

}  // namespace

AssertionResult hasItsTwins(const Partition& p) {
  for (int h = 0; h < static_cast<int>(p.twins.size()); ++h) {
    const int twin = p.twins[h];
    if (twin < 0) continue;
    if (p.twins[twin] != h || tailOf(p, twin) != tipOf(p, h) || tipOf(p, twin) != tailOf(p, h))
      return AssertionFailure() << "halfedge " << h << " has twin " << twin;
  }
  return AssertionSuccess();
}

AssertionResult hasTheAreasOf(const TriangleMesh& mesh, const Diagram& d, const Partition& p) {
  for (const RegionPatch& region : p.regions)
    if (!(std::abs(region.area - d.regionArea[region.label]) <= 1e-9 * mesh.area()))
      return AssertionFailure() << "region " << region.label << " has area " << region.area
                                << ", by the diagram " << d.regionArea[region.label];
  return AssertionSuccess();
}

AssertionResult agreesWithDiagram(const TriangleMesh& mesh, const Diagram& d, const Partition& p) {
  for (int t = 0; t < static_cast<int>(p.triangles.size()); ++t)
    if (!(cornersInFace(mesh, p, t).determinant() >= -1e-9))
      return AssertionFailure() << "triangle " << t << " is turned over";
  return hasTheAreasOf(mesh, d, p);
}

AssertionResult isSound(const TriangleMesh& mesh, const Partition& p) {
  if (auto result = hasItsTwins(p); !result) return result;
  if (auto result = isTheSurface(mesh, p); !result) return result;
  if (auto result = hasItsPlaces(mesh, p); !result) return result;
  if (auto result = hasAllOfTheArea(mesh, p); !result) return result;
  return describesItsRegions(p);
}

}  // namespace gvd::checks
