// SPDX-License-Identifier: MIT
//
// Energy and gradient of a tessellation, integrated over the cells of its diagram in closed form.
#include "tessellation/cvt_energy.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/sliced_loop.h"
#include "mesh/face_metric.h"
#include "mesh/incidence.h"

namespace gvd {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// The logarithmic map of every label at every vertex that it reaches, with the squared distance.
class LogMaps {
 public:
  struct Value {
    int label;
    double squaredDistance;
    Vector2d vector;
  };

  explicit LogMaps(const TriangleMesh& mesh) {
    offset_.reserve(mesh.vertexCount() + 1);
    values_.reserve(mesh.vertexCount());
  }

  /// Adds the labels at the next vertex.
  void add(const DistanceField& distances, int vertex) {
    for (const LabelledDistance& d : distances.at(vertex)) {
      const Vector2d u = d.distance * distances.direction(d.label, vertex);
      values_.push_back(
          {d.label, d.distance * d.distance, u.allFinite() ? u : Vector2d(Vector2d::Zero())});
    }
    offset_.push_back(static_cast<int>(values_.size()));
  }

  /// Null if the label is not known at the vertex.
  const Value* find(int vertex, int label) const {
    const auto end = values_.begin() + offset_[vertex + 1];
    const auto it = std::find_if(values_.begin() + offset_[vertex], end,
                                 [&](const Value& value) { return value.label == label; });
    return it == end ? nullptr : &*it;
  }

 private:
  std::vector<int> offset_ = {0};
  std::vector<Value> values_;
};

class Integrator final : public SequentialWork<CvtEnergy> {
 public:
  Integrator(const TriangleMesh& mesh, const DistanceField& distances, const Diagram& diagram,
             std::span<const double> density)
      : mesh_(mesh), distances_(distances), diagram_(diagram), density_(density), logMaps_(mesh) {
    out_.regions.resize(diagram.siteCount);
  }

  bool advance(long budget) override {
    const int faces = mesh_.faceCount();
    return sequence_.run(
        forEach(mesh_.vertexCount(), budget, 4, [&](int v) { logMaps_.add(distances_, v); }),
        [&] { return fillInSlices(out_.faceEnergy, faces, 0., budget); },
        forEach(faces, budget, 4, [&](int f) { addFace(f); }),
        forEach(diagram_.cells, budget, 2, [&](int c) { addCell(c); }),
        forEach(faces, budget, kQuickRounds, [&](int f) { out_.energy += out_.faceEnergy[f]; }));
  }

 private:
  void addFace(int face) {
    if (diagram_.faceLabel[face] >= 0 && enterFace(face, diagram_.faceLabel[face]))
      add(mesh_.faceArea(face), rho_, squared_, {sides_[1], sides_[2], sides_[0]}, vectors_);
  }

  /// Loads the corner values of a label on a face; false if the label is not known there.
  bool enterFace(int face, int label) {
    for (int i = 0; i < 3; ++i) {
      const int v = mesh_.tail(3 * face + i);
      const LogMaps::Value* value = logMaps_.find(v, label);
      if (!value) return false;
      squared_[i] = value->squaredDistance;
      vectors_.col(i) = value->vector;
      if (!density_.empty()) rho_[i] = density_[v];
    }
    face_ = face;
    label_ = label;
    sides_ = squaredSides(mesh_, face);
    return true;
  }

  void addCell(int cell) {
    const int face = diagram_.cellFace[cell];
    if (!enterFace(face, diagram_.cellLabel[cell])) return;
    const double faceArea = mesh_.faceArea(face);
    const auto points = diagram_.cells[cell];
    Matrix3d corners;
    corners.col(0) = cornerAt(points[0]);
    corners.col(2) = cornerAt(points[1]);
    for (size_t i = 2; i < points.size(); ++i) {
      corners.col(1) = corners.col(2);
      corners.col(2) = cornerAt(points[i]);
      const double share = areaShare(corners.col(0), corners.col(1), corners.col(2));
      addTriangle(corners, std::max(0.0, share) * faceArea);
    }
  }

  Vector3d cornerAt(int point) const { return baryInFace(mesh_, diagram_.points[point], face_); }

  /// Adds the integrals over a triangle in the current face.
  void addTriangle(const Matrix3d& corners, double area) {
    Vector3d squared = corners.transpose() * squared_;
    Vector3d opposite;  // squared sides, by the corner opposite
    for (int i = 0; i < 3; ++i) {
      squared[i] -= interpolationExcess(corners.col(i), sides_);
      opposite[i] =
          squaredDistance(corners.col(cornerAfter(i)), corners.col(cornerBefore(i)), sides_);
    }
    add(area, corners.transpose() * rho_, squared, opposite, vectors_ * corners);
  }

  /// Adds the integrals, given ρ, d² and u at the triangle's corners and the squared sides opposite
  /// to them. In the triangle, ρ and u are linear, and d² is the interpolant of its corner values
  /// less Σ cᵢ cⱼ |eᵢⱼ|², where c are the triangle's own barycentric coordinates and e its sides.
  /// So only means of products of up to three c are needed: 1/3 for cᵢ, 1/12 for cᵢ cⱼ, 1/6 for
  /// cᵢ², 1/60 for c₀ c₁ c₂, 1/30 for cᵢ² cⱼ.
  void add(double area, const Vector3d& rho, const Vector3d& squared, const Vector3d& opposite,
           const Eigen::Matrix<double, 2, 3>& vectors) {
    const double rhoSum = rho.sum();
    const double linear = (rhoSum * squared.sum() + rho.dot(squared)) / 12;
    const double bulge = (2 * rhoSum * opposite.sum() - rho.dot(opposite)) / 60;
    out_.faceEnergy[face_] += area * (linear - bulge);
    RegionMoments& region = out_.regions[label_];
    region.mass += area * rhoSum / 3;
    const Vector3d weights = (rho + Vector3d::Constant(rhoSum)) / 12;
    region.moment += area * (vectors * weights);
  }

  const TriangleMesh& mesh_;
  const DistanceField& distances_;
  const Diagram& diagram_;
  const std::span<const double> density_;
  LogMaps logMaps_;

  // Of the current face and label, by corner.
  int face_ = -1, label_ = -1;
  std::array<double, 3> sides_;
  Vector3d squared_;
  Eigen::Matrix<double, 2, 3> vectors_;
  Vector3d rho_ = Vector3d::Ones();
};

}  // namespace

std::unique_ptr<SlicedWork<CvtEnergy>> startCvtEnergy(const TriangleMesh& mesh,
                                                      const DistanceField& distances,
                                                      const Diagram& diagram,
                                                      std::span<const double> density) {
  return std::make_unique<Integrator>(mesh, distances, diagram, density);
}

}  // namespace gvd
