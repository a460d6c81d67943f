// SPDX-License-Identifier: MIT
//
// Shared by the dual, its checks, its repair and the remesh.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "gvd/dual.h"
#include "gvd/partition.h"
#include "gvd/remesh.h"
#include "mesh/given_points.h"
#include "partition/region_complex.h"

namespace gvd {

/// Builds a dual from the regions of its diagram, in slices.
class DualBuilding {
 public:
  /// All must outlive this.
  DualBuilding(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
               const RegionComplex& complex);
  bool step(long& budget);
  PolygonMesh take() { return std::move(out_); }

 private:
  void addSite(int label);
  void addRun(int border);
  void addPolygon(int vertex);

  const TriangleMesh& mesh_;
  const std::span<const SurfacePoint> sites_;
  const RegionComplex& complex_;
  SlicedSequence sequence_;
  std::vector<int> vertexOfLabel_, vertexOfRun_;
  PolygonMesh out_;
};

/// Work on the regions of a diagram: first finds them, then steps through the part that
/// `make(complex)` returns, whose result it takes.
template <class Make>
auto fromRegions(const TriangleMesh& mesh, const Diagram& diagram, Make make) {
  using Part = decltype(make(std::declval<const RegionComplex&>()));
  using Result = decltype(std::declval<Part>().take());
  class FromRegions final : public SlicedWork<Result> {
   public:
    FromRegions(const TriangleMesh& mesh, const Diagram& diagram, Make make)
        : regions_(mesh, diagram), make_(std::move(make)) {}

    bool advance(long budget) override {
      return sequence_.run([&] { return regions_.step(budget); },
                           [&] { part_.emplace(make_(regions_.complex())); },
                           [&] { return part_->step(budget); });
    }
    double share() const override { return regions_.progress(); }
    Result result() override { return part_->take(); }

   private:
    SlicedSequence sequence_;
    RegionComplexBuilding regions_;
    Make make_;
    std::optional<Part> part_;
  };
  return std::unique_ptr<SlicedWork<Result>>(new FromRegions(mesh, diagram, std::move(make)));
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
  std::vector<SurfacePoint> clean(sites.begin(), sites.end());
  for (std::size_t label = 0; label < clean.size(); ++label)
    if (clean[label].face != -1) clean[label] = onMesh(mesh, clean[label], "site", label);
  return clean;
}

/// The quality of a remesh but for its distance from the surface. The remesh must outlive the work.
std::unique_ptr<SlicedWork<RemeshQuality>> startTriangleQuality(const PolygonMesh& remesh);

/// Throws unless so many sites may be added by `repair` or `remesh`.
void requireMaxAdded(int count);

}  // namespace gvd
