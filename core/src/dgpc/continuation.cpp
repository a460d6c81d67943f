// SPDX-License-Identifier: MIT
#include "dgpc/continuation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "base/heap.h"
#include "base/index_set.h"
#include "base/prefetch.h"
#include "base/tolerances.h"
#include "dgpc/dgpc_view.h"
#include "dgpc/fan.h"
#include "dgpc/path_straightening.h"
#include "dgpc/saddle_ties.h"
#include "distance/edge_share.h"
#include "distance/site_frame.h"

namespace gvd {
namespace {

using Eigen::Vector2d;

class Continuation {
 public:
  explicit Continuation(DgpcField& field)
      : mesh_(field.mesh()),
        field_(field),
        scope_(mesh_.vertexCount(), Scope::kOutside),
        inScope_(mesh_.vertexCount()),
        sources_(mesh_.vertexCount()),
        firstGuest_(mesh_.vertexCount(), -1),
        ownPath_(mesh_.vertexCount(), -1),
        queue_(mesh_.meanEdgeLength()),
        straightener_(field) {}

  /// Only once.
  void runEverywhere() {
    scope_.assign(mesh_.vertexCount(), Scope::kInside);
    for (int label = 0; label < static_cast<int>(field_.sites().size()); ++label)
      if (field_.sites()[label].face >= 0) lookFromSite(label);
    const std::vector<int> borders = verticesAtBorders();
    guests_.reserve(2 * borders.size());
    guestViews_.reserve(2 * borders.size());
    lookAround(borders);
    findGuests();
    field_.reserve(hosts_.size() + guests_.size());
    for (const int host : hosts_) collect(host);
    for (const int v : farHosts_) field_.setFarLabel(v, true);
    SaddleTies(field_, straightener_).carryEverywhere();
  }

  /// What a vertex is told first depends on its neighbours, and what it makes of that on theirs; an
  /// edge is looked through for what its ends make of it. So the effect of a change ends three
  /// edges away, unless labels come from further: then with all that those have come to.
  LabelChange runAround(std::span<const int> changed) {
    inScope_.clear();
    for (const int v : changed) inScope_.add(v);
    for (int ring = 0, first = 0; ring < 3; ++ring) first = addNeighbours(inScope_, first);
    for (int size = 0; size < inScope_.size();) {
      addDependent(inScope_);
      size = inScope_.size();
      runWithinScope();
      for (const int v : farHosts_) {
        inScope_.add(v);
        mesh_.visitNeighbours(v, [&](int neighbour) { inScope_.add(neighbour); });
      }
    }
    LabelChange change{{changed.begin(), changed.end()}, {}};
    const auto noteLabels = [&](int v) {
      for (const LabelledDistance& d : field_.at(v)) change.labels.push_back(d.label);
    };
    for (const int v : changed) noteLabels(v);
    for (const int v : inScope_.list()) {
      const size_t count = change.labels.size();
      noteLabels(v);
      if (collect(v)) {
        noteLabels(v);
        change.vertices.push_back(v);
      } else {
        change.labels.resize(count);
      }
      field_.setFarLabel(v, false);
    }
    for (const int v : farHosts_) field_.setFarLabel(v, true);
    for (const int v : SaddleTies(field_, straightener_).carryAround(inScope_)) {
      noteLabels(v);
      change.vertices.push_back(v);
    }
    for (const int v : changed) noteLabels(v);
    makeSet(change.vertices);
    makeSet(change.labels);
    return change;
  }

 private:
  /// A label known at a vertex that another one owns; they form a list at each vertex.
  struct Guest {
    int vertex;
    int label;
    double distance;
    int next;  ///< -1 at the end
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

  // --- Scope ---

  /// Adds the neighbours of those vertices that have been added as number `first` or later; returns
  /// the number from which to go on.
  int addNeighbours(IndexSet& vertices, int first) const {
    const int end = vertices.size();
    for (int i = first; i < end; ++i)
      mesh_.visitNeighbours(vertices.list()[i], [&](int neighbour) { vertices.add(neighbour); });
    return end;
  }

  /// Adds what a scope has effects on further away.
  void addDependent(IndexSet& scope) const {
    for (int size = 0; size < scope.size();) {
      size = scope.size();
      addFarHosts(scope);
      SaddleTies::addTold(field_, scope);
    }
  }

  /// Adds all vertices with labels from far that hang together with a scope, and their neighbours.
  void addFarHosts(IndexSet& scope) const {
    for (int i = 0; i < scope.size(); ++i) {
      mesh_.visitNeighbours(scope.list()[i], [&](int v) {
        if (!field_.hasFarLabel(v)) return;
        scope.add(v);
        mesh_.visitNeighbours(v, [&](int neighbour) { scope.add(neighbour); });
      });
    }
  }

  bool isInScope(int vertex) const { return scope_[vertex] == Scope::kInside; }
  bool isInScope(int vertex, int other) const { return isInScope(vertex) && isInScope(other); }
  bool isTold(int vertex) const { return scope_[vertex] != Scope::kOutside; }

  /// Finds the guests of the vertices in scope. Their neighbours are told all that is needed to
  /// that end; what they make of it counts where it makes a guest nearer than the owner.
  void runWithinScope() {
    forget();
    for (const int v : inScope_.list()) sources_.add(v);
    const int told = addNeighbours(sources_, 0);
    const int endOfTold = sources_.size();
    for (int i = 0; i < endOfTold; ++i)
      scope_[sources_.list()[i]] = i < told ? Scope::kInside : Scope::kTold;
    for (int label = 0; label < static_cast<int>(field_.sites().size()); ++label) {
      const int face = field_.sites()[label].face;
      if (face >= 0 && (isTold(mesh_.tail(3 * face)) || isTold(mesh_.tail(3 * face + 1)) ||
                        isTold(mesh_.tail(3 * face + 2))))
        lookFromSite(label);
    }
    addNeighbours(sources_, told);
    for (const int v : sources_.sorted())
      if (owner(v) >= 0 && isAtBorder(v)) lookAround(v);
    findGuests();
  }

  /// Takes back what the last such run has found.
  void forget() {
    for (const int v : sources_.list()) scope_[v] = Scope::kOutside;
    for (const int host : hosts_) firstGuest_[host] = -1;
    for (const OwnPath& p : ownPaths_) ownPath_[p.vertex] = -1;
    sources_.clear();
    ownPaths_.clear();
    guests_.clear();
    guestViews_.clear();
    hosts_.clear();
    farHosts_.clear();
    looks_.clear();
    straightener_.forget();
  }

  void findGuests() {
    size_t straightened = hosts_.size();
    straightenPaths();
    for (size_t i = 0; i < looks_.size(); ++i) {
      const int halfedge = looks_[i].view.halfedge;
      if (isInScope(mesh_.tail(halfedge), mesh_.tip(halfedge)) &&
          !isOutdone(halfedge, looks_[i].label))
        queueLook(static_cast<int>(i));
    }
    int known = 0;
    do {
      lookThroughEdges();
      for (; straightened < hosts_.size(); ++straightened)
        if (isTold(hosts_[straightened])) straightenOwner(hosts_[straightened]);
    } while (completeFaces(known));
  }

  // --- What is known ---

  int owner(int vertex) const { return field_.nearest(vertex).label; }

  double ownersDistance(int vertex) const {
    return ownPath_[vertex] < 0 ? field_.nearest(vertex).distance
                                : ownPaths_[ownPath_[vertex]].path.length;
  }

  int findGuest(int vertex, int label) const {
    int g = firstGuest_[vertex];
    while (g >= 0 && guests_[g].label != label) g = guests_[g].next;
    return g;
  }

  double distanceAt(int vertex, int label) const {
    if (owner(vertex) == label) return ownersDistance(vertex);
    const int g = findGuest(vertex, label);
    return g < 0 ? kInfinity : guests_[g].distance;
  }

  Vector2d departureAt(int vertex, int label) const {
    if (owner(vertex) != label) return departureOf(guestViews_[findGuest(vertex, label)]);
    if (ownPath_[vertex] >= 0) return ownPaths_[ownPath_[vertex]].path.departure;
    return field_.view(vertex).departure(mesh_, field_.nearest(vertex).distance);
  }

  Vector2d departureOf(const View& view) const {
    return view.departure(mesh_, view.offset + view.path(mesh_).norm());
  }

  /// Those of which some neighbour belongs to another label: one owner's after the other's, which
  /// are near each other, for memory is what looking around waits for.
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
    return sortedByLabel(vertices, [&](int v) { return owner(v); });
  }

  /// The same items, label by label, those of one label in the order they are given in.
  template <class Item, class LabelOf>
  std::vector<Item> sortedByLabel(const std::vector<Item>& items, LabelOf labelOf) const {
    std::vector<int> next(field_.sites().size() + 1);
    for (const Item& item : items) ++next[labelOf(item) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<Item> sorted(items.size());
    for (const Item& item : items) sorted[next[labelOf(item)]++] = item;
    return sorted;
  }

  bool isAtBorder(int vertex) const {
    bool result = false;
    mesh_.visitNeighbours(vertex, [&](int v) { result |= owner(v) != owner(vertex); });
    return result;
  }

  /// The owner of a vertex has been found by better means than what it is told of others: what
  /// appears to be nearer counts as being as far. Returns whether that is so.
  bool keepBehindOwner(int vertex, double& distance) const {
    const double owners = ownersDistance(vertex);
    if (!(distance < owners * (1 - kDistanceTolerance))) return false;
    distance = owners;
    return true;
  }

  /// Notes how far a label appears to be from a vertex that another one owns; the shortest counts.
  /// Returns false if it appears to be nearer than the owner. `view` is only asked for if needed.
  template <class MakeView>
  bool see(int vertex, int label, double distance, MakeView view) {
    if (owner(vertex) == label) return true;
    const bool isNearer = keepBehindOwner(vertex, distance);
    const int guest = findGuest(vertex, label);
    if (guest < 0) {
      if (firstGuest_[vertex] < 0) hosts_.push_back(vertex);
      const int next = std::exchange(firstGuest_[vertex], static_cast<int>(guests_.size()));
      guests_.push_back({vertex, label, distance, next});
      guestViews_.push_back(view());
    } else if (distance < guests_[guest].distance * (1 - kDistanceTolerance)) {
      guests_[guest].distance = distance;
      guestViews_[guest] = view();
    }
    return !isNearer;
  }

  /// The same where a label comes to a vertex from further than its neighbours.
  template <class MakeView>
  bool seeFromAfar(int vertex, int label, double distance, MakeView view) {
    if (owner(vertex) != label) farHosts_.push_back(vertex);
    return see(vertex, label, distance, view);
  }

  // --- Looking around ---

  void lookFromSite(int label) {
    const SurfacePoint& site = field_.sites()[label];
    for (int i = 0; i < 3; ++i) {
      const View view = viewOfCorner(mesh_, site, i);
      const double distance = distanceOfCorner(mesh_, site, i);
      see(mesh_.tail(3 * site.face + i), label, distance, [&] { return view; });
    }
    for (int i = 0; i < 3; ++i) {
      const View view = viewOfCorner(mesh_, site, i);
      lookOut(view, view.halfedge, {0, 0}, {mesh_.length(view.halfedge), 0}, label);
    }
  }

  /// From vertices that hang together more or less: what the next ones need is asked for ahead.
  void lookAround(const std::vector<int>& vertices) {
    constexpr size_t kAhead = 4;
    for (size_t i = 0; i < vertices.size(); ++i) {
      if (i + kAhead < vertices.size()) prefetch(field_.view(vertices[i + kAhead]));
      if (i + 1 < vertices.size()) {
        const int h = field_.view(vertices[i + 1]).halfedge;
        if (h >= 0) prefetchFan(mesh_, h, [&](int v) { prefetch(field_.nearest(v)); });
      }
      lookAround(vertices[i]);
    }
  }

  /// Lets the vertices around one see the label that owns it, and looks out of the faces of which
  /// the label owns this corner only.
  void lookAround(int v) {
    if (field_.view(v).halfedge < 0)
      lookAroundSite(v);
    else
      lookAround(v, owner(v), field_.view(v), field_.nearest(v).distance);
  }

  /// The same for a label that a vertex sees by a view, at a distance.
  void lookAround(int v, int label, const View& view, double distance) {
    const Vector2d tip(mesh_.length(view.halfedge), 0);
    lookAtEnds(view, label);
    View free = view;
    free.left = free.right = {0, 0};
    lookOut(free, view.halfedge, {0, 0}, tip, label);

    // If the sides leave a gap between them, the left one sees to that; up to the boundary both.
    const bool isOnBoundary = mesh_.onBoundary(v);
    const int behindRight =
        lookAside<Side::kRight>(label, view, distance, isOnBoundary ? kToBoundary : kToFirstBehind);
    lookAside<Side::kLeft>(label, view, distance, isOnBoundary ? kToBoundary : behindRight);
  }

  /// Lets the ends of a view's halfedge see the source, each through the side of the face that is
  /// across from it; from there, the source is beside that side.
  void lookAtEnds(const View& view, int label) {
    const int h = view.halfedge, next = TriangleMesh::next(h), previous = TriangleMesh::previous(h);
    const TriangleMesh::Layout& l = mesh_.layout(h);
    const Vector2d tip(l.length, 0), apex(l.x, l.y);
    see(mesh_.tail(h), label, view.offset + view.source.norm(),
        [&] { return view.inFrame(next, tip, (apex - tip) * (2 * mesh_.layout(next).inverse)); });
    see(mesh_.tip(h), label, view.offset + (tip - view.source).norm(),
        [&] { return view.inFrame(previous, apex, apex * (-2 * mesh_.layout(previous).inverse)); });
  }

  /// The same around a vertex that is the site.
  void lookAroundSite(int v) {
    const int label = owner(v);
    const double first = angleOfOutgoing(mesh_, field_.sites()[label], mesh_.outgoing(v));
    visitSpokes(mesh_, v, [&](const Spoke& spoke) {
      const double angle = first + spoke.angle;
      const Vector2d departure(std::cos(angle), std::sin(angle));
      see(spoke.neighbour, label, spoke.length, [&] { return viewAlong(mesh_, spoke, first); });
      if (spoke.isFromTail) return;
      View here;
      here.halfedge = TriangleMesh::previous(spoke.halfedge);
      const TriangleMesh::Layout& l = mesh_.layout(here.halfedge);
      here.source = {l.x, l.y};
      here.heading = turnedBackBy(-here.source / spoke.length, departure);
      lookOut(here, here.halfedge, {0, 0}, {mesh_.length(here.halfedge), 0}, label);
    });
  }

  /// Looks around on one side, up to `last` (walkFan).
  template <Side side>
  int lookAside(int label, const View& view, double distance, int last) {
    constexpr bool kLeft = side == Side::kLeft;
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
        see(at, label, distance + face.apex.norm(), [&] {
          View bent = viewFromBend<side>(mesh_, view, path, face, path);
          bent.offset = distance;  // which may be a geodesic's
          return bent;
        });
      else if (sight.reaches(toApex))
        see(at, label, view.offset + toApex.norm(),
            [&] { return viewThrough<side>(mesh_, view, path, face); });
      else
        see(at, label, view.offset + bound.norm() + (toApex - bound).norm(),
            [&] { return viewFromBend<side>(mesh_, view, path, face, bound); });
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
  /// edges there, and nothing behind an edge that is all another one's: one that owns both ends
  /// owns what is between. Of the others isOutdone tells, once all is known.
  void lookOut(const View& view, int halfedge, const Vector2d& tail, const Vector2d& tip,
               int label) {
    const Vector2d zero(0, 0);
    const int twin = mesh_.twin(halfedge);
    if (twin < 0 || ownsAnEnd(twin, label) || haveOneOwner(twin)) return;
    const TriangleMesh::Layout& l = mesh_.layout(twin);
    View out = view.inFrame(twin, tip, (tail - tip) * (2 * l.inverse));
    if (!(out.source.y() <= 0)) return;  // on the edge itself is the site of two faces
    if (out.left == zero) out.left = -out.source;
    if (out.right == zero) out.right = Vector2d(l.length, 0) - out.source;
    looks_.push_back({out, label});
  }

  bool haveOneOwner(int halfedge) const {
    return owner(mesh_.tail(halfedge)) == owner(mesh_.tip(halfedge));
  }

  bool ownsAnEnd(int halfedge, int label) const {
    return owner(mesh_.tail(halfedge)) == label || owner(mesh_.tip(halfedge)) == label;
  }

  // --- Straightening ---

  struct OwnPath {
    int vertex;
    LocalGeodesic path;
  };
  struct PathEnd {
    int label, vertex;
    int guest;  ///< -1: the vertex's owner
  };

  /// What is known where labels meet decides where they meet: there it is taken from geodesics. A
  /// geodesic is a path on the surface, never shorter than the distance; a view may be.
  void straightenPaths() {
    const std::vector<PathEnd> ends = bentPaths();
    for (const PathEnd& end : ends) {
      if (end.guest < 0) {
        straightenOwner(end.vertex);
        continue;
      }
      View& view = guestViews_[end.guest];
      const auto path = straightener_.straighten(end.label, end.vertex, view);
      if (!path) continue;
      guests_[end.guest].distance = path->length;
      view.heading = path->departure;
    }
    lookAroundNewOwners(ends);
  }

  /// The same for the path of a vertex's owner, if that has not been done.
  void straightenOwner(int vertex) {
    if (ownPath_[vertex] >= 0 || owner(vertex) < 0 || !field_.view(vertex).isBent()) return;
    const auto path = straightener_.straighten(owner(vertex), vertex, field_.view(vertex));
    if (!path) return;
    ownPath_[vertex] = static_cast<int>(ownPaths_.size());
    ownPaths_.push_back({vertex, *path});
  }

  /// Where a geodesic has made a guest nearer than the owner, the guest's label may have something
  /// in all faces there: the vertices around have to know it.
  void lookAroundNewOwners(std::span<const PathEnd> ends) {
    std::vector<std::pair<Guest, View>> nearest;
    for (const PathEnd& end : ends)
      if (end.guest >= 0 &&
          guests_[end.guest].distance < ownersDistance(end.vertex) * (1 - kDistanceTolerance))
        nearest.emplace_back(guests_[end.guest], guestViews_[end.guest]);
    for (const auto& [guest, view] : nearest)
      lookAround(guest.vertex, guest.label, view, guest.distance);
  }

  /// The paths to straighten, one label's after the other's: those run through the same faces.
  /// Paths that do not bend err little.
  std::vector<PathEnd> bentPaths() const {
    std::vector<PathEnd> ends;
    const auto addOwner = [&](int v) {
      if (field_.view(v).isBent()) ends.push_back({owner(v), v, -1});
    };
    for (const int host : hosts_) {
      if (!isTold(host)) continue;
      addOwner(host);
      for (int g = firstGuest_[host]; g >= 0; g = guests_[g].next)
        if (guestViews_[g].isBent()) ends.push_back({guests_[g].label, host, g});
    }
    return sortedByLabel(ends, [](const PathEnd& end) { return end.label; });
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

  /// Whether a view through an edge has no width, or comes from so far that the nearest sites of
  /// the edge's ends, and with them those of all its points, are nearer: distances differ by no
  /// more than the way between. This ends every chain of looks.
  bool isFutile(const View& view) const {
    if (!(cross(view.right, view.left) > 0)) return true;
    const int tail = mesh_.tail(view.halfedge), tip = mesh_.tip(view.halfedge);
    const double length = mesh_.length(view.halfedge);
    const double beside = std::max({0.0, -view.source.x(), view.source.x() - length});
    const double least = view.offset + std::hypot(beside, view.source.y());
    return least > (field_.nearest(tail).distance + field_.nearest(tip).distance + length) / 2;
  }

  /// Regions may be so narrow that they cross faces of which they own no corner: there the site is
  /// seen through one edge after the other, as long as it owns something on them but no end.
  void lookThroughEdges() {
    while (!queue_.empty()) {
      const Look look = looks_[queue_.pop().look];
      const View& view = look.view;
      if (!isInScope(mesh_.tail(view.halfedge), mesh_.tip(view.halfedge))) continue;
      if (ownsAnEnd(view.halfedge, look.label) || isOutdone(view.halfedge, look.label)) continue;
      const int left = TriangleMesh::previous(view.halfedge);
      const int right = TriangleMesh::next(view.halfedge);
      const TriangleMesh::Layout& l = mesh_.layout(view.halfedge);
      const Vector2d apex(l.x, l.y), toApex = apex - view.source;
      if (!seeFromAfar(mesh_.tail(left), look.label, view.offset + toApex.norm(),
                       [&] { return view; }))
        continue;
      const double inverseLeft = 2 * mesh_.layout(left).inverse;
      const double inverseRight = 2 * mesh_.layout(right).inverse;
      if (mesh_.twin(left) >= 0 && cross(view.left, toApex) < 0) {
        View next = view.inFrame(mesh_.twin(left), {0, 0}, apex * inverseLeft);
        if (cross(view.right, toApex) > 0) next.right = turnedBackBy(toApex, apex * inverseLeft);
        addLook(next, look.label);
      }
      if (mesh_.twin(right) >= 0 && cross(view.right, toApex) > 0) {
        const Vector2d axis = Vector2d(l.length - l.x, -l.y) * inverseRight;
        View next = view.inFrame(mesh_.twin(right), apex, axis);
        if (cross(view.left, toApex) < 0) next.left = turnedBackBy(toApex, axis);
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
    yieldTo(owner(v), ownersDistance(v));
    for (int g = firstGuest_[v]; g >= 0 && !share.isEmpty(); g = guests_[g].next)
      yieldTo(guests_[g].label, guests_[g].distance);
    return share.isEmpty();
  }

  /// Makes a label that may own something on a side of a face known at the third corner, should it
  /// be out of sight from there; at all guests from number `first`, which is then the one to go on
  /// from. Returns whether there was any.
  ///
  /// An owner is seen by all neighbours, so on such a side the label is a guest at one of the ends.
  bool completeFaces(int& first) {
    const int known = static_cast<int>(guests_.size());
    for (; first < known; ++first) {
      const auto [vertex, label] = std::pair(guests_[first].vertex, guests_[first].label);
      if (!isInScope(vertex)) continue;
      completeFacesAround(vertex, label);
    }
    return static_cast<int>(guests_.size()) > known;
  }

  /// The same in the faces around a vertex of which the label is a guest.
  void completeFacesAround(int vertex, int label) {
    const auto isKnownAt = [&](int v) { return distanceAt(v, label) < kInfinity; };
    const int first = mesh_.outgoing(vertex);
    int h = first;
    bool isAtTip = isKnownAt(mesh_.tip(h));
    do {
      const int back = TriangleMesh::previous(h), tip = mesh_.tip(h), apex = mesh_.tail(back);
      const bool isAtApex = isKnownAt(apex);
      const int side = isAtTip ? h : back;
      const bool isMissing = isAtTip != isAtApex && isInScope(tip, apex) && !isOutdone(side, label);
      if (isMissing) seeOverEnds(side, label);
      isAtTip = isAtApex || isMissing;
      h = mesh_.twin(back);
    } while (h >= 0 && h != first);
  }

  void seeOverEnds(int side, int label) {
    const int tail = mesh_.tail(side), tip = mesh_.tip(side), back = TriangleMesh::previous(side);
    const double overTail = distanceAt(tail, label) + mesh_.length(back);
    const double overTip = distanceAt(tip, label) + mesh_.length(TriangleMesh::next(side));
    const bool isFromTail = overTail <= overTip;
    const int over = isFromTail ? tail : tip;
    seeFromAfar(mesh_.tail(back), label, std::min(overTail, overTip), [&] {
      return viewOverEnd(mesh_, side, isFromTail, distanceAt(over, label),
                         departureAt(over, label));
    });
  }

  // --- The result ---

  /// Hands over what is known at a vertex. Returns whether it is anything else than before.
  bool collect(int v) {
    if (firstGuest_[v] < 0 && owner(v) >= 0 && ownPath_[v] < 0) return collectOwner(v);
    labels_.clear();
    departures_.clear();
    if (owner(v) >= 0) labels_.push_back({owner(v), ownersDistance(v)});
    for (int g = firstGuest_[v]; g >= 0; g = guests_[g].next)
      labels_.push_back({guests_[g].label, guests_[g].distance});
    equalizeTies(labels_);
    for (const LabelledDistance& d : labels_)
      departures_.push_back(d.label == owner(v) && ownPath_[v] < 0 ? Vector2d(0, 0)
                                                                   : departureAt(v, d.label));
    const auto before = field_.at(v);
    const bool isOther = !std::equal(labels_.begin(), labels_.end(), before.begin(), before.end(),
                                     [](const LabelledDistance& a, const LabelledDistance& b) {
                                       return a.label == b.label && a.distance == b.distance;
                                     });
    field_.setLabels(v, labels_, departures_);
    return isOther;
  }

  /// The same where nothing else is known any more.
  bool collectOwner(int v) {
    const LabelledDistance& nearest = field_.nearest(v);
    const Vector2d none(0, 0);
    const auto before = field_.at(v);
    const bool isOther = before.size() != 1 || before[0].label != nearest.label ||
                         before[0].distance != nearest.distance;
    if (isOther) field_.setLabels(v, {&nearest, 1}, {&none, 1});
    return isOther;
  }

  const TriangleMesh& mesh_;
  DgpcField& field_;
  enum class Scope : char { kOutside, kTold, kInside };
  std::vector<Scope> scope_;     ///< per vertex
  IndexSet inScope_;             ///< not of a run everywhere
  IndexSet sources_;             ///< the same, and what is within two edges
  std::vector<int> firstGuest_;  ///< per vertex, -1: none
  std::vector<int> ownPath_;     ///< per vertex, -1: as the owner's view tells
  std::vector<OwnPath> ownPaths_;
  std::vector<Guest> guests_;
  std::vector<View> guestViews_;  ///< apart, for guests are looked for more than at
  std::vector<int> hosts_;        ///< the vertices that have guests
  std::vector<int> farHosts_;     ///< those that were told by others than neighbours, several times
  std::vector<Look> looks_;
  SweepQueue<QueueItem> queue_;
  PathStraightener straightener_;
  std::vector<LabelledDistance> labels_;
  std::vector<Vector2d> departures_;
};

}  // namespace

void continueOverBorders(DgpcField& field) { Continuation(field).runEverywhere(); }

class ContinuationUpdates::Implementation : public Continuation {
 public:
  using Continuation::Continuation;
};

ContinuationUpdates::ContinuationUpdates(DgpcField& field)
    : implementation_(std::make_unique<Implementation>(field)) {}

ContinuationUpdates::~ContinuationUpdates() = default;

LabelChange ContinuationUpdates::run(std::span<const int> changed) {
  return implementation_->runAround(changed);
}

}  // namespace gvd
