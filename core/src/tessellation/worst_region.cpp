// SPDX-License-Identifier: MIT
//
// Sites for the worst region first.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "gvd/dynamic_diagram.h"
#include "gvd/error.h"
#include "gvd/sampling.h"
#include "mesh/surface_geometry.h"

namespace gvd {
namespace {

using Eigen::Vector2d;

/// A mean distortion below this is rounding, of distances and of the difference that it comes from.
constexpr double kFlat = 1e-12;

/// (σ₁ - 1)² + (σ₂ - 1)² of the logarithmic map of a label on a face. Where the map is not known,
/// that of a map to one point.
double distortionOf(const TriangleMesh& mesh, const DistanceField& distances, int label, int face) {
  Eigen::Matrix<double, 2, 3> u;
  for (int i = 0; i < 3; ++i) {
    const int v = mesh.tail(3 * face + i);
    u.col(i).setZero();
    for (const LabelledDistance& d : distances.at(v))
      if (d.label == label && d.distance > 0) u.col(i) = d.distance * distances.direction(label, v);
    if (!u.col(i).allFinite()) u.col(i).setZero();
  }
  // The derivatives along the first side of the face and across it.
  const TriangleMesh::Layout layout = mesh.layout(3 * face);
  const Vector2d along = (u.col(1) - u.col(0)) / layout.length;
  const Vector2d across = (u.col(2) - u.col(0) - layout.x * along) / layout.y;
  // σ₁² + σ₂² = |J|², and σ₁ σ₂ = |det J|, J their matrix.
  const double squares = along.squaredNorm() + across.squaredNorm();
  const double product = std::abs(along[0] * across[1] - along[1] * across[0]);
  return std::max(0.0, squares - 2 * std::sqrt(squares + 2 * product) + 2);
}

/// The area of a cell, a convex polygon in its face.
double areaOfCell(const TriangleMesh& mesh, const Diagram& diagram, int cell) {
  const int face = diagram.cellFace[cell];
  const auto points = diagram.cells[cell];
  const auto at = [&](int i) { return baryInFace(mesh, diagram.points[points[i]], face); };
  double share = 0;
  for (int i = 2; i < static_cast<int>(points.size()); ++i) {
    const Eigen::Vector3d p = at(i - 1) - at(0), q = at(i) - at(0);
    share += p[0] * q[1] - p[1] * q[0];
  }
  return std::max(0.0, share) * mesh.faceArea(face);
}

std::vector<double> distortions(const TriangleMesh& mesh, const DistanceField& distances,
                                const Diagram& diagram) {
  std::vector<double> sums(diagram.siteCount, 0.0);
  for (int f = 0; f < mesh.faceCount(); ++f)
    if (const int label = diagram.faceLabel[f]; label >= 0)
      sums[label] += mesh.faceArea(f) * distortionOf(mesh, distances, label, f);
  for (int c = 0; c < diagram.cells.size(); ++c) {
    const int label = diagram.cellLabel[c];
    sums[label] +=
        areaOfCell(mesh, diagram, c) * distortionOf(mesh, distances, label, diagram.cellFace[c]);
  }
  for (int label = 0; label < diagram.siteCount; ++label)
    if (sums[label] <= kFlat * diagram.regionArea[label]) sums[label] = 0;
  return sums;
}

int worstLabel(const TriangleMesh& mesh, const DistanceField& distances, const Diagram& diagram,
               WorstRegion worst) {
  std::vector<double> badness(diagram.siteCount, 0.0);
  if (worst == WorstRegion::kMostDistorted) badness = distortions(mesh, distances, diagram);
  int label = 0;
  for (int l = 1; l < diagram.siteCount; ++l)
    if (std::pair(badness[l], diagram.regionArea[l]) >
        std::pair(badness[label], diagram.regionArea[label]))
      label = l;
  return label;
}

}  // namespace

SurfacePoint worstRegionPoint(const TriangleMesh& mesh, const DistanceField& distances,
                              const Diagram& diagram, WorstRegion worst) {
  const auto unreached =
      std::find(diagram.faceLabel.begin(), diagram.faceLabel.end(), Diagram::kUnreachable);
  if (unreached != diagram.faceLabel.end())
    return {static_cast<int>(unreached - diagram.faceLabel.begin()),
            Eigen::Vector3d::Constant(1.0 / 3)};

  const int label = worstLabel(mesh, distances, diagram, worst);
  SurfacePoint farthest;
  double most = -1;
  const auto offer = [&](const SurfacePoint& p, double distance) {
    if (!(distance > most)) return;
    most = distance;
    farthest = p;
  };
  for (int v = 0; v < mesh.vertexCount(); ++v)
    if (const LabelledDistance d = nearestOf(distances.at(v)); d.label == label)
      offer({TriangleMesh::faceOf(mesh.outgoing(v)), Eigen::Vector3d::Unit(mesh.outgoing(v) % 3)},
            d.distance);
  for (int loop = 0; loop < diagram.loops.size(); ++loop)
    if (diagram.loopLabel[loop] == label)
      for (const int point : diagram.loops[loop])
        offer(diagram.points[point], distances.nearest(diagram.points[point]).distance);
  return farthest;
}

std::vector<SurfacePoint> sampleWorstFirst(const TriangleMesh& mesh, int count, std::uint64_t seed,
                                           WorstRegion worst) {
  std::vector<SurfacePoint> points = sampleUniform(mesh, std::min(count, 1), seed);
  DynamicDiagram diagram(mesh, points);
  while (static_cast<int>(points.size()) < count) {
    points.push_back(worstRegionPoint(mesh, diagram.distances(), diagram.diagram(), worst));
    diagram.insertSite(points.back());
  }
  return points;
}

}  // namespace gvd
