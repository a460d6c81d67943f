// SPDX-License-Identifier: MIT
//
// What is read off the partition of a mesh, for JavaScript: the partition itself; the dual, its
// violations, its quality and its repair.

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gvd/dual.h"
#include "gvd/partition.h"
#include "gvd/remesh.h"
#include "objects.h"
#include "records.h"

namespace gvd::abi {
namespace {

constexpr Named<Violation::Kind> kViolationKinds[] = {
    {"unreachable", Violation::kUnreachable},
    {"no-region", Violation::kNoRegion},
    {"few-runs", Violation::kFewRuns},
    {"closed-border", Violation::kClosedBorder},
    {"no-disk", Violation::kNoDisk},
    {"touches-itself", Violation::kTouchesItself},
    {"two-meet-twice", Violation::kTwoMeetTwice},
    {"three-meet-twice", Violation::kThreeMeetTwice},
    {"no-manifold", Violation::kNoManifold},
};

/// `Partition`.
class PartitionRecording final : public SlicedWork<Record> {
 public:
  PartitionRecording(DiagramOnMesh on, const PartitionOptions& options)
      : on_(std::move(on)), work_(startPartition(*on_.mesh, *on_.diagram, options)) {}

  bool advance(long budget) override {
    if (work_) {
      if (!work_->step(budget)) return false;
      partition_ = work_->take();
      work_.reset();
      corners_.reserve(3 * partition_.triangles.size());
    }
    constexpr int kTrianglesPerUnit = 4;
    const int count = static_cast<int>(partition_.triangles.size());
    const long most = budget < count ? budget * kTrianglesPerUnit : count;
    for (const long end = std::min<long>(count, next_ + most); next_ < end; ++next_) addCorners();
    if (next_ < count) return false;
    if (!points_) points_.emplace(*on_.mesh, partition_.points, false);
    return points_->step(budget);
  }
  double share() const override {
    constexpr double kPartitionShare = 0.9;
    if (work_) return kPartitionShare * work_->progress();
    const auto count = static_cast<double>(partition_.triangles.size());
    return count > 0 ? kPartitionShare + (1 - kPartitionShare) * next_ / count : 1;
  }
  Record result() override {
    return partitionRecord(*on_.mesh, std::move(partition_), points_->take(), std::move(corners_));
  }

 private:
  void addCorners() {
    const Eigen::Matrix3d corners = cornersInFace(*on_.mesh, partition_, next_);
    int& face = partition_.triangleFace[next_];
    for (const auto& corner : corners.colwise())
      corners_.push_back(on_.mesh->toInput({face, corner}).bary);
    face = on_.mesh->inputFace(face);
  }

  const DiagramOnMesh on_;
  std::unique_ptr<SlicedWork<Partition>> work_;
  Partition partition_;
  std::vector<Eigen::Vector3d> corners_;
  int next_ = 0;  ///< triangle
  std::optional<PointsRecording> points_;
};

/// `PolygonMesh`.
class PolygonRecording final : public SlicedWork<Record> {
 public:
  PolygonRecording(DiagramOnMesh on, std::unique_ptr<SlicedWork<PolygonMesh>> making)
      : on_(std::move(on)), making_(std::move(making)) {}

  bool advance(long budget) override {
    if (making_) {
      if (!making_->step(budget)) return false;
      polygons_ = making_->take();
      making_.reset();
      triangulation_ = startTriangulation(polygons_);
      topology_ = startTopology(polygons_);
      points_.emplace(*on_.mesh, polygons_.points, false);
      return false;
    }
    return triangulation_->step(budget) && topology_->step(budget) && points_->step(budget);
  }
  double share() const override {
    constexpr double kMakingShare = 0.9;
    return making_ ? kMakingShare * making_->progress()
                   : kMakingShare + (1 - kMakingShare) * triangulation_->progress();
  }
  Record result() override {
    return polygonRecord(std::move(polygons_), points_->take(), triangulation_->take(),
                         topology_->take());
  }

 private:
  const DiagramOnMesh on_;
  std::unique_ptr<SlicedWork<PolygonMesh>> making_;
  PolygonMesh polygons_;
  std::unique_ptr<SlicedWork<PolygonTriangles>> triangulation_;
  std::unique_ptr<SlicedWork<PolygonTopology>> topology_;
  std::optional<PointsRecording> points_;
};

/// `DualPaths`.
class DualPathRecording final : public SlicedWork<Record> {
 public:
  DualPathRecording(DiagramOnMesh on, const DistanceField& field)
      : on_(std::move(on)), finding_(startDualPaths(*on_.mesh, *on_.diagram, field)) {}

  bool advance(long budget) override {
    if (points_) return points_->step(budget);
    if (finding_) {
      if (!finding_->step(budget)) return false;
      paths_ = finding_->take();
      finding_.reset();
    }
    for (; labels_.size() < paths_.size(); --budget) {
      if (budget <= 0) return false;
      join(paths_[labels_.size()]);
    }
    points_.emplace(*on_.mesh, joined_, true);
    return false;
  }
  double share() const override {
    constexpr double kFindingShare = 0.9;
    return finding_ ? kFindingShare * finding_->progress()
                    : kFindingShare + (points_ ? (1 - kFindingShare) * points_->progress() : 0);
  }
  Record result() override {
    Record out;
    out.add("labels", std::move(labels_));
    out.add("offset", std::move(offset_));
    out.add("points", points_->take());
    return out;
  }

 private:
  void join(const DualPath& path) {
    labels_.push_back(path.labels);
    joined_.insert(joined_.end(), path.points.begin(), path.points.end());
    offset_.push_back(static_cast<int>(joined_.size()));
  }

  const DiagramOnMesh on_;
  std::unique_ptr<SlicedWork<std::vector<DualPath>>> finding_;
  std::vector<DualPath> paths_;
  std::vector<std::array<int, 2>> labels_;
  std::vector<int> offset_ = {0};
  std::vector<SurfacePoint> joined_;  ///< of all paths
  std::optional<PointsRecording> points_;
};

}  // namespace

/// `Partition`.
GVD_ABI Answer* partition(DiagramHandle* voronoi, bool leaveOutIndifferent,
                          bool leaveOutUnreachable) {
  const PartitionOptions options = {.leaveOutIndifferent = leaveOutIndifferent,
                                    .leaveOutUnreachable = leaveOutUnreachable};
  return answerOn(voronoi, [options](const DiagramOnMesh& on) {
    return std::make_unique<PartitionRecording>(on, options);
  });
}

/// `PolygonMesh`: the dual, or if `primal` the regions themselves.
GVD_ABI Answer* dual(DiagramHandle* voronoi, bool primal) {
  return answerOn(voronoi, [=](const DiagramOnMesh& on) {
    return std::make_unique<PolygonRecording>(
        on, primal ? startRegionMesh(*on.mesh, *on.diagram)
                   : startDualMesh(*on.mesh, voronoi->sitesByLabel(), *on.diagram));
  });
}

/// `DualPaths`.
GVD_ABI Answer* dualPaths(DiagramHandle* voronoi) {
  return answerOn(voronoi, [=](const DiagramOnMesh& on) {
    return std::make_unique<DualPathRecording>(on, voronoi->field());
  });
}

/// Per violation of the dual its kind and its message, and a list of labels.
GVD_ABI Answer* dualViolations(DiagramHandle* voronoi) {
  return answerOn(voronoi, [=](const DiagramOnMesh& on) {
    return recording(startViolations(*on.mesh, voronoi->sitesByLabel(), *on.diagram),
                     [on](const std::vector<Violation>& violations) {
                       std::vector<std::string> kinds, messages;
                       std::vector<int> offset = {0}, labels;
                       for (const Violation& violation : violations) {
                         kinds.emplace_back(nameOf(kViolationKinds, violation.kind));
                         labels.insert(labels.end(), violation.labels.begin(),
                                       violation.labels.end());
                         offset.push_back(static_cast<int>(labels.size()));
                         messages.push_back(violation.message);
                       }
                       Record out;
                       out.add("kind", std::move(kinds));
                       out.add("labelOffset", std::move(offset));
                       out.add("labels", std::move(labels));
                       out.add("message", std::move(messages));
                       return out;
                     });
  });
}

/// `RemeshQuality` of the dual.
GVD_ABI Answer* dualQuality(DiagramHandle* voronoi) {
  return answerOn(voronoi, [=](const DiagramOnMesh& on) {
    return recording(
        startQuality(*on.mesh, startDualMesh(*on.mesh, voronoi->sitesByLabel(), *on.diagram)),
        [on](const RemeshQuality& quality) {
          Record out;
          out.add("triangles", quality.triangles);
          out.add("minAngle", quality.minAngle);
          out.add("meanMinAngle", quality.meanMinAngle);
          out.add("minValence", quality.minValence);
          out.add("maxValence", quality.maxValence);
          out.add("regularShare", quality.regularShare);
          out.add("hausdorff", quality.hausdorff);
          return out;
        });
  });
}

/// `SurfacePoints`: the sites by label, and more for a valid dual.
GVD_ABI Answer* repairedSites(const DiagramHandle* voronoi, int maxAdded) {
  return guarded([&] {
    const auto mesh = voronoi->surface.mesh;
    return answerOf(
        startRepair(*mesh, voronoi->sitesByLabel(), voronoi->metric, {maxAdded, voronoi->options}),
        [mesh](const RepairedSites& repaired) { return pointsRecord(*mesh, repaired.sites); });
  });
}

}  // namespace gvd::abi
