// SPDX-License-Identifier: MIT
/// \file
/// A diagram whose sites are inserted, moved and removed, at the cost of their surroundings.
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

/// What a change of sites has made different in a diagram. All else is as it was.
struct DiagramChange {
  /// The regions that may differ, ascending; among them those that have come or gone.
  std::vector<int> labels;
  /// The faces that may differ, ascending. In each of them, all cells are given.
  std::vector<int> faces;
  /// What takes the place of everything that the diagram had of these labels and faces:
  ///  - the loops of `labels`;
  ///  - all arcs (with all their segments) and all Voronoi points at which one of `labels` takes
  ///  part;
  ///  - the cells of `faces`, and those of `faces` that are indifferent.
  ///
  /// Points are numbered anew. `faceLabel` is given per entry of `faces`, `regionArea` per entry of
  /// `labels`.
  Diagram part;
};

/// A diagram whose sites come, go and move. Only the surroundings of a change are computed anew;
/// what results is the diagram of the present sites: combinatorially, and to rounding in its
/// numbers, the one that `propagate` and `traceDiagram` give. The distances have the same bits, but
/// where several straight paths to a vertex are equally long: these differ by what they round by,
/// less than 2^-44 of their length.
///
/// A site keeps its label until it is removed, and labels that are free have empty regions. So
/// labels are not always consecutive: of n sites they are the lowest n unless sites were removed.
/// `sites()` is a list that all functions take which take sites, with the same labels.
class DynamicDiagram {
 public:
  /// The mesh must outlive this. Sites are in terms of the mesh's faces; there may be none, and
  /// labels without a site (face -1). Here and below, a site that is not on the mesh is refused by
  /// `Error(kInvalidPoint)`, and nothing has changed then.
  DynamicDiagram(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                 Metric metric = Metric::kExact, const DiagramOptions& options = {});
  /// The same in steps.
  static std::unique_ptr<SlicedWork<DynamicDiagram>> start(const TriangleMesh& mesh,
                                                           std::span<const SurfacePoint> sites,
                                                           Metric metric = Metric::kExact,
                                                           const DiagramOptions& options = {});
  /// The diagram of the sites of which these are the distances, as `propagate` gives them with
  /// `Spread::kAsNeeded`, for the same mesh. From now on they change with the diagram; if this
  /// throws, they are as they were. Takes as long as `traceDiagram`. Throws
  /// `Error(kInvalidArgument)` if they come from elsewhere.
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

  /// Each of these takes about as long as it takes to compute the regions in
  /// `DiagramChange::labels`, however large the mesh is. (Where several sites tie behind a saddle
  /// vertex, a little time per vertex of the mesh comes on top.) The new site gets
  /// `lowestFreeLabel()`.
  DiagramChange insertSite(const SurfacePoint& site);
  /// Throws `Error(kInvalidArgument)` if no site has the label.
  DiagramChange removeSite(int label);
  DiagramChange moveSite(int label, const SurfacePoint& site);

  /// The same in steps. Errors are thrown here, before anything changes. Until the change is done
  /// the diagram is neither that before it nor that after it: nothing else may be asked of it, and
  /// it cannot be used any more if the change is dropped. It must outlive the change, but for that.
  std::unique_ptr<SlicedWork<DiagramChange>> startInsert(const SurfacePoint& site);
  std::unique_ptr<SlicedWork<DiagramChange>> startRemove(int label);
  std::unique_ptr<SlicedWork<DiagramChange>> startMove(int label, const SurfacePoint& site);

  int lowestFreeLabel() const;
  /// Labels are less than this.
  int labelCount() const;
  bool hasSite(int label) const;
  const SurfacePoint& site(int label) const;
  /// By label; face -1 where a label has no site.
  std::vector<SurfacePoint> sites() const;

  /// Up to date after every change.
  const DistanceField& distances() const;
  /// All of the diagram. `siteCount` is `labelCount()`. O(size of the diagram).
  Diagram diagram() const;

 private:
  class Implementation;
  class Opening;
  explicit DynamicDiagram(std::unique_ptr<Implementation> implementation);

  std::unique_ptr<Implementation> implementation_;
};

}  // namespace gvd
