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

/// The share done of a recording, given that of its parts: the work on its result, null once that
/// is done, takes most of the time.
double shareOfRecording(const SlicedSteps* work, double ofParts) {
  constexpr double kShareOfWork = 0.9;
  return kShareOfWork * (work ? work->progress() : 1) + (1 - kShareOfWork) * ofParts;
}

/// `Partition`.
class PartitionRecording final : public SequentialWork<Record> {
 public:
  PartitionRecording(DiagramOnMesh on, const PartitionOptions& options)
      : on_(std::move(on)), work_(startPartition(*on_.mesh, *on_.diagram, options)) {}

  bool advance(long budget) override {
    return sequence_.run(
        [&] { return work_->step(budget); },
        [&] {
          partition_ = work_->take();
          work_.reset();
          corners_.reserve(3 * partition_.triangles.size());
        },
        forEach(partition_.triangles, budget, 4, [&](int t) { addCorners(t); }),
        [&] { return runPart(points_, budget, *on_.mesh, partition_.points, false); },
        [&] {
          out_ = partitionRecord(*on_.mesh, std::move(partition_), points_->take(),
                                 std::move(corners_));
        });
  }
  double share() const override { return shareOfRecording(work_.get(), sequence_.progress()); }

 private:
  void addCorners(int t) {
    const Eigen::Matrix3d corners = cornersInFace(*on_.mesh, partition_, t);
    int& face = partition_.triangleFace[t];
    for (const auto& corner : corners.colwise())
      corners_.push_back(on_.mesh->toInput({face, corner}).bary);
    face = on_.mesh->inputFace(face);
  }

  const DiagramOnMesh on_;
  std::unique_ptr<SlicedWork<Partition>> work_;
  Partition partition_;
  std::vector<Eigen::Vector3d> corners_;
  std::optional<PointsRecording> points_;
};

/// `PolygonMesh`.
class PolygonRecording final : public SequentialWork<Record> {
 public:
  PolygonRecording(DiagramOnMesh on, std::unique_ptr<SlicedWork<PolygonMesh>> making)
      : on_(std::move(on)), making_(std::move(making)) {}

  bool advance(long budget) override {
    return sequence_.run(
        [&] { return making_->step(budget); },
        [&] {
          polygons_ = making_->take();
          making_.reset();
          triangulation_ = startTriangulation(polygons_);
          topology_ = startTopology(polygons_);
        },
        [&] { return triangulation_->step(budget); }, [&] { return topology_->step(budget); },
        [&] { return runPart(points_, budget, *on_.mesh, polygons_.points, false); },
        [&] {
          out_ = polygonRecord(std::move(polygons_), points_->take(), triangulation_->take(),
                               topology_->take());
        });
  }
  double share() const override { return shareOfRecording(making_.get(), sequence_.progress()); }

 private:
  const DiagramOnMesh on_;
  std::unique_ptr<SlicedWork<PolygonMesh>> making_;
  PolygonMesh polygons_;
  std::unique_ptr<SlicedWork<PolygonTriangles>> triangulation_;
  std::unique_ptr<SlicedWork<PolygonTopology>> topology_;
  std::optional<PointsRecording> points_;
};

/// `DualPaths`.
class DualPathRecording final : public SequentialWork<Record> {
 public:
  DualPathRecording(DiagramOnMesh on, const DistanceField& field)
      : on_(std::move(on)), finding_(startDualPaths(*on_.mesh, *on_.diagram, field)) {}

  bool advance(long budget) override {
    return sequence_.run([&] { return finding_->step(budget); },
                         [&] {
                           paths_ = finding_->take();
                           finding_.reset();
                         },
                         forEach(paths_, budget, 1, [&](int i) { join(paths_[i]); }),
                         [&] { return runPart(points_, budget, *on_.mesh, joined_, true); },
                         [&] {
                           out_.add("labels", std::move(labels_));
                           out_.add("offset", std::move(offset_));
                           out_.add("points", points_->take());
                         });
  }
  double share() const override { return shareOfRecording(finding_.get(), sequence_.progress()); }

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
