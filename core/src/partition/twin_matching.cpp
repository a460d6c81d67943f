// SPDX-License-Identifier: MIT
#include "partition/twin_matching.h"

#include <algorithm>

#include "mesh/corners.h"
#include "mesh/representations.h"

namespace gvd {

bool TwinMatching::step(long& budget) {
  const size_t n = out_.triangles.size();
  return sequence_.run([&] { return fillInSlices(out_.twins, 3 * n, -1, budget); },
                       [&] { return fillInSlices(firstOpen_, out_.points.size(), -1, budget); },
                       [&] { return fillInSlices(nextOpen_, 3 * n, -1, budget); },
                       forEach(n, budget, 4, [&](int t) { matchTriangle(t); }));
}

void TwinMatching::matchTriangle(int t) {
  for (int h = 3 * t; h < 3 * t + 3; ++h)
    if (!takeFromMesh(h)) match(h);
}

/// Whether the mesh says what is beyond a halfedge: an uncut face, or nothing.
bool TwinMatching::takeFromMesh(int h) {
  const int face = out_.triangleFace[h / 3];
  if (uncut_[face] < 0) return false;
  const int beyond = mesh_.face(face).twins[h % 3];
  if (beyond < 0) return true;
  const int triangle = uncut_[TriangleMesh::faceOf(beyond)];
  if (triangle < 0) return false;
  out_.twins[h] = 3 * triangle + beyond % 3;
  return true;
}

/// Pairs a halfedge with an open one at the lower of their ends, or adds it to the open ones.
void TwinMatching::match(int h) {
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

bool TwinMatching::isOnMeshBoundary(int h) const {
  const int face = out_.triangleFace[h / 3];
  for (int i = 0; i < 3; ++i) {
    if (mesh_.face(face).twins[i] >= 0) continue;
    bool isOnSide = true;
    for (const int end : {tailOf(out_.triangles, h), tipOf(out_.triangles, h)})
      isOnSide &= baryInFace(mesh_, out_.points[end], face)[cornerBefore(i)] == 0;
    if (isOnSide) return true;
  }
  return false;
}

}  // namespace gvd
