// SPDX-License-Identifier: MIT
//
// Closest-point queries, by a tree of the faces of a mesh.
#include "gvd/closest_point.h"

#include <cmath>
#include <utility>

#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "mesh/triangle_tree.h"

namespace gvd {

std::unique_ptr<SlicedWork<ClosestPointQuery>> startClosestPointQuery(const TriangleMesh& mesh) {
  return workOn(std::make_unique<TriangleTree>(mesh),
                [](auto tree) { return ClosestPointQuery(std::move(tree)); });
}

ClosestPointQuery::ClosestPointQuery(const TriangleMesh& mesh)
    : ClosestPointQuery(finished(startClosestPointQuery(mesh))) {}
ClosestPointQuery::ClosestPointQuery(std::unique_ptr<const TriangleTree> tree)
    : tree_(std::move(tree)) {}
ClosestPointQuery::~ClosestPointQuery() = default;
ClosestPointQuery::ClosestPointQuery(ClosestPointQuery&&) noexcept = default;
ClosestPointQuery& ClosestPointQuery::operator=(ClosestPointQuery&&) noexcept = default;

ClosestPoint ClosestPointQuery::closestTo(const Eigen::Vector3d& place) const {
  const NearestOfTriangles nearest = tree_->nearest(place);
  if (nearest.triangle < 0)
    rejectPoint("the distance of the place from the surface is not a finite number");
  return {{nearest.triangle, nearest.bary}, std::sqrt(nearest.squaredDistance)};
}

}  // namespace gvd
