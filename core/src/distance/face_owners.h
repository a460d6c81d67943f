// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "base/sparse_lists.h"
#include "distance/label_turns.h"
#include "distance/nearest_bounds.h"
#include "distance/site_set.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// The labels that own part of each closed face: labels that own a corner, that have their site in
/// the face, or that are nearest somewhere on a side by interpolation between its ends
/// (`LabelClosure`). Owners decide which distances a diagram needs: *a label that is nearest
/// anywhere on a closed face is known at all three corners*.
class FaceOwners {
 public:
  static constexpr int kSeveral = -2;

  struct Owner {
    int label;
    bool isInterpolated;  ///< found by `LabelClosure` only
  };

  FaceOwners(const TriangleMesh& mesh, const SiteSet& sites, const NearestBounds& bounds)
      : mesh_(mesh), sites_(sites), bounds_(bounds) {}
  /// Makes room, in slices; true when it is there.
  bool prepare(long& budget) {
    return fillInSlices(sole_, mesh_.faceCount(), -1, budget) &&
           several_.addLists(mesh_.faceCount(), budget);
  }

  /// The only owner of a face; -1 if no label reaches it, `kSeveral` if there are more.
  int sole(int face) const { return sole_[face]; }
  /// The owners of a face with several; empty if there is a sole owner.
  std::span<const Owner> several(int face) const { return several_[face]; }
  bool has(int face, int label) const;

  /// Sets the owners of a face to those of its corners and the sites in it. Appends to `required`
  /// all of them, if there are several: each must then be known at all corners.
  void reset(int face, std::vector<Requirement>& required);
  /// Adds a label that owns part of a face. Appends to `required` the owners that have to be known
  /// at all corners from now on: the label, and the one that was the sole owner.
  void add(int face, int label, bool isInterpolated, std::vector<Requirement>& required);
  /// Removes a label if it was found by interpolation; returns whether it was.
  bool removeInterpolated(int face, int label);

 private:
  const TriangleMesh& mesh_;
  const SiteSet& sites_;
  const NearestBounds& bounds_;
  std::vector<int> sole_;
  SparseLists<Owner> several_;  ///< empty where there is a sole owner
};

}  // namespace gvd
