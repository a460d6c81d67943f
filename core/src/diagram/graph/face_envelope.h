// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "gvd/surface_point.h"

namespace gvd {

/// One label's linear function on a triangle, by its values at the three corners: the squared
/// distances there. The term |p|² is common to all labels, so the label with the least function is
/// nearest: exactly in the plane, approximately on a surface (Melvær & Reimers 2014, eq. 3: the
/// crossing on an edge is the zero of the difference of two functions).
struct LabelFunction {
  int label;
  std::array<double, 3> value;
};

/// The lower envelope of linear functions on a triangle: a partition into one convex cell for each
/// label that is least somewhere.
///
/// The combinatorics are exact for the doubles given: every decision is the sign of a difference or
/// of a determinant, computed exactly, and ties go to the lower label as if label l were raised by
/// an infinitesimal that grows with l (simulation of simplicity). So cells are never missing or
/// crossed, every inner vertex has exactly three cells and every side vertex two; where the input
/// is degenerate, vertices coincide and cells have no area. Two triangles with a common side, and
/// the same values for the labels that are least on it, get the same side vertices in the same
/// order.
///
/// Below, a function is named by its index in the list given, which is in the order of labels.
class FaceEnvelope {
 public:
  /// Across a side of a cell is the cell of a function, or one of the triangle's own sides: -1 - i
  /// for side i, from corner i to the next.
  static constexpr int across(int side) { return -1 - side; }
  static constexpr bool isTriangleSide(int across) { return across < 0; }
  static constexpr int triangleSide(int across) { return -1 - across; }

  struct Vertex {
    /// `kGone`: within a cell that was cut later, so no cell has it any more.
    enum Kind { kCorner, kOnSide, kInside, kGone } kind;
    int place;                     ///< the corner, or the side
    std::array<int, 3> functions;  ///< kOnSide: before and after, going along the side; kInside:
                                   ///< counterclockwise; -1 where there is none
  };
  /// A cell's side starts at `vertex` and goes counterclockwise to the next one's.
  struct CellSide {
    int vertex;
    int across;
  };
  struct Cell {
    int function;
    int begin, end;  ///< of its sides
  };

  /// Where two cells meet: that of `left`, with the lower label, and that of `right`.
  struct Segment {
    int tail, tip;  ///< vertices
    int left, right;
  };

  /// `functions`: at least one, ascending by label. They must outlive all later calls. O(n²) for n
  /// functions that are least or tie somewhere, at worst O(n³).
  void compute(std::span<const LabelFunction> functions);

  /// The first three are the corners.
  const std::vector<Vertex>& vertices() const { return vertices_; }
  const std::vector<Cell>& cells() const { return cells_; }
  std::span<const CellSide> sides(const Cell& cell) const {
    return {sides_.data() + cell.begin, sides_.data() + cell.end};
  }
  /// The sides of all cells, one cell after the other.
  const std::vector<CellSide>& sides() const { return sides_; }
  /// In the order of the cells on their left.
  const std::vector<Segment>& segments() const { return segments_; }
  /// Sets `bary` to where a vertex lies: number by number, as in bisector_graph.h.
  void setBary(const Vertex& v, Eigen::Vector3d& bary) const;
  int label(int function) const { return functions_[function].label; }
  const std::array<double, 3>& value(int function) const { return functions_[function].value; }

 private:
  /// The envelope of most mixed triangles: two cells with a straight cut between them. `high` is -1
  /// if there is one cell only.
  struct Cut {
    int low = 0, high = -1;        ///< functions, ascending
    std::array<bool, 3> isHigh{};  ///< per corner: whether it is in the cell of `high`

    int functionAt(int corner) const { return isHigh[corner] ? high : low; }
  };

  double shareOfSide(const Vertex& v) const;
  void setInnerBary(const Vertex& v, Eigen::Vector3d& bary) const;
  bool isBelow(int f, const Vertex& v) const;
  bool cutTriangle(int f);
  bool isBelowCut(int f) const;
  void buildCut();
  void findSegments();
  void insert(int f);
  void cutCell(const Cell& cell, int f);
  void addCellOfLinks(int f);
  int cutVertex(const Cell& cell, const CellSide& from, const CellSide& to, bool toIsBelow, int f);

  /// A piece of the outline of the cell being inserted, from vertex to vertex.
  struct Link {
    int from, to, across;
  };
  /// A side between two former cells that the new cell cuts, and the vertex there.
  struct CutSide {
    int from, to, vertex;
  };

  std::span<const LabelFunction> functions_;
  Cut cut_;
  std::vector<Vertex> vertices_;
  std::vector<Cell> cells_;
  std::vector<CellSide> sides_;
  std::vector<Segment> segments_;

  // While a function is inserted.
  std::vector<char> below_;     ///< per vertex: whether the function is below the envelope there
  std::vector<Link> links_;     ///< in no order
  std::vector<CutSide> cuts_;   ///< by the cells on their first sides
  std::vector<CellSide> kept_;  ///< what remains of the sides of all cells
};

inline void FaceEnvelope::setBary(const Vertex& v, Eigen::Vector3d& bary) const {
  if (v.kind == Vertex::kInside) return setInnerBary(v, bary);
  const int i = v.place, j = cornerAfter(i);
  const double share = v.kind == Vertex::kOnSide ? shareOfSide(v) : 0;
  bary[i] = 1 - share;
  bary[j] = share;
  bary[3 - i - j] = 0;
}

/// Where two functions are equal on a side, as a share of the way from its first corner. Two
/// triangles that name the corners in the same order get the same bits.
inline double FaceEnvelope::shareOfSide(const Vertex& v) const {
  const auto [low, high] = std::minmax(v.functions[0], v.functions[1]);
  const auto &a = value(low), &c = value(high);
  const int i = v.place, j = cornerAfter(i);
  const double first = a[i] - c[i], second = a[j] - c[j];
  // `first` and `second` have opposite signs or one is zero; both are zero only if a perturbed tie
  // made the crossing.
  const double span = first - second;
  return span == 0 ? 0.5 : std::clamp(first / span, 0.0, 1.0);
}

}  // namespace gvd
