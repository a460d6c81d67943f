// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "distance/exact/label_state.h"
#include "distance/exact/window_record.h"
#include "distance/exact/window_sweep.h"
#include "distance/label_spread.h"
#include "distance/nearest_bounds.h"
#include "distance/site_set.h"

namespace gvd::exact {

/// The exact metric: polyhedral distance by windows (Mitchell et al. 1987). Distances at vertices
/// are kept. At other points they follow from the windows that have crossed the face, which would
/// take several times the memory of all else: a label that is asked for such a point spreads once
/// more, and its windows are kept until it changes.
class WindowSpread final : public LabelSpread {
 public:
  WindowSpread(const TriangleMesh& mesh, const SiteSet& sites, NearestBounds& bounds,
               SpreadTo startTo);

  void start(int label) override;
  void resume(int label) override;
  void require(int label, std::span<const int> faces) override;
  void require(int label, std::span<RequiredPoint> points) override;
  bool run(long& budget) override;
  void remove(int label) override;

  std::vector<ReachedVertex>& reached(int label) override { return labels_[label].state.vertices; }
  const std::vector<ReachedVertex>& reached(int label) const override {
    return labels_[label].state.vertices;
  }
  std::vector<int> outdated(std::span<const int> /*changedVertices*/) override { return {}; }
  void appendReaching(int /*vertex*/, std::vector<int>& /*labels*/) override {}
  void appendLabelsInside(int face, std::vector<int>& labels) const override;
  double distance(int label, const SurfacePoint& p,
                  const std::array<double, 3>& atCorners) override;
  Eigen::Vector2d direction(int label, int index) const override;
  std::vector<SurfacePoint> path(int label, const SurfacePoint& p) override;

 private:
  /// A label's second run, of which the windows are recorded.
  struct Recording {
    LabelState state;
    WindowRecord windows;
  };
  struct Label {
    LabelState state;
    std::vector<int> crossedFaces;
    std::unique_ptr<Recording> recording;  ///< if a point has been asked for
  };
  /// A label that has crossed a face, in a list of those of the face.
  struct Crossing {
    int label;
    int next;
  };
  void begin(int label);
  void noteCrossedFaces();
  Recording& recordingOf(int label);
  void finish(Recording& recording);

  const TriangleMesh& mesh_;
  const SiteSet& sites_;
  const NearestBounds& bounds_;
  const SpreadTo startTo_;
  WindowSweep sweep_;
  std::vector<Label> labels_;
  std::vector<int> firstCrossing_;  ///< per face, -1
  std::vector<Crossing> crossings_;
  std::vector<int> freeCrossings_;
  int label_ = -1;  ///< the label at hand
};

}  // namespace gvd::exact
