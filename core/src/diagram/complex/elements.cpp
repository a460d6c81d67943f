// SPDX-License-Identifier: MIT
#include "diagram/complex/elements.h"

#include <algorithm>
#include <cmath>

#include "mesh/face_metric.h"

namespace gvd {

int Elements::meshHalfedge(int h) const {
  const int element = h / 3, i = h % 3;
  if (isFace(element)) return 3 * face[element] + i;
  // The side of the face that both ends lie on.
  const Eigen::Matrix3d& here = corners[cornersOf[element]];
  const auto from = here.col(i), to = here.col(cornerAfter(i));
  for (int side = 0; side < 3; ++side) {
    const int apex = cornerBefore(side);
    if (from[apex] == 0 && to[apex] == 0) return 3 * face[element] + side;
  }
  return -1;
}

std::array<double, 3> Elements::sideLengths(const TriangleMesh& mesh, int element) const {
  const auto sides = squaredSides(mesh, face[element]);
  const Eigen::Matrix3d here = cornersIn(element);
  std::array<double, 3> lengths;
  for (int i = 0; i < 3; ++i)
    lengths[i] = std::sqrt(squaredDistance(here.col(i), here.col(cornerAfter(i)), sides));
  return lengths;
}

void Elements::reserve(std::size_t count) {
  tail.reserve(3 * count);
  face.reserve(count);
  cornersOf.reserve(count);
}

void Elements::clear() {
  tail.clear();
  face.clear();
  cornersOf.clear();
  corners.clear();
}

void Elements::addFace(int f, const std::array<int, 3>& nodes) {
  tail.insert(tail.end(), nodes.begin(), nodes.end());
  face.push_back(f);
  cornersOf.push_back(-1);
}

///        c               c               c
///       / \             / \             /|\        ab, bc, ca: the middles
///     ca---bc         ca---bc          / | \       With two of them, the shorter diagonal
///     / \ / \         / \_   \        /  |  \      between the others is taken.
///    a---ab--b       a------b        a---ab--b
void Elements::split(const TriangleMesh& mesh, int element, const std::array<int, 3>& middle) {
  // The corners, 0 to 2, and the middles of the sides after them, 3 to 5.
  std::array<int, 6> node;
  Eigen::Matrix<double, 3, 6> place;
  place.leftCols<3>() = cornersIn(element);
  for (int i = 0; i < 3; ++i) {
    node[i] = nodes(element)[i];
    node[3 + i] = middle[i];
    place.col(3 + i) = (place.col(i) + place.col(cornerAfter(i))) / 2;
  }
  int part = element;
  const auto addPart = [&](const std::array<int, 3>& corner) {
    if (part == count()) addFace(face[element], {});
    if (isFace(part)) {
      cornersOf[part] = static_cast<int>(corners.size());
      corners.emplace_back();
    }
    for (int i = 0; i < 3; ++i) {
      tail[3 * part + i] = node[corner[i]];
      corners[cornersOf[part]].col(i) = place.col(corner[i]);
    }
    part = count();
  };
  const auto wholeCount = std::count(middle.begin(), middle.end(), -1);
  if (wholeCount == 0) {
    addPart({3, 4, 5});
    for (int i = 0; i < 3; ++i) addPart({i, 3 + i, 3 + cornerBefore(i)});
    return;
  }
  // Counted from the side that alone is whole, or alone is not.
  int a = 0;
  while ((middle[a] < 0) != (wholeCount == 1)) ++a;
  const int b = cornerAfter(a), c = cornerBefore(a), ab = 3 + a, bc = 3 + b, ca = 3 + c;
  if (wholeCount == 1) {
    const auto sides = squaredSides(mesh, face[element]);
    const bool isFromA = isFirstDiagonalTaken(squaredDistance(place.col(a), place.col(bc), sides),
                                              squaredDistance(place.col(b), place.col(ca), sides));
    addPart({c, ca, bc});
    addPart({a, b, isFromA ? bc : ca});
    addPart({isFromA ? a : b, bc, ca});
  } else {
    addPart({a, ab, c});
    addPart({ab, b, c});
  }
}

}  // namespace gvd
