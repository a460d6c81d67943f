// SPDX-License-Identifier: MIT
// This work is based on:
// Eivind Lyche Melvær, Martin Reimers. Geodesic Polar Coordinates on Polygonal Meshes. 2012
// Eivind Lyche Melvær, Martin Reimers. Approximating Geodesic Voronoi Diagrams on Triangulated
// Surfaces. 2014
// Joseph Mitchell, David Mount, Christos Papadimitriou. The Discrete Geodesic Problem. 1987
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "continuation.h"
#include "dgpc_view.h"
#include "edge_share.h"
#include "fan.h"
#include "heap.h"
#include "metric.h"
#include "surface_geometry.h"
#include "tolerances.h"

namespace gvd {
namespace {

using Eigen::Vector2d;

/// What one label knows at one vertex. Entry v is the first one of vertex v, further ones follow
/// behind those of all vertices: most vertices need no more than the first. The view is kept apart:
/// most entries are looked at, but not gone on from.
struct Entry {
  double distance = kInfinity;
  int label = -1;
  int next = -1;  ///< the next entry of the same vertex, -1 at the end
};

struct QueueItem {
  double distance;
  int entry;
  /// By distance; then by entry, which makes the order total.
  bool operator<(const QueueItem& other) const {
    return distance < other.distance || (distance == other.distance && entry < other.entry);
  }
};

/// One sweep of all labels through one queue: Dijkstra's, with views carried from vertex to vertex.
/// Label-correcting: an entry that has spread may improve again and then spreads again, which
/// obtuse triangles need.
///
/// DGPC as published keeps distance and angle per vertex and finds those of the next vertex from
/// two known ones by a virtual source. Carrying the unfolded source itself costs less (one root
/// instead of two, no second vertex that must be known), does not blur what comes from both sides
/// of a ridge, and errs towards too long: what saddles and the boundary hide is cut off where the
/// fans meet them.
class DgpcSweep final : public Propagation {
 public:
  DgpcSweep(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Spread spread)
      : mesh_(mesh),
        sites_(sites.begin(), sites.end()),
        spread_(spread),
        limits_(mesh.vertexCount()),
        owner_(mesh.vertexCount(), -1),
        queue_(mesh.meanEdgeLength()) {
    for (int v = 0; v < mesh.vertexCount(); ++v) limits_[v] = limitsViews(mesh, v);
    entries_.reserve(2 * owner_.size());
    entries_.resize(owner_.size());
    views_.reserve(2 * owner_.size());
    views_.resize(owner_.size());
    for (int label = 0; label < static_cast<int>(sites_.size()); ++label) seed(label);
  }

  bool step(long budget) override {
    do {
      for (; budget > 0 && !queue_.empty(); --budget) {
        const QueueItem item = queue_.pop();
        if (item.distance == entries_[item.entry].distance) settle(item.entry);
      }
      if (!queue_.empty()) return false;
    } while (reachTheUnseen());
    return true;
  }

  double progress() const override {
    return queue_.empty()
               ? 1.0
               : std::min(1.0, static_cast<double>(reachedVertices_) / mesh_.vertexCount());
  }

  std::unique_ptr<DistanceField> take() override {
    keepOwners();
    return continueOverBorders(mesh_, std::move(sites_), std::move(nearest_), std::move(views_));
  }

 private:
  // --- Entries ---

  int find(int vertex, int label) const {
    int e = vertex;
    while (e >= 0 && entries_[e].label != label) e = entries_[e].next;
    return e;
  }

  double distanceAt(int vertex, int label) const {
    const int e = find(vertex, label);
    return e < 0 ? kInfinity : entries_[e].distance;
  }

  /// The distance of the nearest label.
  double leastAt(int vertex) const { return distanceAt(vertex, owner_[vertex]); }

  int add(int vertex, int label) {
    Entry& first = entries_[vertex];
    if (first.label < 0) {
      first.label = label;
      return vertex;
    }
    const int entry = static_cast<int>(entries_.size());
    const int next = std::exchange(first.next, entry);
    entries_.push_back({kInfinity, label, next});
    views_.emplace_back();
    vertices_.push_back(vertex);
    return entry;
  }

  int vertexOf(int entry) const {
    return entry < mesh_.vertexCount() ? entry : vertices_[entry - mesh_.vertexCount()];
  }

  /// Takes a path for a label to a vertex if it is shorter than what is known by more than
  /// rounding; `view` is only asked for then.
  template <class MakeView>
  void offer(int vertex, int label, double distance, MakeView view) {
    int entry = find(vertex, label);
    if (entry < 0) entry = add(vertex, label);
    Entry& e = entries_[entry];
    if (!(distance < e.distance * (1 - kDistanceTolerance))) return;
    e.distance = distance;
    views_[entry] = view();
    if (owner_[vertex] != label && distance < leastAt(vertex)) {
      if (owner_[vertex] < 0) ++reachedVertices_;
      owner_[vertex] = label;
    }
    queue_.push({distance, entry});
  }

  // --- Sites ---

  /// The corners of a site's face see it directly. A site on an edge is seen from the other face
  /// through these views, and one at a vertex along the edges there.
  void seed(int label) {
    const SurfacePoint& site = sites_[label];
    for (int i = 0; i < 3; ++i) {
      const double distance = distanceOfCorner(mesh_, site, i);
      offer(mesh_.tail(3 * site.face + i), label, distance,
            [&] { return distance > 0 ? viewOfCorner(mesh_, site, i) : View(); });
    }
  }

  // --- Spreading ---

  /// An entry that goes on to its neighbours.
  struct Origin {
    View view;
    Vector2d path;  ///< from the view's source
    int vertex, label;
    double distance;
    bool isLimit;  ///< whether it limits views past it
  };

  void settle(int entry) {
    Origin from{.view = views_[entry],
                .path = {0, 0},
                .vertex = vertexOf(entry),
                .label = entries_[entry].label,
                .distance = entries_[entry].distance,
                .isLimit = false};
    if (from.view.halfedge < 0) {
      spreadFromSite(from.vertex, from.label);
      return;
    }
    from.path = from.view.path(mesh_);
    from.isLimit = limits_[from.vertex];
    // Between the sides, paths bend; the left one sees to that, up to the boundary both.
    const bool isBend = from.isLimit && mayBend(from.vertex, from.distance);
    const bool isOnBoundary = isBend && mesh_.onBoundary(from.vertex);
    const int behindRight =
        carry<Side::kRight>(from, isOnBoundary, isOnBoundary ? kToBoundary : kToFirstBehind);
    carry<Side::kLeft>(from, isBend, isBend ? behindRight : kToFirstBehind);
  }

  void spreadFromSite(int vertex, int label) {
    const double first = angleOfFirstSpoke(mesh_, sites_[label], vertex);
    visitSpokes(mesh_, vertex, [&](const Spoke& spoke) {
      offer(spoke.neighbour, label, spoke.length, [&] { return viewAlong(mesh_, spoke, first); });
    });
  }

  /// A path that bends at a vertex goes on there as any other label's path would, so only the
  /// nearest label's can be of use.
  bool mayBend(int vertex, double distance) const {
    return spread_ == Spread::kEverywhere || distance <= leastAt(vertex) * (1 + kDistanceTolerance);
  }

  /// Whether another label is ahead of this one for good: at both ends of an edge it is nearer, or
  /// as near and the lower one. What crosses this edge then owns nothing behind it.
  bool isHidden(const Origin& from, int outer, const Vector2d& toOuter) const {
    const int v = from.vertex, nearV = owner_[v], nearOuter = owner_[outer];
    const double atOuter = from.view.offset + toOuter.norm();
    if (nearV != from.label && isAhead(nearV, leastAt(v), from.label, from.distance) &&
        isAhead(nearV, distanceAt(outer, nearV), from.label, atOuter))
      return true;
    return nearOuter >= 0 && nearOuter != from.label && nearOuter != nearV &&
           isAhead(nearOuter, leastAt(outer), from.label, atOuter) &&
           isAhead(nearOuter, distanceAt(v, nearOuter), from.label, from.distance);
  }

  /// Whether a label goes on over an edge.
  bool mayCross(const Origin& from, int outer, const Vector2d& toOuter) const {
    if (spread_ == Spread::kEverywhere) return true;
    return (owner_[from.vertex] == from.label && owner_[outer] == from.label) ||
           !isHidden(from, outer, toOuter);
  }

  /// Whether a label's distance at a vertex cannot be improved by a path that is straight over the
  /// given way, up to the given distance before it.
  bool isFutile(int vertex, int label, const Vector2d& way, double before) const {
    const Entry& first = entries_[vertex];
    const double known = first.distance - before;
    return first.label == label && way.squaredNorm() >= known * std::abs(known);
  }

  /// Carries a view on to the vertices around its own, on one side, up to `last` (walkFan). Those
  /// that are left behind are reached by bending.
  template <Side side>
  int carry(const Origin& from, bool isBend, int last) {
    const Vector2d zero(0, 0);
    const View& view = from.view;
    Sight<side> sight(view);
    return walkFan<side>(mesh_, view, from.path, last, [&](const FanFace& face) {
      if (face.place == FanFace::Place::kBefore) return;
      const int at = mesh_.tail(TriangleMesh::previous(face.halfedge));
      if (face.place == FanFace::Place::kBehind) {
        if (isBend) bend<side>(from, face, at);
        return;
      }
      const Vector2d toOuter = from.path + face.outer, toApex = from.path + face.apex;
      const int outer = outerEnd<side>(face, mesh_);
      if (limits_[outer]) sight.limit(toOuter);
      if (isFutile(at, from.label, toApex, view.offset) || !mayCross(from, outer, toOuter)) return;
      const Vector2d& bound = sight.bound();
      if (sight.reaches(toApex)) {
        offer(at, from.label, view.offset + toApex.norm(),
              [&] { return viewThrough<side>(from, face, zero, bound); });
      } else if (sight.reachesAround(face, from.path, toApex)) {
        const double toBend = bound.norm(), offset = view.offset + toBend;
        offer(at, from.label, offset + (toApex - bound).norm(), [&] {
          const Vector2d limit = limits_[outer] ? Vector2d(toOuter - bound) : zero;
          View next = viewThrough<side>(from, face, bound, limit);
          next.heading = view.departure(bound / toBend);
          next.offset = offset;
          next.isBent = true;
          return next;
        });
      } else if (isBend) {
        bend<side>(from, face, at);
      }
    });
  }

  /// The view through the halfedge by which a fan enters a face, from what lies at `shift` of the
  /// source of the fan's view.
  template <Side side>
  View viewThrough(const Origin& from, const FanFace& face, const Vector2d& shift,
                   const Vector2d& outerBound) const {
    constexpr bool kLeft = side == Side::kLeft;
    const Vector2d zero(0, 0), axis = axisOf<side>(face);
    const Vector2d& limit = kLeft ? from.view.right : from.view.left;
    Vector2d innerBound = zero;
    if (from.isLimit)
      innerBound = from.path - shift;
    else if (limit != zero)
      innerBound = limit - shift;
    View next;
    next.source = inFrameOf<side>(face, mesh_, shift - from.path);
    next.left = turned(kLeft ? outerBound : innerBound, axis);
    next.right = turned(kLeft ? innerBound : outerBound, axis);
    next.heading = from.view.isBent ? from.view.heading : turned(from.view.heading, axis);
    next.offset = from.view.offset;
    next.halfedge = face.halfedge;
    next.isBent = from.view.isBent;
    return next;
  }

  template <Side side>
  void bend(const Origin& from, const FanFace& face, int at) {
    offer(at, from.label, from.distance + face.apex.norm(), [&] {
      return viewFromBend(mesh_, face.halfedge, side == Side::kRight, from.distance,
                          from.view.departure(mesh_, from.distance));
    });
  }

  /// Views end at what hides them. Should a vertex be out of sight from all sides, the path along
  /// the edge from its nearest neighbour reaches it.
  bool reachTheUnseen() {
    if (reachedVertices_ == mesh_.vertexCount()) return false;
    std::vector<std::pair<int, Spoke>> edges;
    for (int v = 0; v < mesh_.vertexCount(); ++v) {
      if (owner_[v] < 0) continue;
      visitSpokes(mesh_, v, [&](const Spoke& spoke) {
        if (owner_[spoke.neighbour] < 0) edges.emplace_back(v, spoke);
      });
    }
    for (const auto& [v, spoke] : edges) {
      const int entry = find(v, owner_[v]);
      const double distance = entries_[entry].distance;
      const View via = viewFromBend(mesh_, spoke.halfedge, spoke.isFromTail, distance,
                                    views_[entry].departure(mesh_, distance));
      offer(spoke.neighbour, owner_[v], distance + spoke.length, [&] { return via; });
    }
    return !edges.empty();
  }

  /// Names the nearest label of each vertex, of those that tie the lowest, and keeps their views.
  void keepOwners() {
    nearest_.resize(mesh_.vertexCount());
    for (int v = 0; v < mesh_.vertexCount(); ++v) {
      if (owner_[v] < 0) continue;
      const double tie = leastAt(v) * (1 + kDistanceTolerance);
      int owner = -1;
      for (int e = v; e >= 0; e = entries_[e].next)
        if (entries_[e].distance <= tie && (owner < 0 || entries_[e].label < entries_[owner].label))
          owner = e;
      nearest_[v] = {entries_[owner].label, entries_[owner].distance};
      if (owner != v) views_[v] = views_[owner];
    }
    views_.resize(mesh_.vertexCount());
  }

  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> sites_;
  Spread spread_;
  std::vector<char> limits_;  ///< limitsViews, per vertex
  std::vector<Entry> entries_;
  std::vector<View> views_;    ///< of the entries
  std::vector<int> vertices_;  ///< of the entries behind the first ones
  std::vector<int> owner_;     ///< the nearest label of each vertex, -1 if none has come
  SweepQueue<QueueItem> queue_;
  std::vector<LabelledDistance> nearest_;
  int reachedVertices_ = 0;
};

}  // namespace

std::unique_ptr<Propagation> propagateDgpc(const TriangleMesh& mesh,
                                           std::span<const SurfacePoint> sites, Spread spread) {
  return std::make_unique<DgpcSweep>(mesh, sites, spread);
}

}  // namespace gvd
