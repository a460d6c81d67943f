// SPDX-License-Identifier: MIT
//
// The facts of each region of a partition: area, perimeter, centroid, neighbours, outlines, genus.
#include "partition/region_patches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "base/sorting.h"

namespace gvd {
namespace {

/// Adds a piece of a border to a list, to the last entry if that is of the same label.
void addBorder(std::vector<RegionPatch::Neighbour>& borders, int label, double length) {
  if (borders.empty() || borders.back().label != label) borders.push_back({label, 0});
  borders.back().length += length;
}

/// Sorts a list by label and leaves one entry for each.
void addUpBorders(std::vector<RegionPatch::Neighbour>& borders) {
  sortStably(std::span(borders), [](const auto& a, const auto& b) { return a.label < b.label; });
  for (const auto& [label, length] : std::exchange(borders, {})) addBorder(borders, label, length);
}

}  // namespace

using Eigen::Vector3d;

PatchMeasuring::PatchMeasuring(const TriangleMesh& mesh, int siteCount,
                               std::span<const double> areas, Partition& partition)
    : mesh_(mesh), siteCount_(siteCount), areas_(areas), partition_(partition) {}

bool PatchMeasuring::step(long& budget) {
  const std::size_t triangles = partition_.triangles.size(), halfedges = 3 * triangles,
                    vertices = partition_.points.size();
  return sequence_.run(
      [&] { return fillInSlices(isSeen_, triangles, '\0', budget); },
      [&] { return fillInSlices(isWalked_, halfedges, '\0', budget); },
      [&] { return fillInSlices(isCounted_, vertices, '\0', budget); },
      [&] { return fillInSlices(lastLabel_, vertices, kNoLabel, budget); },
      [&] { return fillInSlices(partition_.regions, siteCount_, RegionPatch(), budget); },
      forEach(halfedges, budget, 8,
              [&](int h) {
                if (isOnOutline(partition_, h)) isCounted_[tail(h)] = isCounted_[tip(h)] = true;
              }),
      forEach(triangles, budget, 8,
              [&](int t) {
                RegionPatch& region = patchOf(partition_.triangleLabel[t]);
                if (region.triangleCount++ == 0) region.firstTriangle = t;
              }),
      forEach(siteCount_, budget, 8, [&](int l) { partition_.regions[l].label = l; }),
      [&] { return measureAll(budget); });
}

SpaceTriangle PatchMeasuring::cornersOf(int t) const {
  const auto& [a, b, c] = partition_.triangles[t];
  return {partition_.positions[a], partition_.positions[b], partition_.positions[c]};
}

RegionPatch& PatchMeasuring::patchOf(int label) {
  return label < 0 ? partition_.unreachable : partition_.regions[label];
}

/// Measures all regions, then the part that no site reaches.
bool PatchMeasuring::measureAll(long& budget) {
  for (; measured_ <= siteCount_; ++measured_) {
    if (!measure(patchOf(measured_ < siteCount_ ? measured_ : -1), budget)) return false;
    measuring_ = {};
  }
  return true;
}

/// Measures a region whose label and range of triangles are set.
bool PatchMeasuring::measure(RegionPatch& region, long& budget) {
  if (region.triangleCount == 0) return true;
  const int first = region.firstTriangle;
  const auto forTriangles = [&](long perUnit, auto body) {
    return forEach(region.triangleCount, budget, perUnit,
                   [first, body](int i) { body(first + i); });
  };
  return measuring_.run(
      [&] {
        sums_ = {};
        nearest_ = {{Vector3d::Unit(0)}, first};
        nextToSee_ = first;
      },
      forTriangles(8, [&](int t) { addArea(t, region); }),
      forEach(3 * region.triangleCount, budget, 8,
              [&](int i) { walkOutlineFrom(3 * first + i, region); }),
      forTriangles(8, [&](int t) { countInnerVertices(t); }),
      [&] { return countComponents(region, budget); },
      [&] {
        addUpBorders(region.neighbours);
        countTopology(region);
        region.centroid = region.area > 0 ? Vector3d(sums_.moment / region.area)
                                          : Vector3d(sums_.centres / region.triangleCount);
      },
      forTriangles(8, [&](int t) { offerFirstCorner(t, region); }),
      forTriangles(8, [&](int t) { offerTriangle(t, region); }),
      [&] {
        region.nearCentroid = {partition_.triangleFace[nearest_.triangle],
                               cornersInFace(mesh_, partition_, nearest_.triangle) * nearest_.bary};
      });
}

void PatchMeasuring::addArea(int t, RegionPatch& region) {
  const auto corners = cornersOf(t);
  const Vector3d centre = (corners[0] + corners[1] + corners[2]) / 3;
  sums_.reach = std::max({sums_.reach, (corners[1] - corners[0]).squaredNorm(),
                          (corners[2] - corners[0]).squaredNorm()});
  region.area += areas_[t];
  sums_.moment += areas_[t] * centre;
  sums_.centres += centre;
}

void PatchMeasuring::walkOutlineFrom(int start, RegionPatch& region) {
  if (isWalked_[start] || !isOnOutline(partition_, start)) return;
  ++region.loops;
  for (int h = start; !isWalked_[h]; h = nextOnOutline(partition_, h)) {
    isWalked_[h] = true;
    addStep(h, region);
  }
}

void PatchMeasuring::addStep(int h, RegionPatch& region) {
  ++sums_.outlineSteps;
  // The outline passes a point once per fan of the region around it.
  region.selfTouchings += lastLabel_[tail(h)] == region.label;
  lastLabel_[tail(h)] = region.label;
  const double length = (partition_.positions[tip(h)] - partition_.positions[tail(h)]).norm();
  region.perimeter += length;
  const int twin = partition_.twins[h];
  if (twin < 0) {
    region.boundaryLength += length;
    return;
  }
  addBorder(region.neighbours, partition_.triangleLabel[twin / 3], length);
}

void PatchMeasuring::countInnerVertices(int t) {
  for (const int v : partition_.triangles[t]) {
    if (isCounted_[v]) continue;
    isCounted_[v] = true;
    ++sums_.innerVertices;
  }
}

/// Counts the components of a region, by flooding one after another.
bool PatchMeasuring::countComponents(RegionPatch& region, long& budget) {
  constexpr int kTrianglesPerUnit = 8;
  const int end = region.firstTriangle + region.triangleCount;
  for (; budget > 0; --budget)
    for (int i = 0; i < kTrianglesPerUnit; ++i) {
      if (stack_.empty()) {
        if (nextToSee_ == end) return true;
        if (isSeen_[nextToSee_++]) continue;
        ++region.components;
        isSeen_[nextToSee_ - 1] = true;
        stack_.push_back(nextToSee_ - 1);
      }
      const int t = stack_.back();
      stack_.pop_back();
      for (int h = 3 * t; h < 3 * (t + 1); ++h) {
        if (isOnOutline(partition_, h) || isSeen_[partition_.twins[h] / 3]) continue;
        isSeen_[partition_.twins[h] / 3] = true;
        stack_.push_back(partition_.twins[h] / 3);
      }
    }
  return false;
}

/// Counts V - E + F with one vertex per fan, so there are as many vertices on outlines as steps
/// along them.
void PatchMeasuring::countTopology(RegionPatch& region) const {
  const int edges = (3 * region.triangleCount + sums_.outlineSteps) / 2;
  region.eulerCharacteristic =
      sums_.innerVertices + sums_.outlineSteps - edges + region.triangleCount;
  region.genus = genusOf(region.components, region.loops, region.eulerCharacteristic);
}

double PatchMeasuring::squaredDistanceToCentroid(int t, const RegionPatch& region) const {
  return (partition_.positions[partition_.triangles[t][0]] - region.centroid).squaredNorm();
}

/// Offers the first corner of a triangle as the point nearest to the centroid. The best of these
/// bounds the distance, so that few whole triangles have to be looked at.
void PatchMeasuring::offerFirstCorner(int t, const RegionPatch& region) {
  const double distance = squaredDistanceToCentroid(t, region);
  if (distance < nearest_.squaredDistance) nearest_ = {{Vector3d::Unit(0), distance}, t};
}

void PatchMeasuring::offerTriangle(int t, const RegionPatch& region) {
  // (a + b)² ≤ 2 (a² + b²)
  if (squaredDistanceToCentroid(t, region) > 2 * (nearest_.squaredDistance + sums_.reach)) return;
  const NearestPoint here = nearestOnTriangle(region.centroid, cornersOf(t));
  if (here.squaredDistance < nearest_.squaredDistance) nearest_ = {here, t};
}

int nextOnOutline(const Partition& partition, int h) {
  int next = TriangleMesh::next(h);
  while (!isOnOutline(partition, next)) next = TriangleMesh::next(partition.twins[next]);
  return next;
}

}  // namespace gvd
