// SPDX-License-Identifier: MIT
// This work is based on:
// Eivind Lyche Melvær, Martin Reimers. Approximating Geodesic Voronoi Diagrams on Triangulated
// Surfaces. 2014
#include "gvd/diagram.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "face_complex.h"
#include "face_envelope.h"
#include "surface_geometry.h"
#include "tolerances.h"
#include "trace_faces.h"

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
  /// Traces the outlines of the labels that `isTraced` says, of all if it is empty.
  Tracer(const TriangleMesh& mesh, const DistanceField& distances, const FaceComplex& complex,
         int siteCount, std::span<const char> isTraced)
      : mesh_(mesh),
        distances_(distances),
        complex_(complex),
        isTraced_(isTraced),
        tail_(complex.tails()),
        twin_(complex.twins()),
        pointOfNode_(complex.nodeCount(), -1),
        firstOnSide_(tail_.size(), -1) {
    out_.siteCount = siteCount;
    out_.regionArea.assign(siteCount, 0.0);
    out_.faceLabel.assign(mesh.faceCount(), Diagram::kMixed);
  }

  TracedDiagram trace() {
    reserve();
    for (int e = 0; e < complex_.elementCount(); ++e) divide(e);
    collectBoundary();
    const std::vector<Outline> loops = traceLoops();
    outIndex_.assign(points_.size(), -1);
    out_.points.reserve(points_.size());
    collectSegments();
    collectArcs();
    collectVoronoiPoints(loops);
    collectLoops(loops);
    collectCells();
    return {std::move(out_), std::move(mergedFaces_), complex_.completedFaces()};
  }

 private:
  /// A point of the exact graph, or a node that the mesh boundary or a cell passes.
  struct Point {
    SurfacePoint place;
    double error;               ///< bound on how far rounding has moved it
    std::array<int, 3> labels;  ///< of the regions that meet here, -1 for none
    std::array<int, 3> darts;   ///< the dart of each that leaves here, -1 for none
    int nextOnSide;             ///< list of the points on one side of elements
  };
  struct Segment {
    std::array<int, 2> points;
    std::array<int, 2> labels;  ///< left (the lower), right
    int face;
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
  /// A step of a loop starts at a point and crosses a face, or follows a side of it that is on the
  /// mesh boundary.
  struct Step {
    int point;
    int face;
    bool onBoundary;
  };
  struct Loop {
    int label;
    std::vector<Step> steps;
  };
  /// A loop as doubles see it.
  struct Outline {
    int label;
    std::vector<int> points;  ///< final points (`root`)
  };

  // --- The exact graph -------------------------------------------------------------------------

  /// Room for what the elements of several regions usually need.
  void reserve() {
    size_t mixed = 0;
    for (int e = 0; e < complex_.elementCount(); ++e)
      mixed += complex_.soleOwner(e) == Diagram::kMixed;
    points_.reserve(5 * mixed / 2);
    parent_.reserve(5 * mixed / 2);
    isNode_.reserve(5 * mixed / 2);
    segments_.reserve(5 * mixed / 4);
    cells_.reserve(5 * mixed / 2);
    cellPoints_.reserve(8 * mixed);
  }

  void divide(int element) {
    const int face = complex_.face(element);
    const int owner = complex_.soleOwner(element);
    if (owner != Diagram::kMixed && complex_.isWhole(element)) {
      out_.faceLabel[face] = owner;
      if (owner < 0) return;
      out_.regionArea[owner] += mesh_.faceArea(face);
      if (isIndifferent(element, owner)) out_.indifferentFaces.push_back(face);
      return;
    }
    gatherFunctions(element, owner);
    envelope_.compute(functions_);
    addCells(element);
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
    const auto a = complex_.labels(tail_[3 * element]);
    const auto b = complex_.labels(tail_[3 * element + 1]);
    const auto c = complex_.labels(tail_[3 * element + 2]);
    functions_.clear();
    for (auto i = a.begin(), j = b.begin(), k = c.begin();
         i != a.end() && j != b.end() && k != c.end();) {
      const int label = std::max({i->label, j->label, k->label});
      if (i->label < label) {
        ++i;
      } else if (j->label < label) {
        ++j;
      } else if (k->label < label) {
        ++k;
      } else {
        if (soleOwner < 0 || label == soleOwner)
          functions_.push_back(
              {label,
               {i->distance * i->distance, j->distance * j->distance, k->distance * k->distance}});
        ++i, ++j, ++k;
      }
    }
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

  void addCells(int element) {
    const int face = complex_.face(element);
    const auto sides = squaredSides(mesh_, face);
    const double longest = std::sqrt(std::max({sides[0], sides[1], sides[2]}));
    const int vertexCount = static_cast<int>(envelope_.vertices().size());
    pointOfVertex_.assign(vertexCount, -1);
    baryOfVertex_.resize(vertexCount);
    for (const FaceEnvelope::Cell& cell : envelope_.cells()) {
      for (const FaceEnvelope::CellSide& side : cell.sides) {
        if (pointOfVertex_[side.vertex] >= 0) continue;
        baryOfVertex_[side.vertex] = complex_.faceBary(element, envelope_.bary(side.vertex));
        pointOfVertex_[side.vertex] = pointAt(element, side.vertex, sides, longest);
      }
    }
    cellAreas_.clear();
    for (const FaceEnvelope::Cell& cell : envelope_.cells()) {
      const size_t n = cell.sides.size();
      const int first = static_cast<int>(cellPoints_.size());
      const Eigen::Vector3d origin = baryOfVertex_[cell.sides[0].vertex];
      double area = 0;
      for (size_t i = 0; i < n; ++i) {
        const auto [vertex, across] = cell.sides[i];
        const int next = cell.sides[(i + 1) % n].vertex;
        cellPoints_.push_back(pointOfVertex_[vertex]);
        const Eigen::Vector3d p = baryOfVertex_[vertex] - origin, q = baryOfVertex_[next] - origin;
        area += p[0] * q[1] - p[1] * q[0];
        if (across > cell.label) addSegment(vertex, next, cell.label, across, face, sides);
        if (FaceEnvelope::isTriangleSide(across)) {
          addBoundary(element, FaceEnvelope::triangleSide(across), vertex);
          addInnerNodes(element, FaceEnvelope::triangleSide(across));
        }
      }
      cellAreas_.push_back(area);
      cells_.push_back({face, cell.label, first, static_cast<int>(cellPoints_.size()) - first});
    }
    addAreas(mesh_.faceArea(face));
  }

  /// Adds the areas of an element's cells, given as shares of its face, to those of the regions.
  /// Rounding may have turned a sliver over; what it has less than nothing is the largest cell's.
  void addAreas(double faceArea) {
    const auto largest = std::max_element(cellAreas_.begin(), cellAreas_.end());
    for (double& area : cellAreas_)
      if (area < 0) *largest += std::exchange(area, 0.0);
    for (size_t c = 0; c < cellAreas_.size(); ++c)
      out_.regionArea[envelope_.cells()[c].label] += cellAreas_[c] * faceArea;
  }

  int pointAt(int element, int vertex, const std::array<double, 3>& sides, double longest) {
    const FaceEnvelope::Vertex& v = envelope_.vertices()[vertex];
    if (v.kind == FaceEnvelope::Vertex::kCorner)
      return pointOfNode(tail_[3 * element + v.place], element, v.place);
    const SurfacePoint place{complex_.face(element), baryOfVertex_[vertex]};
    if (v.kind == FaceEnvelope::Vertex::kInside)
      return addPoint(place, insideError(v, longest), v.labels);

    // On a side: the neighbour may have made the point already.
    const int h = 3 * element + v.place;
    const int side = twin_[h] < 0 ? h : std::min(h, twin_[h]);
    for (int p = firstOnSide_[side]; p >= 0; p = points_[p].nextOnSide)
      if (std::minmax(points_[p].labels[0], points_[p].labels[1]) ==
          std::minmax(v.labels[0], v.labels[1]))
        return p;
    const int point = addPoint(place, sideError(v, longest), v.labels);
    // It may be no other than an end of the side, or another point there.
    for (const int corner : {v.place, (v.place + 1) % 3}) {
      const Eigen::Vector3d end = complex_.faceBary(element, Eigen::Vector3d::Unit(corner));
      const double error = points_[point].error;
      if (squaredDistance(place.bary, end, sides) <= error * error)
        unite(point, pointOfNode(tail_[3 * element + corner], element, corner));
    }
    for (int p = firstOnSide_[side]; p >= 0; p = points_[p].nextOnSide)
      if ((mesh_.position(points_[p].place) - mesh_.position(place)).norm() <=
          points_[p].error + points_[point].error)
        unite(point, p);
    points_[point].nextOnSide = firstOnSide_[side];
    firstOnSide_[side] = point;
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
    }
    return point;
  }

  /// Goes on with a cell, past the corners of smaller elements on one of its sides: one label owns
  /// all of such a side.
  void addInnerNodes(int element, int side) {
    for (const auto& [node, share] : complex_.innerNodes(3 * element + side)) {
      Eigen::Vector3d bary = Eigen::Vector3d::Zero();
      bary[side] = 1 - share;
      bary[(side + 1) % 3] = share;
      cellPoints_.push_back(pointOfNode(node, element, bary));
    }
  }

  int addPoint(const SurfacePoint& place, double error, const std::array<int, 3>& labels) {
    points_.push_back({place, error, labels, {-1, -1, -1}, -1});
    isNode_.push_back(false);
    parent_.push_back(static_cast<int>(parent_.size()));
    return parent_.back();
  }

  const std::array<double, 3>& value(int label) const {
    return std::lower_bound(functions_.begin(), functions_.end(), label,
                            [](const LabelFunction& f, int l) { return f.label < l; })
        ->value;
  }

  /// The share of an edge by which an error of the functions moves a crossing, times the edge.
  double sideError(const FaceEnvelope::Vertex& v, double longest) const {
    const int i = v.place, j = (i + 1) % 3;
    const auto &a = value(v.labels[0]), &b = value(v.labels[1]);
    const double noise = 2 * kDistanceTolerance * std::max({a[i], a[j], b[i], b[j]});
    const double slope = std::abs((a[i] - b[i]) - (a[j] - b[j]));
    return longest * (noise < kMaxPointError * slope ? noise / slope : kMaxPointError);
  }

  double insideError(const FaceEnvelope::Vertex& v, double longest) const {
    const auto &a = value(v.labels[0]), &b = value(v.labels[1]), &c = value(v.labels[2]);
    const Eigen::Vector3d p(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    const Eigen::Vector3d q(c[0] - a[0], c[1] - a[1], c[2] - a[2]);
    const double noise =
        2 * kDistanceTolerance * std::max({a[0], a[1], a[2]}) * (p.lpNorm<1>() + q.lpNorm<1>());
    const double slope = p.cross(q).lpNorm<1>();
    return longest * (noise < kMaxPointError * slope ? noise / slope : kMaxPointError);
  }

  void addSegment(int fromVertex, int toVertex, int left, int right, int face,
                  const std::array<double, 3>& sides) {
    const int from = pointOfVertex_[fromVertex], to = pointOfVertex_[toVertex];
    const int segment = static_cast<int>(segments_.size());
    segments_.push_back({{from, to}, {left, right}, face});
    setDart(from, left, 2 * segment);
    setDart(to, right, 2 * segment + 1);
    const double error = points_[from].error + points_[to].error;
    if (squaredDistance(baryOfVertex_[fromVertex], baryOfVertex_[toVertex], sides) <= error * error)
      unite(from, to);
  }

  void setDart(int point, int label, int dart) {
    Point& p = points_[point];
    for (int i = 0; i < 3; ++i)
      if (p.labels[i] == label) p.darts[i] = dart;
  }

  int dartAt(int point, int label) const {
    const Point& p = points_[point];
    for (int i = 0; i < 3; ++i)
      if (p.labels[i] == label) return p.darts[i];
    return -1;
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
    mergedFaces_.insert(mergedFaces_.end(), {points_[a].place.face, points_[b].place.face});
    merged_.resize(points_.size(), false);
    merged_[a] = true;
  }

  bool hasMergedPoints() const { return !merged_.empty(); }

  bool isMerged(int finalPoint) const {
    return finalPoint < static_cast<int>(merged_.size()) && merged_[finalPoint];
  }

  // --- The mesh boundary -----------------------------------------------------------------------

  /// Notes a breakpoint: where a piece of the mesh boundary that a cell owns starts.
  void addBoundary(int element, int side, int vertex) {
    const int h = 3 * element + side;
    if (twin_[h] >= 0) return;
    const int boundary = complex_.boundaryHalfedge(h);
    if (boundary < 0) return;
    const FaceEnvelope::Vertex& v = envelope_.vertices()[vertex];
    if (v.kind != FaceEnvelope::Vertex::kOnSide) return;
    const Eigen::Vector3d start = complex_.faceBary(element, Eigen::Vector3d::Unit(side));
    boundary_.push_back(
        {boundary, start[(boundary + 1) % 3], pointOfVertex_[vertex], v.labels[0], v.labels[1]});
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
    }
    return pointOfNode_[vertex];
  }

  // --- Loops -----------------------------------------------------------------------------------

  std::vector<Outline> traceLoops() {
    std::vector<Loop> loops;
    std::vector<char> visited(2 * segments_.size(), false);
    for (int dart = 0; dart < static_cast<int>(visited.size()); ++dart)
      if (!visited[dart] && isTraced(labelOf(dart))) loops.push_back(traceLoop(dart, visited));
    addUnbrokenBoundaries(loops);
    std::vector<Outline> outlines = simplified(loops);
    std::stable_sort(outlines.begin(), outlines.end(),
                     [](const Outline& a, const Outline& b) { return a.label < b.label; });
    return outlines;
  }

  bool isTraced(int label) const { return isTraced_.empty() || isTraced_[label]; }

  int labelOf(int dart) const { return segments_[dart / 2].labels[dart % 2]; }

  Loop traceLoop(int start, std::vector<char>& visited) {
    Loop loop{labelOf(start), {}};
    for (int dart = start; !visited[dart];) {
      visited[dart] = true;
      const Segment& segment = segments_[dart / 2];
      loop.steps.push_back({segment.points[dart % 2], segment.face, false});
      int at = segment.points[1 - dart % 2];
      dart = dartAt(at, loop.label);
      if (dart < 0) dart = followBoundary(at, loop);
    }
    return loop;
  }

  /// From a point where a region comes to the mesh boundary, forward along it to the next point
  /// where the region leaves it; returns that dart.
  int followBoundary(int point, Loop& loop) {
    const int start = boundaryIndex_.at(point);
    int halfedge = boundary_[start].halfedge;
    loop.steps.push_back({point, TriangleMesh::faceOf(halfedge), true});
    int index = start + 1;
    while (index >= static_cast<int>(boundary_.size()) || boundary_[index].halfedge != halfedge) {
      const int vertex = mesh_.tip(halfedge);
      halfedge = mesh_.outgoing(vertex);
      loop.steps.push_back({vertexPoint(vertex), TriangleMesh::faceOf(halfedge), true});
      const auto first = firstOnBoundary_.find(halfedge);
      index = first == firstOnBoundary_.end() ? static_cast<int>(boundary_.size()) : first->second;
    }
    return dartAt(boundary_[index].point, loop.label);
  }

  /// Whole boundary loops that one region owns.
  void addUnbrokenBoundaries(std::vector<Loop>& loops) {
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
      Loop loop{owner, {}};
      for (const int at : vertices)
        loop.steps.push_back({vertexPoint(at), TriangleMesh::faceOf(mesh_.outgoing(at)), true});
      loops.push_back(std::move(loop));
    }
  }

  /// A step between final points, in a ring of steps.
  struct RingStep {
    int label, from, to, face;
    int previous, next;
    bool isGone = false;
  };

  /// Names final points and drops steps of no length, and those that the region takes in both
  /// directions: it has no width there. That may join two loops, or part one in two.
  std::vector<Outline> simplified(const std::vector<Loop>& loops) {
    std::vector<RingStep> steps;
    for (const Loop& loop : loops) {
      const int first = static_cast<int>(steps.size()), n = static_cast<int>(loop.steps.size());
      for (int i = 0; i < n; ++i) {
        const int from = root(loop.steps[i].point);
        const int to = root(loop.steps[(i + 1) % n].point);
        const auto& [point, face, onBoundary] = loop.steps[i];
        steps.push_back({loop.label, from, to, face, first + (i + n - 1) % n, first + (i + 1) % n});
        if (onBoundary && (isMerged(from) || isMerged(to))) boundarySteps_.push_back(steps.back());
      }
    }
    cancelSteps(steps);

    std::vector<Outline> outlines;
    for (RingStep& start : steps) {
      if (start.isGone) continue;
      Outline outline{start.label, {}};
      for (RingStep* step = &start; !step->isGone; step = &steps[step->next]) {
        outline.points.push_back(step->from);
        step->isGone = true;
      }
      outlines.push_back(std::move(outline));
    }
    return outlines;
  }

  void cancelSteps(std::vector<RingStep>& steps) const {
    std::map<std::array<int, 4>, std::vector<int>> waiting;  // by label and where they are
    for (int s = 0; s < static_cast<int>(steps.size()); ++s) {
      RingStep& step = steps[s];
      if (step.from == step.to) {
        steps[step.previous].next = step.next;
        steps[step.next].previous = step.previous;
        step.isGone = true;
      } else if (isMerged(step.from) || isMerged(step.to)) {
        const auto [low, high, face] = placeOf(step.from, step.to, step.face);
        auto& others = waiting[{step.label, low, high, face}];
        if (!others.empty() && steps[others.back()].from == step.to) {
          cancel(steps, s, others.back());
          others.pop_back();
        } else {
          others.push_back(s);
        }
      }
    }
  }

  /// What came to a step goes on behind the opposite one.
  static void cancel(std::vector<RingStep>& steps, int s, int opposite) {
    RingStep &a = steps[s], &b = steps[opposite];
    const RingStep formerA = a, formerB = b;
    steps[formerA.previous].next = formerB.next;
    steps[formerB.next].previous = formerA.previous;
    steps[formerB.previous].next = formerA.next;
    steps[formerA.next].previous = formerB.previous;
    a.isGone = b.isGone = true;
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
      out_.points.push_back(points_[p].place);
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
    for (const Segment& s : segments_) {
      const int from = root(s.points[0]), to = root(s.points[1]);
      if (from == to) continue;
      if (isMerged(from) || isMerged(to))
        stack(from, to, s.labels[0], s.labels[1], s.face);
      else
        out_.segments.push_back({{outPoint(from), outPoint(to)}, s.labels, s.face, -1});
    }
    for (const RingStep& step : boundarySteps_)
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
    const int n = static_cast<int>(out_.points.size());
    std::vector<int> incoming(n, -1), outgoing(n, -1), degree(n, 0);
    for (int s = 0; s < static_cast<int>(out_.segments.size()); ++s) {
      const auto& segment = out_.segments[s];
      outgoing[segment.points[0]] = s;
      incoming[segment.points[1]] = s;
      ++degree[segment.points[0]];
      ++degree[segment.points[1]];
    }
    const auto passes = [&](int point) {
      return degree[point] == 2 && incoming[point] >= 0 && outgoing[point] >= 0 &&
             out_.segments[incoming[point]].labels == out_.segments[outgoing[point]].labels;
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
        segment = outgoing[s.points[1]];
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
  void collectVoronoiPoints(const std::vector<Outline>& loops) {
    std::vector<Sector> sectors;
    if (hasMergedPoints()) {
      for (const Outline& loop : loops) {
        const size_t n = loop.points.size();
        for (size_t i = 0; i < n; ++i)
          if (const int p = loop.points[i]; isMerged(p))
            sectors.push_back(
                {p, loop.label, loop.points[(i + n - 1) % n], loop.points[(i + 1) % n]});
      }
      std::stable_sort(sectors.begin(), sectors.end(),
                       [](const Sector& a, const Sector& b) { return a.point < b.point; });
    }
    auto first = sectors.begin();
    for (int p = 0; p < static_cast<int>(points_.size()); ++p) {
      if (first != sectors.end() && first->point == p) {
        const auto last =
            std::find_if(first, sectors.end(), [&](const Sector& s) { return s.point != p; });
        addVoronoiPoint({&*first, static_cast<size_t>(last - first)});
        first = last;
      } else if (const auto& labels = points_[p].labels;
                 labels[2] >= 0 && parent_[p] == p && !isMerged(p)) {
        addVoronoiPoint(p, {labels.begin(), labels.end()});
      }
    }
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

  void collectLoops(const std::vector<Outline>& loops) {
    std::vector<int> list;
    for (const Outline& loop : loops) {
      list.clear();
      for (const int p : loop.points) list.push_back(outPoint(p));
      out_.loops.add(list);
      out_.loopLabel.push_back(loop.label);
    }
  }

  /// Faces in order; one of which all that has any width went to one label is a region triangle
  /// after all.
  void collectCells() {
    const auto isBefore = [](const Cell& a, const Cell& b) { return a.face < b.face; };
    if (!std::is_sorted(cells_.begin(), cells_.end(), isBefore))
      std::stable_sort(cells_.begin(), cells_.end(), isBefore);
    for (auto first = cells_.begin(); first != cells_.end();) {
      const auto last =
          std::find_if(first, cells_.end(), [&](const Cell& c) { return c.face != first->face; });
      collectCells({&*first, static_cast<size_t>(last - first)});
      first = last;
    }
  }

  void collectCells(std::span<const Cell> cells) {
    const int face = cells.front().face;
    const auto isOne = [&](const Cell& c) { return c.label == cells.front().label; };
    if (std::all_of(cells.begin(), cells.end(), isOne)) {
      out_.faceLabel[face] = cells.front().label;
      return;
    }
    size_t count = 0;
    parts_.resize(std::max(parts_.size(), cells.size()));
    for (const Cell& cell : cells) {
      parts_[count].label = cell.label;
      takeFinalPoints(cell, parts_[count].points);
      if (parts_[count].points.size() >= 3) ++count;
    }
    const std::span<Outline> parts = std::span(parts_).first(count);
    const auto isCorner = [&](int point) { return isNode_[point]; };
    if (parts.size() == 1 && parts[0].points.size() == 3 &&
        std::all_of(parts[0].points.begin(), parts[0].points.end(), isCorner)) {
      out_.faceLabel[face] = parts[0].label;
      return;
    }
    for (Outline& part : parts) {
      for (int& p : part.points) p = outPoint(p);
      out_.cells.add(part.points);
      out_.cellFace.push_back(face);
      out_.cellLabel.push_back(part.label);
    }
  }

  void takeFinalPoints(const Cell& cell, std::vector<int>& list) {
    list.clear();
    for (int i = 0; i < cell.count; ++i) {
      const int p = root(cellPoints_[cell.first + i]);
      if (list.empty() || list.back() != p) list.push_back(p);
    }
    while (list.size() > 1 && list.front() == list.back()) list.pop_back();
  }

  const TriangleMesh& mesh_;
  const DistanceField& distances_;
  const FaceComplex& complex_;
  const std::span<const char> isTraced_;
  const std::span<const int> tail_, twin_;
  Diagram out_;

  std::vector<Point> points_;
  std::vector<char> isNode_;
  std::vector<int> parent_;   ///< union-find over points_
  std::vector<char> merged_;  ///< of roots: whether they stand for several points
  std::vector<int> mergedFaces_;
  std::vector<int> pointOfNode_;
  std::vector<int> firstOnSide_;  ///< per side, by its lower halfedge
  std::vector<Segment> segments_;
  std::vector<Cell> cells_;
  std::vector<int> cellPoints_;
  std::vector<BoundaryPoint> boundary_;
  std::map<int, int> firstOnBoundary_;   ///< per boundary halfedge
  std::map<int, int> boundaryIndex_;     ///< per point
  std::vector<RingStep> boundarySteps_;  ///< those with ends at merged points
  std::vector<int> outIndex_;
  std::vector<Outline> parts_;  ///< of the face at hand; those out of use keep their memory

  // For the element at hand.
  std::vector<LabelFunction> functions_;
  FaceEnvelope envelope_;
  std::vector<int> pointOfVertex_;
  std::vector<Eigen::Vector3d> baryOfVertex_;
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
  return Tracer(mesh, distances, complex, siteCount, {}).trace();
}

TracedDiagram traceFaces(const TriangleMesh& mesh, const DistanceField& distances,
                         const DiagramOptions& options, std::span<const int> faces,
                         std::span<const char> isTraced) {
  const FaceComplex complex(mesh, distances, options.detail, faces);
  const int siteCount = static_cast<int>(isTraced.size());
  return Tracer(mesh, distances, complex, siteCount, isTraced).trace();
}

}  // namespace gvd
