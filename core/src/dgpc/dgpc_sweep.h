// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/heap.h"
#include "base/index_set.h"
#include "dgpc/dgpc_view.h"
#include "dgpc/fan.h"
#include "distance/metric.h"
#include "gvd/geodesic.h"

namespace gvd {

/// One sweep of all labels through one queue: Dijkstra's, with views carried from vertex to vertex.
/// Label-correcting: an entry that has spread may improve again and then spreads again, which
/// obtuse triangles need.
///
/// DGPC as published keeps distance and angle per vertex and finds those of the next vertex from
/// two known ones by a virtual source. Carrying the unfolded source itself costs less (one root
/// instead of two, no second vertex that must be known), does not blur what comes from both sides
/// of a ridge, and errs towards too long: what saddles and the boundary hide is cut off where the
/// fans meet them. What lies beyond the fans may hide more; sharp saddles and holes do so by far,
/// so labels that have come to one walk every line before they take it.
class DgpcSweep final : public Propagation {
 public:
  DgpcSweep(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Spread spread,
            Straightens straightens);

  bool step(long budget) override;
  double progress() const override;
  std::unique_ptr<DistanceField> take() override;

  // Of a sweep that is done, and until `take`:

  /// The nearest label of a vertex, of those that tie the lowest, and how it is seen; label -1 if
  /// no site reaches the vertex.
  struct Nearest {
    LabelledDistance site;
    View view;
  };
  Nearest nearest(int vertex) const;

  /// Puts the site of a label to another place, takes it away (face -1), or adds one: what is known
  /// is then what a sweep of the present sites would find. Labels are numbers from 0. O(what is
  /// known), with little for each, and a sweep of the label and of those around it.
  void setSite(int label, const SurfacePoint& site);
  /// The vertices of which the nearest label, or what it knows, may have changed since this was
  /// called last, in no order.
  std::vector<int> takeTouched();

 private:
  /// What one label knows at one vertex. Entry v is the first one of vertex v, further ones follow
  /// behind those of all vertices: most vertices need no more than the first. The view is kept
  /// apart: most entries are looked at, but not gone on from.
  struct Entry {
    double distance = kInfinity;
    int label = -1;
    int next = -1;  ///< the next entry of the same vertex, -1 at the end
  };

  struct QueueItem {
    double distance;
    int entry;
    int halfedge;  ///< of the entry's view, to ask ahead for what is there
    /// By distance; then by entry, which makes the order total.
    bool operator<(const QueueItem& other) const {
      return distance < other.distance || (distance == other.distance && entry < other.entry);
    }
  };

  /// All that a label knows.
  struct Knowledge {
    struct Place {
      int vertex;
      double distance;
      View view;
    };
    int label;
    std::vector<Place> places;
  };

  /// An entry that goes on to its neighbours.
  struct Origin {
    View view;
    Eigen::Vector2d path;  ///< from the view's source
    int vertex, label;
    double distance;
    bool isLimit;  ///< whether it limits views past it
  };

  int find(int vertex, int label) const;
  double distanceAt(int vertex, int label) const;
  double leastAt(int vertex) const;
  int nearestEntry(int vertex) const;
  int add(int vertex, int label);
  void remove(int entry);
  void release(int entry);
  int vertexOf(int entry) const;
  template <class MakeView>
  void offer(int vertex, int label, double distance, MakeView view);
  void touch(int vertex);

  void seed(int label);
  void indexEntries();
  Knowledge knowledgeOf(int label) const;
  void forget(int label);
  void sweepAnew(std::span<const int> labels);
  std::vector<int> labelsAround(std::span<const int> vertices, std::span<const int> without) const;
  void disturbDifferences(const Knowledge& before);

  long drain(long budget);
  void prefetchUpcoming() const;
  void settle(int entry);
  void spreadFromSite(int vertex, int label);
  bool mayBend(int vertex, double distance) const;
  bool isHidden(const Origin& from, int outer, const Eigen::Vector2d& toOuter) const;
  bool mayCross(const Origin& from, int outer, const Eigen::Vector2d& toOuter) const;
  bool isFutile(int vertex, int label, const Eigen::Vector2d& way, double before) const;
  bool isImproved(int vertex, int label, double distance) const;
  bool isClear(const View& view, int label) const;
  template <Side side>
  int carry(const Origin& from, bool isBend, int last);
  template <Side side, class MakeView>
  void offerIfClear(const Origin& from, const FanFace& face, int at, double distance,
                    MakeView view);
  template <Side side>
  void limit(View& view, const Origin& from, const FanFace& face, const Eigen::Vector2d& shift,
             const Eigen::Vector2d& outerBound) const;
  template <Side side>
  void bend(const Origin& from, const FanFace& face, int at);
  bool reachTheUnseen();

  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> sites_;
  Spread spread_;
  Straightens straightens_;
  std::vector<char> limits_;        ///< limitsViews, per vertex
  std::vector<char> isSharp_;       ///< castsShadow, per vertex
  std::vector<char> meetsShadows_;  ///< per label, whether it has come to such a vertex
  std::vector<Entry> entries_;
  std::vector<View> views_;    ///< of the entries
  std::vector<int> vertices_;  ///< of the entries behind the first ones
  std::vector<int> released_;  ///< entries behind the first ones that are free
  std::vector<int> owner_;     ///< the nearest label of each vertex, -1 if none has come
  SweepQueue<QueueItem> queue_;
  int reachedVertices_ = 0;
  // Empty before the first change of sites:
  std::vector<std::vector<int>> verticesOf_;  ///< per label, where it is known
  std::vector<char> isTouched_, isMarked_;    ///< per vertex
  std::vector<int> touched_;
  IndexSet disturbed_;  ///< the vertices where a change of sites has changed anything
};

}  // namespace gvd
