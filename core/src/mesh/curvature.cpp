// SPDX-License-Identifier: MIT
// This work is based on:
// Mark Meyer, Mathieu Desbrun, Peter Schröder, Alan Barr. Discrete Differential-Geometry Operators
// for Triangulated 2-Manifolds. 2003
#include "gvd/curvature.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/tolerances.h"
#include "gvd/error.h"

namespace gvd {
namespace {

using Eigen::Vector3d;

/// A third of the area of the faces around each vertex.
std::vector<double> vertexAreas(const TriangleMesh& mesh) {
  std::vector<double> areas(mesh.vertexCount(), 0.0);
  for (int h = 0; h < mesh.halfedgeCount(); ++h)
    areas[mesh.tail(h)] += mesh.faceArea(TriangleMesh::faceOf(h)) / 3;
  return areas;
}

/// The gradient of the surface's area when a vertex moves. A face contributes half the side across,
/// turned towards the vertex by 90°: no cotangent of an angle that may be zero.
std::vector<Vector3d> areaGradients(const TriangleMesh& mesh) {
  std::vector<Vector3d> gradients(mesh.vertexCount(), Vector3d::Zero());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    std::array<Vector3d, 3> p;
    for (int i = 0; i < 3; ++i) p[i] = mesh.position(mesh.tail(3 * f + i));
    const Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    for (int i = 0; i < 3; ++i)
      gradients[mesh.tail(3 * f + i)] += normal.cross(p[(i + 2) % 3] - p[(i + 1) % 3]) / 2;
  }
  return gradients;
}

/// Replaces the values at vertices that have none of their own by the mean of their neighbours'.
void fillIn(const TriangleMesh& mesh, const std::vector<char>& hasValue,
            std::vector<double>& values) {
  std::vector<double> sums(values.size(), 0.0);
  std::vector<int> counts(values.size(), 0);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    for (const auto& [to, from] :
         {std::pair(mesh.tail(h), mesh.tip(h)), std::pair(mesh.tip(h), mesh.tail(h))}) {
      if (hasValue[to] || !hasValue[from]) continue;
      sums[to] += values[from];
      ++counts[to];
    }
  }
  for (size_t v = 0; v < values.size(); ++v)
    if (!hasValue[v]) values[v] = counts[v] > 0 ? sums[v] / counts[v] : 0;
}

/// Every vertex the mean, by area, of the means over the faces around it.
void smooth(const TriangleMesh& mesh, const std::vector<double>& areas,
            std::vector<double>& values) {
  std::vector<double> sums(values.size(), 0.0);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const int a = mesh.tail(3 * f), b = mesh.tail(3 * f + 1), c = mesh.tail(3 * f + 2);
    const double share = mesh.faceArea(f) * (values[a] + values[b] + values[c]) / 9;
    for (const int v : {a, b, c}) sums[v] += share;
  }
  for (size_t v = 0; v < values.size(); ++v)
    if (areas[v] > 0) values[v] = sums[v] / areas[v];
}

/// By area; 0 if there is none.
double mean(const std::vector<double>& areas, const std::vector<double>& values) {
  double sum = 0, area = 0;
  for (size_t v = 0; v < values.size(); ++v) {
    sum += areas[v] * values[v];
    area += areas[v];
  }
  return area > 0 ? sum / area : 0;
}

}  // namespace

VertexCurvatures vertexCurvatures(const TriangleMesh& mesh) {
  const std::vector<double> areas = vertexAreas(mesh);
  const std::vector<Vector3d> gradients = areaGradients(mesh);
  VertexCurvatures result;
  result.gaussian.assign(mesh.vertexCount(), 0.0);
  result.mean.assign(mesh.vertexCount(), 0.0);
  std::vector<char> hasValue(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    hasValue[v] = static_cast<char>(areas[v] > 0 && !mesh.onBoundary(v));
    if (!hasValue[v]) continue;
    result.gaussian[v] = (2 * std::numbers::pi - mesh.angleSum(v)) / areas[v];
    result.mean[v] = gradients[v].norm() / (2 * areas[v]);
  }
  fillIn(mesh, hasValue, result.gaussian);
  fillIn(mesh, hasValue, result.mean);
  return result;
}

std::vector<double> curvatureDensity(const TriangleMesh& mesh,
                                     const CurvatureDensityOptions& options) {
  if (options.smoothing < 0 || !(options.floor > 0 && std::isfinite(options.floor)))
    throw Error(ErrorCode::kInvalidArgument,
                "the smoothing is negative, or the floor not positive and finite");
  const VertexCurvatures curvatures = vertexCurvatures(mesh);
  std::vector<double> density(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const double h = curvatures.mean[v];
    const double k = curvatures.gaussian[v];
    // κ₁² + κ₂² >= 2 |κ₁ κ₂|, which the discrete values may violate at sharp corners.
    density[v] = std::max(4 * h * h - 2 * k, 2 * std::abs(k));
  }
  const std::vector<double> areas = vertexAreas(mesh);
  for (int i = 0; i < options.smoothing; ++i) smooth(mesh, areas, density);

  const double before = mean(areas, density), size = mesh.boundingDiagonal();
  if (!(before * size * size > kFlatCurvature)) return std::vector<double>(density.size(), 1.0);
  for (double& rho : density) rho = (rho / before + options.floor) / (1 + options.floor);
  return density;
}

}  // namespace gvd
