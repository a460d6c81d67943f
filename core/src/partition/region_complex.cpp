// SPDX-License-Identifier: MIT
//
// Borders and nodes of a partition, read off the outlines of its regions.
#include "partition/region_complex.h"

#include <algorithm>
#include <utility>

#include "partition/region_patches.h"

namespace gvd {
namespace {

class Builder {
 public:
  explicit Builder(const Partition& partition)
      : partition_(partition),
        nodeOfVertex_(partition.points.size(), -1),
        borderAt_(partition.twins.size(), -1) {}

  RegionComplex build() {
    findNodes();
    walkLoops();
    listBordersOfNodes();
    return std::move(out_);
  }

 private:
  int tail(int h) const { return partition_.triangles[h / 3][h % 3]; }
  bool isOnOutline(int h) const { return gvd::isOnOutline(partition_, h); }

  /// The outline's halfedge that ends the sector which one leaving a vertex starts: turning
  /// counterclockwise within the region.
  int endOfSector(int h) const {
    int last = TriangleMesh::previous(h);
    while (!isOnOutline(last)) last = TriangleMesh::previous(partition_.twins[last]);
    return last;
  }

  /// A vertex on outlines is a node unless it has two sectors that close, or one on the boundary.
  void findNodes() {
    std::vector<int> sectors(partition_.points.size(), 0);
    std::vector<char> isOnBoundary(partition_.points.size(), false);
    for (int h = 0; h < static_cast<int>(partition_.twins.size()); ++h) {
      if (!isOnOutline(h)) continue;
      ++sectors[tail(h)];
      if (partition_.twins[h] < 0) isOnBoundary[tail(h)] = true;
    }
    for (int v = 0; v < static_cast<int>(sectors.size()); ++v) {
      if (sectors[v] < (isOnBoundary[v] ? 2 : 3)) continue;
      nodeOfVertex_[v] = static_cast<int>(out_.nodes.size());
      out_.nodes.push_back({v, {}, -1});
    }
  }

  void walkLoops() {
    std::vector<char> isWalked(partition_.twins.size(), false);
    std::vector<int> steps;
    for (int start = 0; start < static_cast<int>(partition_.twins.size()); ++start) {
      if (isWalked[start] || !isOnOutline(start)) continue;
      steps.clear();
      for (int h = start; !isWalked[h]; h = nextOnOutline(partition_, h)) {
        isWalked[h] = true;
        steps.push_back(h);
      }
      addLoop(steps);
    }
  }

  void addLoop(std::vector<int>& steps) {
    const auto leavesNode = [&](int h) { return nodeOfVertex_[tail(h)] >= 0; };
    const auto first = std::find_if(steps.begin(), steps.end(), leavesNode);
    if (first != steps.end()) std::rotate(steps.begin(), first, steps.end());
    const int firstBorder = static_cast<int>(out_.borders.size());
    for (const int h : steps) {
      if (leavesNode(h) || h == steps.front()) startBorder(h);
      out_.borders.back().path.push_back(h);
    }
    const int end = static_cast<int>(out_.borders.size());
    for (int b = firstBorder; b < end; ++b)
      out_.borders[b].toNode = out_.borders[b + 1 < end ? b + 1 : firstBorder].fromNode;
    out_.loops.push_back(
        {partition_.triangleLabel[steps.front() / 3], firstBorder, end - firstBorder});
  }

  void startBorder(int h) {
    const int twin = partition_.twins[h];
    borderAt_[h] = static_cast<int>(out_.borders.size());
    out_.borders.push_back({partition_.triangleLabel[h / 3],
                            twin < 0 ? RegionComplex::kOutside : partition_.triangleLabel[twin / 3],
                            nodeOfVertex_[tail(h)],
                            -1,
                            {}});
  }

  void listBordersOfNodes() {
    for (int b = 0; b < static_cast<int>(out_.borders.size()); ++b) {
      const RegionComplex::Border& border = out_.borders[b];
      if (border.fromNode < 0) continue;
      if (border.beyond == RegionComplex::kOutside) {
        out_.nodes[border.toNode].arrivingRun = b;
        out_.nodes[border.fromNode].borders.assign(1, b);  // the first, wherever others start
      } else if (out_.nodes[border.fromNode].borders.empty()) {
        out_.nodes[border.fromNode].borders.assign(1, b);
      }
    }
    for (RegionComplex::Node& node : out_.nodes) {
      for (;;) {
        const int last = endOfSector(out_.borders[node.borders.back()].path.front());
        const int beyond = partition_.twins[last];
        if (beyond < 0 || borderAt_[beyond] == node.borders.front()) break;
        node.borders.push_back(borderAt_[beyond]);
      }
    }
  }

  const Partition& partition_;
  std::vector<int> nodeOfVertex_;
  std::vector<int> borderAt_;  ///< the border that starts with a halfedge, or -1
  RegionComplex out_;
};

}  // namespace

std::vector<int> RegionComplex::labelsAt(int node) const {
  std::vector<int> labels;
  for (const int b : nodes[node].borders) labels.push_back(borders[b].label);
  return labels;
}

RegionComplex buildRegionComplex(const Partition& partition) { return Builder(partition).build(); }

}  // namespace gvd
