// SPDX-License-Identifier: MIT
#include "distance/site_distances.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "distance/dgpc/unfolding_spread.h"
#include "distance/exact/window_spread.h"
#include "gvd/error.h"
#include "mesh/given_points.h"
#include "mesh/incidence.h"

namespace gvd {
namespace {

std::unique_ptr<LabelSpread> makeSpread(const TriangleMesh& mesh, Metric metric,
                                        const SiteSet& sites, NearestBounds& bounds) {
  if (metric == Metric::kDgpc) return std::make_unique<dgpc::UnfoldingSpread>(mesh, sites, bounds);
  return std::make_unique<exact::WindowSpread>(mesh, sites, bounds);
}

/// The place of a point on a curve through a cube that passes through each of its eighths in turn,
/// and so on in these (Morton order). `p` has coordinates from -1 to 1.
int placeOnCurve(const Eigen::Vector3d& p) {
  constexpr int kBits = 10;
  const Eigen::Array3i cell = ((p.array() + 1) * ((1 << (kBits - 1)) - 0.5)).cast<int>();
  int place = 0;
  for (int bit = kBits - 1; bit >= 0; --bit)
    for (const int coordinate : cell) place = place << 1 | (coordinate >> bit & 1);
  return place;
}

std::vector<SiteChange> insertionsOf(std::span<const SurfacePoint> sites) {
  std::vector<SiteChange> changes;
  for (size_t label = 0; label < sites.size(); ++label)
    if (sites[label].face != -1) changes.push_back({static_cast<int>(label), sites[label]});
  return changes;
}

}  // namespace

// Not inlined, as the WebAssembly module would be larger.
[[gnu::noinline]] void requireMesh(const TriangleMesh& mesh, const DistanceField& distances) {
  const auto* const own = dynamic_cast<const SiteDistances*>(&distances);
  if (own && &own->mesh() != &mesh)
    throw Error(ErrorCode::kInvalidArgument, "the distances are those of another mesh");
}

SiteDistances::SiteDistances(const TriangleMesh& mesh, Metric metric,
                             std::span<const SurfacePoint> sites)
    : mesh_(mesh),
      given_(mesh),
      sites_(mesh),
      edgeBounds_(mesh, sites_),
      bounds_(mesh),
      spread_(makeSpread(mesh, metric, sites_, bounds_)),
      reaching_(mesh.vertexCount()),
      lowering_(mesh, *spread_, edgeBounds_, bounds_, change_),
      known_(mesh, sites_, bounds_, *spread_, change_),
      forgottenAt_(mesh.vertexCount()) {
  change(insertionsOf(sites));
}

// --- A change ----------------------------------------------------------------------------------

void SiteDistances::change(std::span<const SiteChange> changes) {
  given_.change(changes);
  change_ = {};
  resumed_ = outdated_ = IndexSet(sites_.labelCount());
  lowering_.beginChange();
  forgottenAt_.clear();
  known_.beginChange();
  for (const SiteChange& c : changes) known_.noteChanged(c.label);
  sequence_ = {};
}

bool SiteDistances::step(long& budget) {
  const std::vector<SiteChange>& changes = given_.changes();
  return sequence_.run(
      [&] {
        return given_.prepare(budget) && sites_.prepare(budget) && edgeBounds_.prepare(budget) &&
               bounds_.prepare(budget) && spread_->prepare(budget) && known_.prepare(budget);
      },
      [&] {
        return sites_.count() == 0 || reaching_.collect(*spread_, sites_.labelCount(), budget);
      },
      [&] { return given_.step(sites_, budget); },
      // 1. Bounds, and which labels start or resume because of them.
      [&] { findLeaving(); }, [&] { return forget(budget); },
      forItems(forgotten_, budget, kSitesPerUnit, [&](int label) { removeSite(label); }),
      [&] { return edgeBounds_.forget(budget); },
      forItems(changes, budget, kSitesPerUnit, [&](const SiteChange& c) { insertSite(c); }),
      [&] { return edgeBounds_.step(budget); },
      [&](SlicedLoop& loop) { return findOutdated(loop, budget); }, [&] { return forget(budget); },
      forItems(change_.started, budget, kSitesPerUnit, [&](int label) { placeStarted(label); }),
      [&] { orderLabels(); },
      // 2. Spread.
      [&] { return lowering_.step(budget); },
      // 3. Known labels.
      [&] { return known_.step(budget); });
}

/// Finds the labels that lose their sites.
void SiteDistances::findLeaving() {
  forgotten_.clear();
  for (const SiteChange& c : given_.changes())
    if (sites_.contains(c.label)) forgotten_.push_back(c.label);
}

/// Forgets the distances of the labels in `forgotten_`, in slices; true when done.
bool SiteDistances::forget(long& budget) {
  return forgetting_.runRound(
      [&] {
        for (const int label : forgotten_) known_.noteLeaving(label);
      },
      [&] {
        return reachedLoop_.run(*spread_, forgotten_, budget,
                                [&](int label, int /*i*/, const ReachedVertex& r) {
                                  if (r.isFinal) forgetAt(label, r);
                                });
      },
      [&] { return reaching_.remove(*spread_, forgotten_, budget); },
      [&] { spread_->remove(forgotten_); });
}

/// Forgets the distance of a label at a vertex. Other labels that have reached the vertex may have
/// stopped there, because it was nearer; they are resumed.
void SiteDistances::forgetAt(int label, const ReachedVertex& r) {
  known_.noteLeavingFrom(r.vertex, label);
  // Once per vertex, even if all labels reach it and all are forgotten.
  if (forgottenAt_.add(r.vertex))
    for (const int other : reaching_[r.vertex]) resumed_.add(other);
  LabelledDistance& nearest = bounds_[r.vertex];
  if (nearest.label < 0 || !bounds_.ties().isAtMost(r.distance, nearest.distance)) return;
  nearest = {};
  change_.resetVertices.push_back(r.vertex);
}

void SiteDistances::removeSite(int label) {
  const SurfacePoint site = sites_[label];
  sites_.remove(label);
  edgeBounds_.remove(label, site);
}

void SiteDistances::insertSite(const SiteChange& c) {
  if (!c.site) return;
  sites_.insert(c.label, *c.site);
  edgeBounds_.insert(c.label);
  change_.started.push_back(c.label);
}

/// Finds the labels that have reached a vertex whose edge bound has changed, if their distances
/// depend on it: these start again.
bool SiteDistances::findOutdated(SlicedLoop& loop, long& budget) {
  constexpr long kVerticesPerUnit = 8;
  if (spread_->dependsOnEdgeBounds() && sites_.count() > static_cast<int>(change_.started.size())) {
    const std::vector<int>& changed = edgeBounds_.changed().list();
    if (!loop.run(changed.size(), budget, kVerticesPerUnit, [&](int i) {
          for (const int label : reaching_[changed[i]]) outdated_.add(label);
        }))
      return false;
  }
  forgotten_ = outdated_.sorted();
  change_.started.insert(change_.started.end(), forgotten_.begin(), forgotten_.end());
  return true;
}

double SiteDistances::progress() const {
  constexpr double kShareOfSpread = 0.6;
  return kShareOfSpread * lowering_.progress() + (1 - kShareOfSpread) * known_.progress();
}

void SiteDistances::placeStarted(int label) {
  const Eigen::Vector3d fromVertex = mesh_.position(sites_[label]) - mesh_.position(0);
  startedPlaces_.push_back({placeOnCurve(fromVertex / mesh_.boundingDiagonal()), label, label});
}

/// Puts neighbouring labels in succession, so that the memory they touch is still in the cache.
/// Labels that start do not resume, too.
void SiteDistances::orderLabels() {
  std::sort(startedPlaces_.begin(), startedPlaces_.end());
  std::transform(startedPlaces_.begin(), startedPlaces_.end(), change_.started.begin(),
                 [](const KeyedItem& place) { return place.back(); });
  release(startedPlaces_);
  change_.hasStarted.assign(sites_.labelCount(), false);
  for (const int label : change_.started) change_.hasStarted[label] = true;
  change_.startsAll = sites_.count() == static_cast<int>(change_.started.size());
  change_.resumed = resumed_.sorted();
  std::erase_if(change_.resumed,
                [&](int label) { return !sites_.contains(label) || change_.hasStarted[label]; });
}

// --- Queries -----------------------------------------------------------------------------------

LabelledDistance SiteDistances::nearest(const SurfacePoint& given, long& budget) const {
  const SurfacePoint p = onMesh(mesh_, given);
  if (const int v = vertexAt(mesh_, p); v >= 0) return nearestOf(at(v));
  LabelledDistance best;
  bool isBestKnown = false;
  for (const auto& [label, distance] : spread_->nearestAt(p, *this, budget)) {
    if (!(bounds_.ties().isAtMost(distance, best.distance) && distance < kInfinity)) continue;
    // Of labels that tie, prefer those known around the point, then the lowest.
    const bool isKnown = isKnownAround(label, p);
    const bool isTie = bounds_.ties().isAtMost(best.distance, distance);
    if (!isTie || isKnown > isBestKnown || (isKnown == isBestKnown && label < best.label)) {
      best.label = label;
      isBestKnown = isKnown;
    }
    best.distance = std::min(best.distance, distance);
  }
  return best;
}

/// Whether a label is known at the corners of the face, or of the side, that has the point.
bool SiteDistances::isKnownAround(int label, const SurfacePoint& p) const {
  for (int i = 0; i < 3; ++i)
    if (p.bary[i] > 0 && known_.lists().distance(mesh_.tail(3 * p.face + i), label) == kInfinity)
      return false;
  return true;
}

double SiteDistances::distance(int label, const SurfacePoint& p) const {
  if (const LabelledDistance there = nearest(p); there.label == label) return there.distance;
  return distancesAt({{label, p}})[0];
}

/// Distances at vertices come from the lists, at other points from the spread.
class SiteDistances::DistancesAtPoints final : public SequentialWork<std::vector<double>> {
 public:
  DistancesAtPoints(const SiteDistances& field, std::vector<LabelledPoint> points)
      : field_(field), points_(std::move(points)) {}

  bool advance(long budget) override {
    return sequence_.run(
        [&] { out_.reserve(points_.size()); },
        forEach(points_, budget, kQuickRounds, [&](int i) { return sortOut(i, budget); }),
        [&] {
          points_.resize(open_.size());
          atPoints_ = field_.spread_->startDistancesAt(std::move(points_), field_);
        },
        [&] { return atPoints_->step(budget); }, [&] { found_ = atPoints_->take(); },
        forEach(open_, budget, kQuickRounds, [&](int i) { out_[open_[i]] = found_[i]; }));
  }
  double share() const override { return atPoints_ ? atPoints_->progress() : 0; }

 private:
  /// Moves the points that are left to the spread to the front of the list. Returns how many quick
  /// rounds it took, but for a search.
  long sortOut(int i, long& budget) {
    const int label = points_[i].label;
    const SurfacePoint p = onMesh(field_.mesh_, points_[i].point);
    const int v = vertexAt(field_.mesh_, p);
    out_.push_back(v >= 0 ? field_.known_.lists().distance(v, label) : kInfinity);
    if (v >= 0) return 1;
    if (field_.isKnownAround(label, p)) {
      points_[open_.size()] = {label, p};
      open_.push_back(i);
      return 1;
    }
    const LabelledDistance there = field_.nearest(p, budget);
    if (there.label == label) out_.back() = there.distance;
    return kQuickRounds;
  }

  const SiteDistances& field_;
  std::vector<LabelledPoint> points_;
  std::vector<int> open_;  ///< the indices of the points that are left to the spread
  std::unique_ptr<SlicedWork<std::vector<double>>> atPoints_;
  std::vector<double> found_;  ///< by the spread
};

std::unique_ptr<SlicedWork<std::vector<double>>> SiteDistances::startDistancesAt(
    std::vector<LabelledPoint> points) const {
  return std::make_unique<DistancesAtPoints>(*this, std::move(points));
}

Eigen::Vector2d SiteDistances::direction(int label, int vertex) const {
  const int index = known_.lists().reachedIndex(vertex, label);
  if (index < 0) return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  return spread_->direction(label, index);
}

std::vector<SurfacePoint> SiteDistances::path(int label, const SurfacePoint& given) const {
  const SurfacePoint p = onMesh(mesh_, given);
  if (!sites_.contains(label)) return {};
  const bool isKnown = isKnownAround(label, p) || nearest(p).label == label;
  return isKnown ? spread_->path(label, p) : shortestPath(mesh_, p, sites_[label]);
}

}  // namespace gvd
