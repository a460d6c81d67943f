// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "dgpc/fan.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// A path that is shorter than all paths close to it.
struct LocalGeodesic {
  double length;
  Eigen::Vector2d departure;  ///< at its end, as `DistanceField::direction` gives it
  bool bends = false;         ///< at vertices on the way
};

/// A sequence of faces, each of them entered through an edge of the one before.
class FaceStrip {
 public:
  explicit FaceStrip(const TriangleMesh& mesh) : mesh_(mesh) {}

  /// Begins anew with a face, and goes on through some halfedges.
  void start(int face, std::span<const int> through = {});
  /// Goes on through a halfedge of the last face, to the face across. Going back takes away a face.
  void goThrough(int halfedge);
  /// Goes on around a vertex of the last face to another face there, over the fewest edges. False
  /// if the vertex's faces do not hang together.
  bool turn(int vertex, int face);
  int lastFace() const { return lastFace_; }

  /// The path from a vertex of the first face to a point of the last face that follows from the
  /// shortest one in the strip by leading the strip around the other side of every vertex at which
  /// the path may be cut short there, as long as there are any (Xin & Wang 2007). The strip is then
  /// that of the path, and may end in another face at the point. Nothing if that does not end soon.
  /// O(faces) every time.
  std::optional<LocalGeodesic> straighten(int vertex, const SurfacePoint& end);

  // Of such a path:

  /// A part of it that does not bend.
  struct Piece {
    int vertex;                    ///< where it begins: the path's, or one where it bends
    int firstFace;                 ///< a face of that one
    std::span<const int> crossed;  ///< the halfedges of the faces that are left through them
    double length;
    /// Where it leaves a vertex at which the path bends, counterclockwise from the first halfedge
    /// there.
    double angle;
  };
  /// All of them, in order; until the strip changes.
  const std::vector<Piece>& pieces();
  /// Where it comes to an end that is a vertex, as angles of pieces are told.
  double angleAtEnd() const;

 private:
  /// An edge that the strip crosses, unfolded; left and right as seen on the way.
  struct Gate {
    Eigen::Vector2d left, right;
  };
  struct Bend {
    Eigen::Vector2d place;
    int vertex;
    size_t gate;  ///< one that has the vertex as an end
    Side side;    ///< where the vertex is
  };

  Eigen::Vector2d placeAt(size_t gate, Side side) const {
    return side == Side::kLeft ? gates_[gate].left : gates_[gate].right;
  }
  int endAt(size_t gate, Side side) const {
    return side == Side::kLeft ? mesh_.tip(crossed_[gate]) : mesh_.tail(crossed_[gate]);
  }
  bool isEnd(int halfedge, int vertex) const {
    return mesh_.tail(halfedge) == vertex || mesh_.tip(halfedge) == vertex;
  }
  /// The first or the last gate that has a bend's vertex as an end.
  size_t firstGate(const Bend& bend) const;
  size_t lastGate(const Bend& bend) const;
  double angleBehind(const Bend& bend, const Eigen::Vector2d& direction) const;
  void trim(int vertex, int endVertex);
  LocalGeodesic acrossOneFace(int vertex, int endVertex, const SurfacePoint& end) const;
  void unfold(int endVertex, const SurfacePoint& end);
  void pullTight();
  bool mayFlip(size_t bend) const;
  bool flip(const Bend& bend);
  LocalGeodesic path(const SurfacePoint& end);

  const TriangleMesh& mesh_;
  int lastFace_ = -1;
  std::vector<int> crossed_;  ///< the halfedges of the faces that are left through them

  // While it is straightened:
  int vertex_ = -1, endVertex_ = -1;
  Eigen::Vector2d start_, end_;
  std::vector<Gate> gates_;
  std::vector<Bend> bends_;
  std::vector<int> detour_, rest_;
  double length_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace gvd
