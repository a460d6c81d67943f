// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/heap.h"
#include "dgpc/dgpc_field.h"
#include "dgpc/dgpc_view.h"
#include "dgpc/fan.h"
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
class DgpcSweep {
 public:
  DgpcSweep(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, Spread spread);

  /// As `Propagation` has them.
  bool step(long budget);
  double progress() const;
  /// The nearest label of each vertex, and how it is seen; once all is done, and only once.
  std::unique_ptr<DgpcField> take();

  // Of a sweep that is done, and until `take`:

  /// The nearest label of a vertex, of those that tie the lowest, and how it is seen; label -1 if
  /// no site reaches the vertex.
  struct Nearest {
    LabelledDistance site;
    View view;
  };
  Nearest nearest(int vertex) const;

 protected:
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
    int label;
    int halfedge;  ///< of the entry's view, also to ask ahead for what is there
    /// By distance; then by what does not depend on which entries were made first: no two of a
    /// label have the same halfedge.
    bool operator<(const QueueItem& other) const {
      if (distance != other.distance) return distance < other.distance;
      return label != other.label ? label < other.label : halfedge < other.halfedge;
    }
  };

  int find(int vertex, int label) const;
  double distanceAt(int vertex, int label) const;
  int vertexOf(int entry) const;
  void addLabels(int count);
  void seed(int label);
  void queue(int entry);
  void startAnew();
  long drain(long budget);
  bool reachTheUnseen();

  const TriangleMesh& mesh_;
  std::vector<SurfacePoint> sites_;
  std::vector<Entry> entries_;
  std::vector<View> views_;         ///< of the entries
  std::vector<int> vertices_;       ///< of the entries behind the first ones
  std::vector<int> released_;       ///< entries behind the first ones that are free
  std::vector<int> owner_;          ///< the nearest label of each vertex, -1 if none has come
  int reachedVertices_ = 0;         ///< that have an owner
  std::vector<char> meetsShadows_;  ///< per label, whether it has come to a sharp vertex
  /// Per label, whether what it knows depends on more than on what has been nearer: on whether it
  /// had met a shadow by then, on what nobody else sees, on which of two that tie came first.
  std::vector<char> isEntangled_;
  /// The entries that have improved when others had been settled that are further, several times.
  std::vector<int> late_;
  /// The entries that have taken an offer, several times; noted only if that is asked for.
  std::vector<int> accepted_;
  bool notesAccepted_ = false;

 private:
  /// An entry that goes on to its neighbours.
  struct Origin {
    View view;
    Eigen::Vector2d path;  ///< from the view's source
    int vertex, label;
    double distance;
    bool isLimit;  ///< whether it limits views past it
  };

  double leastAt(int vertex) const;
  int nearestEntry(int vertex) const;
  int add(int vertex, int label);
  template <class MakeView>
  void offer(int vertex, int label, double distance, MakeView view);
  void prefetchUpcoming() const;
  void settle(int entry);
  void spreadFromSite(int vertex, int label);
  bool mayBend(int vertex, double distance) const;
  bool isLeastAt(int vertex, double distance) const;
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

  Spread spread_;
  std::vector<char> limits_;   ///< limitsViews, per vertex
  std::vector<char> isSharp_;  ///< castsShadow, per vertex
  SweepQueue<QueueItem> queue_;
  double clock_ = 0;  ///< how far settling has come
};

}  // namespace gvd
