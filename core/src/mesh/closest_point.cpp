// SPDX-License-Identifier: MIT
//
// A tree of the faces of a mesh, and what is asked of it.
#include "gvd/closest_point.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "gvd/error.h"
#include "mesh/triangle_tree.h"

namespace gvd {
namespace {

std::vector<TriangleTree::Triangle> facesOf(const TriangleMesh& mesh) {
  std::vector<TriangleTree::Triangle> faces;
  faces.reserve(mesh.faceCount());
  for (int h = 0; h < mesh.halfedgeCount(); h += 3)
    faces.push_back({mesh.position(mesh.tail(h)), mesh.position(mesh.tail(h + 1)),
                     mesh.position(mesh.tail(h + 2))});
  return faces;
}

}  // namespace

class ClosestPointQuery::Implementation {
 public:
  explicit Implementation(const TriangleMesh& mesh) : tree_(facesOf(mesh)) {
    long unlimited = std::numeric_limits<long>::max();
    tree_.step(unlimited);
  }

  ClosestPoint closestTo(const Eigen::Vector3d& place) const {
    const TriangleTree::Nearest nearest = tree_.nearest(place);
    if (nearest.triangle < 0)
      throw Error(ErrorCode::kInvalidPoint, "its distance from the surface is not a finite number");
    return {{nearest.triangle, nearest.bary}, std::sqrt(nearest.squaredDistance)};
  }

 private:
  TriangleTree tree_;
};

ClosestPointQuery::ClosestPointQuery(const TriangleMesh& mesh)
    : implementation_(std::make_unique<Implementation>(mesh)) {}
ClosestPointQuery::~ClosestPointQuery() = default;
ClosestPointQuery::ClosestPointQuery(ClosestPointQuery&&) noexcept = default;
ClosestPointQuery& ClosestPointQuery::operator=(ClosestPointQuery&&) noexcept = default;

ClosestPoint ClosestPointQuery::closestTo(const Eigen::Vector3d& place) const {
  return implementation_->closestTo(place);
}

}  // namespace gvd
