// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "distance/exact/window.h"
#include "distance/site_set.h"
#include "distance/straight_line.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// What is known of the distances at vertices of the labels that are searched for.
class VertexDistances {
 public:
  virtual ~VertexDistances() = default;
  /// None of the labels is nearer to the vertex than this.
  virtual double atLeast(int vertex) const = 0;
  /// The length of a path of one of the labels to the vertex, infinity if none is known.
  virtual double atMost(int vertex) const = 0;
};

/// The shortest path from a point to a site, as far as it is straight: up to a vertex, from where
/// the path of a label is known, or to the site itself.
struct FirstPiece {
  int vertex = -1;             ///< at which the piece ends, or
  int label = -1;              ///< of the site at which it ends
  double distance = kInfinity; ///< the length of the whole path
  double length = 0;           ///< of the piece
  int halfedge = -1;           ///< by which it leaves the point's face; -1 if it ends there
  double angle = 0;            ///< at which it leaves the point, from the direction of the halfedge
};

/// Finds shortest paths from points, which lie in faces or on edges, back to sites of which the
/// distances at vertices are known. Windows spread from the point. Through any place of an edge the
/// path is as long as the window's distance and that of the site there, and the latter cannot be
/// less than those at the ends of the edge less the way to them (Lipschitz). What is longer than a
/// path that is known is cut off, so that a strip of few faces remains around the shortest path;
/// the windows of the least such length go first. O(n log n) of the n faces that the path crosses,
/// where they are well shaped.
class BackwardSearch {
 public:
  BackwardSearch(const TriangleMesh& mesh, const SiteSet& sites) : mesh_(mesh), sites_(sites) {}

  /// The first pieces of the shortest path from a point and of all that tie with it; `label` -1
  /// stands for all labels. Good until the next call. Empty if no distance is known at the corners
  /// of the point's face.
  const std::vector<FirstPiece>& run(const SurfacePoint& p, int label,
                                     const VertexDistances& known);

 private:
  /// A window that has come to a halfedge.
  struct Item {
    double least;  ///< what a path through the window is long at least
    int first;     ///< the halfedge by which the window has left the point's face
    int halfedge;
    Window window;
  };

  void startIn(const SurfacePoint& place);
  void leave(const SurfacePoint& place);
  void cross(const Item& item);
  void add(Window w, int halfedge, int first);
  void offer(const FirstPiece& piece);

  const TriangleMesh& mesh_;
  const SiteSet& sites_;

  // The search at hand.
  int label_ = -1;
  const VertexDistances* known_ = nullptr;
  double bound_ = kInfinity;      ///< the length of the shortest path so far, and what ties with it
  std::vector<Item> queue_;       ///< a heap
  std::vector<FirstPiece> found_;
};

/// A straight line that leaves the face of a point as a first piece does.
StraightLine lineAlong(const TriangleMesh& mesh, const SurfacePoint& p, const FirstPiece& piece);

}  // namespace gvd::exact
