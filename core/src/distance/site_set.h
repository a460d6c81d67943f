// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "base/sparse_lists.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"
#include "mesh/incidence.h"

namespace gvd {

/// Sites that are looked up and changed in about one unit of the budget.
inline constexpr long kSitesPerUnit = 2;

/// A site in a face or on one of its sides.
struct FaceSite {
  int label;
  Eigen::Vector3d bary;
};

/// The sites by label, and those of each face. A site on an edge belongs to the faces on both
/// sides; a site on a vertex to the face that it was given by.
class SiteSet {
 public:
  explicit SiteSet(const TriangleMesh& mesh) : mesh_(mesh) {}
  /// Makes room, in slices; true when it is there. Before any site is inserted.
  bool prepare(long& budget) { return inFace_.addLists(mesh_.faceCount(), budget); }

  /// One more than the largest label so far.
  int labelCount() const { return static_cast<int>(points_.size()); }
  int count() const { return count_; }
  bool contains(int label) const {
    return label >= 0 && label < labelCount() && points_[label].face >= 0;
  }
  const SurfacePoint& operator[](int label) const { return points_[label]; }
  /// Calls `visit` with a label's site in each face whose `inFace` list has it.
  template <class Visit>
  void visitFacesOf(int label, Visit visit) const {
    const SurfacePoint& point = points_[label];
    if (incidenceOf(point.bary).corner >= 0) return visit(point);
    visitRepresentations(mesh_, point, visit);
  }
  std::span<const FaceSite> inFace(int face) const { return inFace_[face]; }

  /// The site comes from `onMesh`.
  void insert(int label, const SurfacePoint& site);
  void remove(int label);

 private:
  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> points_;  ///< face -1: there is no site with this label
  SparseLists<FaceSite> inFace_;
  int count_ = 0;
};

}  // namespace gvd
