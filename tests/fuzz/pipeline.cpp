// SPDX-License-Identifier: MIT
//
// A wild mesh, sites, and all that can be made of them: see `pipeline_checks.h`.
#include <cstdio>
#include <cstdlib>

#include "gvd/error.h"
#include "pipeline_checks.h"
#include "wild_mesh.h"

namespace {

using namespace gvd;

std::string complaint(shapes::Random& random) {
  checks::PipelineOptions options{.edits = 3, .cvtIterations = 2};
  options.metric = random.below(2) ? Metric::kExact : Metric::kDgpc;
  const shapes::Shape shape = wildMesh(random, 12);
  try {
    shape.mesh();
  } catch (const Error&) {
    return {};
  }
  const TriangleMesh mesh = shape.mesh();
  std::vector<SurfacePoint> sites;
  for (int n = 1 + random.below(6); n > 0; --n) {
    double a = random.uniform(), b = random.uniform();
    if (a + b > 1) a = 1 - a, b = 1 - b;
    sites.push_back({random.below(mesh.faceCount()), {a, b, 1 - a - b}});
  }
  return checks::complaintAboutPipeline(mesh, sites, random, options);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  shapes::Random random(std::span(data, size));
  const std::string what = complaint(random);
  if (what.empty()) return 0;
  std::fprintf(stderr, "%s\n", what.c_str());
  std::abort();
}
