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

/// A vertex that a label has reached.
struct ReachedVertex {
  int vertex;
  /// Whether the distance is final: the label owns the vertex or ties with its owner, or its
  /// distance was required there. Otherwise the distance is an upper bound, because the label was
  /// stopped.
  bool isFinal;
  double distance;
};

/// How labels spread from their sites: the part that differs between the two metrics. Labels spread
/// one at a time: `start`, `resume` or `require` begins, and `step` carries on until it returns
/// true.
class LabelSpread {
 public:
  virtual ~LabelSpread() = default;

  /// Allocates the working memory, in slices; true when it is there. Before anything else.
  virtual bool prepare(long& budget) = 0;
  /// Takes the edge bound of a vertex (`EdgeBounds`) whenever it has changed.
  virtual void setEdgeBound(int vertex, double bound) = 0;
  /// Spreads a new label from its site, at least as far as it is nearest.
  virtual void start(int label) = 0;
  /// Spreads a label on from where others stopped it, because bounds have risen.
  virtual void resume(int label) = 0;
  /// Spreads a label on to all corners of some faces. The label must own part of each. Quickest
  /// if the same label was required last. Returns how many quick rounds it took (`kQuickRounds`).
  virtual long require(int label, std::span<const int> faces) = 0;
  /// Works on at most `budget` units and lowers it by their number. True when the label is done.
  virtual bool step(long& budget) = 0;
  /// The index in `reached` of a corner of the faces required last.
  virtual int indexOf(int vertex) const = 0;
  /// Forgets some labels.
  virtual void remove(std::span<const int> labels) = 0;

  /// The vertices that a label has reached, in a stable order: new ones are appended.
  virtual const std::vector<ReachedVertex>& reached(int label) const = 0;
  /// Marks the distance of `reached(label)[index]` as final, while no label spreads.
  virtual void markFinal(int label, int index) = 0;
  /// Whether the distances that a label finds depend on `EdgeBounds`: then a label has to start
  /// again when the edge bound of a vertex that it has reached changes.
  virtual bool dependsOnEdgeBounds() const = 0;
  /// Candidates for the nearest label at a point that is no vertex, with the lengths of paths to
  /// their sites. All labels that tie for nearest are among them, each with its distance; a label
  /// may come several times, also with longer paths. `known` has the distances at vertices.
  /// Lowers the budget by the units that it takes, whatever is left.
  virtual std::vector<LabelledDistance> nearestAt(const SurfacePoint& p, const DistanceField& known,
                                                  long& budget) = 0;
  /// Starts to find the distances of labels at points that are no vertices. Each label must be
  /// known around its points, and sites must not change until the work is done.
  virtual std::unique_ptr<SlicedWork<std::vector<double>>> startDistancesAt(
      std::vector<LabelledPoint> points, const DistanceField& known) = 0;
  /// The direction at the site of the path to the vertex `reached(label)[index]`
  /// (`DistanceField::direction`).
  virtual Eigen::Vector2d direction(int label, int index) const = 0;
  /// The path from a point where the label is known to its site (`DistanceField::path`).
  virtual std::vector<SurfacePoint> path(int label, const SurfacePoint& p) = 0;
};

}  // namespace gvd
