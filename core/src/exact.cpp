// SPDX-License-Identifier: MIT
// This work is based on:
// Joseph Mitchell, David Mount, Christos Papadimitriou. The Discrete Geodesic Problem. 1987
// Jindong Chen, Yijie Han. Shortest Paths on a Polyhedron. 1990
// Shi-Qing Xin, Guo-Jin Wang. Improving Chen and Han's Algorithm on the Discrete Geodesic
// Problem. 2009
// Chunxu Xu, Tuanfeng Wang, Yong-Jin Liu, Ligang Liu, Ying He. Fast Wavefront Propagation (FWP) for
// Computing Exact Geodesic Distances on Meshes. 2015
#include "exact.h"

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "edge_share.h"
#include "metric.h"

namespace gvd {
namespace exact {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Angle sums carry rounding; what is flat within it needs no virtual source.
constexpr double kAngleTolerance = 1e-12;

/// Beside a window, as a share of its halfedge, a vertex still gets the path that bends at the
/// window's end. Neighbouring windows leave gaps of rounding, some 2^-53 of the distance; this
/// covers them up to distances of 2^20 edges and more, and a bent path is never too short.
constexpr double kGrazing = 1e-7;

/// A label goes on where the best one is ahead by less than this share of a face's longest side.
/// It may be any number: what else is needed is found in the second stage.
constexpr double kOverlap = 0.25;

/// A site in a face or on its sides.
struct FaceSite {
  int label;
  Eigen::Vector3d bary;
  int next;
};

/// The coordinates of a point in those of side i.
Eigen::Vector2d layOut(const Frame& frame, int i, const Eigen::Vector3d& bary) {
  const double toTip = bary[Frame::after(i)], toApex = bary[Frame::before(i)];
  return {toTip * frame.length[i] + toApex * frame.apexX(i), toApex * frame.apexY(i)};
}

std::vector<Frame> layOutFaces(const TriangleMesh& mesh) {
  std::vector<Frame> frames(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    Frame& frame = frames[f];
    for (int i = 0; i < 3; ++i) {
      frame.length[i] = mesh.length(3 * f + i);
      frame.vertex[i] = mesh.tail(3 * f + i);
      frame.twin[i] = mesh.twin(3 * f + i);
      frame.firstWindow[i] = -1;
    }
    frame.firstSite = -1;
    frame.label = Frame::kNoLabel;
    const double longest = frame.longestSide();
    std::array<Eigen::Vector3d, 3> side;
    for (int i = 0; i < 3; ++i)
      side[i] =
          (mesh.position(frame.vertex[Frame::after(i)]) - mesh.position(frame.vertex[i])) / longest;
    // The area from the two shorter sides: its error is least there.
    const int far = frame.length[0] == longest ? 0 : frame.length[1] == longest ? 1 : 2;
    const double area2 = side[Frame::after(far)].cross(side[Frame::before(far)]).norm();
    for (int i = 0; i < 3; ++i) {
      const int j = Frame::before(i);
      const double product = (frame.length[i] / longest) * (frame.length[j] / longest);
      frame.cosine[i] = -side[i].dot(side[j]) / product;
      frame.sine[i] = area2 / product;
    }
  }
  return frames;
}

/// The same point of an edge, seen from the face on the other side.
SurfacePoint acrossEdge(const TriangleMesh& mesh, const SurfacePoint& p, int h) {
  const int twin = mesh.twin(h);
  SurfacePoint q{TriangleMesh::faceOf(twin), Eigen::Vector3d::Zero()};
  q.bary[twin % 3] = p.bary[Frame::after(h % 3)];
  q.bary[Frame::after(twin % 3)] = p.bary[h % 3];
  return q;
}

/// Where a point lies: the corner or side it is on, if any.
struct Place {
  int corner = -1;
  int side = -1;
};
Place placeOf(const Eigen::Vector3d& bary) {
  Place place;
  for (int i = 0; i < 3; ++i) {
    const bool first = bary[Frame::after(i)] == 0, second = bary[Frame::before(i)] == 0;
    if (first && second) return {i, -1};
    if (second) place.side = i;
  }
  return place;
}

// --- The result ----------------------------------------------------------------------------------

/// Distances at vertices, and windows from which the distances of all other points follow.
class Field final : public DistanceField {
 public:
  Field(const TriangleMesh& mesh, std::vector<Frame> frames, WindowPool windows,
        std::vector<FaceSite> sites, std::vector<int> offset, std::vector<LabelledDistance> values)
      : mesh_(mesh),
        frames_(std::move(frames)),
        windows_(std::move(windows)),
        sites_(std::move(sites)),
        offset_(std::move(offset)),
        values_(std::move(values)) {}

  std::span<const LabelledDistance> at(int vertex) const override {
    return {values_.data() + offset_[vertex], values_.data() + offset_[vertex + 1]};
  }

  LabelledDistance nearest(const SurfacePoint& p) const override {
    LabelledDistance best;
    double runnerUp = kInfinity;  // of another label
    visitPaths(p, [&](int label, double distance) {
      if (label == best.label) {
        best.distance = std::min(best.distance, distance);
      } else if (distance < best.distance) {
        runnerUp = best.distance;
        best = {label, distance};
      } else {
        runnerUp = std::min(runnerUp, distance);
      }
    });
    const double tie = best.distance * (1 + kDistanceTolerance);
    if (runnerUp > tie || best.label < 0) return best;
    visitPaths(p, [&](int label, double distance) {
      if (distance <= tie && label < best.label) best.label = label;
    });
    return best;
  }

  double distance(int label, const SurfacePoint& p) const override {
    for (int i = 0; i < 3; ++i)
      if (p.bary[i] > 0 && !isKnownAt(frames_[p.face].vertex[i], label)) return kInfinity;
    double least = kInfinity;
    visitPaths(p, [&](int pathLabel, double distance) {
      if (pathLabel == label) least = std::min(least, distance);
    });
    return least;
  }

 private:
  bool isKnownAt(int vertex, int label) const {
    for (const LabelledDistance& d : at(vertex))
      if (d.label == label) return true;
    return false;
  }

  /// Calls visit(label, length) for paths to a point that include the shortest of every label known
  /// there; the same ones, whichever face the point is given in.
  template <class Visit>
  void visitPaths(const SurfacePoint& p, Visit visit) const {
    const Place place = placeOf(p.bary);
    if (place.corner >= 0) {
      for (const LabelledDistance& d : at(frames_[p.face].vertex[place.corner]))
        visit(d.label, d.distance);
      return;
    }
    visitPathsInFace(p, visit);
    if (place.side >= 0 && frames_[p.face].twin[place.side] >= 0)
      visitPathsInFace(acrossEdge(mesh_, p, 3 * p.face + place.side), visit);
  }

  template <class Visit>
  void visitPathsInFace(const SurfacePoint& p, Visit visit) const {
    const Frame& frame = frames_[p.face];
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector2d q = layOut(frame, i, p.bary);
      const double toCorner = q.norm();
      for (const LabelledDistance& d : at(frame.vertex[i])) visit(d.label, d.distance + toCorner);
      for (int w = frame.firstWindow[i]; w >= 0; w = windows_[w].next)
        visit(windows_[w].label, windows_[w].distance(q.x(), q.y()));
    }
    for (int s = frame.firstSite; s >= 0; s = sites_[s].next)
      visit(sites_[s].label, layOut(frame, 0, p.bary - sites_[s].bary).norm());
  }

  const TriangleMesh& mesh_;
  std::vector<Frame> frames_;
  WindowPool windows_;
  std::vector<FaceSite> sites_;
  std::vector<int> offset_;
  std::vector<LabelledDistance> values_;
};

// --- Distances at vertices -----------------------------------------------------------------------

/// What one label knows at one vertex.
struct Entry {
  double distance;
  /// Where the path to the vertex enters its last face: a halfedge (the vertex is its apex) and the
  /// place on it. -1 for a site at the vertex.
  double crossing;
  int arrival;
  int label;
  int vertex;
  int demand;  ///< index of the demand for this distance, -1 if nothing depends on it
};

/// The distances of labels at vertices.
class VertexTable {
 public:
  explicit VertexTable(int vertexCount)
      : best_(vertexCount, {kInfinity, -1, -1}), slots_(4096, -1) {
    entries_.reserve(vertexCount + vertexCount / 4);
  }

  struct Best {
    double distance;
    int label;
    int entry;
  };
  const Best& best(int vertex) const { return best_[vertex]; }
  Entry& operator[](int entry) { return entries_[entry]; }
  const Entry& operator[](int entry) const { return entries_[entry]; }
  int size() const { return static_cast<int>(entries_.size()); }
  int vertexCount() const { return static_cast<int>(best_.size()); }

  int find(int vertex, int label) const {
    const Best& best = best_[vertex];
    if (best.label == label) return best.entry;
    if (best.label < 0) return -1;
    for (std::uint32_t s = hash(vertex, label);; ++s) {
      const int e = slots_[s & mask()];
      if (e < 0 || (entries_[e].vertex == vertex && entries_[e].label == label)) return e;
    }
  }
  double distance(int vertex, int label) const {
    const Best& best = best_[vertex];
    if (best.label == label) return best.distance;
    const int e = find(vertex, label);
    return e < 0 ? kInfinity : entries_[e].distance;
  }
  int findOrAdd(int vertex, int label) {
    const int found = find(vertex, label);
    if (found >= 0) return found;
    const int e = size();
    entries_.push_back({kInfinity, 0, -1, label, vertex, -1});
    if (2 * entries_.size() > slots_.size()) {
      slots_.assign(2 * slots_.size(), -1);
      for (int i = 0; i < e; ++i) place(i);
    }
    place(e);
    return e;
  }
  /// The entry gets a new distance, known to be less.
  void improve(int entry, double distance, int arrival, double crossing) {
    Entry& e = entries_[entry];
    e.distance = distance;
    e.arrival = arrival;
    e.crossing = crossing;
    Best& best = best_[e.vertex];
    if (best.label == e.label || distance < best.distance) best = {distance, e.label, entry};
  }

 private:
  std::uint32_t mask() const { return static_cast<std::uint32_t>(slots_.size()) - 1; }
  static std::uint32_t hash(int vertex, int label) {
    const std::uint64_t key =
        static_cast<std::uint64_t>(vertex) << 32 | static_cast<unsigned>(label);
    return static_cast<std::uint32_t>(key * 0x9E3779B97F4A7C15u >> 32);
  }
  void place(int entry) {
    std::uint32_t s = hash(entries_[entry].vertex, entries_[entry].label);
    while (slots_[s & mask()] >= 0) ++s;
    slots_[s & mask()] = entry;
  }

  std::vector<Best> best_;
  std::vector<Entry> entries_;
  std::vector<int> slots_;  ///< hash table of entries by vertex and label
};

// --- The queue -----------------------------------------------------------------------------------

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
      : mesh_(mesh), spread_(spread), frames_(layOutFaces(mesh)), table_(mesh.vertexCount()) {
    double sum = 0;
    for (const Frame& f : frames_) sum += f.length[0] + f.length[1] + f.length[2];
    bucketWidth_ = 0.5 * sum / mesh.halfedgeCount();
    for (int label = 0; label < static_cast<int>(sites.size()); ++label) start(label, sites[label]);
  }

  bool step(long budget) override {
    while (stage_ != Stage::kDone) {
      while (bucket_ < buckets_.size()) {
        Bucket& b = buckets_[bucket_];
        if (b.firstWindow >= 0) {
          if (budget-- <= 0) return false;
          const int id = b.firstWindow;
          b.firstWindow = windows_[id].next;
          popWindow(id);
        } else if (b.firstEvent >= 0) {
          if (budget-- <= 0) return false;
          const Event event = events_[b.firstEvent];
          b.firstEvent = event.next;
          popEvent(event);
        } else {
          ++bucket_;
        }
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
    return std::make_unique<Field>(mesh_, std::move(frames_), std::move(windows_),
                                   std::move(faceSites_), std::move(offset), std::move(values));
  }

 private:
  enum class Stage { kOwn, kComplete, kDone };
  struct Bucket {
    int firstWindow = -1, lastWindow = -1;
    int firstEvent = -1, lastEvent = -1;
  };
  /// A vertex to become a virtual source of a label, if its distance still is this one then.
  struct Event {
    int entry;
    int next;
    double distance;
  };

  // --- Sites ---

  void start(int label, const SurfacePoint& site) {
    const Place place = placeOf(site.bary);
    if (place.corner >= 0) {
      const int vertex = frames_[site.face].vertex[place.corner];
      offer(vertex, label, 0, -1, 0);
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
            std::clamp(below, 0.0, frame.length[i]));
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
      push(w, frame.length[i], table_.distance(frame.vertex[Frame::after(i)], label),
           table_.distance(frame.vertex[i], label));
    }
  }

  // --- Queue ---

  Bucket& bucketFor(double key) {
    const std::size_t b = std::max(bucket_, static_cast<std::size_t>(key / bucketWidth_));
    if (b >= buckets_.size()) buckets_.resize(b + 1);
    return buckets_[b];
  }

  /// Queues a window unless paths over the ends of its halfedge leave nothing of it.
  void push(Window& w, double length, double atTail, double atTip) {
    w.y = std::min(w.y, -0x1p-52 * length);
    trim(w, length, atTail, atTip);
    if (!(w.begin < w.end)) return;
    enqueue(windows_.add(w));
  }

  void enqueue(int id) {
    Bucket& b = bucketFor(windows_[id].least());
    windows_[id].next = -1;
    (b.firstWindow < 0 ? b.firstWindow : windows_[b.lastWindow].next) = id;
    b.lastWindow = id;
  }

  void enqueueEvent(int entry) {
    const double distance = table_[entry].distance;
    Bucket& b = bucketFor(distance);
    const int id = static_cast<int>(events_.size());
    events_.push_back({entry, -1, distance});
    (b.firstEvent < 0 ? b.firstEvent : events_[b.lastEvent].next) = id;
    b.lastEvent = id;
  }

  // --- Vertices ---

  bool bendsPaths(int vertex) const {
    return mesh_.angleSum(vertex) >
           (mesh_.onBoundary(vertex) ? kPi - kAngleTolerance : 2 * kPi + kAngleTolerance);
  }

  /// Takes the length of a path to a vertex if it is the shortest so far of its label. Returns the
  /// label's entry there.
  int offer(int vertex, int label, double distance, int arrival, double crossing) {
    const int entry = table_.findOrAdd(vertex, label);
    Entry& e = table_[entry];
    if (!(distance < e.distance)) return entry;
    if (table_.best(vertex).label < 0) ++reachedVertices_;
    table_.improve(entry, distance, arrival, crossing);
    if (e.demand >= 0) demands_[e.demand].bound = distance;
    if (arrival < 0 || bendsPaths(vertex)) enqueueEvent(entry);
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
      if (!isNeeded(e.label, mesh_.position(e.vertex), 0, e.distance, excess, {e.vertex, -1, -1})) {
        parkedEvents_.push_back(event.entry);
        return;
      }
    }
    bend(e);
  }

  /// A path's corner at a vertex: windows through the faces around it, as far as the path can go on
  /// there as a shortest one, with angles of π at least on both sides.
  void bend(const Entry& e) {
    fan_.clear();
    const int first = mesh_.outgoing(e.vertex);
    int o = first;
    do {
      fan_.push_back(o);
      o = mesh_.rotate(o);
    } while (o >= 0 && o != first);
    const bool closed = o >= 0;
    const int n = static_cast<int>(fan_.size());
    if (e.arrival < 0) {
      for (int o : fan_) emit(e, o, 0, oppositeLength(o));
      return;
    }
    int j0 = 0;
    while (fan_[j0] / 3 != e.arrival / 3) ++j0;
    const Frame& f0 = frames_[fan_[j0] / 3];
    const int i0 = fan_[j0] % 3;
    const double share = e.crossing / f0.length[Frame::after(i0)];
    Eigen::Vector2d back(
        (1 - share) * f0.length[i0] + share * f0.length[Frame::before(i0)] * f0.cosine[i0],
        share * f0.length[Frame::before(i0)] * f0.sine[i0]);
    back.normalize();
    double C = f0.cosine[i0] * back.x() + f0.sine[i0] * back.y();
    double S = std::max(0.0, f0.sine[i0] * back.x() - f0.cosine[i0] * back.y());
    int li = -1;
    Eigen::Vector2d ld(0, 0), rd(0, 0);
    for (int s = 1; s < (closed ? n : n - j0); ++s) {
      const int o = fan_[(j0 + s) % n];
      const double c = frames_[o / 3].cosine[o % 3], sn = frames_[o / 3].sine[o % 3];
      const double C2 = C * c - S * sn, S2 = S * c + C * sn;
      if (S2 < 0) {
        li = s;
        ld = {-C, S};
        break;
      }
      C = C2;
      S = S2;
    }
    int ri = -1;
    C = back.x();
    S = std::max(0.0, back.y());
    for (int s = 1; s < (closed ? n : j0 + 1); ++s) {
      const int o = fan_[(j0 - s + n) % n];
      const double c = frames_[o / 3].cosine[o % 3], sn = frames_[o / 3].sine[o % 3];
      const double C2 = C * c - S * sn, S2 = S * c + C * sn;
      if (S2 < 0) {
        ri = s;
        rd = {c * -C + sn * S, sn * -C - c * S};
        break;
      }
      C = C2;
      S = S2;
    }
    if (closed) {
      if (li < 0 || ri < 0) return;
      const int last = n - ri;
      for (int s = li; s <= last; ++s) {
        const int o = fan_[(j0 + s) % n];
        emit(e, o, s == li ? meetOpposite(o, ld) : 0,
             s == last ? meetOpposite(o, rd) : oppositeLength(o));
      }
    } else {
      if (li >= 0)
        for (int s = li; s < n - j0; ++s)
          emit(e, fan_[j0 + s], s == li ? meetOpposite(fan_[j0 + s], ld) : 0,
               oppositeLength(fan_[j0 + s]));
      if (ri >= 0)
        for (int s = ri; s <= j0; ++s)
          emit(e, fan_[j0 - s], 0,
               s == ri ? meetOpposite(fan_[j0 - s], rd) : oppositeLength(fan_[j0 - s]));
    }
  }

  double oppositeLength(int o) const { return frames_[o / 3].length[Frame::after(o % 3)]; }
  double meetOpposite(int o, const Eigen::Vector2d& d) const {
    const Frame& f = frames_[o / 3];
    const int i = o % 3, j = Frame::after(i);
    const double num = f.length[i] * d.y(), den = d.x() * f.sine[j] + d.y() * f.cosine[j];
    if (!(num > 0)) return 0;
    return den * f.length[j] > num ? num / den : f.length[j];
  }

  /// Lets a vertex see through the side opposite to it in the face of its outgoing halfedge o.
  void emit(const Entry& e, int o, double from, double to) {
    const Frame& f = frames_[o / 3];
    const int i = o % 3, j = Frame::after(i), k = Frame::before(i);
    const double length = f.length[j];
    if (from <= kGrazing * length)
      offer(f.vertex[j], e.label, e.distance + f.length[i], 3 * (o / 3) + k, f.length[k]);
    if (to >= (1 - kGrazing) * length) offer(f.vertex[k], e.label, e.distance + f.length[k], o, 0);
    if (f.twin[j] < 0) return;
    Window w;
    w.begin = length - to;
    w.end = length - from;
    w.x = length - f.length[i] * f.cosine[j];
    w.y = -f.length[i] * f.sine[j];
    w.sourceDistance = e.distance;
    w.label = e.label;
    w.halfedge = f.twin[j];
    push(w, length, table_.distance(f.vertex[k], e.label), table_.distance(f.vertex[j], e.label));
  }

  // --- Windows ---

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
      touch(w, frame, i);
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
    crossFace(w, frame, i, atTail, atTip);
  }

  void crossFace(const Window& w, const Frame& frame, int i, double atTail, double atTip) {
    const int j = Frame::after(i), k = Frame::before(i);
    const double length = frame.length[i];
    const double px = frame.apexX(i), py = frame.apexY(i);
    const double crossing = w.crossing(px, py);
    const int apex = frame.vertex[k];
    bool goLeft = frame.twin[k] >= 0 && crossing > w.begin,
         goRight = frame.twin[j] >= 0 && crossing < w.end;
    if (crossing >= w.begin - kGrazing * length && crossing <= w.end + kGrazing * length) {
      const double distance = w.distance(px, py);
      const Entry& e = table_[offer(apex, w.label, distance, w.halfedge, crossing)];
      if (e.arrival == w.halfedge &&
          distance > e.distance + kDistanceTolerance * (e.distance + length))
        (crossing < e.crossing ? goRight : goLeft) = false;
    }
    const double atApex = table_.distance(apex, w.label);
    Window child;
    child.sourceDistance = w.sourceDistance;
    child.label = w.label;
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

  struct Demand {
    Eigen::Vector3d position;
    double bound;  ///< the distance so far
    double best;
    int vertex;
    int label;
    int entry;
  };

  void demand(int face, int label) {
    const Frame& frame = frames_[face];
    std::array<int, 3> entry;
    for (int i = 0; i < 3; ++i) {
      entry[i] = table_.findOrAdd(frame.vertex[i], label);
      if (table_[entry[i]].demand < 0) {
        table_[entry[i]].demand = static_cast<int>(demands_.size());
        demands_.push_back({mesh_.position(frame.vertex[i]), table_[entry[i]].distance,
                            table_.best(frame.vertex[i]).distance, frame.vertex[i], label,
                            entry[i]});
      }
    }
    for (int i = 0; i < 3; ++i) {
      const int j = Frame::after(i), k = Frame::before(i);
      offer(frame.vertex[j], label, table_[entry[i]].distance + frame.length[i], 3 * face + k,
            frame.length[k]);
      offer(frame.vertex[k], label, table_[entry[i]].distance + frame.length[k], 3 * face + i, 0);
    }
  }

  /// Offers a window's paths to those corners of its face where they are asked for.
  void touch(const Window& w, const Frame& frame, int i) {
    const int j = Frame::after(i), k = Frame::before(i), base = w.halfedge - i;
    const auto touchCorner = [&](int corner, double distance, int arrival, double crossing) {
      const int e = table_.find(frame.vertex[corner], w.label);
      if (e >= 0 && table_[e].demand >= 0 &&
          distance < table_[e].distance * (1 - kDistanceTolerance))
        offer(frame.vertex[corner], w.label, distance, arrival, crossing);
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
    return isNeeded(w.label, m, w.end - middle, w.least(), excess,
                    {frame.vertex[i], frame.vertex[j], frame.vertex[k]});
  }

  /// Whether a path of at least the given length up to a point at most `radius` from `place` can
  /// become the shortest of its label to a vertex that asks for it.
  bool isNeeded(int label, const Eigen::Vector3d& place, double radius, double length,
                double excess, const std::array<int, 3>& without) {
    for (int d = firstDemand_[label]; d < firstDemand_[label + 1]; ++d) {
      const Demand& demand = demands_[d];
      const double rest = demand.bound * (1 - kDistanceTolerance) - length + radius;
      if (rest <= 0 || excess >= demand.bound - demand.best) continue;
      if ((demand.position - place).squaredNorm() >= rest * rest) continue;
      if (demand.vertex == without[0] || demand.vertex == without[1] || demand.vertex == without[2])
        continue;
      return true;
    }
    return false;
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
    bucket_ = 0;
    int labels = 0;
    for (const Demand& d : demands_) labels = std::max(labels, d.label + 1);
    for (int id : parked_) labels = std::max(labels, windows_[id].label + 1);
    for (int e : parkedEvents_) labels = std::max(labels, table_[e].label + 1);
    firstDemand_.assign(labels + 1, 0);
    for (const Demand& d : demands_) ++firstDemand_[d.label + 1];
    std::partial_sum(firstDemand_.begin(), firstDemand_.end(), firstDemand_.begin());
    std::vector<int> cursor(firstDemand_.begin(), firstDemand_.end() - 1);
    std::vector<Demand> sorted(demands_.size());
    for (const Demand& d : demands_) {
      table_[d.entry].demand = cursor[d.label];
      sorted[cursor[d.label]++] = d;
    }
    demands_.swap(sorted);
    for (int id : parked_)
      touch(windows_[id], frames_[windows_[id].halfedge / 3], windows_[id].halfedge % 3);
    for (const int id : std::exchange(parked_, {})) enqueue(id);
    for (const int e : std::exchange(parkedEvents_, {})) enqueueEvent(e);
  }

  bool owns(Window w, const Frame& frame, int i) {
    const auto &bestTail = table_.best(frame.vertex[i]),
               &bestTip = table_.best(frame.vertex[Frame::after(i)]);
    trim(w, frame.length[i], bestTail.distance, bestTip.distance);
    if (!(w.begin < w.end)) return false;
    return true;
  }

  const TriangleMesh& mesh_;
  Spread spread_;
  std::vector<Frame> frames_;
  std::vector<FaceSite> faceSites_;
  VertexTable table_;
  WindowPool windows_;
  std::vector<Event> events_;
  std::vector<Bucket> buckets_;
  std::size_t bucket_ = 0;
  double bucketWidth_;
  Stage stage_ = Stage::kOwn;
  std::vector<int> parked_, parkedEvents_;
  std::vector<Demand> demands_;
  std::vector<int> firstDemand_;
  std::vector<int> fan_;
  int reachedVertices_ = 0;
};

}  // namespace
}  // namespace exact

std::unique_ptr<Propagation> propagateExact(const TriangleMesh& mesh,
                                            std::span<const SurfacePoint> sites, Spread spread) {
  return std::make_unique<exact::Sweep>(mesh, sites, spread);
}

}  // namespace gvd
