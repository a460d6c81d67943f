// SPDX-License-Identifier: MIT
#include "continuation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dgpc_field.h"
#include "edge_share.h"
#include "fan.h"
#include "heap.h"
#include "tolerances.h"
#include "unfolding.h"

namespace gvd {
namespace {

using Eigen::Vector2d;

class Continuation {
 public:
  Continuation(const TriangleMesh& mesh, std::vector<SurfacePoint> sites,
               std::vector<LabelledDistance> nearest, std::vector<View> views)
      : mesh_(mesh),
        sites_(std::move(sites)),
        nearest_(std::move(nearest)),
        views_(std::move(views)),
        firstGuest_(mesh.vertexCount(), -1),
        queue_(mesh.meanEdgeLength()) {}

  std::unique_ptr<DistanceField> run() {
    for (int label = 0; label < static_cast<int>(sites_.size()); ++label) lookFromSite(label);
    for (const int v : verticesAtBorders()) lookAround(v);
    unfoldGuests();
    for (size_t i = 0; i < looks_.size(); ++i)
      if (!isOutdone(looks_[i].view.halfedge, looks_[i].label)) queueLook(static_cast<int>(i));
    do {
      lookThroughEdges();
    } while (completeFaces());
    return collect();
  }

 private:
  /// A label known at a vertex that another one owns; they form a list at each vertex.
  struct Guest {
    double distance;
    int label;
    int next;  ///< -1 at the end
    Vector2d departure;
  };

  /// A site seen through a halfedge by the face it belongs to, between the view's bounds.
  struct Look {
    View view;
    int label;
  };

  struct QueueItem {
    double distance;
    int look;
    /// By distance; then in the order they were made.
    bool operator<(const QueueItem& other) const {
      return distance < other.distance || (distance == other.distance && look < other.look);
    }
  };

  // --- What is known ---

  int owner(int vertex) const { return nearest_[vertex].label; }

  int findGuest(int vertex, int label) const {
    int g = firstGuest_[vertex];
    while (g >= 0 && guests_[g].label != label) g = guests_[g].next;
    return g;
  }

  double distanceAt(int vertex, int label) const {
    if (owner(vertex) == label) return nearest_[vertex].distance;
    const int g = findGuest(vertex, label);
    return g < 0 ? kInfinity : guests_[g].distance;
  }

  Vector2d departureAt(int vertex, int label) const {
    return owner(vertex) == label ? views_[vertex].departure(mesh_, nearest_[vertex].distance)
                                  : guests_[findGuest(vertex, label)].departure;
  }

  /// Ascending, those of which some neighbour belongs to another label.
  std::vector<int> verticesAtBorders() const {
    std::vector<char> isAtBorder(mesh_.vertexCount());
    for (int h = 0; h < mesh_.halfedgeCount(); h += 3) {
      const int a = mesh_.tail(h), b = mesh_.tail(h + 1), c = mesh_.tail(h + 2);
      const int ofA = owner(a), ofB = owner(b), ofC = owner(c);
      if (ofA == ofB && ofB == ofC) continue;
      isAtBorder[a] = isAtBorder[b] = isAtBorder[c] = true;
    }
    std::vector<int> vertices;
    for (int v = 0; v < mesh_.vertexCount(); ++v)
      if (isAtBorder[v] && owner(v) >= 0) vertices.push_back(v);
    return vertices;
  }

  /// Notes how far a label appears to be from a vertex that another one owns; the shortest counts.
  /// The owner has been found by better means, so what appears to be nearer comes next to it.
  /// Returns false in that case. `departure` tells the direction at the site, in the site's frame.
  template <class Departure>
  bool see(int vertex, int label, double distance, Departure departure) {
    if (owner(vertex) == label) return true;
    const double owners = nearest_[vertex].distance;
    const bool isNearer = distance < owners * (1 - kDistanceTolerance);
    if (isNearer) distance = owners * (1 + 4 * kDistanceTolerance);
    const int guest = findGuest(vertex, label);
    if (guest < 0) {
      if (firstGuest_[vertex] < 0) hosts_.push_back(vertex);
      const int next = std::exchange(firstGuest_[vertex], static_cast<int>(guests_.size()));
      guests_.push_back({distance, label, next, departure()});
    } else if (distance < guests_[guest].distance * (1 - kDistanceTolerance)) {
      guests_[guest].distance = distance;
      guests_[guest].departure = departure();
    }
    return !isNearer;
  }

  /// The same along a straight line from the source of a view, given in the view's frame.
  bool see(int vertex, int label, const View& view, const Vector2d& path) {
    if (owner(vertex) == label) return true;
    const double length = path.norm();
    return see(vertex, label, view.offset + length,
               [&] { return length > 0 ? view.departure(path / length) : Vector2d(1, 0); });
  }

  // --- Looking around ---

  void lookFromSite(int label) {
    for (int i = 0; i < 3; ++i) {
      const View view = viewOfCorner(mesh_, sites_[label], i);
      const double distance = distanceOfCorner(mesh_, sites_[label], i);
      see(mesh_.tail(3 * sites_[label].face + i), label, distance,
          [&] { return view.departure(mesh_, distance); });
    }
    for (int i = 0; i < 3; ++i) {
      const View view = viewOfCorner(mesh_, sites_[label], i);
      lookOut(view, view.halfedge, {0, 0}, {mesh_.length(view.halfedge), 0}, label);
    }
  }

  /// Lets the vertices around one see the label that owns it, and looks out of the faces of which
  /// the label owns this corner only.
  void lookAround(int v) {
    const int label = owner(v);
    const View& view = views_[v];
    if (view.halfedge < 0) {
      lookAroundSite(v);
      return;
    }
    const Vector2d tip(mesh_.length(view.halfedge), 0);
    see(mesh_.tail(view.halfedge), label, view, -view.source);
    see(mesh_.tip(view.halfedge), label, view, tip - view.source);
    View free = view;
    free.left = free.right = {0, 0};
    lookOut(free, view.halfedge, {0, 0}, tip, label);

    // If the sides leave a gap between them, the left one sees to that; up to the boundary both.
    const bool isOnBoundary = mesh_.onBoundary(v);
    const int behindRight =
        lookAside<Side::kRight>(view, v, isOnBoundary ? kToBoundary : kToFirstBehind);
    lookAside<Side::kLeft>(view, v, isOnBoundary ? kToBoundary : behindRight);
  }

  /// The same around a vertex that is the site.
  void lookAroundSite(int v) {
    const int label = owner(v);
    const double first = angleOfFirstSpoke(mesh_, sites_[label], v);
    visitSpokes(mesh_, v, [&](const Spoke& spoke) {
      const double angle = first + spoke.angle;
      const Vector2d departure(std::cos(angle), std::sin(angle));
      see(spoke.neighbour, label, spoke.length, [&] { return departure; });
      if (spoke.isFromTail) return;
      View here;
      here.halfedge = TriangleMesh::previous(spoke.halfedge);
      const TriangleMesh::Layout& l = mesh_.layout(here.halfedge);
      here.source = {l.x, l.y};
      here.heading = turned(-here.source / spoke.length, departure);
      lookOut(here, here.halfedge, {0, 0}, {mesh_.length(here.halfedge), 0}, label);
    });
  }

  /// Looks around on one side, up to `last` (walkFan).
  template <Side side>
  int lookAside(const View& view, int v, int last) {
    constexpr bool kLeft = side == Side::kLeft;
    const int label = owner(v);
    const double distance = nearest_[v].distance;
    const Vector2d path = view.path(mesh_);
    View here = view;  // as seen from the vertex
    here.source = -path;
    here.left = here.right = {0, 0};
    bool wasBehind = false;
    Sight<side> sight(view);
    return walkFan<side>(mesh_, view, path, last, [&](const FanFace& face) {
      const int at = mesh_.tail(TriangleMesh::previous(face.halfedge));
      const bool isBehind = face.place == FanFace::Place::kBehind;
      if (const int outer = outerEnd<side>(face, mesh_); limitsViews(mesh_, outer))
        sight.limit(path + face.outer);
      if (owner(at) == label) {
        wasBehind = isBehind;
        return;
      }
      const Vector2d toApex = path + face.apex, &bound = sight.bound();
      if (isBehind)
        see(at, label, distance + face.apex.norm(),
            [&] { return view.departure(mesh_, distance); });
      else if (sight.reaches(toApex))
        see(at, label, view, toApex);
      else
        see(at, label, view.offset + bound.norm() + (toApex - bound).norm(),
            [&] { return view.departure(bound.normalized()); });
      if (std::exchange(wasBehind, isBehind)) return;
      // Where the line behind the vertex runs through the face, up to that line.
      if (isBehind) (kLeft ? here.right : here.left) = path;
      if (kLeft)
        lookOut(here, TriangleMesh::previous(face.halfedge), face.apex, face.outer, label);
      else
        lookOut(here, TriangleMesh::next(face.halfedge), face.outer, face.apex, label);
    });
  }

  /// Notes a look through a halfedge of the face that a source lies in or is seen in, out to the
  /// face across, between the view's bounds; a bound of zero is the end of the halfedge. Its ends
  /// are given in the view's frame.
  ///
  /// A vertex looks around for the label that owns it, so nothing needs to be looked for behind the
  /// edges there, and nothing behind an edge that others share among themselves.
  void lookOut(const View& view, int halfedge, const Vector2d& tail, const Vector2d& tip,
               int label) {
    const Vector2d zero(0, 0);
    const int twin = mesh_.twin(halfedge);
    if (twin < 0 || ownsAnEnd(twin, label)) return;
    const TriangleMesh::Layout& l = mesh_.layout(twin);
    View out = view.inFrame(twin, tip, (tail - tip) * (2 * l.inverse));
    if (!(out.source.y() <= 0)) return;  // on the edge itself is the site of two faces
    if (out.left == zero) out.left = -out.source;
    if (out.right == zero) out.right = Vector2d(l.length, 0) - out.source;
    looks_.push_back({out, label});
  }

  bool ownsBothEnds(int halfedge, int label) const {
    return owner(mesh_.tail(halfedge)) == label && owner(mesh_.tip(halfedge)) == label;
  }

  bool ownsAnEnd(int halfedge, int label) const {
    return owner(mesh_.tail(halfedge)) == label || owner(mesh_.tip(halfedge)) == label;
  }

  /// What is hidden from the vertices that a label owns may be nearer by way of other guests: each
  /// takes the least of what its faces' other corners put there. All at once, so that the order in
  /// which they were noted does not matter.
  void unfoldGuests() {
    std::vector<Guest> unfolded = guests_;
    for (const int host : hosts_)
      for (int g = firstGuest_[host]; g >= 0; g = guests_[g].next)
        unfoldGuest(host, unfolded[g]);
    guests_ = std::move(unfolded);
  }

  void unfoldGuest(int host, Guest& guest) const {
    const double least = nearest_[host].distance * (1 + 4 * kDistanceTolerance);
    const int label = guest.label, first = mesh_.outgoing(host);
    int h = first;
    double atRight = distanceAt(mesh_.tip(h), label);
    do {
      const int across = TriangleMesh::next(h);
      const double atLeft = distanceAt(mesh_.tip(across), label);
      if (atLeft < kInfinity && atRight < kInfinity && !ownsBothEnds(across, label)) {
        const Unfolded u = unfold(mesh_, across, atRight, atLeft);
        const double distance = std::max(least, u.distance);
        if (distance < guest.distance * (1 - kDistanceTolerance)) {
          guest.distance = distance;
          guest.departure = u.byTail * departureAt(mesh_.tail(across), label) +
                            u.byTip * departureAt(mesh_.tip(across), label);
        }
      }
      atRight = atLeft;
      h = mesh_.rotate(h);
    } while (h >= 0 && h != first);
  }

  // --- Looking through edges ---

  void queueLook(int look) {
    const View& view = looks_[look].view;
    queue_.push({view.offset - view.source.y(), look});
  }

  void addLook(const View& view, int label) {
    if (isFutile(view)) return;
    looks_.push_back({view, label});
    queueLook(static_cast<int>(looks_.size()) - 1);
  }

  /// Whether a view through an edge has no width, or comes from so far that the nearest sites of the
  /// edge's ends, and with them those of all its points, are nearer: distances differ by no more
  /// than the way between. This ends every chain of looks.
  bool isFutile(const View& view) const {
    if (!(cross(view.right, view.left) > 0)) return true;
    const int tail = mesh_.tail(view.halfedge), tip = mesh_.tip(view.halfedge);
    const double length = mesh_.length(view.halfedge);
    const double beside = std::max({0.0, -view.source.x(), view.source.x() - length});
    const double least = view.offset + std::hypot(beside, view.source.y());
    return least > (nearest_[tail].distance + nearest_[tip].distance + length) / 2;
  }

  /// Regions may be so narrow that they cross faces of which they own no corner: there the site is
  /// seen through one edge after the other, as long as it owns something on them but no end.
  void lookThroughEdges() {
    while (!queue_.empty()) {
      const Look look = looks_[queue_.pop().look];
      const View& view = look.view;
      if (ownsAnEnd(view.halfedge, look.label) || isOutdone(view.halfedge, look.label)) continue;
      const int left = TriangleMesh::previous(view.halfedge);
      const int right = TriangleMesh::next(view.halfedge);
      const TriangleMesh::Layout& l = mesh_.layout(view.halfedge);
      const Vector2d apex(l.x, l.y), toApex = apex - view.source;
      if (!see(mesh_.tail(left), look.label, view, toApex)) continue;
      const double inverseLeft = 2 * mesh_.layout(left).inverse;
      const double inverseRight = 2 * mesh_.layout(right).inverse;
      if (mesh_.twin(left) >= 0 && cross(view.left, toApex) < 0) {
        View next = view.inFrame(mesh_.twin(left), {0, 0}, apex * inverseLeft);
        if (cross(view.right, toApex) > 0) next.right = turned(toApex, apex * inverseLeft);
        addLook(next, look.label);
      }
      if (mesh_.twin(right) >= 0 && cross(view.right, toApex) > 0) {
        const Vector2d axis = Vector2d(l.length - l.x, -l.y) * inverseRight;
        View next = view.inFrame(mesh_.twin(right), apex, axis);
        if (cross(view.left, toApex) < 0) next.left = turned(toApex, axis);
        addLook(next, look.label);
      }
    }
    looks_.clear();
  }

  /// Whether the labels known at both ends of an edge leave nothing of it to one of them.
  bool isOutdone(int halfedge, int label) const {
    const int v = mesh_.tail(halfedge), u = mesh_.tip(halfedge);
    EdgeShare share(label, distanceAt(v, label), distanceAt(u, label));
    const auto yieldTo = [&](int other, double atV) {
      if (other == label) return;
      const double atU = distanceAt(u, other);
      if (atU < kInfinity) share.yieldTo(other, atV, atU);
    };
    yieldTo(owner(v), nearest_[v].distance);
    for (int g = firstGuest_[v]; g >= 0 && !share.isEmpty(); g = guests_[g].next)
      yieldTo(guests_[g].label, guests_[g].distance);
    return share.isEmpty();
  }

  /// Makes a label that may own something on a side of a face known at the third corner, should it
  /// be out of sight from there. Returns whether there was any.
  ///
  /// An owner is seen by all neighbours, so on such a side the label is a guest at one of the ends.
  bool completeFaces() {
    const size_t before = guests_.size();
    for (size_t i = 0; i < hosts_.size(); ++i) {
      const int host = hosts_[i];
      const int first = mesh_.outgoing(host);
      int h = first;
      do {
        completeFace(h);
        h = mesh_.rotate(h);
      } while (h >= 0 && h != first);
    }
    return guests_.size() > before;
  }

  /// The same in one face, for the guests of the vertex that a halfedge leaves.
  void completeFace(int halfedge) {
    const int host = mesh_.tail(halfedge);
    for (int g = firstGuest_[host]; g >= 0; g = guests_[g].next) {
      const int label = guests_[g].label;
      const double atTip = distanceAt(mesh_.tip(halfedge), label);
      const int back = TriangleMesh::previous(halfedge);
      const double atApex = distanceAt(mesh_.tail(back), label);
      if ((atTip == kInfinity) == (atApex == kInfinity)) continue;
      const int side = atTip == kInfinity ? back : halfedge;
      if (!isOutdone(side, label)) seeOverEnds(side, label);
    }
  }

  void seeOverEnds(int side, int label) {
    const int tail = mesh_.tail(side), tip = mesh_.tip(side), back = TriangleMesh::previous(side);
    const double overTail = distanceAt(tail, label) + mesh_.length(back);
    const double overTip = distanceAt(tip, label) + mesh_.length(TriangleMesh::next(side));
    see(mesh_.tail(back), label, std::min(overTail, overTip),
        [&] { return departureAt(overTail <= overTip ? tail : tip, label); });
  }

  // --- The result ---

  std::unique_ptr<DistanceField> collect() {
    std::vector<int> offset = {0};
    std::vector<LabelledDistance> values, here;
    std::vector<Vector2d> departures;
    const size_t count = nearest_.size() + guests_.size();
    offset.reserve(nearest_.size() + 1);
    values.reserve(count);
    departures.reserve(count);
    for (int v = 0; v < mesh_.vertexCount(); ++v) {
      if (owner(v) >= 0) {
        here.assign(1, nearest_[v]);
        for (int g = firstGuest_[v]; g >= 0; g = guests_[g].next)
          here.push_back({guests_[g].label, guests_[g].distance});
        equalizeTies(here);
        for (const LabelledDistance& d : here) {
          values.push_back(d);
          departures.push_back(d.label == owner(v) ? Vector2d(0, 0) : departureAt(v, d.label));
        }
      }
      offset.push_back(static_cast<int>(values.size()));
    }
    return std::make_unique<DgpcField>(mesh_, std::move(sites_), std::move(offset),
                                       std::move(values), std::move(views_),
                                       std::move(departures));
  }

  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> sites_;
  std::vector<LabelledDistance> nearest_;
  std::vector<View> views_;
  std::vector<int> firstGuest_;  ///< per vertex, -1: none
  std::vector<Guest> guests_;
  std::vector<int> hosts_;  ///< the vertices that have guests
  std::vector<Look> looks_;
  SweepQueue<QueueItem> queue_;
};

}  // namespace

std::unique_ptr<DistanceField> continueOverBorders(const TriangleMesh& mesh,
                                                   std::vector<SurfacePoint> sites,
                                                   std::vector<LabelledDistance> nearest,
                                                   std::vector<View> views) {
  return Continuation(mesh, std::move(sites), std::move(nearest), std::move(views)).run();
}

}  // namespace gvd
