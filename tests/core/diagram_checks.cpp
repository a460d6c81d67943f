// SPDX-License-Identifier: MIT
#include "diagram_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "brute_force.h"
#include "mesh/incidence.h"

namespace gvd::checks {
namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

/// Sides from one point to another, counted.
using Sides = std::map<std::pair<int, int>, int>;

AssertionResult checkPoints(const TriangleMesh& mesh, const Diagram& d) {
  for (const SurfacePoint& p : d.points)
    if (p.face < 0 || p.face >= mesh.faceCount() || !(p.bary.minCoeff() >= 0) ||
        !(std::abs(p.bary.sum() - 1) < 1e-12))
      return AssertionFailure() << "a point is off the surface: face " << p.face << ", "
                                << p.bary.transpose();
  std::vector<char> hasSegment(d.points.size()), isInFaceOfOne(d.points.size());
  for (const Diagram::Segment& s : d.segments)
    for (const int p : s.points) {
      hasSegment[p] = true;
      isInFaceOfOne[p] |= d.points[p].face == s.face;
    }
  for (size_t p = 0; p < d.points.size(); ++p)
    if (hasSegment[p] && !isInFaceOfOne[p])
      return AssertionFailure() << "point " << p << " is named in face " << d.points[p].face
                                << ", where none of its segments is";
  std::vector<char> isUsed = hasSegment;
  for (const PointLists* lists : {&d.loops, &d.cells})
    for (const int p : lists->points) isUsed[p] = true;
  if (const auto unused = std::ranges::find(isUsed, false); unused != isUsed.end())
    return AssertionFailure() << "nothing has point " << unused - isUsed.begin();
  return AssertionSuccess();
}

AssertionResult checkAreas(const TriangleMesh& mesh, const Diagram& d) {
  double reached = 0, regions = 0;
  for (int f = 0; f < mesh.faceCount(); ++f)
    if (d.faceLabel[f] != Diagram::kUnreachable) reached += mesh.faceArea(f);
  for (const double area : d.regionArea) {
    if (!(area >= 0)) return AssertionFailure() << "a region's area is " << area;
    regions += area;
  }
  if (!(std::abs(regions - reached) <= 1e-12 * reached))
    return AssertionFailure() << "region areas sum to " << regions << ", not " << reached;
  return AssertionSuccess();
}

/// How far along a boundary halfedge a point is, if it is there. Not by places in space: vertices
/// that rounding has brought together are apart on the surface.
std::optional<double> shareOf(const TriangleMesh& mesh, int h, const SurfacePoint& p) {
  if (const int v = vertexAt(mesh, p); v >= 0) {
    if (v == mesh.tail(h)) return 0.0;
    return v == mesh.tip(h) ? std::optional(1.0) : std::nullopt;
  }
  const bool isOn = p.face == TriangleMesh::faceOf(h) && p.bary[TriangleMesh::previous(h) % 3] == 0;
  return isOn ? std::optional(p.bary[TriangleMesh::next(h) % 3]) : std::nullopt;
}

bool runsAlongBoundary(const TriangleMesh& mesh, const SurfacePoint& from, const SurfacePoint& to) {
  const auto isAlong = [&](int h) {
    if (mesh.twin(h) >= 0) return false;
    const auto begin = shareOf(mesh, h, from), end = shareOf(mesh, h, to);
    return begin && end && *end >= *begin - 1e-7;
  };
  if (const int v = vertexAt(mesh, from); v >= 0) return isAlong(mesh.outgoing(v));
  return isAlong(3 * from.face) || isAlong(3 * from.face + 1) || isAlong(3 * from.face + 2);
}

AssertionResult checkLoops(const TriangleMesh& mesh, const Diagram& d) {
  std::map<std::pair<int, int>, std::multiset<int>> steps;  // who walks from one point to another
  for (int i = 0; i < d.loops.size(); ++i) {
    const auto loop = d.loops[i];
    if (loop.size() < 2) return AssertionFailure() << "a loop of " << loop.size() << " points";
    if (i > 0 && d.loopLabel[i] < d.loopLabel[i - 1])
      return AssertionFailure() << "the loops are not ascending by label";
    for (size_t k = 0; k < loop.size(); ++k)
      steps[{loop[k], loop[(k + 1) % loop.size()]}].insert(d.loopLabel[i]);
  }
  for (const Diagram::Segment& s : d.segments) {
    if (s.labels[0] >= s.labels[1]) return AssertionFailure() << "a segment runs backwards";
    for (const int side : {0, 1}) {
      auto& walkers = steps[{s.points[side], s.points[1 - side]}];
      const auto walker = walkers.find(s.labels[side]);
      if (walker == walkers.end())
        return AssertionFailure() << "region " << s.labels[side] << " does not walk a segment of "
                                  << s.labels[0] << "|" << s.labels[1];
      walkers.erase(walker);
    }
  }
  for (const auto& [ends, walkers] : steps) {
    if (walkers.empty()) continue;
    if (!runsAlongBoundary(mesh, d.points[ends.first], d.points[ends.second]) || walkers.size() > 1)
      return AssertionFailure() << "region " << *walkers.begin()
                                << " walks where there is neither a segment nor the boundary";
  }
  return AssertionSuccess();
}

AssertionResult checkArcs(const Diagram& d) {
  size_t segments = 0;
  using Piece = std::tuple<int, int, std::array<int, 2>>;  // two points and the labels
  std::set<Piece> pieces;
  for (const Diagram::Segment& s : d.segments) pieces.insert({s.points[0], s.points[1], s.labels});
  for (int a = 0; a < d.arcs.size(); ++a) {
    const auto arc = d.arcs[a];
    segments += arc.size() - 1;
    for (size_t i = 0; i + 1 < arc.size(); ++i) {
      if (!pieces.contains({arc[i], arc[i + 1], d.arcLabels[a]}))
        return AssertionFailure() << "an arc is no chain of its bisector's segments";
    }
  }
  if (segments != d.segments.size())
    return AssertionFailure() << "arcs have " << segments << " of " << d.segments.size()
                              << " segments";
  for (const auto& v : d.voronoiPoints)
    if (std::set<int>(v.labels.begin(), v.labels.end()).size() < 3)
      return AssertionFailure() << "a Voronoi point of fewer than three labels";
  return AssertionSuccess();
}

/// The whole partition as a complex of polygons.
AssertionResult checkComplex(const TriangleMesh& mesh, const Diagram& d) {
  std::vector<int> name(d.points.size());  // mesh vertices first, then all other points
  for (size_t i = 0; i < d.points.size(); ++i) {
    Eigen::Index corner;
    const SurfacePoint& p = d.points[i];
    name[i] = p.bary.maxCoeff(&corner) == 1 ? mesh.tail(3 * p.face + static_cast<int>(corner))
                                            : mesh.vertexCount() + static_cast<int>(i);
  }
  Sides sides;
  std::set<int> points;
  int faces = 0, edges = 0;
  const auto addTriangle = [&](int f) {
    ++faces;
    for (int h = 3 * f; h < 3 * f + 3; ++h) ++sides[{mesh.tail(h), mesh.tip(h)}];
  };
  // Sides between two cells of one face are no sides of the face, though they may run between the
  // same points as one.
  const auto addCells = [&](int first, int last) {
    Sides inFace;
    for (int c = first; c < last; ++c) {
      ++faces;
      for (size_t i = 0; i < d.cells[c].size(); ++i) {
        const int from = name[d.cells[c][i]], to = name[d.cells[c][(i + 1) % d.cells[c].size()]];
        points.insert(from);
        if (const auto other = inFace.find({to, from}); other != inFace.end()) {
          ++edges;
          if (--other->second == 0) inFace.erase(other);
        } else {
          ++inFace[{from, to}];
        }
      }
    }
    for (const auto& [ends, count] : inFace) sides[ends] += count;
  };
  for (int f = 0; f < mesh.faceCount(); ++f)
    if (d.faceLabel[f] != Diagram::kMixed) addTriangle(f);
  for (int first = 0, last = 0; first < d.cells.size(); first = last) {
    while (last < d.cells.size() && d.cellFace[last] == d.cellFace[first]) ++last;
    addCells(first, last);
  }
  // Where the mesh was cut, several of its halfedges may run between the same two vertices.
  Sides ofMesh, boundary;
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    ++ofMesh[{mesh.tail(h), mesh.tip(h)}];
    boundary[{mesh.tail(h), mesh.tip(h)}] += mesh.twin(h) < 0;
  }
  int open = 0, paired = 0;
  for (const auto& [ends, count] : sides) {
    points.insert({ends.first, ends.second});
    if (count > std::max(1, ofMesh[ends]))
      return AssertionFailure() << "two parts use a side in the same direction";
    const int alone = sides.contains({ends.second, ends.first}) ? boundary[ends] : count;
    open += alone;
    paired += count - alone;
  }
  edges += open + paired / 2;
  if (mesh.topology().boundaryLoops == 0 && open > 0)
    return AssertionFailure() << open << " sides of parts have nothing beyond them";
  const int euler = static_cast<int>(points.size()) - edges + faces;
  if (euler != mesh.topology().eulerCharacteristic)
    return AssertionFailure() << "V - E + F of the partition is " << euler << ", of the mesh "
                              << mesh.topology().eulerCharacteristic;
  return AssertionSuccess();
}

/// The share of a face that rounding may give to one label or another, where sites are 1e-9 apart.
constexpr double kSliver = 1e-6;

/// A face or a part of one, with the label that owns it.
struct Part {
  int face, label;
  std::vector<Eigen::Vector3d> corners;

  Eigen::Vector3d middle() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& corner : corners) sum += corner;
    return sum / sum.sum();
  }
  /// As a share of the face's area.
  double share() const {
    double sum = 0;
    for (size_t i = 1; i + 1 < corners.size(); ++i) {
      const Eigen::Vector3d p = corners[i] - corners[0], q = corners[i + 1] - corners[0];
      sum += p[0] * q[1] - p[1] * q[0];
    }
    return sum;
  }
};

/// A point of the face or on its sides, in terms of that face.
Eigen::Vector3d baryIn(const TriangleMesh& mesh, int face, const SurfacePoint& p) {
  if (p.face == face) return p.bary;
  Eigen::Vector3d bary = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (mesh.tail(3 * face + i) == mesh.tail(3 * p.face + k)) bary[i] = p.bary[k];
  return bary;
}

std::vector<Part> reachedParts(const TriangleMesh& mesh, const Diagram& d) {
  std::vector<Part> parts;
  for (int f = 0; f < mesh.faceCount(); ++f)
    if (d.faceLabel[f] >= 0)
      parts.push_back({f, d.faceLabel[f], {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  for (int c = 0; c < d.cells.size(); ++c) {
    Part part{d.cellFace[c], d.cellLabel[c], {}};
    for (const int p : d.cells[c]) part.corners.push_back(baryIn(mesh, part.face, d.points[p]));
    parts.push_back(std::move(part));
  }
  return parts;
}

AssertionResult checkNearestAtVertices(const TriangleMesh& mesh, const DistanceField& field) {
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const int v = mesh.tail(h);
    LabelledDistance least;
    for (const LabelledDistance& d : field.at(v))
      if (d.distance < least.distance) least = d;
    const auto nearest = field.nearest({TriangleMesh::faceOf(h), Eigen::Vector3d::Unit(h % 3)});
    const bool isSame = least.label < 0 ? nearest.label < 0
                                        : std::abs(nearest.distance - least.distance) <=
                                              1e-7 * mesh.boundingDiagonal();
    if (!isSame)
      return AssertionFailure() << "nearest at vertex " << v << " is " << nearest.label << " at "
                                << nearest.distance << ", not " << least.label << " at "
                                << least.distance;
  }
  return AssertionSuccess();
}

AssertionResult checkExactDistances(const TriangleMesh& mesh, const DistanceField& field,
                                    std::span<const SurfacePoint> sites) {
  const double tolerance = 1e-9 * mesh.boundingDiagonal();
  for (int v = 0; v < mesh.vertexCount(); ++v)
    for (const LabelledDistance& d : field.at(v)) {
      const double straight = (mesh.position(v) - mesh.position(sites[d.label])).norm();
      if (!(d.distance >= straight - tolerance))
        return AssertionFailure() << "site " << d.label << " is " << d.distance
                                  << " away from vertex " << v << ", less than the straight line, "
                                  << straight;
    }
  for (size_t i = 0; i < sites.size(); ++i)
    if (const auto nearest = field.nearest(sites[i]); !(nearest.distance <= tolerance))
      return AssertionFailure() << "the nearest site at site " << i << " is " << nearest.label
                                << ", " << nearest.distance << " away";
  return AssertionSuccess();
}

}  // namespace

Traced trace(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Metric metric,
             int detail) {
  Traced traced{finished(propagate(mesh, sites, metric)), {}};
  traced.diagram = traceDiagram(mesh, *traced.field, static_cast<int>(sites.size()), {detail});
  return traced;
}

Traced traceByBruteForce(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                         Metric metric) {
  Traced traced{std::make_unique<BruteForce>(mesh, sites, metric), {}};
  traced.diagram = traceDiagram(mesh, *traced.field, static_cast<int>(sites.size()));
  return traced;
}

AssertionResult isConsistent(const TriangleMesh& mesh, const Diagram& d, int detail) {
  if (auto result = checkPoints(mesh, d); !result) return result;
  if (auto result = checkAreas(mesh, d); !result) return result;
  if (auto result = checkLoops(mesh, d); !result) return result;
  if (auto result = checkArcs(d); !result) return result;
  return detail == 0 ? checkComplex(mesh, d) : AssertionSuccess();
}

AssertionResult agreesWithField(const TriangleMesh& mesh, const Traced& traced,
                                std::span<const SurfacePoint> sites, Metric metric) {
  if (auto result = checkNearestAtVertices(mesh, *traced.field); !result) return result;
  return metric == Metric::kDgpc ? AssertionSuccess()
                                 : checkExactDistances(mesh, *traced.field, sites);
}

AssertionResult spreadsFarEnough(const TriangleMesh& mesh, const Traced& traced,
                                 const DistanceField& everywhere) {
  const double tolerance = 1e-9 * mesh.boundingDiagonal();
  const int siteCount = traced.diagram.siteCount;
  std::vector<SurfacePoint> middles;
  for (const Part& part : reachedParts(mesh, traced.diagram))
    if (part.share() > kSliver) middles.push_back({part.face, part.middle()});
  std::vector<LabelledPoint> ofAll;
  for (const SurfacePoint& p : middles)
    for (int label = 0; label < siteCount; ++label) ofAll.push_back({label, p});
  const std::vector<double> distances = everywhere.distancesAt(std::move(ofAll));
  auto ofFirst = distances.begin();
  for (const SurfacePoint& p : middles) {
    const LabelledDistance ours = traced.field->nearest(p);
    const auto expected = std::min_element(ofFirst, ofFirst + siteCount);
    if (!(std::abs(ours.distance - *expected) <= tolerance))
      return AssertionFailure() << "in face " << p.face << ", " << ours.label << " is nearest, "
                                << ours.distance << " away; by brute force " << expected - ofFirst
                                << ", " << *expected << " away";
    ofFirst += siteCount;
  }
  return AssertionSuccess();
}

AssertionResult areSame(const TriangleMesh& mesh, const Diagram& a, const Diagram& b,
                        std::span<const int> labelInB, double tolerance) {
  const auto inB = [&](int label) { return label < 0 ? label : labelInB[label]; };
  for (int f = 0; f < mesh.faceCount(); ++f)
    if (inB(a.faceLabel[f]) != b.faceLabel[f])
      return AssertionFailure() << "face " << f << " belongs to " << inB(a.faceLabel[f]) << " and "
                                << b.faceLabel[f];
  for (int l = 0; l < a.siteCount; ++l)
    if (!(std::abs(a.regionArea[l] - b.regionArea[inB(l)]) <= tolerance * mesh.area()))
      return AssertionFailure() << "region " << l << " has area " << a.regionArea[l] << " and "
                                << b.regionArea[inB(l)];
  const auto bisectors = [&](const Diagram& d, bool rename) {
    std::multiset<std::pair<int, int>> pairs;
    for (const auto& s : d.segments)
      pairs.insert(rename ? std::minmax({inB(s.labels[0]), inB(s.labels[1])})
                          : std::pair(s.labels[0], s.labels[1]));
    return pairs;
  };
  if (bisectors(a, true) != bisectors(b, false))
    return AssertionFailure() << "the bisector segments differ: " << a.segments.size() << " and "
                              << b.segments.size();
  const auto meetings = [&](const Diagram& d, bool rename) {
    std::multiset<std::vector<int>> labels;
    for (const auto& v : d.voronoiPoints) {
      std::vector<int> here;
      for (const int l : v.labels) here.push_back(rename ? inB(l) : l);
      std::rotate(here.begin(), std::min_element(here.begin(), here.end()), here.end());
      labels.insert(here);
    }
    return labels;
  };
  if (meetings(a, true) != meetings(b, false))
    return AssertionFailure() << "the Voronoi points differ: " << a.voronoiPoints.size() << " and "
                              << b.voronoiPoints.size();
  const auto outlines = [&](const Diagram& d, bool rename) {
    std::multiset<int> labels;
    for (const int l : d.loopLabel) labels.insert(rename ? inB(l) : l);
    return labels;
  };
  if (outlines(a, true) != outlines(b, false)) return AssertionFailure() << "the loops differ";
  return AssertionSuccess();
}

std::vector<int> identity(int count) {
  std::vector<int> labels(count);
  std::iota(labels.begin(), labels.end(), 0);
  return labels;
}

}  // namespace gvd::checks
