// SPDX-License-Identifier: MIT
#include "dgpc/inside_straightening.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <optional>
#include <vector>

#include "base/plane.h"
#include "dgpc/path_straightening.h"
#include "mesh/unfolding.h"

namespace gvd {
namespace {

using Eigen::Vector2d;

/// What distances may come to err by, as a share of them, before a path is straightened: an
/// estimate that adds up, from one neighbour to the next, the curvature times the edge. The errors
/// themselves are fifty times smaller on average.
constexpr float kMostError = 0.02f;
constexpr float kNotToFollow = static_cast<float>(kInfinity);

class InsideStraightening {
 public:
  explicit InsideStraightening(DgpcField& field)
      : mesh_(field.mesh()), field_(field), straightener_(field), error_(mesh_.vertexCount()) {}

  void run() {
    for (const Inside& inside : bentInsides()) {
      const auto [label, distance, v] = inside;
      if (const auto unfolded = unfoldFromNeighbours(v, label)) {
        set(v, label, unfolded->path, unfolded->error);
      } else if (const auto path = straightener_.straighten(label, v, field_.view(v))) {
        set(v, label, *path, path->bends ? kNotToFollow : 0);
      }
    }
  }

 private:
  /// A vertex that knows of one label only.
  struct Inside {
    int label;
    double distance;
    int vertex;
    auto operator<=>(const Inside& other) const = default;
  };
  struct Unfolded {
    LocalGeodesic path;
    float error;  ///< as a share of the length
  };

  /// Those where views bend: one label's after the other's, the nearest first, for what follows
  /// from neighbours follows from nearer ones.
  std::vector<Inside> bentInsides() {
    std::vector<Inside> insides;
    for (int v = 0; v < mesh_.vertexCount(); ++v) {
      if (!field_.view(v).isBent()) continue;
      error_[v] = kNotToFollow;
      if (field_.at(v).size() != 1) continue;
      insides.push_back({field_.nearest(v).label, field_.nearest(v).distance, v});
    }
    std::sort(insides.begin(), insides.end());
    return insides;
  }

  void set(int vertex, int label, const LocalGeodesic& path, float error) {
    const LabelledDistance distance{label, path.length};
    field_.setLabels(vertex, {&distance, 1}, {&path.departure, 1});
    error_[vertex] = error;
  }

  /// The path that follows from those of the ends of the edge through which a vertex sees the site.
  /// Nothing if it does not see it there, or if that would err by too much.
  std::optional<Unfolded> unfoldFromNeighbours(int vertex, int label) const {
    const int h = field_.view(vertex).halfedge, tail = mesh_.tail(h), tip = mesh_.tip(h);
    if (field_.nearest(tail).label != label || field_.nearest(tip).label != label) return {};
    const float errorBefore = std::max(error_[tail], error_[tip]);
    if (!(errorBefore < kMostError)) return {};

    const double atTail = field_.distanceAt(tail, label), atTip = field_.distanceAt(tip, label);
    const auto source = virtualSource(mesh_, h, atTail, atTip);
    if (!source || !seesApex(mesh_, h, *source)) return {};
    const TriangleMesh::Layout& l = mesh_.layout(h);
    const Vector2d toTail = -*source, toTip = Vector2d(l.length, 0) - *source;
    const Vector2d toApex = Vector2d(l.x, l.y) - *source;
    const double length = toApex.norm();

    // The directions at the site, at which the three differ as they do at the virtual source.
    const Vector2d fromTail = field_.direction(label, tail), fromTip = field_.direction(label, tip);
    const Vector2d turn = turnedBackBy(toTail, toTip) / (atTail * atTip);
    const double curvature = (turnedBy(fromTip, turn) - fromTail).norm();
    const float error = errorBefore + static_cast<float>(curvature * l.length / length);
    if (!(error <= kMostError)) return {};
    const Vector2d departure = turnedBy(fromTip, turnedBackBy(toApex, toTip)) / atTip +
                               turnedBy(fromTail, turnedBackBy(toApex, toTail)) / atTail;
    return Unfolded{{length, departure.normalized()}, error};
  }

  const TriangleMesh& mesh_;
  DgpcField& field_;
  PathStraightener straightener_;
  /// Of each vertex's distance, as a share of it; kNotToFollow where a path bends, or may: what is
  /// behind a bend is seen from there.
  std::vector<float> error_;
};

}  // namespace

void straightenInsides(DgpcField& field) { InsideStraightening(field).run(); }

}  // namespace gvd
