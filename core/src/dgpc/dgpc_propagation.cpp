// SPDX-License-Identifier: MIT
#include "dgpc/continuation.h"
#include "dgpc/dgpc_sweep.h"
#include "dgpc/inside_straightening.h"
#include "distance/metric.h"

namespace gvd {
namespace {

/// Sweeps, and then tells vertices what a diagram needs to know there.
class DgpcPropagation final : public Propagation {
 public:
  DgpcPropagation(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Spread spread,
                  Straightens straightens)
      : sweep_(mesh, sites, spread), straightens_(straightens) {}

  bool step(long budget) override { return sweep_.step(budget); }
  double progress() const override { return sweep_.progress(); }

  std::unique_ptr<DistanceField> take() override {
    auto field = sweep_.take();
    continueOverBorders(*field);
    if (straightens_ == Straightens::kEverywhere) straightenInsides(*field);
    return field;
  }

 private:
  DgpcSweep sweep_;
  Straightens straightens_;
};

}  // namespace

std::unique_ptr<Propagation> propagateDgpc(const TriangleMesh& mesh,
                                           std::span<const SurfacePoint> sites, Spread spread,
                                           Straightens straightens) {
  return std::make_unique<DgpcPropagation>(mesh, sites, spread, straightens);
}

}  // namespace gvd
