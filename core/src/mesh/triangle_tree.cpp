// SPDX-License-Identifier: MIT
#include "mesh/triangle_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace gvd {
namespace {

constexpr int kLeafSize = 4;

Eigen::Vector3d sumOf(const SpaceTriangle& t) { return t[0] + t[1] + t[2]; }

}  // namespace

TriangleTree::TriangleTree(std::vector<SpaceTriangle> triangles)
    : triangles_(std::move(triangles)) {}

TriangleTree::TriangleTree(const TriangleMesh& mesh) : mesh_(&mesh) {}

bool TriangleTree::step(long& budget) {
  return sequence_.run([&](SlicedLoop& loop) { return !mesh_ || takeFaces(loop, budget); },
                       [&] {
                         order_.resize(triangles_.size());
                         std::iota(order_.begin(), order_.end(), 0);
                         if (!order_.empty())
                           tasks_.push_back({0, static_cast<int>(order_.size()), -1});
                       },
                       [&] {
                         while (!tasks_.empty() && budget > 0) makeNext(budget);
                         return tasks_.empty();
                       });
}

bool TriangleTree::takeFaces(SlicedLoop& loop, long& budget) {
  triangles_.reserve(mesh_->faceCount());
  return loop.run(mesh_->faceCount(), budget, 8, [&](int f) {
    const auto corner = [&](int i) { return mesh_->position(mesh_->tail(3 * f + i)); };
    triangles_.push_back({corner(0), corner(1), corner(2)});
  });
}

/// Halves the triangles of a node along the longest side of the box of their centres.
void TriangleTree::makeNext(long& budget) {
  constexpr int kTrianglesPerUnit = 16;
  const auto [first, last, parent] = tasks_.back();
  tasks_.pop_back();
  budget -= 1 + (last - first) / kTrianglesPerUnit;
  const int node = static_cast<int>(nodes_.size());
  if (parent >= 0) nodes_[parent].second = node;
  Eigen::AlignedBox3d box, centres;
  for (int i = first; i < last; ++i) {
    for (const Eigen::Vector3d& corner : triangles_[order_[i]]) box.extend(corner);
    centres.extend(sumOf(triangles_[order_[i]]));
  }
  nodes_.push_back({box, first, last, -1});
  if (last - first <= kLeafSize) return;
  Eigen::Index axis;
  centres.sizes().maxCoeff(&axis);
  const int middle = (first + last) / 2;
  std::nth_element(
      order_.begin() + first, order_.begin() + middle, order_.begin() + last,
      [&](int a, int b) { return sumOf(triangles_[a])[axis] < sumOf(triangles_[b])[axis]; });
  tasks_.push_back({middle, last, node});
  tasks_.push_back({first, middle, -1});
}

TriangleTree::Nearest TriangleTree::nearest(const Eigen::Vector3d& p) const {
  Nearest nearest;
  const auto toBox = [&](int node) { return nodes_[node].box.squaredExteriorDistance(p); };
  std::vector<std::pair<double, int>> open;
  if (!nodes_.empty()) open.emplace_back(toBox(0), 0);
  while (!open.empty()) {
    const auto [bound, index] = open.back();
    open.pop_back();
    if (bound > nearest.squaredDistance) continue;
    const Node& node = nodes_[index];
    if (node.second < 0) {
      for (int i = node.first; i < node.last; ++i) {
        const NearestPoint here = nearestOnTriangle(p, triangles_[order_[i]]);
        if (here.squaredDistance < nearest.squaredDistance ||
            (here.squaredDistance == nearest.squaredDistance && order_[i] < nearest.triangle))
          nearest = {here, order_[i]};
      }
      continue;
    }
    std::pair<double, int> near(toBox(index + 1), index + 1), far(toBox(node.second), node.second);
    if (far < near) std::swap(near, far);
    open.push_back(far);
    open.push_back(near);
  }
  return nearest;
}

}  // namespace gvd
