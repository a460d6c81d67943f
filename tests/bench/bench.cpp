// SPDX-License-Identifier: MIT
//
// Measures the core: how fast against Dijkstra's algorithm, how far from exact distances. The
// figures go to standard output as one JSON document, what is going on to standard error.

#include <exception>
#include <filesystem>
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
    // What is wrong with a file is told before anything is measured.
    for (const auto& path : options_.meshes) readGltfMesh(path);
    writeList("speed", "speed", [&] {
      forEachMesh(largeMeshes(), [&](const NamedMesh& mesh) { writeSpeed(mesh); });
    });
    writeList("size", "size", [&] {
      forEachNamed(sizeLadder(), [&](const NamedMesh& mesh) { writeSizeStep(mesh); });
    });
    writeList("accuracy", "accuracy", [&] {
      if (hasOracle())
        forEachMesh(smallMeshes(), [&](const NamedMesh& mesh) { writeAccuracy(mesh); });
    });
    if (!hasOracle()) json_.text("accuracyNote", "built without CGAL");
    writeList("accuracy", "cases", [&] {
      forEachCase(options_.cases, [&](const TruthCase& truth) { writeCase(truth); });
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
      forEachCase(options_.tessellations,
                  [&](const TruthCase& start) { writeTessellation(start); });
    });
    json_.endObject();
  }

 private:
  void describe() {
    json_.number("seed", static_cast<double>(options_.seed));
    json_.number("runs", options_.runs);
    json_.number("detail", options_.detail);
    json_.number("subdivisions", options_.subdivisions);
  }

  /// A list, empty if its part is not asked for.
  template <class Write>
  void writeList(const std::string& part, const char* name, Write write) {
    json_.beginList(name);
    if (options_.parts.contains(part)) write();
    json_.endList();
  }

  /// Visits the given meshes, or the generated ones, as far as they are asked for.
  template <class Visit>
  void forEachMesh(std::vector<NamedMesh> generated, Visit visit) {
    std::vector<NamedMesh> meshes;
    if (options_.meshes.empty() || options_.generated) meshes = std::move(generated);
    for (const auto& path : options_.meshes) meshes.push_back(fileMesh(path));
    forEachNamed(distinctlyNamed(std::move(meshes)), visit);
  }

  template <class Visit>
  void forEachNamed(std::vector<NamedMesh> meshes, Visit visit) {
    for (NamedMesh& mesh : meshes) {
      if (mesh.name.find(options_.only) == std::string::npos) continue;
      if (options_.subdivisions > 0) {
        mesh.make = [make = mesh.make, times = options_.subdivisions] {
          return subdivided(make(), times);
        };
      }
      visit(mesh);
    }
  }

  template <class Visit>
  void forEachCase(const std::vector<std::filesystem::path>& paths, Visit visit) {
    for (const auto& path : paths)
      if (path.stem().string().find(options_.only) != std::string::npos) visit(readTruthCase(path));
  }

  void writeSpeed(const NamedMesh& named) {
    const TriangleMesh mesh = named.make();
    for (const int count : options_.sites) {
      announce(named.name + ", " + std::to_string(mesh.faceCount()) + " faces, " +
               std::to_string(count) + (count == 1 ? " site" : " sites"));
      writeSpeed(named.name, mesh, sampleUniform(mesh, count, options_.seed));
    }
    if (!options_.meshFolder.empty()) writeGlb(mesh, options_.meshFolder / (named.name + ".glb"));
  }

  void writeSizeStep(const NamedMesh& named) {
    constexpr int kSites = 300;
    const TriangleMesh mesh = named.make();
    announce(named.name + ", " + std::to_string(mesh.faceCount()) + " faces");
    writeSpeed(named.name, mesh, sampleUniform(mesh, kSites, options_.seed));
  }

  void writeSpeed(const std::string& name, const TriangleMesh& mesh,
                  const std::vector<SurfacePoint>& sites) {
    const Speed speed =
        measureSpeed(mesh, sites, options_.metrics, {options_.runs, options_.detail});
    json_.beginObject();
    describe(name, mesh);
    json_.number("sites", static_cast<double>(sites.size()));
    json_.number("dijkstra", speed.dijkstra);
    json_.beginObject("metrics");
    for (const MetricSpeed& metric : speed.metrics) {
      json_.beginObject(metric.metric.name);
      if (metric.note.empty()) {
        json_.number("distances", metric.distances);
        json_.number("diagram", metric.diagram);
        json_.number("partition", metric.partition);
        if (metric.change) json_.number("change", *metric.change);
        json_.number("bytes", metric.bytes);
        json_.number("bytesPerFace", metric.bytes / mesh.faceCount());
      } else {
        json_.text("note", metric.note);
      }
      json_.endObject();
    }
    json_.endObject();
    json_.endObject();
  }

  void writeAccuracy(const NamedMesh& named) {
    const TriangleMesh mesh = named.make();
    if (isTooLarge(named.name, mesh)) return;
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

  /// To be compared with exact distances.
  bool isTooLarge(const std::string& name, const TriangleMesh& mesh) {
    if (mesh.faceCount() <= options_.oracleFaces) return false;
    announce(name + " has more than " + std::to_string(options_.oracleFaces) +
             " faces: left out here (--oracle-faces)");
    return true;
  }

  void writeCase(const TruthCase& truth) {
    announce(truth.name);
    const TriangleMesh mesh = readGltfMesh(truth.mesh);
    json_.beginObject();
    json_.text("case", truth.name);
    describe(truth.mesh.stem().string(), mesh);
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
      json_.number("largestError", result.largestError);
    });
  }

  void writeDetail(const NamedMesh& named) {
    constexpr int kMostDetail = 4;
    const TriangleMesh mesh = named.make();
    if (isTooLarge(named.name, mesh)) return;
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
    if (isTooLarge(named.name, mesh)) return;
    writeTessellation(named.name, mesh, sampleUniform(mesh, options_.oracleSites, options_.seed),
                      sampleUniform(mesh, kPoints, options_.seed + 1));
  }

  void writeTessellation(const TruthCase& start) {
    const TriangleMesh mesh = readGltfMesh(start.mesh);
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
    json_.text("mesh", name);
    json_.number("faces", mesh.faceCount());
  }

  /// Measures into one object per metric. What fails says so there, and the rest goes on.
  template <class Measure>
  void forEachMetric(Measure measure) {
    json_.beginObject("metrics");
    for (const auto& [name, metric] : options_.metrics) {
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
    std::cerr << "bench: " << error.what() << '\n';
    return 2;
  }
}
