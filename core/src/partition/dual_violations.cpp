// SPDX-License-Identifier: MIT
// This work is based on:
// Herbert Edelsbrunner, Nimish Shah. Triangulating Topological Spaces. 1997
#include "partition/dual_violations.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "base/grouping.h"
#include "base/index_set.h"
#include "base/sorting.h"
#include "diagram/given_diagram.h"

namespace gvd {
namespace {

/// "2 outlines", "1 outline".
std::string countText(int count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// "regions 1, 4 and 7".
std::string regionsText(const std::vector<int>& labels) {
  std::string list = labels.size() == 1 ? "region " : "regions ";
  for (size_t i = 0; i < labels.size(); ++i)
    list += (i == 0 ? "" : i + 1 < labels.size() ? ", " : " and ") + std::to_string(labels[i]);
  return list;
}

std::vector<int> trianglesOf(const RegionPatch& region) {
  std::vector<int> triangles(region.triangleCount);
  std::iota(triangles.begin(), triangles.end(), region.firstTriangle);
  return triangles;
}

}  // namespace

ViolationFinding::ViolationFinding(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                   const Diagram& diagram, const RegionComplex& complex)
    : mesh_(mesh),
      sites_(sites),
      diagram_(diagram),
      complex_(complex),
      bareFace_(mesh.topology().components, -1),
      isWalked_(complex.vertices.size()) {}

bool ViolationFinding::step(long& budget) {
  const auto forVertices = [&](auto body) { return forEach(complex_.vertices, budget, 1, body); };
  const auto forBorders = [&](auto body) { return forEach(complex_.borders, budget, 4, body); };
  return sequence_.run(
      forEach(mesh_.faceCount(), budget, kQuickRounds, [&](int f) { findBareFace(f); }),
      [&] { addBareComponents(); },
      forItems(complex_.partition.regions, budget, 4,
               [&](const RegionPatch& region) { inspectRegion(region); }),
      [&] { return pairs_.prepare(complex_.borders.size(), budget); },
      forBorders([&](int b) { addMeetingAlong(b); }), forVertices([&](int v) { addMeetingsAt(v); }),
      [&] {
        return bordersOf_.run(
            static_cast<int>(pairOfBorder_.size()), pairs_.size(),
            [&](int b) { return pairOfBorder_[b]; }, budget);
      },
      [&] {
        return meetingsOf_.run(
            static_cast<int>(vertexMeetings_.size()), pairs_.size(),
            [&](int i) { return vertexMeetings_[i].pair; }, budget);
      },
      forEach(pairs_, budget, 1, [&](int pair) { inspectPair(pair); }),
      forEach(pairs_, budget, 1, [&](int pair) { findTriples(pair); }), [&] { addTriples(); },
      forVertices([&](int v) { inspectBoundaryFrom(v); }),
      forBorders([&](int b) { inspectClosedRun(complex_.borders[b]); }),
      [&] { return !found_.empty() || inspectDual(budget); },
      [&] {
        sortStably(std::span(found_), [](const Finding& a, const Finding& b) {
          return std::tie(a.violation.kind, a.violation.labels) <
                 std::tie(b.violation.kind, b.violation.labels);
        });
      });
}

void ViolationFinding::add(Violation::Kind kind, std::vector<int> labels, std::string message,
                           std::vector<int> triangles) {
  found_.push_back({{kind, std::move(labels), std::move(message)}, std::move(triangles)});
}

void ViolationFinding::addBeside(int h, std::vector<int>& triangles) const {
  triangles.push_back(h / 3);
  if (complex_.partition.twins[h] >= 0) triangles.push_back(complex_.partition.twins[h] / 3);
}

void ViolationFinding::addBeside(const RegionComplex::Border& border,
                                 std::vector<int>& triangles) const {
  for (const int h : border.path) addBeside(h, triangles);
}

void ViolationFinding::addAround(int vertex, std::vector<int>& triangles) const {
  for (const int b : complex_.vertices[vertex].borders)
    addBeside(complex_.borders[b].path.front(), triangles);
}

// --- Components and regions ----------------------------------------------------------------------

void ViolationFinding::findBareFace(int f) {
  if (diagram_.faceLabel[f] != Diagram::kUnreachable) return;
  int& first = bareFace_[mesh_.component(f)];
  if (first < 0) first = f;
}

void ViolationFinding::addBareComponents() {
  for (size_t component = 0; component < bareFace_.size(); ++component) {
    if (bareFace_[component] < 0) continue;
    add(Violation::kUnreachable, {},
        "no site is on component " + std::to_string(component) + " of the mesh");
    found_.back().bareFace = bareFace_[component];
  }
}

void ViolationFinding::inspectRegion(const RegionPatch& region) {
  if (sites_[region.label].face < 0) return;
  if (region.triangleCount == 0) {
    add(Violation::kNoRegion, {region.label},
        "site " + std::to_string(region.label) + " has no region: another site is at its place");
    return;
  }
  if (region.components == 1 && region.loops == 1 && region.genus == 0 && region.selfTouchings == 0)
    return;
  const std::string name = regionsText({region.label});
  if (region.components != 1 || region.loops != 1 || region.genus != 0)
    add(Violation::kNoDisk, {region.label},
        name + " is no disk: it has " + countText(region.components, "component") + ", " +
            countText(region.loops, "outline") + " and genus " + std::to_string(region.genus),
        trianglesOf(region));
  if (region.selfTouchings > 0)
    add(Violation::kTouchesItself, {region.label},
        name + " touches itself in " + countText(region.selfTouchings, "point"),
        trianglesOf(region));
}

// --- Two and three regions -----------------------------------------------------------------------

void ViolationFinding::addMeetingAlong(int b) {
  const RegionComplex::Border& border = complex_.borders[b];
  const bool isCounted = border.beyond > border.label;  // not the outside, nor the other side
  pairOfBorder_.push_back(isCounted ? pairs_.add(border.label, border.beyond) : -1);
  if (!isCounted || border.fromVertex >= 0) return;
  std::vector<int> triangles;
  addBeside(border, triangles);
  add(Violation::kClosedBorder, {border.label, border.beyond},
      regionsText({border.label, border.beyond}) + " meet along a closed curve",
      std::move(triangles));
}

/// Adds a meeting of each two regions around a vertex. Neighbours in the order around it have an
/// arc that ends there.
void ViolationFinding::addMeetingsAt(int v) {
  const std::vector<int> around = complex_.labelsAt(v);
  const size_t arcs = around.size() - complex_.vertices[v].isOnBoundary();
  std::vector<KeyedItem> withArc;
  for (size_t i = 0; i < arcs; ++i) {
    const auto [low, high] = std::minmax(around[i], around[(i + 1) % around.size()]);
    withArc.push_back({low, high});
  }
  std::sort(withArc.begin(), withArc.end());
  std::vector<int> labels = around;
  makeSet(labels);
  for (size_t i = 0; i < labels.size(); ++i)
    for (size_t k = i + 1; k < labels.size(); ++k) {
      const KeyedItem pair = {labels[i], labels[k]};
      vertexMeetings_.push_back({pairs_.add(labels[i], labels[k]), v,
                                 std::binary_search(withArc.begin(), withArc.end(), pair)});
    }
  labelsAt_.add(labels);
}

void ViolationFinding::inspectPair(int pair) {
  const auto borders = bordersOf_.items(pair), meetings = meetingsOf_.items(pair);
  const auto isPlace = [&](int i) { return !vertexMeetings_[i].hasArc; };
  const size_t count = borders.size() + std::count_if(meetings.begin(), meetings.end(), isPlace);
  if (count == 1) return;
  std::vector<int> triangles;
  for (const int b : borders) addBeside(complex_.borders[b], triangles);
  for (const int i : meetings)
    if (isPlace(i)) addAround(vertexMeetings_[i].vertex, triangles);
  const std::vector<int> labels(pairs_[pair].begin(), pairs_[pair].end());
  add(Violation::kTwoMeetTwice, labels,
      regionsText(labels) + " meet in " + std::to_string(count) + " places", std::move(triangles));
}

/// Finds pairs of vertices that have three or more regions in common, of which those of the pair
/// are the lowest; two regions rarely share more than the ends of one arc.
void ViolationFinding::findTriples(int pair) {
  const auto meetings = meetingsOf_.items(pair);
  for (size_t i = 0; i < meetings.size(); ++i)
    for (size_t k = i + 1; k < meetings.size(); ++k) {
      const int vertices[] = {vertexMeetings_[meetings[i]].vertex,
                              vertexMeetings_[meetings[k]].vertex};
      const auto a = labelsAt_[vertices[0]], b = labelsAt_[vertices[1]];
      std::vector<int> common;
      std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
      if (common.size() < 3 || common[0] != pairs_[pair][0] || common[1] != pairs_[pair][1])
        continue;
      for (const int v : vertices) addAround(v, triples_[common]);
    }
}

void ViolationFinding::addTriples() {
  for (const auto& [labels, triangles] : triples_)
    add(Violation::kThreeMeetTwice, labels,
        regionsText(labels) + " meet in more than one Voronoi point", triangles);
}

// --- Boundary and dual ---------------------------------------------------------------------------

/// Walks a loop of the mesh boundary run by run.
void ViolationFinding::inspectBoundaryFrom(int start) {
  if (isWalked_[start] || !complex_.vertices[start].isOnBoundary()) return;
  std::vector<int> labels, triangles;
  for (int v = start; !isWalked_[v];) {
    isWalked_[v] = true;
    const RegionComplex::Border& run = complex_.borders[complex_.vertices[v].borders.front()];
    labels.push_back(run.label);
    addBeside(run, triangles);
    v = run.toVertex;
  }
  if (labels.size() >= 3) return;
  makeSet(labels);
  addFewRuns(labels, std::move(triangles));
}

/// A loop of the mesh boundary without a vertex is one run.
void ViolationFinding::inspectClosedRun(const RegionComplex::Border& border) {
  if (border.beyond != RegionComplex::kOutside || border.fromVertex >= 0) return;
  std::vector<int> triangles;
  addBeside(border, triangles);
  addFewRuns({border.label}, std::move(triangles));
}

void ViolationFinding::addFewRuns(const std::vector<int>& labels, std::vector<int> triangles) {
  add(Violation::kFewRuns, labels, "a loop of the mesh boundary passes only " + regionsText(labels),
      std::move(triangles));
}

bool ViolationFinding::inspectDual(long budget) {
  return ofDual_.run(
      [&] { return runPart(dualBuilding_, budget, mesh_, sites_, complex_); },
      [&] {
        dual_ = taken(dualBuilding_);
        topology_ = startTopology(dual_);
      },
      [&] { return topology_->step(budget); },
      [&] {
        const PolygonTopology dual = topology_->take();
        const MeshTopology& surface = mesh_.topology();
        if (!dual.isManifold || dual.eulerCharacteristic != surface.eulerCharacteristic ||
            dual.boundaryLoops != surface.boundaryLoops || dual.components != surface.components)
          add(Violation::kNoManifold, {}, "the dual is no manifold of the surface's topology");
      });
}

std::vector<Violation> ViolationFinding::take() {
  std::vector<Violation> violations;
  for (Finding& finding : found_) violations.push_back(std::move(finding.violation));
  return violations;
}

std::unique_ptr<SlicedWork<std::vector<Violation>>> startViolations(
    const TriangleMesh& mesh, std::span<const SurfacePoint> sites, const Diagram& diagram) {
  return fromRegions(
      mesh, diagram,
      [&mesh, sites = sitesOf(mesh, diagram, sites), &diagram](const RegionComplex& complex) {
        return ViolationFinding(mesh, sites, diagram, complex);
      });
}

std::vector<Violation> findViolations(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                      const Diagram& diagram) {
  return finished(startViolations(mesh, sites, diagram));
}

}  // namespace gvd
