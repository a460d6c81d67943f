// SPDX-License-Identifier: MIT
#include "distance/exact/point_distances.h"

#include <algorithm>
#include <utility>

#include "distance/path_points.h"
#include "mesh/incidence.h"

namespace gvd::exact {
namespace {

/// Points that take about as long to look at as one unit of the budget.
constexpr long kPointsPerUnit = 4;

/// One representation for a point on an edge, whichever face it is given in.
SurfacePoint unique(const TriangleMesh& mesh, const SurfacePoint& p) {
  SurfacePoint least = p;
  visitRepresentations(mesh, p, [&](const SurfacePoint& place) {
    if (place.face < least.face) least = place;
  });
  return least;
}

}  // namespace

// --- What has been found -----------------------------------------------------------------------

double FoundDistances::find(const LabelledPoint& p) const {
  if (p.label >= static_cast<int>(ofLabel_.size())) return kInfinity;
  const auto found = ofLabel_[p.label].find(p.point);
  return found == ofLabel_[p.label].end() ? kInfinity : found->second;
}

void FoundDistances::add(const LabelledPoint& p, double distance) {
  if (p.label >= static_cast<int>(ofLabel_.size())) ofLabel_.resize(p.label + 1);
  ofLabel_[p.label].emplace(p.point, distance);
}

void FoundDistances::remove(int label) {
  if (label < static_cast<int>(ofLabel_.size())) ofLabel_[label].clear();
}

// --- What has not ------------------------------------------------------------------------------

PointDistances::PointDistances(const TriangleMesh& mesh, const SiteSet& sites,
                               NearestBounds& bounds, FoundDistances& found,
                               std::unique_ptr<WindowSweep>& spare,
                               std::vector<LabelledPoint> points)
    : mesh_(mesh),
      sites_(sites),
      bounds_(bounds),
      found_(found),
      points_(std::move(points)),
      spare_(spare) {}

bool PointDistances::advance(long budget) {
  return sequence_.run([&] { distances_.reserve(points_.size()); },
                       forEach(points_, budget, kPointsPerUnit, [&](int i) { sortOut(i); }),
                       [&] { points_.resize(open_.size()); },
                       [&] {
                         return byLabel_.run(
                             static_cast<int>(points_.size()), sites_.labelCount(),
                             [&](int i) { return points_[i].label; }, budget);
                       },
                       [&] { return spread(budget); });
}

/// Moves the points without a distance to the front of the list.
void PointDistances::sortOut(int index) {
  const auto& [label, p] = points_[index];
  const LabelledPoint at = {label, unique(mesh_, p)};
  distances_.push_back(found_.find(at));
  if (distances_.back() < kInfinity) return;
  points_[open_.size()] = at;
  open_.push_back(index);
}

std::vector<double> PointDistances::result() {
  // Only now: in the working memory of a work that is given up there are windows.
  if (sweep_) spare_ = std::move(sweep_);
  return std::move(distances_);
}

bool PointDistances::spread(long& budget) {
  if (!open_.empty() && !sweep_)
    sweep_ = spare_ ? std::move(spare_) : std::make_unique<WindowSweep>(mesh_, sites_, bounds_);
  if (sweep_ && !sweep_->prepare(budget)) return false;
  for (; doneCount_ < open_.size(); ++label_)
    if (!spreadOne(budget)) return false;
  return true;
}

/// Spreads the current label to its open points, if it has any.
bool PointDistances::spreadOne(long& budget) {
  const std::span<const int> open = byLabel_.items(label_);
  if (open.empty()) return true;
  const auto forPoints = [&](auto body) { return forEach(open, budget, kPointsPerUnit, body); };
  return turn_.runRound(
      [&] {
        state_ = {};
        required_.clear();
      },
      forPoints([&](int i) { addRequired(open[i]); }),
      [&] { sweep_->start(label_, state_, required_); }, [&] { return sweep_->step(budget); },
      forPoints([&](int i) { required_[i].distance = sweep_->distanceAtPoint(i); }),
      [&] { sweep_->require(label_, state_, required_); }, [&] { return sweep_->step(budget); },
      forPoints([&](int i) { keep(open[i], sweep_->distanceAtPoint(i)); }));
}

double PointDistances::share() const {
  if (open_.empty()) return sequence_.progress();
  return static_cast<double>(doneCount_) / static_cast<double>(open_.size());
}

void PointDistances::addRequired(int open) {
  const SurfacePoint& p = points_[open].point;
  required_.push_back({p, lengthBetween(mesh_, p, sites_[label_]), nearestAtLeast(p)});
}

void PointDistances::keep(int open, double distance) {
  distances_[open_[open]] = distance;
  found_.add(points_[open], distance);
  ++doneCount_;
}

/// No label is nearer to a point than this, by the distances at the corners of its face.
double PointDistances::nearestAtLeast(const SurfacePoint& p) const {
  const TriangleMesh::Face& face = mesh_.face(p.face);
  double nearest = 0;
  for (int i = 0; i < 3; ++i)
    nearest =
        std::max(nearest, bounds_[face.vertices[i]].distance - distanceToCorner(face, p.bary, i));
  return nearest;
}

}  // namespace gvd::exact
