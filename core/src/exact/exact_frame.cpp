// SPDX-License-Identifier: MIT
#include "exact/exact_frame.h"

#include <Eigen/Geometry>
#include <array>

namespace gvd::exact {

std::vector<Frame> layOutFaces(const TriangleMesh& mesh) {
  std::vector<Frame> frames(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    Frame& frame = frames[f];
    for (int i = 0; i < 3; ++i) {
      frame.length[i] = mesh.length(3 * f + i);
      frame.vertex[i] = mesh.tail(3 * f + i);
      frame.twin[i] = mesh.twin(3 * f + i);
      frame.firstWindow[i] = -1;
    }
    frame.firstSite = -1;
    frame.label = Frame::kNoLabel;
    const double longest = frame.longestSide();
    std::array<Eigen::Vector3d, 3> side;
    for (int i = 0; i < 3; ++i)
      side[i] =
          (mesh.position(frame.vertex[Frame::after(i)]) - mesh.position(frame.vertex[i])) / longest;
    // The area from the two shorter sides: its error is least there.
    const int far = frame.length[0] == longest ? 0 : frame.length[1] == longest ? 1 : 2;
    const double area2 = side[Frame::after(far)].cross(side[Frame::before(far)]).norm();
    for (int i = 0; i < 3; ++i) {
      const int j = Frame::before(i);
      const double product = (frame.length[i] / longest) * (frame.length[j] / longest);
      frame.cosine[i] = -side[i].dot(side[j]) / product;
      frame.sine[i] = area2 / product;
    }
  }
  return frames;
}

SurfacePoint acrossEdge(const TriangleMesh& mesh, const SurfacePoint& p, int h) {
  const int twin = mesh.twin(h);
  SurfacePoint q{TriangleMesh::faceOf(twin), Eigen::Vector3d::Zero()};
  q.bary[twin % 3] = p.bary[Frame::after(h % 3)];
  q.bary[Frame::after(twin % 3)] = p.bary[h % 3];
  return q;
}

Place placeOf(const Eigen::Vector3d& bary) {
  Place place;
  for (int i = 0; i < 3; ++i) {
    const bool first = bary[Frame::after(i)] == 0, second = bary[Frame::before(i)] == 0;
    if (first && second) return {i, -1};
    if (second) place.side = i;
  }
  return place;
}

}  // namespace gvd::exact
