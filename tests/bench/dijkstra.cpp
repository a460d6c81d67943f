// SPDX-License-Identifier: MIT
#include "dijkstra.h"

#include "quaternary_heap.h"

namespace gvd::bench {
namespace {

struct Item {
  double distance;
  int vertex;
  bool operator<(const Item& other) const { return distance < other.distance; }
};

class Sweep {
 public:
  explicit Sweep(const TriangleMesh& mesh) : mesh_(mesh), nearest_(mesh.vertexCount()) {}

  void start(int label, const SurfacePoint& site) {
    const Eigen::Vector3d position = mesh_.position(site);
    for (int h = 3 * site.face; h < 3 * site.face + 3; ++h)
      offer(mesh_.tail(h), label, (mesh_.position(mesh_.tail(h)) - position).norm());
  }

  std::vector<LabelledDistance> run() {
    while (!queue_.empty()) {
      const Item item = queue_.top();
      queue_.pop();
      // Outdated items stay in the queue until they are met: cheaper than to find and move them.
      if (item.distance == nearest_[item.vertex].distance) spread(item.vertex);
    }
    return std::move(nearest_);
  }

 private:
  void offer(int vertex, int label, double distance) {
    if (!(distance < nearest_[vertex].distance)) return;
    nearest_[vertex] = {label, distance};
    queue_.push({distance, vertex});
  }

  void spread(int vertex) {
    const LabelledDistance from = nearest_[vertex];
    mesh_.visitEdges(vertex, [&](int neighbour, double length) {
      offer(neighbour, from.label, from.distance + length);
    });
  }

  const TriangleMesh& mesh_;
  std::vector<LabelledDistance> nearest_;
  QuaternaryHeap<Item> queue_;
};

}  // namespace

std::vector<LabelledDistance> dijkstra(const TriangleMesh& mesh,
                                       std::span<const SurfacePoint> sites) {
  Sweep sweep(mesh);
  for (int label = 0; label < static_cast<int>(sites.size()); ++label)
    sweep.start(label, sites[label]);
  return sweep.run();
}

}  // namespace gvd::bench
