// SPDX-License-Identifier: MIT
#include "mesh/building/manifold_building.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "base/rejection.h"
#include "mesh/given_triangles.h"

namespace gvd {

// --- Twins -------------------------------------------------------------------------------------

bool HalfedgeMatching::step(long& budget) {
  const int count = 3 * static_cast<int>(faces_.size());
  const auto lowerEnd = [&](int h) { return std::min(tailOf(faces_, h), tipOf(faces_, h)); };
  return sequence_.run([&] { return byLowerEnd_.run(count, vertexCount_, lowerEnd, budget); },
                       [&] {
                         return byLowerEnd_.visitGroups(
                             [&](std::span<const int> group) { match(group); }, budget);
                       });
}

/// Pairs the halfedges with one lower end by their higher ends.
void HalfedgeMatching::match(std::span<const int> halfedges) {
  byHigherEnd_.clear();
  for (const int h : halfedges)
    byHigherEnd_.push_back({std::max(tailOf(faces_, h), tipOf(faces_, h)), 0, h});
  visitSame(byHigherEnd_, [&](std::span<const KeyedItem> run) {
    if (run.size() == 2) {
      twinOf(faces_, run[0][2]) = run[1][2];
      twinOf(faces_, run[1][2]) = run[0][2];
    } else if (run.size() > 2) {
      ++repairs_.nonManifoldEdges;
      std::vector<int>& edge = nonManifold_.emplace_back();
      for (const KeyedItem& item : run) edge.push_back(item[2]);
    }
  });
}

// --- Orientation -------------------------------------------------------------------------------

bool TriangleOrienting::step(long& budget) {
  const std::size_t count = faces_.size();
  return sequence_.run([&] { return fillInSlices(out_.flipped, count, '\0', budget); },
                       forEach(orientation_ == Orientation::kUnify ? 0 : 3 * count, budget,
                               kQuickRounds, [&](int h) { cutIfInconsistent(h); }),
                       [&] { return fillInSlices(out_.component, count, -1, budget); },
                       [&] { queue_.reserve(count); },
                       forEach(count, budget, 8, [&](int i) { visit(i); }),
                       [&] {
                         endComponent();
                         release(queue_);
                       },
                       forEach(count, budget, kQuickRounds,
                               [&](int t) {
                                 if (isComponentTurned_[out_.component[t]]) out_.flipped[t] ^= 1;
                                 if (out_.flipped[t]) turnOver(t);
                               }),
                       // Side i of a triangle that is turned over becomes side 2 - i. The sides
                       // keep their neighbours.
                       forEach(3 * count, budget, kQuickRounds, [&](int h) {
                         int& twin = twinOf(faces_, h);
                         if (twin >= 0 && out_.flipped[twin / 3]) twin += 2 - 2 * (twin % 3);
                       }));
}

/// Whether both triangles of an edge run along it in the same direction.
bool TriangleOrienting::disagree(int h) const {
  return tailOf(faces_, h) == tailOf(faces_, twinOf(faces_, h));
}

/// Cuts an edge if its two triangles disagree even when those marked in `flipped` are turned over.
void TriangleOrienting::cutIfInconsistent(int h) {
  const int twin = twinOf(faces_, h);
  if (twin < 0) return;
  if ((out_.flipped[h / 3] != out_.flipped[twin / 3]) == disagree(h)) return;
  twinOf(faces_, twin) = twinOf(faces_, h) = -1;
  ++repairs_.orientationCuts;
}

/// Visits the next triangle, breadth first: the orientation of a component's first triangle spreads
/// over the component.
void TriangleOrienting::visit(int index) {
  if (static_cast<std::size_t>(index) == queue_.size()) {
    endComponent();
    while (out_.component[nextRoot_] >= 0) ++nextRoot_;
    out_.component[nextRoot_] = static_cast<int>(out_.size.size());
    queue_.push_back(nextRoot_);
  }
  const int f = queue_[index];
  for (int h = 3 * f; h < 3 * f + 3; ++h) {
    const int twin = twinOf(faces_, h), neighbour = twin / 3;
    if (twin < 0) continue;
    if (out_.component[neighbour] >= 0) {
      cutIfInconsistent(h);
      continue;
    }
    out_.component[neighbour] = out_.component[f];
    out_.flipped[neighbour] = static_cast<char>((out_.flipped[f] != 0) != disagree(h));
    flips_ += out_.flipped[neighbour];
    queue_.push_back(neighbour);
  }
}

/// If most triangles of a component are marked as turned over, the others are turned over instead.
void TriangleOrienting::endComponent() {
  const int members = static_cast<int>(queue_.size() - firstOfComponent_);
  if (members == 0) return;
  isComponentTurned_.push_back(static_cast<char>(flips_ > members / 2));
  out_.size.push_back(members);
  firstOfComponent_ = queue_.size();
  flips_ = 0;
}

void TriangleOrienting::turnOver(int t) {
  TriangleMesh::Face& face = faces_[t];
  std::swap(face.vertices[1], face.vertices[2]);
  std::swap(face.twins[0], face.twins[2]);
}

// --- Stitching ---------------------------------------------------------------------------------

namespace {

void join(Faces& faces, int h, int twin) {
  twinOf(faces, h) = twin;
  twinOf(faces, twin) = h;
}

/// Joins the triangles of some halfedges of one edge, each with the next one across the inside of a
/// solid, if insides and outsides alternate around the edge.
void joinAcrossInsides(Faces& faces, std::span<const double> positions,
                       std::span<const int> halfedges) {
  const int tail = tailOf(faces, halfedges[0]), tip = tipOf(faces, halfedges[0]);
  const Eigen::Vector3d start = positionOf(positions, tail);
  const Eigen::Vector3d edge = positionOf(positions, tip) - start;
  const double length = edge.norm();
  // Counterclockwise around the edge from the first triangle. Triangles in one plane have one
  // angle, counted in steps of 1.5e-3. Of two, the one at which a solid ends comes first: the one
  // that runs from tail to tip.
  constexpr int kSteps = 4096;
  constexpr double kStepsPerRadian = kSteps / (2 * std::numbers::pi);
  std::vector<KeyedItem> around;
  const auto apexOf = [&](int h) -> Eigen::Vector3d {
    return positionOf(positions, tipOf(faces, TriangleMesh::next(h))) - start;
  };
  const Eigen::Vector3d firstNormal = edge.cross(apexOf(halfedges[0]));
  for (const int h : halfedges) {
    const Eigen::Vector3d apex = apexOf(h);
    const Eigen::Vector3d normal = edge.cross(apex);
    const double angle = std::atan2(length * firstNormal.dot(apex), firstNormal.dot(normal));
    // No number where positions are too far apart, which is told when distances are measured.
    const int steps =
        std::isnan(angle) ? 0 : static_cast<int>(std::nearbyint(kStepsPerRadian * angle));
    around.push_back({steps & (kSteps - 1), tailOf(faces, h) != tail, h});
  }
  std::sort(around.begin(), around.end());
  around.push_back(around[0]);
  for (std::size_t i = 1; i < around.size(); ++i)
    if (around[i][1] == around[i - 1][1]) return;
  for (std::size_t i = 1; i < around.size(); ++i)
    if (around[i][1] == 0) join(faces, around[i - 1][2], around[i][2]);
}

}  // namespace

void stitch(Faces& faces, const OrientedComponents& oriented, std::span<const double> positions,
            std::span<const int> halfedges) {
  std::vector<KeyedItem> byComponent;  // no second key
  for (const int h : halfedges) {
    const int f = h / 3, side = oriented.flipped[f] ? 2 - h % 3 : h % 3;
    byComponent.push_back({oriented.component[f], 0, 3 * f + side});
  }
  std::vector<int> others;
  visitSame(byComponent, [&](std::span<const KeyedItem> run) {
    if (run.size() == 2 && tailOf(faces, run[0][2]) != tailOf(faces, run[1][2]))
      return join(faces, run[0][2], run[1][2]);
    for (const KeyedItem& item : run) others.push_back(item[2]);
  });
  if (!others.empty()) joinAcrossInsides(faces, positions, others);
}

// --- Small components --------------------------------------------------------------------------

SmallComponents::SmallComponents(int least, Selection& selection, OrientedComponents& oriented,
                                 MeshRepairs& repairs)
    : count_(selection.input.size()),
      selection_(selection),
      oriented_(oriented),
      repairs_(repairs) {
  int components = 0;
  for (const int size : oriented.size) newComponent_.push_back(size < least ? -1 : components++);
  if (components == 0)
    rejectMesh("no component has " + std::to_string(least) + " triangles: the largest has " +
               std::to_string(*std::max_element(oriented.size.begin(), oriented.size.end())));
  repairs.smallComponents =
      static_cast<int>(std::erase_if(oriented.size, [&](int size) { return size < least; }));
}

bool SmallComponents::step(long& budget) {
  if (repairs_.smallComponents == 0) return true;
  Faces& faces = selection_.faces;
  return sequence_.run([&] { return fillInSlices(newTriangle_, count_, -1, budget); },
                       forEach(count_, budget, 8, [&](int t) { moveUp(t); }), [&] { shorten(); },
                       forItems(faces, budget, 8,
                                [&](TriangleMesh::Face& face) {
                                  for (int& twin : face.twins)
                                    if (twin >= 0) twin = 3 * newTriangle_[twin / 3] + twin % 3;
                                }),
                       forItems(selection_.kept, budget, kQuickRounds, [&](int& kept) {
                         if (kept >= 0) kept = newTriangle_[kept];
                       }));
}

/// Moves a kept triangle towards the front of all lists.
void SmallComponents::moveUp(int t) {
  const int component = newComponent_[oriented_.component[t]];
  if (component < 0) return;
  newTriangle_[t] = kept_;
  oriented_.component[kept_] = component;
  oriented_.flipped[kept_] = oriented_.flipped[t];
  selection_.input[kept_] = selection_.input[t];
  selection_.faces[kept_] = selection_.faces[t];
  ++kept_;
}

void SmallComponents::shorten() {
  repairs_.smallComponentTriangles = static_cast<int>(count_) - kept_;
  oriented_.component.resize(kept_);
  oriented_.flipped.resize(kept_);
  selection_.input.resize(kept_);
  selection_.faces.resize(kept_);
}

// --- Fans --------------------------------------------------------------------------------------

bool FanSplitting::step(long& budget) {
  const std::size_t halfedgeCount = 3 * faces_.size();
  return sequence_.run(
      [&] { return fillInSlices(firstVertex_, inputVertexCount_, -1, budget); },
      forItems(faces_, budget, 8,
               [&](const TriangleMesh::Face& face) {
                 for (const int representative : face.vertices)
                   used_ += std::exchange(firstVertex_[representative], 0) < 0;
               }),
      [&] { out_.representative.reserve(used_); },
      forEach(inputVertexCount_, budget, kQuickRounds,
              [&](int representative) {
                if (firstVertex_[representative] < 0) return;
                firstVertex_[representative] = static_cast<int>(out_.representative.size());
                out_.representative.push_back(representative);
              }),
      [&] { return fillInSlices(out_.outgoing, out_.representative.size(), -1, budget); },
      [&] { return fillInSlices(isInFan_, halfedgeCount, '\0', budget); },
      forEach(halfedgeCount, budget, 8, [&](int h) { takeFan(h); }));
}

/// Gives the fan around a halfedge's tail a vertex, unless it has one.
void FanSplitting::takeFan(int h) {
  if (isInFan_[h]) return;
  const int representative = tailOf(faces_, h);
  int v = firstVertex_[representative];
  if (out_.outgoing[v] >= 0) {  // another fan has it already
    v = static_cast<int>(out_.outgoing.size());
    out_.outgoing.push_back(-1);
    out_.representative.push_back(representative);
    ++repairs_.splitVertices;
  }
  const auto take = [&](int g) {
    isInFan_[g] = true;
    faces_[g / 3].vertices[g % 3] = v;
    return g;
  };
  const auto counterclockwise = [&](int g) { return twinOf(faces_, TriangleMesh::previous(g)); };
  int g = counterclockwise(take(h));
  while (g >= 0 && g != h) g = counterclockwise(take(g));
  int first = h;
  if (g < 0)  // the boundary: the other halfedges are clockwise of h
    for (int twin; (twin = twinOf(faces_, first)) >= 0;) first = take(TriangleMesh::next(twin));
  out_.outgoing[v] = first;
}

}  // namespace gvd
