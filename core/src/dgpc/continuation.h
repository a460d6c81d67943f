// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "dgpc/dgpc_field.h"

namespace gvd {

/// Adds to the nearest site of each vertex those other sites that a diagram needs to know there.
///
/// To tell where in a face one region ends, the distances of both labels must be known at all its
/// corners, also those that another label owns. What counts there is the continuation of the
/// distance inside the region: how far the site is, as seen from the corners the region has. So it
/// depends on no path outside of the region, and nothing need have spread there. Only where labels
/// tie because their paths bend at the same vertex, all of them are told, however far behind it.
///
/// Paths that bend are straightened there, those of owners too. A site may then be nearer to a
/// vertex than the one that the sweep has found for it, and what a vertex knows is what counts: the
/// sweep's is only where this starts.
///
/// Fills in the labels of all vertices of a field that knows the sites and what is nearest.
void continueOverBorders(DgpcField& field);

/// Where the labels of a field have changed.
struct LabelChange {
  std::vector<int> vertices;  ///< ascending
  std::vector<int> labels;    ///< all that are or were known there, ascending
};

/// Keeps up to date what `continueOverBorders` has filled in. Each time it takes time for what is
/// near the change, and little for each site.
class ContinuationUpdates {
 public:
  /// The field must outlive this.
  explicit ContinuationUpdates(DgpcField& field);
  ~ContinuationUpdates();

  /// Brings up to date what follows from a change: of the nearest site of some vertices, or how it
  /// is seen, or of a site in a face that they are corners of.
  LabelChange run(std::span<const int> changed);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace gvd
