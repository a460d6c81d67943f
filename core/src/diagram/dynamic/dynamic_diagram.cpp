// SPDX-License-Identifier: MIT
//
// A dynamic diagram: after a site was inserted, removed or moved, the regions and faces with
// changed distances are traced again.
#include "gvd/dynamic_diagram.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "base/index_set.h"
#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "diagram/diagram_tracing.h"
#include "diagram/dynamic/diagram_pieces.h"
#include "diagram/dynamic/overlap_faces.h"
#include "distance/site_distances.h"
#include "gvd/error.h"

namespace gvd {
namespace {

void requireFree(const SiteDistances& distances) {
  if (distances.isTaken()) rejectArgument("the distances have been given to a diagram before");
}

/// The implementation behind a field made by `propagate`.
std::shared_ptr<SiteDistances> asSiteDistances(const TriangleMesh& mesh,
                                               const std::shared_ptr<DistanceField>& distances) {
  auto found = std::dynamic_pointer_cast<SiteDistances>(distances);
  if (!found) rejectArgument("the distances are not those that propagate gives");
  requireMesh(mesh, *found);
  requireFree(*found);
  return found;
}

}  // namespace

class DynamicDiagram::Implementation {
 public:
  /// All sites must have been inserted by the last change of the distances. There is no diagram
  /// until the first `Update` is done.
  Implementation(const TriangleMesh& mesh, std::shared_ptr<SiteDistances> distances,
                 const DiagramOptions& options)
      : mesh_(mesh),
        options_(options),
        distances_(std::move(distances)),
        tracer_(mesh, *distances_, options),
        pieces_(mesh.faceCount()),
        overlaps_(mesh, *distances_) {}

  int labelCount() const { return distances_->sites().labelCount(); }
  const SiteDistances& distances() const { return *distances_; }
  std::unique_ptr<SlicedWork<Diagram>> startDiagram() const { return pieces_.startDiagram(); }

  /// From now on the distances change with this diagram alone.
  void takeDistances() {
    requireFree(*distances_);
    distances_->markTaken();
  }

  /// Throws unless the last change was carried to its end.
  void requireWhole() const {
    if (isChanging_) rejectArgument("a change of the diagram is not finished");
  }

  void requireSite(int label) const {
    if (!distances_->sites().contains(label))
      rejectArgument("there is no site " + std::to_string(label));
  }

  class Update;
  /// Traces the diagram of sites whose distances are known or under way.
  static std::unique_ptr<SlicedWork<DynamicDiagram>> open(const TriangleMesh& mesh,
                                                          std::shared_ptr<SiteDistances> distances,
                                                          const DiagramOptions& options);
  /// Begins a change of some labels, each named once.
  std::unique_ptr<SlicedWork<DiagramChange>> start(std::span<const SiteChange> changes);
  std::unique_ptr<SlicedWork<DiagramChange>> start(const SiteChange& change) {
    return start({&change, 1});
  }

 private:
  /// Adds the labels that are known in a face or in one that has a corner in common with it.
  void addLabelsAround(int face, IndexSet& labels) const {
    const auto add = [&](int v) {
      for (const LabelledDistance& d : distances_->at(v)) labels.add(d.label);
    };
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      add(mesh_.tail(h));
      mesh_.visitNeighbours(mesh_.tail(h), add);
    }
  }

  const TriangleMesh& mesh_;
  DiagramOptions options_;
  bool isChanging_ = false;  ///< from `start` until the change is done
  std::shared_ptr<SiteDistances> distances_;
  PartialTracer tracer_;
  DiagramPieces pieces_;
  OverlapFaces overlaps_;
  /// Faces with merged points, and some that had them before; ascending.
  std::vector<int> mergedFaces_;
  /// Faces where the tracer added labels when the whole diagram was traced last; ascending.
  std::vector<int> completedFaces_;
};

/// Makes the diagram follow a change of its distances, in slices.
class DynamicDiagram::Implementation::Update final : public SequentialWork<DiagramChange> {
 public:
  /// The change of the distances has begun. The whole diagram is traced if there is none yet.
  Update(Implementation& diagram, bool isFirst) : diagram_(diagram), tracesAll_(isFirst) {}

  bool advance(long budget) override {
    return sequence_.run(
        [&] { return diagram_.distances_->step(budget); },
        [&] { labels_ = IndexSet(labelCount(), diagram_.distances_->changedLabels()); },
        [&] { return diagram_.overlaps_.update(labels_, budget); },
        [&] { return tracesAll_ || traceParts(budget); },
        forItems(out_.faces, budget, 8, [&](int face) { addFaceLabel(face); }),
        [&] { return !tracesAll_ || traceAll(budget); },
        [&] { return diagram_.pieces_.replace(out_, budget); },
        forEach(out_.labels, budget, kQuickRounds, [&](int i) { return setArea(i); }),
        [&] { diagram_.isChanging_ = false; });
  }
  double share() const override {
    const double ofDistances = propagationShare(diagram_.options_);
    return ofDistances * diagram_.distances_->progress() + (1 - ofDistances) * sequence_.progress();
  }

 private:
  int labelCount() const { return diagram_.labelCount(); }

  /// Traces the changed labels in the faces where they meet others. If points are merged there,
  /// before or after the change, a bisector may run where a third region has no width left, and the
  /// order of regions around the point depends on all labels known there: these labels are then
  /// traced, too. If the tracer adds labels in a face, or had done so before, the whole diagram is
  /// traced.
  bool traceParts(long& budget) {
    for (;;) {
      if (!tracing_) {
        const std::vector<int> faces = diagram_.overlaps_.of(labels_.list());
        tracing_ = diagram_.tracer_.start(faces, labels_, labelCount());
      }
      if (!tracing_->step(budget)) return false;
      TracedDiagram traced = tracing_->take();
      tracing_.reset();
      const auto isTraced = [&](int f) { return diagram_.tracer_.faceIndex(f) >= 0; };
      const std::vector<int>& completed = diagram_.completedFaces_;
      tracesAll_ = !traced.completedFaces.empty() ||
                   std::any_of(completed.begin(), completed.end(), isTraced);
      if (tracesAll_) return true;
      std::vector<int> merged = traced.mergedFaces;
      for (const int f : diagram_.mergedFaces_)
        if (isTraced(f)) merged.push_back(f);
      makeSet(merged);
      const int tracedCount = labels_.size();
      for (const int f : merged) diagram_.addLabelsAround(f, labels_);
      if (labels_.size() > tracedCount) continue;

      std::erase_if(diagram_.mergedFaces_, isTraced);
      diagram_.mergedFaces_.insert(diagram_.mergedFaces_.end(), traced.mergedFaces.begin(),
                                   traced.mergedFaces.end());
      makeSet(diagram_.mergedFaces_);
      takeParts(std::move(traced.diagram), merged);
      return true;
    }
  }

  /// Puts into the change the traced labels, and the faces that have changed or share a corner with
  /// a face with merged points, but not yet the labels of these faces.
  void takeParts(Diagram traced, std::span<const int> merged) {
    const TriangleMesh& mesh = diagram_.mesh_;
    out_ = {labels_.sorted(), diagram_.distances_->changedFaces().sorted(), {}};
    for (const int f : merged)
      for (int h = 3 * f; h < 3 * f + 3; ++h)
        mesh.visitFaces(mesh.tail(h), [&](int around) { out_.faces.push_back(around); });
    makeSet(out_.faces);
    out_.part = extract(traced, labels_, out_.faces);
    out_.part.faceLabel.reserve(out_.faces.size());
    tracedFaceLabel_ = std::move(traced.faceLabel);
    tracedArea_ = std::move(traced.regionArea);
  }

  /// Where labels do not meet, the nearest one at a corner owns all of a face.
  void addFaceLabel(int face) {
    const int index = diagram_.tracer_.faceIndex(face);
    out_.part.faceLabel.push_back(
        index >= 0 ? tracedFaceLabel_[index]
                   : nearestOf(diagram_.distances_->at(diagram_.mesh_.tail(3 * face))).label);
  }

  bool traceAll(long& budget) {
    if (!tracing_)
      tracing_ =
          startTracing(diagram_.mesh_, *diagram_.distances_, labelCount(), diagram_.options_);
    if (!tracing_->step(budget)) return false;
    TracedDiagram traced = tracing_->take();
    diagram_.mergedFaces_ = std::move(traced.mergedFaces);
    diagram_.completedFaces_ = std::move(traced.completedFaces);
    makeSet(diagram_.mergedFaces_);
    makeSet(diagram_.completedFaces_);
    out_ = changeTo(std::move(traced.diagram));
    return true;
  }

  /// Returns how many quick rounds it took.
  long setArea(int i) {
    const int label = out_.labels[i];
    std::vector<double>& areas = out_.part.regionArea;
    long rounds = 1;
    if (!tracesAll_) {
      const std::vector<int>& triangles = diagram_.pieces_.regionTriangles(label);
      double area = tracedArea_[label];
      for (const int f : triangles)  // the others have been traced
        if (diagram_.tracer_.faceIndex(f) < 0) area += diagram_.mesh_.faceArea(f);
      areas.push_back(area);
      rounds += static_cast<long>(triangles.size());
    }
    diagram_.pieces_.setArea(label, areas[i]);
    return rounds;
  }

  Implementation& diagram_;
  bool tracesAll_;
  IndexSet labels_{0};  ///< labels to trace
  std::unique_ptr<SlicedWork<TracedDiagram>> tracing_;
  std::vector<int> tracedFaceLabel_;  ///< of each traced face
  std::vector<double> tracedArea_;    ///< per label, in the traced faces
};

std::unique_ptr<SlicedWork<DiagramChange>> DynamicDiagram::Implementation::start(
    std::span<const SiteChange> changes) {
  isChanging_ = true;
  try {
    distances_->change(changes);
  } catch (const Error&) {  // A site was refused. Anything else leaves the change unfinished.
    isChanging_ = false;
    throw;
  }
  return std::make_unique<Update>(*this, false);
}

// --- Making one --------------------------------------------------------------------------------

std::unique_ptr<SlicedWork<DynamicDiagram>> DynamicDiagram::Implementation::open(
    const TriangleMesh& mesh, std::shared_ptr<SiteDistances> distances,
    const DiagramOptions& options) {
  auto diagram = std::make_unique<Implementation>(mesh, std::move(distances), options);
  auto update = std::make_unique<Update>(*diagram, true);
  return workOn(std::move(update), [diagram = std::move(diagram)](auto /*update*/) mutable {
    diagram->takeDistances();
    return DynamicDiagram(std::move(diagram));
  });
}

DynamicDiagram::DynamicDiagram(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                               Metric metric, const DiagramOptions& options)
    : DynamicDiagram(finished(start(mesh, sites, metric, options))) {}

DynamicDiagram::DynamicDiagram(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

// Not inlined, as the WebAssembly module would be larger.
[[gnu::noinline]] DynamicDiagram::Implementation& DynamicDiagram::whole() const {
  implementation_->requireWhole();
  return *implementation_;
}

std::unique_ptr<SlicedWork<DynamicDiagram>> DynamicDiagram::start(
    const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric,
    const DiagramOptions& options) {
  return Implementation::open(mesh, std::make_shared<SiteDistances>(mesh, metric, sites), options);
}

DynamicDiagram DynamicDiagram::fromDistances(const TriangleMesh& mesh,
                                             const std::shared_ptr<DistanceField>& distances,
                                             const DiagramOptions& options) {
  return finished(startFromDistances(mesh, distances, options));
}

std::unique_ptr<SlicedWork<DynamicDiagram>> DynamicDiagram::startFromDistances(
    const TriangleMesh& mesh, const std::shared_ptr<DistanceField>& distances,
    const DiagramOptions& options) {
  return Implementation::open(mesh, asSiteDistances(mesh, distances), options);
}

DynamicDiagram::~DynamicDiagram() = default;
DynamicDiagram::DynamicDiagram(DynamicDiagram&&) noexcept = default;
DynamicDiagram& DynamicDiagram::operator=(DynamicDiagram&&) noexcept = default;

// --- Changes -----------------------------------------------------------------------------------

DiagramChange DynamicDiagram::insertSite(const SurfacePoint& site) {
  return finished(startInsert(site));
}

DiagramChange DynamicDiagram::removeSite(int label) { return finished(startRemove(label)); }

DiagramChange DynamicDiagram::moveSite(int label, const SurfacePoint& site) {
  return finished(startMove(label, site));
}

std::unique_ptr<SlicedWork<DiagramChange>> DynamicDiagram::startInsert(const SurfacePoint& site) {
  return startInsert({&site, 1});
}

std::unique_ptr<SlicedWork<DiagramChange>> DynamicDiagram::startInsert(
    std::span<const SurfacePoint> sites) {
  std::vector<SiteChange> changes;
  int label = 0;
  for (const SurfacePoint& site : sites) {
    while (hasSite(label)) ++label;
    changes.push_back({label++, site});
  }
  return whole().start(changes);
}

std::unique_ptr<SlicedWork<DiagramChange>> DynamicDiagram::startRemove(int label) {
  whole().requireSite(label);
  return whole().start({label, std::nullopt});
}

std::unique_ptr<SlicedWork<DiagramChange>> DynamicDiagram::startMove(int label,
                                                                     const SurfacePoint& site) {
  whole().requireSite(label);
  return whole().start({label, site});
}

// --- What there is -----------------------------------------------------------------------------

int DynamicDiagram::lowestFreeLabel() const {
  int label = 0;
  while (hasSite(label)) ++label;
  return label;
}

int DynamicDiagram::labelCount() const { return whole().labelCount(); }

bool DynamicDiagram::hasSite(int label) const {
  return whole().distances().sites().contains(label);
}

SurfacePoint DynamicDiagram::site(int label) const {
  whole().requireSite(label);
  return whole().distances().sites()[label];
}

std::vector<SurfacePoint> DynamicDiagram::sites() const {
  const SiteSet& all = whole().distances().sites();
  std::vector<SurfacePoint> sites;
  sites.reserve(all.labelCount());
  for (int label = 0; label < all.labelCount(); ++label) sites.push_back(all[label]);
  return sites;
}

const DistanceField& DynamicDiagram::distances() const { return whole().distances(); }

Diagram DynamicDiagram::diagram() const { return finished(startDiagram()); }

std::unique_ptr<SlicedWork<Diagram>> DynamicDiagram::startDiagram() const {
  return whole().startDiagram();
}

}  // namespace gvd
