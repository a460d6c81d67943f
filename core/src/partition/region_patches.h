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

  /// What is summed up over a region, and what is best in it so far.
  struct Sums {
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();   ///< areas times centres of triangles
    Eigen::Vector3d centres = Eigen::Vector3d::Zero();  ///< of its triangles
    double squaredReach = 0;  ///< of the farthest points of triangles from their first corners
    int outlineSteps = 0, innerVertices = 0;
    NearestOfTriangles nearest;  ///< to the centroid
  };

  int tail(int h) const { return tailOf(partition_.triangles, h); }
  int tip(int h) const { return tipOf(partition_.triangles, h); }
  SpaceTriangle cornersOf(int t) const;
  double squaredDistanceToCentroid(int t, const RegionPatch& region) const;
  RegionPatch& patchOf(int label);
  /// `Diagram::kUnreachable` is -1.
  Sums& sumsOf(int label) { return sums_[label + 1]; }

  void walkOutlineFrom(int start);
  void addStep(int h, RegionPatch& region);
  void addTriangle(int t);
  bool countComponents(long& budget);
  void sumUp(int label);
  void offerFirstCorner(int t);
  void offerTriangle(int t);
  void setNearCentroid(int label);

  const TriangleMesh& mesh_;
  const int siteCount_;
  const std::span<const double> areas_;
  Partition& partition_;

  SlicedSequence sequence_;
  std::vector<Sums> sums_;      ///< of what no site reaches, then of each region
  std::vector<char> isSeen_;    ///< triangles
  std::vector<int> stack_;      ///< triangles seen whose neighbours are to be visited
  int nextToSee_ = 0;           ///< triangle
  std::vector<char> isWalked_;  ///< halfedges on outlines
  std::vector<int> lastLabel_;  ///< per vertex, of the last region that was found to have it
};

/// Whether a halfedge is on the outline of its region.
inline bool isOnOutline(const Partition& partition, int h) {
  const int twin = partition.twins[h];
  return twin < 0 || partition.triangleLabel[twin / 3] != partition.triangleLabel[h / 3];
}

/// Calls `visit` with the halfedges of a region's outline in order, from `start` on. Where an
/// outline passes a point, the next halfedge is found by turning around the point within the
/// region.
template <class Visit>
void walkOutline(const Partition& partition, int start, Visit visit) {
  int h = start;
  do {
    visit(h);
    h = TriangleMesh::next(h);
    while (!isOnOutline(partition, h)) h = TriangleMesh::next(partition.twins[h]);
  } while (h != start);
}

}  // namespace gvd
