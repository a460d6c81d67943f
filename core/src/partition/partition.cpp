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
#include <tuple>
#include <utility>

#include "base/grouping.h"
#include "base/sliced_loop.h"
#include "base/sorting.h"
#include "diagram/given_diagram.h"
#include "mesh/corners.h"
#include "mesh/face_layout.h"
#include "mesh/representations.h"
#include "mesh/surface_geometry.h"
#include "partition/convex_triangulation.h"
#include "partition/region_patches.h"

namespace gvd {
namespace {

/// While triangles are made, a vertex of the mesh keeps its number, and point i of the diagram has
/// the number `vertexCount() + i` unless it is at a vertex.
class Partitioner final : public SlicedWork<Partition> {
 public:
  Partitioner(const TriangleMesh& mesh, const Diagram& diagram, const PartitionOptions& options)
      : mesh_(mesh), diagram_(diagram), options_(options) {
    requireFaces(mesh, diagram);
  }

  bool advance(long budget) override {
    return sequence_.run(
        [&] { return nameVertices(budget); }, [&] { return collectSidePoints(budget); },
        [&] { return cutFaces(budget); }, [&] { return groupByLabel(budget); },
        [&] { return numberVertices(budget); }, [&] { return findTwins(budget); },
        [&] { return runPart(patches_, budget, mesh_, diagram_.siteCount, areas_, out_); });
  }
  double progress() const override { return sequence_.progress(); }
  Partition result() override { return std::move(out_); }

 private:
  /// A triangle of the partition, before triangles are sorted by label.
  struct Piece {
    std::array<int, 3> vertices;
    int label, face;
    double area;
  };
  /// A point on the side of a face that is not mixed, added by the mixed face beyond.
  struct SidePoint {
    int halfedge;
    int order;  ///< ascending along the halfedge
    int vertex;
  };

  // --- Triangles -------------------------------------------------------------------------------

  bool nameVertices(long& budget) {
    vertexOfPoint_.resize(diagram_.points.size());
    return loop_.run(vertexOfPoint_.size(), budget, 8, [&](int i) {
      const SurfacePoint& p = diagram_.points[i];
      Eigen::Index corner;
      vertexOfPoint_[i] = p.bary.maxCoeff(&corner) == 1
                              ? mesh_.tail(3 * p.face + static_cast<int>(corner))
                              : mesh_.vertexCount() + i;
    });
  }

  bool isMixed(int face) const { return diagram_.faceLabel[face] == Diagram::kMixed; }

  /// With detail, a diagram has points on the sides of mixed faces that the region triangle beyond
  /// does not list.
  bool collectSidePoints(long& budget) {
    const bool isDone = loop_.run(diagram_.cells.size(), budget, 2, [&](int first) {
      const int face = diagram_.cellFace[first];
      if (first > 0 && diagram_.cellFace[first - 1] == face) return;
      bool isGathered = false;
      for (int h = 3 * face; h < 3 * (face + 1); ++h) {
        if (mesh_.twin(h) < 0 || isMixed(TriangleMesh::faceOf(mesh_.twin(h)))) continue;
        if (!isGathered) gatherSides(first);
        isGathered = true;
        followSide(h);
      }
    });
    if (isDone)
      sortStably(std::span(sidePoints_), [](const SidePoint& a, const SidePoint& b) {
        return std::tie(a.halfedge, a.order) < std::tie(b.halfedge, b.order);
      });
    return isDone;
  }

  void gatherSides(int firstCell) {
    sides_.clear();
    const int face = diagram_.cellFace[firstCell];
    for (int c = firstCell; c < diagram_.cells.size() && diagram_.cellFace[c] == face; ++c) {
      const auto cell = diagram_.cells[c];
      for (size_t i = 0; i < cell.size(); ++i)
        sides_.emplace_back(vertexOfPoint_[cell[i]], vertexOfPoint_[cell[(i + 1) % cell.size()]]);
    }
  }

  /// Follows a mixed face's halfedge from its tail to its tip, along the sides of cells that have
  /// no other cell of the face beyond. The points on the way are found by the cells that list them,
  /// not by coordinates, because rounding may have put an inner point on the side.
  void followSide(int h) {
    const auto has = [&](int from, int to) {
      return std::find(sides_.begin(), sides_.end(), std::pair(from, to)) != sides_.end();
    };
    const int tip = mesh_.tip(h);
    if (has(mesh_.tail(h), tip)) return;
    int at = mesh_.tail(h);
    for (int steps = 0; at != tip && steps < static_cast<int>(sides_.size()); ++steps) {
      const auto next = std::find_if(sides_.begin(), sides_.end(), [&](const auto& side) {
        return side.first == at && !has(side.second, at);
      });
      if (next == sides_.end()) return;
      at = next->second;
      if (at != tip) sidePoints_.push_back({mesh_.twin(h), -steps, at});
    }
  }

  bool cutFaces(long& budget) {
    const int faces = mesh_.faceCount();
    return cutting_.run([&] { return fillInSlices(isLeftOut_, faces, '\0', budget); },
                        [&] {
                          if (options_.leaveOutIndifferent)
                            for (const int f : diagram_.indifferentFaces) isLeftOut_[f] = true;
                          pieces_.reserve(faces + diagram_.cells.points.size());
                        },
                        [&] { return fillInSlices(uncutPiece_, faces, -1, budget); },
                        [&] { return loop_.run(faces, budget, 4, [&](int f) { cutFace(f); }); });
  }

  void cutFace(int f) {
    const size_t firstPiece = pieces_.size();
    if (isMixed(f)) {
      for (; nextCell_ < diagram_.cells.size() && diagram_.cellFace[nextCell_] == f; ++nextCell_)
        addCell(nextCell_);
      measurePieces(firstPiece);
      return;
    }
    const int label = diagram_.faceLabel[f];
    const size_t first = nextSidePoint_;
    while (nextSidePoint_ < sidePoints_.size() &&
           sidePoints_[nextSidePoint_].halfedge < 3 * (f + 1))
      ++nextSidePoint_;
    if (isLeftOut_[f] || (label < 0 && options_.leaveOutUnreachable)) return;
    if (first == nextSidePoint_) {
      uncutPiece_[f] = static_cast<int>(pieces_.size());
      pieces_.push_back({{mesh_.tail(3 * f), mesh_.tail(3 * f + 1), mesh_.tail(3 * f + 2)},
                         label,
                         f,
                         mesh_.faceArea(f)});
    } else {
      addFaceWithSidePoints(f, std::span(sidePoints_).subspan(first, nextSidePoint_ - first));
      measurePieces(firstPiece);
    }
  }

  /// Measures the pieces of one face, whose areas sum to that of the face. Rounding may have turned
  /// a sliver over, or moved a point off a side; the largest piece absorbs the difference.
  void measurePieces(size_t first) {
    if (first == pieces_.size()) return;
    const double faceArea = mesh_.faceArea(pieces_[first].face);
    size_t largest = first;
    double rest = faceArea;
    for (size_t i = first; i < pieces_.size(); ++i) {
      Piece& piece = pieces_[i];
      const auto& [a, b, c] = piece.vertices;
      piece.area = faceArea * std::max(0.0, areaShare(baryOf(a, piece.face), baryOf(b, piece.face),
                                                      baryOf(c, piece.face)));
      rest -= piece.area;
      if (piece.area > pieces_[largest].area) largest = i;
    }
    pieces_[largest].area = std::max(0.0, pieces_[largest].area + rest);
  }

  void addFaceWithSidePoints(int face, std::span<const SidePoint> points) {
    polygon_.clear();
    auto point = points.begin();
    for (int h = 3 * face; h < 3 * (face + 1); ++h) {
      polygon_.push_back(mesh_.tail(h));
      for (; point != points.end() && point->halfedge == h; ++point)
        polygon_.push_back(point->vertex);
    }
    triangulate(polygon_, diagram_.faceLabel[face], face);
  }

  /// Triangulates a cell. A cell that passes a point twice, because its width there is below
  /// rounding, is split into the polygons in between.
  void addCell(int cell) {
    const int label = diagram_.cellLabel[cell], face = diagram_.cellFace[cell];
    polygon_.clear();
    for (const int point : diagram_.cells[cell]) {
      const int vertex = vertexOfPoint_[point];
      const auto before = std::find(polygon_.begin(), polygon_.end(), vertex);
      if (before != polygon_.end()) {
        triangulate({&*before, static_cast<size_t>(polygon_.end() - before)}, label, face);
        polygon_.erase(before, polygon_.end());
      }
      polygon_.push_back(vertex);
    }
    triangulate(polygon_, label, face);
  }

  void triangulate(std::span<const int> polygon, int label, int face) {
    if (polygon.size() < 3) return;
    if (polygon.size() == 3) {
      pieces_.push_back({{polygon[0], polygon[1], polygon[2]}, label, face, 0});
      return;
    }
    corners_.clear();
    for (const int vertex : polygon)
      corners_.push_back(layOut(mesh_.face(face), 0, baryOf(vertex, face)));
    for (const auto& [a, b, c] : triangulation_.compute(corners_))
      pieces_.push_back({{polygon[a], polygon[b], polygon[c]}, label, face, 0});
  }

  Eigen::Vector3d baryOf(int vertex, int face) const {
    if (vertex >= mesh_.vertexCount())
      return baryInFace(mesh_, diagram_.points[vertex - mesh_.vertexCount()], face);
    Eigen::Vector3d bary;
    for (int i = 0; i < 3; ++i) bary[i] = mesh_.tail(3 * face + i) == vertex;
    return bary;
  }

  // --- All triangles ---------------------------------------------------------------------------

  bool groupByLabel(long& budget) {
    const int n = static_cast<int>(pieces_.size());
    const auto partOf = [&](int i) {
      return pieces_[i].label < 0 ? diagram_.siteCount : pieces_[i].label;
    };
    return grouping_.run([&] { return byLabel_.run(n, diagram_.siteCount + 1, partOf, budget); },
                         [&] { return fillInSlices(triangleOfPiece_, n, 0, budget); },
                         [&] {
                           out_.triangles.reserve(n);
                           out_.triangleLabel.reserve(n);
                           out_.triangleFace.reserve(n);
                           areas_.reserve(n);
                         },
                         [&] {
                           return loop_.run(n, budget, 8,
                                            [&](int t) { addTriangle(byLabel_.items()[t], t); });
                         },
                         [&] { byLabel_ = {}; });
  }

  void addTriangle(int i, int t) {
    const Piece& piece = pieces_[i];
    triangleOfPiece_[i] = t;
    out_.triangles.push_back(piece.vertices);
    out_.triangleLabel.push_back(piece.label);
    out_.triangleFace.push_back(piece.face);
    areas_.push_back(piece.area);
  }

  bool numberVertices(long& budget) {
    const size_t n = out_.triangles.size(), all = mesh_.vertexCount() + diagram_.points.size();
    return numbering_.run(
        [&] {
          release(pieces_);
          return fillInSlices(number_, all, -1, budget);
        },
        [&] {
          return loop_.run(n, budget, 8, [&](int t) {
            for (const int v : out_.triangles[t]) used_ += std::exchange(number_[v], 0) < 0;
          });
        },
        [&] {
          out_.points.reserve(used_);
          out_.positions.reserve(used_);
          return loop_.run(all, budget, 8, [&](int v) { numberVertex(v); });
        },
        [&] {
          return loop_.run(n, budget, 8, [&](int t) {
            for (int& v : out_.triangles[t]) v = number_[v];
          });
        });
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

  bool findTwins(long& budget) {
    const size_t n = out_.triangles.size();
    return matching_.run([&] { return fillInSlices(out_.twins, 3 * n, -1, budget); },
                         [&] { return fillInSlices(firstOpen_, out_.points.size(), -1, budget); },
                         [&] { return fillInSlices(nextOpen_, 3 * n, -1, budget); },
                         [&] { return loop_.run(n, budget, 4, [&](int t) { findTwinsOf(t); }); });
  }

  /// Between faces that are not cut, takes the twins of the mesh; matches other sides by their
  /// ends.
  void findTwinsOf(int t) {
    const int face = out_.triangleFace[t];
    for (int i = 0; i < 3; ++i) {
      if (uncutPiece_[face] >= 0) {
        const int beyond = mesh_.twin(3 * face + i);
        if (beyond < 0) continue;
        const int piece = uncutPiece_[TriangleMesh::faceOf(beyond)];
        if (piece >= 0) {
          out_.twins[3 * t + i] = 3 * triangleOfPiece_[piece] + beyond % 3;
          continue;
        }
      }
      findTwin(3 * t + i);
    }
  }

  /// Pairs a halfedge with an open one at the lower of their ends, or adds it to the open ones.
  void findTwin(int h) {
    const int tail = tailOf(out_.triangles, h), tip = tipOf(out_.triangles, h);
    int* link = &firstOpen_[std::min(tail, tip)];
    for (int* open = link; *open >= 0; open = &nextOpen_[*open]) {
      const int other = *open;
      if (tailOf(out_.triangles, other) != tip || tipOf(out_.triangles, other) != tail) continue;
      // Where the mesh was cut, sides of different faces may have the same ends without being
      // neighbours.
      if (out_.triangleFace[h / 3] != out_.triangleFace[other / 3] && isOnMeshBoundary(h) &&
          isOnMeshBoundary(other))
        continue;
      out_.twins[h] = other;
      out_.twins[other] = h;
      *open = nextOpen_[other];
      return;
    }
    nextOpen_[h] = *link;
    *link = h;
  }

  bool isOnMeshBoundary(int h) const {
    const int face = out_.triangleFace[h / 3];
    for (int i = 0; i < 3; ++i) {
      if (mesh_.twin(3 * face + i) >= 0) continue;
      bool isOnSide = true;
      for (const int end : {tailOf(out_.triangles, h), tipOf(out_.triangles, h)})
        isOnSide &= baryInFace(mesh_, out_.points[end], face)[cornerBefore(i)] == 0;
      if (isOnSide) return true;
    }
    return false;
  }

  const TriangleMesh& mesh_;
  const Diagram& diagram_;
  const PartitionOptions options_;
  Partition out_;

  SlicedSequence sequence_, cutting_, grouping_, numbering_, matching_;
  SlicedLoop loop_;
  std::vector<int> vertexOfPoint_;
  std::vector<SidePoint> sidePoints_;       ///< ascending by halfedge and order
  std::vector<std::pair<int, int>> sides_;  ///< of the cells of the current face
  std::vector<Piece> pieces_;
  std::vector<char> isLeftOut_;  ///< faces
  int nextCell_ = 0;
  size_t nextSidePoint_ = 0;
  std::vector<int> uncutPiece_;  ///< per face that is not cut, its piece; else -1
  std::vector<int> triangleOfPiece_;
  std::vector<double> areas_;  ///< per triangle
  Grouping byLabel_;           ///< pieces
  std::vector<int> number_;    ///< of a vertex in the result, -1 if it is not in use
  size_t used_ = 0;
  /// Lists of the halfedges without a twin so far, by the lower of their ends.
  std::vector<int> firstOpen_, nextOpen_;
  std::vector<int> polygon_;
  std::vector<Eigen::Vector2d> corners_;
  ConvexTriangulation triangulation_;
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
