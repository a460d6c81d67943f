// SPDX-License-Identifier: MIT
//
// Centroidal tessellations for JavaScript, an iteration in slices; remeshes.

#include <memory>
#include <utility>
#include <vector>

#include "gvd/remesh.h"
#include "objects.h"
#include "records.h"

namespace gvd::abi {
namespace {

constexpr Named<CvtMethod> kCvtMethods[] = {{"lloyd", CvtMethod::kLloyd},
                                            {"lbfgs", CvtMethod::kLbfgs}};

/// `density` is one value per input vertex, or none.
CvtOptions optionsOf(const TriangleMesh& mesh, Text method, Text metric, int iterations,
                     double energyTolerance, double moveTolerance, Doubles density,
                     Ints fixedSites) {
  CvtOptions options;
  options.method = valueOf(kCvtMethods, "method", method);
  options.metric = metricOf(metric);
  options.iterations = iterations;
  options.energyTolerance = energyTolerance;
  options.moveTolerance = moveTolerance;
  options.density = densityFromInput(mesh, density);
  options.fixedSites.assign(fixedSites.data, fixedSites.data + fixedSites.size);
  return options;
}

/// The next iteration as a `CvtState` without a diagram; `hasState` is false if there was none.
class CvtAdvancing final : public SlicedWork<Record> {
 public:
  /// The tessellation must outlive the steps. Others go on where these end.
  explicit CvtAdvancing(CvtHandle& handle) : handle_(handle) {}

  bool advance(long budget) override {
    hasState_ = handle_.cvt->step(budget);
    return hasState_ || handle_.cvt->isDone();
  }
  double share() const override { return 0; }  // not known
  Record result() override {
    const Cvt& cvt = *handle_.cvt;
    const CvtIteration& iteration = cvt.iteration();
    Record out;
    out.add("hasState", hasState_);
    out.add("iteration", iteration.number);
    out.add("energy", iteration.energy);
    out.add("largestMove", iteration.largestMove);
    out.add("sites", pointsRecord(*handle_.surface.mesh, cvt.sites()));
    return out;
  }

 private:
  CvtHandle& handle_;
  bool hasState_ = false;
};

}  // namespace

GVD_ABI CvtHandle* startCvt(const MeshHandle* handle, Ints face, Doubles bary, Text method,
                            Text metric, int iterations, double energyTolerance,
                            double moveTolerance, Doubles density, Ints fixedSites) {
  return guarded([&] {
    const TriangleMesh& mesh = *handle->mesh;
    CvtOptions options = optionsOf(mesh, method, metric, iterations, energyTolerance, moveTolerance,
                                   density, fixedSites);
    const std::vector<SurfacePoint> sites = sitesFromInput(mesh, face, bary);
    auto cvt = std::make_unique<CvtHandle>();
    cvt->surface = *handle;
    cvt->metric = options.metric;
    cvt->cvt = std::make_unique<Cvt>(mesh, sites, std::move(options));
    return cvt.release();
  });
}

GVD_ABI void freeCvt(CvtHandle* cvt) { delete cvt; }

/// See `CvtAdvancing`.
GVD_ABI Answer* advanceCvt(CvtHandle* cvt) {
  return guarded([&] { return answerOf(std::make_unique<CvtAdvancing>(*cvt)); });
}

/// The diagram of the last iteration as an object.
GVD_ABI DiagramHandle* cvtVoronoi(const CvtHandle* handle) {
  return guarded([&] {
    const Cvt& cvt = *handle->cvt;
    auto voronoi = std::make_unique<DiagramHandle>();
    voronoi->surface = handle->surface;
    voronoi->sites.assign(cvt.sites().begin(), cvt.sites().end());
    voronoi->metric = handle->metric;
    voronoi->sharedDistances = cvt.distances();
    voronoi->traced = cvt.diagram();
    return voronoi.release();
  });
}

/// `SurfacePoints`: the sites of a remesh.
GVD_ABI Answer* remeshedSites(const MeshHandle* handle, Ints face, Doubles bary, Text method,
                              Text metric, int iterations, double energyTolerance,
                              double moveTolerance, Doubles density, Ints fixedSites,
                              int maxAdded) {
  return guarded([&] {
    const auto mesh = handle->mesh;
    const CvtOptions tessellation = optionsOf(*mesh, method, metric, iterations, energyTolerance,
                                              moveTolerance, density, fixedSites);
    return answerOf(
        startRemesh(*mesh, sitesFromInput(*mesh, face, bary), {tessellation, maxAdded}),
        [mesh](const RepairedSites& remeshed) { return pointsRecord(*mesh, remeshed.sites); });
  });
}

}  // namespace gvd::abi
