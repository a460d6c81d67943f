// SPDX-License-Identifier: MIT
#include "dgpc/saddle_ties.h"

#include <algorithm>
#include <cmath>

#include "base/plane.h"
#include "base/tolerances.h"
#include "dgpc/fan.h"
#include "mesh/surface_geometry.h"

namespace gvd {
namespace {

using Eigen::Vector2d;

/// Whether two points of the surface are the same, by whatever face and corners they are named.
bool areOnePlace(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  const auto areNear = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return (p - q).cwiseAbs().maxCoeff() <= kDistanceTolerance;
  };
  const int vertex = vertexAt(mesh, a);
  if (vertex >= 0 || vertexAt(mesh, b) >= 0) return vertex == vertexAt(mesh, b);
  if (a.face == b.face) return areNear(a.bary, b.bary);
  for (int i = 0; i < 3; ++i) {
    const int twin = mesh.twin(3 * a.face + i);
    if (a.bary[(i + 2) % 3] != 0 || twin < 0 || TriangleMesh::faceOf(twin) != b.face) continue;
    Eigen::Vector3d across = Eigen::Vector3d::Zero();
    across[twin % 3] = a.bary[(i + 1) % 3];
    across[(twin + 1) % 3] = a.bary[i];
    return areNear(across, b.bary);
  }
  return false;
}

/// Whether the line of sight to a view's vertex touches what limits it, before it is there.
bool touches(const Vector2d& path, const Vector2d& bound) {
  return bound != Vector2d(0, 0) && isTowards<Side::kLeft>(bound, path) &&
         isTowards<Side::kRight>(bound, path) && bound.dot(path) > 0 &&
         bound.squaredNorm() < path.squaredNorm();
}

}  // namespace

void SaddleTies::carryEverywhere() {
  DgpcField::Ties& ties = field_.ties();
  for (int v = 0; v < mesh_.vertexCount(); ++v)
    if (isOrigin(v)) ties.origins.push_back(v);
  if (ties.origins.empty()) return;
  for (const int v : ties.origins) addSource(v);
  carry({});
}

void SaddleTies::addTold(const DgpcField& field, IndexSet& scope) {
  const auto& told = field.ties().told;
  for (bool isMore = true; isMore;) {
    isMore = false;
    for (const auto& [vertex, from] : told)
      if (scope.contains(from)) isMore |= scope.add(vertex);
  }
}

/// Outside of the scope all is as it was, so ties need not be carried on again unless they come
/// from within it, or come to it.
std::vector<int> SaddleTies::carryAround(const IndexSet& scope) {
  DgpcField::Ties& ties = field_.ties();
  std::erase_if(ties.origins, [&](int v) { return scope.contains(v); });
  std::erase_if(ties.told, [&](const auto& t) { return scope.contains(t.vertex); });
  bool isOfUse = false;
  for (const int v : scope.list()) {
    if (!isOrigin(v)) continue;
    ties.origins.push_back(v);
    isOfUse = true;
  }
  if (ties.origins.empty()) return {};
  for (const int v : ties.origins) addSource(v);
  std::vector<int> told;
  for (const auto& t : ties.told) {
    told.push_back(t.vertex);
    if (limitsViews(mesh_, t.vertex)) addSource(t.vertex);
  }
  for (const int v : scope.list()) isOfUse = isOfUse || viewFromSource(v);
  if (!isOfUse) return {};
  return carry(std::move(told));
}

/// Whether labels tie at a vertex where paths bend, other than of sites in one place.
bool SaddleTies::isOrigin(int vertex) const {
  return field_.at(vertex).size() > 1 && limitsViews(mesh_, vertex) && tiesAt(vertex).size() > 1;
}

/// The labels that tie for the nearest, without those that a lower one has the place of.
std::vector<LabelledDistance> SaddleTies::tiesAt(int vertex) const {
  const auto here = field_.at(vertex);
  const double least = nearestOf(here).distance;
  std::vector<LabelledDistance> ties;
  for (const LabelledDistance& d : here) {
    const auto isInOnePlace = [&](const LabelledDistance& lower) {
      return areOnePlace(mesh_, field_.sites()[lower.label], field_.sites()[d.label]);
    };
    if (d.distance == least && std::none_of(ties.begin(), ties.end(), isInOnePlace))
      ties.push_back(d);
  }
  return ties;
}

void SaddleTies::addSource(int vertex) {
  sources_.insert({field_.nearest(vertex).distance, vertex});
}

/// Whether labels tie anywhere at this distance.
bool SaddleTies::mayBeSource(double distance) const {
  const auto least = sources_.lower_bound({distance * (1 - 4 * kDistanceTolerance), -1});
  return least != sources_.end() && least->first <= distance * (1 + 4 * kDistanceTolerance);
}

/// Carries ties from all sources to the vertices behind them but those that have been told, the
/// nearest first, so that those that are sources themselves are told before they tell others.
std::vector<int> SaddleTies::carry(std::vector<int> told) {
  std::sort(told.begin(), told.end());
  std::vector<char> isTied(field_.sites().size());  // only what these labels own is told of them
  for (const auto& [distance, v] : sources_)
    for (const LabelledDistance& d : tiesAt(v)) isTied[d.label] = true;
  std::vector<std::pair<double, int>> vertices;
  for (int v = 0; v < mesh_.vertexCount(); ++v) {
    const auto [label, distance] = field_.nearest(v);
    if (label >= 0 && isTied[label] && distance > sources_.begin()->first &&
        !std::binary_search(told.begin(), told.end(), v))
      vertices.push_back({distance, v});
  }
  std::sort(vertices.begin(), vertices.end());
  std::vector<int> changed;
  for (const auto& [distance, v] : vertices) {
    const auto from = lastPassage(v);
    if (!from || !tell(v, *from)) continue;
    changed.push_back(v);
    field_.ties().told.push_back({v, from->vertex});
    if (limitsViews(mesh_, v)) addSource(v);
  }
  return changed;
}

/// How a vertex sees the last vertex that the path to its owner bends at or touches, if that may be
/// a source.
std::optional<View> SaddleTies::viewFromSource(int vertex) const {
  const View& view = field_.view(vertex);
  if (view.halfedge < 0 || field_.nearest(vertex).label < 0) return std::nullopt;
  const Vector2d path = view.path(mesh_), none(0, 0);
  const bool touchesLeft = touches(path, view.left), touchesRight = touches(path, view.right);
  if (!touchesLeft && !touchesRight) {
    if (!view.isBent() || !mayBeSource(view.offset)) return std::nullopt;
    return view;
  }
  const Vector2d& touched =
      touchesLeft && !(touchesRight && view.right.squaredNorm() > view.left.squaredNorm())
          ? view.left
          : view.right;
  View from = view;
  from.source += touched;
  from.left = from.right = none;
  from.offset += touched.norm();
  from.detour = std::max(from.detour, 0.0f);
  if (!mayBeSource(from.offset)) return std::nullopt;
  return from;
}

/// Where that is, if the way there can be found.
auto SaddleTies::lastPassage(int vertex) -> std::optional<Passage> {
  const auto view = viewFromSource(vertex);
  if (!view) return std::nullopt;
  const auto source = straightener_.lookBack(*view, field_.sites()[field_.nearest(vertex).label]);
  if (!source) return std::nullopt;
  return Passage{*source, view->path(mesh_).norm()};
}

/// Adds the labels that tie at a vertex to those of another one, of which the path to its owner
/// comes through there. Returns whether there are any.
bool SaddleTies::tell(int vertex, const Passage& from) {
  if (!sources_.contains({field_.nearest(from.vertex).distance, from.vertex})) return false;
  const std::vector<LabelledDistance> ties = tiesAt(from.vertex);
  const int owner = field_.nearest(vertex).label;
  if (std::none_of(ties.begin(), ties.end(), [&](const auto& d) { return d.label == owner; }))
    return false;
  const double distance = field_.distanceAt(vertex, owner);
  // A geodesic may have been found since that does not come through there.
  if (distance < (ties[0].distance + from.way) * (1 - 4 * kDistanceTolerance)) return false;
  for (const LabelledDistance& d : ties)
    if (d.label != owner)
      field_.setLabel(vertex, {d.label, distance}, field_.direction(d.label, from.vertex));
  return ties.size() > 1;
}

}  // namespace gvd
