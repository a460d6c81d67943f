// SPDX-License-Identifier: MIT
/// \file
/// The surface that everything is computed on: a triangle mesh, repaired to a manifold.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gvd/sliced_work.h"
#include "gvd/surface_point.h"

namespace gvd {

/// Whether triangles may be turned over, so that neighbours agree on the order of their corners.
enum class Orientation {
  kUnify,  ///< triangles that disagree with the majority of their component are turned over
  kKeep,   ///< no triangle is turned over; edges whose two triangles disagree are cut
};

/// Options for the repairs that are described at `TriangleMesh`.
struct MeshOptions {
  /// The largest distance at which vertices are welded and T-junctions joined, as a share of the
  /// bounding box's diagonal, from 0 to 1. Below the rounding of coordinates (2^-52), only vertices
  /// at bit-equal positions are welded, and no T-junctions joined.
  double weld = 0;
  Orientation orientation = Orientation::kUnify;
  /// Components with fewer triangles than this are dropped; not negative.
  int minComponent = 0;
};

/// The repairs that made the input a manifold without flat triangles, as described at
/// `TriangleMesh`. All counts are zero for a clean mesh. They are complete:
///
///     input triangles + joined vertices = faces + non-finite + degenerate + duplicate
///                                         + small component
///     input vertices = vertices - split + welded + isolated
struct MeshRepairs {
  int weldedVertices = 0;       ///< input vertices merged into an earlier one at their place
  int joinedVertices = 0;       ///< joined to an edge they lie within, each by a flat triangle
  int isolatedVertices = 0;     ///< input vertices at whose position no kept triangle has a corner
  int nonFiniteTriangles = 0;   ///< dropped: a corner is NaN or infinite
  int degenerateTriangles = 0;  ///< dropped: two corners at one position
  int duplicateTriangles = 0;   ///< dropped: same three corners as an earlier triangle, either side
  int nonManifoldEdges = 0;     ///< of three or more triangles: components are cut apart there
  int orientationCuts = 0;   ///< edges cut because no orientation fits both sides (Möbius strip)
  int flippedTriangles = 0;  ///< turned over to agree with the majority of their component
  int smallComponents = 0;   ///< dropped: fewer triangles than `MeshOptions::minComponent`
  int smallComponentTriangles = 0;  ///< the triangles of those components
  int splitVertices = 0;       ///< copies made of vertices of several fans: one per further fan
  int mollifiedTriangles = 0;  ///< flat or tiny, the reason why all edges were lengthened
  double mollification = 0;    ///< the length added to every edge, in the positions' unit
};

/// Facts of topology, computed once with the mesh.
struct MeshTopology {
  int edges = 0;
  int components = 0;
  int boundaryLoops = 0;
  int eulerCharacteristic = 0;  ///< V - E + F
  /// Sum of the genera of all components: (2·components - boundaryLoops - eulerCharacteristic) / 2.
  int genus = 0;
  /// Whether boundary vertices nearly coincide: within 1e-6 of the bounding diagonal, not joined by
  /// an edge. Mostly rounding has made two of one, and `MeshOptions::weld` joins them, so that
  /// paths lead across. Looked for at 4096 boundary vertices at most, evenly spaced.
  bool hasOpenSeams = false;
  /// Whether boundary vertices lie within boundary edges (T-junctions, as programs that cut solids
  /// often leave): within 1e-6 of the bounding diagonal, farther from the edge's ends. No path
  /// leads across, unless `MeshOptions::weld` joins them. Looked for at all boundary vertices if
  /// there are 2048 at most; of more, at fewer, evenly spaced.
  bool hasTJunctions = false;
};

/// An oriented 2-manifold triangle mesh, with or without boundary, of one or several components:
/// flat arrays, immutable.
///
/// Halfedge h is side h % 3 of face h / 3 and runs from corner h % 3 to the next corner, so the
/// halfedges of the face (a, b, c) with index f are
///
///     3f: a→b      3f+1: b→c      3f+2: c→a
///
/// and corner i of face f is the tail of halfedge 3f+i. `twin` is the halfedge of the neighbour
/// face that runs the other way, -1 on the boundary.
///
/// From any list of triangles to a manifold, in this order, each step counted in `repairs()`:
///  1. triangles with a non-finite corner are dropped;
///  2. vertices at bit-equal positions (-0 = +0) are welded. With a tolerance (`weld`), vertices
///     are taken in input order, and each is welded into the first vertex kept so far within the
///     tolerance; kept vertices are farther apart than that;
///  3. triangles with two equal corners are dropped, which loses an edge or a vertex at most.
///     Triangles with the same three corners as an earlier one, in either orientation, are dropped,
///     too. Triangles of zero area with three distinct corners stay, because dropping one would
///     tear its neighbours apart;
///  4. with a tolerance (`weld`), T-junctions are joined: boundary vertices within a boundary edge
///     of a triangle that they are no corners of, each to the nearest edge within the tolerance.
///     One flat triangle per vertex fills the room between the edge and the vertices along it, so
///     the triangles of the input stay as they are;
///  5. an edge of three or more triangles is cut: each gets a boundary there;
///  6. each component is oriented like the majority of its triangles (on a draw, like the first);
///     an edge whose triangles cannot agree (non-orientable surface) is cut. With
///     `Orientation::kKeep` no triangle is turned over, and every edge whose triangles disagree is
///     cut;
///  7. where an edge was cut in step 5, triangles are joined again: cutting and stitching (Guéziec
///     et al. 2001, "Cutting and Stitching: Converting Sets of Polygons to Manifold Surfaces").
///     First the triangles of a component, if there are just two and they agree in orientation: so
///     solids that touch along an edge stay closed, and a surface with a fin on it stays whole.
///     Then the others, each with the next one across the inside of a solid, if insides and
///     outsides, by their orientations, alternate around the edge: so solids stay closed that touch
///     in faces which both divide into triangles, but not into the same ones;
///  8. components of fewer than `minComponent` triangles are dropped;
///  9. a vertex whose triangles form several fans is split, one vertex per fan: no path passes
///     through it;
/// 10. if a triangle is flat (two sides hardly longer than the third) or tiny, all edges are
///     lengthened by one amount, the least for which in every triangle two sides exceed the third
///     by 1e-11 of the mean edge, or of the triangle's longest side where that is longer: intrinsic
///     mollification (Sharp & Crane 2020, "A Laplacian for Nonmanifold Triangle Meshes", section
///     4.5). So no face is degenerate, and computations on the mesh need no tolerance for such
///     faces.
///
/// Lengths, angles and areas are those of the *intrinsic* surface, which is made of triangles with
/// these edge lengths. They are the positions' own, to the last bits, unless step 10 was needed:
/// then each edge is longer by at most 1e-11 of the longest, and no distance is shorter. But a flat
/// triangle whose longest side is a mean edge gets a height of about 2e-6 of that side (the square
/// root of half the margin), and distances across it grow by that height. Positions are never
/// moved, except that a welded vertex takes the position of the vertex it was welded into.
///
/// Faces and vertices keep the order of the input; copies of split vertices come last, and so do
/// the faces that join T-junctions. A clean mesh keeps all its indices. Where an edge was cut, two
/// boundary edges may have the same two ends.
class TriangleMesh {
 public:
  /// `positions`: x, y, z per vertex, any unit. `triangles`: three vertex indices each. Throws
  /// `Error(kInvalidMesh)` if an array's size is no multiple of three or more than 2^31 - 1, an
  /// index is out of range, or no triangle is left after the repairs; `Error(kInvalidArgument)` if
  /// an option is not in its range; `Error(kInvalidMesh)` also if the bounding diagonal is longer
  /// than 2^200 (1.6e60) or the mean edge shorter than 2^-200 (6e-61): between these limits, which
  /// all numbers of single precision keep, no product of four lengths overflows or underflows. The
  /// mesh may be anywhere relative to the origin. O(n log n).
  TriangleMesh(std::span<const double> positions, std::span<const int> triangles,
               const MeshOptions& options = {});

  int vertexCount() const { return static_cast<int>(inputVertex_.size()); }
  int faceCount() const { return static_cast<int>(faces_.size()); }
  int halfedgeCount() const { return 3 * faceCount(); }

  static int faceOf(int h) { return h / 3; }
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  int tail(int h) const { return face(faceOf(h)).vertices[index(h % 3)]; }
  int tip(int h) const { return face(faceOf(h)).vertices[index(cornerAfter(h % 3))]; }
  int twin(int h) const { return face(faceOf(h)).twins[index(h % 3)]; }
  /// Positive, and the same bits for both halfedges of an edge.
  double length(int h) const { return face(faceOf(h)).lengths[index(h % 3)]; }

  /// The data of a face, in two cache lines: what walks along edges need is in the first. Side i is
  /// halfedge 3f+i, from corner i to the next.
  struct alignas(64) Face {
    std::array<double, 3> lengths;  ///< of side i
    std::array<int, 3> vertices;    ///< at corner i: `tail(3f+i)`
    std::array<int, 3> twins;       ///< of side i: `twin(3f+i)`
    double area;                    ///< positive
    std::array<double, 3> cosines;  ///< of the interior angle at corner i
    std::array<double, 3> sines;    ///< positive, to full relative precision
    std::array<double, 3> angles;   ///< in (0, π)
  };
  const Face& face(int f) const { return faces_[index(f)]; }

  /// For each boundary loop, the halfedge that leaves its lowest vertex; `outgoing(tip(h))` is the
  /// next halfedge of the loop.
  std::span<const int> boundaryLoops() const { return boundaryLoops_; }
  bool onBoundary(int v) const { return twin(outgoing(v)) < 0; }

  /// The halfedges that leave v, counterclockwise: one per face around it. On a boundary vertex the
  /// first is the one without twin.
  std::span<const int> fan(int v) const {
    return {fanHalfedges_.data() + fanBegin_[index(v)],
            fanHalfedges_.data() + fanBegin_[index(v + 1)]};
  }
  /// The first halfedge of the fan.
  int outgoing(int v) const { return fan(v).front(); }
  /// The next outgoing halfedge counterclockwise, -1 past the last face of a boundary vertex.
  int rotate(int h) const { return twin(previous(h)); }

  /// Calls `visit` with every vertex that shares an edge with v, and the length of the edge. Once
  /// per edge: where one was cut, both of its copies may end at the same two vertices.
  template <class Visit>
  void visitEdges(int v, Visit visit) const {
    for (const int h : fan(v)) visit(tip(h), length(h));
    if (!onBoundary(v)) return;
    const int last = previous(fan(v).back());
    visit(tail(last), length(last));
  }

  /// Calls `visit` with every vertex that shares an edge with v, once per edge.
  template <class Visit>
  void visitNeighbours(int v, Visit visit) const {
    visitEdges(v, [&](int neighbour, double) { visit(neighbour); });
  }

  /// Calls `visit` with every face around v.
  template <class Visit>
  void visitFaces(int v, Visit visit) const {
    for (const int h : fan(v)) visit(faceOf(h));
  }

  /// In the frame of the input's positions.
  Eigen::Vector3d position(int v) const { return Eigen::Vector3d::Map(&positions_[3 * index(v)]); }
  /// The point on the flat face between the positions of its corners.
  Eigen::Vector3d position(const SurfacePoint& p) const;
  /// The interior angle at corner h % 3 of face h / 3, in (0, π).
  double cornerAngle(int h) const { return face(faceOf(h)).angles[index(h % 3)]; }
  /// The sum of the corner angles at v: > 2π at an inner saddle vertex.
  double angleSum(int v) const { return angleSum_[index(v)]; }
  /// Positive, of the intrinsic triangle.
  double faceArea(int f) const { return face(f).area; }
  /// The sum of all `faceArea`.
  double area() const { return area_; }
  /// The length of the longest edge at v.
  double longestEdge(int v) const { return longestEdge_[index(v)]; }
  /// The length of the longest edge of all.
  double longestEdge() const { return longestOfAll_; }
  /// The faces, ascending, whose shortest side is below 1e-5 of the longest: few or none.
  std::span<const int> needles() const { return needles_; }
  /// The mean of `length` over all halfedges: an inner edge counts twice.
  double meanEdgeLength() const { return meanEdgeLength_; }
  /// For the width of the buckets that distances are sorted into: about the lower quartile of edge
  /// lengths, estimated from a sample. Not less than 1/256 of the mean, nor than 6/2^30 of all
  /// sides of faces together, so that no distance needs more than 2^30 buckets.
  double shortEdgeLength() const { return shortEdgeLength_; }
  /// The component of a face, numbered from 0 in order of the first face.
  int component(int f) const { return component_[index(f)]; }
  /// The length of the bounding box's diagonal, of positions.
  double boundingDiagonal() const { return boundingDiagonal_; }

  /// The input triangle a face was made from, or along whose side it joins a T-junction; and
  /// whether it was turned over (corners 1 and 2 swapped).
  int inputFace(int f) const {
    const int input = inputFace_[index(f)];
    return isJoining(f) ? joining_[index(input - inputFaceCount_)].triangle : input;
  }
  bool isFlipped(int f) const { return flipped_[index(f)]; }
  /// Whether a face joins a T-junction and is no triangle of the input.
  bool isJoining(int f) const { return inputFace_[index(f)] >= inputFaceCount_; }
  /// The first input vertex at the place of v.
  int inputVertex(int v) const { return inputVertex_[index(v)]; }
  int inputFaceCount() const { return inputFaceCount_; }
  int inputVertexCount() const { return static_cast<int>(vertexOfInput_.size()); }

  /// A sentence that says why a point is not on this mesh; empty if it is. Barycentric coordinates
  /// may be off by 1e-6: functions that take sites or points clamp and normalise them, and throw
  /// `Error(kInvalidPoint)` with this text if they are off by more.
  std::string faultOfPoint(const SurfacePoint& p) const;

  /// A point of this mesh in terms of the input's triangles; face -1 stays -1. A point on a face
  /// that joins a T-junction is given on the side that the face continues. O(1).
  SurfacePoint toInput(const SurfacePoint& p) const;
  /// A point given by an input triangle, in terms of this mesh. A point on a dropped triangle is
  /// found on a kept one that has all of its corners. Barycentric coordinates may be off by up to
  /// 1e-6 (they are clamped and normalised); throws `Error(kInvalidPoint)` naming the fault if they
  /// are off by more or not finite, if the triangle does not exist, or if it was dropped and no
  /// kept one has its corners. O(log F).
  SurfacePoint fromInput(const SurfacePoint& p) const;
  /// The place of an input vertex; throws `Error(kInvalidPoint)` if the vertex does not exist or is
  /// isolated. For a split vertex, its copy in the first triangle that names the input vertex.
  /// O(1).
  SurfacePoint fromInputVertex(int inputVertex) const;
  /// The vertex at that place, -1 if the input vertex is isolated. The input vertex exists.
  int vertexOfInput(int inputVertex) const {
    const int h = vertexOfInput_[index(inputVertex)];
    return h < 0 ? -1 : tail(h);
  }

  const MeshRepairs& repairs() const { return repairs_; }
  const MeshTopology& topology() const { return topology_; }

 private:
  friend class InputMap;
  friend class MeshBuilding;
  friend class MeshMeasuring;
  TriangleMesh() = default;
  /// An index in the type of the containers of the standard library.
  static constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }
  std::array<int, 3> halfedgesOfInput(int triangle) const;

  /// Where a face that joins a T-junction is in the input: the columns are the barycentric
  /// coordinates of its corners.
  struct Joining {
    int triangle;
    Eigen::Matrix3d corners;
  };

  std::vector<double> positions_;
  std::vector<Face> faces_;
  std::vector<int> fanBegin_, fanHalfedges_;  ///< fan after fan, and where each begins
  std::vector<double> angleSum_, longestEdge_;
  std::vector<int> needles_;
  double area_ = 0, boundingDiagonal_ = 0;
  double longestOfAll_ = 0, meanEdgeLength_ = 0, shortEdgeLength_ = 0;
  std::vector<int> component_;
  std::vector<int> boundaryLoops_;
  /// `inputFace_` is ascending. From `inputFaceCount_` on, it counts the entries of `joining_`.
  std::vector<int> inputFace_, inputVertex_;
  std::vector<Joining> joining_;
  std::vector<char> flipped_;
  int inputFaceCount_ = 0;
  /// The dropped triangles of the input, ascending: a face that has the places of their corners, or
  /// -1, and the corners that these places are, two bits each.
  std::vector<int> droppedFace_;
  std::vector<std::uint8_t> droppedCorners_;
  std::vector<int> vertexOfInput_;  ///< a halfedge leaving the vertex's place, or -1
  MeshRepairs repairs_;
  MeshTopology topology_;
};

/// The same mesh in steps; throws as its constructor does, at once or in a step. It needs less
/// memory: positions become those of the mesh in place.
std::unique_ptr<SlicedWork<TriangleMesh>> startMesh(std::vector<double> positions,
                                                    std::vector<int> triangles,
                                                    const MeshOptions& options = {});

}  // namespace gvd
