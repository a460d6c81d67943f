// SPDX-License-Identifier: MIT
#include "mesh/mesh_orientation.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

#include "gvd/error.h"
#include "mesh/counting_sort.h"

namespace gvd {
namespace {

/// Spreads the orientation of each component's first triangle breadth first, then turns the whole
/// component over if that suits the majority better.
OrientedComponents orient(const std::vector<Corners>& triangles, const std::vector<int>& twin) {
  const int count = static_cast<int>(triangles.size());
  OrientedComponents result{std::vector<int>(count, -1), std::vector<char>(count, false)};
  std::vector<int> queue;
  queue.reserve(count);
  for (int root = 0; root < count; ++root) {
    if (result.component[root] >= 0) continue;
    const std::size_t begin = queue.size();
    result.component[root] = result.components;
    queue.push_back(root);
    int flips = 0;
    for (std::size_t i = begin; i < queue.size(); ++i) {
      const int f = queue[i];
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        if (twin[h] < 0 || result.component[twin[h] / 3] >= 0) continue;
        const int neighbour = twin[h] / 3;
        const bool disagree = tailOf(triangles, h) == tailOf(triangles, twin[h]);
        result.component[neighbour] = result.components;
        result.flipped[neighbour] = static_cast<char>(result.flipped[f] != disagree);
        flips += result.flipped[neighbour];
        queue.push_back(neighbour);
      }
    }
    const int members = static_cast<int>(queue.size() - begin);
    if (2 * static_cast<std::int64_t>(flips) > members) {
      for (std::size_t i = begin; i < queue.size(); ++i) result.flipped[queue[i]] ^= 1;
    }
    ++result.components;
  }
  return result;
}

/// Cuts the edges whose two triangles disagree once some of all have been turned over.
void cutWhereOrientationsDisagree(const std::vector<Corners>& triangles,
                                  const std::vector<char>& flipped, std::vector<int>& twin,
                                  MeshRepairs& repairs) {
  for (int h = 0; h < static_cast<int>(twin.size()); ++h) {
    if (twin[h] < h) continue;  // no twin, or seen from there
    const bool disagreed = tailOf(triangles, h) == tailOf(triangles, twin[h]);
    if ((flipped[h / 3] != flipped[twin[h] / 3]) == disagreed) continue;
    twin[twin[h]] = -1;
    twin[h] = -1;
    ++repairs.orientationCuts;
  }
}

/// Turns the flipped triangles over: (a, b, c) becomes (a, c, b), so that side i becomes side 2 -
/// i. The sides keep their neighbours.
void turnOver(const std::vector<char>& flipped, std::vector<Corners>& triangles,
              std::vector<int>& twin) {
  const auto moved = [&](int h) { return flipped[h / 3] ? h - h % 3 + (2 - h % 3) : h; };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!flipped[t]) continue;
    std::swap(triangles[t][1], triangles[t][2]);
    std::swap(twin[3 * t], twin[3 * t + 2]);
  }
  for (int& h : twin) {
    if (h >= 0) h = moved(h);
  }
}

}  // namespace

std::vector<int> matchHalfedges(const std::vector<Corners>& triangles, int vertexCount,
                                MeshRepairs& repairs) {
  const int halfedgeCount = 3 * static_cast<int>(triangles.size());
  std::vector<std::pair<int, int>> ends(halfedgeCount);
  for (int h = 0; h < halfedgeCount; ++h) {
    ends[h] = std::minmax({tailOf(triangles, h), tipOf(triangles, h)});
  }
  std::vector<int> order(halfedgeCount);
  std::iota(order.begin(), order.end(), 0);
  order = countingSort(order, vertexCount, [&](int h) { return ends[h].second; });
  order = countingSort(order, vertexCount, [&](int h) { return ends[h].first; });

  std::vector<int> twin(halfedgeCount, -1);
  forEachRun(
      order, [&](int g, int h) { return ends[g] == ends[h]; },
      [&](std::span<const int> run) {
        if (run.size() == 2) {
          twin[run[0]] = run[1];
          twin[run[1]] = run[0];
        } else if (run.size() > 2) {
          ++repairs.nonManifoldEdges;
        }
      });
  return twin;
}

OrientedComponents orientTriangles(std::vector<Corners>& triangles, std::vector<int>& twin,
                                   Orientation orientation, MeshRepairs& repairs) {
  if (orientation == Orientation::kKeep) {
    const std::vector<char> none(triangles.size(), false);
    cutWhereOrientationsDisagree(triangles, none, twin, repairs);
  }
  OrientedComponents oriented = orient(triangles, twin);
  cutWhereOrientationsDisagree(triangles, oriented.flipped, twin, repairs);
  turnOver(oriented.flipped, triangles, twin);
  return oriented;
}

void dropSmallComponents(int least, Selection& selection, std::vector<int>& twin,
                         OrientedComponents& oriented, MeshRepairs& repairs) {
  std::vector<int> size(oriented.components, 0);
  for (const int component : oriented.component) ++size[component];
  std::vector<int> newComponent(size.size(), -1);
  int components = 0;
  for (std::size_t c = 0; c < size.size(); ++c)
    if (size[c] >= least) newComponent[c] = components++;
  if (components == oriented.components) return;
  if (components == 0)
    throw Error(ErrorCode::kInvalidMesh,
                "no component has " + std::to_string(least) + " triangles: the largest has " +
                    std::to_string(*std::max_element(size.begin(), size.end())));
  repairs.smallComponents = oriented.components - components;

  // Triangles that stay move up in all lists.
  const int count = static_cast<int>(oriented.component.size());
  std::vector<int> newTriangle(count, -1);
  int kept = 0;
  for (int t = 0; t < count; ++t) {
    const int component = newComponent[oriented.component[t]];
    if (component < 0) continue;
    newTriangle[t] = kept;
    oriented.component[kept] = component;
    oriented.flipped[kept] = oriented.flipped[t];
    selection.input[kept] = selection.input[t];
    selection.corners[kept] = selection.corners[t];
    for (int i = 0; i < 3; ++i) twin[3 * kept + i] = twin[3 * t + i];
    ++kept;
  }
  repairs.smallComponentTriangles = count - kept;
  oriented.components = components;
  oriented.component.resize(kept);
  oriented.flipped.resize(kept);
  selection.input.resize(kept);
  selection.corners.resize(kept);
  twin.resize(3 * static_cast<std::size_t>(kept));
  for (int& h : twin)
    if (h >= 0) h = 3 * newTriangle[h / 3] + h % 3;
  for (int& t : selection.kept)
    if (t >= 0) t = newTriangle[t];
}

Fans splitFans(const std::vector<Corners>& triangles, const std::vector<int>& twin,
               int inputVertexCount, MeshRepairs& repairs) {
  const int halfedgeCount = 3 * static_cast<int>(triangles.size());
  Fans fans;
  std::vector<int> firstVertex(inputVertexCount, -1);  // of each representative
  for (const Corners& corners : triangles) {
    for (int representative : corners) firstVertex[representative] = 0;
  }
  for (int representative = 0; representative < inputVertexCount; ++representative) {
    if (firstVertex[representative] < 0) continue;
    firstVertex[representative] = static_cast<int>(fans.representative.size());
    fans.representative.push_back(representative);
  }

  fans.outgoing.assign(fans.representative.size(), -1);
  fans.tail.assign(halfedgeCount, -1);
  const auto clockwise = [&](int h) { return twin[h] < 0 ? -1 : TriangleMesh::next(twin[h]); };
  for (int h = 0; h < halfedgeCount; ++h) {
    if (fans.tail[h] >= 0) continue;
    const int representative = tailOf(triangles, h);
    int v = firstVertex[representative];
    if (fans.outgoing[v] >= 0) {  // another fan has it already
      v = static_cast<int>(fans.outgoing.size());
      fans.outgoing.push_back(-1);
      fans.representative.push_back(representative);
      ++repairs.splitVertices;
    }
    int first = h;
    while (clockwise(first) >= 0 && clockwise(first) != h) first = clockwise(first);
    if (clockwise(first) == h) first = h;  // a full turn: an inner vertex
    fans.outgoing[v] = first;
    int g = first;
    do {
      fans.tail[g] = v;
      g = twin[TriangleMesh::previous(g)];
    } while (g >= 0 && g != first);
  }
  return fans;
}

}  // namespace gvd
