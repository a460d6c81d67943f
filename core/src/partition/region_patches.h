// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/partition.h"
#include "gvd/triangle_mesh.h"
#include "mesh/corners.h"

namespace gvd {

/// Fills in `regions` and `unreachable` of a partition whose triangles and twins are known, in
/// slices.
class PatchMeasuring {
 public:
  /// `areas` are those of the partition's triangles. All must outlive this.
  PatchMeasuring(const TriangleMesh& mesh, int siteCount, std::span<const double> areas,
                 Partition& partition);
  bool step(long& budget);

 private:
  static constexpr int kNoLabel = -2;  // neither a region's nor `Diagram::kUnreachable`

  int tail(int h) const { return tailOf(partition_.triangles, h); }
  int tip(int h) const { return tipOf(partition_.triangles, h); }
  std::array<Eigen::Vector3d, 3> cornersOf(int t) const;
  double squaredDistanceToCentroid(int t, const RegionPatch& region) const;
  RegionPatch& patchOf(int label);

  bool measureAll(long& budget);
  bool measure(RegionPatch& region, long& budget);
  void noteOutline(int h);
  void addArea(int t, RegionPatch& region);
  void walkOutlineFrom(int start, RegionPatch& region);
  void addStep(int h, RegionPatch& region);
  void countInnerVertices(int t);
  bool countComponents(RegionPatch& region, long& budget);
  void countTopology(RegionPatch& region) const;
  void offerTriangle(int t, const RegionPatch& region);

  const TriangleMesh& mesh_;
  const int siteCount_;
  const std::span<const double> areas_;
  Partition& partition_;

  SlicedSequence sequence_, measuring_;
  SlicedLoop loop_;
  int measured_ = 0;               ///< regions
  std::vector<char> isOnOutline_;  ///< halfedges
  std::vector<char> isSeen_;       ///< triangles
  std::vector<char> isWalked_;     ///< halfedges on outlines
  std::vector<char> isOnBorder_;
  std::vector<int> lastLabel_;  ///< per vertex, of the last region whose outline passed it

  // Of the current region.
  Eigen::Vector3d moment_, sum_;
  double reach_ = 0;  ///< most squared distance of a triangle's points from its first corner
  int outlineSteps_ = 0, innerVertices_ = 0;
  int nextToSee_ = 0;       ///< triangle
  std::vector<int> stack_;  ///< triangles seen whose neighbours are to be visited
  int nearest_ = 0;
  double least_ = 0;  ///< least squared distance to the centroid so far
  Eigen::Vector3d nearestBary_;
};

/// The next halfedge along the outline of a region after h, which is on that outline: turns around
/// the tip of h within the region.
int nextOnOutline(const Partition& partition, int h);

/// Whether a halfedge is on the outline of its region.
inline bool isOnOutline(const Partition& partition, int h) {
  const int twin = partition.twins[h];
  return twin < 0 || partition.triangleLabel[twin / 3] != partition.triangleLabel[h / 3];
}

}  // namespace gvd
