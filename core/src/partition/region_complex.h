// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/partition.h"
#include "mesh/corners.h"

namespace gvd {

/// The regions of a diagram as a complex, and their partition. Its faces are the regions. Its edges
/// are the *borders* between two regions, or between a region and the outside. Its vertices are the
/// points where three or more sectors of regions, or two and the outside, meet. A border has its
/// region on the left, so an arc between two regions consists of two borders; a *run*, a border
/// along the mesh boundary, is there once.
struct RegionComplex {
  static constexpr int kOutside = -1;

  struct Vertex {
    int point;  ///< of the partition
    /// The borders that leave the vertex, counterclockwise; each starts a sector of the region to
    /// its left. On the mesh boundary the first border is a run, and the sectors do not close.
    std::vector<int> borders;
    /// The run that ends at the vertex; -1 inside.
    int arrivingRun = -1;

    bool isOnBoundary() const { return arrivingRun >= 0; }
  };

  struct Border {
    int label, beyond;         ///< to the left, to the right
    int fromVertex, toVertex;  ///< -1 if the border is closed and meets no vertex
    std::vector<int> path;     ///< the halfedges of the partition along it
  };

  struct Loop {
    int label;
    int firstBorder, borderCount;
  };

  Partition partition;  ///< without components that have no site
  std::vector<Vertex> vertices;
  std::vector<Border> borders;
  std::vector<Loop> loops;  ///< ascending by label

  /// The regions around a vertex, counterclockwise.
  std::vector<int> labelsAt(int vertex) const;
};

/// Builds the complex of a diagram's regions, in slices.
class RegionComplexBuilding {
 public:
  /// Both must outlive this.
  RegionComplexBuilding(const TriangleMesh& mesh, const Diagram& diagram);
  bool step(long& budget);
  double progress() const;
  const RegionComplex& complex() const { return out_; }

 private:
  int tail(int h) const { return tailOf(out_.partition.triangles, h); }
  int endOfSector(int h) const;
  void countSector(int h);
  void findVertex(int point);
  void walkLoopFrom(int start);
  void startBorder(int h);
  void listBorder(int b);
  void turnAround(int vertex);

  SlicedSequence sequence_;
  std::unique_ptr<SlicedWork<Partition>> partitioning_;
  /// First the number of sectors, of regions and the outside, around a point, then its vertex or
  /// -1.
  std::vector<int> vertexOfPoint_;
  std::vector<int> borderOf_;  ///< of each halfedge on an outline, -1 before it is walked
  std::vector<int> steps_;     ///< of the current loop
  RegionComplex out_;
};

/// Work on the regions of a diagram: first finds them, then steps through the part that
/// `make(complex)` returns, whose result it takes.
template <class Make>
auto fromRegions(const TriangleMesh& mesh, const Diagram& diagram, Make make) {
  using Part = decltype(make(std::declval<const RegionComplex&>()));
  using Result = decltype(std::declval<Part>().take());
  class FromRegions final : public SlicedWork<Result> {
   public:
    FromRegions(const TriangleMesh& mesh, const Diagram& diagram, Make make)
        : regions_(mesh, diagram), make_(std::move(make)) {}

    bool advance(long budget) override {
      return sequence_.run([&] { return regions_.step(budget); },
                           [&] { part_.emplace(make_(regions_.complex())); },
                           [&] { return part_->step(budget); });
    }
    double share() const override { return regions_.progress(); }
    Result result() override { return part_->take(); }

   private:
    SlicedSequence sequence_;
    RegionComplexBuilding regions_;
    Make make_;
    std::optional<Part> part_;
  };
  return std::unique_ptr<SlicedWork<Result>>(new FromRegions(mesh, diagram, std::move(make)));
}

}  // namespace gvd
