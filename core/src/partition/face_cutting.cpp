// SPDX-License-Identifier: MIT
#include "partition/face_cutting.h"

#include <algorithm>

#include "mesh/face_layout.h"
#include "mesh/face_metric.h"
#include "mesh/incidence.h"

namespace gvd {

bool FaceCutting::step(long& budget) {
  const int faces = mesh_.faceCount();
  return sequence_.run(
      [&] { vertexOfPoint_.reserve(diagram_.points.size()); },
      forEach(diagram_.points, budget, 8,
              [&](int i) {
                const int vertex = vertexAt(mesh_, diagram_.points[i]);
                vertexOfPoint_.push_back(vertex >= 0 ? vertex : mesh_.vertexCount() + i);
              }),
      [&] { return sidePoints_.step(budget); },
      [&] { pieces_.reserve(faces + diagram_.cells.points.size()); },
      [&] { return fillInSlices(uncut_, faces, -1, budget); },
      forEach(faces, budget, 4, [&](int f) { cutFace(f); }));
}

void FaceCutting::cutFace(int f) {
  const size_t firstPiece = pieces_.size();
  if (diagram_.faceLabel[f] == Diagram::kMixed) {
    for (; nextCell_ < diagram_.cells.size() && diagram_.cellFace[nextCell_] == f; ++nextCell_)
      addCell(nextCell_);
    measurePieces(firstPiece);
    return;
  }
  const int label = diagram_.faceLabel[f];
  const auto onSides = sidePoints_.next(f);
  if (label < 0 ? options_.leaveOutUnreachable : isLeftOut(f)) return;
  if (onSides.empty()) {
    uncut_[f] = static_cast<int>(pieces_.size());
    pieces_.push_back({mesh_.face(f).vertices, label, f, mesh_.faceArea(f)});
  } else {
    addFaceWithSidePoints(f, onSides);
    measurePieces(firstPiece);
  }
}

bool FaceCutting::isLeftOut(int f) const {
  const std::vector<int>& indifferent = diagram_.indifferentFaces;
  return options_.leaveOutIndifferent &&
         std::binary_search(indifferent.begin(), indifferent.end(), f);
}

/// Measures the pieces of one face, whose areas sum to that of the face. Rounding may have turned
/// a sliver over, or moved a point off a side; the largest piece absorbs the difference.
void FaceCutting::measurePieces(size_t first) {
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

void FaceCutting::addFaceWithSidePoints(int face, std::span<const SidePoints::Point> points) {
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
void FaceCutting::addCell(int cell) {
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

void FaceCutting::triangulate(std::span<const int> polygon, int label, int face) {
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

Eigen::Vector3d FaceCutting::baryOf(int vertex, int face) const {
  if (vertex >= mesh_.vertexCount())
    return baryInFace(mesh_, diagram_.points[vertex - mesh_.vertexCount()], face);
  Eigen::Vector3d bary;
  for (int i = 0; i < 3; ++i) bary[i] = mesh_.tail(3 * face + i) == vertex;
  return bary;
}

}  // namespace gvd
