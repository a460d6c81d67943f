// SPDX-License-Identifier: MIT
#include "gvd/diagram.h"

#include <memory>
#include <utility>

#include "diagram/diagram_tracing.h"

namespace gvd {
namespace {

/// Yields the diagram of a tracing without the rest.
class DiagramOfTracing final : public SlicedWork<Diagram> {
 public:
  explicit DiagramOfTracing(std::unique_ptr<SlicedWork<TracedDiagram>> tracing)
      : tracing_(std::move(tracing)) {}

  bool step(long budget) override { return tracing_->step(budget); }
  double progress() const override { return tracing_->progress(); }
  Diagram take() override { return tracing_->take().diagram; }

 private:
  const std::unique_ptr<SlicedWork<TracedDiagram>> tracing_;
};

}  // namespace

std::unique_ptr<SlicedWork<Diagram>> startDiagram(const TriangleMesh& mesh,
                                                  const DistanceField& distances, int siteCount,
                                                  const DiagramOptions& options) {
  return std::make_unique<DiagramOfTracing>(startTracing(mesh, distances, siteCount, options));
}

Diagram traceDiagram(const TriangleMesh& mesh, const DistanceField& distances, int siteCount,
                     const DiagramOptions& options) {
  return finished(startDiagram(mesh, distances, siteCount, options));
}

}  // namespace gvd
