// SPDX-License-Identifier: MIT
// This work is based on:
// Eivind Lyche Melvær, Martin Reimers. Approximating Geodesic Voronoi Diagrams on Triangulated
// Surfaces. 2014
#include "gvd/partition.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

#include "base/sorting.h"
#include "mesh/convex_triangulation.h"
#include "mesh/surface_geometry.h"
#include "partition/region_patches.h"

namespace gvd {
namespace {

/// While triangles are made, vertices have the mesh's numbers, and points of the diagram theirs,
/// above.
class Partitioner {
 public:
  Partitioner(const TriangleMesh& mesh, const Diagram& diagram, const PartitionOptions& options)
      : mesh_(mesh), diagram_(diagram), options_(options) {}

  Partition compute() {
    nameVertices();
    collectPointsOnWholeSides();
    cutFaces();
    groupByLabel();
    numberVertices();
    findTwins();
    measurePatches(mesh_, diagram_.siteCount, areas_, out_);
    return std::move(out_);
  }

 private:
  /// A triangle as it was made.
  struct Piece {
    std::array<int, 3> vertices;
    int label, face;
    double area;
  };
  /// A point on the side of a whole face, put there by the neighbour.
  struct SidePoint {
    int halfedge;
    int order;  ///< ascending along the halfedge
    int vertex;
  };

  // --- Triangles -------------------------------------------------------------------------------

  void nameVertices() {
    vertexOfPoint_.resize(diagram_.points.size());
    for (size_t i = 0; i < vertexOfPoint_.size(); ++i) {
      const SurfacePoint& p = diagram_.points[i];
      Eigen::Index corner;
      vertexOfPoint_[i] = p.bary.maxCoeff(&corner) == 1
                              ? mesh_.tail(3 * p.face + static_cast<int>(corner))
                              : mesh_.vertexCount() + static_cast<int>(i);
    }
  }

  bool isWhole(int face) const { return diagram_.faceLabel[face] != Diagram::kMixed; }

  /// A diagram of more detail has points on the sides of mixed faces that a region triangle beyond
  /// does not name.
  void collectPointsOnWholeSides() {
    const int cells = diagram_.cells.size();
    for (int first = 0, last = 0; first < cells; first = last) {
      const int face = diagram_.cellFace[first];
      while (last < cells && diagram_.cellFace[last] == face) ++last;
      bool isGathered = false;
      for (int h = 3 * face; h < 3 * (face + 1); ++h) {
        if (mesh_.twin(h) < 0 || !isWhole(TriangleMesh::faceOf(mesh_.twin(h)))) continue;
        if (!isGathered) gatherSides(first, last);
        isGathered = true;
        followSide(h);
      }
    }
    sortStably(std::span(sidePoints_), [](const SidePoint& a, const SidePoint& b) {
      return std::tie(a.halfedge, a.order) < std::tie(b.halfedge, b.order);
    });
  }

  void gatherSides(int firstCell, int lastCell) {
    sides_.clear();
    for (int c = firstCell; c < lastCell; ++c) {
      const auto cell = diagram_.cells[c];
      for (size_t i = 0; i < cell.size(); ++i)
        sides_.emplace_back(vertexOfPoint_[cell[i]], vertexOfPoint_[cell[(i + 1) % cell.size()]]);
    }
  }

  /// Follows a mixed face's halfedge from its tail to its tip, by the sides of cells that have no
  /// other cell of the face beyond. Which points are on the way is told by the cells that name
  /// them, not by coordinates: rounding may have put a point of the inside on the side.
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

  void cutFaces() {
    std::vector<char> isLeftOut(mesh_.faceCount(), false);
    if (options_.leaveOutIndifferent)
      for (const int f : diagram_.indifferentFaces) isLeftOut[f] = true;
    pieces_.reserve(mesh_.faceCount() + diagram_.cells.points.size());
    plainPiece_.assign(mesh_.faceCount(), -1);
    auto sidePoint = sidePoints_.cbegin();
    int cell = 0;
    for (int f = 0; f < mesh_.faceCount(); ++f) {
      const size_t firstPiece = pieces_.size();
      if (!isWhole(f)) {
        for (; cell < diagram_.cells.size() && diagram_.cellFace[cell] == f; ++cell) addCell(cell);
        measurePieces(firstPiece);
        continue;
      }
      const int label = diagram_.faceLabel[f];
      const auto first = sidePoint;
      while (sidePoint != sidePoints_.cend() && sidePoint->halfedge < 3 * (f + 1)) ++sidePoint;
      if (isLeftOut[f] || (label < 0 && options_.leaveOutUnreachable)) continue;
      if (first == sidePoint) {
        plainPiece_[f] = static_cast<int>(pieces_.size());
        pieces_.push_back({{mesh_.tail(3 * f), mesh_.tail(3 * f + 1), mesh_.tail(3 * f + 2)},
                           label,
                           f,
                           mesh_.faceArea(f)});
      } else {
        addFaceWithSidePoints(f, first, sidePoint);
        measurePieces(firstPiece);
      }
    }
  }

  /// The areas of all pieces of one face, which sum to its own. Rounding may have turned a sliver
  /// over, or moved a point off a side; what that makes too much or too little is the largest
  /// one's.
  void measurePieces(size_t first) {
    if (first == pieces_.size()) return;
    const double faceArea = mesh_.faceArea(pieces_[first].face);
    size_t largest = first;
    double rest = faceArea;
    for (size_t i = first; i < pieces_.size(); ++i) {
      Piece& piece = pieces_[i];
      const auto& [a, b, c] = piece.vertices;
      const Eigen::Vector3d origin = baryOf(a, piece.face);
      const Eigen::Vector3d p = baryOf(b, piece.face) - origin, q = baryOf(c, piece.face) - origin;
      piece.area = std::max(0.0, p[0] * q[1] - p[1] * q[0]) * faceArea;
      rest -= piece.area;
      if (piece.area > pieces_[largest].area) largest = i;
    }
    pieces_[largest].area = std::max(0.0, pieces_[largest].area + rest);
  }

  void addFaceWithSidePoints(int face, std::vector<SidePoint>::const_iterator point,
                             std::vector<SidePoint>::const_iterator last) {
    polygon_.clear();
    for (int h = 3 * face; h < 3 * (face + 1); ++h) {
      polygon_.push_back(mesh_.tail(h));
      for (; point != last && point->halfedge == h; ++point) polygon_.push_back(point->vertex);
    }
    triangulate(polygon_, diagram_.faceLabel[face], face);
  }

  /// A cell that comes to one point twice, its width no more than rounding there, falls apart into
  /// the polygons in between.
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
    for (const int vertex : polygon) corners_.push_back(layOut(vertex, face));
    for (const auto& [a, b, c] : triangulation_.compute(corners_))
      pieces_.push_back({{polygon[a], polygon[b], polygon[c]}, label, face, 0});
  }

  /// A vertex in the plane of a face.
  Eigen::Vector2d layOut(int vertex, int face) const {
    const TriangleMesh::Layout& layout = mesh_.layout(3 * face);
    const Eigen::Vector3d bary = baryOf(vertex, face);
    return {bary[1] * layout.length + bary[2] * layout.x, bary[2] * layout.y};
  }

  Eigen::Vector3d baryOf(int vertex, int face) const {
    if (vertex >= mesh_.vertexCount())
      return baryInFace(mesh_, diagram_.points[vertex - mesh_.vertexCount()], face);
    Eigen::Vector3d bary;
    for (int i = 0; i < 3; ++i) bary[i] = mesh_.tail(3 * face + i) == vertex;
    return bary;
  }

  // --- The mesh of all -------------------------------------------------------------------------

  int partOf(int label) const { return label < 0 ? diagram_.siteCount : label; }

  /// Puts the pieces in the order of the result, by counting.
  void groupByLabel() {
    std::vector<int> next(diagram_.siteCount + 2, 0);
    for (const Piece& piece : pieces_) ++next[partOf(piece.label) + 1];
    for (size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
    const size_t n = pieces_.size();
    out_.triangles.resize(n);
    out_.triangleLabel.resize(n);
    out_.triangleFace.resize(n);
    triangleOfPiece_.resize(n);
    isWholeFace_.resize(n);
    areas_.resize(n);
    for (size_t i = 0; i < n; ++i) {
      const Piece& piece = pieces_[i];
      const int t = next[partOf(piece.label)]++;
      triangleOfPiece_[i] = t;
      out_.triangles[t] = piece.vertices;
      out_.triangleLabel[t] = piece.label;
      out_.triangleFace[t] = piece.face;
      isWholeFace_[t] = static_cast<char>(plainPiece_[piece.face] >= 0);
      areas_[t] = piece.area;
    }
  }

  void numberVertices() {
    const int meshVertices = mesh_.vertexCount();
    std::vector<int> number(meshVertices + diagram_.points.size(), -1);
    for (const auto& triangle : out_.triangles)
      for (const int v : triangle) number[v] = 0;
    const size_t used = number.size() - std::count(number.begin(), number.end(), -1);
    out_.points.reserve(used);
    out_.positions.reserve(used);
    for (int v = 0; v < static_cast<int>(number.size()); ++v) {
      if (number[v] < 0) continue;
      number[v] = static_cast<int>(out_.points.size());
      if (v < meshVertices) {
        const int h = mesh_.outgoing(v);
        out_.points.push_back({TriangleMesh::faceOf(h), Eigen::Vector3d::Unit(h % 3)});
        out_.positions.push_back(mesh_.position(v));
      } else {
        out_.points.push_back(diagram_.points[v - meshVertices]);
        out_.positions.push_back(mesh_.position(out_.points.back()));
      }
    }
    for (auto& triangle : out_.triangles)
      for (int& v : triangle) v = number[v];
  }

  /// Between whole faces, the mesh's; the others are matched by their ends.
  void findTwins() {
    out_.twins.assign(3 * out_.triangles.size(), -1);
    firstOpen_.assign(out_.points.size(), -1);
    nextOpen_.resize(out_.twins.size());
    for (int t = 0; t < static_cast<int>(out_.triangles.size()); ++t) {
      const int face = out_.triangleFace[t];
      for (int i = 0; i < 3; ++i) {
        if (isWholeFace_[t]) {
          const int beyond = mesh_.twin(3 * face + i);
          if (beyond < 0) continue;
          const int piece = plainPiece_[TriangleMesh::faceOf(beyond)];
          if (piece >= 0) {
            out_.twins[3 * t + i] = 3 * triangleOfPiece_[piece] + beyond % 3;
            continue;
          }
        }
        findTwin(3 * t + i);
      }
    }
  }

  /// Joins a halfedge with one that waits for it at the lower of their ends, or lets it wait.
  void findTwin(int h) {
    const int tail = out_.triangles[h / 3][h % 3], tip = out_.triangles[h / 3][(h + 1) % 3];
    int* link = &firstOpen_[std::min(tail, tip)];
    for (int* open = link; *open >= 0; open = &nextOpen_[*open]) {
      const int other = *open;
      if (out_.triangles[other / 3][other % 3] != tip ||
          out_.triangles[other / 3][(other + 1) % 3] != tail)
        continue;
      // Where the mesh was cut, sides of different faces may have the same ends and nothing to do
      // with each other.
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
      for (const int corner : {h % 3, (h + 1) % 3}) {
        const SurfacePoint& p = out_.points[out_.triangles[h / 3][corner]];
        isOnSide &= baryInFace(mesh_, p, face)[(i + 2) % 3] == 0;
      }
      if (isOnSide) return true;
    }
    return false;
  }

  const TriangleMesh& mesh_;
  const Diagram& diagram_;
  const PartitionOptions options_;
  Partition out_;

  std::vector<int> vertexOfPoint_;
  std::vector<SidePoint> sidePoints_;       ///< ascending by halfedge and order
  std::vector<std::pair<int, int>> sides_;  ///< of the cells of the face at hand
  std::vector<Piece> pieces_;
  std::vector<int> plainPiece_;  ///< per face, the piece that is all of it, or -1
  std::vector<int> triangleOfPiece_;
  std::vector<char> isWholeFace_;  ///< per triangle
  std::vector<double> areas_;      ///< per triangle
  /// Lists of the halfedges without a twin so far, by the lower of their ends.
  std::vector<int> firstOpen_, nextOpen_;
  std::vector<int> polygon_;
  std::vector<Eigen::Vector2d> corners_;
  ConvexTriangulation triangulation_;
};

}  // namespace

Partition partition(const TriangleMesh& mesh, const Diagram& diagram,
                    const PartitionOptions& options) {
  return Partitioner(mesh, diagram, options).compute();
}

Eigen::Matrix3d cornersInFace(const TriangleMesh& mesh, const Partition& partition, int triangle) {
  Eigen::Matrix3d corners;
  for (int i = 0; i < 3; ++i)
    corners.col(i) = baryInFace(mesh, partition.points[partition.triangles[triangle][i]],
                                partition.triangleFace[triangle]);
  return corners;
}

}  // namespace gvd
