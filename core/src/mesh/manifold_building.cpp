// SPDX-License-Identifier: MIT
#include "mesh/manifold_building.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "gvd/error.h"

namespace gvd {

// --- Twins -------------------------------------------------------------------------------------

bool HalfedgeMatching::step(long& budget) {
  const int count = 3 * static_cast<int>(triangles_.size());
  const auto lowerEnd = [&](int h) {
    return std::min(tailOf(triangles_, h), tipOf(triangles_, h));
  };
  return sequence_.run([&] { return fillInSlices(twin_, count, -1, budget); },
                       [&] { return byLowerEnd_.run(count, vertexCount_, lowerEnd, budget); },
                       [&] {
                         return loop_.run(vertexCount_, budget, 2,
                                          [&](int group) { match(byLowerEnd_.items(group)); });
                       });
}

/// Pairs the halfedges with one lower end by their higher ends.
void HalfedgeMatching::match(std::span<int> halfedges) {
  const auto higherEnd = [&](int h) {
    return std::max(tailOf(triangles_, h), tipOf(triangles_, h));
  };
  std::sort(halfedges.begin(), halfedges.end(),
            [&](int g, int h) { return higherEnd(g) < higherEnd(h); });
  forEachRun(
      halfedges, [&](int g, int h) { return higherEnd(g) == higherEnd(h); },
      [&](std::span<const int> run) {
        if (run.size() == 2) {
          twin_[run[0]] = run[1];
          twin_[run[1]] = run[0];
        } else if (run.size() > 2) {
          ++repairs_.nonManifoldEdges;
        }
      });
}

// --- Orientation -------------------------------------------------------------------------------

bool TriangleOrienting::step(long& budget) {
  const std::size_t count = triangles_.size();
  const auto cutEdges = [&] {
    return loop_.run(twin_.size(), budget, kQuickRounds, [&](int h) { cutIfInconsistent(h); });
  };
  return sequence_.run(
      [&] { return fillInSlices(out_.flipped, count, '\0', budget); },
      [&] { return orientation_ == Orientation::kUnify || cutEdges(); },
      [&] { return fillInSlices(out_.component, count, -1, budget); },
      [&] {
        queue_.reserve(count);
        return loop_.run(count, budget, 8, [&](int i) { visit(i); });
      },
      [&] {
        endComponent();
        release(queue_);
      },
      [&] {
        return loop_.run(count, budget, kQuickRounds, [&](int t) {
          if (isComponentTurned_[out_.component[t]]) out_.flipped[t] ^= 1;
        });
      },
      cutEdges,
      // Side i of a triangle that is turned over becomes side 2 - i. The sides keep their
      // neighbours.
      [&] { return loop_.run(count, budget, kQuickRounds, [&](int t) { turnOver(t); }); },
      [&] {
        return loop_.run(twin_.size(), budget, kQuickRounds, [&](int h) {
          int& twin = twin_[h];
          if (twin >= 0 && out_.flipped[twin / 3]) twin += 2 - 2 * (twin % 3);
        });
      });
}

/// Whether both triangles of an edge run along it in the same direction.
bool TriangleOrienting::disagree(int h) const {
  return tailOf(triangles_, h) == tailOf(triangles_, twin_[h]);
}

/// Cuts an edge if its two triangles disagree even when those marked in `flipped` are turned over.
void TriangleOrienting::cutIfInconsistent(int h) {
  const int twin = twin_[h];
  if (twin < h) return;  // no twin, or handled with the twin
  if ((out_.flipped[h / 3] != out_.flipped[twin / 3]) == disagree(h)) return;
  twin_[twin] = twin_[h] = -1;
  ++repairs_.orientationCuts;
}

/// Visits the next triangle, breadth first: the orientation of a component's first triangle spreads
/// over the component.
void TriangleOrienting::visit(int index) {
  if (static_cast<std::size_t>(index) == queue_.size()) {
    endComponent();
    while (out_.component[nextRoot_] >= 0) ++nextRoot_;
    out_.component[nextRoot_] = out_.components++;
    queue_.push_back(nextRoot_);
  }
  const int f = queue_[index];
  for (int h = 3 * f; h < 3 * f + 3; ++h) {
    if (twin_[h] < 0 || out_.component[twin_[h] / 3] >= 0) continue;
    const int neighbour = twin_[h] / 3;
    out_.component[neighbour] = out_.component[f];
    out_.flipped[neighbour] = static_cast<char>((out_.flipped[f] != 0) != disagree(h));
    flips_ += out_.flipped[neighbour];
    queue_.push_back(neighbour);
  }
}

/// If most triangles of a component are marked as turned over, the others are turned over instead.
void TriangleOrienting::endComponent() {
  const std::size_t members = queue_.size() - firstOfComponent_;
  if (members > 0)
    isComponentTurned_.push_back(static_cast<char>(2 * static_cast<std::size_t>(flips_) > members));
  firstOfComponent_ = queue_.size();
  flips_ = 0;
}

void TriangleOrienting::turnOver(int t) {
  if (!out_.flipped[t]) return;
  std::swap(triangles_[t][1], triangles_[t][2]);
  std::swap(twin_[3 * t], twin_[3 * t + 2]);
}

// --- Small components --------------------------------------------------------------------------

bool SmallComponents::step(long& budget) {
  return least_ <= 1 ||
         sequence_.run([&] { return fillInSlices(size_, oriented_.components, 0, budget); },
                       [&] {
                         return loop_.run(count_, budget, kQuickRounds,
                                          [&](int t) { ++size_[oriented_.component[t]]; });
                       },
                       [&] { numberAnew(); },
                       [&] { return repairs_.smallComponents == 0 || drop(budget); });
}

bool SmallComponents::drop(long& budget) {
  return dropping_.run([&] { return fillInSlices(newTriangle_, count_, -1, budget); },
                       [&] { return loop_.run(count_, budget, 8, [&](int t) { moveUp(t); }); },
                       [&] { shorten(); },
                       [&] {
                         return loop_.run(twin_.size(), budget, kQuickRounds, [&](int h) {
                           if (int& twin = twin_[h]; twin >= 0)
                             twin = 3 * newTriangle_[twin / 3] + twin % 3;
                         });
                       },
                       [&] {
                         return loop_.run(selection_.kept.size(), budget, kQuickRounds, [&](int t) {
                           if (int& kept = selection_.kept[t]; kept >= 0) kept = newTriangle_[kept];
                         });
                       });
}

void SmallComponents::numberAnew() {
  newComponent_.assign(size_.size(), -1);
  int components = 0;
  for (std::size_t c = 0; c < size_.size(); ++c)
    if (size_[c] >= least_) newComponent_[c] = components++;
  if (components == 0)
    throw Error(ErrorCode::kInvalidMesh,
                "no component has " + std::to_string(least_) + " triangles: the largest has " +
                    std::to_string(*std::max_element(size_.begin(), size_.end())));
  repairs_.smallComponents = oriented_.components - components;
  oriented_.components = components;
}

/// Moves a kept triangle towards the front of all lists.
void SmallComponents::moveUp(int t) {
  const int component = newComponent_[oriented_.component[t]];
  if (component < 0) return;
  newTriangle_[t] = kept_;
  oriented_.component[kept_] = component;
  oriented_.flipped[kept_] = oriented_.flipped[t];
  selection_.input[kept_] = selection_.input[t];
  selection_.corners[kept_] = selection_.corners[t];
  for (int i = 0; i < 3; ++i) twin_[3 * kept_ + i] = twin_[3 * t + i];
  ++kept_;
}

void SmallComponents::shorten() {
  repairs_.smallComponentTriangles = static_cast<int>(count_) - kept_;
  oriented_.component.resize(kept_);
  oriented_.flipped.resize(kept_);
  selection_.input.resize(kept_);
  selection_.corners.resize(kept_);
  twin_.resize(3 * static_cast<std::size_t>(kept_));
}

// --- Fans --------------------------------------------------------------------------------------

bool FanSplitting::step(long& budget) {
  const std::size_t halfedgeCount = 3 * triangles_.size();
  return sequence_.run(
      [&] { return fillInSlices(firstVertex_, inputVertexCount_, -1, budget); },
      [&] {
        return loop_.run(triangles_.size(), budget, 8, [&](int t) {
          for (const int representative : triangles_[t])
            used_ += std::exchange(firstVertex_[representative], 0) < 0;
        });
      },
      [&] {
        out_.representative.reserve(used_);
        return loop_.run(inputVertexCount_, budget, kQuickRounds, [&](int representative) {
          if (firstVertex_[representative] < 0) return;
          firstVertex_[representative] = static_cast<int>(out_.representative.size());
          out_.representative.push_back(representative);
        });
      },
      [&] { return fillInSlices(out_.outgoing, out_.representative.size(), -1, budget); },
      [&] { return fillInSlices(out_.tail, halfedgeCount, -1, budget); },
      [&] { return loop_.run(halfedgeCount, budget, 8, [&](int h) { takeFan(h); }); });
}

/// Gives the fan around a halfedge's tail a vertex, unless it has one.
void FanSplitting::takeFan(int h) {
  if (out_.tail[h] >= 0) return;
  const auto clockwise = [&](int g) { return twin_[g] < 0 ? -1 : TriangleMesh::next(twin_[g]); };
  const int representative = tailOf(triangles_, h);
  int v = firstVertex_[representative];
  if (out_.outgoing[v] >= 0) {  // another fan has it already
    v = static_cast<int>(out_.outgoing.size());
    out_.outgoing.push_back(-1);
    out_.representative.push_back(representative);
    ++repairs_.splitVertices;
  }
  int first = h;
  while (clockwise(first) >= 0 && clockwise(first) != h) first = clockwise(first);
  if (clockwise(first) == h) first = h;  // a full turn: an inner vertex
  out_.outgoing[v] = first;
  int g = first;
  do {
    out_.tail[g] = v;
    g = twin_[TriangleMesh::previous(g)];
  } while (g >= 0 && g != first);
}

}  // namespace gvd
