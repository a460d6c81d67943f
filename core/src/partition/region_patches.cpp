// SPDX-License-Identifier: MIT
//
// The facts of each region of a partition: area, perimeter, centroid, neighbours, outlines, genus.
#include "partition/region_patches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "base/sorting.h"
#include "mesh/genus.h"

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
  const auto forTriangles = [&](auto body) { return forEach(triangles, budget, 8, body); };
  const auto forLabels = [&](auto body) {
    return forEach(sums_, budget, 1, [body](int i) { body(i - 1); });
  };
  return sequence_.run(
      [&] { return fillInSlices(isSeen_, triangles, '\0', budget); },
      [&] { return fillInSlices(isWalked_, halfedges, '\0', budget); },
      [&] { return fillInSlices(lastLabel_, vertices, kNoLabel, budget); },
      [&] { return fillInSlices(partition_.regions, siteCount_, RegionPatch(), budget); },
      [&] { return fillInSlices(sums_, siteCount_ + 1, Sums(), budget); },
      forEach(siteCount_, budget, 8, [&](int l) { partition_.regions[l].label = l; }),
      forEach(halfedges, budget, 8, [&](int h) { walkOutlineFrom(h); }),
      forTriangles([&](int t) { addTriangle(t); }), [&] { return countComponents(budget); },
      forLabels([&](int l) { sumUp(l); }), forTriangles([&](int t) { offerFirstCorner(t); }),
      forTriangles([&](int t) { offerTriangle(t); }),
      forLabels([&](int l) { setNearCentroid(l); }));
}

SpaceTriangle PatchMeasuring::cornersOf(int t) const {
  const auto& [a, b, c] = partition_.triangles[t];
  return {partition_.positions[a], partition_.positions[b], partition_.positions[c]};
}

RegionPatch& PatchMeasuring::patchOf(int label) {
  return label < 0 ? partition_.unreachable : partition_.regions[label];
}

void PatchMeasuring::walkOutlineFrom(int start) {
  if (isWalked_[start] || !isOnOutline(partition_, start)) return;
  RegionPatch& region = patchOf(partition_.triangleLabel[start / 3]);
  ++region.loops;
  walkOutline(partition_, start, [&](int h) {
    isWalked_[h] = true;
    addStep(h, region);
  });
}

void PatchMeasuring::addStep(int h, RegionPatch& region) {
  ++sumsOf(region.label).outlineSteps;
  // The outline passes a point once per fan of the region around it.
  region.selfTouchings += lastLabel_[tail(h)] == region.label;
  lastLabel_[tail(h)] = region.label;
  const double length = (partition_.positions[tip(h)] - partition_.positions[tail(h)]).norm();
  region.perimeter += length;
  const int twin = partition_.twins[h];
  if (twin < 0)
    region.boundaryLength += length;
  else
    addBorder(region.neighbours, partition_.triangleLabel[twin / 3], length);
}

void PatchMeasuring::addTriangle(int t) {
  RegionPatch& region = patchOf(partition_.triangleLabel[t]);
  Sums& sums = sumsOf(region.label);
  if (region.triangleCount++ == 0) {
    region.firstTriangle = t;
    sums.nearest = {{Vector3d::Unit(0)}, t};
  }
  const auto corners = cornersOf(t);
  const Vector3d centre = (corners[0] + corners[1] + corners[2]) / 3;
  sums.squaredReach = std::max({sums.squaredReach, (corners[1] - corners[0]).squaredNorm(),
                                (corners[2] - corners[0]).squaredNorm()});
  region.area += areas_[t];
  sums.moment += areas_[t] * centre;
  sums.centres += centre;
  for (const int v : partition_.triangles[t])
    if (lastLabel_[v] == kNoLabel) {
      lastLabel_[v] = region.label;
      ++sums.innerVertices;
    }
}

/// Counts the components of all regions, by flooding one after another.
bool PatchMeasuring::countComponents(long& budget) {
  constexpr int kTrianglesPerUnit = 8;
  for (; budget > 0; --budget)
    for (int i = 0; i < kTrianglesPerUnit; ++i) {
      if (stack_.empty()) {
        if (nextToSee_ == static_cast<int>(isSeen_.size())) return true;
        const int t = nextToSee_++;
        if (std::exchange(isSeen_[t], true)) continue;
        ++patchOf(partition_.triangleLabel[t]).components;
        stack_.push_back(t);
      }
      const int t = stack_.back();
      stack_.pop_back();
      for (int h = 3 * t; h < 3 * (t + 1); ++h) {
        const int beyond = partition_.twins[h] / 3;
        if (!isOnOutline(partition_, h) && !std::exchange(isSeen_[beyond], true))
          stack_.push_back(beyond);
      }
    }
  return false;
}

void PatchMeasuring::sumUp(int label) {
  RegionPatch& region = patchOf(label);
  if (region.triangleCount == 0) return;
  const Sums& sums = sumsOf(label);
  addUpBorders(region.neighbours);
  // V - E + F with one vertex per fan, so there are as many vertices on outlines as steps along
  // them.
  const int edges = (3 * region.triangleCount + sums.outlineSteps) / 2;
  region.eulerCharacteristic =
      sums.innerVertices + sums.outlineSteps - edges + region.triangleCount;
  region.genus = genusOf(region.components, region.loops, region.eulerCharacteristic);
  region.centroid = region.area > 0 ? Vector3d(sums.moment / region.area)
                                    : Vector3d(sums.centres / region.triangleCount);
}

double PatchMeasuring::squaredDistanceToCentroid(int t, const RegionPatch& region) const {
  return (partition_.positions[partition_.triangles[t][0]] - region.centroid).squaredNorm();
}

/// Offers the first corner of a triangle as the point nearest to the centroid. The best of these
/// bounds the distance, so that few whole triangles have to be looked at.
void PatchMeasuring::offerFirstCorner(int t) {
  const RegionPatch& region = patchOf(partition_.triangleLabel[t]);
  NearestOfTriangles& nearest = sumsOf(region.label).nearest;
  const double distance = squaredDistanceToCentroid(t, region);
  if (distance < nearest.squaredDistance) nearest = {{Vector3d::Unit(0), distance}, t};
}

void PatchMeasuring::offerTriangle(int t) {
  const RegionPatch& region = patchOf(partition_.triangleLabel[t]);
  Sums& sums = sumsOf(region.label);
  NearestOfTriangles& nearest = sums.nearest;
  // (a + b)² ≤ 2 (a² + b²)
  if (squaredDistanceToCentroid(t, region) > 2 * (nearest.squaredDistance + sums.squaredReach))
    return;
  const NearestPoint here = nearestOnTriangle(region.centroid, cornersOf(t));
  if (here.squaredDistance < nearest.squaredDistance) nearest = {here, t};
}

void PatchMeasuring::setNearCentroid(int label) {
  const NearestOfTriangles& nearest = sumsOf(label).nearest;
  if (nearest.triangle < 0) return;
  patchOf(label).nearCentroid = {partition_.triangleFace[nearest.triangle],
                                 cornersInFace(mesh_, partition_, nearest.triangle) * nearest.bary};
}

}  // namespace gvd
