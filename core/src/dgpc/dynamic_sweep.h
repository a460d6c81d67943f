// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "base/index_set.h"
#include "dgpc/dgpc_sweep.h"

namespace gvd {

/// A sweep whose sites come, go and move. What is known is then what a sweep of the present sites
/// would find, and of the labels around a change only that part is swept again that it affects.
///
/// What a label knows at a vertex follows from what has come there, in the order of distances: a
/// vertex keeps one view, and whether a worse one was carried on before the better one came, others
/// see. So the sweep is not mended but replayed, in part. An entry that is settled reads what the
/// owners of its vertex and of the neighbours know, up to the distances at which it would get
/// there. If any of this has changed, the entry is settled again; what may have followed from it is
/// undone first, and comes anew from what is left around. Where this changes more, all is replayed
/// again with what that affects, until it does not.
class DynamicSweep : private DgpcSweep {
 public:
  using DgpcSweep::nearest;

  DynamicSweep(const TriangleMesh& mesh, std::span<const SurfacePoint> sites);

  /// Puts the site of a label to another place, takes it away (face -1), or adds one; labels are
  /// numbers from 0. Sweeps this label twice or more, and of those around it what is affected.
  void setSite(int label, const SurfacePoint& site);
  /// The vertices of which the nearest label, or what it knows, may have changed since this was
  /// called last, in no order.
  std::vector<int> takeTouched();

 private:
  /// What becomes of an entry when a site changes.
  enum class State : char {
    kUnlisted,  ///< not known before, or there is no such entry
    kAsBefore,
    kBesideUndone,  ///< settled again, for something next to it is undone
    kAffected,      ///< settled again, and what may have followed from it is undone
    kUndone,        ///< taken back and maybe found anew, or new
  };

  /// An undone entry as it was; at an infinite distance if it is new.
  struct Undone {
    int entry, vertex, label;
    double distance;
    View view;
  };

  void list(int entry);
  bool findAffected();
  void readFrom(int vertex, double way, double change);
  void affect(int entry);
  bool mustBeWhole(int label) const;
  void undoAll(int label);
  void undo(int entry);
  void undoWhatFollows();
  void undoIfFollowing(int vertex, int label, double distance);
  void replay();
  void markBeside(int vertex, int label);
  void noteAccepted();
  void noteDifferences();
  void finish();
  void findOwner(int vertex);
  void remove(int entry);
  void release(int entry);
  void clear(int entry);

  std::vector<std::vector<int>> verticesOf_;  ///< per label, where it is known
  std::vector<State> state_;                  ///< per entry
  std::vector<char> isLate_;                  ///< per entry
  IndexSet touched_;                          ///< vertices

  // Of the change at hand:
  IndexSet labels_;            ///< those that are replayed, all or in part
  std::vector<char> isWhole_;  ///< per label
  std::vector<Undone> undone_;
  std::vector<int> settledAgain_;  ///< entries beside undone ones, and affected ones
  size_t followed_ = 0;            ///< of so many of these it is undone what follows
  std::vector<double> changeAt_;   ///< per vertex, the least distance that has changed there
  std::vector<int> changed_;       ///< vertices with such a distance
  size_t read_ = 0;                ///< of so many of these it is known who reads them
};

}  // namespace gvd
