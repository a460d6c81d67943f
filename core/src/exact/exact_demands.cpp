// SPDX-License-Identifier: MIT
#include "exact/exact_demands.h"

#include <algorithm>
#include <numeric>

#include "base/tolerances.h"

namespace gvd::exact {

void Demands::add(const TriangleMesh& mesh, VertexTable& table, int entry) {
  Entry& e = table[entry];
  if (e.demand >= 0) return;
  e.demand = static_cast<int>(demands_.size());
  demands_.push_back({mesh.position(e.vertex), e.distance, table.best(e.vertex).distance, e.vertex,
                      e.label, entry});
}

void Demands::index(VertexTable& table) {
  std::fill(offset_.begin(), offset_.end(), 0);
  for (const Demand& d : demands_) ++offset_[d.label + 1];
  std::partial_sum(offset_.begin(), offset_.end(), offset_.begin());
  std::vector<int> cursor(offset_.begin(), offset_.end() - 1);
  std::vector<Demand> sorted(demands_.size());
  for (const Demand& d : demands_) {
    table[d.entry].demand = cursor[d.label];
    sorted[cursor[d.label]++] = d;
  }
  demands_.swap(sorted);
}

bool Demands::isNeeded(int label, const Eigen::Vector3d& place, double radius, double length,
                       double excess, const std::array<int, 3>& without) const {
  for (int i = offset_[label]; i < offset_[label + 1]; ++i) {
    const Demand& demand = demands_[i];
    const double rest = demand.bound * (1 - kDistanceTolerance) - length + radius;
    if (rest <= 0 || excess >= demand.bound - demand.best) continue;
    if ((demand.position - place).squaredNorm() >= rest * rest) continue;
    if (demand.vertex == without[0] || demand.vertex == without[1] || demand.vertex == without[2])
      continue;
    return true;
  }
  return false;
}

}  // namespace gvd::exact
