// SPDX-License-Identifier: MIT
#include "distance/face_layout.h"

namespace gvd {

Incidence incidenceOf(const Eigen::Vector3d& bary) {
  Incidence incidence;
  for (int i = 0; i < 3; ++i) {
    const bool first = bary[cornerAfter(i)] == 0, second = bary[cornerBefore(i)] == 0;
    if (first && second) return {i, -1};
    if (second) incidence.side = i;
  }
  return incidence;
}

SurfacePoint acrossEdge(const TriangleMesh& mesh, const SurfacePoint& p, int h) {
  const int twin = mesh.twin(h);
  SurfacePoint q{TriangleMesh::faceOf(twin), Eigen::Vector3d::Zero()};
  q.bary[twin % 3] = p.bary[cornerAfter(h % 3)];
  q.bary[cornerAfter(twin % 3)] = p.bary[h % 3];
  return q;
}

}  // namespace gvd
