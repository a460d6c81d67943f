// SPDX-License-Identifier: MIT
//
// A diagram is traced from distances in stages: elements, labels that they lack, bisectors,
// outlines, segments, Voronoi points, loops, cells, arcs.
#include "diagram/diagram_tracing.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "diagram/complex/label_completion.h"
#include "diagram/final/arc_chaining.h"
#include "diagram/final/final_cells.h"
#include "diagram/final/final_points.h"
#include "diagram/final/final_segments.h"
#include "diagram/final/region_outlines.h"
#include "diagram/final/voronoi_points.h"
#include "diagram/graph/bisector_tracing.h"
#include "distance/site_distances.h"

namespace gvd {
namespace {

/// Traces the diagram of a complex: the bisector graph with all ties broken, the outlines of
/// regions, and from these the diagram with points merged.
class Tracing final : public SlicedWork<TracedDiagram> {
 public:
  /// Traces outlines of some labels, of all if `labels` is null. `pointOfNode` is working memory,
  /// empty before and after: parts that are traced one after the other allocate it once.
  Tracing(const DistanceField& distances, ComplexBuilding& building, int siteCount,
          const IndexSet* labels, IndexMap& pointOfNode)
      : distances_(distances),
        building_(building),
        complex_(building.complex()),
        mesh_(complex_.mesh()),
        labels_(labels),
        pointOfNode_(pointOfNode) {
    out_.siteCount = siteCount;
  }

  bool advance(long budget) override {
    return sequence_.run(
        [&] { return building_.step(budget); }, [&] { requireLabels(); },
        [&] { return complex_.hasFacesOnly() || runPart(completion_, budget, complex_); },
        [&] { return isUnreliable() || trace(budget); });
  }
  double share() const override {
    if (!building_.splitsFaces()) return tracing_.progress();
    constexpr double kOfBuilding = 0.8;
    return kOfBuilding * building_.progress() + (1 - kOfBuilding) * tracing_.progress();
  }

  TracedDiagram result() override {
    pointOfNode_.clear();
    return {std::move(out_), std::move(graph_.mergedFaces),
            completion_ ? completion_->takeFaces() : std::vector<int>()};
  }

 private:
  /// Whether labels were added in a part. Their regions may then go on into faces outside of it.
  bool isUnreliable() const { return labels_ && completion_ && completion_->hasAddedLabels(); }

  void requireLabels() const {
    const int highest = complex_.nodes().highestLabel();
    if (highest >= out_.siteCount)
      rejectArgument("there are distances of site " + std::to_string(highest) +
                     ", but the number of sites is " + std::to_string(out_.siteCount));
  }

  bool trace(long& budget) {
    return tracing_.run(
        [&] { return runPart(bisectors_, budget, complex_, pointOfNode_, graph_, out_); },
        [&] { bisectors_.reset(); },
        [&] {
          return runPart(outlines_, budget, complex_, distances_, pointOfNode_, labels_, graph_);
        },
        [&] { release(graph_.nextDart); }, [&] { return points_.prepare(budget); },
        [&] {
          return runPart(segments_, budget, mesh_, graph_, outlines_->boundarySteps(), points_,
                         out_);
        },
        [&] { return runPart(voronoiPoints_, budget, graph_, *outlines_, points_, out_); },
        [&](SlicedLoop& loop) { return collectLoops(loop, budget); },
        [&] { return runPart(cells_, budget, complex_, graph_, points_, out_); },
        [&] {
          outlines_.reset();
          release(graph_.points);
        },
        [&] { return arcs_.step(budget); });
  }

  bool collectLoops(SlicedLoop& loop, long& budget) {
    out_.loops.points.reserve(outlines_->pointCount());
    return loop.run(outlines_->size(), budget, 1, [&](int outline) {
      for (const int p : outlines_->points(outline)) out_.loops.points.push_back(points_.number(p));
      out_.loops.close();
      out_.loopLabel.push_back(outlines_->label(outline));
    });
  }

  const DistanceField& distances_;
  ComplexBuilding& building_;
  FaceComplex& complex_;
  const TriangleMesh& mesh_;
  const IndexSet* const labels_;
  IndexMap& pointOfNode_;

  SlicedSequence sequence_, tracing_;
  BisectorGraph graph_;
  Diagram out_;
  FinalPoints points_{graph_, out_.points};
  std::optional<LabelCompletion> completion_;
  std::optional<BisectorTracing> bisectors_;
  std::optional<RegionOutlines> outlines_;
  std::optional<FinalSegments> segments_;
  ArcChaining arcs_{out_};
  std::optional<VoronoiPoints> voronoiPoints_;
  std::optional<FinalCells> cells_;
};

int validDetail(const DiagramOptions& options) {
  if (options.detail < 0 || options.detail > DiagramOptions::kMostDetail)
    rejectArgument("the detail " + std::to_string(options.detail) + " is not from 0 to " +
                   std::to_string(DiagramOptions::kMostDetail));
  return options.detail;
}

}  // namespace

std::unique_ptr<SlicedWork<TracedDiagram>> startTracing(const TriangleMesh& mesh,
                                                        const DistanceField& distances,
                                                        int siteCount,
                                                        const DiagramOptions& options) {
  requireMesh(mesh, distances);
  auto building = std::make_unique<ComplexBuilding>(mesh, distances, validDetail(options),
                                                    ComplexBuilding::Extent::kMesh);
  auto pointOfNode = std::make_unique<IndexMap>();
  auto tracing = std::make_unique<Tracing>(distances, *building, siteCount, nullptr, *pointOfNode);
  return workOn(std::move(tracing),
                [building = std::move(building),
                 pointOfNode = std::move(pointOfNode)](auto traced) { return traced->take(); });
}

std::unique_ptr<SlicedWork<Diagram>> startDiagram(const TriangleMesh& mesh,
                                                  const DistanceField& distances, int siteCount,
                                                  const DiagramOptions& options) {
  return workOn(startTracing(mesh, distances, siteCount, options),
                [](auto tracing) { return tracing->take().diagram; });
}

Diagram traceDiagram(const TriangleMesh& mesh, const DistanceField& distances, int siteCount,
                     const DiagramOptions& options) {
  return finished(startDiagram(mesh, distances, siteCount, options));
}

double propagationShare(const DiagramOptions& options) {
  const int detail = validDetail(options);
  return detail == 0 ? 0.9 : 0.5 / (1 << detail);
}

PartialTracer::PartialTracer(const TriangleMesh& mesh, const DistanceField& distances,
                             const DiagramOptions& options)
    : distances_(distances),
      building_(mesh, distances, validDetail(options), ComplexBuilding::Extent::kPart) {}

std::unique_ptr<SlicedWork<TracedDiagram>> PartialTracer::start(std::span<const int> faces,
                                                                const IndexSet& labels,
                                                                int labelCount) {
  building_.startPart(faces);
  return std::make_unique<Tracing>(distances_, building_, labelCount, &labels, pointOfNode_);
}

}  // namespace gvd
