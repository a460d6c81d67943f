// SPDX-License-Identifier: MIT
// This work is based on:
// Joseph Mitchell, David Mount, Christos Papadimitriou. The Discrete Geodesic Problem. 1987
#include "distance/exact/window_path.h"

#include <algorithm>

#include "distance/path_points.h"
#include "distance/reached_index.h"
#include "distance/straight_line.h"
#include "mesh/face_layout.h"
#include "mesh/incidence.h"

namespace gvd::exact {
namespace {

using Eigen::Vector2d;

/// A path over a vertex counts as no longer than the straight line beside the vertex if it exceeds
/// it by at most this share: some 200 times the rounding of distances (`kLineDifference`), and
/// still too little to see.
constexpr double kSameLength = 1e-11;
/// How far an unfolded virtual source may be from its vertex, as a share of the way to it. The
/// distances must agree as well (`kSameLength`).
constexpr double kSourceError = 1e-6;

/// The shortest path from a point back to the site of a label (Mitchell et al. 1987, §3.5). No back
/// pointers are kept. Between the vertices at which it turns, the path is a straight line of the
/// unfolded faces towards a known virtual source, followed from face to face.
class WindowPath {
 public:
  /// Begins the path at a point.
  WindowPath(const TriangleMesh& mesh, const SurfacePoint& site, const LabelState& state,
             const IndexMap& index, const SurfacePoint& p);

  /// Offers a window of a face that the point lies in; `place` is the point in that face.
  void offer(const Window& w, int halfedge, const SurfacePoint& place);
  /// The shortest path: through an offered window, over a corner around the point, or straight
  /// within a face. Empty if none leads to the site.
  std::vector<SurfacePoint> take();

 private:
  /// The rest of a straight piece of the path, up to its virtual source.
  struct Piece {
    StraightLine line;
    double sourceDistance;
  };
  /// Where a followed piece ends, other than at a vertex: lost if no corner leads on
  /// (`bestCorner`).
  enum : int { kLost = -1, kAtSite = -2 };

  int follow(Piece piece);
  Piece lastPiece(int vertex) const;
  int sourceAt(const Piece& piece) const;
  bool leadsOn(int vertex, double distance) const;
  /// The corner of the last point's faces over which the path on from there is shortest.
  CornerOnPath nextCorner() const {
    const auto at = [&](int vertex) { return distanceAt(vertex); };
    return bestCorner(mesh_, points_.last(), bound_, at);
  }

  double distanceAt(int vertex) const { return distanceIn(state_.vertices, index_, vertex); }

  const TriangleMesh& mesh_;
  const LabelState& state_;
  PathPoints points_;
  const IndexMap& index_;
  /// The distance at the path's last vertex. The next vertex must be nearer to the site, so the
  /// path ends.
  double bound_ = kInfinity;
  // The best beginning.
  double least_ = kInfinity;
  Piece first_;
};

}  // namespace

// --- The beginning -----------------------------------------------------------------------------

WindowPath::WindowPath(const TriangleMesh& mesh, const SurfacePoint& site, const LabelState& state,
                       const IndexMap& index, const SurfacePoint& p)
    : mesh_(mesh), state_(state), points_(mesh, site), index_(index) {
  points_.add(p);
  least_ = nextCorner().length;
}

void WindowPath::offer(const Window& w, int halfedge, const SurfacePoint& place) {
  const Vector2d p = layOut(mesh_.face(place.face), halfedge % 3, place.bary);
  const double distance = w.distance(p.x(), p.y());
  if (!(distance < least_)) return;
  least_ = distance;
  const double crossing = std::clamp(w.crossing(p.x(), p.y()), w.begin, w.end);
  first_ = {{halfedge, crossing, {w.x, w.y}}, w.sourceDistance};
}

std::vector<SurfacePoint> WindowPath::take() {
  int vertex = vertexAt(mesh_, points_.last());
  if (vertex < 0) {
    if (points_.endAtSite()) return points_.take();
    vertex = first_.line.halfedge >= 0 ? follow(first_) : nextCorner().vertex;
  }
  while (vertex >= 0) {
    points_.add(pointAtVertex(mesh_, vertex));
    if (points_.endAtSite()) return points_.take();
    if (distanceAt(vertex) == kInfinity) return {};
    bound_ = distanceAt(vertex);
    vertex = follow(lastPiece(vertex));
  }
  if (vertex == kLost) return {};
  return points_.take();
}

/// The last piece of the path to a vertex. Its face does not have the site.
WindowPath::Piece WindowPath::lastPiece(int vertex) const {
  const LastPiece& last = state_.pieces[index_[vertex]];
  const TriangleMesh::Face& face = mesh_.face(last.arrival / 3);
  const int i = last.arrival % 3;
  const Vector2d apex = apexOf(face, i);
  const double crossing = std::clamp(apex.x() + last.fromFoot, 0.0, face.lengths[i]);
  const double length = distanceAt(vertex) - last.sourceDistance;
  const Vector2d source = apex + Vector2d(last.fromFoot, -apex.y()).normalized() * length;
  return {{last.arrival, crossing, source}, last.sourceDistance};
}

// --- A straight line ---------------------------------------------------------------------------

/// Adds the points of a line up to the site or up to the vertex at which it ends, and returns that
/// end. A line that misses its source by rounding ends at a vertex beside it.
int WindowPath::follow(Piece piece) {
  StraightLine& line = piece.line;
  for (int crossed = 0; crossed <= mesh_.faceCount(); ++crossed) {
    const std::size_t before = points_.size();
    points_.add(pointOnHalfedge(mesh_, line.halfedge, line.along));
    const int passed = vertexAt(mesh_, points_.last());
    if (passed >= 0 && leadsOn(passed, piece.sourceDistance + line.length())) return passed;
    if (points_.endAtSite()) return kAtSite;
    if (!line.enterFace(mesh_)) {  // the line passes the vertex beyond the boundary
      points_.shrinkTo(before);
      break;
    }
    if (const int source = sourceAt(piece); source >= 0) return source;
    // A site beyond a side may appear in front of the side, if it is as near to it as rounding.
    if (!line.crossFace(mesh_) &&
        !points_.isBesideSite(pointOnHalfedge(mesh_, line.halfedge, line.along)))
      break;
  }
  return nextCorner().vertex;
}

/// The apex of the face that a line has entered, if the line ends there; else -1.
int WindowPath::sourceAt(const Piece& piece) const {
  const StraightLine& line = piece.line;
  const TriangleMesh::Face& face = mesh_.face(line.halfedge / 3);
  const int i = line.halfedge % 3;
  const Vector2d from(line.along, 0), apex = apexOf(face, i);
  if ((line.source - apex).norm() > kSourceError * line.length()) return -1;
  const int vertex = face.vertices[cornerBefore(i)];
  return leadsOn(vertex, piece.sourceDistance + line.length() - (apex - from).norm()) ? vertex : -1;
}

/// Whether the path may go on from a vertex that is so far from the site along the line.
bool WindowPath::leadsOn(int vertex, double distance) const {
  const double known = distanceAt(vertex);
  return known < bound_ && known <= distance + kSameLength * least_;
}

// --- The path of a label -----------------------------------------------------------------------

std::vector<SurfacePoint> pathToSite(const TriangleMesh& mesh, const SurfacePoint& site,
                                     const LabelState& state, const SurfacePoint& p,
                                     IndexMap& index) {
  indexVertices(state.vertices, index);
  WindowPath path(mesh, site, state, index, p);
  if (vertexAt(mesh, p) >= 0) return path.take();
  visitRepresentations(mesh, p, [&](const SurfacePoint& place) {
    for (int i = 0; i < 3; ++i) {
      if (place.bary[cornerBefore(i)] == 0) continue;  // on the side: see the face beyond
      const int halfedge = 3 * place.face + i;
      for (const WaitingWindow& w : state.waiting.windows)
        if (w.halfedge == halfedge) path.offer(w.window, halfedge, place);
    }
  });
  return path.take();
}

}  // namespace gvd::exact
