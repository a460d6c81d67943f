// SPDX-License-Identifier: MIT
//
// Closest-point queries, by a tree of the faces of a mesh.
#include "gvd/closest_point.h"

#include <cmath>
#include <utility>

#include "gvd/error.h"
#include "mesh/triangle_tree.h"

namespace gvd {

class ClosestPointQuery::Implementation {
 public:
  explicit Implementation(const TriangleMesh& mesh) : tree_(mesh) {}

  bool step(long budget) { return tree_.step(budget); }
  double progress() const { return tree_.progress(); }

  ClosestPoint closestTo(const Eigen::Vector3d& place) const {
    const TriangleTree::Nearest nearest = tree_.nearest(place);
    if (nearest.triangle < 0)
      throw Error(ErrorCode::kInvalidPoint,
                  "the distance of the place from the surface is not a finite number");
    return {{nearest.triangle, nearest.bary}, std::sqrt(nearest.squaredDistance)};
  }

 private:
  TriangleTree tree_;
};

class ClosestPointQuery::Building final : public SlicedWork<ClosestPointQuery> {
 public:
  explicit Building(const TriangleMesh& mesh)
      : implementation_(std::make_unique<Implementation>(mesh)) {}
  bool step(long budget) override { return implementation_->step(budget); }
  double progress() const override { return implementation_->progress(); }
  ClosestPointQuery take() override { return ClosestPointQuery(std::move(implementation_)); }

 private:
  std::unique_ptr<Implementation> implementation_;
};

std::unique_ptr<SlicedWork<ClosestPointQuery>> startClosestPointQuery(const TriangleMesh& mesh) {
  return std::make_unique<ClosestPointQuery::Building>(mesh);
}

ClosestPointQuery::ClosestPointQuery(const TriangleMesh& mesh)
    : ClosestPointQuery(finished(startClosestPointQuery(mesh))) {}
ClosestPointQuery::ClosestPointQuery(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ClosestPointQuery::~ClosestPointQuery() = default;
ClosestPointQuery::ClosestPointQuery(ClosestPointQuery&&) noexcept = default;
ClosestPointQuery& ClosestPointQuery::operator=(ClosestPointQuery&&) noexcept = default;

ClosestPoint ClosestPointQuery::closestTo(const Eigen::Vector3d& place) const {
  return implementation_->closestTo(place);
}

}  // namespace gvd
