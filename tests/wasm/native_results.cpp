// SPDX-License-Identifier: MIT
//
// Writes diagrams as the native build computes them, with the meshes and sites they are of, to
// standard output: `native.test.mjs` has the WebAssembly build repeat them.

#include <array>
#include <initializer_list>
#include <iostream>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagram_checks.h"
#include "gvd/sampling.h"
#include "json_writer.h"
#include "shapes.h"

namespace gvd {
namespace {

struct NamedShape {
  std::string name;
  shapes::Shape shape;
};

/// Of every kind. No triangle is dropped or turned over: faces are the input's on both sides.
std::vector<NamedShape> allShapes() {
  std::vector<NamedShape> all = {
      {"regular grid", shapes::grid(8, 8)},
      {"needles and caps", shapes::randomTriangulation(60, 40, 1)},
      {"graded disk", shapes::gradedDisk(12, 9, 0.6)},
      {"cube", shapes::cube()},
      {"sphere", shapes::icosphere(2)},
      {"torus", shapes::torus(14, 9)},
      {"saddle", shapes::subdivided(shapes::subdivided(shapes::vertexFan(8, 7.5)))},
      {"open cylinder", shapes::cylinder(9, 5)},
      {"two components",
       shapes::joined(shapes::octahedron(), shapes::moved(shapes::grid(4, 4, 0.2, 2), {5, 0, 0}))},
  };
  for (const int genus : {0, 1, 2, 3})
    all.push_back(
        {"bumpy, genus " + std::to_string(genus), shapes::bumpySurface(genus, 2, 0.4, 10 + genus)});
  return all;
}

/// Sites at vertices: distances tie, and several bisectors meet at points and run along edges.
std::vector<SurfacePoint> cornerSites(const TriangleMesh& mesh) {
  std::vector<SurfacePoint> sites;
  for (int f = 0; f < mesh.faceCount(); f += 7) sites.push_back({f, Eigen::Vector3d::Unit(f % 3)});
  return sites;
}

std::vector<SurfacePoint> pointsToLocate(const TriangleMesh& mesh) {
  auto points = sampleUniform(mesh, 100, 99);
  for (int f = 0; f < mesh.faceCount(); ++f) points.push_back({f, Eigen::Vector3d::Unit(f % 3)});
  return points;
}

template <class Numbers>
void writeNumbers(JsonWriter& out, std::string_view name, const Numbers& numbers) {
  out.beginList(name);
  for (const double number : numbers) out.number({}, number);
  out.endList();
}

/// A list of the numbers that `numbersOf(item)` gives for each item, one after the other.
template <class Items, class NumbersOf>
void writeEach(JsonWriter& out, std::string_view name, const Items& items, NumbersOf numbersOf) {
  out.beginList(name);
  for (const auto& item : items)
    for (const double number : numbersOf(item)) out.number({}, number);
  out.endList();
}

using OneNumber = std::array<double, 1>;

void writePointArrays(JsonWriter& out, std::span<const SurfacePoint> points) {
  writeEach(out, "face", points, [](const SurfacePoint& p) { return OneNumber{double(p.face)}; });
  writeEach(out, "bary", points, [](const SurfacePoint& p) { return p.bary; });
}

void writePoints(JsonWriter& out, std::string_view name, std::span<const SurfacePoint> points) {
  out.beginObject(name);
  writePointArrays(out, points);
  out.endObject();
}

void writeLists(JsonWriter& out, const PointLists& lists) {
  writeNumbers(out, "offset", lists.offset);
  writeNumbers(out, "points", lists.points);
}

void writeVoronoiPoints(JsonWriter& out, std::span<const Diagram::VoronoiPoint> voronoiPoints) {
  std::vector<int> points, offset = {0}, labels;
  for (const auto& v : voronoiPoints) {
    points.push_back(v.point);
    labels.insert(labels.end(), v.labels.begin(), v.labels.end());
    offset.push_back(static_cast<int>(labels.size()));
  }
  out.beginObject("voronoiPoints");
  writeNumbers(out, "point", points);
  writeNumbers(out, "labelOffset", offset);
  writeNumbers(out, "labels", labels);
  out.endObject();
}

/// As `DiagramData` of the package.
void writeDiagram(JsonWriter& out, const TriangleMesh& mesh, const Diagram& d) {
  out.beginObject("data");
  out.number("siteCount", d.siteCount);
  out.beginObject("points");
  writePointArrays(out, d.points);
  writeEach(out, "position", d.points, [&](const SurfacePoint& p) { return mesh.position(p); });
  out.endObject();
  out.beginObject("segments");
  writeEach(out, "points", d.segments, [](const auto& s) { return s.points; });
  writeEach(out, "labels", d.segments, [](const auto& s) { return s.labels; });
  writeEach(out, "face", d.segments, [](const auto& s) { return OneNumber{double(s.face)}; });
  writeEach(out, "arc", d.segments, [](const auto& s) { return OneNumber{double(s.arc)}; });
  out.endObject();
  out.beginObject("arcs");
  writeLists(out, d.arcs);
  writeEach(out, "labels", d.arcLabels, [](const auto& labels) { return labels; });
  out.endObject();
  writeVoronoiPoints(out, d.voronoiPoints);
  out.beginObject("loops");
  writeLists(out, d.loops);
  writeNumbers(out, "label", d.loopLabel);
  out.endObject();
  writeNumbers(out, "regionArea", d.regionArea);
  writeNumbers(out, "faceLabel", d.faceLabel);
  writeNumbers(out, "indifferentFaces", d.indifferentFaces);
  out.beginObject("cells");
  writeLists(out, d.cells);
  writeNumbers(out, "face", d.cellFace);
  writeNumbers(out, "label", d.cellLabel);
  out.endObject();
  out.endObject();
}

/// As the package's `locate` answers; JSON has no infinity, and writes null for it.
void writeLocated(JsonWriter& out, const DistanceField& field,
                  std::span<const SurfacePoint> points) {
  std::vector<double> label, distance;
  for (const SurfacePoint& p : points) {
    const LabelledDistance nearest = field.nearest(p);
    label.push_back(nearest.label);
    distance.push_back(nearest.distance);
  }
  out.beginObject("located");
  writeNumbers(out, "label", label);
  writeNumbers(out, "distance", distance);
  out.endObject();
}

void writeResult(JsonWriter& out, const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                 std::span<const SurfacePoint> points, Metric metric, int detail) {
  const checks::Traced traced = checks::trace(mesh, sites, metric, detail);
  out.beginObject();
  out.text("metric", metric == Metric::kDgpc ? "dgpc" : "exact");
  out.number("detail", detail);
  writeDiagram(out, mesh, traced.diagram);
  writeLocated(out, *traced.field, points);
  out.endObject();
}

void writeSiteSet(JsonWriter& out, const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                  std::initializer_list<int> details) {
  const auto points = pointsToLocate(mesh);
  out.beginObject();
  writePoints(out, "sites", sites);
  writePoints(out, "points", points);
  out.beginList("results");
  for (const Metric metric : {Metric::kDgpc, Metric::kExact})
    for (const int detail : details) writeResult(out, mesh, sites, points, metric, detail);
  out.endList();
  out.endObject();
}

void writeMesh(JsonWriter& out, const NamedShape& named) {
  const TriangleMesh mesh = named.shape.mesh();
  out.beginObject();
  out.text("name", named.name);
  writeNumbers(out, "positions", named.shape.positions);
  writeNumbers(out, "indices", named.shape.triangles);
  out.beginList("siteSets");
  for (const int count : {1, 4, 25})
    writeSiteSet(out, mesh, sampleUniform(mesh, count, count), {0, 2});
  // Sites at vertices of symmetric meshes tie along whole bisectors. Between the vertices, with
  // detail, the last bit decides which of the parts there have a width.
  writeSiteSet(out, mesh, cornerSites(mesh), {0});
  out.endList();
  out.endObject();
}

}  // namespace
}  // namespace gvd

int main() {
  gvd::JsonWriter out(std::cout);
  out.beginList();
  for (const auto& shape : gvd::allShapes()) gvd::writeMesh(out, shape);
  out.endList();
}
