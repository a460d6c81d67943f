// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "distance/site_set.h"
#include "distance/ties.h"
#include "gvd/geodesic.h"
#include "mesh/incidence.h"

namespace gvd::exact {

/// Bounds on the distances of the labels that a search from a point looks for.
class SearchBounds {
 public:
  virtual ~SearchBounds() = default;
  /// A lower bound on the distance of each of the labels at a vertex.
  virtual double atLeast(int vertex) const = 0;
  /// An upper bound for one of the labels: the length of a known path, infinity if there is none.
  virtual double atMost(int vertex) const = 0;
  /// Whether a label is one of those searched for.
  virtual bool isSought(int label) const = 0;
};

/// The sites that a search from a point has found, and the length of the shortest path to one of
/// them (`WindowSweep::search`).
class SiteSearch {
 public:
  SiteSearch(const TieTolerance& ties, const SiteSet& sites) : ties_(ties), sites_(sites) {}

  void start(const SearchBounds& bounds) {
    bounds_ = &bounds;
    shortest_ = kInfinity;
    found_.clear();
  }
  /// The length of the shortest path so far, infinity if there is none.
  double shortest() const { return shortest_; }
  /// The sites found, except those on vertices: these are at distance 0 from their vertex.
  std::span<const LabelledDistance> found() const { return found_; }

  /// How far a vertex may be from the point for a path over it to be no longer than the shortest
  /// known one, ties included. Along an edge that ends at the vertex, the limit rises by the way
  /// from the vertex.
  double mostAt(int vertex) const { return ties_.mostTying(shortest_) - bounds_->atLeast(vertex); }
  /// Offers the path over a vertex at this distance from the point.
  void offerVertex(int vertex, double distance) {
    shortest_ = std::min(shortest_, distance + bounds_->atMost(vertex));
  }
  /// Offers a path to a site; returns whether it is one of the shortest so far.
  bool offerSite(int label, double length) {
    if (!ties_.isAtMost(length, shortest_)) return false;
    shortest_ = std::min(shortest_, length);
    found_.push_back({label, length});
    return true;
  }
  /// Calls `visit` with each site in a face that is searched for and on no vertex.
  template <class Visit>
  void visitSites(int face, Visit visit) const {
    for (const FaceSite& site : sites_.inFace(face))
      if (bounds_->isSought(site.label) && incidenceOf(site.bary).corner < 0) visit(site);
  }

 private:
  const TieTolerance& ties_;
  const SiteSet& sites_;
  const SearchBounds* bounds_ = nullptr;
  double shortest_ = kInfinity;
  std::vector<LabelledDistance> found_;
};

}  // namespace gvd::exact
