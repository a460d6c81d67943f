// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "dgpc/dgpc_field.h"
#include "dgpc/face_strip.h"

namespace gvd {

/// Turns the paths by which vertices see sites into geodesics. Views err: a line of sight may leave
/// the faces it was unfolded through, and where views end, paths bend whether or not they have to.
///
/// Most paths that bend may as well be straight, and to find that out takes little: that is tried
/// first. Else, a vertex's geodesic hardly differs from that of the neighbour over which the site
/// is nearest: it is led through the faces of that one and pulled tight there.
class PathStraightener {
 public:
  explicit PathStraightener(const DgpcField& field)
      : field_(field),
        mesh_(field.mesh()),
        strip_(field.mesh()),
        wayOf_(mesh_.vertexCount(), kNotFound) {}

  /// The geodesic that is found near the path by which a vertex sees the site of a label: a
  /// straight line to the site or, should that be none or longer than the view's path, what follows
  /// from that of a neighbour, the shorter. The result depends on the views of the label's own
  /// vertices, on this one and the mesh only. Nothing if neither is found. O(faces on the way), a
  /// few times; that for each neighbour on the way, too, unless the label was the same before.
  std::optional<LocalGeodesic> straighten(int label, int vertex, const View& view);
  /// To be told when the field has changed.
  void forget();

  /// The vertex where the path of a view to a site bends last, or the site's; negative if that is
  /// in a face. Nothing if the line from the view's vertex does not lead there. O(faces on the
  /// way).
  std::optional<int> lookBack(const View& view, const SurfacePoint& site);

 private:
  /// A geodesic from a vertex to the site: a piece that does not bend, and another way from where
  /// that ends. So ways that bend at one vertex have in common what follows.
  struct Way {
    LocalGeodesic path;
    int vertex;
    double angle;       ///< where another way goes on with it (FaceStrip::Piece)
    int firstFace;      ///< of the piece
    size_t begin, end;  ///< in crossed_, the halfedges that the piece crosses
    int next;           ///< -1: the piece ends at the site
    /// Where no halfedges are kept: the straight line to the site, in the frame of the face's
    /// halfedge that has the vertex as its apex; zero if it stays in the face.
    Eigen::Vector2d line;
  };
  static constexpr int kNone = -1;  ///< no way
  static constexpr int kNotFound = -2;

  const SurfacePoint& goal() const { return field_.sites()[label_]; }
  int wayFrom(int vertex);
  int findAhead(int vertex, const View& view);
  int findNear(int vertex, const View& view, int ahead);
  bool isNoLonger(int way, const View& view) const;
  bool isInFace(const SurfacePoint& site, int halfedge) const;
  int aim(int vertex, int halfedge, Eigen::Vector2d line);
  int followNeighbour(int vertex);
  int followView(int vertex, const View& view);
  int pullTight(int vertex, int along);
  bool isTight(int bend, double angle) const;
  bool goAlong(int way);
  auto isAt(const SurfacePoint& site) const;
  int keepStraight(int vertex, const LocalGeodesic& path, int face, const Eigen::Vector2d& line);
  int keepPieces(const LocalGeodesic& path, int next);
  int stepToOwner(int vertex) const;
  int otherEnd(int halfedge, int vertex) const;
  SurfacePoint pointAt(int vertex) const;

  const DgpcField& field_;
  const TriangleMesh& mesh_;
  FaceStrip strip_;
  std::vector<int> walkedThrough_;  ///< halfedges

  // Of the vertices that the label asked for last owns, as far as they have been needed:
  int label_ = -1;
  std::vector<int> wayOf_;  ///< per vertex
  std::vector<int> found_;  ///< the vertices of which it has been looked for
  std::vector<Way> ways_;
  std::vector<int> crossed_;
};

}  // namespace gvd
