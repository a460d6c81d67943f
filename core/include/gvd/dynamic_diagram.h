// SPDX-License-Identifier: MIT
/// \file
/// A diagram whose sites are inserted, moved and removed in time that depends on the surroundings
/// only.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gvd/diagram.h"
#include "gvd/geodesic.h"
#include "gvd/sliced_work.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The parts of a diagram that a change of sites has altered. Everything else is unchanged.
struct DiagramChange {
  /// The regions that may differ, ascending, including those of inserted and removed sites.
  std::vector<int> labels;
  /// The faces that may differ, ascending. `part` has all cells of each.
  std::vector<int> faces;
  /// Replaces everything that the diagram had for these labels and faces:
  ///  - the loops of `labels`;
  ///  - all arcs, with their segments, and all Voronoi points that involve one of `labels`;
  ///  - the cells of `faces`, and the indifferent ones of `faces`.
  ///
  /// Points are numbered anew, and `siteCount` is `labelCount()`. `faceLabel` is given per entry of
  /// `faces`, `regionArea` per entry of `labels`.
  Diagram part;
};

/// A diagram whose sites are inserted, removed and moved. Only the surroundings of a change are
/// computed anew. The result is the diagram that `propagate` and `traceDiagram` give for the
/// present sites: the same combinatorics, and numbers equal up to rounding. Distances have the same
/// bits, unless several straight paths to a vertex are equally long: then they may differ by the
/// rounding of these lengths, less than 2^-44 of them, and 2^-46 of the longest edge.
///
/// A site keeps its label until it is removed; a free label has an empty region. So the labels of n
/// sites are 0 … n - 1 only if no site was removed. Every function that takes a list of sites
/// accepts `sites()`, which has the same labels.
class DynamicDiagram {
 public:
  /// The mesh must outlive this. Sites are given in the mesh's faces; the list may be empty and may
  /// have labels without a site (face -1). Here and below, a site that is not on the mesh throws
  /// `Error(kInvalidPoint)` and changes nothing. Throws `Error(kInvalidArgument)` if `detail` is
  /// out of its range.
  DynamicDiagram(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                 Metric metric = Metric::kExact, const DiagramOptions& options = {});
  /// The same in steps.
  static std::unique_ptr<SlicedWork<DynamicDiagram>> start(const TriangleMesh& mesh,
                                                           std::span<const SurfacePoint> sites,
                                                           Metric metric = Metric::kExact,
                                                           const DiagramOptions& options = {});
  /// The diagram of distances that `propagate` has computed for the same mesh. From now on the
  /// distances change with the diagram; if this throws, they are unchanged. Takes as long as
  /// `traceDiagram`. Throws `Error(kInvalidArgument)` if the distances come from elsewhere, are
  /// those of another mesh, or have been given to a diagram before.
  static DynamicDiagram fromDistances(const TriangleMesh& mesh,
                                      const std::shared_ptr<DistanceField>& distances,
                                      const DiagramOptions& options = {});
  /// The same in steps.
  static std::unique_ptr<SlicedWork<DynamicDiagram>> startFromDistances(
      const TriangleMesh& mesh, const std::shared_ptr<DistanceField>& distances,
      const DiagramOptions& options = {});
  ~DynamicDiagram();
  DynamicDiagram(DynamicDiagram&&) noexcept;
  DynamicDiagram& operator=(DynamicDiagram&&) noexcept;

  /// A change takes about as long as computing the regions in `DiagramChange::labels`, however
  /// large the mesh is. (A little time is added per loop of the mesh boundary, and if several sites
  /// tie behind a saddle vertex, per vertex of the mesh. With `detail`, the whole diagram is traced
  /// again if the change touches a face in which a label is nearest without being known at its
  /// corners.) The new site gets `lowestFreeLabel()`. After `std::bad_alloc` the change stays
  /// unfinished (`startInsert`).
  DiagramChange insertSite(const SurfacePoint& site);
  /// Throws `Error(kInvalidArgument)` if no site has the label.
  DiagramChange removeSite(int label);
  DiagramChange moveSite(int label, const SurfacePoint& site);

  /// The same in steps. Errors are thrown here, before anything changes. Until the change is done
  /// the diagram is inconsistent: all functions throw `Error(kInvalidArgument)`, for good if the
  /// change is dropped unfinished, and `distances` given out before must not be used. The diagram
  /// must outlive the change.
  std::unique_ptr<SlicedWork<DiagramChange>> startInsert(const SurfacePoint& site);
  /// Inserts several sites as one change, in less time than one after the other. They get the
  /// lowest free labels, in their order.
  std::unique_ptr<SlicedWork<DiagramChange>> startInsert(std::span<const SurfacePoint> sites);
  std::unique_ptr<SlicedWork<DiagramChange>> startRemove(int label);
  std::unique_ptr<SlicedWork<DiagramChange>> startMove(int label, const SurfacePoint& site);

  /// The lowest label without a site. O(labels).
  int lowestFreeLabel() const;
  /// All labels that have had a site are below this number. Labels without a site at the end of the
  /// list given do not count.
  int labelCount() const;
  bool hasSite(int label) const;
  /// Throws `Error(kInvalidArgument)` if no site has the label. O(1).
  SurfacePoint site(int label) const;
  /// By label; face -1 where a label has no site. O(labels).
  std::vector<SurfacePoint> sites() const;

  /// Up to date after every change.
  const DistanceField& distances() const;
  /// The whole diagram. `siteCount` is `labelCount()`. O(size of the diagram).
  Diagram diagram() const;
  /// The same in steps. No change may begin before it is done.
  std::unique_ptr<SlicedWork<Diagram>> startDiagram() const;

 private:
  class Implementation;
  explicit DynamicDiagram(std::unique_ptr<Implementation> implementation);
  Implementation& whole() const;

  std::unique_ptr<Implementation> implementation_;
};

}  // namespace gvd
