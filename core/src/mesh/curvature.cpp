// SPDX-License-Identifier: MIT
// This work is based on:
// Mark Meyer, Mathieu Desbrun, Peter Schröder, Alan Barr. Discrete Differential-Geometry Operators
// for Triangulated 2-Manifolds. 2003
#include "gvd/curvature.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "gvd/surface_point.h"
#include "mesh/nearest_on_triangle.h"

namespace gvd {
namespace {

using Eigen::Vector3d;

/// The angle defect that rounding may leave at a vertex of a flat mesh: a few times 2^-51, with a
/// margin of ten. V vertices of area A/V with a defect δ have the mean squared curvature 2 V δ / A.
constexpr double kDefectRounding = 0x1p-46;

/// The height of a flat face, as a share of its longest side, is less than this: coordinates of
/// single precision are rounded by as much where a side is a hundredth of the mesh.
constexpr double kFlat = 1e-5;

/// The curvatures at all vertices, with the areas of the vertices.
class CurvatureMeasuring final : public SequentialWork<VertexCurvatures> {
 public:
  explicit CurvatureMeasuring(const TriangleMesh& mesh) : mesh_(mesh) {}

  bool advance(long budget) override {
    const int vertices = mesh_.vertexCount();
    const auto forVertices = [&](auto body) { return forEach(vertices, budget, 8, body); };
    return sequence_.run([&] { return fillInSlices(areas_, vertices, 0., budget); },
                         [&] {
                           return fillInSlices(areaGradients_, vertices, {0, 0, 0}, budget);
                         },
                         [&] { return fillInSlices(out_.gaussian, vertices, 0., budget); },
                         [&] { return fillInSlices(out_.mean, vertices, 0., budget); },
                         forEach(mesh_.faceCount(), budget, 4, [&](int f) { addFace(f); }),
                         forVertices([&](int v) { measure(v); }),
                         forVertices([&](int v) { takeFromNeighbours(v); }));
  }
  /// A third of the area of the faces around each vertex.
  std::vector<double> takeAreas() { return std::move(areas_); }

 private:
  /// Adds a face to the areas of its corners and to the gradients of the surface's area as a corner
  /// moves: half the opposite side, turned by 90° towards the corner. Unlike the cotangent formula,
  /// this is finite at any angle.
  void addFace(int f) {
    const SpaceTriangle p = cornersOf(f);
    const Vector3d normal = normalOf(f);
    for (int i = 0; i < 3; ++i) {
      const int v = mesh_.tail(3 * f + i);
      areas_[v] += mesh_.faceArea(f) / 3;
      areaGradients_[v] += normal.cross(p[cornerBefore(i)] - p[cornerAfter(i)]) / 2;
    }
  }

  /// The unit normal of a face. A flat face has that of the face across its longest side: its own
  /// is rounding, and at a vertex within that side the surface would seem to end. Across flat faces
  /// that fill one side, halving it again and again, the way is shorter than `kMostFlat`.
  Vector3d normalOf(int f) const {
    constexpr int kMostFlat = 32;
    for (int flat = 0;; ++flat) {
      const SpaceTriangle p = cornersOf(f);
      const Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
      const int side = longestSide(p), twin = mesh_.twin(3 * f + side);
      const double least = kFlat * (p[cornerAfter(side)] - p[side]).squaredNorm();
      const bool isFlat = mesh_.isJoining(f) || normal.norm() < least;
      if (!isFlat || twin < 0 || flat == kMostFlat) return normal.normalized();
      f = TriangleMesh::faceOf(twin);
    }
  }

  SpaceTriangle cornersOf(int f) const {
    SpaceTriangle p;
    for (int i = 0; i < 3; ++i) p[i] = mesh_.position(mesh_.tail(3 * f + i));
    return p;
  }

  void measure(int v) {
    if (mesh_.onBoundary(v)) return;
    out_.gaussian[v] = (2 * std::numbers::pi - mesh_.angleSum(v)) / areas_[v];
    out_.mean[v] = areaGradients_[v].norm() / (2 * areas_[v]);
  }

  /// The formulas do not hold on the boundary: a vertex there gets the mean of its inner
  /// neighbours.
  void takeFromNeighbours(int v) {
    if (!mesh_.onBoundary(v)) return;
    double gaussian = 0, mean = 0;
    int count = 0;
    mesh_.visitNeighbours(v, [&](int neighbour) {
      if (mesh_.onBoundary(neighbour)) return;
      gaussian += out_.gaussian[neighbour];
      mean += out_.mean[neighbour];
      ++count;
    });
    if (count == 0) return;
    out_.gaussian[v] = gaussian / count;
    out_.mean[v] = mean / count;
  }

  const TriangleMesh& mesh_;
  std::vector<double> areas_;
  std::vector<Vector3d> areaGradients_;
};

class DensityMaking final : public SequentialWork<std::vector<double>> {
 public:
  DensityMaking(const TriangleMesh& mesh, const CurvatureDensityOptions& options)
      : mesh_(mesh), options_(options), measuring_(mesh) {
    if (options.smoothing < 0 || !(options.floor > 0 && std::isfinite(options.floor)))
      rejectArgument("the smoothing is negative, or the floor not positive and finite");
  }

  bool advance(long budget) override {
    const int vertices = mesh_.vertexCount();
    const auto forVertices = [&](auto body) {
      return forEach(vertices, budget, kQuickRounds, body);
    };
    return sequence_.run(
        [&] { return measuring_.step(budget); },
        [&] {
          areas_ = measuring_.takeAreas();
          curvatures_ = measuring_.take();
        },
        [&] { return fillInSlices(out_, vertices, 0., budget); }, forVertices([&](int v) {
          const double h = curvatures_.mean[v], k = curvatures_.gaussian[v];
          // κ₁² + κ₂² >= 2 |κ₁ κ₂|, which the discrete values may violate at sharp corners.
          out_[v] = std::max(4 * h * h - 2 * k, 2 * std::abs(k));
        }),
        [&] { return fillInSlices(sums_, vertices, 0., budget); },
        [&] {
          for (; round_ < options_.smoothing; ++round_, smoothing_ = {})
            if (!smooth(budget)) return false;
          return true;
        },
        forVertices([&](int v) { mean_ += areas_[v] * out_[v] / mesh_.area(); }),
        [&] { isFlat_ = !(mean_ * mesh_.area() > 2 * kDefectRounding * vertices); },
        forVertices([&](int v) { out_[v] = scaled(out_[v]); }));
  }
  double share() const override { return (measuring_.progress() + sequence_.progress()) / 2; }

 private:
  /// Sets every vertex to the mean of the faces around it, weighted by area; the value of a face is
  /// the mean of its corners.
  bool smooth(long& budget) {
    const auto addToSums = [&](int f) {
      const int a = mesh_.tail(3 * f), b = mesh_.tail(3 * f + 1), c = mesh_.tail(3 * f + 2);
      const double share = mesh_.faceArea(f) * (out_[a] + out_[b] + out_[c]) / 9;
      for (const int v : {a, b, c}) sums_[v] += share;
    };
    const auto takeMean = [&](int v) {
      out_[v] = sums_[v] / areas_[v];
      sums_[v] = 0;
    };
    return smoothing_.run(forEach(mesh_.faceCount(), budget, 8, addToSums),
                          forEach(mesh_.vertexCount(), budget, kQuickRounds, takeMean));
  }

  /// The density raised by the floor, scaled to the mean 1.
  double scaled(double density) const {
    return isFlat_ ? 1 : (density / mean_ + options_.floor) / (1 + options_.floor);
  }

  const TriangleMesh& mesh_;
  const CurvatureDensityOptions options_;
  CurvatureMeasuring measuring_;
  SlicedSequence smoothing_;
  std::vector<double> areas_;
  VertexCurvatures curvatures_;
  std::vector<double> sums_;
  int round_ = 0;
  double mean_ = 0;  ///< of the density, over the surface
  bool isFlat_ = false;
};

}  // namespace

VertexCurvatures vertexCurvatures(const TriangleMesh& mesh) {
  return finished<VertexCurvatures>(std::make_unique<CurvatureMeasuring>(mesh));
}

std::unique_ptr<SlicedWork<std::vector<double>>> startCurvatureDensity(
    const TriangleMesh& mesh, const CurvatureDensityOptions& options) {
  return std::make_unique<DensityMaking>(mesh, options);
}

std::vector<double> curvatureDensity(const TriangleMesh& mesh,
                                     const CurvatureDensityOptions& options) {
  return finished(startCurvatureDensity(mesh, options));
}

}  // namespace gvd
