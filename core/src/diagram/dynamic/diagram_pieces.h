// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "base/index_set.h"
#include "base/sliced_loop.h"
#include "gvd/diagram.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/sliced_work.h"
#include "gvd/surface_point.h"

namespace gvd {

/// A diagram in pieces that are replaced one by one; each has its own copy of its points.
class DiagramPieces {
 public:
  /// A diagram without sites: no region reaches any face.
  explicit DiagramPieces(int faceCount)
      : faceLabel_(faceCount, Diagram::kUnreachable),
        isIndifferent_(faceCount),
        cellsOf_(faceCount, -1) {}

  /// Replaces all pieces of a change's labels and faces by those of the change, in slices; true
  /// when done. Takes time proportional to the pieces replaced. Areas do not change.
  bool replace(const DiagramChange& change, long& budget);

  void setArea(int label, double area) { regions_[label].area = area; }

  /// The region triangles of a label, ascending; valid until the next change.
  const std::vector<int>& regionTriangles(int label);

  /// Starts to join all pieces to one diagram, in which each place is one point. No piece may be
  /// replaced meanwhile.
  std::unique_ptr<SlicedWork<Diagram>> startDiagram() const;

 private:
  class Joining;

  /// Items with stable numbers. New items reuse the memory of removed ones, including their lists,
  /// because an edit usually adds about as much as it removes.
  template <class Item>
  class Pool {
   public:
    /// The number of a new item, which still has the content of the removed item it reuses.
    int add() {
      if (free_.empty()) {
        free_.push_back(static_cast<int>(items_.size()));
        items_.emplace_back();
        isUsed_.push_back(false);
      }
      const int number = free_.back();
      free_.pop_back();
      isUsed_[number] = true;
      return number;
    }
    void remove(int number) {
      isUsed_[number] = false;
      free_.push_back(number);
    }
    Item& operator[](int number) { return items_[number]; }
    const Item& operator[](int number) const { return items_[number]; }
    /// One more than the largest number.
    int limit() const { return static_cast<int>(items_.size()); }
    bool isUsed(int number) const { return isUsed_[number]; }

   private:
    std::vector<Item> items_;
    std::vector<char> isUsed_;
    std::vector<int> free_;
  };

  struct Region {
    double area = 0;
    std::vector<std::vector<SurfacePoint>> loops;
    std::vector<int> faces;  ///< its region triangles, and some that no longer are
    std::vector<int> arcs, voronoiPoints;
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
  /// The cells of a face, one outline after the other.
  struct Cells {
    struct Cell {
      int label;
      int end;  ///< in `points`
    };
    std::vector<Cell> cells;
    std::vector<SurfacePoint> points;
  };

  void removePiecesOf(int label);
  void removePiecesIn(int face);
  template <class Piece>
  void remove(std::vector<int>& pieces, Pool<Piece>& pool);
  void unlistRemoved(int label);
  void addArc(const Diagram& part, int arc);
  void addVoronoiPoint(const Diagram& part, const Diagram::VoronoiPoint& point);
  void addCell(const Diagram& part, int cell);

  std::vector<Region> regions_;
  Pool<Arc> arcs_;
  Pool<VoronoiPoint> voronoiPoints_;
  std::vector<int> faceLabel_;
  std::vector<char> isIndifferent_;
  std::vector<int> cellsOf_;  ///< per face, -1: it has none
  Pool<Cells> cells_;

  // The current change.
  SlicedSequence replacing_;
  /// Unchanged labels beside a changed one: their lists still name arcs and Voronoi points that the
  /// change has removed.
  std::vector<int> beside_;
  std::vector<int> arcOf_;  ///< the numbers of its arcs
};

/// The change that makes a diagram out of none.
DiagramChange changeTo(Diagram diagram);

/// Copies out of a diagram the loops, arcs and Voronoi points of some labels, the cells of some
/// faces, given ascending, and which of these faces are indifferent. Points are numbered anew;
/// `faceLabel` and areas are left empty.
Diagram extract(const Diagram& from, const IndexSet& labels, std::span<const int> faces);

}  // namespace gvd
