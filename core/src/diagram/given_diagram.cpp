// SPDX-License-Identifier: MIT
#include "diagram/given_diagram.h"

#include <string>

#include "gvd/error.h"

namespace gvd {

void requireFaces(const TriangleMesh& mesh, const Diagram& diagram) {
  if (static_cast<int>(diagram.faceLabel.size()) == mesh.faceCount()) return;
  throw Error(ErrorCode::kInvalidArgument,
              "the diagram has " + std::to_string(diagram.faceLabel.size()) + " faces, the mesh " +
                  std::to_string(mesh.faceCount()));
}

}  // namespace gvd
