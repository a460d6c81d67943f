// SPDX-License-Identifier: MIT
#include "mesh/building/t_junctions.h"

#include <algorithm>
#include <tuple>

#include "base/sorting.h"
#include "mesh/given_triangles.h"

namespace gvd {

bool TJunctionFilling::step(long& budget) {
  return sequence_.run(
      forEach(3 * faces_.size(), budget, kQuickRounds, [&](int h) { addEdge(h); }),
      [&] { tree_.emplace(std::move(inSpace_)); }, [&] { return tree_->step(budget); },
      forItems(vertices_.list(), budget, 1, [&](int v) { findEdgeOf(v); }),
      [&] {
        sortStably(std::span(found_), [](const Junction& a, const Junction& b) {
          return std::tie(a.halfedge, a.share) < std::tie(b.halfedge, b.share);
        });
      },
      forEach(found_, budget, kQuickRounds, [&](int i) { return fillEdgeOf(i); }));
}

void TJunctionFilling::addEdge(int h) {
  if (faces_[h / 3].twins[h % 3] >= 0) return;
  edges_.push_back(h);
  const Eigen::Vector3d tail = positionOf(positions_, tailOf(faces_, h));
  const Eigen::Vector3d tip = positionOf(positions_, tipOf(faces_, h));
  inSpace_.push_back({tail, tip, tip});
  vertices_.add(tailOf(faces_, h));
  vertices_.add(tipOf(faces_, h));
}

void TJunctionFilling::findEdgeOf(int vertex) {
  const NearestOfTriangles nearest =
      tree_->nearest(positionOf(positions_, vertex), tolerance_, [&](int edge) {
        const Corners& corners = faces_[edges_[edge] / 3].vertices;
        return std::find(corners.begin(), corners.end(), vertex) == corners.end();
      });
  if (nearest.triangle >= 0)
    found_.push_back({edges_[nearest.triangle], 1 - nearest.bary[0], vertex});
}

/// Fills along the edge of a junction, if it is the first one there. Returns how many quick rounds
/// it took.
long TJunctionFilling::fillEdgeOf(int index) {
  const int h = found_[index].halfedge;
  if (index > 0 && found_[index - 1].halfedge == h) return 1;
  std::vector<Junction> points = {{h, 0, tailOf(faces_, h)}};
  for (auto next = found_.begin() + index; next != found_.end() && next->halfedge == h; ++next)
    points.push_back(*next);
  points.push_back({h, 1, tipOf(faces_, h)});
  fill(points);
  return static_cast<long>(points.size());
}

/// Fills between the edge from the first point to the last and those from each point to the next.
/// Halves the points, so that lines across the edge cross few flat triangles.
void TJunctionFilling::fill(std::span<const Junction> points) {
  if (points.size() == 2) return;
  const std::size_t middle = points.size() / 2;
  FlatTriangle flat;
  flat.beside = points[0].halfedge / 3;
  const int side = points[0].halfedge % 3;
  int i = 0;
  for (const Junction& point : {points.back(), points.front(), points[middle]}) {
    flat.vertices[i] = point.vertex;
    flat.corners.col(i++) = (1 - point.share) * Eigen::Vector3d::Unit(side) +
                            point.share * Eigen::Vector3d::Unit(cornerAfter(side));
  }
  out_.push_back(flat);
  fill(points.first(middle + 1));
  fill(points.subspan(middle));
}

}  // namespace gvd
