// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd::exact {

/// A face laid out for unfolding. Side i runs from corner i to the next one. A halfedge has
/// coordinates: the origin is its tail, the x axis runs along it, its face lies at y >= 0.
struct alignas(128) Frame {
  double length[3];
  double cosine[3], sine[3];  ///< of the angle at corner i
  int vertex[3];
  int twin[3];
  int firstWindow[3];  ///< list of the windows on side i, -1 if empty
  int firstSite;       ///< list of the sites in the face or on its sides
  int label;           ///< of all windows and sites here; kNoLabel, kSeveralLabels

  static constexpr int kNoLabel = -1;
  static constexpr int kSeveralLabels = -2;

  void add(int newLabel) {
    if (label != newLabel) label = label == kNoLabel ? newLabel : kSeveralLabels;
  }
  double longestSide() const { return std::max({length[0], length[1], length[2]}); }
  /// The corner across from side i, in the coordinates of that side.
  double apexX(int i) const { return length[before(i)] * cosine[i]; }
  double apexY(int i) const { return length[before(i)] * sine[i]; }

  static constexpr int after(int i) { return i == 2 ? 0 : i + 1; }
  static constexpr int before(int i) { return i == 0 ? 2 : i - 1; }
};

/// Of all faces, without windows and sites.
std::vector<Frame> layOutFaces(const TriangleMesh& mesh);

/// A point of a face in the coordinates of its side i; linear, so of differences of points too.
inline Eigen::Vector2d layOut(const Frame& frame, int i, const Eigen::Vector3d& bary) {
  const double toTip = bary[Frame::after(i)], toApex = bary[Frame::before(i)];
  return {toTip * frame.length[i] + toApex * frame.apexX(i), toApex * frame.apexY(i)};
}

/// A site in a face or on its sides.
struct FaceSite {
  int label;
  Eigen::Vector3d bary;
  int next;  ///< in the list of its face, -1 at the end
};

/// Where a point lies: the corner or side it is on, if any.
struct Place {
  int corner = -1;
  int side = -1;
};
Place placeOf(const Eigen::Vector3d& bary);

/// The same point of an edge, seen from the face on the other side.
SurfacePoint acrossEdge(const TriangleMesh& mesh, const SurfacePoint& p, int h);

}  // namespace gvd::exact
