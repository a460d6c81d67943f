// SPDX-License-Identifier: MIT
//
// The areas of the regions of three sites on an octahedron.

#include <gvd/gltf.h>
#include <gvd/gvd.h>

#include <iostream>
#include <vector>

int main(int argc, char**) try {
  const std::vector<double> positions{1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0, 0, -1, 0, 0, 0, -1};
  const std::vector<int> triangles{0, 1, 2, 1, 3, 2, 3, 4, 2, 4, 0, 2,
                                   1, 0, 5, 3, 1, 5, 4, 3, 5, 0, 4, 5};
  const gvd::TriangleMesh mesh(positions, triangles);
  const auto sites = gvd::sampleUniform(mesh, 3, /*seed=*/1);
  const auto distances = gvd::finished(gvd::propagate(mesh, sites, gvd::Metric::kExact));
  const gvd::Diagram diagram = gvd::traceDiagram(mesh, *distances, static_cast<int>(sites.size()));
  for (const double area : diagram.regionArea) std::cout << area << '\n';
  if (argc > 1) gvd::readGltf({});  // of no bytes: says what is wrong with them
  return 0;
} catch (const gvd::Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
