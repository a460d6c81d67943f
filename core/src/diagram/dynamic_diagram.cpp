// SPDX-License-Identifier: MIT
//
// A live diagram: after a site has come, gone or moved, the regions and faces that its distances
// change are traced again.
#include "gvd/dynamic_diagram.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "base/index_set.h"
#include "diagram/diagram_pieces.h"
#include "diagram/trace_faces.h"
#include "distance/site_distances.h"
#include "gvd/error.h"

namespace gvd {
namespace {

void complete(SiteDistances& distances) {
  while (!distances.step(std::numeric_limits<long>::max())) {
  }
}

std::shared_ptr<SiteDistances> distancesOf(const TriangleMesh& mesh,
                                           std::span<const SurfacePoint> sites, Metric metric) {
  auto distances = std::make_shared<SiteDistances>(mesh, metric);
  distances->change(arrivals(sites));
  complete(*distances);
  return distances;
}

/// What `propagate` has made.
std::shared_ptr<SiteDistances> asSiteDistances(const std::shared_ptr<DistanceField>& distances) {
  auto found = std::dynamic_pointer_cast<SiteDistances>(distances);
  if (!found)
    throw Error(ErrorCode::kInvalidArgument, "the distances are not those that propagate gives");
  return found;
}

}  // namespace

class DynamicDiagram::Implementation {
 public:
  /// The last change of the distances is that in which all sites have come.
  Implementation(const TriangleMesh& mesh, std::shared_ptr<SiteDistances> distances,
                 const DiagramOptions& options)
      : mesh_(mesh),
        options_(options),
        distances_(std::move(distances)),
        tracer_(mesh, *distances_, options),
        pieces_(mesh.faceCount()),
        faces_(mesh.faceCount()) {
    noteMixed();
    replaceAll();
  }

  int labelCount() const { return distances_->sites().labelCount(); }
  const SiteDistances& distances() const { return *distances_; }
  Diagram whole() const { return pieces_.whole(); }

  void expectSite(int label) const {
    if (!distances_->sites().contains(label))
      throw Error(ErrorCode::kInvalidArgument, "there is no site " + std::to_string(label));
  }

  /// Takes the site of a label away if it has one, and puts it to another place if one is given.
  DiagramChange setSite(int label, const std::optional<SurfacePoint>& site) {
    const SiteChange change = {label, site};
    distances_->change({&change, 1});
    complete(*distances_);
    noteMixed();
    return trace();
  }

 private:
  /// Keeps note of where the changed labels meet others.
  void noteMixed() {
    mixedFaces_.resize(labelCount());
    const std::vector<int>& labels = distances_->changedLabels();
    const std::vector<char> isChanged = marks(labels);
    gather(distances_->changedFaces());
    for (const int label : labels)
      std::erase_if(mixedFaces_[label], [&](int f) { return faces_.contains(f); });
    for (const int f : faces_.list())
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        const auto known = distances_->at(mesh_.tail(h));
        if (known.size() < 2) continue;
        for (const LabelledDistance& d : known) {
          if (!isChanged[d.label]) continue;
          std::vector<int>& mixed = mixedFaces_[d.label];
          if (mixed.empty() || mixed.back() != f) mixed.push_back(f);
        }
      }
  }

  /// Cells can differ only in the faces around changed vertices, and in those for which the tracer
  /// completes labels. Where points are merged, before the change or after it, a bisector may run
  /// where a third region has no width left, and the order of regions around the point follows from
  /// all labels known there: these labels and their faces are traced again too.
  DiagramChange trace() {
    IndexSet labels(labelCount(), distances_->changedLabels());
    for (;;) {
      const std::vector<int> tracedLabels = labels.sorted();
      const std::vector<int> tracedFaces = facesWhereMet(tracedLabels);
      TracedDiagram traced = tracer_.trace(tracedFaces, marks(tracedLabels));
      if (!traced.completedFaces.empty() || haveCommon(tracedFaces, completedFaces_))
        return replaceAll();
      std::vector<int> merged = traced.mergedFaces;
      for (const int f : mergedFaces_)
        if (isOneOf(tracedFaces, f)) merged.push_back(f);
      makeSet(merged);
      for (const int f : merged) addLabelsAround(f, labels);
      if (labels.size() > static_cast<int>(tracedLabels.size())) continue;

      gather(distances_->changedFaces());
      for (const int f : merged)
        for (int h = 3 * f; h < 3 * f + 3; ++h)
          mesh_.visitFaces(mesh_.tail(h), [&](int around) { faces_.add(around); });
      std::erase_if(mergedFaces_, [&](int f) { return isOneOf(tracedFaces, f); });
      mergedFaces_.insert(mergedFaces_.end(), traced.mergedFaces.begin(), traced.mergedFaces.end());
      makeSet(mergedFaces_);
      return replaced(tracedLabels, faces_.sorted(), traced.diagram);
    }
  }

  /// Begins to gather faces with these.
  void gather(std::span<const int> faces) {
    faces_.clear();
    for (const int f : faces) faces_.add(f);
  }

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

  /// `faces` are ascending.
  static bool isOneOf(std::span<const int> faces, int face) {
    return std::binary_search(faces.begin(), faces.end(), face);
  }

  static bool haveCommon(std::span<const int> faces, std::span<const int> few) {
    return std::any_of(few.begin(), few.end(), [&](int f) { return isOneOf(faces, f); });
  }

  /// Traces all of the diagram.
  DiagramChange replaceAll() {
    TracedDiagram traced = traceAll(mesh_, *distances_, labelCount(), options_);
    mergedFaces_ = std::move(traced.mergedFaces);
    completedFaces_ = std::move(traced.completedFaces);
    makeSet(mergedFaces_);
    makeSet(completedFaces_);
    DiagramChange all{std::vector<int>(labelCount()), std::vector<int>(mesh_.faceCount()),
                      std::move(traced.diagram)};
    std::iota(all.labels.begin(), all.labels.end(), 0);
    std::iota(all.faces.begin(), all.faces.end(), 0);
    pieces_.replace(all);
    for (const int label : all.labels) pieces_.setArea(label, all.part.regionArea[label]);
    return all;
  }

  std::vector<char> marks(std::span<const int> labels) const {
    std::vector<char> isOne(labelCount());
    for (const int label : labels) isOne[label] = true;
    return isOne;
  }

  /// All faces of which several labels are known at a corner, one of the given ones among them;
  /// ascending.
  std::vector<int> facesWhereMet(std::span<const int> labels) {
    gather({});
    for (const int label : labels)
      for (const int f : mixedFaces_[label]) faces_.add(f);
    return faces_.sorted();
  }

  /// Puts what has been traced of the changed labels and faces in the place of what there was.
  DiagramChange replaced(const std::vector<int>& labels, std::vector<int> faces,
                         const Diagram& traced) {
    DiagramChange change{labels, std::move(faces), {}};
    change.part = extract(traced, marks(labels), change.faces);
    for (const int f : change.faces) {
      const int index = tracer_.faceIndex(f);
      change.part.faceLabel.push_back(index >= 0
                                          ? traced.faceLabel[index]
                                          : nearestOf(distances_->at(mesh_.tail(3 * f))).label);
    }
    pieces_.replace(change);
    for (const int label : change.labels) {
      double area = traced.regionArea[label];
      for (const int f : pieces_.wholeFaces(label))
        if (tracer_.faceIndex(f) < 0) area += mesh_.faceArea(f);
      change.part.regionArea.push_back(area);
      pieces_.setArea(label, area);
    }
    return change;
  }

  const TriangleMesh& mesh_;
  DiagramOptions options_;
  std::shared_ptr<SiteDistances> distances_;
  PartialTracer tracer_;
  DiagramPieces pieces_;
  IndexSet faces_;  ///< those that are gathered at the time
  /// Where points have become one, and some where they had; ascending.
  std::vector<int> mergedFaces_;
  /// Where the tracer had to add labels when all was traced; ascending.
  std::vector<int> completedFaces_;
  /// Per label the faces with a corner where it and others are known.
  std::vector<std::vector<int>> mixedFaces_;
};

DynamicDiagram::DynamicDiagram(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                               Metric metric, const DiagramOptions& options)
    : implementation_(
          std::make_unique<Implementation>(mesh, distancesOf(mesh, sites, metric), options)) {}

DynamicDiagram::DynamicDiagram(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

DynamicDiagram DynamicDiagram::fromDistances(const TriangleMesh& mesh,
                                             const std::shared_ptr<DistanceField>& distances,
                                             const DiagramOptions& options) {
  return DynamicDiagram(
      std::make_unique<Implementation>(mesh, asSiteDistances(distances), options));
}

DynamicDiagram::~DynamicDiagram() = default;
DynamicDiagram::DynamicDiagram(DynamicDiagram&&) noexcept = default;
DynamicDiagram& DynamicDiagram::operator=(DynamicDiagram&&) noexcept = default;

DiagramChange DynamicDiagram::insertSite(const SurfacePoint& site) {
  return implementation_->setSite(lowestFreeLabel(), site);
}

DiagramChange DynamicDiagram::removeSite(int label) {
  implementation_->expectSite(label);
  return implementation_->setSite(label, std::nullopt);
}

DiagramChange DynamicDiagram::moveSite(int label, const SurfacePoint& site) {
  implementation_->expectSite(label);
  return implementation_->setSite(label, site);
}

int DynamicDiagram::lowestFreeLabel() const {
  int label = 0;
  while (hasSite(label)) ++label;
  return label;
}

int DynamicDiagram::labelCount() const { return implementation_->labelCount(); }

bool DynamicDiagram::hasSite(int label) const {
  return implementation_->distances().sites().contains(label);
}

const SurfacePoint& DynamicDiagram::site(int label) const {
  implementation_->expectSite(label);
  return implementation_->distances().sites()[label];
}

std::vector<SurfacePoint> DynamicDiagram::sites() const {
  const SiteSet& all = implementation_->distances().sites();
  std::vector<SurfacePoint> sites;
  sites.reserve(all.labelCount());
  for (int label = 0; label < all.labelCount(); ++label) sites.push_back(all[label]);
  return sites;
}

const DistanceField& DynamicDiagram::distances() const { return implementation_->distances(); }

Diagram DynamicDiagram::diagram() const { return implementation_->whole(); }

}  // namespace gvd
