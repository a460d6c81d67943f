// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "exact/exact_vertices.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// A distance at a vertex that a label has to know, although another one is nearer there.
struct Demand {
  Eigen::Vector3d position;
  double bound;  ///< the label's distance so far
  double best;   ///< the nearest label's
  int vertex;
  int label;
  int entry;
};

/// All distances that are asked for.
class Demands {
 public:
  explicit Demands(int labelCount) : offset_(labelCount + 1, 0) {}

  /// Asks for an entry's distance, from the next `index` on.
  void add(const TriangleMesh& mesh, VertexTable& table, int entry);
  /// Has an entry's distance become less.
  void shorten(int demand, double distance) { demands_[demand].bound = distance; }
  /// Groups the demands by label, for `isNeeded`.
  void index(VertexTable& table);

  /// Whether a path of at least the given length up to a point at most `radius` from `place` can
  /// become the shortest of its label to a vertex that asks for it, three vertices left out. There,
  /// it is longer than another label's by `excess`, and so it remains.
  bool isNeeded(int label, const Eigen::Vector3d& place, double radius, double length,
                double excess, const std::array<int, 3>& without) const;

 private:
  std::vector<int> offset_;  ///< of label l: demands_[offset_[l]] up to demands_[offset_[l + 1]]
  std::vector<Demand> demands_;
};

}  // namespace gvd::exact
