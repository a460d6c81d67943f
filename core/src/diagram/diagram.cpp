// SPDX-License-Identifier: MIT
// This work is based on:
// Eivind Lyche Melvær, Martin Reimers. Approximating Geodesic Voronoi Diagrams on Triangulated
// Surfaces. 2014
#include "gvd/diagram.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "base/tolerances.h"
#include "diagram/face_complex.h"
#include "diagram/face_envelope.h"
#include "diagram/trace_faces.h"
#include "distance/common_labels.h"
#include "mesh/surface_geometry.h"

namespace gvd {
namespace {

/// Traces a diagram in two stages.
///
/// First exactly: in every element of several regions the lower envelope, all ties broken, so that
/// the bisector segments form a graph where three segments meet at every inner vertex and two at
/// every crossing of an element's side. Seen from a region, every segment is a *dart* that has the
/// region on its left, each point has at most one dart of a region leaving it, and following darts
/// (and the mesh boundary in between) closes the region's loops without a choice to make.
///
/// Then as doubles see it: points whose error bounds overlap become one. That yields the Voronoi
/// points of higher degree, those on edges and vertices, and bisectors along edges; outlines lose
/// what has shrunk to nothing.
class Tracer {
 public:
  /// Traces the outlines of the labels that `isTraced` says, of all if it is empty. `pointOfNode`
  /// has -1 for every node, and is so left.
  Tracer(const TriangleMesh& mesh, const DistanceField& distances, const FaceComplex& complex,
         int siteCount, std::span<const char> isTraced, std::span<int> pointOfNode)
      : mesh_(mesh),
        distances_(distances),
        complex_(complex),
        isTraced_(isTraced),
        tail_(complex.tails()),
        twin_(complex.twins()),
        pointOfNode_(pointOfNode) {
    out_.siteCount = siteCount;
    out_.regionArea.assign(siteCount, 0.0);
    out_.faceLabel.assign(complex.faceCount(), Diagram::kMixed);
  }

  TracedDiagram trace() {
    collectMixed();
    reserve();
    divideAll();
    collectBoundary();
    traceLoops();
    outIndex_.assign(points_.size(), -1);
    out_.points.reserve(points_.size());
    collectSegments();
    collectArcs();
    collectVoronoiPoints();
    collectLoops();
    collectCells();
    for (const int node : nodesWithPoint_) pointOfNode_[node] = -1;
    return {std::move(out_), std::move(mergedFaces_), complex_.completedFaces()};
  }

 private:
  /// A point of the exact graph, or a node that the mesh boundary or a cell passes.
  struct Point {
    double error;               ///< bound on how far rounding has moved it
    std::array<int, 3> labels;  ///< of the regions that meet here, -1 for none
    std::array<int, 3> darts;   ///< of each, the dart that came or left here first, -1 for none
    int nextOnSide;             ///< list of the points on one side of elements
  };
  struct Segment {
    std::array<int, 2> points;
    std::array<int, 2> labels;  ///< left (the lower), right
    int face;
  };
  /// What there is to know of the sides of an element.
  struct Sides {
    std::array<double, 3> squaredLength;  ///< of the face's
    std::array<int, 3> index;             ///< in firstOnSide_
  };
  /// A vertex of the envelope at hand.
  struct Corner {
    int point = -1;
    Eigen::Vector3d bary;  ///< in terms of the face
  };
  struct Cell {
    int face, label;
    int first, count;  ///< in cellPoints_
  };
  /// A point on the mesh boundary, between the regions that own what is before and after it going
  /// forward; `start` is where its element's part of the halfedge begins.
  struct BoundaryPoint {
    int halfedge;
    double start;  ///< 0 … 1 along the halfedge, exact
    int point;
    int before, after;
  };
  /// A step of a loop between final points (`root`), in a ring of steps: across a face, or along a
  /// side of it that is on the mesh boundary.
  struct Step {
    int label, from, face;
    int previous, next;
    bool isOnBoundary, isGone;
  };
  struct BoundaryStep {
    int label, from, to, face;
  };
  /// A loop as doubles see it.
  struct Outline {
    int label;
    int first, count;  ///< in outlinePoints_
  };

  // --- The exact graph -------------------------------------------------------------------------

  /// The sides of the elements of several regions, those that two have in common counted once.
  void collectMixed() {
    std::vector<int> indexOf(complex_.elementCount(), -1);
    mixedSides_.reserve(complex_.contested().size());
    int sideCount = 0;
    for (const int e : complex_.contested()) {
      if (complex_.soleOwner(e) != Diagram::kMixed) continue;
      Sides sides{squaredSides(mesh_, complex_.face(e)), {}};
      for (int i = 0; i < 3; ++i) {
        const int twin = twin_[3 * e + i], neighbour = twin < 0 ? -1 : indexOf[twin / 3];
        sides.index[i] = neighbour < 0 ? sideCount++ : mixedSides_[neighbour].index[twin % 3];
      }
      indexOf[e] = static_cast<int>(mixedSides_.size());
      mixedSides_.push_back(sides);
    }
    firstOnSide_.assign(sideCount, -1);
  }

  /// Room for what the elements of several regions usually need.
  void reserve() {
    const size_t mixed = mixedSides_.size();
    points_.reserve(5 * mixed / 2);
    place_.reserve(5 * mixed / 2);
    parent_.reserve(5 * mixed / 2);
    isNode_.reserve(5 * mixed / 2);
    segments_.reserve(5 * mixed / 4);
    nextDart_.reserve(5 * mixed / 2);
    cells_.reserve(5 * mixed / 2);
    cellPoints_.reserve(8 * mixed);
  }

  /// In order, so that areas are always summed in the same one.
  void divideAll() {
    int next = 0;
    auto sides = mixedSides_.begin();
    for (const int contested : complex_.contested()) {
      for (; next < contested; ++next) give(next, complex_.owner(tail_[3 * next]));
      const int owner = complex_.soleOwner(next);
      if (owner == Diagram::kMixed) {
        divide(next, owner, *sides++);
      } else {
        give(next, owner);
        if (owner >= 0 && complex_.isWhole(next) && isIndifferent(next, owner))
          out_.indifferentFaces.push_back(complex_.face(next));
      }
      ++next;
    }
    for (; next < complex_.elementCount(); ++next) give(next, complex_.owner(tail_[3 * next]));
  }

  /// Gives all of an element to one label, or to none.
  void give(int element, int owner) {
    const int face = complex_.face(element);
    if (!complex_.isWhole(element)) return divide(element, owner, {squaredSides(mesh_, face), {}});
    out_.faceLabel[complex_.faceIndex(face)] = owner;
    if (owner >= 0) out_.regionArea[owner] += mesh_.faceArea(face);
  }

  void divide(int element, int soleOwner, const Sides& sides) {
    gatherFunctions(element, soleOwner);
    envelope_.compute(functions_);
    addCells(element, sides);
  }

  /// Whether some other label ties with the owner at all three nodes.
  bool isIndifferent(int element, int owner) const {
    for (int i = 0; i < 3; ++i)
      if (!complex_.hasTie(tail_[3 * element + i])) return false;
    const auto ties = [&](int corner, int label) {
      const auto labels = complex_.labels(tail_[3 * element + corner]);
      double ours = kInfinity, theirs = -1;
      for (const LabelledDistance& d : labels) {
        if (d.label == owner) ours = d.distance;
        if (d.label == label) theirs = d.distance;
      }
      return ours == theirs;
    };
    for (const LabelledDistance& d : complex_.labels(tail_[3 * element]))
      if (d.label != owner && ties(0, d.label) && ties(1, d.label) && ties(2, d.label)) return true;
    return false;
  }

  /// The labels known at all three nodes of an element, without those that one owner of a node
  /// hides everywhere.
  void gatherFunctions(int element, int soleOwner) {
    const int* const node = &tail_[3 * element];
    functions_.clear();
    visitCommonLabels(complex_.labels(node[0]), complex_.labels(node[1]), complex_.labels(node[2]),
                      [&](int label, const std::array<double, 3>& d) {
                        if (soleOwner < 0 || label == soleOwner)
                          functions_.push_back({label, {d[0] * d[0], d[1] * d[1], d[2] * d[2]}});
                      });
    if (functions_.size() <= 3) return;
    std::array<const LabelFunction*, 3> owners;
    for (int i = 0; i < 3; ++i)
      owners[i] = &*std::find_if(functions_.begin(), functions_.end(), [&](const LabelFunction& f) {
        return f.label == complex_.owner(tail_[3 * element + i]);
      });
    const std::array<LabelFunction, 3> least = {*owners[0], *owners[1], *owners[2]};
    std::erase_if(functions_, [&](const LabelFunction& f) {
      return std::any_of(least.begin(), least.end(), [&](const LabelFunction& owner) {
        bool hidden = owner.label != f.label;
        for (int i = 0; i < 3; ++i)
          hidden &= owner.value[i] < f.value[i] ||
                    (owner.value[i] == f.value[i] && owner.label < f.label);
        return hidden;
      });
    });
  }

  void addCells(int element, const Sides& sides) {
    const int face = complex_.face(element);
    const auto& squared = sides.squaredLength;
    const double longest = std::sqrt(std::max({squared[0], squared[1], squared[2]}));
    corners_.assign(envelope_.vertices().size(), {});
    for (const FaceEnvelope::Cell& cell : envelope_.cells()) {
      for (const auto& [vertex, across] : cell.sides) {
        Corner& corner = corners_[vertex];
        if (corner.point >= 0) continue;
        corner.bary = complex_.faceBary(element, envelope_.bary(vertex));
        corner.point = pointAt(element, vertex, sides, longest);
      }
    }
    tellApartInnerPoints();
    cellAreas_.clear();
    for (const FaceEnvelope::Cell& cell : envelope_.cells()) {
      const size_t n = cell.sides.size();
      const int first = static_cast<int>(cellPoints_.size());
      const Eigen::Vector3d& origin = corners_[cell.sides[0].vertex].bary;
      double area = 0;
      for (size_t i = 0; i < n; ++i) {
        const auto [vertex, across] = cell.sides[i];
        const Corner& from = corners_[vertex];
        const Corner& to = corners_[cell.sides[i + 1 < n ? i + 1 : 0].vertex];
        cellPoints_.push_back(from.point);
        const double px = from.bary[0] - origin[0], py = from.bary[1] - origin[1];
        const double qx = to.bary[0] - origin[0], qy = to.bary[1] - origin[1];
        area += px * qy - py * qx;
        if (across > cell.function)
          addSegment(from, to, label(cell.function), label(across), face, squared);
        if (FaceEnvelope::isTriangleSide(across)) {
          const int h = 3 * element + FaceEnvelope::triangleSide(across);
          if (twin_[h] < 0) addUnmatchedSide(h, vertex);
        }
      }
      cellAreas_.push_back(area);
      cells_.push_back(
          {face, label(cell.function), first, static_cast<int>(cellPoints_.size()) - first});
    }
    addAreas(mesh_.faceArea(face));
  }

  /// Where slivers meet, an inner point may be where another one is, or a corner, that no segment
  /// joins it to: they stay two points, and so have to be told apart by their places.
  void tellApartInnerPoints() {
    for (size_t v = 0; v < corners_.size(); ++v) {
      Corner& inner = corners_[v];
      if (inner.point < 0 || envelope_.vertices()[v].kind != FaceEnvelope::Vertex::kInside)
        continue;
      for (const Corner& other : corners_) {
        if (other.point < 0 || other.point == inner.point || other.bary != inner.bary) continue;
        Eigen::Index largest;
        inner.bary.maxCoeff(&largest);
        inner.bary[largest] = std::nextafter(inner.bary[largest], 0.0);
        place_[inner.point].bary = inner.bary;
      }
    }
  }

  /// Adds the areas of an element's cells, given as shares of its face, to those of the regions.
  /// Rounding may have turned a sliver over; what it has less than nothing is the largest cell's.
  void addAreas(double faceArea) {
    const auto largest = std::max_element(cellAreas_.begin(), cellAreas_.end());
    for (double& area : cellAreas_)
      if (area < 0) *largest += std::exchange(area, 0.0);
    for (size_t c = 0; c < cellAreas_.size(); ++c)
      out_.regionArea[label(envelope_.cells()[c].function)] += cellAreas_[c] * faceArea;
  }

  int pointAt(int element, int vertex, const Sides& sides, double longest) {
    const FaceEnvelope::Vertex& v = envelope_.vertices()[vertex];
    if (v.kind == FaceEnvelope::Vertex::kCorner)
      return pointOfNode(tail_[3 * element + v.place], element, v.place);
    const SurfacePoint place{complex_.face(element), corners_[vertex].bary};
    const std::array<int, 3> labels = {label(v.functions[0]), label(v.functions[1]),
                                       v.functions[2] < 0 ? -1 : label(v.functions[2])};
    if (v.kind == FaceEnvelope::Vertex::kInside) {
      innerPoints_.push_back(static_cast<int>(points_.size()));
      return addPoint(place, insideError(v, longest), labels);
    }

    // On a side: the neighbour may have made the point already.
    int& first = firstOnSide_[sides.index[v.place]];
    for (int p = first; p >= 0; p = points_[p].nextOnSide)
      if (std::minmax(points_[p].labels[0], points_[p].labels[1]) ==
          std::minmax(labels[0], labels[1]))
        return p;
    const int point = addPoint(place, sideError(v, longest), labels);
    // It may be no other than an end of the side, or another point there.
    for (const int corner : {v.place, (v.place + 1) % 3}) {
      const Eigen::Vector3d end = complex_.faceBary(element, Eigen::Vector3d::Unit(corner));
      const double error = points_[point].error;
      if (squaredDistance(place.bary, end, sides.squaredLength) <= error * error)
        unite(point, pointOfNode(tail_[3 * element + corner], element, corner));
    }
    for (int p = first; p >= 0; p = points_[p].nextOnSide)
      if ((mesh_.position(place_[p]) - mesh_.position(place)).norm() <=
          points_[p].error + points_[point].error)
        unite(point, p);
    points_[point].nextOnSide = std::exchange(first, point);
    return point;
  }

  int pointOfNode(int node, int element, int corner) {
    return pointOfNode(node, element, Eigen::Vector3d::Unit(corner));
  }

  int pointOfNode(int node, int element, const Eigen::Vector3d& bary) {
    int& point = pointOfNode_[node];
    if (point < 0) {
      point =
          addPoint({complex_.face(element), complex_.faceBary(element, bary)}, 0.0, {-1, -1, -1});
      isNode_.back() = true;
      nodesWithPoint_.push_back(node);
    }
    return point;
  }

  /// Goes on with a cell, along a side without twin.
  void addUnmatchedSide(int h, int vertex) {
    addBoundary(h, vertex);
    addInnerNodes(h / 3, h % 3);
  }

  /// Past the corners of smaller elements on a side: one label owns all of it.
  void addInnerNodes(int element, int side) {
    for (const auto& [node, share] : complex_.innerNodes(3 * element + side)) {
      Eigen::Vector3d bary = Eigen::Vector3d::Zero();
      bary[side] = 1 - share;
      bary[(side + 1) % 3] = share;
      cellPoints_.push_back(pointOfNode(node, element, bary));
    }
  }

  int addPoint(const SurfacePoint& place, double error, const std::array<int, 3>& labels) {
    const int point = static_cast<int>(points_.size());
    points_.push_back({error, labels, {-1, -1, -1}, -1});
    place_.push_back(place);
    isNode_.push_back(false);
    parent_.push_back(point);
    return point;
  }

  int label(int function) const { return functions_[function].label; }
  const std::array<double, 3>& value(int function) const { return functions_[function].value; }

  /// The share of an edge by which an error of the functions moves a crossing, times the edge.
  double sideError(const FaceEnvelope::Vertex& v, double longest) const {
    const int i = v.place, j = (i + 1) % 3;
    const auto &a = value(v.functions[0]), &b = value(v.functions[1]);
    const double noise = 2 * kDistanceTolerance * std::max({a[i], a[j], b[i], b[j]});
    const double slope = std::abs((a[i] - b[i]) - (a[j] - b[j]));
    return longest * (noise < kMaxPointError * slope ? noise / slope : kMaxPointError);
  }

  double insideError(const FaceEnvelope::Vertex& v, double longest) const {
    const auto &a = value(v.functions[0]), &b = value(v.functions[1]), &c = value(v.functions[2]);
    const Eigen::Vector3d p(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    const Eigen::Vector3d q(c[0] - a[0], c[1] - a[1], c[2] - a[2]);
    const double noise =
        2 * kDistanceTolerance * std::max({a[0], a[1], a[2]}) * (p.lpNorm<1>() + q.lpNorm<1>());
    const double slope = p.cross(q).lpNorm<1>();
    return longest * (noise < kMaxPointError * slope ? noise / slope : kMaxPointError);
  }

  void addSegment(const Corner& from, const Corner& to, int left, int right, int face,
                  const std::array<double, 3>& sides) {
    const int dart = 2 * static_cast<int>(segments_.size());
    segments_.push_back({{from.point, to.point}, {left, right}, face});
    nextDart_.insert(nextDart_.end(), {-1, -1});
    Point &tail = points_[from.point], &tip = points_[to.point];
    leave(tail, left, dart);
    arrive(tail, right, dart + 1);
    arrive(tip, left, dart);
    leave(tip, right, dart + 1);
    const double error = tail.error + tip.error;
    if (squaredDistance(from.bary, to.bary, sides) <= error * error) unite(from.point, to.point);
  }

  /// A dart of a region leaves a point: the one that comes there, if it is known, goes on with it.
  void leave(Point& p, int label, int dart) {
    int& other = dartAt(p, label);
    if (other < 0)
      other = dart;
    else
      nextDart_[other] = dart;
  }

  void arrive(Point& p, int label, int dart) {
    int& other = dartAt(p, label);
    if (other < 0)
      other = dart;
    else
      nextDart_[dart] = other;
  }

  static int& dartAt(Point& p, int label) {
    return p.darts[p.labels[0] == label ? 0 : p.labels[1] == label ? 1 : 2];
  }

  // --- Which points are one --------------------------------------------------------------------

  int root(int point) {
    while (parent_[point] != point) point = parent_[point] = parent_[parent_[point]];
    return point;
  }

  /// The node stands for all, so that a place on a vertex is exactly that; else the first. Two
  /// nodes stay two, however near: region triangles have them as corners.
  void unite(int a, int b) {
    a = root(a);
    b = root(b);
    if (a == b || (isNode_[a] && isNode_[b])) return;
    if (isNode_[b] || (!isNode_[a] && b < a)) std::swap(a, b);
    parent_[b] = a;
    mergedFaces_.insert(mergedFaces_.end(), {place_[a].face, place_[b].face});
    merged_.resize(points_.size(), false);
    merged_[a] = true;
  }

  bool hasMergedPoints() const { return !merged_.empty(); }

  bool isMerged(int finalPoint) const {
    return finalPoint < static_cast<int>(merged_.size()) && merged_[finalPoint];
  }

  // --- The mesh boundary -----------------------------------------------------------------------

  /// Notes a breakpoint: where a piece of the mesh boundary that a cell owns starts.
  void addBoundary(int h, int vertex) {
    const int boundary = complex_.boundaryHalfedge(h);
    if (boundary < 0) return;
    const FaceEnvelope::Vertex& v = envelope_.vertices()[vertex];
    if (v.kind != FaceEnvelope::Vertex::kOnSide) return;
    const Eigen::Vector3d start = complex_.faceBary(h / 3, Eigen::Vector3d::Unit(h % 3));
    boundary_.push_back({boundary, start[(boundary + 1) % 3], corners_[vertex].point,
                         label(v.functions[0]), label(v.functions[1])});
  }

  /// Puts the boundary points in order along their halfedges.
  void collectBoundary() {
    const auto part = [](const BoundaryPoint& b) { return std::pair(b.halfedge, b.start); };
    std::stable_sort(boundary_.begin(), boundary_.end(),
                     [&](const auto& a, const auto& b) { return part(a) < part(b); });
    for (auto first = boundary_.begin(); first != boundary_.end();) {
      const auto last = std::find_if(
          first, boundary_.end(), [&](const BoundaryPoint& b) { return part(b) != part(*first); });
      chain({&*first, static_cast<size_t>(last - first)});
      first = last;
    }
    for (int i = 0; i < static_cast<int>(boundary_.size()); ++i) {
      firstOnBoundary_.try_emplace(boundary_[i].halfedge, i);
      boundaryIndex_[boundary_[i].point] = i;
    }
  }

  /// Each point starts with the label that the one before it ends with: that is their order in the
  /// exact graph, which rounding may have reversed in their coordinates.
  void chain(std::span<BoundaryPoint> points) {
    const auto isFirst = [&](const BoundaryPoint& p) {
      return std::none_of(points.begin(), points.end(),
                          [&](const BoundaryPoint& other) { return other.after == p.before; });
    };
    std::iter_swap(points.begin(), std::find_if(points.begin(), points.end(), isFirst));
    for (size_t i = 1; i < points.size(); ++i)
      std::iter_swap(points.begin() + i,
                     std::find_if(points.begin() + i, points.end(), [&](const BoundaryPoint& p) {
                       return p.before == points[i - 1].after;
                     }));
  }

  int vertexPoint(int vertex) {
    const int h = mesh_.outgoing(vertex);
    if (pointOfNode_[vertex] < 0) {
      pointOfNode_[vertex] =
          addPoint({TriangleMesh::faceOf(h), Eigen::Vector3d::Unit(h % 3)}, 0.0, {-1, -1, -1});
      isNode_.back() = true;
      nodesWithPoint_.push_back(vertex);
    }
    return pointOfNode_[vertex];
  }

  // --- Loops -----------------------------------------------------------------------------------

  void traceLoops() {
    steps_.reserve(2 * segments_.size());
    std::vector<char> visited(2 * segments_.size(), false);
    for (int dart = 0; dart < static_cast<int>(visited.size()); ++dart)
      if (!visited[dart] && isTraced(labelOf(dart))) traceLoop(dart, visited);
    addUnbrokenBoundaries();
    cancelSteps();
    collectOutlines();
  }

  bool isTraced(int label) const { return isTraced_.empty() || isTraced_[label]; }

  int labelOf(int dart) const { return segments_[dart / 2].labels[dart % 2]; }

  void traceLoop(int start, std::vector<char>& visited) {
    const int first = static_cast<int>(steps_.size()), label = labelOf(start);
    for (int dart = start; !visited[dart];) {
      visited[dart] = true;
      const Segment& segment = segments_[dart / 2];
      const int tip = segment.points[1 - dart % 2];
      addStep(label, segment.points[dart % 2], segment.face, false);
      dart = nextDart_[dart];
      if (dart < 0) dart = followBoundary(tip, label);
    }
    closeRing(first);
  }

  void addStep(int label, int point, int face, bool isOnBoundary) {
    const int s = static_cast<int>(steps_.size());
    steps_.push_back({label, root(point), face, s - 1, s + 1, isOnBoundary, false});
  }

  /// Makes a ring of the steps since the first one.
  void closeRing(int first) {
    steps_[first].previous = static_cast<int>(steps_.size()) - 1;
    steps_.back().next = first;
    for (const Step& step : std::span(steps_).subspan(first))
      if (step.isOnBoundary && (isMerged(step.from) || isMerged(tip(step))))
        boundarySteps_.push_back({step.label, step.from, tip(step), step.face});
  }

  int tip(const Step& step) const { return steps_[step.next].from; }

  /// From a point where a region comes to the mesh boundary, forward along it to the next point
  /// where the region leaves it; returns that dart.
  int followBoundary(int point, int label) {
    const int start = boundaryIndex_.at(point);
    int halfedge = boundary_[start].halfedge;
    addStep(label, point, TriangleMesh::faceOf(halfedge), true);
    int index = start + 1;
    while (index >= static_cast<int>(boundary_.size()) || boundary_[index].halfedge != halfedge) {
      const int vertex = mesh_.tip(halfedge);
      halfedge = mesh_.outgoing(vertex);
      addStep(label, vertexPoint(vertex), TriangleMesh::faceOf(halfedge), true);
      const auto first = firstOnBoundary_.find(halfedge);
      index = first == firstOnBoundary_.end() ? static_cast<int>(boundary_.size()) : first->second;
    }
    return dartAt(points_[boundary_[index].point], label);
  }

  /// Whole boundary loops that one region owns.
  void addUnbrokenBoundaries() {
    for (const int start : mesh_.boundaryLoops()) {
      bool isBroken = false;
      std::vector<int> vertices;
      int h = start;
      do {
        vertices.push_back(mesh_.tail(h));
        isBroken |= firstOnBoundary_.contains(h);
        h = mesh_.outgoing(mesh_.tip(h));
      } while (h != start);
      const int owner = nearestOf(distances_.at(vertices[0])).label;
      if (isBroken || owner < 0 || !isTraced(owner)) continue;
      const int first = static_cast<int>(steps_.size());
      for (const int at : vertices)
        addStep(owner, vertexPoint(at), TriangleMesh::faceOf(mesh_.outgoing(at)), true);
      closeRing(first);
    }
  }

  /// Drops steps of no length, and those that the region takes in both directions: it has no width
  /// there. That may join two loops, or part one in two.
  void cancelSteps() {
    std::map<std::array<int, 4>, std::vector<int>> waiting;  // by label and where they are
    for (int s = 0; s < static_cast<int>(steps_.size()); ++s) {
      Step& step = steps_[s];
      const int from = step.from, to = tip(step);
      if (from == to) {
        steps_[step.previous].next = step.next;
        steps_[step.next].previous = step.previous;
        step.isGone = true;
      } else if (isMerged(from) || isMerged(to)) {
        const auto [low, high, face] = placeOf(from, to, step.face);
        auto& others = waiting[{step.label, low, high, face}];
        if (!others.empty() && steps_[others.back()].from == to) {
          cancel(s, others.back());
          others.pop_back();
        } else {
          others.push_back(s);
        }
      }
    }
  }

  /// What came to a step goes on behind the opposite one.
  void cancel(int s, int opposite) {
    Step &a = steps_[s], &b = steps_[opposite];
    const Step formerA = a, formerB = b;
    steps_[formerA.previous].next = formerB.next;
    steps_[formerB.next].previous = formerA.previous;
    steps_[formerB.previous].next = formerA.next;
    steps_[formerA.next].previous = formerB.previous;
    a.isGone = b.isGone = true;
  }

  void collectOutlines() {
    outlinePoints_.reserve(steps_.size());
    for (Step& start : steps_) {
      if (start.isGone) continue;
      const int first = static_cast<int>(outlinePoints_.size());
      for (Step* step = &start; !step->isGone; step = &steps_[step->next]) {
        outlinePoints_.push_back(step->from);
        step->isGone = true;
      }
      outlines_.push_back({start.label, first, static_cast<int>(outlinePoints_.size()) - first});
    }
    std::stable_sort(outlines_.begin(), outlines_.end(),
                     [](const Outline& a, const Outline& b) { return a.label < b.label; });
  }

  std::span<const int> pointsOf(const Outline& outline) const {
    return std::span(outlinePoints_).subspan(outline.first, outline.count);
  }

  /// Segments between the same final points of which one is merged lie on top of each other if this
  /// is the same: in one face they do, and between two merged points along an edge of both faces.
  std::array<int, 3> placeOf(int from, int to, int face) const {
    const bool anyFace = isMerged(from) && isMerged(to);
    return {std::min(from, to), std::max(from, to), anyFace ? -1 : face};
  }

  // --- Results ---------------------------------------------------------------------------------

  int outPoint(int point) {
    const int p = root(point);
    if (outIndex_[p] < 0) {
      outIndex_[p] = static_cast<int>(out_.points.size());
      out_.points.push_back(place_[p]);
    }
    return outIndex_[p];
  }

  /// Segments that end at merged points may lie on top of each other, or on the boundary, with a
  /// region of no width between them; what remains there has the outermost labels.
  void collectSegments() {
    struct Side {
      std::vector<int> left, right;
      int face;
    };
    std::map<std::array<int, 3>, Side> stacked;  // by two points, and the face if it matters
    const auto stack = [&](int from, int to, int left, int right, int face) {
      const bool swapped = to < from;
      Side& side = stacked[placeOf(from, to, face)];
      (swapped ? side.right : side.left).push_back(left);
      if (right >= 0) (swapped ? side.left : side.right).push_back(right);
      side.face = face;
    };
    out_.segments.reserve(segments_.size());
    for (const Segment& s : segments_) {
      const int from = root(s.points[0]), to = root(s.points[1]);
      if (from == to) continue;
      if (isMerged(from) || isMerged(to))
        stack(from, to, s.labels[0], s.labels[1], s.face);
      else
        out_.segments.push_back({{outPoint(from), outPoint(to)}, s.labels, s.face, -1});
    }
    for (const BoundaryStep& step : boundarySteps_)
      if (step.from != step.to) stack(step.from, step.to, step.label, -1, step.face);
    for (auto& [ends, side] : stacked) {
      for (auto label = side.left.begin(); label != side.left.end();) {
        const auto same = std::find(side.right.begin(), side.right.end(), *label);
        if (same == side.right.end()) {
          ++label;
        } else {
          side.right.erase(same);
          label = side.left.erase(label);
        }
      }
      if (side.left.empty() || side.right.empty()) continue;
      const int left = side.left.front(), right = side.right.front();
      const int first = outPoint(ends[0]), second = outPoint(ends[1]);
      if (left < right)
        out_.segments.push_back({{first, second}, {left, right}, side.face, -1});
      else
        out_.segments.push_back({{second, first}, {right, left}, side.face, -1});
    }
  }

  /// Chains segments through the points where exactly two of one bisector meet.
  void collectArcs() {
    struct Ends {
      int incoming = -1, outgoing = -1, degree = 0;
    };
    std::vector<Ends> ends(out_.points.size());
    for (int s = 0; s < static_cast<int>(out_.segments.size()); ++s) {
      Ends &tail = ends[out_.segments[s].points[0]], &tip = ends[out_.segments[s].points[1]];
      tail.outgoing = tip.incoming = s;
      ++tail.degree;
      ++tip.degree;
    }
    const auto passes = [&](int point) {
      const auto& [incoming, outgoing, degree] = ends[point];
      if (degree != 2 || incoming < 0 || outgoing < 0) return false;
      const auto &before = out_.segments[incoming].labels, &after = out_.segments[outgoing].labels;
      return before[0] == after[0] && before[1] == after[1];
    };
    std::vector<int> chain;
    const auto follow = [&](int segment) {
      const int arc = out_.arcs.size();
      out_.arcLabels.push_back(out_.segments[segment].labels);
      chain.assign(1, out_.segments[segment].points[0]);
      for (;;) {
        auto& s = out_.segments[segment];
        s.arc = arc;
        chain.push_back(s.points[1]);
        if (!passes(s.points[1])) break;
        segment = ends[s.points[1]].outgoing;
        if (out_.segments[segment].arc >= 0) break;
      }
      out_.arcs.add(chain);
    };
    for (int s = 0; s < static_cast<int>(out_.segments.size()); ++s)
      if (!passes(out_.segments[s].points[0])) follow(s);
    for (int s = 0; s < static_cast<int>(out_.segments.size()); ++s)
      if (out_.segments[s].arc < 0) follow(s);
  }

  /// A region's loop that comes to a point from `before` and leaves it to `after` covers the sector
  /// counterclockwise from `after` to `before`.
  struct Sector {
    int point, label, before, after;
  };

  /// In order of their points. Where three regions of the exact graph meet, there is no more to
  /// say; where points have become one, the outlines tell who is around.
  void collectVoronoiPoints() {
    std::vector<Sector> sectors = mergedSectors();
    auto next = sectors.begin();
    const auto addMergedBefore = [&](int point) {
      while (next != sectors.end() && next->point < point) {
        const auto last = std::find_if(next, sectors.end(),
                                       [&](const Sector& s) { return s.point != next->point; });
        addVoronoiPoint({&*next, static_cast<size_t>(last - next)});
        next = last;
      }
    };
    for (const int p : innerPoints_) {
      if (parent_[p] != p || isMerged(p)) continue;
      addMergedBefore(p);
      const auto& labels = points_[p].labels;
      addVoronoiPoint(p, {labels.begin(), labels.end()});
    }
    addMergedBefore(static_cast<int>(points_.size()));
  }

  /// In order of their points.
  std::vector<Sector> mergedSectors() const {
    std::vector<Sector> sectors;
    if (!hasMergedPoints()) return sectors;
    for (const Outline& outline : outlines_) {
      const std::span<const int> points = pointsOf(outline);
      const size_t n = points.size();
      for (size_t i = 0; i < n; ++i)
        if (isMerged(points[i]))
          sectors.push_back({points[i], outline.label, points[i > 0 ? i - 1 : n - 1],
                             points[i + 1 < n ? i + 1 : 0]});
    }
    std::stable_sort(sectors.begin(), sectors.end(),
                     [](const Sector& a, const Sector& b) { return a.point < b.point; });
    return sectors;
  }

  void addVoronoiPoint(std::span<Sector> sectors) {
    std::vector<int> distinct;
    for (const Sector& s : sectors)
      if (distinct.empty() || distinct.back() != s.label) distinct.push_back(s.label);
    if (distinct.size() < 3) return;  // the loops, and so the sectors, are ascending by label
    // Counterclockwise: each sector starts where the one before it ends. On the mesh boundary the
    // first one starts where none ends.
    auto start = std::find_if(sectors.begin(), sectors.end(), [&](const Sector& s) {
      return std::none_of(sectors.begin(), sectors.end(),
                          [&](const Sector& other) { return other.before == s.after; });
    });
    if (start == sectors.end()) start = sectors.begin();
    std::swap(*start, sectors.front());
    size_t joinsLeft = sectors.size();  // there are not more rounds than sectors
    for (size_t i = 1; i < sectors.size(); ++i) {
      const auto next = std::find_if(sectors.begin() + i, sectors.end(), [&](const Sector& s) {
        return s.after == sectors[i - 1].before;
      });
      if (next != sectors.end()) {
        std::swap(*next, sectors[i]);
      } else if (joinsLeft > 0 && joinRounds(sectors.first(i), sectors.subspan(i))) {
        --joinsLeft;
        i = 0;
      }
    }
    std::vector<int> labels;
    for (const Sector& s : sectors) labels.push_back(s.label);
    addVoronoiPoint(sectors.front().point, std::move(labels));
  }

  /// `labels` are counterclockwise.
  void addVoronoiPoint(int point, std::vector<int> labels) {
    std::rotate(labels.begin(), std::min_element(labels.begin(), labels.end()), labels.end());
    out_.voronoiPoints.push_back({outPoint(point), std::move(labels)});
  }

  /// Where a region comes to a point twice, between others that only it keeps apart, its loops pair
  /// the sides of its two sectors the wrong way: the sectors form two rounds instead of one.
  static bool joinRounds(std::span<Sector> chained, std::span<Sector> others) {
    for (Sector& a : chained)
      for (Sector& b : others)
        if (a.label == b.label) {
          std::swap(a.before, b.before);
          return true;
        }
    return false;
  }

  void collectLoops() {
    out_.loops.points.reserve(outlinePoints_.size());
    std::vector<int> list;
    for (const Outline& outline : outlines_) {
      list.clear();
      for (const int p : pointsOf(outline)) list.push_back(outPoint(p));
      out_.loops.add(list);
      out_.loopLabel.push_back(outline.label);
    }
  }

  /// Faces in order; one of which all that has any width went to one label is a region triangle
  /// after all.
  void collectCells() {
    const auto isBefore = [](const Cell& a, const Cell& b) { return a.face < b.face; };
    if (!std::is_sorted(cells_.begin(), cells_.end(), isBefore))
      std::stable_sort(cells_.begin(), cells_.end(), isBefore);
    out_.cells.offset.reserve(cells_.size() + 1);
    out_.cells.points.reserve(cellPoints_.size());
    out_.cellFace.reserve(cells_.size());
    out_.cellLabel.reserve(cells_.size());
    for (auto first = cells_.begin(); first != cells_.end();) {
      const auto last =
          std::find_if(first, cells_.end(), [&](const Cell& c) { return c.face != first->face; });
      collectCells({&*first, static_cast<size_t>(last - first)});
      first = last;
    }
  }

  void collectCells(std::span<const Cell> cells) {
    const int face = cells.front().face, first = cells.front().label;
    if (std::all_of(cells.begin(), cells.end(), [&](const Cell& c) { return c.label == first; })) {
      out_.faceLabel[complex_.faceIndex(face)] = first;
      return;
    }
    PointLists& lists = out_.cells;
    const int before = lists.size();
    for (const Cell& cell : cells) addFinalPoints(cell);
    const std::span<int> points = std::span(lists.points).subspan(lists.offset[before]);
    if (lists.size() == before + 1 && points.size() == 3 &&
        std::all_of(points.begin(), points.end(), [&](int p) { return isNode_[p]; })) {
      out_.faceLabel[complex_.faceIndex(face)] = out_.cellLabel.back();
      dropLastCell();
      return;
    }
    for (int& p : points) p = outPoint(p);
  }

  /// Adds what is left of a cell, if it has any width.
  void addFinalPoints(const Cell& cell) {
    PointLists& lists = out_.cells;
    const size_t begin = lists.points.size();
    for (const int point : std::span(cellPoints_).subspan(cell.first, cell.count)) {
      const int p = root(point);
      if (lists.points.size() == begin || lists.points.back() != p) lists.points.push_back(p);
    }
    while (lists.points.size() > begin + 1 && lists.points[begin] == lists.points.back())
      lists.points.pop_back();
    if (lists.points.size() < begin + 3) {
      lists.points.resize(begin);
      return;
    }
    lists.offset.push_back(static_cast<int>(lists.points.size()));
    out_.cellFace.push_back(cell.face);
    out_.cellLabel.push_back(cell.label);
  }

  void dropLastCell() {
    out_.cells.offset.pop_back();
    out_.cells.points.resize(out_.cells.offset.back());
    out_.cellFace.pop_back();
    out_.cellLabel.pop_back();
  }

  const TriangleMesh& mesh_;
  const DistanceField& distances_;
  const FaceComplex& complex_;
  const std::span<const char> isTraced_;
  const std::span<const int> tail_, twin_;
  Diagram out_;

  std::vector<Point> points_;
  std::vector<SurfacePoint> place_;  ///< per point
  std::vector<int> innerPoints_;     ///< those of three regions
  std::vector<char> isNode_;
  std::vector<int> parent_;   ///< union-find over points_
  std::vector<char> merged_;  ///< of roots: whether they stand for several points
  std::vector<int> mergedFaces_;
  const std::span<int> pointOfNode_;
  std::vector<int> nodesWithPoint_;
  std::vector<int> firstOnSide_;  ///< per side of mixed elements
  std::vector<Segment> segments_;
  std::vector<int> nextDart_;  ///< of the same region; -1 where it comes to the mesh boundary
  std::vector<Cell> cells_;
  std::vector<int> cellPoints_;
  std::vector<BoundaryPoint> boundary_;
  std::map<int, int> firstOnBoundary_;  ///< per boundary halfedge
  std::map<int, int> boundaryIndex_;    ///< per point
  std::vector<Step> steps_;
  std::vector<BoundaryStep> boundarySteps_;  ///< those with ends at merged points
  std::vector<Outline> outlines_;            ///< ascending by label
  std::vector<int> outlinePoints_;
  std::vector<int> outIndex_;

  /// Of the mixed elements. Read all at once, with many loads under way at a time; one by one, each
  /// would have to be waited for.
  std::vector<Sides> mixedSides_;

  // For the element at hand.
  std::vector<LabelFunction> functions_;
  FaceEnvelope envelope_;
  std::vector<Corner> corners_;  ///< per vertex of the envelope
  std::vector<double> cellAreas_;
};

}  // namespace

Diagram traceDiagram(const TriangleMesh& mesh, const DistanceField& distances, int siteCount,
                     const DiagramOptions& options) {
  return traceAll(mesh, distances, siteCount, options).diagram;
}

TracedDiagram traceAll(const TriangleMesh& mesh, const DistanceField& distances, int siteCount,
                       const DiagramOptions& options) {
  const FaceComplex complex(mesh, distances, options.detail);
  std::vector<int> pointOfNode(complex.nodeCount(), -1);
  return Tracer(mesh, distances, complex, siteCount, {}, pointOfNode).trace();
}

PartialTracer::PartialTracer(const TriangleMesh& mesh, const DistanceField& distances,
                             const DiagramOptions& options)
    : mesh_(mesh), distances_(distances), options_(options), complex_(mesh, distances) {}

TracedDiagram PartialTracer::trace(std::span<const int> faces, std::span<const char> isTraced) {
  complex_.take(faces, options_.detail);
  if (complex_.nodeCount() > static_cast<int>(pointOfNode_.size()))
    pointOfNode_.resize(complex_.nodeCount(), -1);
  const int siteCount = static_cast<int>(isTraced.size());
  return Tracer(mesh_, distances_, complex_, siteCount, isTraced, pointOfNode_).trace();
}

}  // namespace gvd
