// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "exact/exact_window.h"
#include "gvd/geodesic.h"

namespace gvd::exact {

/// What one label knows at one vertex.
struct Entry {
  double distance;
  /// Where the path to the vertex enters its last face: a halfedge (the vertex is its apex) and the
  /// place on it. -1 for a site at the vertex.
  double crossing;
  int arrival;
  int label;
  int vertex;
  int origin;
  int demand;  ///< index of the demand for this distance, -1 if nothing depends on it
};

/// The distances of labels at vertices.
class VertexTable {
 public:
  explicit VertexTable(int vertexCount)
      : best_(vertexCount, {kInfinity, -1, -1}), slots_(4096, -1) {
    entries_.reserve(vertexCount + vertexCount / 4);
  }

  struct Best {
    double distance;
    int label;
    int entry;
  };
  const Best& best(int vertex) const { return best_[vertex]; }
  Entry& operator[](int entry) { return entries_[entry]; }
  const Entry& operator[](int entry) const { return entries_[entry]; }
  int size() const { return static_cast<int>(entries_.size()); }
  int vertexCount() const { return static_cast<int>(best_.size()); }

  int find(int vertex, int label) const {
    const Best& best = best_[vertex];
    if (best.label == label) return best.entry;
    if (best.label < 0) return -1;
    for (std::uint32_t s = hash(vertex, label);; ++s) {
      const int e = slots_[s & mask()];
      if (e < 0 || (entries_[e].vertex == vertex && entries_[e].label == label)) return e;
    }
  }
  double distance(int vertex, int label) const {
    const Best& best = best_[vertex];
    if (best.label == label) return best.distance;
    const int e = find(vertex, label);
    return e < 0 ? kInfinity : entries_[e].distance;
  }
  int findOrAdd(int vertex, int label) {
    const int found = find(vertex, label);
    if (found >= 0) return found;
    const int e = size();
    entries_.push_back({kInfinity, 0, -1, label, vertex, kFromSite, -1});
    if (2 * entries_.size() > slots_.size()) {
      slots_.assign(2 * slots_.size(), -1);
      for (int i = 0; i < e; ++i) place(i);
    }
    place(e);
    return e;
  }
  /// The entry gets a new distance, known to be less.
  void improve(int entry, double distance, int arrival, double crossing, int origin) {
    Entry& e = entries_[entry];
    e.distance = distance;
    e.arrival = arrival;
    e.crossing = crossing;
    e.origin = origin;
    Best& best = best_[e.vertex];
    if (best.label == e.label || distance < best.distance) best = {distance, e.label, entry};
  }

 private:
  std::uint32_t mask() const { return static_cast<std::uint32_t>(slots_.size()) - 1; }
  static std::uint32_t hash(int vertex, int label) {
    const std::uint64_t key =
        static_cast<std::uint64_t>(vertex) << 32 | static_cast<unsigned>(label);
    return static_cast<std::uint32_t>(key * 0x9E3779B97F4A7C15u >> 32);
  }
  void place(int entry) {
    std::uint32_t s = hash(entries_[entry].vertex, entries_[entry].label);
    while (slots_[s & mask()] >= 0) ++s;
    slots_[s & mask()] = entry;
  }

  std::vector<Best> best_;
  std::vector<Entry> entries_;
  std::vector<int> slots_;  ///< hash table of entries by vertex and label
};

}  // namespace gvd::exact
