// SPDX-License-Identifier: MIT
//
// Shared by the dual, its checks, its repair and the remesh.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/rejection.h"
#include "gvd/dual.h"
#include "gvd/partition.h"
#include "mesh/given_points.h"
#include "partition/region_complex.h"

namespace gvd {

/// Like `dualMesh`, but from a partition, which leaves out components without a site.
PolygonMesh buildDual(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                      const Partition& partition, const RegionComplex& complex);

/// Work that computes a result from the regions of a diagram, at one go.
template <class Result, class Make>
class FromRegions final : public SlicedWork<Result> {
 public:
  FromRegions(const TriangleMesh& mesh, const Diagram& diagram, Make make)
      : regions_(mesh, diagram), make_(std::move(make)) {}

  bool advance(long budget) override {
    if (!regions_.step(budget) || budget <= 0) return false;
    result_ = make_(regions_.partition(), regions_.complex());
    return true;
  }
  double share() const override { return regions_.progress(); }
  Result result() override { return std::move(result_); }

 private:
  RegionsBuilding regions_;
  Make make_;
  Result result_;
};

/// Starts such work; `make(partition, complex)` computes the result.
template <class Make>
auto fromRegions(const TriangleMesh& mesh, const Diagram& diagram, Make make) {
  using Result =
      decltype(make(std::declval<const Partition&>(), std::declval<const RegionComplex&>()));
  return std::unique_ptr<SlicedWork<Result>>(
      new FromRegions<Result, Make>(mesh, diagram, std::move(make)));
}

/// The sites of a diagram, with clean coordinates. Throws `Error(kInvalidArgument)` unless there is
/// an entry per label, with a site if the label has a region, and `Error(kInvalidPoint)` if a site
/// is not on the mesh.
inline std::vector<SurfacePoint> sitesOf(const TriangleMesh& mesh, const Diagram& diagram,
                                         std::span<const SurfacePoint> sites) {
  if (static_cast<int>(sites.size()) != diagram.siteCount)
    rejectArgument("the number of sites is " + std::to_string(sites.size()) +
                   ", not that of the diagram, " + std::to_string(diagram.siteCount));
  for (int label = 0; label < diagram.siteCount; ++label)
    if (sites[label].face < 0 && diagram.regionArea[label] > 0)
      rejectArgument("label " + std::to_string(label) + " has a region, but no site");
  return allOnMesh(mesh, sites, "site ");
}

/// A violation, and the triangles of the partition where it shows. A place inside of one, far from
/// all sites, is good for another site: on the mesh boundary, triangles of the dual could have no
/// area.
struct Finding {
  Violation violation;
  std::vector<int> triangles;
  int bareFace = -1;  ///< of a component without a site, which the partition leaves out
};

/// Like `findViolations`, in the same order.
std::vector<Finding> inspect(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                             const Diagram& diagram, const Partition& partition,
                             const RegionComplex& complex);

/// `RemeshQuality::minAngle` alone.
double minAngleOf(const PolygonMesh& remesh);

/// Throws unless so many sites may be added by `repair` or `remesh`.
void requireMaxAdded(int count);

}  // namespace gvd
