// SPDX-License-Identifier: MIT
//
// `sampleWorstFirst`.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/sampling.h"

namespace gvd {
namespace {

/// Inserts a site for the worst region, again and again.
class WorstFirstSampling final : public SequentialWork<std::vector<SurfacePoint>> {
 public:
  WorstFirstSampling(const TriangleMesh& mesh, int count, std::uint64_t seed, WorstRegion worst)
      : mesh_(mesh),
        count_(count),
        worst_(worst),
        sampling_(startUniform(mesh, std::min(count, 1), seed)) {}

  bool advance(long budget) override {
    return sequence_.run([&] { return sampling_->step(budget); }, [&] { out_ = sampling_->take(); },
                         [&] { return isComplete() || addOthers(budget); });
  }
  double share() const override {
    return count_ > 0 ? static_cast<double>(out_.size()) / count_ : 0;
  }

 private:
  bool addOthers(long budget) {
    return adding_.run(
        [&] {
          if (!making_) making_ = DynamicDiagram::start(mesh_, out_);
          return making_->step(budget);
        },
        [&] {
          diagram_ = making_->take();
          making_.reset();
          first_ = diagram_->diagram();
          listing_ = WorstRegions::start(mesh_, diagram_->distances(), first_, worst_);
        },
        [&] { return listing_->step(budget); },
        [&] {
          regions_ = listing_->take();
          listing_.reset();
          first_ = {};
          addPoint();
        },
        [&] { return insertOthers(budget); });
  }

  /// Adds the place for the next point. The last one need not be inserted.
  void addPoint() {
    out_.push_back(regions_->point());
    if (!isComplete()) insertion_ = diagram_->startInsert(out_.back());
  }

  /// One site per step at the most, as each part of a round may use up the budget.
  bool insertOthers(long budget) {
    if (isComplete()) return true;
    round_.runRound([&] { return insertion_->step(budget); },
                    [&] {
                      change_ = insertion_->take();
                      following_ = regions_->startFollow(change_);
                    },
                    [&] { return following_->step(budget); }, [&] { addPoint(); });
    return isComplete();
  }

  bool isComplete() const { return static_cast<int>(out_.size()) == count_; }

  const TriangleMesh& mesh_;
  const int count_;
  const WorstRegion worst_;
  SlicedSequence adding_, round_;
  std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> sampling_;  ///< of the first point
  std::unique_ptr<SlicedWork<DynamicDiagram>> making_;
  std::optional<DynamicDiagram> diagram_;
  Diagram first_;  ///< of the first point
  std::unique_ptr<SlicedWork<WorstRegions>> listing_;
  std::optional<WorstRegions> regions_;
  // Of the last point.
  std::unique_ptr<SlicedWork<DiagramChange>> insertion_;
  DiagramChange change_;
  std::unique_ptr<SlicedSteps> following_;
};

}  // namespace

std::unique_ptr<SlicedWork<std::vector<SurfacePoint>>> startWorstFirst(const TriangleMesh& mesh,
                                                                       int count,
                                                                       std::uint64_t seed,
                                                                       WorstRegion worst) {
  return std::make_unique<WorstFirstSampling>(mesh, count, seed, worst);
}

std::vector<SurfacePoint> sampleWorstFirst(const TriangleMesh& mesh, int count, std::uint64_t seed,
                                           WorstRegion worst) {
  return finished(startWorstFirst(mesh, count, seed, worst));
}

}  // namespace gvd
