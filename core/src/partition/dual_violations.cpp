// SPDX-License-Identifier: MIT
// This work is based on:
// Herbert Edelsbrunner, Nimish Shah. Triangulating Topological Spaces. 1997
#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "base/index_set.h"
#include "base/sorting.h"
#include "mesh/corners.h"
#include "partition/dual_parts.h"

namespace gvd {
namespace {

/// "2 outlines", "1 outline".
std::string counted(int count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// "regions 1, 4 and 7".
std::string regions(const std::vector<int>& labels) {
  std::string list = labels.size() == 1 ? "region " : "regions ";
  for (size_t i = 0; i < labels.size(); ++i)
    list += (i == 0 ? "" : i + 1 < labels.size() ? ", " : " and ") + std::to_string(labels[i]);
  return list;
}

class Inspector {
 public:
  Inspector(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, const Diagram& diagram,
            const Partition& partition, const RegionComplex& complex)
      : mesh_(mesh), sites_(sites), diagram_(diagram), partition_(partition), complex_(complex) {}

  std::vector<Finding> inspect() {
    inspectComponents();
    for (const RegionPatch& region : partition_.regions)
      if (sites_[region.label].face >= 0) inspectRegion(region);
    inspectPairs();
    inspectTriples();
    inspectBoundary();
    if (found_.empty()) inspectDual();
    sortStably(std::span(found_), [](const Finding& a, const Finding& b) {
      return std::tie(a.violation.kind, a.violation.labels) <
             std::tie(b.violation.kind, b.violation.labels);
    });
    return std::move(found_);
  }

 private:
  void add(Violation::Kind kind, std::vector<int> labels, std::string message,
           std::vector<int> triangles = {}) {
    found_.push_back({{kind, std::move(labels), std::move(message)}, std::move(triangles)});
  }

  static std::vector<int> trianglesOf(const RegionPatch& region) {
    std::vector<int> triangles(region.triangleCount);
    std::iota(triangles.begin(), triangles.end(), region.firstTriangle);
    return triangles;
  }

  void addBeside(int h, std::vector<int>& triangles) const {
    triangles.push_back(h / 3);
    if (partition_.twins[h] >= 0) triangles.push_back(partition_.twins[h] / 3);
  }

  void addBeside(const RegionComplex::Border& border, std::vector<int>& triangles) const {
    for (const int h : border.path) addBeside(h, triangles);
  }

  void addAround(int vertex, std::vector<int>& triangles) const {
    for (const int b : complex_.vertices[vertex].borders)
      addBeside(complex_.borders[b].path.front(), triangles);
  }

  void inspectComponents() {
    std::map<int, int> bareFaces;  // by component, its first face
    for (int f = 0; f < mesh_.faceCount(); ++f)
      if (diagram_.faceLabel[f] == Diagram::kUnreachable) bareFaces.emplace(mesh_.component(f), f);
    for (const auto& [component, face] : bareFaces) {
      add(Violation::kUnreachable, {},
          "no site is on component " + std::to_string(component) + " of the mesh");
      found_.back().bareFace = face;
    }
  }

  void inspectRegion(const RegionPatch& region) {
    if (region.triangleCount == 0) {
      add(Violation::kNoRegion, {region.label},
          "site " + std::to_string(region.label) + " has no region: another site is at its place");
      return;
    }
    const std::string name = regions({region.label});
    if (region.components != 1 || region.loops != 1 || region.genus != 0)
      add(Violation::kNoDisk, {region.label},
          name + " is no disk: it has " + counted(region.components, "component") + ", " +
              counted(region.loops, "outline") + " and genus " + std::to_string(region.genus),
          trianglesOf(region));
    if (region.selfTouchings > 0)
      add(Violation::kTouchesItself, {region.label},
          name + " touches itself in " + counted(region.selfTouchings, "point"),
          trianglesOf(region));
  }

  /// The regions around a vertex in ascending order, each once.
  std::vector<int> labelSet(int vertex) const {
    std::vector<int> labels = complex_.labelsAt(vertex);
    makeSet(labels);
    return labels;
  }

  /// Where two regions meet.
  struct Meeting {
    std::vector<const RegionComplex::Border*> borders;
    std::vector<int> vertices;
  };
  using Meetings = std::map<std::pair<int, int>, Meeting>;

  void inspectPairs() {
    Meetings meetings;
    for (const RegionComplex::Border& border : complex_.borders) {
      if (border.beyond < border.label) continue;  // the outside, or counted from the other side
      meetings[{border.label, border.beyond}].borders.push_back(&border);
      if (border.fromVertex >= 0) continue;
      std::vector<int> triangles;
      addBeside(border, triangles);
      add(Violation::kClosedBorder, {border.label, border.beyond},
          regions({border.label, border.beyond}) + " meet along a closed curve",
          std::move(triangles));
    }
    for (int v = 0; v < static_cast<int>(complex_.vertices.size()); ++v)
      countMeetingsAt(v, meetings);
    for (const auto& [labels, meeting] : meetings) {
      const size_t count = meeting.borders.size() + meeting.vertices.size();
      if (count == 1) continue;
      std::vector<int> triangles;
      for (const auto* border : meeting.borders) addBeside(*border, triangles);
      for (const int v : meeting.vertices) addAround(v, triangles);
      add(Violation::kTwoMeetTwice, {labels.first, labels.second},
          regions({labels.first, labels.second}) + " meet in " + std::to_string(count) + " places",
          std::move(triangles));
    }
  }

  /// Counts pairs of regions that meet at a vertex, but in none of the arcs that end there.
  void countMeetingsAt(int v, Meetings& meetings) const {
    const auto around = complex_.labelsAt(v);
    if (around.size() <= 3 && !complex_.vertices[v].isOnBoundary()) return;
    std::set<std::pair<int, int>> inArcs;
    for (size_t i = 0; i < around.size(); ++i) {
      if (i + 1 == around.size() && complex_.vertices[v].isOnBoundary()) break;
      inArcs.insert(std::minmax(around[i], around[(i + 1) % around.size()]));
    }
    const auto labels = labelSet(v);
    for (size_t i = 0; i < labels.size(); ++i)
      for (size_t k = i + 1; k < labels.size(); ++k)
        if (!inArcs.contains({labels[i], labels[k]}))
          meetings[{labels[i], labels[k]}].vertices.push_back(v);
  }

  /// Finds pairs of vertices that have three or more regions in common. Only vertices that share
  /// the two lowest of these are compared; two regions rarely share more than the ends of one arc.
  void inspectTriples() {
    std::vector<std::vector<int>> labels;
    std::map<std::pair<int, int>, std::vector<int>> verticesOf;  // two regions
    for (int v = 0; v < static_cast<int>(complex_.vertices.size()); ++v) {
      labels.push_back(labelSet(v));
      const std::vector<int>& around = labels.back();
      for (size_t i = 0; i < around.size(); ++i)
        for (size_t k = i + 1; k < around.size(); ++k)
          verticesOf[{around[i], around[k]}].push_back(v);
    }
    std::map<std::vector<int>, std::vector<int>> found;  // regions → triangles
    std::vector<int> common;
    for (const auto& [lowest, vertices] : verticesOf)
      for (size_t i = 0; i < vertices.size(); ++i)
        for (size_t k = i + 1; k < vertices.size(); ++k) {
          const auto &a = labels[vertices[i]], &b = labels[vertices[k]];
          common.clear();
          std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
          if (common.size() < 3 || std::pair(common[0], common[1]) != lowest) continue;
          for (const int v : {vertices[i], vertices[k]}) addAround(v, found[common]);
        }
    for (const auto& [three, triangles] : found)
      add(Violation::kThreeMeetTwice, three,
          regions(three) + " meet in more than one Voronoi point", triangles);
  }

  /// Checks the loops of the mesh boundary: those with vertices run by run, then those without.
  void inspectBoundary() {
    std::vector<char> isWalked(complex_.vertices.size(), false);
    for (int start = 0; start < static_cast<int>(complex_.vertices.size()); ++start) {
      if (isWalked[start] || !complex_.vertices[start].isOnBoundary()) continue;
      std::vector<int> labels, triangles;
      for (int v = start; !isWalked[v];) {
        isWalked[v] = true;
        const RegionComplex::Border& run = complex_.borders[complex_.vertices[v].borders.front()];
        labels.push_back(run.label);
        addBeside(run, triangles);
        v = run.toVertex;
      }
      if (labels.size() >= 3) continue;
      makeSet(labels);
      addFewRuns(labels, std::move(triangles));
    }
    for (const RegionComplex::Border& border : complex_.borders) {
      if (border.beyond != RegionComplex::kOutside || border.fromVertex >= 0) continue;
      std::vector<int> triangles;
      addBeside(border, triangles);
      addFewRuns({border.label}, std::move(triangles));
    }
  }

  void addFewRuns(const std::vector<int>& labels, std::vector<int> triangles) {
    add(Violation::kFewRuns, labels, "a loop of the mesh boundary passes only " + regions(labels),
        std::move(triangles));
  }

  void inspectDual() {
    const PolygonTopology dual = topologyOf(buildDual(mesh_, sites_, partition_, complex_));
    const MeshTopology& surface = mesh_.topology();
    if (!dual.isManifold || dual.eulerCharacteristic != surface.eulerCharacteristic ||
        dual.boundaryLoops != surface.boundaryLoops || dual.components != surface.components)
      add(Violation::kNoManifold, {}, "the dual is no manifold of the surface's topology");
  }

  const TriangleMesh& mesh_;
  const std::span<const SurfacePoint> sites_;
  const Diagram& diagram_;
  const Partition& partition_;
  const RegionComplex& complex_;
  std::vector<Finding> found_;
};

}  // namespace

std::vector<Finding> inspect(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                             const Diagram& diagram, const Partition& partition,
                             const RegionComplex& complex) {
  return Inspector(mesh, sites, diagram, partition, complex).inspect();
}

std::unique_ptr<SlicedWork<std::vector<Violation>>> startViolations(
    const TriangleMesh& mesh, std::span<const SurfacePoint> sites, const Diagram& diagram) {
  return fromRegions(mesh, diagram,
                     [&mesh, sites = sitesOf(mesh, diagram, sites), &diagram](
                         const Partition& partition, const RegionComplex& complex) {
                       std::vector<Violation> violations;
                       for (Finding& finding : inspect(mesh, sites, diagram, partition, complex))
                         violations.push_back(std::move(finding.violation));
                       return violations;
                     });
}

std::vector<Violation> findViolations(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                      const Diagram& diagram) {
  return finished(startViolations(mesh, sites, diagram));
}

}  // namespace gvd
