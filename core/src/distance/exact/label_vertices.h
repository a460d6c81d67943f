// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "distance/exact/label_state.h"
#include "distance/exact/required_distances.h"
#include "gvd/geodesic.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// The vertices that the current label has reached. There is room for all vertices of the mesh, but
/// a label touches only those that it reaches, which stay in the cache.
class LabelVertices {
 public:
  /// The label's shortest path to a vertex so far; as initialized where it has found none.
  struct alignas(64) Vertex {
    double distance = kInfinity;
    LastPiece piece = {};
    int index = -1;                           ///< in the label's state
    int required = RequiredDistances::kNone;  ///< index in the required distances
    bool isFinal = false, isQueued = false;
    bool isTouched = false;  ///< since the label's state was stored
    bool isSaddle = false;   ///< of the mesh, whatever the label

    bool isRequired() const { return required != RequiredDistances::kNone; }
  };

  explicit LabelVertices(const TriangleMesh& mesh) : mesh_(mesh) {}
  /// Makes room, in slices; true when it is there.
  bool prepare(long& budget);

  /// Begins with another label, which has reached no vertex.
  void clear();
  /// Begins with the vertices of a label's state, after `clear`.
  void load(const LabelState& state);
  /// Writes distances and last pieces to the label's state, which has those from before. Those that
  /// were required are final.
  void store(LabelState& state);

  std::size_t count() const { return reached_.size(); }
  const Vertex& operator[](int v) const { return all_[v]; }
  Vertex& operator[](int v) { return all_[v]; }
  /// A vertex that counts as reached from now on, if need be at distance infinity.
  Vertex& touched(int v) {
    if (!all_[v].isTouched) touch(v);
    return all_[v];
  }
  /// Infinity unless the label has reached the vertex.
  double distance(int v) const { return all_[v].distance; }

 private:
  void add(int v);
  void touch(int v);

  const TriangleMesh& mesh_;
  std::vector<Vertex> all_;
  std::vector<int> reached_;
  std::vector<int> touched_;  ///< those to be stored
};

}  // namespace gvd::exact
