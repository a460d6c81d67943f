// SPDX-License-Identifier: MIT
//
// Repair of a dual: adds sites at its violations until there are none.
#include "partition/dual_repair.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "diagram/given_diagram.h"
#include "distance/site_distances.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/error.h"
#include "partition/dual_violations.h"
#include "partition/sharp_cones.h"

namespace gvd {
namespace {

// --- Sites of one round --------------------------------------------------------------------------

/// Where one site is to be added: at the one of these points that is farthest from the nearest
/// site.
struct Gap {
  std::vector<int> labels;  ///< of the regions that the points lie in; none for a single point
  std::vector<SurfacePoint> points;
};

/// The gap where a violation shows, or in a component without a site.
Gap gapAt(const TriangleMesh& mesh, const Partition& partition, const Finding& finding) {
  if (finding.bareFace >= 0) return {{}, {{finding.bareFace, Eigen::Vector3d::Constant(1.0 / 3)}}};
  Gap gap{finding.violation.labels, {}};
  for (const int t : finding.triangles) {
    // Three candidates per triangle, because the middle may be the place of a site.
    const Eigen::Matrix3d corners = cornersInFace(mesh, partition, t);
    const Eigen::Vector3d middle = corners.rowwise().mean();
    for (int i = 0; i < 3; ++i)
      gap.points.push_back({partition.triangleFace[t], (3 * middle + corners.col(i)) / 4});
  }
  return gap;
}

/// The gaps to fill in one round of the repair.
std::vector<Gap> gapsOf(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                        const Partition& partition, std::span<const Finding> findings) {
  std::vector<Gap> gaps;
  std::vector<char> isTouched(partition.regions.size());  // regions that a new site may change
  for (const Finding& finding : findings) {
    const Violation& violation = finding.violation;
    const std::vector<int>& labels = violation.labels;
    if (violation.kind == Violation::kNoRegion) rejectArgument(violation.message);
    if (violation.kind == Violation::kNoManifold) throw std::logic_error(violation.message);
    if (std::any_of(labels.begin(), labels.end(), [&](int label) { return isTouched[label]; }))
      continue;
    const auto aroundCone = sitesAroundCone(mesh, sites, partition, violation);
    for (const SurfacePoint& p : aroundCone) gaps.push_back({{}, {p}});
    if (aroundCone.empty()) gaps.push_back(gapAt(mesh, partition, finding));
    for (const int label : labels) {
      isTouched[label] = true;
      for (const auto& n : partition.regions[label].neighbours) isTouched[n.label] = true;
    }
  }
  return gaps;
}

/// Finds the sites that fill the gaps. The distances at the points of all of them are requested at
/// once: on long faces there are many points, and the path of each to its site crosses many faces.
class GapFilling final : public SlicedWork<std::vector<SurfacePoint>> {
 public:
  GapFilling(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, const Diagram& diagram,
             const DistanceField& field)
      : mesh_(mesh),
        sites_(sitesOf(mesh, diagram, sites)),
        diagram_(diagram),
        field_(field),
        regions_(mesh, diagram) {}

  bool advance(long budget) override {
    return sequence_.run(
        [&] { return regions_.step(budget); },
        [&] { return runPart(finding_, budget, mesh_, sites_, diagram_, regions_.complex()); },
        [&] {
          const std::vector<Finding> findings = finding_->takeFindings();
          if (!findings.empty()) firstViolation_ = findings.front().violation.message;
          gaps_ = gapsOf(mesh_, sites_, regions_.complex().partition, findings);
          startDistances();
        },
        [&] { return distances_->step(budget); });
  }
  double share() const override {
    return distances_ ? (1 + distances_->progress()) / 2 : regions_.progress() / 2;
  }

  std::vector<SurfacePoint> result() override {
    const std::vector<double> distances = distances_->take();
    auto next = distances.begin();
    std::vector<SurfacePoint> sites;
    for (const Gap& gap : gaps_) {
      sites.push_back(gap.points.front());
      double most = -1;
      for (const SurfacePoint& p : gap.points) {
        double nearest = kInfinity;
        for (size_t i = 0; i < gap.labels.size(); ++i) nearest = std::min(nearest, *next++);
        if (nearest <= most || nearest == kInfinity) continue;
        most = nearest;
        sites.back() = p;
      }
    }
    return sites;
  }

  /// The message of the first violation, once the work is done.
  const std::string& firstViolation() const { return firstViolation_; }

 private:
  void startDistances() {
    std::vector<LabelledPoint> points;
    for (const Gap& gap : gaps_)
      for (const SurfacePoint& p : gap.points)
        for (const int label : gap.labels) points.push_back({label, p});
    distances_ = field_.startDistancesAt(std::move(points));
  }

  const TriangleMesh& mesh_;
  const std::vector<SurfacePoint> sites_;
  const Diagram& diagram_;
  const DistanceField& field_;
  SlicedSequence sequence_;
  RegionComplexBuilding regions_;
  std::optional<ViolationFinding> finding_;
  std::string firstViolation_;  ///< empty if there are no violations
  std::vector<Gap> gaps_;
  std::unique_ptr<SlicedWork<std::vector<double>>> distances_;
};

}  // namespace

std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startRepairingSites(
    const TriangleMesh& mesh, std::span<const SurfacePoint> sites, const Diagram& diagram,
    const DistanceField& field) {
  requireMesh(mesh, field);
  return std::make_unique<GapFilling>(mesh, sites, diagram, field);
}

std::vector<SurfacePoint> repairingSites(const TriangleMesh& mesh,
                                         std::span<const SurfacePoint> sites,
                                         const Diagram& diagram, const DistanceField& field) {
  return finished(startRepairingSites(mesh, sites, diagram, field));
}

// --- Rounds --------------------------------------------------------------------------------------

void requireMaxAdded(int count) {
  if (count < 0)
    rejectArgument("maxAdded is " + std::to_string(count) + ", not a number of 0 or more");
}

namespace {

/// Repairs in rounds: joins the diagram, finds sites to add, and inserts them.
class Repairing final : public SlicedWork<RepairedSites> {
 public:
  Repairing(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric,
            const RepairOptions& options)
      : mesh_(mesh),
        most_(options.maxAdded),
        opening_(DynamicDiagram::start(mesh, sites, metric, options.diagram)) {
    requireMaxAdded(most_);
  }

  bool advance(long budget) override {
    if (!dynamic_) {
      if (!opening_->step(budget)) return false;
      dynamic_.emplace(opening_->take());
      beginRound();
      return false;
    }
    if (!round_.runRound([&] { return joining_->step(budget); }, [&] { startFinding(); },
                         [&] { return find(budget); }, [&] { takeFound(); },
                         [&] { return insert(budget); }))
      return false;
    if (found_.empty()) return true;
    share_ = shareAfterRound();
    beginRound();
    return false;
  }

  /// The number of rounds is not known: each counts as half of what is left.
  double share() const override {
    if (!dynamic_) return share_ * opening_->progress();
    return share_ + (shareAfterRound() - share_) * (change_ ? change_->progress() : 0);
  }
  RepairedSites result() override { return std::move(repaired_); }

 private:
  double shareAfterRound() const { return (1 + share_) / 2; }

  void beginRound() {
    found_.clear();
    change_.reset();
    joining_ = dynamic_->startDiagram();
  }

  void startFinding() {
    repaired_ = {dynamic_->sites(), repaired_.added, joining_->take()};
    joining_.reset();
    finding_ = std::make_unique<GapFilling>(mesh_, repaired_.sites, repaired_.diagram,
                                            dynamic_->distances());
  }

  /// The first round refuses given sites without region. Later ones come upon added sites: along an
  /// edge that is cut, for example, a diagram may mistake one side for the other, and sites are
  /// added between the same two over and over.
  bool find(long budget) {
    try {
      return finding_->step(budget);
    } catch (const Error& error) {
      if (repaired_.added == 0) throw;
      throw Error(
          ErrorCode::kTooFewSites,
          "more sites do not make the dual valid, perhaps because triangles are too long: " +
              std::string(error.what()));
    }
  }

  void takeFound() {
    found_ = finding_->take();
    const int count = static_cast<int>(found_.size());
    if (count > most_ - repaired_.added)
      throw Error(ErrorCode::kTooFewSites,
                  "the dual is not valid with as many sites as may be added, perhaps because "
                  "triangles are too long: " +
                      finding_->firstViolation());
    repaired_.added += count;
  }

  bool insert(long budget) {
    if (found_.empty()) return true;
    if (!change_) change_ = dynamic_->startInsert(found_);
    return change_->step(budget);
  }

  const TriangleMesh& mesh_;
  const int most_;
  std::unique_ptr<SlicedWork<DynamicDiagram>> opening_;
  std::optional<DynamicDiagram> dynamic_;
  RepairedSites repaired_;  ///< before the sites of this round
  SlicedSequence round_;
  std::unique_ptr<SlicedWork<Diagram>> joining_;
  std::unique_ptr<GapFilling> finding_;
  std::vector<SurfacePoint> found_;  ///< sites to be inserted in this round
  std::unique_ptr<SlicedWork<DiagramChange>> change_;
  double share_ = 0.5;  ///< of the work up to this round
};

}  // namespace

std::unique_ptr<SlicedWork<RepairedSites>> startRepair(const TriangleMesh& mesh,
                                                       std::span<const SurfacePoint> sites,
                                                       Metric metric,
                                                       const RepairOptions& options) {
  return std::make_unique<Repairing>(mesh, sites, metric, options);
}

RepairedSites repair(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric,
                     const RepairOptions& options) {
  return finished(startRepair(mesh, sites, metric, options));
}

}  // namespace gvd
