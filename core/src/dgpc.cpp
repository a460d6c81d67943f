// SPDX-License-Identifier: MIT
// This work is based on:
// Eivind Lyche Melvær, Martin Reimers. Geodesic Polar Coordinates on Polygonal Meshes. 2012
// Eivind Lyche Melvær, Martin Reimers. Approximating Geodesic Voronoi Diagrams on Triangulated
// Surfaces. 2014
#include <algorithm>
#include <cmath>
#include <utility>

#include "heap.h"
#include "metric.h"
#include "surface_geometry.h"
#include "tolerances.h"

namespace gvd {
namespace {

/// What one label knows at one vertex. Entry v is the first one of vertex v, further ones follow
/// behind those of all vertices: most vertices need no more than the first.
struct Entry {
  double distance = kInfinity;
  int label = -1;
  int vertex = -1;
  int next = -1;  ///< the next entry of the same vertex, -1 at the end
};

struct QueueItem {
  double distance;
  int entry;
  /// By distance; then by entry, which makes the order total. A label's own entries keep their
  /// order whatever the other labels do, so permuting the sites permutes the result.
  bool operator<(const QueueItem& other) const {
    return distance < other.distance || (distance == other.distance && entry < other.entry);
  }
};

/// The distance at the apex of a halfedge by the Euclidean interpolant: the virtual source has the
/// given distances from the halfedge's ends and lies across it (section 2 of the draft). Infinity
/// if there is none, if the straight line from it to the apex does not cross the halfedge, or if it
/// is no shorter than `known`.
double unfold(const TriangleMesh::Layout& apex, double atTail, double atTip, double known) {
  const double d = apex.length;
  const double difference = atTail - atTip, sum = atTail + atTip;
  const double x = (difference * sum + d * d) * apex.inverse;
  // y², by Heron's product: c² - x² would cancel.
  const double product = (d - difference) * (d + difference) * (sum - d) * (sum + d);
  const double ySquared = product * (apex.inverse * apex.inverse);
  const double dx = apex.x - x;
  // The apex is not nearer to the source than y and its own height make it, which spares the root
  // wherever the wave has come from the apex's side.
  if (!(dx * dx + apex.y * apex.y + ySquared < known * known)) return kInfinity;
  // Below zero the two distances fit no triangle. A source on the edge itself makes it zero, up to
  // rounding of sum - d.
  if (product < 0 && !(std::abs(sum - d) <= kDistanceTolerance * d && std::abs(difference) <= d))
    return kInfinity;
  const double y = product > 0 ? std::sqrt(ySquared) : 0.0;
  const double height = apex.y + y;
  const double crossing = x * apex.y + apex.x * y;  // times height
  if (crossing < 0 || crossing > d * height) return kInfinity;
  return std::sqrt(dx * dx + height * height);
}

/// A field of DGPC distances: per vertex the labels that may own a point of a face around it.
class DgpcField final : public DistanceField {
 public:
  DgpcField(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
            const std::vector<Entry>& entries)
      : mesh_(mesh), sites_(sites.begin(), sites.end()) {
    offset_.reserve(mesh.vertexCount() + 1);
    values_.reserve(entries.size());
    offset_.push_back(0);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      for (int e = v; e >= 0 && entries[e].label >= 0; e = entries[e].next)
        values_.push_back({entries[e].label, entries[e].distance});
      std::sort(values_.begin() + offset_.back(), values_.end(),
                [](const auto& a, const auto& b) { return a.label < b.label; });
      offset_.push_back(static_cast<int>(values_.size()));
    }
  }

  std::span<const LabelledDistance> at(int vertex) const override {
    return {values_.data() + offset_[vertex], values_.data() + offset_[vertex + 1]};
  }

  LabelledDistance nearest(const SurfacePoint& p) const override {
    LabelledDistance best;
    double least = kInfinity;
    for (const LabelledDistance& candidate : at(mesh_.tail(3 * p.face))) {
      const double value = interpolate(candidate.label, p);
      if (value < least) {
        least = value;
        best.label = candidate.label;
      }
    }
    if (best.label >= 0) best.distance = distanceFrom(best.label, p, least);
    return best;
  }

  double distance(int label, const SurfacePoint& p) const override {
    const double value = interpolate(label, p);
    return value == kInfinity ? kInfinity : distanceFrom(label, p, value);
  }

 private:
  double find(int vertex, int label) const {
    const auto labels = at(vertex);
    const auto it = std::lower_bound(labels.begin(), labels.end(), label,
                                     [](const LabelledDistance& d, int l) { return d.label < l; });
    return it != labels.end() && it->label == label ? it->distance : kInfinity;
  }

  /// The linear interpolant of squared distance, which decides between labels.
  double interpolate(int label, const SurfacePoint& p) const {
    double value = 0;
    for (int i = 0; i < 3; ++i) {
      const double d = find(mesh_.tail(3 * p.face + i), label);
      if (d == kInfinity) return kInfinity;
      value += p.bary[i] * d * d;
    }
    return value;
  }

  /// The distance itself: what the interpolant has too much is the same for every label,
  /// Σ bᵢ bⱼ |eᵢⱼ|². In the site's own face the straight line is exact and free of cancellation.
  double distanceFrom(int label, const SurfacePoint& p, double interpolated) const {
    const auto sides = squaredSides(mesh_, p.face);
    if (sites_[label].face == p.face)
      return std::sqrt(squaredDistance(sites_[label].bary, p.bary, sides));
    const double excess = p.bary[0] * p.bary[1] * sides[0] + p.bary[1] * p.bary[2] * sides[1] +
                          p.bary[2] * p.bary[0] * sides[2];
    return std::sqrt(std::max(0.0, interpolated - excess));
  }

  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> sites_;
  std::vector<int> offset_;
  std::vector<LabelledDistance> values_;
};

double meanEdgeLength(const TriangleMesh& mesh) {
  double sum = 0;
  for (int h = 0; h < mesh.halfedgeCount(); ++h) sum += mesh.length(h);
  return sum / mesh.halfedgeCount();
}

/// How far behind the nearest label another one still spreads from a vertex.
///
/// If it owns a point of a face with corner x, it is at most 2h(x) behind there, h being the
/// longest edge around: distances are 1-Lipschitz. Along its way to x it is never further behind,
/// and at the corners of the faces that this way crosses by at most twice their own edges more. A
/// way through small faces to a large one needs the large one's allowance, so h is carried into the
/// neighbourhood, less half the way.
std::vector<double> reaches(const TriangleMesh& mesh) {
  std::vector<double> longest(mesh.vertexCount(), 0.0);
  for (int h = 0; h < mesh.halfedgeCount(); ++h)
    for (const int v : {mesh.tail(h), mesh.tip(h)})
      longest[v] = std::max(longest[v], mesh.length(h));
  std::vector<double> around = longest;
  for (bool changed = true; changed;) {
    changed = false;
    for (int h = 0; h < mesh.halfedgeCount(); ++h) {
      double &a = around[mesh.tail(h)], &b = around[mesh.tip(h)];
      const double least = std::max(a, b) - mesh.length(h) / 2;
      if (a < least || b < least) {
        a = std::max(a, least);
        b = std::max(b, least);
        changed = true;
      }
    }
  }
  for (int v = 0; v < mesh.vertexCount(); ++v) longest[v] = 2 * (longest[v] + around[v]);
  return longest;
}

/// One sweep of all labels through one queue. Label-correcting: an entry that has spread may
/// improve again and then spreads again, which is what makes it exact in the plane for any
/// triangulation.
class DgpcSweep final : public Propagation {
 public:
  DgpcSweep(const TriangleMesh& mesh, std::span<const SurfacePoint> sites)
      : mesh_(mesh),
        sites_(sites.begin(), sites.end()),
        reach_(reaches(mesh)),
        entries_(mesh.vertexCount()),
        best_(mesh.vertexCount(), kInfinity),
        queue_(meanEdgeLength(mesh) / 2) {
    entries_.reserve(2 * entries_.size());
    for (int label = 0; label < static_cast<int>(sites_.size()); ++label) seed(label);
  }

  bool step(long budget) override {
    for (; budget > 0 && !queue_.empty(); --budget) {
      const QueueItem item = queue_.pop();
      if (item.distance == entries_[item.entry].distance) settle(item.entry);
    }
    return queue_.empty();
  }

  double progress() const override {
    return queue_.empty()
               ? 1.0
               : std::min(1.0, static_cast<double>(reachedVertices_) / mesh_.vertexCount());
  }

  std::unique_ptr<DistanceField> take() override {
    equalizeTiesAtVertices();
    complete();
    return std::make_unique<DgpcField>(mesh_, sites_, entries_);
  }

 private:
  int find(int vertex, int label) const {
    int e = vertex;
    while (e >= 0 && entries_[e].label != label) e = entries_[e].next;
    return e;
  }

  int add(int vertex, int label) {
    Entry& first = entries_[vertex];
    if (first.label < 0) {
      first.label = label;
      first.vertex = vertex;
      return vertex;
    }
    const int entry = static_cast<int>(entries_.size());
    const int next = std::exchange(first.next, entry);
    entries_.push_back({kInfinity, label, vertex, next});
    return entry;
  }

  /// The straight distances from a site to the corners of its face. On an edge the other face's
  /// corner follows by unfolding, at a vertex its neighbours do.
  void seed(int label) {
    const SurfacePoint& site = sites_[label];
    const auto sides = squaredSides(mesh_, site.face);
    for (int i = 0; i < 3; ++i)
      offer(mesh_.tail(3 * site.face + i), label, -1,
            std::sqrt(squaredDistance(site.bary, Eigen::Vector3d::Unit(i), sides)));
  }

  /// Takes a distance for a label at a vertex if it is better than what is known by more than
  /// rounding. `entry` is the label's entry there, -1 if it has none or none is known; the entry is
  /// returned.
  int offer(int vertex, int label, int entry, double distance) {
    if (entry < 0) entry = find(vertex, label);
    if (entry < 0) entry = add(vertex, label);
    Entry& e = entries_[entry];
    if (!(distance < e.distance * (1 - kDistanceTolerance))) return entry;
    e.distance = distance;
    if (distance < best_[vertex]) {
      if (best_[vertex] == kInfinity) ++reachedVertices_;
      best_[vertex] = distance;
    }
    queue_.push({distance, entry});
    return entry;
  }

  /// Spreads an entry over the faces around its vertex.
  void settle(int entry) {
    const Entry from = entries_[entry];
    if (from.distance - best_[from.vertex] > reach_[from.vertex]) return;
    const int first = mesh_.outgoing(from.vertex);
    int h = first;
    int a = mesh_.tip(h);
    int atA = find(a, from.label);
    do {
      // The face (vertex, a, b).
      const int back = mesh_.previous(h);
      const int b = mesh_.tail(back);
      int atB = find(b, from.label);
      atA = improve(back, a, atA, atB, from, mesh_.length(h), false);
      atB = improve(h, b, atB, atA, from, mesh_.length(back), true);
      a = b;
      atA = atB;
      h = mesh_.twin(back);
    } while (h >= 0 && h != first);
  }

  /// Offers `vertex`, the apex of halfedge `across`, what comes over that halfedge: between
  /// `from.vertex` (its tail if `fromTail`) and the vertex of entry `other`; or, where nothing
  /// does, along the edge of the given length from `from.vertex`.
  int improve(int across, int vertex, int entry, int other, const Entry& from, double length,
              bool fromTail) {
    const double known = entry < 0 ? kInfinity : entries_[entry].distance;
    double distance = kInfinity;
    if (other >= 0) {
      const double beside = entries_[other].distance;
      distance = fromTail ? unfold(mesh_.layout(across), from.distance, beside, known)
                          : unfold(mesh_.layout(across), beside, from.distance, known);
    }
    if (distance == kInfinity) distance = from.distance + length;
    return distance < known ? offer(vertex, from.label, entry, distance) : entry;
  }

  void equalizeTiesAtVertices() {
    std::vector<LabelledDistance> here;
    for (int v = 0; v < mesh_.vertexCount(); ++v) {
      if (entries_[v].next < 0) continue;
      here.clear();
      for (int e = v; e >= 0; e = entries_[e].next)
        here.push_back({entries_[e].label, entries_[e].distance});
      equalizeTies(here);
      for (const LabelledDistance& d : here) entries_[find(v, d.label)].distance = d.distance;
    }
  }

  /// Makes the field's promise hold where the sweep stopped a label too early: a label that may be
  /// least somewhere on a side of a face is known at the face's third corner.
  void complete() {
    std::vector<int> faces;
    for (int f = 0; f < mesh_.faceCount(); ++f) completeFace(f, faces);
    while (!faces.empty()) {
      const int f = faces.back();
      faces.pop_back();
      completeFace(f, faces);
    }
  }

  /// Extends what is missing at a corner of the face, and then lists the faces around that corner.
  void completeFace(int f, std::vector<int>& changed) {
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const int apex = mesh_.tail(mesh_.previous(h));
      for (int e = mesh_.tail(h); e >= 0 && entries_[e].label >= 0; e = entries_[e].next) {
        if (find(apex, entries_[e].label) >= 0) continue;
        const int atTip = find(mesh_.tip(h), entries_[e].label);
        if (atTip < 0 || isHidden(e, atTip)) continue;
        extend(h, entries_[e].distance, entries_[atTip].distance, entries_[e].label);
        const int first = mesh_.outgoing(apex);
        int g = first;
        do {
          changed.push_back(TriangleMesh::faceOf(g));
          g = mesh_.rotate(g);
        } while (g >= 0 && g != first);
      }
    }
  }

  /// Whether a single label is nearer than another one, of which the entries are given, at both
  /// ends of an edge.
  bool isHidden(int atTail, int atTip) const {
    const Entry &tail = entries_[atTail], &tip = entries_[atTip];
    const auto isNearerExactly = [](const Entry& a, const Entry& b) {
      return a.distance < b.distance || (a.distance == b.distance && a.label < b.label);
    };
    for (int e = tail.vertex; e >= 0; e = entries_[e].next) {
      if (!isNearerExactly(entries_[e], tail)) continue;
      const int other = find(tip.vertex, entries_[e].label);
      if (other >= 0 && isNearerExactly(entries_[other], tip)) return true;
    }
    return false;
  }

  /// Gives a label a distance at the apex of h from those at its ends.
  void extend(int h, double atTail, double atTip, int label) {
    const int vertex = mesh_.tail(mesh_.previous(h));
    double distance = unfold(mesh_.layout(h), atTail, atTip, kInfinity);
    if (distance == kInfinity)
      distance =
          std::min(atTail + mesh_.length(mesh_.previous(h)), atTip + mesh_.length(mesh_.next(h)));
    for (int e = vertex; e >= 0; e = entries_[e].next)
      if (std::abs(entries_[e].distance - distance) <= kDistanceTolerance * distance)
        distance = entries_[e].distance;
    entries_[add(vertex, label)].distance = distance;
  }

  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> sites_;
  std::vector<double> reach_;
  std::vector<Entry> entries_;
  std::vector<double> best_;
  SweepQueue<QueueItem> queue_;
  long reachedVertices_ = 0;
};

}  // namespace

std::unique_ptr<Propagation> propagateDgpc(const TriangleMesh& mesh,
                                           std::span<const SurfacePoint> sites) {
  return std::make_unique<DgpcSweep>(mesh, sites);
}

}  // namespace gvd
