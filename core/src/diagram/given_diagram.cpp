// SPDX-License-Identifier: MIT
#include "diagram/given_diagram.h"

#include "gvd/error.h"

namespace gvd {

// Not inlined, as the WebAssembly module would be larger.
[[gnu::noinline]] void requireFaces(const TriangleMesh& mesh, const Diagram& diagram) {
  if (static_cast<int>(diagram.faceLabel.size()) != mesh.faceCount())
    throw Error(ErrorCode::kInvalidArgument, "the diagram is that of another mesh");
}

}  // namespace gvd
