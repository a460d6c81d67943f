// SPDX-License-Identifier: MIT
//
// Remeshing: sites move to the centroids of their regions, and more are added for a valid dual.
#include "gvd/remesh.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/error.h"
#include "partition/dual_building.h"
#include "partition/dual_repair.h"
#include "partition/dual_violations.h"
#include "partition/remesh_quality.h"

namespace gvd {
namespace {

/// The sites that were added last take at most so many steps towards their centroids.
constexpr int kMostSettlings = 5;

/// The labels that have a site now, and had none before.
std::vector<int> labelsAdded(std::span<const SurfacePoint> before,
                             std::span<const SurfacePoint> now) {
  std::vector<int> added;
  for (std::size_t label = 0; label < now.size(); ++label)
    if (now[label].face >= 0 && !(label < before.size() && before[label].face >= 0))
      added.push_back(static_cast<int>(label));
  return added;
}

/// The sites of the last iteration of a tessellation and their diagram.
RepairedSites stateOf(const Cvt& cvt, int added) {
  return {{cvt.sites().begin(), cvt.sites().end()}, added, *cvt.diagram()};
}

/// Moves some sites towards the centroids of their regions, a step of Lloyd's method at a time, as
/// long as the dual stays valid and its least angle grows. Steps of all sites would soon break the
/// dual, and so may these: a site of a violation then stays where it is, and the others try again.
class Settling final : public SlicedWork<RepairedSites> {
 public:
  Settling(const TriangleMesh& mesh, RepairedSites valid, std::span<const int> labels,
           CvtOptions tessellation)
      : mesh_(mesh),
        kept_(std::move(valid)),
        movable_(labels.begin(), labels.end()),
        tessellation_(std::move(tessellation)) {
    tessellation_.method = CvtMethod::kLloyd;
    tessellation_.iterations = 1;
  }

  bool advance(long budget) override {
    return movable_.empty() ||
           sequence_.run([&] { return runPart(regions_, budget, mesh_, kept_.diagram); },
                         [&] { return measureAngle(kept_, budget); },
                         [&] {
                           keptAngle_ = quality_->take().minAngle;
                           regions_.reset();
                         },
                         [&] { return takeStep(budget) && isOver_; });
  }
  double share() const override { return (stepCount_ + step_.progress()) / kMostSettlings; }
  RepairedSites result() override { return std::move(kept_); }

 private:
  bool isMovable(int label) const {
    return std::binary_search(movable_.begin(), movable_.end(), label);
  }

  CvtOptions optionsOfStep() const {
    CvtOptions options = tessellation_;
    options.fixedSites.clear();
    for (int label = 0; label < static_cast<int>(kept_.sites.size()); ++label)
      if (kept_.sites[label].face >= 0 && !isMovable(label)) options.fixedSites.push_back(label);
    return options;
  }

  bool takeStep(long budget) {
    return step_.runRound([&] { cvt_.emplace(mesh_, kept_.sites, optionsOfStep()); },
                          [&] {
                            cvt_->step(budget);
                            return cvt_->isDone();
                          },
                          [&] { moved_ = stateOf(*cvt_, kept_.added); },
                          [&] { return runPart(regions_, budget, mesh_, moved_.diagram); },
                          [&] {
                            return runPart(finding_, budget, mesh_, moved_.sites, moved_.diagram,
                                           regions_->complex());
                          },
                          [&] {
                            findings_ = finding_->takeFindings();
                            finding_.reset();
                          },
                          [&] { return !findings_.empty() || measureAngle(moved_, budget); },
                          [&] {
                            judge();
                            regions_.reset();
                          });
  }

  /// Measures the least angle of the dual of sites whose regions are there.
  bool measureAngle(const RepairedSites& of, long budget) {
    return measuring_.runRound(
        [&] { return runPart(building_, budget, mesh_, of.sites, regions_->complex()); },
        [&] {
          dual_ = taken(building_);
          quality_ = startTriangleQuality(dual_);
        },
        [&] { return quality_->step(budget); });
  }

  /// Keeps the moved sites if their dual is valid and better than the one before. The sites of
  /// violations must not move any more; if none of them has moved, the next step would be the same.
  void judge() {
    const double angle = findings_.empty() ? quality_->take().minAngle : 0;
    isOver_ = angle <= keptAngle_;
    if (!isOver_) {
      kept_ = std::move(moved_);
      keptAngle_ = angle;
    }
    for (const Finding& finding : findings_)
      for (const int label : finding.violation.labels)
        if (std::erase(movable_, label) > 0) isOver_ = false;
    if (++stepCount_ == kMostSettlings) isOver_ = true;
  }

  const TriangleMesh& mesh_;
  RepairedSites kept_, moved_;
  std::vector<int> movable_;  ///< labels, ascending
  CvtOptions tessellation_;
  SlicedSequence sequence_, step_;
  int stepCount_ = 0;
  std::optional<Cvt> cvt_;
  std::optional<RegionComplexBuilding> regions_;  ///< of `kept_`, then of `moved_`
  std::optional<ViolationFinding> finding_;
  std::vector<Finding> findings_;  ///< about `moved_`
  SlicedSequence measuring_;
  std::optional<DualBuilding> building_;
  PolygonMesh dual_;
  std::unique_ptr<SlicedWork<RemeshQuality>> quality_;  ///< of the dual
  double keptAngle_ = 0;                                ///< the least of the dual of `kept_`
  bool isOver_ = false;
};

/// Tessellates and repairs in rounds, then settles the sites that the last round added.
class Remeshing final : public SlicedWork<RepairedSites> {
 public:
  Remeshing(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
            const RemeshOptions& options)
      : mesh_(mesh),
        options_(options),
        sites_(sites.begin(), sites.end()),
        most_(options.maxAdded) {
    requireMaxAdded(most_);
    cvt_.emplace(mesh_, sites_, options_.tessellation);
  }

  bool advance(long budget) override {
    if (settling_) return settling_->step(budget);
    if (!round_.runRound([&] { return tessellate(budget); },
                         [&] {
                           sites_.assign(cvt_->sites().begin(), cvt_->sites().end());
                           repairing_ = startRepair(
                               mesh_, sites_, options_.tessellation.metric,
                               {.maxAdded = std::min(most_, options_.maxAdded - added_)});
                         },
                         [&] { return repair(budget); }))
      return false;
    iterationShare_ = 0;
    if (isLastRound_ || ++roundCount_ == kMostRounds)
      settling_.emplace(mesh_, std::move(*kept_), last_, options_.tessellation);
    else
      cvt_.emplace(mesh_, sites_, options_.tessellation);
    return false;
  }

  double share() const override {
    if (settling_) return (kMostRounds + settling_->progress()) / (kMostRounds + 1);
    constexpr double kTessellationShare = 0.8;  // roughly, in the time of a round
    const double ofRound =
        repairing_ ? kTessellationShare + (1 - kTessellationShare) * repairing_->progress()
                   : kTessellationShare * iterationShare_;
    return (roundCount_ + ofRound) / (kMostRounds + 1);
  }
  RepairedSites result() override {
    RepairedSites remeshed = settling_->take();
    remeshed.added = added_;
    return remeshed;
  }

 private:
  /// More than one, because sites just added are not at centroids yet.
  static constexpr int kMostRounds = 3;

  bool tessellate(long budget) {
    if (cvt_->step(budget))
      iterationShare_ = (1.0 + cvt_->iteration().number) / (1 + options_.tessellation.iterations);
    return cvt_->isDone();
  }

  /// Adds sites for a valid dual. If a round needs too many, the one before has the result.
  bool repair(long budget) {
    try {
      if (!repairing_->step(budget)) return false;
    } catch (const Error& error) {
      if (!kept_ || error.code() != ErrorCode::kTooFewSites) throw;
      isLastRound_ = true;
      return true;
    }
    endRound(repairing_->take());
    repairing_.reset();
    return true;
  }

  void endRound(RepairedSites repaired) {
    last_ = labelsAdded(sites_, repaired.sites);
    const int count = static_cast<int>(last_.size());
    most_ = count / 2;
    added_ += count;
    sites_ = repaired.sites;
    isLastRound_ = count == 0;
    kept_ = std::move(repaired);
  }

  const TriangleMesh& mesh_;
  const RemeshOptions options_;
  std::vector<SurfacePoint> sites_;
  int most_;  ///< how many sites this round may add, if so many are left
  int added_ = 0, roundCount_ = 0;
  SlicedSequence round_;
  std::optional<Cvt> cvt_;
  double iterationShare_ = 0;  ///< of this round
  std::unique_ptr<SlicedWork<RepairedSites>> repairing_;
  std::optional<RepairedSites> kept_;  ///< after the last round
  std::vector<int> last_;              ///< labels of the sites that the last round added
  bool isLastRound_ = false;           ///< whether no further round is needed, or helps
  std::optional<Settling> settling_;
};

}  // namespace

std::unique_ptr<SlicedWork<RepairedSites>> startRemesh(const TriangleMesh& mesh,
                                                       std::span<const SurfacePoint> sites,
                                                       const RemeshOptions& options) {
  return std::make_unique<Remeshing>(mesh, sites, options);
}

RepairedSites remesh(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                     const RemeshOptions& options) {
  return finished(startRemesh(mesh, sites, options));
}

}  // namespace gvd
