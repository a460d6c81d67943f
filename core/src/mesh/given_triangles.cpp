// SPDX-License-Identifier: MIT
#include "mesh/given_triangles.h"

#include <limits>
#include <string>

#include "base/rejection.h"

namespace gvd {
namespace {

void requireMultipleOfThree(std::size_t count, const std::string& what) {
  if (count % 3 != 0)
    rejectMesh("the number of " + what + " is " + std::to_string(count) +
               ", not a multiple of three");
  if (count > std::numeric_limits<int>::max()) rejectMesh("there are too many " + what);
}

}  // namespace

void requireTriples(std::size_t coordinates, std::size_t indices) {
  requireMultipleOfThree(coordinates, "coordinates");
  requireMultipleOfThree(indices, "vertex indices");
}

void requireVertices(std::span<const int> triangles, int triangle, int vertexCount) {
  for (const int v : triangles.subspan(3 * static_cast<std::size_t>(triangle), 3)) {
    if (v >= 0 && v < vertexCount) continue;
    rejectMesh("triangle " + std::to_string(triangle) + " has vertex index " + std::to_string(v) +
               ", but the number of vertices is " + std::to_string(vertexCount));
  }
}

}  // namespace gvd
