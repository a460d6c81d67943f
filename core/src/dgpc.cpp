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

#include "dgpc_field.h"
#include "dgpc_view.h"
#include "edge_share.h"
#include "heap.h"
#include "metric.h"
#include "surface_geometry.h"
#include "tolerances.h"

namespace gvd {
namespace {

using Eigen::Vector2d;

/// A face in the fan around a vertex, in the frame of the halfedge through which the fan enters it.
/// That vertex is the halfedge's inner end, the other one its outer end.
struct FanFace {
  int halfedge;
  Vector2d source;
  Vector2d bound;  ///< from the source to what limits the view on the fan's outer side, or zero
  Vector2d axis;   ///< the frame's x axis in the view's frame
  Vector2d inner = {0, 0}, outer = {0, 0}, apex = {0, 0};
  /// Where the apex lies: the fan may begin before the direct line from the source to its vertex,
  /// and it ends where that line, continued behind the vertex, is met from the other side.
  enum class Place { kBefore, kInSight, kBehind } place = Place::kInSight;
};

/// The left side of a fan is what lies counterclockwise of the view's face around its vertex.
enum class Side { kLeft, kRight };

/// Whether a direction lies on the given side of another one, or along it: what just passes a
/// vertex must not depend on rounding.
template <Side side>
bool isTowards(const Vector2d& from, const Vector2d& direction) {
  constexpr double kGrazing = 1e-12;  // of a radian
  const double turn = cross(from, direction);
  return (side == Side::kLeft ? turn : -turn) >= -kGrazing * std::abs(from.dot(direction));
}

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

double meanEdgeLength(const TriangleMesh& mesh) {
  double sum = 0;
  for (int h = 0; h < mesh.halfedgeCount(); ++h) sum += mesh.length(h);
  return sum / mesh.halfedgeCount();
}

/// Vertices where shortest paths may bend: inner saddles, and the boundary. What they hide is only
/// reached around them, so they limit views. At all others paths on both sides of the vertex reach
/// every point behind it, and a view that is carried on past such a vertex gives no length that is
/// less than the distance (the hinge theorem for non-negative curvature): it needs no limit, and in
/// the plane every view of a site is the same.
std::vector<char> bendingVertices(const TriangleMesh& mesh) {
  constexpr double kFlat = 2 * std::numbers::pi * (1 + 1e-12);  // of the sum of rounded angles
  std::vector<char> bends(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v) bends[v] = mesh.angleSum(v) > kFlat;
  for (int h = 0; h < mesh.halfedgeCount(); ++h)
    if (mesh.twin(h) < 0) bends[mesh.tail(h)] = bends[mesh.tip(h)] = true;
  return bends;
}

/// The direction of the first side of a face in the frame of its side i.
Vector2d firstSide(const TriangleMesh& mesh, int face, int i) {
  const TriangleMesh::Layout& l = mesh.layout(3 * face + i);
  const double inverse = 2 * mesh.layout(3 * face).inverse;
  if (i == 1) return Vector2d(-l.x, -l.y) * inverse;
  if (i == 2) return Vector2d(l.x - l.length, l.y) * inverse;
  return {1, 0};
}

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
        bends_(bendingVertices(mesh)),
        entries_(mesh.vertexCount()),
        views_(mesh.vertexCount()),
        owner_(mesh.vertexCount(), -1),
        queue_(meanEdgeLength(mesh) / 2) {
    entries_.reserve(2 * entries_.size());
    views_.reserve(2 * views_.size());
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
    for (int label = 0; label < static_cast<int>(sites_.size()); ++label) lookFromSite(label);
    for (const int v : verticesAtBorders()) lookAround(v);
    do {
      lookThroughEdges();
    } while (completeFaces());
    return collect();
  }

 private:
  /// A site seen through a halfedge by the face it belongs to, between the view's bounds.
  struct Look {
    View view;
    int label;
  };

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
    if (areOwnersKept_) {
      departures_.emplace_back();
    } else {
      views_.emplace_back();
      vertices_.push_back(vertex);
    }
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

  View viewOfCorner(int label, int corner) const {
    const SurfacePoint& site = sites_[label];
    const int i = (corner + 1) % 3, h = 3 * site.face + i;
    const TriangleMesh::Layout& l = mesh_.layout(h);
    const double toTip = site.bary[(corner + 2) % 3], toApex = site.bary[corner];
    View view;
    view.source = {toTip * l.length + toApex * l.x, toApex * l.y};
    view.heading = firstSide(mesh_, site.face, i);
    view.halfedge = h;
    return view;
  }

  double distanceOfCorner(int label, int corner) const {
    const SurfacePoint& site = sites_[label];
    return std::sqrt(
        squaredDistance(site.bary, Eigen::Vector3d::Unit(corner), squaredSides(mesh_, site.face)));
  }

  /// The corners of a site's face see it directly. A site on an edge is seen from the other face
  /// through these views, and one at a vertex along the edges there.
  void seed(int label) {
    for (int i = 0; i < 3; ++i) {
      const double distance = distanceOfCorner(label, i);
      offer(mesh_.tail(3 * sites_[label].face + i), label, distance,
            [&] { return distance > 0 ? viewOfCorner(label, i) : View(); });
    }
  }

  /// The angle at a site that lies on a vertex, of the vertex's outgoing halfedge; further ones
  /// follow counterclockwise by the corner angles.
  double angleOfOutgoing(int label, int vertex) const {
    const int face = sites_[label].face;
    int corner = 0;
    double angle = 0;
    while (mesh_.tail(3 * face + corner) != vertex)
      angle += std::numbers::pi - mesh_.cornerAngle(3 * face + ++corner);
    for (int h = mesh_.outgoing(vertex); TriangleMesh::faceOf(h) != face; h = mesh_.rotate(h))
      angle -= mesh_.cornerAngle(h);
    return angle;
  }

  // --- Spreading ---

  void settle(int entry) {
    const View view = views_[entry];
    const int vertex = vertexOf(entry);
    const int label = entries_[entry].label;
    const double distance = entries_[entry].distance;
    const auto give = [&](int at, double length, auto makeView) {
      offer(at, label, length, makeView);
    };
    if (view.halfedge >= 0) {
      const auto mayCross = [&](int outer, double length) {
        return (owner_[vertex] == label && owner_[outer] == label) ||
               !isHidden(label, vertex, distance, outer, length);
      };
      carry<Side::kLeft>(view, vertex, mayCross, give);
      carry<Side::kRight>(view, vertex, mayCross, give);
    }
    if ((view.halfedge < 0 || bends_[vertex]) && mayBend(vertex, distance)) alongEdges(entry, give);
  }

  /// A path that bends at a vertex goes on there as any other label's path would, so only the
  /// nearest label's can be of use.
  bool mayBend(int vertex, double distance) const {
    return spread_ == Spread::kEverywhere || distance <= leastAt(vertex) * (1 + kDistanceTolerance);
  }

  /// Whether another label is ahead of this one for good: at both ends of an edge it is nearer, or
  /// as near and the lower one. What crosses this edge then owns nothing behind it.
  bool isHidden(int label, int v, double atV, int u, double atU) const {
    if (spread_ == Spread::kEverywhere) return false;
    const int nearV = owner_[v], nearU = owner_[u];
    if (nearV != label && isAhead(nearV, leastAt(v), label, atV) &&
        isAhead(nearV, distanceAt(u, nearV), label, atU))
      return true;
    return nearU >= 0 && nearU != label && nearU != nearV &&
           isAhead(nearU, leastAt(u), label, atU) &&
           isAhead(nearU, distanceAt(v, nearU), label, atV);
  }

  /// Visits the faces on one side of a view around its vertex, until `visit` returns false, the
  /// boundary is met or the fan closes.
  template <Side side, class Visit>
  void walkFan(const View& view, Visit visit) const {
    using Place = FanFace::Place;
    constexpr bool kLeft = side == Side::kLeft;
    const auto isOutward = [](const FanFace& face, const Vector2d& p) {
      return isTowards<side>(face.inner - face.source, p - face.source);
    };
    const TriangleMesh::Layout& own = mesh_.layout(view.halfedge);
    FanFace face{.halfedge = view.halfedge,
                 .source = view.source,
                 .bound = kLeft ? view.left : view.right,
                 .axis = {1, 0},
                 .inner = {own.x, own.y}};
    Place next = isOutward(face, kLeft ? Vector2d(0, 0) : Vector2d(own.length, 0)) ? Place::kInSight
                                                                                   : Place::kBefore;
    bool overLeftSide = kLeft;
    for (;;) {
      const int from = face.halfedge;
      const int over = overLeftSide ? TriangleMesh::previous(from) : TriangleMesh::next(from);
      face.halfedge = mesh_.twin(over);
      if (face.halfedge < 0 ||
          TriangleMesh::faceOf(face.halfedge) == TriangleMesh::faceOf(view.halfedge))
        return;
      const TriangleMesh::Layout &old = mesh_.layout(from), &l = mesh_.layout(face.halfedge);
      const Vector2d oldApex(old.x, old.y);
      const Vector2d axis =
          (overLeftSide ? oldApex : Vector2d(old.length - old.x, -old.y)) * (2 * l.inverse);
      face.source = turned(overLeftSide ? face.source : Vector2d(face.source - oldApex), axis);
      face.bound = turned(face.bound, axis);
      face.axis = {face.axis.x() * axis.x() - face.axis.y() * axis.y(),
                   face.axis.x() * axis.y() + face.axis.y() * axis.x()};
      face.inner = {kLeft ? l.length : 0, 0};
      face.outer = {kLeft ? 0 : l.length, 0};
      face.apex = {l.x, l.y};
      face.place = next;
      const bool apexIsOutward = isOutward(face, face.apex);
      if (next == Place::kBefore && apexIsOutward) next = Place::kInSight;
      if (next == Place::kInSight && face.place == next && !apexIsOutward)
        face.place = next = Place::kBehind;
      if (!visit(face)) return;
      overLeftSide = !kLeft;
    }
  }

  /// Carries a view on to the vertices around its own, on one side. Per edge it asks
  /// mayCross(outer vertex, distance there), and if so, calls give(apex, distance, makeView) for
  /// the apex of the face behind the edge. Faces behind further edges are asked for in any case.
  template <Side side, class MayCross, class Give>
  void carry(const View& view, int vertex, MayCross mayCross, Give give) const {
    constexpr bool kLeft = side == Side::kLeft;
    constexpr Side kInward = kLeft ? Side::kRight : Side::kLeft;
    const auto isWithin = isTowards<kInward>;
    const Vector2d zero(0, 0);
    walkFan<side>(view, [&](FanFace& face) {
      if (face.place == FanFace::Place::kBefore) return true;
      if (face.place == FanFace::Place::kBehind) return false;
      const Vector2d toOuter = face.outer - face.source, toApex = face.apex - face.source;
      const int outer = kLeft ? mesh_.tail(face.halfedge) : mesh_.tip(face.halfedge);
      if (bends_[outer] && (face.bound == zero || isWithin(face.bound, toOuter)))
        face.bound = toOuter;
      if (!mayCross(outer, view.offset + toOuter.norm())) return true;
      const auto viewFrom = [&](const Vector2d& source, const Vector2d& outerBound) {
        Vector2d innerBound = zero;
        if (bends_[vertex])
          innerBound = face.inner - source;
        else if (const Vector2d& limit = kLeft ? view.right : view.left; limit != zero)
          innerBound = turned(limit, face.axis) + (face.source - source);
        View next;
        next.source = source;
        next.left = kLeft ? outerBound : innerBound;
        next.right = kLeft ? innerBound : outerBound;
        next.heading = view.isBent ? view.heading : turned(view.heading, face.axis);
        next.offset = view.offset;
        next.halfedge = face.halfedge;
        next.isBent = view.isBent;
        return next;
      };
      const int at = mesh_.tail(TriangleMesh::previous(face.halfedge));
      if (face.bound == zero || isWithin(face.bound, toApex)) {
        give(at, view.offset + toApex.norm(), [&] { return viewFrom(face.source, face.bound); });
        return true;
      }
      // Out of sight: around the vertex that hides it, unless that is an end of this halfedge, from
      // which the path goes on by itself.
      const Vector2d corner = face.source + face.bound;
      if (corner.y() < 0 && isWithin(face.outer - corner, face.apex - corner)) {
        const double toCorner = face.bound.norm(), offset = view.offset + toCorner;
        give(at, offset + (face.apex - corner).norm(), [&] {
          View next = viewFrom(corner, bends_[outer] ? Vector2d(face.outer - corner) : zero);
          next.heading = view.departure(face.bound / toCorner, face.axis);
          next.offset = offset;
          next.isBent = true;
          return next;
        });
      }
      return true;
    });
  }

  /// Makes a vertex the source for its neighbours, a site or a vertex where paths bend: calls
  /// give(neighbour, distance, makeView) for each.
  template <class Give>
  void alongEdges(int entry, Give give) const {
    const View view = views_[entry];
    const int vertex = vertexOf(entry), label = entries_[entry].label;
    const double distance = entries_[entry].distance;
    const bool isSite = view.halfedge < 0;
    const Vector2d departure = view.departure(mesh_, distance);
    double angle = isSite ? angleOfOutgoing(label, vertex) : 0;
    const auto go = [&](int halfedge, bool fromTail) {
      const double length =
          mesh_.length(fromTail ? TriangleMesh::previous(halfedge) : TriangleMesh::next(halfedge));
      give(mesh_.tail(TriangleMesh::previous(halfedge)), distance + length, [&] {
        const TriangleMesh::Layout& l = mesh_.layout(halfedge);
        View next;
        if (!fromTail) next.source = {l.length, 0};
        next.offset = distance;
        next.halfedge = halfedge;
        next.isBent = !isSite;
        next.heading = departure;
        if (isSite) {
          const Vector2d along = (Vector2d(l.x, l.y) - next.source) / length;
          next.heading = turned(along, {std::cos(angle), std::sin(angle)});
        }
        return next;
      });
    };
    const int first = mesh_.outgoing(vertex);
    int h = first;
    do {
      const int back = TriangleMesh::previous(h);
      go(back, false);
      if (isSite) angle += mesh_.cornerAngle(h);
      if (mesh_.twin(back) < 0) go(h, true);
      h = mesh_.twin(back);
    } while (h >= 0 && h != first);
  }

  /// Views end at what hides them. Should a vertex be out of sight from all sides, the path along
  /// the edge from its nearest neighbour reaches it.
  bool reachTheUnseen() {
    if (reachedVertices_ == mesh_.vertexCount()) return false;
    bool found = false;
    for (int v = 0; v < mesh_.vertexCount(); ++v) {
      if (owner_[v] < 0) continue;
      const int first = mesh_.outgoing(v);
      int h = first;
      bool isLast = false;
      do {
        const int back = TriangleMesh::previous(h);
        if (owner_[mesh_.tip(h)] < 0 || owner_[mesh_.tail(back)] < 0) isLast = true;
        h = mesh_.twin(back);
      } while (!isLast && h >= 0 && h != first);
      if (!isLast) continue;
      alongEdges(find(v, owner_[v]), [&](int at, double distance, auto makeView) {
        offer(at, owner_[v], distance, makeView);
      });
      found = true;
    }
    return found;
  }

  // --- Sites that do not own a vertex, as they appear there ---
  //
  // To tell where in a face one region ends, the distances of both labels must be known at all its
  // corners, also those that another label owns. What counts there is the continuation of the
  // distance inside the region: how far the site is, as seen from the corners the region has. So it
  // depends on no path outside of the region, and nothing need have spread there.

  /// Keeps of the entries those of the owners; ties go to the lower label.
  void keepOwners() {
    for (int v = 0; v < mesh_.vertexCount(); ++v) {
      if (owner_[v] < 0) continue;
      const double tie = leastAt(v) * (1 + kDistanceTolerance);
      for (int e = v; e >= 0; e = entries_[e].next)
        if (entries_[e].distance <= tie) owner_[v] = std::min(owner_[v], entries_[e].label);
      const int e = find(v, owner_[v]);
      if (e != v) views_[v] = views_[e];
      entries_[v] = {entries_[e].distance, owner_[v], -1};
    }
    entries_.resize(mesh_.vertexCount());
    views_.resize(mesh_.vertexCount());
    vertices_.clear();
    areOwnersKept_ = true;
  }

  /// Ascending, those of which some neighbour belongs to another label.
  std::vector<int> verticesAtBorders() const {
    std::vector<char> isAtBorder(mesh_.vertexCount());
    for (int h = 0; h < mesh_.halfedgeCount(); ++h) {
      const int tail = mesh_.tail(h), tip = mesh_.tip(h);
      if (owner_[tail] != owner_[tip]) isAtBorder[tail] = isAtBorder[tip] = true;
    }
    std::vector<int> vertices;
    for (int v = 0; v < mesh_.vertexCount(); ++v)
      if (isAtBorder[v]) vertices.push_back(v);
    return vertices;
  }

  /// Notes how far a label appears to be from a vertex that another one owns; the shortest counts.
  /// The owner has been found by better means, so what appears to be nearer comes next to it.
  /// Returns false in that case. `departure` is the direction at the site, in the site's frame.
  bool see(int vertex, int label, double distance, const Vector2d& departure) {
    if (owner_[vertex] == label) return true;
    const double owners = entries_[vertex].distance;
    const bool isNearer = distance < owners * (1 - kDistanceTolerance);
    if (isNearer) distance = owners * (1 + 4 * kDistanceTolerance);
    int entry = find(vertex, label);
    if (entry < 0) entry = add(vertex, label);
    if (distance < entries_[entry].distance * (1 - kDistanceTolerance)) {
      entries_[entry].distance = distance;
      departures_[entry - mesh_.vertexCount()] = departure;
    }
    return !isNearer;
  }

  /// The same along a straight line from the source of a view, given in a frame whose x axis is
  /// `axis` in the view's.
  bool see(int vertex, int label, const View& view, const Vector2d& path, const Vector2d& axis) {
    const double length = path.norm();
    return see(vertex, label, view.offset + length,
               length > 0 ? view.departure(path / length, axis) : Vector2d(1, 0));
  }

  /// What a view sees, in the frame of another halfedge of its face or of the face across it. The
  /// frame's origin and x axis are given in the view's frame.
  static View inFrame(const View& view, int halfedge, const Vector2d& origin,
                      const Vector2d& axis) {
    View other;
    other.source = turned(view.source - origin, axis);
    other.left = turned(view.left, axis);
    other.right = turned(view.right, axis);
    other.heading = view.isBent ? view.heading : turned(view.heading, axis);
    other.offset = view.offset;
    other.halfedge = halfedge;
    other.isBent = view.isBent;
    return other;
  }

  void lookFromSite(int label) {
    for (int i = 0; i < 3; ++i) {
      const double distance = distanceOfCorner(label, i);
      see(mesh_.tail(3 * sites_[label].face + i), label, distance,
          viewOfCorner(label, i).departure(mesh_, distance));
    }
    for (int i = 0; i < 3; ++i) {
      const View view = viewOfCorner(label, i);
      lookOut(view, {mesh_.length(view.halfedge), 0}, {-1, 0}, label);
    }
  }

  /// Lets the vertices around one see the label that owns it, and looks out of the faces of which
  /// the label owns this corner only.
  void lookAround(int v) {
    const int label = owner_[v];
    const View view = views_[v];
    if (view.halfedge < 0) {
      lookAroundSite(v);
      return;
    }
    const Vector2d tip(mesh_.length(view.halfedge), 0);
    see(mesh_.tail(view.halfedge), label, view, -view.source, {1, 0});
    see(mesh_.tip(view.halfedge), label, view, tip - view.source, {1, 0});
    View here = view;
    here.left = here.right = {0, 0};
    lookOut(here, tip, {-1, 0}, label);
    lookAside<Side::kLeft>(view, v);
    lookAside<Side::kRight>(view, v);
  }

  /// The same around a vertex that is the site.
  void lookAroundSite(int v) {
    const int label = owner_[v];
    alongEdges(v, [&](int at, double distance, auto makeView) {
      const View view = makeView();
      see(at, label, distance, view.departure(mesh_, distance));
    });
    const int first = mesh_.outgoing(v);
    int h = first;
    do {
      View here;
      here.halfedge = TriangleMesh::next(h);
      const TriangleMesh::Layout& l = mesh_.layout(here.halfedge);
      here.source = {l.x, l.y};
      lookOut(here, {l.length, 0}, {-1, 0}, label);
      h = mesh_.rotate(h);
    } while (h >= 0 && h != first);
  }

  template <Side side>
  void lookAside(const View& view, int v) {
    constexpr bool kLeft = side == Side::kLeft;
    const Entry own = entries_[v];
    bool isBehind = false;
    walkFan<side>(view, [&](const FanFace& face) {
      const int outer = kLeft ? mesh_.tail(face.halfedge) : mesh_.tip(face.halfedge);
      const int at = mesh_.tail(TriangleMesh::previous(face.halfedge));
      const bool wasBehind = std::exchange(isBehind, face.place == FanFace::Place::kBehind);
      if (isBehind)
        see(at, own.label, own.distance + (face.apex - face.inner).norm(),
            view.departure(mesh_, own.distance));
      else
        see(at, own.label, view, face.apex - face.source, face.axis);
      if (wasBehind || owner_[at] == own.label || owner_[outer] == own.label) return true;
      View here;
      here.source = face.source;
      here.heading = view.isBent ? view.heading : turned(view.heading, face.axis);
      here.offset = view.offset;
      here.isBent = view.isBent;
      here.halfedge =
          kLeft ? TriangleMesh::previous(face.halfedge) : TriangleMesh::next(face.halfedge);
      // Where the line behind the vertex runs through the face, up to that line.
      if (isBehind) (kLeft ? here.right : here.left) = face.inner - face.source;
      const Vector2d origin = kLeft ? face.outer : face.apex;
      const Vector2d end = kLeft ? face.apex : face.outer;
      lookOut(here, origin, (end - origin) * (2 * mesh_.layout(here.halfedge).inverse), own.label);
      return true;
    });
  }

  /// Queues a look through a halfedge of the face a source lies in or is seen in, out to the face
  /// across, between the view's bounds; a bound of zero is the end of the halfedge. The twin's
  /// frame is given in that of the view.
  void lookOut(const View& view, const Vector2d& origin, const Vector2d& axis, int label) {
    const Vector2d zero(0, 0);
    const int twin = mesh_.twin(view.halfedge);
    if (twin < 0 || ownsAnEnd(twin, label)) return;
    View out = inFrame(view, twin, origin, axis);
    if (!(out.source.y() <= 0)) return;  // on the edge itself is the site of two faces
    if (out.left == zero) out.left = -out.source;
    if (out.right == zero) out.right = Vector2d(mesh_.length(twin), 0) - out.source;
    queueLook(out, label);
  }

  void queueLook(const View& view, int label) {
    queue_.push({view.offset - view.source.y(), static_cast<int>(looks_.size())});
    looks_.push_back({view, label});
  }

  /// Regions may be so narrow that they cross faces of which they own no corner: there the site is
  /// seen through one edge after the other, as long as it owns something on them but no end.
  void lookThroughEdges() {
    while (!queue_.empty()) {
      const Look look = looks_[queue_.pop().entry];
      const View& view = look.view;
      const int tail = mesh_.tail(view.halfedge), tip = mesh_.tip(view.halfedge);
      if (ownsAnEnd(view.halfedge, look.label) ||
          isOutdone(look.label, tail, distanceAt(tail, look.label), tip,
                    distanceAt(tip, look.label)))
        continue;
      const int left = TriangleMesh::previous(view.halfedge);
      const int right = TriangleMesh::next(view.halfedge);
      const TriangleMesh::Layout& l = mesh_.layout(view.halfedge);
      const Vector2d apex(l.x, l.y), toApex = apex - view.source;
      if (!see(mesh_.tail(left), look.label, view, toApex, {1, 0})) continue;
      const double inverseLeft = 2 * mesh_.layout(left).inverse;
      const double inverseRight = 2 * mesh_.layout(right).inverse;
      if (mesh_.twin(left) >= 0 && cross(view.left, toApex) < 0) {
        View next = inFrame(view, mesh_.twin(left), {0, 0}, apex * inverseLeft);
        if (cross(view.right, toApex) > 0) next.right = turned(toApex, apex * inverseLeft);
        queueLook(next, look.label);
      }
      if (mesh_.twin(right) >= 0 && cross(view.right, toApex) > 0) {
        const Vector2d axis = Vector2d(l.length - l.x, -l.y) * inverseRight;
        View next = inFrame(view, mesh_.twin(right), apex, axis);
        if (cross(view.left, toApex) < 0) next.left = turned(toApex, axis);
        queueLook(next, look.label);
      }
    }
    looks_.clear();
  }

  /// A vertex looks around for the label that owns it, so nothing needs to be looked for behind the
  /// edges there.
  bool ownsAnEnd(int halfedge, int label) const {
    return owner_[mesh_.tail(halfedge)] == label || owner_[mesh_.tip(halfedge)] == label;
  }

  /// Whether the labels known at both ends of an edge leave nothing of it to a label with these
  /// distances there.
  bool isOutdone(int label, int v, double atV, int u, double atU) const {
    EdgeShare share(label, atV, atU);
    for (int e = v; e >= 0 && !share.isEmpty(); e = entries_[e].next) {
      const int other = entries_[e].label, atOtherEnd = find(u, other);
      if (other != label && atOtherEnd >= 0)
        share.yieldTo(other, entries_[e].distance, entries_[atOtherEnd].distance);
    }
    return share.isEmpty();
  }

  Vector2d departureOf(int entry) const {
    return entry < mesh_.vertexCount() ? views_[entry].departure(mesh_, entries_[entry].distance)
                                       : departures_[entry - mesh_.vertexCount()];
  }

  /// Makes a label that may own something on a side of a face known at the third corner, should it
  /// be out of sight from there. Returns whether there was any.
  bool completeFaces() {
    bool found = false;
    for (int h = 0; h < mesh_.halfedgeCount(); ++h) {
      const int tail = mesh_.tail(h), tip = mesh_.tip(h);
      if (entries_[tail].next < 0 && entries_[tip].next < 0) continue;
      const int back = TriangleMesh::previous(h), apex = mesh_.tail(back);
      for (int e = tail; e >= 0; e = entries_[e].next) {
        const int label = entries_[e].label;
        const double atTail = entries_[e].distance, atTip = distanceAt(tip, label);
        if (atTip == kInfinity || find(apex, label) >= 0 ||
            isOutdone(label, tail, atTail, tip, atTip))
          continue;
        const double overTail = atTail + mesh_.length(back);
        const double overTip = atTip + mesh_.length(TriangleMesh::next(h));
        const int last = overTail <= overTip ? e : find(tip, label);
        see(apex, label, std::min(overTail, overTip), departureOf(last));
        found = true;
      }
    }
    return found;
  }

  std::unique_ptr<DistanceField> collect() {
    std::vector<int> offset = {0};
    std::vector<LabelledDistance> values, here;
    std::vector<Vector2d> departures;
    offset.reserve(mesh_.vertexCount() + 1);
    values.reserve(entries_.size());
    departures.reserve(entries_.size());
    for (int v = 0; v < mesh_.vertexCount(); ++v) {
      here.clear();
      for (int e = v; e >= 0 && entries_[e].label >= 0; e = entries_[e].next)
        here.push_back({entries_[e].label, entries_[e].distance});
      equalizeTies(here);
      for (const LabelledDistance& d : here) {
        values.push_back(d);
        const int e = find(v, d.label);
        departures.push_back(e == v ? Vector2d(0, 0) : departures_[e - mesh_.vertexCount()]);
      }
      offset.push_back(static_cast<int>(values.size()));
    }
    return std::make_unique<DgpcField>(mesh_, sites_, std::move(offset), std::move(values),
                                       std::move(views_), std::move(departures));
  }

  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> sites_;
  Spread spread_;
  std::vector<char> bends_;
  std::vector<Entry> entries_;
  std::vector<View> views_;    ///< of the entries
  std::vector<int> vertices_;  ///< of the entries behind the first ones
  /// Once only the owners' entries are kept, further ones need no view.
  bool areOwnersKept_ = false;
  std::vector<Vector2d> departures_;  ///< of the entries behind the first ones, then
  std::vector<int> owner_;            ///< the nearest label of each vertex, -1 if none has come
  SweepQueue<QueueItem> queue_;
  std::vector<Look> looks_;
  int reachedVertices_ = 0;
};

}  // namespace

std::unique_ptr<Propagation> propagateDgpc(const TriangleMesh& mesh,
                                           std::span<const SurfacePoint> sites, Spread spread) {
  return std::make_unique<DgpcSweep>(mesh, sites, spread);
}

}  // namespace gvd
