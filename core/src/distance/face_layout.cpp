// SPDX-License-Identifier: MIT
#include "distance/face_layout.h"

namespace gvd {

std::vector<FaceLayout> layOutFaces(const TriangleMesh& mesh) {
  std::vector<FaceLayout> layouts(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    FaceLayout& face = layouts[f];
    for (int i = 0; i < 3; ++i) {
      const int h = 3 * f + i;
      const TriangleMesh::Layout& side = mesh.layout(h);
      const double toApex = mesh.length(TriangleMesh::previous(h));
      face.length[i] = side.length;
      face.angle[i] = mesh.cornerAngle(h);
      face.cosine[i] = side.x / toApex;
      face.sine[i] = side.y / toApex;
      face.vertex[i] = mesh.tail(h);
      face.twin[i] = mesh.twin(h);
    }
  }
  return layouts;
}

Incidence incidenceOf(const Eigen::Vector3d& bary) {
  Incidence incidence;
  for (int i = 0; i < 3; ++i) {
    const bool first = bary[FaceLayout::after(i)] == 0, second = bary[FaceLayout::before(i)] == 0;
    if (first && second) return {i, -1};
    if (second) incidence.side = i;
  }
  return incidence;
}

SurfacePoint acrossEdge(const TriangleMesh& mesh, const SurfacePoint& p, int h) {
  const int twin = mesh.twin(h);
  SurfacePoint q{TriangleMesh::faceOf(twin), Eigen::Vector3d::Zero()};
  q.bary[twin % 3] = p.bary[FaceLayout::after(h % 3)];
  q.bary[FaceLayout::after(twin % 3)] = p.bary[h % 3];
  return q;
}

}  // namespace gvd
