// SPDX-License-Identifier: MIT
//
// Measures the core: how fast against Dijkstra's algorithm, how far from exact distances. The
// figures go to standard output as one JSON document, what is going on to standard error.

#include <exception>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "accuracy.h"
#include "convergence.h"
#include "gvd/sampling.h"
#include "json_writer.h"
#include "meshes.h"
#include "metrics.h"
#include "options.h"
#include "speed.h"
#include "tessellation.h"
#include "truth_case.h"

namespace gvd::bench {
namespace {

class Bench {
 public:
  Bench(const Options& options, std::ostream& out) : options_(options), json_(out) {}

  void run() {
    json_.beginObject();
    describe();
    writeList("speed", "speed", [&] {
      forEachMesh(largeMeshes(), [&](const NamedMesh& mesh) { writeSpeed(mesh); });
    });
    writeList("accuracy", "accuracy", [&] {
      if (hasOracle())
        forEachMesh(smallMeshes(), [&](const NamedMesh& mesh) { writeAccuracy(mesh); });
    });
    if (!hasOracle()) json_.text("accuracyNote", "built without CGAL");
    writeList("accuracy", "cases", [&] {
      for (const auto& path : options_.cases) writeCase(readTruthCase(path));
    });
    writeList("convergence", "byDetail", [&] {
      forEachMesh(smallMeshes(), [&](const NamedMesh& mesh) { writeDetail(mesh); });
    });
    writeList("convergence", "byRefinement", [&] {
      for (int subdivisions = 2; subdivisions <= 6; ++subdivisions) writeRefinement(subdivisions);
    });
    writeList("cvt", "tessellations", [&] {
      if (options_.tessellations.empty())
        forEachMesh(smallMeshes(), [&](const NamedMesh& mesh) { writeTessellation(mesh); });
      for (const auto& path : options_.tessellations) writeTessellation(readTruthCase(path));
    });
    json_.endObject();
  }

 private:
  void describe() {
    json_.number("sites", options_.sites);
    json_.number("seed", static_cast<double>(options_.seed));
    json_.number("runs", options_.runs);
    json_.number("detail", options_.detail);
  }

  /// A list, empty if its part is not asked for.
  template <class Write>
  void writeList(const std::string& part, const char* name, Write write) {
    json_.beginList(name);
    if (options_.parts.contains(part)) write();
    json_.endList();
  }

  /// The given meshes and the models.
  template <class Visit>
  void forEachMesh(std::vector<NamedMesh> meshes, Visit visit) {
    for (const auto& path : options_.models) meshes.push_back(modelMesh(path));
    for (const NamedMesh& mesh : meshes)
      if (mesh.name.find(options_.only) != std::string::npos) visit(mesh);
  }

  void writeSpeed(const NamedMesh& named) {
    announce(named.name);
    const TriangleMesh mesh = named.make();
    const auto sites = sampleUniform(mesh, options_.sites, options_.seed);
    const SpeedOptions speedOptions{options_.runs, options_.detail};
    json_.beginObject();
    describe(named.name, mesh);
    json_.number("dijkstra", dijkstraSeconds(mesh, sites, speedOptions));
    forEachMetric([&](Metric metric) {
      const Speed speed = measureSpeed(mesh, sites, metric, speedOptions);
      json_.number("distances", speed.distances);
      json_.number("diagram", speed.diagram);
      json_.number("partition", speed.partition);
      json_.number("change", speed.change);
      json_.number("bytes", speed.bytes);
    });
    json_.endObject();
    if (!options_.meshFolder.empty()) writeGlb(mesh, options_.meshFolder / (named.name + ".glb"));
  }

  void writeAccuracy(const NamedMesh& named) {
    const TriangleMesh mesh = named.make();
    if (mesh.faceCount() > options_.oracleFaces) return;
    announce(named.name + " and CGAL");
    const auto sites = sampleUniform(mesh, options_.oracleSites, options_.seed);
    const auto points = sampleUniform(mesh, options_.oraclePoints, options_.seed + 1);
    const auto truth = trueNearest(mesh, sites, points);
    json_.beginObject();
    describe(named.name, mesh);
    json_.number("sites", options_.oracleSites);
    writeScores(mesh, sites, points, truth);
    json_.endObject();
  }

  void writeCase(const TruthCase& truth) {
    announce(truth.name);
    const TriangleMesh mesh = readGlb(truth.mesh);
    json_.beginObject();
    describe(truth.name, mesh);
    json_.number("sites", static_cast<double>(truth.sites.size()));
    writeScores(mesh, ofMesh(mesh, truth.sites), ofMesh(mesh, truth.points), truth.nearest);
    json_.endObject();
  }

  void writeScores(const TriangleMesh& mesh, const std::vector<SurfacePoint>& sites,
                   const std::vector<SurfacePoint>& points, const std::vector<TrueNearest>& truth) {
    json_.number("points", static_cast<double>(points.size()));
    forEachMetric([&](Metric metric) {
      const Score result = score(*distances(mesh, sites, metric), points, truth);
      json_.number("mislabelled", result.mislabelledShare());
      json_.number("meanError", result.meanError);
    });
  }

  void writeDetail(const NamedMesh& named) {
    constexpr int kMostDetail = 4;
    const TriangleMesh mesh = named.make();
    if (mesh.faceCount() > options_.oracleFaces) return;
    announce(named.name + " in detail");
    const auto sites = sampleUniform(mesh, options_.oracleSites, options_.seed);
    const DetailStudy study(mesh, sites, options_.seed + 1);
    json_.beginObject();
    describe(named.name, mesh);
    json_.number("sites", options_.oracleSites);
    forEachMetric([&](Metric metric) {
      json_.beginList("mislabelled");
      for (const double share : study.mislabelled(metric, kMostDetail)) json_.number({}, share);
      json_.endList();
    });
    json_.endObject();
  }

  void writeRefinement(int subdivisions) {
    constexpr int kPoints = 200'000;
    const SphereCase sphere =
        sphereCase(subdivisions, options_.oracleSites, kPoints, options_.seed);
    announce("sphere of " + std::to_string(sphere.mesh.faceCount()) + " faces");
    json_.beginObject();
    describe("sphere", sphere.mesh);
    json_.number("sites", options_.oracleSites);
    writeScores(sphere.mesh, sphere.sites, sphere.points, sphere.nearest);
    json_.endObject();
  }

  void writeTessellation(const NamedMesh& named) {
    constexpr int kPoints = 20'000;
    const TriangleMesh mesh = named.make();
    if (mesh.faceCount() > options_.oracleFaces) return;
    writeTessellation(named.name, mesh, sampleUniform(mesh, options_.oracleSites, options_.seed),
                      sampleUniform(mesh, kPoints, options_.seed + 1));
  }

  void writeTessellation(const TruthCase& start) {
    const TriangleMesh mesh = readGlb(start.mesh);
    writeTessellation(start.name, mesh, ofMesh(mesh, start.sites), ofMesh(mesh, start.points));
  }

  void writeTessellation(const std::string& name, const TriangleMesh& mesh,
                         const std::vector<SurfacePoint>& sites,
                         const std::vector<SurfacePoint>& points) {
    announce("tessellation of " + name);
    json_.beginObject();
    describe(name, mesh);
    json_.number("sites", static_cast<double>(sites.size()));
    json_.beginObject("methods");
    for (const auto& [method, title] :
         {std::pair(CvtMethod::kLbfgs, "lbfgs"), std::pair(CvtMethod::kLloyd, "lloyd")}) {
      const TessellationScore score = measureTessellation(mesh, sites, points, method);
      json_.beginObject(title);
      json_.beginList("energy");
      for (const double energy : score.energy) json_.number({}, energy);
      json_.endList();
      json_.number("diagrams", score.diagrams);
      json_.endObject();
    }
    json_.endObject();
    json_.endObject();
  }

  void describe(const std::string& name, const TriangleMesh& mesh) {
    json_.text("name", name);
    json_.number("faces", mesh.faceCount());
  }

  /// Measures into one object per metric. What fails says so there, and the rest goes on.
  template <class Measure>
  void forEachMetric(Measure measure) {
    json_.beginObject("metrics");
    for (const auto& [name, metric] : kMetrics) {
      json_.beginObject(name);
      try {
        measure(metric);
      } catch (const std::exception& error) {
        json_.text("note", error.what());
      }
      json_.endObject();
    }
    json_.endObject();
  }

  static std::vector<SurfacePoint> ofMesh(const TriangleMesh& mesh,
                                          std::vector<SurfacePoint> points) {
    for (SurfacePoint& p : points) p = mesh.fromInput(p);
    return points;
  }

  static void announce(const std::string& what) { std::cerr << what << std::endl; }

  const Options& options_;
  JsonWriter json_;
};

}  // namespace
}  // namespace gvd::bench

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments == std::vector<std::string>{"--help"}) {
    std::cout << gvd::bench::kUsage;
    return 0;
  }
  try {
    const auto options = gvd::bench::parseOptions(arguments);
    gvd::bench::Bench(options, std::cout).run();
  } catch (const std::exception& error) {
    std::cerr << "gvd_bench: " << error.what() << '\n';
    return 1;
  }
}
