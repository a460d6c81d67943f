// SPDX-License-Identifier: MIT
#include "mesh/triangle_tree.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/index_set.h"

namespace gvd {
namespace {

constexpr int kLeafSize = 4;

Eigen::Vector3d sumOf(const SpaceTriangle& t) { return t[0] + t[1] + t[2]; }

}  // namespace

TriangleTree::TriangleTree(std::vector<SpaceTriangle> triangles)
    : triangles_(std::move(triangles)) {}

TriangleTree::TriangleTree(const TriangleMesh& mesh) : mesh_(&mesh) {}

bool TriangleTree::step(long& budget) {
  const int faces = mesh_ ? mesh_->faceCount() : 0;
  return sequence_.run(
      [&] { triangles_.reserve(faces); },
      forEach(faces, budget, 8,
              [&](int f) {
                const auto& [a, b, c] = mesh_->face(f).vertices;
                triangles_.push_back({mesh_->position(a), mesh_->position(b), mesh_->position(c)});
              }),
      [&] {
        order_ = indicesBelow(static_cast<int>(triangles_.size()));
        if (!order_.empty()) tasks_.push_back({0, static_cast<int>(order_.size()), -1});
      },
      [&] {
        while (!tasks_.empty())
          if (!makeNext(budget)) return false;
        return true;
      });
}

/// Makes a node, and divides its triangles along the longest side of the box of their centres, in
/// slices; true when it is done.
bool TriangleTree::makeNext(long& budget) {
  constexpr long kTrianglesPerUnit = 16;
  const auto [first, last, parent] = tasks_.back();
  const int count = last - first, begin = first;
  if (budget <= 0 ||
      !making_.runRound(
          [&] {
            box_.setEmpty();
            centres_.setEmpty();
          },
          forEach(count, budget, kTrianglesPerUnit,
                  [&](int i) {
                    const SpaceTriangle& triangle = triangles_[order_[begin + i]];
                    for (const Eigen::Vector3d& corner : triangle) box_.extend(corner);
                    centres_.extend(sumOf(triangle));
                  }),
          [&] {
            middle_ = begin;
            findPivot(begin, count);
          },
          forEach(count <= kLeafSize ? 0 : count, budget, kTrianglesPerUnit, [&](int i) {
            if (sumOf(triangles_[order_[begin + i]])[axis_] < pivot_)
              std::swap(order_[begin + i], order_[middle_++]);
          })))
    return false;
  tasks_.pop_back();
  const int node = static_cast<int>(nodes_.size());
  if (parent >= 0) nodes_[parent].second = node;
  nodes_.push_back({box_, first, last, -1});
  if (count <= kLeafSize) return true;
  if (middle_ == first) middle_ += count / 2;  // none is less than the pivot
  tasks_.push_back({middle_, last, node});
  tasks_.push_back({first, middle_, -1});
  return true;
}

/// Finds the median of some centres, along the longest side of their box: the median of all would
/// take a large mesh too long in one step.
void TriangleTree::findPivot(int first, int count) {
  constexpr int kSamples = 63;
  centres_.sizes().maxCoeff(&axis_);
  std::vector<double> sample;
  for (int i = 0; i < std::min(count, kSamples); ++i) {
    const auto place = static_cast<std::int64_t>(i) * count / std::min(count, kSamples);
    sample.push_back(sumOf(triangles_[order_[first + place]])[axis_]);
  }
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
  std::nth_element(sample.begin(), middle, sample.end());
  pivot_ = *middle;
}

NearestOfTriangles TriangleTree::nearest(const Eigen::Vector3d& p, double below,
                                         const std::function<bool(int)>& isSought) const {
  NearestOfTriangles nearest;
  nearest.squaredDistance = below * below;
  const auto toBox = [&](int node) { return nodes_[node].box.squaredExteriorDistance(p); };
  std::vector<std::pair<double, int>> open;
  open.reserve(64);  // more than a tree is deep, mostly
  if (!nodes_.empty()) open.emplace_back(toBox(0), 0);
  while (!open.empty()) {
    const auto [bound, index] = open.back();
    open.pop_back();
    if (bound > nearest.squaredDistance) continue;
    const Node& node = nodes_[index];
    if (node.second < 0) {
      for (int i = node.first; i < node.last; ++i) {
        if (isSought && !isSought(order_[i])) continue;
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
