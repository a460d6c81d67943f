// SPDX-License-Identifier: MIT
//
// Diagrams for JavaScript: distances first, then the diagram, both in slices; points located in it,
// paths to its sites, sites that come, go and move.

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "objects.h"
#include "records.h"

namespace gvd::abi {
namespace {

/// A direction in the frame of a face, in the frame of the input triangle: if that was turned over,
/// its first side is the face's last one, and left and right are exchanged.
Eigen::Vector2d directionToInput(const TriangleMesh& mesh, int face,
                                 const Eigen::Vector2d& direction) {
  if (!mesh.isFlipped(face)) return direction;
  const TriangleMesh::Face& f = mesh.face(face);
  const Eigen::Vector2d firstSide(f.cosines[0], f.sines[0]);
  return {direction.dot(firstSide), direction.x() * firstSide.y() - direction.y() * firstSide.x()};
}

/// `VertexDistances` of sites: distances first, then those of the input's vertices.
class VertexDistances final : public PointLookup {
 public:
  VertexDistances(std::shared_ptr<const TriangleMesh> mesh, std::vector<SurfacePoint> sites,
                  Metric metric)
      : PointLookup(mesh->inputVertexCount()),
        mesh_(std::move(mesh)),
        sites_(std::move(sites)),
        propagation_(propagate(*mesh_, sites_, metric)) {
    label_.reserve(mesh_->inputVertexCount());
    distance_.reserve(mesh_->inputVertexCount());
    direction_.reserve(2 * static_cast<std::size_t>(mesh_->inputVertexCount()));
  }

  double share() const override {
    constexpr double kPropagationShare = 0.9;
    return kPropagationShare * propagation_->progress() +
           (1 - kPropagationShare) * PointLookup::share();
  }
  Record result() override {
    Record out;
    out.add("label", std::move(label_));
    out.add("distance", std::move(distance_));
    out.add("direction", std::move(direction_));
    return out;
  }

 private:
  bool prepare(long budget) override {
    if (!field_ && propagation_->step(budget)) field_ = propagation_->take();
    return field_ != nullptr;
  }
  void lookUp(std::size_t i, long& /*budget*/) override {
    const int vertex = mesh_->vertexOfInput(static_cast<int>(i));
    const LabelledDistance nearest =
        vertex < 0 ? LabelledDistance{} : nearestOf(field_->at(vertex));
    label_.push_back(nearest.label);
    distance_.push_back(nearest.distance);
    Eigen::Vector2d direction = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
    if (nearest.label >= 0)
      direction = directionToInput(*mesh_, sites_[nearest.label].face,
                                   field_->direction(nearest.label, vertex));
    direction_.insert(direction_.end(), direction.begin(), direction.end());
  }

  const std::shared_ptr<const TriangleMesh> mesh_;
  const std::vector<SurfacePoint> sites_;
  const std::unique_ptr<Propagation> propagation_;
  std::unique_ptr<DistanceField> field_;
  std::vector<int> label_;
  std::vector<double> distance_, direction_;
};

/// Makes a diagram: distances first, then what is traced of them.
class VoronoiMaking final : public SequentialWork<Record> {
 public:
  /// Takes a handle with a mesh, sites, metric and options.
  explicit VoronoiMaking(std::unique_ptr<DiagramHandle> voronoi)
      : voronoi_(std::move(voronoi)),
        propagation_(propagate(voronoi_->mesh(), voronoi_->sites, voronoi_->metric)) {}

  bool advance(long budget) override {
    return sequence_.run([&] { return propagation_->step(budget); },
                         [&] {
                           voronoi_->distances = propagation_->take();
                           tracing_ = startDiagram(voronoi_->mesh(), voronoi_->field(),
                                                   static_cast<int>(voronoi_->sites.size()),
                                                   voronoi_->options);
                         },
                         [&] { return tracing_->step(budget); });
  }
  double share() const override {
    const double ofDistances = propagationShare(voronoi_->options);
    return tracing_ ? ofDistances + (1 - ofDistances) * tracing_->progress()
                    : ofDistances * propagation_->progress();
  }
  Record result() override {
    voronoi_->traced = std::make_shared<const Diagram>(tracing_->take());
    return addressRecord("voronoi", std::move(voronoi_));
  }

 private:
  std::unique_ptr<DiagramHandle> voronoi_;  // outlives the work on it
  const std::unique_ptr<Propagation> propagation_;
  std::unique_ptr<SlicedWork<Diagram>> tracing_;
};

/// `Located`.
class LocatedPoints final : public PointLookup {
 public:
  /// The diagram must outlive the steps.
  LocatedPoints(const DiagramHandle& voronoi, std::span<const int> face,
                std::span<const double> bary)
      : PointLookup(face.size()),
        voronoi_(voronoi),
        face_(face.begin(), face.end()),
        bary_(bary.begin(), bary.end()) {}

  Record result() override {
    Record out;
    out.add("label", std::move(label_));
    out.add("distance", std::move(distance_));
    return out;
  }

 private:
  void lookUp(std::size_t i, long& budget) override {
    const SurfacePoint point = naming(
        "point", i, [&] { return pointFromInput(voronoi_.mesh(), face_[i], &bary_[3 * i]); });
    const LabelledDistance nearest = voronoi_.field().nearest(point, budget);
    label_.push_back(nearest.label);
    distance_.push_back(nearest.distance);
  }

  const DiagramHandle& voronoi_;
  const std::vector<int> face_;
  const std::vector<double> bary_;
  std::vector<int> label_;
  std::vector<double> distance_;
};

/// `DiagramChange`: inserts, removes or moves a site. The first change makes the `DynamicDiagram`.
/// The worst regions follow, if there are any.
class SiteChanging final : public SequentialWork<Record> {
 public:
  /// Without a label, inserts the site; without a site, removes that of the label. The diagram must
  /// outlive the steps.
  SiteChanging(DiagramHandle& voronoi, std::optional<int> label, std::optional<SurfacePoint> site)
      : voronoi_(voronoi), label_(label), site_(std::move(site)) {}

  bool advance(long budget) override {
    return sequence_.run([&] { return makeDynamic(budget); }, [&] { start(); },
                         [&] { return change_->step(budget); },
                         [&] {
                           voronoi_.traced.reset();
                           changed_ = change_->take();
                           regions_ = std::move(voronoi_.worstRegions);
                           if (regions_) following_ = regions_->startFollow(changed_);
                         },
                         [&] { return !following_ || following_->step(budget); },
                         [&] { voronoi_.worstRegions = std::move(regions_); });
  }
  double share() const override {
    if (making_) return making_->progress() / 2;
    const double own = change_ ? change_->progress() : 0;
    return wasMade_ ? (1 + own) / 2 : own;
  }
  Record result() override { return changeRecord(voronoi_.mesh(), *label_, std::move(changed_)); }

 private:
  /// Makes the `DynamicDiagram` if there is none yet; true when it is there.
  bool makeDynamic(long budget) {
    if (voronoi_.dynamic) return true;
    if (!making_) making_ = voronoi_.startDynamic();
    if (!making_->step(budget)) return false;
    voronoi_.takeDynamic(making_->take());
    making_.reset();
    wasMade_ = true;
    return true;
  }

  void start() {
    DynamicDiagram& diagram = *voronoi_.dynamic;
    if (!label_) {
      label_ = diagram.lowestFreeLabel();
      change_ = diagram.startInsert(*site_);
    } else {
      change_ = site_ ? diagram.startMove(*label_, *site_) : diagram.startRemove(*label_);
    }
  }

  DiagramHandle& voronoi_;
  std::optional<int> label_;
  const std::optional<SurfacePoint> site_;
  std::unique_ptr<SlicedWork<DynamicDiagram>> making_;
  bool wasMade_ = false;
  std::unique_ptr<SlicedWork<DiagramChange>> change_;
  DiagramChange changed_;
  /// Those of the handle while they follow the change; the handle has none if that does not end.
  std::unique_ptr<WorstRegions> regions_;
  std::unique_ptr<SlicedSteps> following_;
};

Answer* changeAnswer(DiagramHandle& voronoi, std::optional<int> label,
                     std::optional<SurfacePoint> site) {
  return answerOf(std::make_unique<SiteChanging>(voronoi, label, std::move(site)));
}

}  // namespace

/// `voronoi`: a `DiagramHandle`.
GVD_ABI Answer* createVoronoi(const MeshHandle* handle, Ints face, Doubles bary, Text metric,
                              int detail) {
  return guarded([&] {
    auto voronoi = std::make_unique<DiagramHandle>();
    voronoi->surface = *handle;
    voronoi->sites = sitesFromInput(voronoi->mesh(), face, bary);
    voronoi->metric = metricOf(metric);
    voronoi->options = {.detail = detail};
    return answerOf(std::make_unique<VoronoiMaking>(std::move(voronoi)));
  });
}

GVD_ABI void freeVoronoi(DiagramHandle* voronoi) { delete voronoi; }

/// The mesh that a diagram is on: the diagram's own handle of it, freed with it.
GVD_ABI MeshHandle* meshOfVoronoi(DiagramHandle* voronoi) { return &voronoi->surface; }

/// `VertexDistances` of sites, without a diagram.
GVD_ABI Answer* distancesAtVertices(const MeshHandle* handle, Ints face, Doubles bary,
                                    Text metric) {
  return guarded([&] {
    return answerOf(std::make_unique<VertexDistances>(
        handle->mesh, sitesFromInput(*handle->mesh, face, bary), metricOf(metric)));
  });
}

/// `SurfacePath` from a point to its nearest site; no points and infinity if no site reaches it.
GVD_ABI Answer* pathToSite(const DiagramHandle* voronoi, Ints face, Doubles bary) {
  return answer([&] {
    const TriangleMesh& mesh = voronoi->mesh();
    const DistanceField& field = voronoi->field();
    const SurfacePoint from = pointFromInput(mesh, face, bary);
    const int label = field.nearest(from).label;
    return pathRecord(mesh, label < 0 ? std::vector<SurfacePoint>() : field.path(label, from));
  });
}

/// `DiagramData`.
GVD_ABI Answer* voronoiDiagram(DiagramHandle* voronoi) {
  return answerOn(voronoi, diagramRecording);
}

/// `DiagramChange`. Nothing else may be asked of the diagram until it is done.
GVD_ABI Answer* insertSite(DiagramHandle* voronoi, Ints face, Doubles bary) {
  return guarded([&] {
    return changeAnswer(*voronoi, std::nullopt, pointFromInput(voronoi->mesh(), face, bary));
  });
}

GVD_ABI Answer* moveSite(DiagramHandle* voronoi, int label, Ints face, Doubles bary) {
  return guarded(
      [&] { return changeAnswer(*voronoi, label, pointFromInput(voronoi->mesh(), face, bary)); });
}

GVD_ABI Answer* removeSite(DiagramHandle* voronoi, int label) {
  return guarded([&] { return changeAnswer(*voronoi, label, std::nullopt); });
}

/// `SurfacePoints`: one, for the worst region.
GVD_ABI Answer* worstRegionPoint(DiagramHandle* voronoi, Text worst) {
  return guarded([&] {
    const WorstRegion kind = worstRegionOf(worst);
    const auto point = [voronoi] {
      const SurfacePoint place = voronoi->worstRegions->point();
      return pointsRecord(voronoi->mesh(), {&place, 1});
    };
    if (voronoi->worstRegions && voronoi->worstRegions->kind() == kind) return answer(point);
    return answerOn(voronoi, [=](const DiagramOnMesh& on) {
      return recording(WorstRegions::start(*on.mesh, voronoi->field(), *on.diagram, kind),
                       [voronoi, point, on](WorstRegions regions) {
                         voronoi->worstRegions = std::make_unique<WorstRegions>(std::move(regions));
                         return point();
                       });
    });
  });
}

/// `DiagramAccuracy`.
GVD_ABI Answer* diagramAccuracy(DiagramHandle* voronoi, int samples) {
  return answerOn(voronoi, [=](const DiagramOnMesh& on) {
    return recording(startAccuracy(*on.mesh, voronoi->field(), *on.diagram, samples),
                     [on](const DiagramAccuracy& accuracy) {
                       Record out;
                       out.add("mislabelled", accuracy.mislabelled);
                       out.add("maxEdge", accuracy.maxEdge);
                       return out;
                     });
  });
}

/// `Located`.
GVD_ABI Answer* locate(const DiagramHandle* voronoi, Ints face, Doubles bary) {
  return guarded([&] {
    return answerOf(std::make_unique<LocatedPoints>(*voronoi, face.span(), bary.span()));
  });
}

}  // namespace gvd::abi
