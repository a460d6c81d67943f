// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "base/index_set.h"
#include "distance/label_spread.h"
#include "distance/nearest_bounds.h"
#include "distance/site_set.h"
#include "distance/small_lists.h"
#include "gvd/triangle_mesh.h"

namespace gvd {

/// A label whose distances are required at all corners of a face.
struct Requirement {
  int label, face;
};

/// The labels that own part of each closed face: those that own a corner, those with their site in
/// the face, and those that are nearest somewhere on a side by interpolation between its ends
/// (`KnownLabels::close`). This decides which distances a diagram needs: *a label that is least
/// anywhere on a closed face is known at all three corners*.
class FaceOwners {
 public:
  static constexpr int kSeveral = -2;

  struct Owner {
    int label;
    bool isInterpolated;  ///< shown by interpolation only
  };

  FaceOwners(const TriangleMesh& mesh, const SiteSet& sites, const NearestBounds& bounds)
      : mesh_(mesh),
        sites_(sites),
        bounds_(bounds),
        sole_(mesh.faceCount(), -1),
        several_(mesh.faceCount()) {}

  /// The one label that owns all of a face, -1 if none reaches it, `kSeveral`.
  int sole(int face) const { return sole_[face]; }
  /// The owners of a face, if these are several.
  std::span<const Owner> several(int face) const { return several_[face]; }
  bool has(int face, int label) const;

  /// Forgets the owners of a face and finds those of its corners.
  void reset(int face, std::vector<Requirement>& found);
  /// Adds a label that owns part of a face.
  void add(int face, int label, bool isInterpolated, std::vector<Requirement>& found);
  /// Takes out the labels that are owners by interpolation; returns whether there were any.
  bool removeInterpolated(int face);

 private:
  const TriangleMesh& mesh_;
  const SiteSet& sites_;
  const NearestBounds& bounds_;
  std::vector<int> sole_;
  SmallLists<Owner> several_;  ///< empty where there is a sole owner
};

}  // namespace gvd
