// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/grouping.h"
#include "base/index_pairs.h"
#include "base/sliced_loop.h"
#include "gvd/dual.h"
#include "gvd/partition.h"
#include "partition/dual_building.h"
#include "partition/region_complex.h"

namespace gvd {

/// A violation, and the triangles of the partition where it shows. A further site is put inside one
/// of these, not on a border: on the mesh boundary, triangles of the dual could have no area.
struct Finding {
  Violation violation;
  std::vector<int> triangles;
  int bareFace = -1;  ///< of a component without a site, which the partition leaves out
};

/// Finds the violations of a dual from the regions of its diagram, in slices.
class ViolationFinding {
 public:
  /// All must outlive this.
  ViolationFinding(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                   const Diagram& diagram, const RegionComplex& complex);
  bool step(long& budget);
  std::vector<Violation> take();
  /// The same violations, in the same order.
  std::vector<Finding> takeFindings() { return std::move(found_); }

 private:
  /// Two regions that have a vertex in common.
  struct VertexMeeting {
    int pair;  ///< in `pairs_`
    int vertex;
    bool hasArc;  ///< whether one of the arcs that end there is between the two
  };

  void add(Violation::Kind kind, std::vector<int> labels, std::string message,
           std::vector<int> triangles = {});
  void addBeside(int h, std::vector<int>& triangles) const;
  void addBeside(const RegionComplex::Border& border, std::vector<int>& triangles) const;
  void addAround(int vertex, std::vector<int>& triangles) const;

  void findBareFace(int f);
  void addBareComponents();
  void inspectRegion(const RegionPatch& region);
  void addMeetingAlong(int b);
  void addMeetingsAt(int v);
  void inspectPair(int pair);
  void findTriples(int pair);
  void addTriples();
  void inspectBoundaryFrom(int start);
  void inspectClosedRun(const RegionComplex::Border& border);
  void addFewRuns(const std::vector<int>& labels, std::vector<int> triangles);
  bool inspectDual(long budget);

  const TriangleMesh& mesh_;
  const std::span<const SurfacePoint> sites_;
  const Diagram& diagram_;
  const RegionComplex& complex_;

  SlicedSequence sequence_, ofDual_;
  std::vector<Finding> found_;
  std::vector<int> bareFace_;      ///< the first face of each component without a site, else -1
  IndexPairs pairs_;               ///< of regions that meet
  std::vector<int> pairOfBorder_;  ///< -1 for the outside, and for one of an arc's two borders
  std::vector<VertexMeeting> vertexMeetings_;
  Grouping bordersOf_, meetingsOf_;  ///< of each pair
  PointLists labelsAt_;              ///< the regions around each vertex, ascending
  std::map<std::vector<int>, std::vector<int>> triples_;  ///< regions → triangles
  std::vector<char> isWalked_;                            ///< vertices on the mesh boundary
  std::optional<DualBuilding> dualBuilding_;
  PolygonMesh dual_;
  std::unique_ptr<SlicedWork<PolygonTopology>> topology_;
};

}  // namespace gvd
