// SPDX-License-Identifier: MIT
//
// Sampling of the worst region first: finds the worst region of a diagram, and keeps the answer up
// to date while sites are inserted.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/plane.h"
#include "base/sliced_loop.h"
#include "diagram/diagram_pieces.h"
#include "diagram/given_diagram.h"
#include "distance/labelled_distances.h"
#include "distance/path_points.h"
#include "distance/site_distances.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/sampling.h"
#include "mesh/face_layout.h"
#include "mesh/representations.h"
#include "mesh/surface_geometry.h"

namespace gvd {
namespace {

using Eigen::Vector2d;

/// The mean distortion of a region's logarithmic map (`WorstRegion::kDistortion`) that rounding
/// of distances and of their differences can cause.
constexpr double kFlatDistortion = 1e-12;

/// (σ₁ - 1)² + (σ₂ - 1)² of a label's logarithmic map on a face; 0 if the label is not known at all
/// corners.
double distortionOf(const TriangleMesh& mesh, const DistanceField& distances, int label, int f) {
  const TriangleMesh::Face& face = mesh.face(f);
  Eigen::Matrix<double, 2, 3> u;
  for (int i = 0; i < 3; ++i) {
    const int v = face.vertices[i];
    const LabelledDistance* const known = findLabel(distances.at(v), label);
    if (!known) return 0;
    u.col(i) = known->distance * distances.direction(label, v);
  }
  // The derivatives along the first side of the face and across it.
  const Vector2d apex = apexOf(face, 0);
  const Vector2d along = (u.col(1) - u.col(0)) / face.lengths[0];
  const Vector2d across = (u.col(2) - u.col(0) - apex.x() * along) / apex.y();
  // σ₁² + σ₂² = |J|², and σ₁ σ₂ = |det J|, where J is their matrix.
  const double squares = along.squaredNorm() + across.squaredNorm();
  const double product = std::abs(cross(along, across));
  return std::max(0.0, squares - 2 * std::sqrt(squares + 2 * product) + 2);
}

/// The area of a cell, a convex polygon in its face.
double areaOfCell(const TriangleMesh& mesh, const Diagram& diagram, int cell) {
  const int face = diagram.cellFace[cell];
  const auto points = diagram.cells[cell];
  const auto at = [&](int i) { return baryInFace(mesh, diagram.points[points[i]], face); };
  double share = 0;
  for (int i = 2; i < static_cast<int>(points.size()); ++i)
    share += areaShare(at(0), at(i - 1), at(i));
  return std::max(0.0, share) * mesh.faceArea(face);
}

}  // namespace

WorstRegions::WorstRegions(const TriangleMesh& mesh, const DistanceField& distances,
                           const Diagram& diagram, WorstRegion worst)
    : mesh_(mesh),
      distances_(distances),
      worst_(worst),
      faceLabel_(mesh.faceCount(), Diagram::kUnreachable),
      shares_(worst == WorstRegion::kDistortion ? mesh.faceCount() : 0) {
  requireFaces(mesh, diagram);
  requireMesh(mesh, distances);
  follow(changeTo(diagram));
}

void WorstRegions::follow(const DiagramChange& change) {
  if (!change.labels.empty())
    regions_.resize(std::max<size_t>(regions_.size(), change.labels.back() + 1));
  const Diagram& part = change.part;
  for (size_t i = 0; i < change.labels.size(); ++i)
    regions_[change.labels[i]] = {part.regionArea[i], 0, {}};
  for (int i = 0; i < part.loops.size(); ++i)
    for (const int point : part.loops[i])
      regions_[part.loopLabel[i]].outline.push_back(part.points[point]);
  for (size_t i = 0; i < change.faces.size(); ++i) faceLabel_[change.faces[i]] = part.faceLabel[i];
  if (worst_ == WorstRegion::kDistortion) followDistortion(change);
}

void WorstRegions::followDistortion(const DiagramChange& change) {
  const Diagram& part = change.part;
  const auto add = [&](int face, int label, double area) {
    shares_[face].push_back({label, area * distortionOf(mesh_, distances_, label, face)});
  };
  for (const int f : change.faces) {
    shares_[f].clear();
    if (faceLabel_[f] >= 0) add(f, faceLabel_[f], mesh_.faceArea(f));
  }
  for (int c = 0; c < part.cells.size(); ++c)
    add(part.cellFace[c], part.cellLabel[c], areaOfCell(mesh_, part, c));

  std::vector<char> isChanged(regions_.size());
  for (const int label : change.labels) isChanged[label] = true;
  for (const std::vector<Share>& shares : shares_)
    for (const auto& [label, distortion] : shares)
      if (isChanged[label]) regions_[label].distortion += distortion;
  for (const int label : change.labels) {
    Region& region = regions_[label];
    if (region.distortion <= kFlatDistortion * region.area) region.distortion = 0;
  }
}

SurfacePoint WorstRegions::point() const {
  const auto unreached = std::find(faceLabel_.begin(), faceLabel_.end(), Diagram::kUnreachable);
  if (unreached != faceLabel_.end())
    return {static_cast<int>(unreached - faceLabel_.begin()), Eigen::Vector3d::Constant(1.0 / 3)};

  const auto worst =
      std::max_element(regions_.begin(), regions_.end(), [](const Region& a, const Region& b) {
        return std::pair(a.distortion, a.area) < std::pair(b.distortion, b.area);
      });
  const int label = static_cast<int>(worst - regions_.begin());
  SurfacePoint farthest;
  double most = -1;
  const auto offer = [&](const SurfacePoint& p, double distance) {
    if (!(distance > most)) return;
    most = distance;
    farthest = p;
  };
  for (int v = 0; v < mesh_.vertexCount(); ++v)
    if (const LabelledDistance d = nearestOf(distances_.at(v)); d.label == label)
      offer(pointAtVertex(mesh_, v), d.distance);
  const auto nearestAt = [&](int v) { return nearestOf(distances_.at(v)).distance; };
  for (const SurfacePoint& p : worst->outline)
    if (distanceOverCorners(mesh_, p, nearestAt) > most) offer(p, distances_.nearest(p).distance);
  return farthest;
}

namespace {

/// Inserts a site for the worst region, again and again.
class WorstFirstSampling final : public SlicedWork<std::vector<SurfacePoint>> {
 public:
  WorstFirstSampling(const TriangleMesh& mesh, int count, std::uint64_t seed, WorstRegion worst)
      : mesh_(mesh),
        count_(count),
        worst_(worst),
        points_(sampleUniform(mesh, std::min(count, 1), seed)) {}

  bool advance(long budget) override {
    return sequence_.run(
        [&] {
          if (count_ == 0) return true;
          if (!making_) making_ = DynamicDiagram::start(mesh_, points_);
          return making_->step(budget);
        },
        [&] {
          if (count_ == 0) return;
          diagram_ = making_->take();
          making_.reset();
          regions_.emplace(mesh_, diagram_->distances(), diagram_->diagram(), worst_);
        },
        [&] { return insertOthers(budget); });
  }
  double progress() const override {
    return count_ > 0 ? static_cast<double>(points_.size() - 1) / count_ : 1;
  }
  std::vector<SurfacePoint> result() override { return std::move(points_); }

 private:
  /// One site per step at the most, because finding its place takes O(F).
  bool insertOthers(long budget) {
    if (!insertion_) {
      if (isComplete()) return true;
      points_.push_back(regions_->point());
      insertion_ = diagram_->startInsert(points_.back());
    }
    if (!insertion_->step(budget)) return false;
    regions_->follow(insertion_->take());
    insertion_.reset();
    return isComplete();
  }

  bool isComplete() const { return static_cast<int>(points_.size()) == count_; }

  const TriangleMesh& mesh_;
  const int count_;
  const WorstRegion worst_;
  std::vector<SurfacePoint> points_;
  SlicedSequence sequence_;
  std::unique_ptr<SlicedWork<DynamicDiagram>> making_;
  std::optional<DynamicDiagram> diagram_;
  std::optional<WorstRegions> regions_;
  std::unique_ptr<SlicedWork<DiagramChange>> insertion_;
};

}  // namespace

std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startWorstFirst(const TriangleMesh& mesh,
                                                                       int count,
                                                                       std::uint64_t seed,
                                                                       WorstRegion worst) {
  return std::make_unique<WorstFirstSampling>(mesh, count, seed, worst);
}

std::vector<SurfacePoint> sampleWorstFirst(const TriangleMesh& mesh, int count, std::uint64_t seed,
                                           WorstRegion worst) {
  return finished(startWorstFirst(mesh, count, seed, worst));
}

}  // namespace gvd
