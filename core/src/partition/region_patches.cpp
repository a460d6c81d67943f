// SPDX-License-Identifier: MIT
//
// The facts of each region of a partition: area, perimeter, centroid, neighbours, outlines, genus.
#include "partition/region_patches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <span>

#include "base/sorting.h"
#include "mesh/nearest_on_triangle.h"
#include "mesh/surface_geometry.h"

namespace gvd {
namespace {

using Eigen::Vector3d;

class Surveyor {
 public:
  Surveyor(const TriangleMesh& mesh, std::span<const double> areas, Partition& partition)
      : mesh_(mesh),
        areas_(areas),
        partition_(partition),
        isOnOutline_(partition.twins.size(), false),
        isSeen_(partition.triangles.size(), false),
        isWalked_(partition.twins.size(), false),
        isOnBorder_(partition.points.size(), false),
        lastLabel_(partition.points.size(), kNoLabel) {
    for (int h = 0; h < static_cast<int>(partition.twins.size()); ++h) {
      if (!isOnOutline(partition, h)) continue;
      isOnOutline_[h] = true;
      isOnBorder_[tail(h)] = isOnBorder_[tip(h)] = true;
    }
  }

  /// A region whose label and range of triangles are given.
  void survey(RegionPatch& region) {
    if (region.triangleCount == 0) return;
    const double reach = measureArea(region);
    walkOutlines(region);
    countTopology(region);
    findNearCentroid(region, reach);
  }

 private:
  static constexpr int kNoLabel = -2;  // no region's, nor that of what no site reaches

  int tail(int h) const { return partition_.triangles[h / 3][h % 3]; }
  int tip(int h) const { return tail(TriangleMesh::next(h)); }
  std::array<Vector3d, 3> cornersOf(int t) const {
    const auto& [a, b, c] = partition_.triangles[t];
    return {partition_.positions[a], partition_.positions[b], partition_.positions[c]};
  }

  /// Returns the square of how far a point of a triangle may be from its first corner, at most.
  double measureArea(RegionPatch& region) {
    double reach = 0;
    Vector3d moment = Vector3d::Zero(), sum = Vector3d::Zero();
    for (int i = 0; i < region.triangleCount; ++i) {
      const int t = region.firstTriangle + i;
      const auto corners = cornersOf(t);
      const Vector3d centre = (corners[0] + corners[1] + corners[2]) / 3;
      reach = std::max({reach, (corners[1] - corners[0]).squaredNorm(),
                        (corners[2] - corners[0]).squaredNorm()});
      const double area = areas_[t];
      region.area += area;
      moment += area * centre;
      sum += centre;
    }
    region.centroid =
        region.area > 0 ? Vector3d(moment / region.area) : Vector3d(sum / region.triangleCount);
    return reach;
  }

  void walkOutlines(RegionPatch& region) {
    const int first = 3 * region.firstTriangle, last = first + 3 * region.triangleCount;
    for (int start = first; start < last; ++start) {
      if (!isOnOutline_[start] || isWalked_[start]) continue;
      ++region.loops;
      for (int h = start; !isWalked_[h]; h = nextOnOutline(partition_, h)) {
        isWalked_[h] = true;
        addStep(h, region);
      }
    }
    sortStably(std::span(region.neighbours),
               [](const auto& a, const auto& b) { return a.label < b.label; });
  }

  void addStep(int h, RegionPatch& region) {
    ++outlineSteps_;
    // Every fan of the region around a point of its outline starts with one such step.
    region.selfTouchings += lastLabel_[tail(h)] == region.label;
    lastLabel_[tail(h)] = region.label;
    const double length = (partition_.positions[tip(h)] - partition_.positions[tail(h)]).norm();
    region.perimeter += length;
    const int twin = partition_.twins[h];
    if (twin < 0) {
      region.boundaryLength += length;
      return;
    }
    const int label = partition_.triangleLabel[twin / 3];
    const auto known = std::find_if(region.neighbours.begin(), region.neighbours.end(),
                                    [&](const auto& n) { return n.label == label; });
    if (known != region.neighbours.end())
      known->length += length;
    else
      region.neighbours.push_back({label, length});
  }

  /// V - E + F, with one vertex per fan: as many on outlines as there are steps along them.
  void countTopology(RegionPatch& region) {
    int inner = 0;
    for (int i = 0; i < region.triangleCount; ++i) {
      const int t = region.firstTriangle + i;
      for (const int v : partition_.triangles[t]) {
        if (isOnBorder_[v]) continue;
        isOnBorder_[v] = true;  // counted
        ++inner;
      }
      if (!isSeen_[t]) {
        ++region.components;
        flood(t);
      }
    }
    const int edges = (3 * region.triangleCount + outlineSteps_) / 2;
    region.eulerCharacteristic = inner + outlineSteps_ - edges + region.triangleCount;
    region.genus = (2 * region.components - region.loops - region.eulerCharacteristic) / 2;
    outlineSteps_ = 0;
  }

  void flood(int start) {
    isSeen_[start] = true;
    stack_.assign(1, start);
    while (!stack_.empty()) {
      const int t = stack_.back();
      stack_.pop_back();
      for (int h = 3 * t; h < 3 * (t + 1); ++h) {
        if (isOnOutline_[h]) continue;
        const int other = partition_.twins[h] / 3;
        if (isSeen_[other]) continue;
        isSeen_[other] = true;
        stack_.push_back(other);
      }
    }
  }

  void findNearCentroid(RegionPatch& region, double reach) {
    const int last = region.firstTriangle + region.triangleCount;
    const auto toCorner = [&](int t) {
      return (partition_.positions[partition_.triangles[t][0]] - region.centroid).squaredNorm();
    };
    int nearest = region.firstTriangle;
    double least = kInfinity;  // squared
    for (int t = region.firstTriangle; t < last; ++t) {
      const double distance = toCorner(t);
      if (distance >= least) continue;
      least = distance;
      nearest = t;
    }
    Vector3d bary = Vector3d::Unit(0);
    for (int t = region.firstTriangle; t < last; ++t) {
      if (toCorner(t) > 2 * (least + reach)) continue;  // (a + b)² ≤ 2 (a² + b²)
      const auto corners = cornersOf(t);
      const Vector3d here = nearestOnTriangle(region.centroid, corners);
      const double distance =
          (here[0] * corners[0] + here[1] * corners[1] + here[2] * corners[2] - region.centroid)
              .squaredNorm();
      if (distance >= least) continue;
      least = distance;
      nearest = t;
      bary = here;
    }
    region.nearCentroid = {partition_.triangleFace[nearest],
                           cornersInFace(mesh_, partition_, nearest) * bary};
  }

  const TriangleMesh& mesh_;
  const std::span<const double> areas_;
  Partition& partition_;
  std::vector<char> isOnOutline_;  ///< halfedges
  std::vector<char> isSeen_;       ///< triangles
  std::vector<char> isWalked_;     ///< halfedges on outlines
  std::vector<char> isOnBorder_;
  std::vector<int> lastLabel_;  ///< per vertex, of the last region whose outline came by
  std::vector<int> stack_;
  int outlineSteps_ = 0;
};

}  // namespace

int nextOnOutline(const Partition& partition, int h) {
  int next = TriangleMesh::next(h);
  while (!isOnOutline(partition, next)) next = TriangleMesh::next(partition.twins[next]);
  return next;
}

void measurePatches(const TriangleMesh& mesh, int siteCount, std::span<const double> areas,
                    Partition& partition) {
  partition.regions.resize(siteCount);
  for (int l = 0; l < siteCount; ++l) partition.regions[l].label = l;
  const auto patchOf = [&](int label) -> RegionPatch& {
    return label < 0 ? partition.unreachable : partition.regions[label];
  };
  for (int t = 0; t < static_cast<int>(partition.triangles.size()); ++t) {
    RegionPatch& region = patchOf(partition.triangleLabel[t]);
    if (region.triangleCount++ == 0) region.firstTriangle = t;
  }
  Surveyor surveyor(mesh, areas, partition);
  for (RegionPatch& region : partition.regions) surveyor.survey(region);
  surveyor.survey(partition.unreachable);
}

}  // namespace gvd
