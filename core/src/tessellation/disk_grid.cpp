// SPDX-License-Identifier: MIT
#include "tessellation/disk_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/face_layout.h"

namespace gvd {
namespace {

/// The largest number of rectangles of one face. All faces together have about as many at most,
/// beside one for each face.
constexpr int kMostRectangles = 1 << 18;
/// The relative rounding of squared distances, with a wide margin: a few 2^-53 of the squared
/// distances at the corners and of the squared longest side.
constexpr double kSquareRounding = 1e-12;

/// Which of equal parts of a length a coordinate is in, or the nearest.
int partAt(double x, double length, int parts) {
  return static_cast<int>(std::clamp(x / length * parts, 0.0, parts - 1.0));
}

/// The least value of x² - 2 centre x in part i of a length.
double leastInPart(double centre, double length, int parts, int i) {
  const double width = length / parts;
  const double x = std::clamp(centre, i * width, (i + 1) * width);
  return x * (x - 2 * centre);
}

/// The parts in which x² - 2 centre x falls below `most`: the first, and the one after the last.
std::array<int, 2> partsBelow(double most, double centre, double length, int parts) {
  int begin = partAt(centre, length, parts), end = begin;
  while (end < parts && leastInPart(centre, length, parts, end) < most) ++end;
  while (begin > 0 && leastInPart(centre, length, parts, begin - 1) < most) --begin;
  return {begin, end};
}

}  // namespace

DiskGrid::DiskGrid(const TriangleMesh& mesh, double width)
    : mesh_(mesh), width_(std::max(width, std::sqrt(2 * mesh.area() / kMostRectangles))) {}

bool DiskGrid::prepare(long& budget) {
  return sequence_.run([&] { first_.reserve(mesh_.faceCount() + 1); },
                       forEach(mesh_.faceCount(), budget, kQuickRounds,
                               [&](int f) {
                                 const Grid grid = gridOf(mesh_.face(f));
                                 first_.push_back(first_.back() + grid.columns * grid.rows);
                               }),
                       [&] { disks_ = SmallLists<int>(first_.back()); });
}

/// The number of rectangles is at most that of squares of `width_` in the face, or 1.
DiskGrid::Grid DiskGrid::gridOf(const TriangleMesh::Face& face) const {
  Grid grid{};
  for (int i = 1; i < 3; ++i)
    if (face.lengths[i] > face.lengths[grid.side]) grid.side = i;
  grid.length = face.lengths[grid.side];
  grid.apex = apexOf(face, grid.side);
  const double rows = grid.apex.y() / width_;
  grid.columns = static_cast<int>(std::max(grid.length / width_ * std::min(rows, 1.0), 1.0));
  grid.rows = static_cast<int>(std::max(rows, 1.0));
  return grid;
}

void DiskGrid::add(int f, const Distances& distances, double radius) {
  const TriangleMesh::Face& face = mesh_.face(f);
  const Grid grid = gridOf(face);
  const double length = grid.length, height = grid.apex.y();
  const int side = grid.side, columns = grid.columns, rows = grid.rows;
  const auto squared = [&](int corner) { return distances[corner] * distances[corner]; };
  const double atTail = squared(side), atTip = squared(cornerAfter(side)),
               atApex = squared(cornerBefore(side));
  // The centre, at which x² - 2 centreX x + y² - 2 centreY y + atTail is least.
  const double centreX = (atTail - atTip + length * length) / (2 * length);
  const double centreY =
      (atTail - atApex + grid.apex.squaredNorm() - 2 * centreX * grid.apex.x()) / (2 * height);
  const double most = radius * radius - atTail + kSquareRounding * (atTail + length * length);

  const auto [left, right] =
      partsBelow(most - leastInPart(centreY, height, 1, 0), centreX, length, columns);
  if (left == right) return;
  const int disk = static_cast<int>(distances_.size());
  distances_.push_back(distances);
  for (int i = left; i < right; ++i) {
    const double leastX = leastInPart(centreX, length, columns, i);
    const auto [low, high] = partsBelow(most - leastX, centreY, height, rows);
    for (int j = low; j < high; ++j) disks_.add(first_[f] + i * rows + j, disk);
  }
}

std::span<const int> DiskGrid::near(const SurfacePoint& p) const {
  const int first = first_[p.face];
  if (first_[p.face + 1] - first == 1) return disks_[first];
  const TriangleMesh::Face& face = mesh_.face(p.face);
  const Grid grid = gridOf(face);
  const double x = layOut(face, grid.side, p.bary).x();
  const int i = partAt(x, grid.length, grid.columns);
  const int j = partAt(p.bary[cornerBefore(grid.side)], 1, grid.rows);
  return disks_[first + i * grid.rows + j];
}

}  // namespace gvd
