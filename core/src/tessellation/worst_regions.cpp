// SPDX-License-Identifier: MIT
//
// `WorstRegions`: the worst region of a diagram, also while sites change.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/index_set.h"
#include "base/plane.h"
#include "base/sliced_loop.h"
#include "diagram/given_diagram.h"
#include "distance/labelled_distances.h"
#include "distance/path_points.h"
#include "distance/site_distances.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/sampling.h"
#include "mesh/face_layout.h"
#include "mesh/face_metric.h"
#include "mesh/incidence.h"

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
  const double share = areaShare(points.size(), [&](std::size_t i) {
    return baryInFace(mesh, diagram.points[points[i]], face);
  });
  return std::max(0.0, share) * mesh.faceArea(face);
}

}  // namespace

WorstRegions::WorstRegions(const TriangleMesh& mesh, const DistanceField& distances,
                           WorstRegion worst)
    : mesh_(&mesh),
      distances_(&distances),
      worst_(worst),
      faceLabel_(mesh.faceCount(), Diagram::kUnreachable) {}

/// Makes the regions follow a change of the diagram, and finds the next point.
class WorstRegions::Update final : public SlicedSteps {
 public:
  /// Takes what has changed, as in a `DiagramChange`. All must outlive this.
  Update(WorstRegions& of, std::span<const int> labels, std::span<const int> faces,
         const Diagram& part)
      : of_(of), labels_(labels), faces_(faces), part_(part) {}

  bool advance(long budget) override {
    return sequence_.run(
        [&] { begin(); }, forEach(labels_, budget, 8, [&](int i) { clear(i); }),
        forEach(part_.loops.size(), budget, 1, [&](int i) { addOutline(i); }),
        forEach(faces_, budget, 4, [&](int i) { addShares(i); }),
        forEach(labels_, budget, 4, [&](int i) { sumUp(i); }), [&] { findWorst(); },
        [&](SlicedLoop& loop) {
          return loop.run(worst_->shares.size(), budget, 4,
                          [&](int i) { offerCorners(worst_->shares[i].face); });
        },
        [&](SlicedLoop& loop) {
          return loop.run(worst_->outline.size(), budget, kQuickRounds,
                          [&](int i) { return offerOutline(worst_->outline[i], budget); });
        });
  }
  double share() const override { return sequence_.progress(); }

 private:
  void begin() {
    const std::size_t count = labels_.empty() ? 0 : labels_.back() + 1;
    if (of_.regions_.size() < count) of_.regions_.resize(count);
    keptShares_.resize(labels_.size());
    changed_ = IndexSet(static_cast<int>(of_.regions_.size()), labels_);
  }

  /// Empties a region but for its shares in unchanged faces.
  void clear(int i) {
    Region& region = of_.regions_[labels_[i]];
    region = {part_.regionArea[i], 0, std::move(region.shares), {}};
    auto face = faces_.begin();
    const auto isOutdated = [&](const Share& share) {
      while (face != faces_.end() && *face < share.face) ++face;
      return face != faces_.end() && *face == share.face;
    };
    std::erase_if(region.shares, isOutdated);
    keptShares_[i] = region.shares.size();
  }

  void addOutline(int loop) {
    std::vector<SurfacePoint>& outline = of_.regions_[part_.loopLabel[loop]].outline;
    for (const int point : part_.loops[loop]) outline.push_back(part_.points[point]);
  }

  void addShares(int i) {
    const int face = faces_[i], label = part_.faceLabel[i];
    of_.faceLabel_[face] = label;
    if (label >= 0) addShare(face, label, of_.mesh_->faceArea(face));
    for (; nextCell_ < part_.cells.size() && part_.cellFace[nextCell_] == face; ++nextCell_)
      addShare(face, part_.cellLabel[nextCell_], areaOfCell(*of_.mesh_, part_, nextCell_));
  }

  void addShare(int face, int label, double area) {
    if (!changed_.contains(label)) return;
    const double distortion = of_.worst_ == WorstRegion::kDistortion
                                  ? area * distortionOf(*of_.mesh_, *of_.distances_, label, face)
                                  : 0;
    of_.regions_[label].shares.push_back({face, distortion});
  }

  void sumUp(int i) {
    Region& region = of_.regions_[labels_[i]];
    const auto added = region.shares.begin() + static_cast<std::ptrdiff_t>(keptShares_[i]);
    std::inplace_merge(region.shares.begin(), added, region.shares.end(),
                       [](const Share& a, const Share& b) { return a.face < b.face; });
    for (const Share& share : region.shares) region.distortion += share.distortion;
    if (region.distortion <= kFlatDistortion * region.area) region.distortion = 0;
  }

  /// Finds a face in a component without a site, otherwise the worst region.
  void findWorst() {
    const std::vector<int>& labels = of_.faceLabel_;
    const auto unreached = std::find(labels.begin(), labels.end(), Diagram::kUnreachable);
    if (unreached != labels.end())
      of_.point_ = {static_cast<int>(unreached - labels.begin()),
                    Eigen::Vector3d::Constant(1.0 / 3)};
    else
      worst_ = &*std::max_element(
          of_.regions_.begin(), of_.regions_.end(), [](const Region& a, const Region& b) {
            return std::pair(a.distortion, a.area) < std::pair(b.distortion, b.area);
          });
  }

  void offerCorners(int face) {
    const int label = static_cast<int>(worst_ - of_.regions_.data());
    for (const int v : of_.mesh_->face(face).vertices)
      if (const LabelledDistance d = nearestOf(of_.distances_->at(v)); d.label == label)
        offer(pointAtVertex(*of_.mesh_, v), d.distance);
  }

  /// Offers a point of the outline if it can be farther than the farthest one so far. Returns how
  /// many quick rounds it took, but for the search.
  long offerOutline(const SurfacePoint& p, long& budget) {
    constexpr long kRounds = 4, kRoundsOfSearch = 2 * kQuickRounds;
    const auto nearestAt = [&](int v) { return nearestOf(of_.distances_->at(v)).distance; };
    if (!(distanceOverCorners(*of_.mesh_, p, nearestAt) > most_)) return kRounds;
    offer(p, of_.distances_->nearest(p, budget).distance);
    return kRoundsOfSearch;
  }

  void offer(const SurfacePoint& p, double distance) {
    if (!(distance > most_)) return;
    most_ = distance;
    of_.point_ = p;
  }

  WorstRegions& of_;
  const std::span<const int> labels_, faces_;
  const Diagram& part_;
  SlicedSequence sequence_;
  IndexSet changed_{0};                  ///< the changed labels
  std::vector<std::size_t> keptShares_;  ///< per changed label, their number; new ones follow
  int nextCell_ = 0;
  const Region none_;
  const Region* worst_ = &none_;
  double most_ = -1;  ///< the distance of the farthest point so far
};

/// Begins with no regions, which then follow a change of all labels and faces.
std::unique_ptr<SlicedWork<WorstRegions>> WorstRegions::start(const TriangleMesh& mesh,
                                                              const DistanceField& distances,
                                                              const Diagram& diagram,
                                                              WorstRegion worst) {
  requireFaces(mesh, diagram);
  requireMesh(mesh, distances);
  struct Change {
    WorstRegions regions;
    std::vector<int> labels, faces;
  };
  std::unique_ptr<Change> change(new Change{WorstRegions(mesh, distances, worst),
                                            indicesBelow(diagram.siteCount),
                                            indicesBelow(mesh.faceCount())});
  auto update = std::make_unique<Update>(change->regions, change->labels, change->faces, diagram);
  return workOn(std::move(update), [change = std::move(change)](auto /*update*/) {
    return std::move(change->regions);
  });
}

WorstRegions::WorstRegions(const TriangleMesh& mesh, const DistanceField& distances,
                           const Diagram& diagram, WorstRegion worst)
    : WorstRegions(finished(start(mesh, distances, diagram, worst))) {}

std::unique_ptr<SlicedSteps> WorstRegions::startFollow(const DiagramChange& change) {
  return std::make_unique<Update>(*this, change.labels, change.faces, change.part);
}

void WorstRegions::follow(const DiagramChange& change) {
  const auto steps = startFollow(change);
  while (!steps->step(kUnlimited)) {
  }
}

}  // namespace gvd
