// SPDX-License-Identifier: MIT
//
// The topology of a mesh, found from the corners of its polygons alone.
#pragma once

#include <map>
#include <numeric>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace gvd::checks {

/// Collects polygons, then tells the topology of the surface they form.
class PolygonSurface {
 public:
  void add(std::span<const int> polygon) {
    ++faces_;
    for (size_t i = 0; i < polygon.size(); ++i) {
      const int from = polygon[i], to = polygon[(i + 1) % polygon.size()];
      isOriented_ &= from != to && sides_.emplace(std::pair(from, to), faces_ - 1).second;
      corners_[from].push_back({polygon[(i + polygon.size() - 1) % polygon.size()], to});
    }
  }

  /// Whether no two polygons use a side in the same direction, and the polygons around every vertex
  /// form one fan.
  bool isManifold() const {
    if (!isOriented_) return false;
    for (const auto& [vertex, fan] : corners_) {
      std::map<int, int> turn;  // from the next neighbour to the one before: counterclockwise
      for (const auto& [before, after] : fan) turn[after] = before;
      if (turn.size() != fan.size()) return false;
      int start = turn.begin()->first;
      for (const auto& [after, before] : turn) {
        bool isTurnedTo = false;
        for (const auto& [other, to] : turn) isTurnedTo |= to == after;
        if (!isTurnedTo) start = after;  // where an open fan begins
      }
      size_t met = 0;
      for (int at = start; turn.contains(at) && met < fan.size(); at = turn[at]) ++met;
      if (met != fan.size()) return false;
    }
    return true;
  }

  int eulerCharacteristic() const {
    int edges = 0;
    for (const auto& [ends, face] : sides_)
      edges += ends.first < ends.second || !sides_.contains({ends.second, ends.first});
    return static_cast<int>(corners_.size()) - edges + faces_;
  }

  /// Holds for manifolds: every boundary vertex is left by one side without a neighbour.
  int boundaryLoops() const {
    std::map<int, int> next;
    for (const auto& [ends, face] : sides_)
      if (!sides_.contains({ends.second, ends.first})) next[ends.first] = ends.second;
    int loops = 0;
    while (!next.empty()) {
      ++loops;
      for (auto at = next.begin(); at != next.end();) {
        const int to = at->second;
        next.erase(at);
        at = next.find(to);
      }
    }
    return loops;
  }

  int components() const {
    std::vector<int> parent(faces_);
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int f) {
      while (parent[f] != f) f = parent[f];
      return f;
    };
    for (const auto& [ends, face] : sides_) {
      const auto other = sides_.find({ends.second, ends.first});
      if (other != sides_.end()) parent[root(face)] = root(other->second);
    }
    int count = 0;
    for (int f = 0; f < faces_; ++f) count += parent[f] == f;
    return count;
  }

  int genus() const { return (2 * components() - boundaryLoops() - eulerCharacteristic()) / 2; }

 private:
  std::map<std::pair<int, int>, int> sides_;                 // → face
  std::map<int, std::vector<std::pair<int, int>>> corners_;  // → neighbours before and after
  int faces_ = 0;
  bool isOriented_ = true;
};

}  // namespace gvd::checks
