// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "gvd/geodesic.h"
#include "gvd/sliced_work.h"
#include "gvd/surface_point.h"

namespace gvd {

class KnownLabels;

/// A vertex that a label has reached.
struct ReachedVertex {
  int vertex;
  /// Whether the distance is final: the label owns the vertex, or its distance was required there.
  /// Otherwise it is an upper bound, for the label was stopped before.
  bool isFinal;
  double distance;
};

/// How the labels spread from their sites: what the two metrics differ in. One label is worked on
/// at a time: one of the first three functions begins, and `run` carries on until it is done.
class LabelSpread {
 public:
  virtual ~LabelSpread() = default;

  /// From the site, to where another label is nearer. Nothing must be known of the label.
  virtual void start(int label) = 0;
  /// On from where the label stopped, because bounds have risen.
  virtual void resume(int label) = 0;
  /// On to all corners of some faces, each of which the label owns some part of.
  virtual void require(int label, std::span<const int> faces) = 0;
  /// Works on at most `budget` units and lowers it by their number. True when the label is done.
  virtual bool run(long& budget) = 0;
  /// Forgets some labels.
  virtual void remove(std::span<const int> labels) = 0;

  /// The vertices that a label has reached. Their order stays, further ones come last.
  virtual std::vector<ReachedVertex>& reached(int label) = 0;
  virtual const std::vector<ReachedVertex>& reached(int label) const = 0;
  /// The labels that have to start again because the bounds by paths along edges have changed.
  virtual std::vector<int> outdated(std::span<const int> changedVertices) = 0;
  /// Appends the labels that have reached a vertex, if those known at the vertices around it need
  /// not be all that may own it in place of a label that goes.
  virtual void appendReaching(int vertex, std::vector<int>& labels) = 0;
  /// The labels that may be nearest at a point that is no vertex, with their distances: all labels
  /// that are, each once. `known` is what is known of all labels.
  virtual std::vector<LabelledDistance> nearestAt(const SurfacePoint& p,
                                                  const KnownLabels& known) = 0;
  /// Starts the distances of labels at points that are no vertices; each is known around its
  /// points. There must be no change until it is done.
  virtual std::unique_ptr<SlicedWork<std::vector<double>>> startDistancesAt(
      std::span<const LabelledPoint> points, const KnownLabels& known) = 0;
  /// The direction at the site of the path to the vertex `reached(label)[index]`
  /// (`DistanceField::direction`).
  virtual Eigen::Vector2d direction(int label, int index) const = 0;
  /// The path from a point where the label is known to its site (`DistanceField::path`).
  virtual std::vector<SurfacePoint> path(int label, const SurfacePoint& p) = 0;
};

}  // namespace gvd
