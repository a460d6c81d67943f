// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <unordered_map>
#include <vector>

#include "gvd/diagram.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/surface_point.h"

namespace gvd {

/// A diagram in pieces that are replaced one by one; each has its own copy of its points.
class DiagramPieces {
 public:
  /// That of no sites: no region reaches any face.
  explicit DiagramPieces(int faceCount)
      : faceLabel_(faceCount, Diagram::kUnreachable), isIndifferent_(faceCount) {}

  /// Puts the pieces of a change in the place of all that there was of its labels and faces.
  /// Takes time for all arcs and Voronoi points, and for the change. Areas stay as they are.
  void replace(const DiagramChange& change);

  void setArea(int label, double area) { regions_[label].area = area; }

  /// The faces that a region has all of, ascending; good until the next call that changes
  /// something.
  const std::vector<int>& wholeFaces(int label);

  /// All pieces as one diagram, which has each place once among its points.
  Diagram whole() const;

 private:
  struct Region {
    double area = 0;
    std::vector<std::vector<SurfacePoint>> loops;
    std::vector<int> faces;  ///< those it has all of, and some that it had
  };
  struct Segment {
    SurfacePoint from, to;
    int face;
  };
  struct Arc {
    std::array<int, 2> labels;
    std::vector<SurfacePoint> points;
    std::vector<Segment> segments;
  };
  struct VoronoiPoint {
    SurfacePoint place;
    std::vector<int> labels;
  };
  struct Cell {
    int label;
    std::vector<SurfacePoint> outline;
  };

  void removePieces(const DiagramChange& change);

  std::vector<Region> regions_;
  std::vector<Arc> arcs_;
  std::vector<VoronoiPoint> voronoiPoints_;
  std::vector<int> faceLabel_;
  std::vector<char> isIndifferent_;
  std::unordered_map<int, std::vector<Cell>> cells_;  ///< by face
};

/// Copies out of a diagram the loops, arcs and Voronoi points of the labels for which `isWanted`,
/// one per label, says so, and the cells of some faces, given ascending, with those of them that
/// are indifferent. Points are numbered anew; the labels of faces and the areas are left out.
Diagram extract(const Diagram& from, std::span<const char> isWanted, std::span<const int> faces);

}  // namespace gvd
