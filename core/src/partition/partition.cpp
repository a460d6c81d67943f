// SPDX-License-Identifier: MIT
// This work is based on:
// Eivind Lyche Melvær, Martin Reimers. Approximating Geodesic Voronoi Diagrams on Triangulated
// Surfaces. 2014
#include "gvd/partition.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "base/grouping.h"
#include "base/sliced_loop.h"
#include "diagram/given_diagram.h"
#include "mesh/incidence.h"
#include "mesh/slits.h"
#include "mesh/twin_matching.h"
#include "partition/face_cutting.h"
#include "partition/region_patches.h"

namespace gvd {
namespace {

/// Sorts the pieces by label, and finds vertices, twins and the facts of regions.
class Partitioner final : public SequentialWork<Partition> {
 public:
  Partitioner(const TriangleMesh& mesh, const Diagram& diagram, const PartitionOptions& options)
      : mesh_(mesh), diagram_(diagram), options_(options) {
    requireFaces(mesh, diagram);
  }

  bool advance(long budget) override {
    const int siteCount = diagram_.siteCount;
    const auto groupOf = [&](int i) { return pieces_[i].label < 0 ? siteCount : pieces_[i].label; };
    return sequence_.run(
        [&] { return cutting_.step(budget); },
        [&] {
          pieces_ = cutting_.takePieces();
          uncut_ = cutting_.takeUncut();
        },
        [&] {
          const int pieces = static_cast<int>(pieces_.size());
          return byLabel_.run(pieces, siteCount + 1, groupOf, budget);
        },
        [&] {
          out_.triangles.reserve(pieces_.size());
          out_.triangleLabel.reserve(pieces_.size());
          out_.triangleFace.reserve(pieces_.size());
          areas_.reserve(pieces_.size());
        },
        forEach(pieces_, budget, 8, [&](int t) { addTriangle(byLabel_.items()[t], t); }),
        [&] {
          byLabel_ = {};
          release(pieces_);
        },
        [&] {
          const std::size_t all = mesh_.vertexCount() + diagram_.points.size();
          return fillInSlices(number_, all, -1, budget);
        },
        forItems(out_.triangles, budget, 8,
                 [&](const Corners& triangle) {
                   for (const int v : triangle) used_ += std::exchange(number_[v], 0) < 0;
                 }),
        [&] {
          out_.points.reserve(used_);
          out_.positions.reserve(used_);
        },
        forEach(number_, budget, 8, [&](int v) { numberVertex(v); }),
        forItems(out_.triangles, budget, 8,
                 [&](Corners& triangle) {
                   for (int& v : triangle) v = number_[v];
                 }),
        [&] { return twins_.prepare(3 * out_.triangles.size(), budget); },
        forEach(out_.triangles, budget, 4, [&](int t) { matchTwins(t); }),
        [&] {
          out_.twins = twins_.take();
          twins_ = {};
        },
        [&] { return runPart(patches_, budget, mesh_, siteCount, areas_, out_); });
  }

 private:
  void addTriangle(int i, int t) {
    const FaceCutting::Piece& piece = pieces_[i];
    if (int& uncut = uncut_[piece.face]; uncut >= 0) uncut = t;
    out_.triangles.push_back(piece.vertices);
    out_.triangleLabel.push_back(piece.label);
    out_.triangleFace.push_back(piece.face);
    areas_.push_back(piece.area);
  }

  void numberVertex(int v) {
    if (number_[v] < 0) return;
    number_[v] = static_cast<int>(out_.points.size());
    if (v < mesh_.vertexCount()) {
      out_.points.push_back(pointAtVertex(mesh_, v));
      out_.positions.push_back(mesh_.position(v));
    } else {
      out_.points.push_back(diagram_.points[v - mesh_.vertexCount()]);
      out_.positions.push_back(mesh_.position(out_.points.back()));
    }
  }

  /// Between faces that are not cut, twins are those of the mesh. Other sides are matched by their
  /// ends and, if double edges have these ends, by the edge.
  void matchTwins(int t) {
    const int face = out_.triangleFace[t];
    for (int i = 0; i < 3; ++i) {
      const int h = 3 * t + i;
      if (uncut_[face] >= 0) {
        const int twin = mesh_.face(face).twins[i];
        if (twin < 0) continue;
        if (const int beyond = uncut_[TriangleMesh::faceOf(twin)]; beyond >= 0) {
          twins_.set(h, 3 * beyond + twin % 3);
          continue;
        }
      }
      twins_.add(
          h, [&](int of) { return tailOf(out_.triangles, of); },
          [&](int other) {
            if (!mayHaveDoubleEdges(mesh_) || face == out_.triangleFace[other / 3]) return true;
            const int side = meshHalfedge(h), beyond = meshHalfedge(other);
            return side < 0 || beyond < 0 || mesh_.twin(side) == beyond;
          });
    }
  }

  /// The halfedge of the mesh on which both ends of a halfedge lie, -1 if there is none.
  int meshHalfedge(int h) const {
    const int face = out_.triangleFace[h / 3];
    const auto place = [&](int vertex) { return baryInFace(mesh_, out_.points[vertex], face); };
    const Eigen::Vector3d tail = place(tailOf(out_.triangles, h)),
                          tip = place(tipOf(out_.triangles, h));
    for (int i = 0; i < 3; ++i)
      if (tail[cornerBefore(i)] == 0 && tip[cornerBefore(i)] == 0) return 3 * face + i;
    return -1;
  }

  const TriangleMesh& mesh_;
  const Diagram& diagram_;
  const PartitionOptions options_;

  FaceCutting cutting_{mesh_, diagram_, options_};
  std::vector<FaceCutting::Piece> pieces_;
  std::vector<int> uncut_;     ///< per face that is not cut, its piece, later its triangle; else -1
  Grouping byLabel_;           ///< pieces
  std::vector<double> areas_;  ///< per triangle
  std::vector<int> number_;    ///< of a vertex in the result, -1 if it is not in use
  size_t used_ = 0;
  TwinMatching twins_;
  std::optional<PatchMeasuring> patches_;
};

}  // namespace

std::unique_ptr<SlicedWork<Partition>> startPartition(const TriangleMesh& mesh,
                                                      const Diagram& diagram,
                                                      const PartitionOptions& options) {
  return std::make_unique<Partitioner>(mesh, diagram, options);
}

Partition partition(const TriangleMesh& mesh, const Diagram& diagram,
                    const PartitionOptions& options) {
  return finished(startPartition(mesh, diagram, options));
}

Eigen::Matrix3d cornersInFace(const TriangleMesh& mesh, const Partition& partition, int triangle) {
  Eigen::Matrix3d corners;
  for (int i = 0; i < 3; ++i)
    corners.col(i) = baryInFace(mesh, partition.points[partition.triangles[triangle][i]],
                                partition.triangleFace[triangle]);
  return corners;
}

}  // namespace gvd
