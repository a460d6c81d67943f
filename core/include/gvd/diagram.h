// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "gvd/geodesic.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// A list of lists of point indices in one array: list i is `points[offset[i]] … points[offset[i+1]
/// - 1]`.
struct PointLists {
  std::vector<int> offset = {0};
  std::vector<int> points;

  int size() const { return static_cast<int>(offset.size()) - 1; }
  std::span<const int> operator[](int i) const {
    return {points.data() + offset[i], points.data() + offset[i + 1]};
  }
  void add(std::span<const int> list) {
    points.insert(points.end(), list.begin(), list.end());
    offset.push_back(static_cast<int>(points.size()));
  }
};

/// The geodesic Voronoi diagram of a mesh (Melvær & Reimers 2014), traced.
///
/// Words: a *bisector segment* is a straight piece of a bisector inside one face; an *arc* a
/// maximal chain of segments of the same two labels between Voronoi points, ends on the mesh
/// boundary, or closed; a *Voronoi point* is equidistant from three or more sites; a *loop* is a
/// closed outline of a region. "Left" is as seen with the faces counterclockwise.
struct Diagram {
  static constexpr int kUnreachable = -1;  ///< label of what no site reaches
  static constexpr int kMixed = -2;        ///< faceLabel of a face with several regions

  int siteCount = 0;

  /// Every point named below, each place once. `face` counts the mesh's faces. Where points have
  /// become one on an edge or a vertex, the coordinates off it are exactly zero. The end of a
  /// segment is named in terms of a face of one of the segments there.
  std::vector<SurfacePoint> points;

  /// A bisector segment, oriented forwards: the lower label `labels[0]` is on its left,
  /// `labels[1]` on its right.
  struct Segment {
    std::array<int, 2> points;
    std::array<int, 2> labels;
    int face;
    int arc;
  };
  std::vector<Segment> segments;

  /// Arcs, oriented as their segments; a closed arc repeats its first point at the end.
  PointLists arcs;
  std::vector<std::array<int, 2>> arcLabels;

  struct VoronoiPoint {
    int point;
    /// Labels around the point, counterclockwise, the lowest first; a label occurs again where its
    /// region comes to the point twice. Their number is the point's degree.
    std::vector<int> labels;
  };
  std::vector<VoronoiPoint> voronoiPoints;

  /// Closed outlines, the region on the left; the first point is not repeated. They run along the
  /// mesh boundary where the region does, through every boundary vertex there. A region that is a
  /// whole closed component has none.
  PointLists loops;
  std::vector<int> loopLabel;  ///< region of each loop, ascending

  std::vector<double> regionArea;  ///< per label; sums to the area that any site reaches

  /// Per mesh face: its label if one region owns all of it (a region triangle), else `kMixed` or
  /// `kUnreachable`. A face of one region beside bisectors that meet on its side is mixed as well:
  /// its only cell has their meeting as a corner.
  std::vector<int> faceLabel;
  /// Region triangles that two or more labels tie on; given to the lowest of them. They lie behind
  /// saddles and corners of the boundary at which the labels tie. Sites in one place tie on all of
  /// their region.
  std::vector<int> indifferentFaces;

  /// The parts of mixed faces: convex polygons, counterclockwise, ascending by face. A point on the
  /// outline of several cells is a corner of all of them, so angles may be straight; region
  /// triangles alone do not name the points that a neighbour of more detail has on their sides.
  PointLists cells;
  std::vector<int> cellFace;
  std::vector<int> cellLabel;
};

struct DiagramOptions {
  /// How many times a mixed face is split in four, distances evaluated anew at the new corners:
  /// the bisectors converge to the true curves. 0: one straight segment per face and bisector.
  int detail = 0;
};

/// The diagram of the distances of `siteCount` sites. The same input gives the same diagram to the
/// last bit; permuting the sites permutes the labels. O(F + M log M), M the number of points.
Diagram traceDiagram(const TriangleMesh& mesh, const DistanceField& distances, int siteCount,
                     const DiagramOptions& options = {});

/// The same in slices, so that a caller keeps responding and can give up.
class DiagramTracing {
 public:
  /// The mesh and the distances must outlive this.
  DiagramTracing(const TriangleMesh& mesh, const DistanceField& distances, int siteCount,
                 const DiagramOptions& options = {});
  ~DiagramTracing();
  DiagramTracing(DiagramTracing&&) noexcept;
  DiagramTracing& operator=(DiagramTracing&&) noexcept;

  /// Does work for at most `budget` mixed faces, a microsecond or less each, or as much of another
  /// kind; true when everything is done. What is not parted: one face, with all the sites in it;
  /// one loop.
  bool step(long budget);
  /// The result; call once, after `step` returned true.
  Diagram take();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace gvd
