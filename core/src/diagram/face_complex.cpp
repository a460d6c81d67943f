// SPDX-License-Identifier: MIT
#include "diagram/face_complex.h"

namespace gvd {

std::vector<NodeLabels::InnerNode> FaceComplex::innerNodes(int h) const {
  std::vector<NodeLabels::InnerNode> inner;
  if (!hasFacesOnly() && twins_[h] < 0)
    nodes_.appendBetween(elements_.tail[h], elements_.tail[TriangleMesh::next(h)], inner);
  return inner;
}

int FaceComplex::boundaryHalfedge(int h) const {
  if (hasOwnElements_) return elements_.boundaryHalfedge(mesh_, h);
  return mesh_.twin(h) < 0 ? h : -1;
}

}  // namespace gvd
