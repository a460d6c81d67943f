// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/index_set.h"
#include "dgpc/dgpc_field.h"
#include "dgpc/path_straightening.h"

namespace gvd {

/// Carries ties on to what lies behind the vertices where paths bend. All that is reached around
/// such a vertex is as far from each of the labels that tie there, but a sweep goes on with the
/// lowest of them only, for the others own nothing there.
///
/// Sites in one place tie everywhere, and the lowest takes it all: of those only it is carried on.
class SaddleTies {
 public:
  /// `straightener` is one of the same field, to find back along paths with.
  SaddleTies(DgpcField& field, PathStraightener& straightener)
      : field_(field), mesh_(field.mesh()), straightener_(straightener) {}

  /// Carries all ties on, once the labels of all vertices have been set.
  void carryEverywhere();

  /// Adds to a scope all vertices that ties have been carried on to from within it.
  static void addTold(const DgpcField& field, IndexSet& scope);
  /// The same after the labels of the vertices in a scope with all that `addTold` adds have been
  /// set anew. Returns the vertices that have labels added or changed, in no order.
  std::vector<int> carryAround(const IndexSet& scope);

 private:
  /// Where a path comes through a vertex.
  struct Passage {
    int vertex;
    double way;  ///< from there to the end of the path
  };

  bool isOrigin(int vertex) const;
  std::vector<LabelledDistance> tiesAt(int vertex) const;
  std::vector<int> carry(std::vector<int> told);
  void addSource(int vertex);
  bool mayBeSource(double distance) const;
  std::optional<View> viewFromSource(int vertex) const;
  std::optional<Passage> lastPassage(int vertex);
  bool tell(int vertex, const Passage& from);

  DgpcField& field_;
  const TriangleMesh& mesh_;
  PathStraightener& straightener_;
  std::set<std::pair<double, int>> sources_;  ///< where labels tie and paths bend, by distance
};

}  // namespace gvd
