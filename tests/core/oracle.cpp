// SPDX-License-Identifier: MIT
#include "oracle.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace gvd {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using ShortestPath = CGAL::Surface_mesh_shortest_path<Traits>;

Mesh toCgal(const TriangleMesh& mesh) {
  Mesh result;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const Eigen::Vector3d p = mesh.position(v);
    result.add_vertex({p.x(), p.y(), p.z()});
  }
  const auto vertex = [&](int h) { return Mesh::Vertex_index(mesh.tail(h)); };
  for (int h = 0; h < mesh.halfedgeCount(); h += 3)
    if (result.add_face(vertex(h), vertex(h + 1), vertex(h + 2)) == Mesh::null_face())
      throw std::runtime_error("CGAL refuses a face");
  return result;
}

}  // namespace

struct Oracle::Surface {
  Mesh mesh;

  /// CGAL counts the corners of a face from the tail of a halfedge of its choice.
  ShortestPath::Face_location locate(const TriangleMesh& ours, const SurfacePoint& p) const {
    const Mesh::Face_index face(p.face);
    const int first = mesh.source(mesh.halfedge(face));
    int corner = 0;
    while (ours.tail(3 * p.face + corner) != first) ++corner;
    const Eigen::Vector3d bary = offEdge(p.bary);
    return {face, {bary[corner], bary[(corner + 1) % 3], bary[(corner + 2) % 3]}};
  }

  /// CGAL 5.5 takes a site on an edge for the one as far from the edge's other end, and does not
  /// see every path to a point on an edge. So points on edges, but for vertices, move aside.
  static Eigen::Vector3d offEdge(Eigen::Vector3d bary) {
    if ((bary.array() == 0).count() != 1) return bary;
    for (double& weight : bary) weight = std::max(weight, kAside);
    return bary / bary.sum();
  }

  static constexpr double kAside = 1e-14;
};

Oracle::Oracle(const TriangleMesh& mesh)
    : mesh_(mesh), surface_(std::make_unique<Surface>(toCgal(mesh))) {}

Oracle::~Oracle() = default;

std::vector<double> Oracle::distances(const SurfacePoint& site,
                                      std::span<const SurfacePoint> points) const {
  ShortestPath tree(surface_->mesh);
  const auto source = surface_->locate(mesh_, site);
  tree.add_source_point(source.first, source.second);
  std::vector<double> result;
  for (const SurfacePoint& p : points) {
    const auto [face, location] = surface_->locate(mesh_, p);
    const double distance = tree.shortest_distance_to_source_points(face, location).first;
    // Below zero means that there is no path.
    result.push_back(distance < 0 ? std::numeric_limits<double>::infinity() : distance);
  }
  return result;
}

}  // namespace gvd
