// SPDX-License-Identifier: MIT
#include "gvd/dynamic_diagram.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>

#include "continuation.h"
#include "dgpc_field.h"
#include "dgpc_sweep.h"
#include "gvd/error.h"
#include "index_set.h"
#include "trace_faces.h"

namespace gvd {
namespace {

/// Numbers places, each once: two are the same if they are written the same.
class PlaceIndex {
 public:
  int add(const SurfacePoint& place) {
    const auto [entry, isNew] = index_.try_emplace(place, static_cast<int>(places_.size()));
    if (isNew) places_.push_back(place);
    return entry->second;
  }

  std::vector<int> addAll(std::span<const SurfacePoint> places) {
    std::vector<int> indices;
    for (const SurfacePoint& p : places) indices.push_back(add(p));
    return indices;
  }

  std::vector<SurfacePoint> take() { return std::move(places_); }

 private:
  struct Hash {
    size_t operator()(const SurfacePoint& p) const {
      std::uint64_t hash = static_cast<std::uint64_t>(p.face);
      for (int i = 0; i < 2; ++i)
        hash = (hash ^ std::hash<double>()(p.bary[i])) * 0x9e3779b97f4a7c15u;
      return static_cast<size_t>(hash ^ hash >> 32);
    }
  };
  struct Equal {
    bool operator()(const SurfacePoint& a, const SurfacePoint& b) const {
      return a.face == b.face && a.bary == b.bary;
    }
  };

  std::unordered_map<SurfacePoint, int, Hash, Equal> index_;
  std::vector<SurfacePoint> places_;
};

/// A diagram in pieces that are replaced one by one; each has its own copy of its points.
class DiagramPieces {
 public:
  explicit DiagramPieces(int faceCount)
      : faceLabel_(faceCount, Diagram::kUnreachable), isIndifferent_(faceCount) {}

  /// The faces that a region has all of, ascending.
  const std::vector<int>& wholeFaces(int label) {
    std::vector<int>& faces = regions_[label].faces;
    std::erase_if(faces, [&](int f) { return faceLabel_[f] != label; });
    makeSet(faces);
    return faces;
  }

  void setArea(int label, double area) { regions_[label].area = area; }

  void replace(const DiagramChange& change) {
    removePieces(change);
    const Diagram& part = change.part;
    const auto places = [&](std::span<const int> points) {
      std::vector<SurfacePoint> list;
      for (const int p : points) list.push_back(part.points[p]);
      return list;
    };
    for (int i = 0; i < part.loops.size(); ++i)
      regions_[part.loopLabel[i]].loops.push_back(places(part.loops[i]));
    const size_t firstArc = arcs_.size();
    for (int i = 0; i < part.arcs.size(); ++i)
      arcs_.push_back({part.arcLabels[i], places(part.arcs[i]), {}});
    for (const Diagram::Segment& s : part.segments)
      arcs_[firstArc + s.arc].segments.push_back(
          {part.points[s.points[0]], part.points[s.points[1]], s.face});
    for (const Diagram::VoronoiPoint& v : part.voronoiPoints)
      voronoiPoints_.push_back({part.points[v.point], v.labels});
    for (size_t i = 0; i < change.faces.size(); ++i) {
      faceLabel_[change.faces[i]] = part.faceLabel[i];
      if (part.faceLabel[i] >= 0) regions_[part.faceLabel[i]].faces.push_back(change.faces[i]);
    }
    for (const int face : part.indifferentFaces) isIndifferent_[face] = true;
    for (int i = 0; i < part.cells.size(); ++i)
      cells_[part.cellFace[i]].push_back({part.cellLabel[i], places(part.cells[i])});
  }

  Diagram whole() const {
    Diagram out;
    PlaceIndex points;
    out.siteCount = static_cast<int>(regions_.size());
    for (const Arc& arc : arcs_) {
      const int index = out.arcs.size();
      for (const Segment& s : arc.segments)
        out.segments.push_back({{points.add(s.from), points.add(s.to)}, arc.labels, s.face, index});
      out.arcs.add(points.addAll(arc.points));
      out.arcLabels.push_back(arc.labels);
    }
    for (const VoronoiPoint& v : voronoiPoints_)
      out.voronoiPoints.push_back({points.add(v.place), v.labels});
    for (int label = 0; label < out.siteCount; ++label) {
      for (const auto& loop : regions_[label].loops) {
        out.loops.add(points.addAll(loop));
        out.loopLabel.push_back(label);
      }
      out.regionArea.push_back(regions_[label].area);
    }
    out.faceLabel = faceLabel_;
    for (int f = 0; f < static_cast<int>(faceLabel_.size()); ++f) {
      if (isIndifferent_[f]) out.indifferentFaces.push_back(f);
      const auto cells = cells_.find(f);
      if (cells == cells_.end()) continue;
      for (const Cell& cell : cells->second) {
        out.cells.add(points.addAll(cell.outline));
        out.cellFace.push_back(f);
        out.cellLabel.push_back(cell.label);
      }
    }
    out.points = points.take();
    return out;
  }

 private:
  struct Region {
    double area = 0;
    std::vector<std::vector<SurfacePoint>> loops;
    std::vector<int> faces;  ///< those it has all of, and some that it had
  };
  struct Segment {
    SurfacePoint from, to;
    int face;
  };
  struct Arc {
    std::array<int, 2> labels;
    std::vector<SurfacePoint> points;
    std::vector<Segment> segments;
  };
  struct VoronoiPoint {
    SurfacePoint place;
    std::vector<int> labels;
  };
  struct Cell {
    int label;
    std::vector<SurfacePoint> outline;
  };

  void removePieces(const DiagramChange& change) {
    if (!change.labels.empty() && change.labels.back() >= static_cast<int>(regions_.size()))
      regions_.resize(change.labels.back() + 1);
    std::vector<char> isOne(regions_.size());
    for (const int label : change.labels) {
      isOne[label] = true;
      regions_[label].loops.clear();
    }
    const auto is = [&](int label) { return isOne[label] != 0; };
    std::erase_if(arcs_, [&](const Arc& a) { return is(a.labels[0]) || is(a.labels[1]); });
    std::erase_if(voronoiPoints_, [&](const VoronoiPoint& v) {
      return std::any_of(v.labels.begin(), v.labels.end(), is);
    });
    for (const int face : change.faces) {
      cells_.erase(face);
      isIndifferent_[face] = false;
    }
  }

  std::vector<Region> regions_;
  std::vector<Arc> arcs_;
  std::vector<VoronoiPoint> voronoiPoints_;
  std::vector<int> faceLabel_;
  std::vector<char> isIndifferent_;
  std::unordered_map<int, std::vector<Cell>> cells_;  ///< by face
};

/// Copies what is wanted of a diagram, points numbered anew.
class Extract {
 public:
  Extract(const Diagram& from, std::vector<char> isOne)
      : from_(from), isOne_(std::move(isOne)), pointOf_(from.points.size(), -1) {}

  /// The loops, arcs and Voronoi points of the labels, and the cells of the faces.
  Diagram run(std::span<const int> faces) {
    out_.siteCount = from_.siteCount;
    addArcs();
    for (const Diagram::VoronoiPoint& v : from_.voronoiPoints)
      if (std::any_of(v.labels.begin(), v.labels.end(), [&](int l) { return isOne_[l]; }))
        out_.voronoiPoints.push_back({point(v.point), v.labels});
    for (int i = 0; i < from_.loops.size(); ++i) {
      if (!isOne_[from_.loopLabel[i]]) continue;
      addList(from_.loops[i], out_.loops);
      out_.loopLabel.push_back(from_.loopLabel[i]);
    }
    for (int i = 0; i < from_.cells.size(); ++i) {
      if (!std::binary_search(faces.begin(), faces.end(), from_.cellFace[i])) continue;
      addList(from_.cells[i], out_.cells);
      out_.cellFace.push_back(from_.cellFace[i]);
      out_.cellLabel.push_back(from_.cellLabel[i]);
    }
    std::set_intersection(from_.indifferentFaces.begin(), from_.indifferentFaces.end(),
                          faces.begin(), faces.end(), std::back_inserter(out_.indifferentFaces));
    return std::move(out_);
  }

 private:
  void addArcs() {
    std::vector<int> arcOf(from_.arcs.size(), -1);
    for (int i = 0; i < from_.arcs.size(); ++i) {
      const auto& labels = from_.arcLabels[i];
      if (!isOne_[labels[0]] && !isOne_[labels[1]]) continue;
      arcOf[i] = out_.arcs.size();
      addList(from_.arcs[i], out_.arcs);
      out_.arcLabels.push_back(labels);
    }
    for (const Diagram::Segment& s : from_.segments)
      if (arcOf[s.arc] >= 0)
        out_.segments.push_back(
            {{point(s.points[0]), point(s.points[1])}, s.labels, s.face, arcOf[s.arc]});
  }

  void addList(std::span<const int> points, PointLists& to) {
    list_.clear();
    for (const int p : points) list_.push_back(point(p));
    to.add(list_);
  }

  int point(int p) {
    if (pointOf_[p] < 0) {
      pointOf_[p] = static_cast<int>(out_.points.size());
      out_.points.push_back(from_.points[p]);
    }
    return pointOf_[p];
  }

  const Diagram& from_;
  const std::vector<char> isOne_;
  std::vector<int> pointOf_;
  std::vector<int> list_;
  Diagram out_;
};

}  // namespace

class DynamicDiagram::Implementation {
 public:
  Implementation(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                 const DiagramOptions& options)
      : mesh_(mesh),
        options_(options),
        sweep_(mesh, sites, Spread::kAsNeeded),
        pieces_(mesh.faceCount()) {
    while (!sweep_.step(std::numeric_limits<long>::max())) {
    }
    std::vector<LabelledDistance> nearest;
    std::vector<View> views;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      auto [site, view] = sweep_.nearest(v);
      nearest.push_back(site);
      views.push_back(view);
    }
    field_ =
        std::make_unique<DgpcField>(mesh, std::vector<SurfacePoint>(sites.begin(), sites.end()),
                                    std::move(nearest), std::move(views));
    continueOverBorders(*field_);
    for (int v = 0; v < mesh.vertexCount(); ++v) noteLabels(v);
    replaceAll();
  }

  int labelCount() const { return static_cast<int>(field_->sites().size()); }
  const DgpcField& field() const { return *field_; }
  Diagram whole() const { return pieces_.whole(); }

  bool hasSite(int label) const {
    return label >= 0 && label < labelCount() && field_->sites()[label].face >= 0;
  }

  void expectSite(int label) const {
    if (!hasSite(label))
      throw Error(ErrorCode::kInvalidArgument, "there is no site " + std::to_string(label));
  }

  /// Takes the site of a label away if it has one, and puts it to another place if one is given.
  DiagramChange setSite(int label, const SurfacePoint& site) {
    std::vector<int> changed;
    const auto noteCorners = [&](const SurfacePoint& p) {
      if (p.face < 0) return;
      for (int i = 0; i < 3; ++i) changed.push_back(mesh_.tail(3 * p.face + i));
    };
    if (hasSite(label)) noteCorners(field_->sites()[label]);
    noteCorners(site);
    sweep_.setSite(label, site);
    field_->setSite(label, site);
    for (const int v : sweep_.takeTouched()) {
      const auto [nearest, view] = sweep_.nearest(v);
      const LabelledDistance& before = field_->nearest(v);
      if (nearest.label == before.label && nearest.distance == before.distance &&
          view == field_->view(v))
        continue;
      changed.push_back(v);
      field_->setNearest(v, nearest, view);
    }
    makeSet(changed);
    LabelChange labels = continueOverBorders(*field_, changed);
    labels.labels.push_back(label);
    makeSet(labels.labels);
    for (const int v : labels.vertices) noteLabels(v);
    return trace(labels);
  }

 private:
  /// Keeps note of where labels meet.
  void noteLabels(int vertex) {
    const auto labels = field_->at(vertex);
    if (labels.size() < 2) return;
    for (const LabelledDistance& d : labels) {
      if (d.label >= static_cast<int>(sharedVertices_.size())) sharedVertices_.resize(d.label + 1);
      sharedVertices_[d.label].push_back(vertex);
    }
  }

  /// The vertices where a label and others are known, ascending.
  const std::vector<int>& sharedVertices(int label) {
    if (label >= static_cast<int>(sharedVertices_.size())) sharedVertices_.resize(label + 1);
    std::vector<int>& vertices = sharedVertices_[label];
    std::erase_if(vertices, [&](int v) {
      const auto labels = field_->at(v);
      return labels.size() < 2 || std::none_of(labels.begin(), labels.end(),
                                               [&](const auto& d) { return d.label == label; });
    });
    makeSet(vertices);
    return vertices;
  }

  /// Only in faces around the changed vertices, and by what the tracer completes in those beside
  /// them, can cells be others.
  DiagramChange trace(const LabelChange& change) {
    IndexSet faces(mesh_.faceCount());
    for (const int v : change.vertices) {
      addFacesAround(v, faces);
      mesh_.visitNeighbours(v, [&](int neighbour) { addFacesAround(neighbour, faces); });
    }
    const std::vector<int> tracedFaces = facesWhereMet(change.labels);
    TracedDiagram traced = traceFaces(mesh_, *field_, options_, tracedFaces, marks(change.labels));
    if (!traced.completedFaces.empty() || haveCommon(tracedFaces, completedFaces_))
      return replaceAll();
    const bool hadMerged = haveCommon(tracedFaces, mergedFaces_);
    if (traced.mergedFaces.empty() && !hadMerged)
      return replaced(change.labels, faces, traced.diagram, tracedFaces);
    mergedFaces_.insert(mergedFaces_.end(), traced.mergedFaces.begin(), traced.mergedFaces.end());
    makeSet(mergedFaces_);
    return traceWithOthers(change.labels, faces);
  }

  static bool haveCommon(std::span<const int> faces, std::span<const int> few) {
    return std::any_of(few.begin(), few.end(),
                       [&](int f) { return std::binary_search(faces.begin(), faces.end(), f); });
  }

  /// Traces all of the diagram.
  DiagramChange replaceAll() {
    TracedDiagram traced = traceAll(mesh_, *field_, labelCount(), options_);
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

  /// The same where points have become one, or have been. A bisector may then lie where a third
  /// label has no width left, so those that the changed labels may meet count as changed too, in
  /// all their faces; and all that those may meet are traced.
  DiagramChange traceWithOthers(const std::vector<int>& changed, IndexSet& faces) {
    const std::vector<int> labels = withThoseMet(changed);
    for (const int f : facesWhereMet(labels)) faces.add(f);
    const std::vector<int> traced = withThoseMet(labels), tracedFaces = facesWhereMet(traced);
    const Diagram part = traceFaces(mesh_, *field_, options_, tracedFaces, marks(traced)).diagram;
    return replaced(labels, faces, part, tracedFaces);
  }

  std::vector<char> marks(std::span<const int> labels) const {
    std::vector<char> isOne(labelCount());
    for (const int label : labels) isOne[label] = true;
    return isOne;
  }

  /// Some labels and those that are known at a vertex where one of them is; ascending.
  std::vector<int> withThoseMet(std::span<const int> labels) {
    IndexSet met(labelCount(), labels);
    for (const int label : labels)
      for (const int v : sharedVertices(label))
        for (const LabelledDistance& d : field_->at(v)) met.add(d.label);
    return met.sorted();
  }

  /// All faces of which several labels are known at a corner, one of the given ones among them;
  /// ascending.
  std::vector<int> facesWhereMet(std::span<const int> labels) {
    IndexSet faces(mesh_.faceCount());
    for (const int label : labels)
      for (const int v : sharedVertices(label)) addFacesAround(v, faces);
    return faces.sorted();
  }

  /// Puts what has been traced of the changed labels and faces in the place of what there was.
  DiagramChange replaced(const std::vector<int>& labels, const IndexSet& faces,
                         const Diagram& traced, std::span<const int> tracedFaces) {
    const IndexSet isTraced(mesh_.faceCount(), tracedFaces);
    DiagramChange change{labels, faces.sorted(), {}};
    change.part = Extract(traced, marks(labels)).run(change.faces);
    for (const int f : change.faces)
      change.part.faceLabel.push_back(
          isTraced.contains(f) ? traced.faceLabel[f] : field_->nearest(mesh_.tail(3 * f)).label);
    pieces_.replace(change);
    for (const int label : change.labels) {
      double area = traced.regionArea[label];
      for (const int f : pieces_.wholeFaces(label))
        if (!isTraced.contains(f)) area += mesh_.faceArea(f);
      change.part.regionArea.push_back(area);
      pieces_.setArea(label, area);
    }
    return change;
  }

  void addFacesAround(int vertex, IndexSet& faces) const {
    const int first = mesh_.outgoing(vertex);
    int h = first;
    do {
      faces.add(TriangleMesh::faceOf(h));
      h = mesh_.rotate(h);
    } while (h >= 0 && h != first);
  }

  const TriangleMesh& mesh_;
  DiagramOptions options_;
  DgpcSweep sweep_;
  std::unique_ptr<DgpcField> field_;
  DiagramPieces pieces_;
  // Ascending:
  std::vector<int> mergedFaces_;     ///< where points have become one since all was traced
  std::vector<int> completedFaces_;  ///< where the tracer had to add labels when all was traced
  /// Per label the vertices where others are known as well, and some where that was so.
  std::vector<std::vector<int>> sharedVertices_;
};

DynamicDiagram::DynamicDiagram(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                               const DiagramOptions& options)
    : implementation_(std::make_unique<Implementation>(mesh, sites, options)) {}

DynamicDiagram::~DynamicDiagram() = default;
DynamicDiagram::DynamicDiagram(DynamicDiagram&&) noexcept = default;
DynamicDiagram& DynamicDiagram::operator=(DynamicDiagram&&) noexcept = default;

DiagramChange DynamicDiagram::insertSite(const SurfacePoint& site) {
  return implementation_->setSite(lowestFreeLabel(), site);
}

DiagramChange DynamicDiagram::removeSite(int label) {
  implementation_->expectSite(label);
  return implementation_->setSite(label, {});
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

bool DynamicDiagram::hasSite(int label) const { return implementation_->hasSite(label); }

const SurfacePoint& DynamicDiagram::site(int label) const {
  implementation_->expectSite(label);
  return implementation_->field().sites()[label];
}

const DistanceField& DynamicDiagram::distances() const { return implementation_->field(); }

Diagram DynamicDiagram::diagram() const { return implementation_->whole(); }

}  // namespace gvd
