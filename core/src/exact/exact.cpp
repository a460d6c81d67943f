// SPDX-License-Identifier: MIT
// This work is based on:
// Joseph Mitchell, David Mount, Christos Papadimitriou. The Discrete Geodesic Problem. 1987
// Jindong Chen, Yijie Han. Shortest Paths on a Polyhedron. 1990
// Shi-Qing Xin, Guo-Jin Wang. Improving Chen and Han's Algorithm on the Discrete Geodesic
// Problem. 2009
#include <Eigen/Geometry>
#include <array>
#include <numeric>
#include <span>
#include <utility>

#include "distance/edge_share.h"
#include "distance/metric.h"
#include "exact/exact_bend.h"
#include "exact/exact_demands.h"
#include "exact/exact_field.h"
#include "exact/exact_frame.h"
#include "exact/exact_queue.h"
#include "exact/exact_vertices.h"
#include "exact/exact_window.h"

namespace gvd {
namespace exact {
namespace {

/// Beside a window, as a share of its halfedge, a vertex still gets the path that bends at the
/// window's end. Neighbouring windows leave gaps of rounding, some 2^-53 of the distance; this
/// covers them up to distances of 2^20 edges and more, and a bent path is never too short.
constexpr double kGrazing = 1e-7;

/// A label goes on where the best one is ahead by less than this share of a face's longest side.
/// It may be any number: what else is needed is found in the second stage.
constexpr double kOverlap = 0.25;

/// Windows of all sites at once.
///
/// Stage 1: every label spreads over what it owns, and stops where another one is ahead; what stops
/// is parked. Shortest paths run inside their region, so this gives the nearest label and its
/// distance everywhere.
///
/// Stage 2: the diagram also needs the distances of labels at those corners of the faces they share
/// with others that they do not own. These are demands; what is parked goes on as long as it can
/// still shorten one: its length so far and the straight way to the vertex are less than the
/// distance known there.
class Sweep final : public Propagation {
 public:
  Sweep(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Spread spread)
      : mesh_(mesh),
        sites_(sites.begin(), sites.end()),
        spread_(spread),
        frames_(layOutFaces(mesh)),
        table_(mesh.vertexCount()),
        queue_(bucketWidth(frames_)),
        bend_(mesh, frames_),
        demands_(static_cast<int>(sites.size())) {
    for (int label = 0; label < static_cast<int>(sites.size()); ++label) start(label, sites[label]);
  }

  bool step(long budget) override {
    while (stage_ != Stage::kDone) {
      while (!queue_.isEmpty()) {
        if (budget-- <= 0) return false;
        if (queue_.hasWindow())
          popWindow(queue_.takeWindow(windows_));
        else
          popEvent(queue_.takeEvent());
      }
      if (stage_ == Stage::kOwn) {
        stage_ = Stage::kComplete;
        demandOwners();
        resume();
      } else if (demandNeighbours()) {
        resume();
      } else {
        stage_ = Stage::kDone;
      }
    }
    return true;
  }

  double progress() const override {
    return stage_ == Stage::kDone
               ? 1.0
               : std::min(0.99, static_cast<double>(reachedVertices_) / table_.vertexCount());
  }

  std::unique_ptr<DistanceField> take() override {
    auto [offset, values] = listValues();
    return std::make_unique<Field>(mesh_, std::move(sites_), std::move(frames_),
                                   std::move(windows_), std::move(faceSites_), std::move(table_),
                                   std::move(offset), std::move(values));
  }

 private:
  enum class Stage { kOwn, kComplete, kDone };

  /// Half the mean side.
  static double bucketWidth(std::span<const Frame> frames) {
    double sum = 0;
    for (const Frame& f : frames) sum += f.length[0] + f.length[1] + f.length[2];
    return 0.5 * sum / (3 * static_cast<double>(frames.size()));
  }

  // --- Sites ---

  void start(int label, const SurfacePoint& site) {
    const Place place = placeOf(site.bary);
    if (place.corner >= 0) {
      const int vertex = frames_[site.face].vertex[place.corner];
      offer(vertex, label, 0, -1, 0, kFromSite);
      return;
    }
    startInFace(label, site, place.side);
    if (place.side >= 0 && frames_[site.face].twin[place.side] >= 0) {
      const SurfacePoint across = acrossEdge(mesh_, site, 3 * site.face + place.side);
      startInFace(label, across, placeOf(across.bary).side);
    }
  }

  /// Lets a site in a face see the face's corners and through its sides, but for the one it is on.
  void startInFace(int label, const SurfacePoint& site, int itsSide) {
    Frame& frame = frames_[site.face];
    frame.add(label);
    faceSites_.push_back({label, site.bary, frame.firstSite});
    frame.firstSite = static_cast<int>(faceSites_.size()) - 1;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector2d toApex =
          layOut(frame, i, Eigen::Vector3d::Unit(Frame::before(i)) - site.bary);
      const Eigen::Vector2d s = layOut(frame, i, site.bary);
      const double below = toApex.y() > 0 ? s.x() - toApex.x() * (s.y() / toApex.y()) : s.x();
      offer(frame.vertex[Frame::before(i)], label, toApex.norm(), 3 * site.face + i,
            std::clamp(below, 0.0, frame.length[i]), kFromSite);
    }
    for (int i = 0; i < 3; ++i) {
      if (i == itsSide || frame.twin[i] < 0) continue;
      const Eigen::Vector2d s = layOut(frame, i, site.bary);
      Window w;
      w.begin = 0;
      w.end = frame.length[i];
      w.x = frame.length[i] - s.x();
      w.y = -s.y();
      w.sourceDistance = 0;
      w.label = label;
      w.halfedge = frame.twin[i];
      w.origin = kFromSite;
      push(w, frame.length[i], table_.distance(frame.vertex[Frame::after(i)], label),
           table_.distance(frame.vertex[i], label));
    }
  }

  // --- Vertices ---

  /// Takes the length of a path to a vertex if it is the shortest so far of its label. Returns the
  /// label's entry there.
  int offer(int vertex, int label, double distance, int arrival, double crossing, int origin) {
    const int entry = table_.findOrAdd(vertex, label);
    Entry& e = table_[entry];
    if (!(distance < e.distance)) return entry;
    if (table_.best(vertex).label < 0) ++reachedVertices_;
    table_.improve(entry, distance, arrival, crossing, origin);
    if (e.demand >= 0) demands_.shorten(e.demand, distance);
    if (arrival < 0 || bendsPaths(mesh_, vertex)) queue_.addEvent(entry, distance);
    return entry;
  }

  void popEvent(const Event& event) {
    const Entry e = table_[event.entry];
    if (e.distance != event.distance) return;
    const double excess = e.distance - table_.best(e.vertex).distance;
    if (spread_ == Spread::kAsNeeded && e.arrival >= 0 &&
        excess > kOverlap * frames_[e.arrival / 3].longestSide()) {
      if (stage_ == Stage::kOwn) {
        parkedEvents_.push_back(event.entry);
        return;
      }
      if (!demands_.isNeeded(e.label, mesh_.position(e.vertex), 0, e.distance, excess,
                             {e.vertex, -1, -1})) {
        parkedEvents_.push_back(event.entry);
        return;
      }
    }
    for (const OppositeSide& side : bend_.sidesBehind(e.vertex, e.arrival, e.crossing))
      emit(event.entry, side.outgoing, side.from, side.to);
  }

  /// Lets a vertex see through the side opposite to it in the face of its outgoing halfedge o.
  void emit(int entry, int o, double from, double to) {
    const Entry e = table_[entry];
    const int origin = fromVertex(entry);
    const Frame& f = frames_[o / 3];
    const int i = o % 3, j = Frame::after(i), k = Frame::before(i);
    const double length = f.length[j];
    if (from <= kGrazing * length)
      offer(f.vertex[j], e.label, e.distance + f.length[i], 3 * (o / 3) + k, f.length[k], origin);
    if (to >= (1 - kGrazing) * length)
      offer(f.vertex[k], e.label, e.distance + f.length[k], o, 0, origin);
    if (f.twin[j] < 0) return;
    Window w;
    w.begin = length - to;
    w.end = length - from;
    w.x = length - f.length[i] * f.cosine[j];
    w.y = -f.length[i] * f.sine[j];
    w.sourceDistance = e.distance;
    w.label = e.label;
    w.halfedge = f.twin[j];
    w.origin = origin;
    push(w, length, table_.distance(f.vertex[k], e.label), table_.distance(f.vertex[j], e.label));
  }

  // --- Windows ---

  /// Queues a window unless paths over the ends of its halfedge leave nothing of it.
  void push(Window& w, double length, double atTail, double atTip) {
    w.y = std::min(w.y, -0x1p-52 * length);
    trim(w, length, atTail, atTip);
    if (!(w.begin < w.end)) return;
    queue_.addWindow(windows_, windows_.add(w));
  }

  void popWindow(int id) {
    Window& w = windows_[id];
    Frame& frame = frames_[w.halfedge / 3];
    const int i = w.halfedge % 3;
    const double length = frame.length[i];
    const int tail = frame.vertex[i], tip = frame.vertex[Frame::after(i)];
    const double atTail = table_.distance(tail, w.label), atTip = table_.distance(tip, w.label);
    trim(w, length, atTail, atTip);
    if (!(w.begin < w.end)) return;
    double excess = -kInfinity;
    const auto &bestTail = table_.best(tail), &bestTip = table_.best(tip);
    if (bestTail.label != w.label) excess = w.distanceOnEdge(w.end) - (bestTail.distance + w.end);
    if (bestTip.label != w.label)
      excess = std::max(excess, w.distanceOnEdge(w.begin) - (bestTip.distance + length - w.begin));
    if (spread_ == Spread::kAsNeeded && excess > kOverlap * frame.longestSide()) {
      if (stage_ == Stage::kOwn) {
        parked_.push_back(id);
        return;
      }
      w.next = frame.firstWindow[i];
      frame.firstWindow[i] = id;
      touch(id, frame, i);
      if (!isNeeded(w, frame, i, excess)) {
        const Window again = w;
        parked_.push_back(windows_.add(again));  // for this one is listed at its face now
        return;
      }
    } else {
      frame.add(w.label);
      w.next = frame.firstWindow[i];
      frame.firstWindow[i] = id;
    }
    crossFace(id, frame, i, atTail, atTip);
  }

  void crossFace(int id, const Frame& frame, int i, double atTail, double atTip) {
    const Window& w = windows_[id];
    const int j = Frame::after(i), k = Frame::before(i);
    const double length = frame.length[i];
    const double px = frame.apexX(i), py = frame.apexY(i);
    const double crossing = w.crossing(px, py);
    const int apex = frame.vertex[k];
    bool goLeft = frame.twin[k] >= 0 && crossing > w.begin,
         goRight = frame.twin[j] >= 0 && crossing < w.end;
    if (crossing >= w.begin - kGrazing * length && crossing <= w.end + kGrazing * length) {
      const double distance = w.distance(px, py);
      const Entry& e = table_[offer(apex, w.label, distance, w.halfedge, crossing, id)];
      if (e.arrival == w.halfedge &&
          distance > e.distance + kDistanceTolerance * (e.distance + length))
        (crossing < e.crossing ? goRight : goLeft) = false;
    }
    const double atApex = table_.distance(apex, w.label);
    Window child;
    child.sourceDistance = w.sourceDistance;
    child.label = w.label;
    child.origin = id;
    if (goLeft) {
      const double c = frame.cosine[i], s = frame.sine[i], side = frame.length[k];
      child.begin = meetSide(w.begin, w.x, w.y, c, s, side);
      child.end = crossing < w.end ? side : meetSide(w.end, w.x, w.y, c, s, side);
      child.x = w.x * c + w.y * s;
      child.y = w.y * c - w.x * s;
      child.halfedge = frame.twin[k];
      push(child, side, atTail, atApex);
    }
    if (goRight) {
      const double c = frame.cosine[j], s = frame.sine[j], side = frame.length[j], x = length - w.x;
      child.begin = crossing > w.begin ? 0 : side - meetSide(length - w.begin, x, w.y, c, s, side);
      child.end = side - meetSide(length - w.end, x, w.y, c, s, side);
      child.x = side - (x * c + w.y * s);
      child.y = w.y * c - x * s;
      child.halfedge = frame.twin[j];
      push(child, side, atApex, atTip);
    }
  }

  // --- Stage 2 ---

  /// Asks for the distances of a label at the corners of a face.
  void demand(int face, int label) {
    const Frame& frame = frames_[face];
    std::array<int, 3> entry;
    for (int i = 0; i < 3; ++i) {
      entry[i] = table_.findOrAdd(frame.vertex[i], label);
      demands_.add(mesh_, table_, entry[i]);
    }
    for (int i = 0; i < 3; ++i) {
      const int j = Frame::after(i), k = Frame::before(i);
      offer(frame.vertex[j], label, table_[entry[i]].distance + frame.length[i], 3 * face + k,
            frame.length[k], fromVertex(entry[i]));
      offer(frame.vertex[k], label, table_[entry[i]].distance + frame.length[k], 3 * face + i, 0,
            fromVertex(entry[i]));
    }
  }

  /// Offers a window's paths to those corners of its face where they are asked for.
  void touch(int id, const Frame& frame, int i) {
    const Window& w = windows_[id];
    const int j = Frame::after(i), k = Frame::before(i), base = w.halfedge - i;
    const auto touchCorner = [&](int corner, double distance, int arrival, double crossing) {
      const int e = table_.find(frame.vertex[corner], w.label);
      if (e >= 0 && table_[e].demand >= 0 &&
          distance < table_[e].distance * (1 - kDistanceTolerance))
        offer(frame.vertex[corner], w.label, distance, arrival, crossing, id);
    };
    const double px = frame.apexX(i), py = frame.apexY(i), length = frame.length[i];
    touchCorner(k, w.distance(px, py), w.halfedge, std::clamp(w.crossing(px, py), w.begin, w.end));
    // Along the halfedge from an end of the window; what looks at a corner directly has already
    // reached it, and from its own direction.
    if (w.begin > kGrazing * length)
      touchCorner(i, w.distanceOnEdge(w.begin) + w.begin, base + j, 0);
    if (w.end < (1 - kGrazing) * length)
      touchCorner(j, w.distanceOnEdge(w.end) + length - w.end, base + k, frame.length[k]);
  }

  bool isNeeded(const Window& w, const Frame& frame, int i, double excess) {
    const int j = Frame::after(i), k = Frame::before(i);
    const double middle = (w.begin + w.end) / 2, share = middle / frame.length[i];
    const Eigen::Vector3d m =
        (1 - share) * mesh_.position(frame.vertex[i]) + share * mesh_.position(frame.vertex[j]);
    return demands_.isNeeded(w.label, m, w.end - middle, w.least(), excess,
                             {frame.vertex[i], frame.vertex[j], frame.vertex[k]});
  }

  /// Demands, at all corners of each face, the labels that own something in it.
  void demandOwners() {
    std::vector<int> owners;
    for (int f = 0; f < mesh_.faceCount(); ++f) {
      const Frame& frame = frames_[f];
      const int label = table_.best(frame.vertex[0]).label;
      if (frame.label != Frame::kSeveralLabels &&
          (frame.label == Frame::kNoLabel || frame.label == label) &&
          table_.best(frame.vertex[1]).label == label &&
          table_.best(frame.vertex[2]).label == label)
        continue;
      owners.clear();
      const auto isOwner = [&](int l) {
        return std::find(owners.begin(), owners.end(), l) != owners.end();
      };
      for (int i = 0; i < 3; ++i) {
        const int l = table_.best(frame.vertex[i]).label;
        if (l >= 0 && !isOwner(l)) owners.push_back(l);
      }
      for (int s = frame.firstSite; s >= 0; s = faceSites_[s].next)
        if (!isOwner(faceSites_[s].label)) owners.push_back(faceSites_[s].label);
      for (int i = 0; i < 3; ++i)
        for (int w = frame.firstWindow[i]; w >= 0; w = windows_[w].next)
          if (!isOwner(windows_[w].label) && owns(windows_[w], frame, i))
            owners.push_back(windows_[w].label);
      for (int l : owners) demand(f, l);
    }
    // Ties at vertices: each of the labels may own points around.
    const int count = table_.size();
    for (int e = 0; e < count; ++e) {
      const Entry entry = table_[e];
      const auto& best = table_.best(entry.vertex);
      if (best.entry == e || entry.distance > best.distance * (1 + kDistanceTolerance)) continue;
      int o = mesh_.outgoing(entry.vertex);
      const int first = o;
      do {
        demand(o / 3, entry.label);
        o = mesh_.rotate(o);
      } while (o >= 0 && o != first);
    }
  }

  /// The diagram takes distances within a face to be those of a plane. If that shows a label on a
  /// side of a face of which it does not know the third corner, that is demanded too. Returns
  /// whether there was any.
  bool demandNeighbours() {
    const Values listed = listValues();
    const auto at = [&](int v) {
      return std::span(listed.values.data() + listed.offset[v],
                       listed.values.data() + listed.offset[v + 1]);
    };
    const auto find = [&](int v, int label) {
      for (const LabelledDistance& d : at(v))
        if (d.label == label) return d.distance;
      return kInfinity;
    };
    bool found = false;
    for (int h = 0; h < mesh_.halfedgeCount(); ++h) {
      const int tail = mesh_.tail(h), tip = mesh_.tip(h);
      if (at(tail).size() < 2 && at(tip).size() < 2) continue;
      const int apex = mesh_.tail(TriangleMesh::previous(h));
      for (const LabelledDistance& d : at(tail)) {
        const double atTip = find(tip, d.label);
        if (atTip == kInfinity || find(apex, d.label) < kInfinity) continue;
        EdgeShare share(d.label, d.distance, atTip);
        for (const LabelledDistance& other : at(tail))
          if (const double otherAtTip = find(tip, other.label);
              other.label != d.label && otherAtTip < kInfinity)
            share.yieldTo(other.label, other.distance, otherAtTip);
        if (share.isEmpty()) continue;
        demand(h / 3, d.label);
        found = true;
      }
    }
    return found;
  }

  struct Values {
    std::vector<int> offset;  ///< of vertex v: values[offset[v]] up to values[offset[v + 1]]
    std::vector<LabelledDistance> values;
  };
  /// The nearest label of each vertex and those demanded there, ascending.
  Values listValues() const {
    std::vector<int> offset(table_.vertexCount() + 1, 0);
    const auto isListed = [&](int e) {
      return spread_ == Spread::kEverywhere || table_[e].demand >= 0 ||
             table_.best(table_[e].vertex).entry == e;
    };
    for (int e = 0; e < table_.size(); ++e) offset[table_[e].vertex + 1] += isListed(e);
    std::partial_sum(offset.begin(), offset.end(), offset.begin());
    std::vector<LabelledDistance> values(offset.back()), here;
    std::vector<int> cursor(offset.begin(), offset.end() - 1);
    for (int e = 0; e < table_.size(); ++e)
      if (isListed(e)) values[cursor[table_[e].vertex]++] = {table_[e].label, table_[e].distance};
    for (int v = 0; v < table_.vertexCount(); ++v) {
      if (offset[v + 1] - offset[v] < 2) continue;
      here.assign(values.begin() + offset[v], values.begin() + offset[v + 1]);
      equalizeTies(here);
      std::copy(here.begin(), here.end(), values.begin() + offset[v]);
    }
    return {std::move(offset), std::move(values)};
  }

  /// Takes up what is parked, for the demands made.
  void resume() {
    queue_.rewind();
    demands_.index(table_);
    for (int id : parked_) touch(id, frames_[windows_[id].halfedge / 3], windows_[id].halfedge % 3);
    for (const int id : std::exchange(parked_, {})) queue_.addWindow(windows_, id);
    for (const int e : std::exchange(parkedEvents_, {})) queue_.addEvent(e, table_[e].distance);
  }

  bool owns(Window w, const Frame& frame, int i) {
    const auto &bestTail = table_.best(frame.vertex[i]),
               &bestTip = table_.best(frame.vertex[Frame::after(i)]);
    trim(w, frame.length[i], bestTail.distance, bestTip.distance);
    return w.begin < w.end;
  }

  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> sites_;
  Spread spread_;
  std::vector<Frame> frames_;
  std::vector<FaceSite> faceSites_;
  VertexTable table_;
  WindowPool windows_;
  WavefrontQueue queue_;
  Bend bend_;
  Stage stage_ = Stage::kOwn;
  std::vector<int> parked_, parkedEvents_;
  Demands demands_;
  int reachedVertices_ = 0;
};

}  // namespace
}  // namespace exact

std::unique_ptr<Propagation> propagateExact(const TriangleMesh& mesh,
                                            std::span<const SurfacePoint> sites, Spread spread) {
  return std::make_unique<exact::Sweep>(mesh, sites, spread);
}

}  // namespace gvd