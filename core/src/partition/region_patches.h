// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/partition.h"
#include "gvd/triangle_mesh.h"
#include "mesh/corners.h"
#include "mesh/nearest_on_triangle.h"

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

  /// Sums over a region.
  struct Sums {
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();   ///< areas times centres of triangles
    Eigen::Vector3d centres = Eigen::Vector3d::Zero();  ///< of its triangles
    double reach = 0;  ///< most squared distance of a triangle's points from its first corner
    int outlineSteps = 0, innerVertices = 0;
  };
  /// The point of a region that is nearest to its centroid.
  struct Nearest : NearestPoint {
    int triangle = 0;
  };

  int tail(int h) const { return tailOf(partition_.triangles, h); }
  int tip(int h) const { return tipOf(partition_.triangles, h); }
  SpaceTriangle cornersOf(int t) const;
  double squaredDistanceToCentroid(int t, const RegionPatch& region) const;
  RegionPatch& patchOf(int label);

  bool measureAll(long& budget);
  bool measure(RegionPatch& region, long& budget);
  void addArea(int t, RegionPatch& region);
  void walkOutlineFrom(int start, RegionPatch& region);
  void addStep(int h, RegionPatch& region);
  void countInnerVertices(int t);
  bool countComponents(RegionPatch& region, long& budget);
  void countTopology(RegionPatch& region) const;
  void offerFirstCorner(int t, const RegionPatch& region);
  void offerTriangle(int t, const RegionPatch& region);

  const TriangleMesh& mesh_;
  const int siteCount_;
  const std::span<const double> areas_;
  Partition& partition_;

  SlicedSequence sequence_, measuring_;
  int measured_ = 0;             ///< regions
  std::vector<char> isSeen_;     ///< triangles
  std::vector<char> isWalked_;   ///< halfedges on outlines
  std::vector<char> isCounted_;  ///< vertices; on outlines, steps count them
  std::vector<int> lastLabel_;   ///< per vertex, of the last region whose outline passed it

  // Of the current region.
  Sums sums_;
  Nearest nearest_;         ///< so far
  int nextToSee_ = 0;       ///< triangle
  std::vector<int> stack_;  ///< triangles seen whose neighbours are to be visited
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
