// SPDX-License-Identifier: MIT
#include "distance/face_layout.h"

namespace gvd {

SurfacePoint acrossEdge(const TriangleMesh& mesh, const SurfacePoint& p, int h) {
  const int twin = mesh.twin(h);
  SurfacePoint q{TriangleMesh::faceOf(twin), Eigen::Vector3d::Zero()};
  q.bary[twin % 3] = p.bary[cornerAfter(h % 3)];
  q.bary[cornerAfter(twin % 3)] = p.bary[h % 3];
  return q;
}

}  // namespace gvd
