// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "dgpc/dgpc_view.h"
#include "dgpc/fan.h"
#include "gvd/geodesic.h"

namespace gvd {

/// Distances at the vertices; inside a face as the views of its corners give them, or as the
/// interpolation of the corners' distances does, whichever is shorter: views are limited and so err
/// towards too long, and interpolation misses what comes between the corners.
class DgpcField final : public DistanceField {
 public:
  /// `nearest` and `views` are those of the vertices; label -1 where no site has come. Nothing else
  /// is known of a vertex until its list of labels has been set.
  DgpcField(const TriangleMesh& mesh, std::vector<SurfacePoint> sites,
            std::vector<LabelledDistance> nearest, std::vector<View> views);

  std::span<const LabelledDistance> at(int vertex) const override;
  LabelledDistance nearest(const SurfacePoint& p) const override;
  double distance(int label, const SurfacePoint& p) const override;
  Eigen::Vector2d direction(int label, int vertex) const override;

  // For those who fill it:

  const TriangleMesh& mesh() const { return mesh_; }
  /// Of a label without a site, face -1.
  std::span<const SurfacePoint> sites() const { return sites_; }
  /// The nearest label of a vertex, of those that tie the lowest, and how it is seen.
  const LabelledDistance& nearest(int vertex) const { return nearest_[vertex]; }
  const View& view(int vertex) const { return views_[vertex]; }
  /// The distance of a label that is known at a vertex.
  double distanceAt(int vertex, int label) const { return find(vertex, label)->distance; }
  /// Whether some label has come to be known at a vertex from further than its neighbours.
  bool hasFarLabel(int vertex) const { return hasFarLabel_[vertex]; }

  /// What has been found out about ties where paths bend (SaddleTies); in no order.
  struct Ties {
    struct Told {
      int vertex, from;
    };
    std::vector<int> origins;  ///< the vertices where ties begin that are carried on
    std::vector<Told> told;    ///< to which other vertices they have been, and from where
  };
  Ties& ties() { return ties_; }
  const Ties& ties() const { return ties_; }

  void setSite(int label, const SurfacePoint& site);
  /// Does not change the list of labels.
  void setNearest(int vertex, const LabelledDistance& nearest, const View& view);
  void setFarLabel(int vertex, bool hasFarLabel) { hasFarLabel_[vertex] = hasFarLabel; }
  /// The labels known at a vertex, ascending, ties made equal; and the directions in which the
  /// paths to it leave their sites, zero for the owner if that is as its view tells.
  void setLabels(int vertex, std::span<const LabelledDistance> labels,
                 std::span<const Eigen::Vector2d> departures);
  /// Adds one label to those of a vertex, or changes what is known of it.
  void setLabel(int vertex, const LabelledDistance& label, const Eigen::Vector2d& departure);
  /// Room for so many labels in all.
  void reserve(size_t labels);

 private:
  const LabelledDistance* find(int vertex, int label) const;
  double interpolate(int label, const SurfacePoint& p) const;
  double distanceSeenFrom(int corner, const SurfacePoint& p) const;
  template <Side side>
  double distanceAside(const View& view, const Eigen::Vector2d& path, const SurfacePoint& p) const;

  /// Where the labels of a vertex are in `values_`. What a list leaves behind that has outgrown its
  /// room stays unused, once for every size it has had. Most vertices have none: there the nearest
  /// label is all that is known.
  struct List {
    int first = 0, count = kNone, room = 0;
    static constexpr int kNone = -1;
  };

  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> sites_;
  std::vector<LabelledDistance> nearest_;
  std::vector<View> views_;
  std::vector<char> hasFarLabel_;
  Ties ties_;
  std::vector<List> lists_;
  std::vector<LabelledDistance> values_;
  std::vector<Eigen::Vector2d> departures_;  ///< one per value
};

}  // namespace gvd
