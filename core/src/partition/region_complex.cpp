// SPDX-License-Identifier: MIT
//
// Borders and vertices of a partition, read off the outlines of its regions.
#include "partition/region_complex.h"

#include <algorithm>

#include "partition/region_patches.h"

namespace gvd {

std::vector<int> RegionComplex::labelsAt(int vertex) const {
  std::vector<int> labels;
  for (const int b : vertices[vertex].borders) labels.push_back(borders[b].label);
  return labels;
}

RegionComplexBuilding::RegionComplexBuilding(const TriangleMesh& mesh, const Diagram& diagram)
    : partitioning_(startPartition(mesh, diagram, {.leaveOutUnreachable = true})) {}

bool RegionComplexBuilding::step(long& budget) {
  const auto& points = out_.partition.points;
  const auto& twins = out_.partition.twins;
  return sequence_.run([&] { return partitioning_->step(budget); },
                       [&] {
                         out_.partition = partitioning_->take();
                         partitioning_.reset();
                       },
                       [&] { return fillInSlices(vertexOfPoint_, points.size(), 0, budget); },
                       [&] { return fillInSlices(borderOf_, twins.size(), -1, budget); },
                       forEach(twins, budget, 8, [&](int h) { countSector(h); }),
                       forEach(points, budget, kQuickRounds, [&](int p) { findVertex(p); }),
                       forEach(twins, budget, 8, [&](int h) { walkLoopFrom(h); }),
                       forEach(out_.borders, budget, 2, [&](int b) { listBorder(b); }),
                       forEach(out_.vertices, budget, 1, [&](int v) { turnAround(v); }),
                       [&] { release(borderOf_); });
}

double RegionComplexBuilding::progress() const {
  constexpr double kPartitionsShare = 0.8;
  return partitioning_ ? kPartitionsShare * partitioning_->progress() : kPartitionsShare;
}

/// The last halfedge of the sector that starts with h: the first one on the outline when turning
/// counterclockwise within the region.
int RegionComplexBuilding::endOfSector(int h) const {
  int last = TriangleMesh::previous(h);
  while (!isOnOutline(out_.partition, last))
    last = TriangleMesh::previous(out_.partition.twins[last]);
  return last;
}

void RegionComplexBuilding::countSector(int h) {
  if (!isOnOutline(out_.partition, h)) return;
  vertexOfPoint_[tail(h)] += out_.partition.twins[h] < 0 ? 2 : 1;  // the outside is one
}

void RegionComplexBuilding::findVertex(int point) {
  const bool isVertex = vertexOfPoint_[point] >= 3;  // sectors
  vertexOfPoint_[point] = isVertex ? static_cast<int>(out_.vertices.size()) : -1;
  if (isVertex) out_.vertices.push_back({point, {}, -1});
}

void RegionComplexBuilding::walkLoopFrom(int start) {
  if (borderOf_[start] >= 0 || !isOnOutline(out_.partition, start)) return;
  steps_.clear();
  walkOutline(out_.partition, start, [&](int h) { steps_.push_back(h); });
  const auto leavesVertex = [&](int h) { return vertexOfPoint_[tail(h)] >= 0; };
  const auto first = std::find_if(steps_.begin(), steps_.end(), leavesVertex);
  if (first != steps_.end()) std::rotate(steps_.begin(), first, steps_.end());
  const int firstBorder = static_cast<int>(out_.borders.size());
  for (const int h : steps_) {
    if (leavesVertex(h) || h == steps_.front()) startBorder(h);
    out_.borders.back().path.push_back(h);
    borderOf_[h] = static_cast<int>(out_.borders.size()) - 1;
  }
  const int end = static_cast<int>(out_.borders.size());
  for (int b = firstBorder; b < end; ++b)
    out_.borders[b].toVertex = out_.borders[b + 1 < end ? b + 1 : firstBorder].fromVertex;
  out_.loops.push_back({out_.partition.triangleLabel[start / 3], firstBorder, end - firstBorder});
}

void RegionComplexBuilding::startBorder(int h) {
  const int twin = out_.partition.twins[h];
  out_.borders.push_back(
      {out_.partition.triangleLabel[h / 3],
       twin < 0 ? RegionComplex::kOutside : out_.partition.triangleLabel[twin / 3],
       vertexOfPoint_[tail(h)],
       -1,
       {}});
}

/// Makes a border the first of its vertex: a run if there is one, else the first border listed.
/// `turnAround` adds the others.
void RegionComplexBuilding::listBorder(int b) {
  const RegionComplex::Border& border = out_.borders[b];
  if (border.fromVertex < 0) return;
  std::vector<int>& borders = out_.vertices[border.fromVertex].borders;
  const bool isRun = border.beyond == RegionComplex::kOutside;
  if (isRun) out_.vertices[border.toVertex].arrivingRun = b;
  if (isRun || borders.empty()) borders.assign(1, b);
}

void RegionComplexBuilding::turnAround(int vertex) {
  std::vector<int>& borders = out_.vertices[vertex].borders;
  for (;;) {
    const int last = endOfSector(out_.borders[borders.back()].path.front());
    const int beyond = out_.partition.twins[last];
    if (beyond < 0 || borderOf_[beyond] == borders.front()) break;
    borders.push_back(borderOf_[beyond]);
  }
}

}  // namespace gvd
