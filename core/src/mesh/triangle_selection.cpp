// SPDX-License-Identifier: MIT
#include "mesh/triangle_selection.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "base/number_text.h"
#include "gvd/error.h"
#include "mesh/counting_sort.h"

namespace gvd {
namespace {

[[noreturn]] void rejectMesh(const std::string& why) { throw Error(ErrorCode::kInvalidMesh, why); }

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

Eigen::Vector3d positionOf(std::span<const double> positions, int v) {
  return Eigen::Vector3d::Map(&positions[3 * static_cast<std::size_t>(v)]);
}

/// The diagonal of the bounding box of all corners that are finite.
double boundingDiagonal(std::span<const double> positions, std::span<const int> triangles) {
  Eigen::Vector3d least = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d most = -least;
  for (const int v : triangles) {
    const Eigen::Vector3d p = positionOf(positions, v);
    if (!p.allFinite()) continue;
    least = least.cwiseMin(p);
    most = most.cwiseMax(p);
  }
  return (most - least).norm();
}

/// Points by the cubes of space that they are in, to find those near a place.
class PointGrid {
 public:
  PointGrid(std::span<const double> positions, double radius)
      : positions_(positions), radius_(radius) {}

  void add(int v) { cubes_[cubeOf(positionOf(positions_, v))].push_back(v); }

  /// The lowest within the radius, -1 if there is none.
  int firstNear(const Eigen::Vector3d& p) const {
    // Rounding keeps the order of numbers, so no point within the radius is in any other cube.
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(radius_);
    const Cube low = cubeOf(p - reach), high = cubeOf(p + reach);
    int first = -1;
    for (double x = low[0]; x <= high[0]; x = after(x))
      for (double y = low[1]; y <= high[1]; y = after(y))
        for (double z = low[2]; z <= high[2]; z = after(z))
          if (const auto cube = cubes_.find({x, y, z}); cube != cubes_.end())
            for (const int v : cube->second)
              if ((first < 0 || v < first) && (positionOf(positions_, v) - p).norm() <= radius_)
                first = v;
    return first;
  }

 private:
  using Cube = std::array<double, 3>;

  Cube cubeOf(const Eigen::Vector3d& p) const {
    const double side = 4 * radius_;
    return {std::floor(p.x() / side), std::floor(p.y() / side), std::floor(p.z() / side)};
  }

  /// The next integer among numbers of double precision.
  static double after(double x) {
    return std::max(x + 1, std::nextafter(x, std::numeric_limits<double>::infinity()));
  }

  std::span<const double> positions_;
  const double radius_;
  std::map<Cube, std::vector<int>> cubes_;
};

std::string whyNothingIsLeft(int count, const MeshRepairs& repairs) {
  if (count == 0) return "there are no triangles";
  return "no triangle is left: of " + std::to_string(count) + " triangles " +
         std::to_string(repairs.nonFiniteTriangles) + " have a corner that is not finite and " +
         std::to_string(repairs.degenerateTriangles) + " have two corners at one position";
}

}  // namespace

void requireValid(const MeshOptions& options) {
  const auto reject = [](const std::string& why) { throw Error(ErrorCode::kInvalidArgument, why); };
  if (!(options.weld >= 0 && options.weld <= 1))
    reject("weld is " + numberText(options.weld) + ", not a number from 0 to 1");
  if (options.minComponent < 0)
    reject("minComponent is " + std::to_string(options.minComponent) + ", not a number from 0");
}

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

std::vector<int> findRepresentatives(std::span<const double> positions) {
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

  std::vector<int> representative(positions.size() / 3, -1);
  const Vertex* first = nullptr;
  for (const Vertex& vertex : vertices) {
    if (!first || !vertex.samePosition(*first)) first = &vertex;
    representative[vertex.index] = first->index;
  }
  return representative;
}

std::vector<int> findRepresentatives(std::span<const double> positions,
                                     std::span<const int> triangles, double weld) {
  std::vector<int> representative = findRepresentatives(positions);
  const double tolerance = weld * boundingDiagonal(positions, triangles);
  constexpr double kRounding = std::numeric_limits<double>::epsilon();
  if (!(weld >= kRounding && tolerance > 0 && std::isfinite(tolerance))) return representative;
  PointGrid staying(positions, tolerance);
  for (int v = 0; v < static_cast<int>(representative.size()); ++v) {
    int& same = representative[v];
    if (same != v) {  // not finite, or what holds of the first one at the same position
      if (same >= 0) same = representative[same];
      continue;
    }
    const int near = staying.firstNear(positionOf(positions, v));
    if (near >= 0)
      same = near;
    else
      staying.add(v);
  }
  return representative;
}

bool isFinite(const Corners& corners) {
  return std::min({corners[0], corners[1], corners[2]}) >= 0;
}

bool isDegenerate(const Corners& corners) {
  return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
}

std::vector<Corners> weldCorners(std::span<const int> triangles,
                                 const std::vector<int>& representative) {
  std::vector<Corners> corners(triangles.size() / 3);
  for (std::size_t t = 0; t < corners.size(); ++t) {
    for (int i = 0; i < 3; ++i) corners[t][i] = representative[triangles[3 * t + i]];
  }
  return corners;
}

Selection selectTriangles(const std::vector<Corners>& welded, int vertexCount,
                          MeshRepairs& repairs) {
  const int count = static_cast<int>(welded.size());
  std::vector<int> candidates;
  candidates.reserve(count);
  for (int t = 0; t < count; ++t) {
    if (!isFinite(welded[t])) {
      ++repairs.nonFiniteTriangles;
    } else if (isDegenerate(welded[t])) {
      ++repairs.degenerateTriangles;
    } else {
      candidates.push_back(t);
    }
  }
  const std::vector<int> original = findOriginals(welded, candidates, vertexCount);

  Selection selection;
  selection.kept.assign(count, -1);
  for (int t : candidates) {
    if (original[t] == t) {
      selection.kept[t] = static_cast<int>(selection.input.size());
      selection.input.push_back(t);
      selection.corners.push_back(welded[t]);
    } else {
      selection.kept[t] = selection.kept[original[t]];
      ++repairs.duplicateTriangles;
    }
  }
  if (selection.input.empty()) rejectMesh(whyNothingIsLeft(count, repairs));
  return selection;
}

}  // namespace gvd
