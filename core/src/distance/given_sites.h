// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/sliced_loop.h"
#include "distance/site_set.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// A label whose site is set, moved or removed.
struct SiteChange {
  int label;
  std::optional<SurfacePoint> site;  ///< none: the site is removed
};

/// The sites as they were given. Of sites at one place only the one with the lowest label takes
/// part in the distances: the others would tie with it everywhere, and k of them take k² times as
/// long.
class GivenSites {
 public:
  explicit GivenSites(const TriangleMesh& mesh) : mesh_(mesh), sites_(mesh) {}

  /// Makes room, in slices; true when it is there. Before the first step.
  bool prepare(long& budget) { return sites_.prepare(budget); }

  /// Begins a change of some labels, each named once. The previous change must be done. Throws
  /// `Error(kInvalidPoint)`, and changes nothing, if a site is not on the mesh.
  void change(std::span<const SiteChange> changes);
  /// Makes the change, in slices; true when done. `takingPart` are the sites that took part before.
  bool step(const SiteSet& takingPart, long& budget);

  /// All sites, also those that take no part.
  const SiteSet& all() const { return sites_; }
  /// What the change means for the sites that take part.
  const std::vector<SiteChange>& changes() const { return changes_; }

 private:
  void take(const SiteChange& given);
  int lowestAt(const SurfacePoint& place) const;
  void takePart(int label, const SiteSet& takingPart);

  const TriangleMesh& mesh_;
  SiteSet sites_;
  // The current change.
  SlicedSequence sequence_;
  std::vector<SiteChange> given_, changes_;
  std::vector<int> atPlaces_;  ///< labels that may begin or cease to be the lowest at their place
};

}  // namespace gvd
