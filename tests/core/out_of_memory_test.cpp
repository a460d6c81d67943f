// SPDX-License-Identifier: MIT
//
// What is left when memory runs out, at any allocation: nothing is lost, and what was there before
// answers as before.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <utility>
#include <vector>

#include "gvd/diagram.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/geodesic.h"
#include "gvd/sampling.h"
#include "shapes.h"

namespace {

long allocated = 0;  ///< blocks of memory that are not freed yet
long left = -1;      ///< allocations before the one that fails; negative: none fails

}  // namespace

void* operator new(std::size_t bytes) {
  if (left-- == 0) throw std::bad_alloc();
  void* const block = std::malloc(std::max<std::size_t>(bytes, 1));
  if (!block) throw std::bad_alloc();
  ++allocated;
  return block;
}
/// For the buffers of the standard library's stable sort.
void* operator new(std::size_t bytes, const std::nothrow_t& /*tag*/) noexcept {
  try {
    return operator new(bytes);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* block) noexcept {
  if (block) --allocated;
  std::free(block);
}
void operator delete(void* block, std::size_t /*bytes*/) noexcept { operator delete(block); }

namespace gvd {
namespace {

/// Calls `f` until it succeeds, and lets the first allocation fail, then the second, and so on.
/// Calls `check` after each failure. Returns how often it failed.
template <class F, class Check>
long callWithEveryFailure(F f, Check check) {
  for (long failures = 0;; ++failures) {
    left = failures;
    try {
      f();
      left = -1;
      return failures;
    } catch (const std::bad_alloc&) {
      left = -1;
    }
    check();
  }
}

class OutOfMemory : public ::testing::TestWithParam<Metric> {
 protected:
  const TriangleMesh mesh = shapes::withoutRandomFaces(shapes::icosphere(1), 9, 3).mesh();
  const std::vector<SurfacePoint> sites = sampleUniform(mesh, 4, 1);
};

TEST_P(OutOfMemory, LosesNothing) {
  const long before = allocated;
  const auto expectNothingLost = [&] { EXPECT_EQ(allocated, before); };
  const auto computeAll = [&] {
    DynamicDiagram dynamic(mesh, sites, GetParam());
    dynamic.insertSite({0, {0.2, 0.3, 0.5}});
    dynamic.removeSite(1);
    dynamic.diagram();
  };
  EXPECT_GT(callWithEveryFailure(computeAll, expectNothingLost), 100);
  expectNothingLost();
}

TEST_P(OutOfMemory, LeavesDistancesAsTheyWere) {
  const std::vector<SurfacePoint> points = sampleUniform(mesh, 6, 2);
  std::vector<LabelledPoint> labelled;
  for (const SurfacePoint& p : points) labelled.push_back({2, p});
  const auto answers = [&](const DistanceField& field) {
    std::vector<double> result = field.distancesAt(labelled);
    for (const SurfacePoint& p : points) {
      const LabelledDistance nearest = field.nearest(p);
      result.push_back(nearest.distance);
      result.push_back(lengthOf(mesh, field.path(nearest.label, p)));
    }
    return result;
  };
  const auto fresh = finished(propagate(mesh, sites, GetParam()));
  const std::vector<double> expected = answers(*fresh);
  const auto field = finished(propagate(mesh, sites, GetParam()));
  const long failures =
      callWithEveryFailure([&] { answers(*field); }, [&] { EXPECT_EQ(answers(*field), expected); });
  EXPECT_GT(failures, 10);
}

INSTANTIATE_TEST_SUITE_P(Both, OutOfMemory, ::testing::Values(Metric::kExact, Metric::kDgpc));

}  // namespace
}  // namespace gvd
