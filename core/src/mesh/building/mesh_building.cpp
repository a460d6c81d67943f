// SPDX-License-Identifier: MIT
//
// Building a mesh: the stages, one after the other, in slices.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "gvd/sliced_work.h"
#include "gvd/triangle_mesh.h"
#include "mesh/building/boundary_gaps.h"
#include "mesh/building/input_map.h"
#include "mesh/building/manifold_building.h"
#include "mesh/building/mesh_measuring.h"
#include "mesh/building/t_junctions.h"
#include "mesh/building/triangle_selection.h"
#include "mesh/building/vertex_welding.h"
#include "mesh/genus.h"
#include "mesh/given_triangles.h"

namespace gvd {
namespace {

void requireValid(const MeshOptions& options) {
  if (!(options.weld >= 0 && options.weld <= 1))
    rejectArgument("weld is " + numberText(options.weld) + ", not a number from 0 to 1");
  if (options.minComponent < 0)
    rejectArgument("minComponent is " + std::to_string(options.minComponent) +
                   ", not a number of 0 or more");
}

}  // namespace

/// Builds a manifold from any list of triangles, by the steps listed at `TriangleMesh`.
/// Each step writes into the faces of the mesh, and intermediate results are freed as soon as no
/// later step needs them, so that building takes no more memory than the finished mesh.
class MeshBuilding final : public SlicedWork<TriangleMesh> {
 public:
  MeshBuilding(std::vector<double> positions, std::vector<int> triangles,
               const MeshOptions& options)
      : positions_(std::move(positions)), triangles_(std::move(triangles)), options_(options) {
    requireValid(options);
    requireTriples(positions_.size(), triangles_.size());
  }

  bool advance(long budget) override {
    return makeManifold(budget) && placeVertices(budget) && measuring_.step(budget) &&
           findBoundary(budget);
  }

  double share() const override {
    return (making_.progress() + placing_.progress() + measuring_.progress() +
            finding_.progress()) /
           4;
  }

  TriangleMesh result() override { return std::move(mesh_); }

 private:
  /// Steps 1 to 9 at `TriangleMesh`, and the map from the input.
  bool makeManifold(long& budget) {
    TriangleMesh& m = mesh_;
    return making_.run(
        forEach(triangles_.size() / 3, budget, kQuickRounds,
                [&](int t) { requireVertices(triangles_, t, inputVertexCount()); }),
        [&] { return runPart(welding_, budget, positions_, triangles_, options_.weld); },
        [&] {
          weldTolerance_ = welding_->tolerance();
          representative_ = taken(welding_);
          m.inputFaceCount_ = static_cast<int>(triangles_.size() / 3);
        },
        [&] { return selectTriangles(budget); },
        [&] { return weldTolerance_ == 0 || joinTJunctions(budget); },
        [&] { return orient(budget); }, [&] { oriented_ = taken(orienting_); },
        forItems(nonManifold_, budget, 8,
                 [&](const std::vector<int>& edge) {
                   stitch(selection_.faces, oriented_, positions_, edge);
                   return static_cast<long>(edge.size());
                 }),
        [&] { return nonManifold_.empty() || orient(budget); }, [&] { takeStitched(); },
        [&] {
          return runPart(dropping_, budget, options_.minComponent, selection_, oriented_,
                         m.repairs_);
        },
        [&] { dropping_.reset(); },
        [&] { return runPart(mapping_, budget, welded(), selection_, m); }, [&] { takeFaces(); },
        [&] { return runPart(splitting_, budget, m.faces_, inputVertexCount(), m.repairs_); },
        [&] { fans_ = taken(splitting_); });
  }

  bool selectTriangles(long& budget) {
    MeshRepairs& repairs = mesh_.repairs_;
    return selectingRound_.runRound(
        [&] { return runPart(selecting_, budget, welded(), inputVertexCount(), repairs); },
        [&] { selection_ = taken(selecting_); },
        [&] { return runPart(matching_, budget, selection_.faces, inputVertexCount(), repairs); },
        [&] { nonManifold_ = taken(matching_); });
  }

  /// Appends flat triangles to those of the input, and selects again.
  bool joinTJunctions(long& budget) {
    return joining_.run(
        [&] { return runPart(filling_, budget, positions_, selection_.faces, weldTolerance_); },
        [&] { appendFlat(taken(filling_)); },
        [&] { return mesh_.joining_.empty() || selectTriangles(budget); });
  }

  bool orient(long& budget) {
    return runPart(orienting_, budget, selection_.faces, options_.orientation, mesh_.repairs_);
  }

  /// Stitching has made components one. Nothing was turned over again, since they agree.
  void takeStitched() {
    if (!orienting_) return;
    std::vector<char> flipped = std::move(oriented_.flipped);
    oriented_ = taken(orienting_);
    oriented_.flipped = std::move(flipped);
    release(nonManifold_);
  }

  /// The halfedges and the position of each vertex.
  bool placeVertices(long& budget) {
    TriangleMesh& m = mesh_;
    return placing_.run(
        [&] { return fillInSlices(m.fanHalfedges_, m.halfedgeCount(), -1, budget); },
        [&] { takeFans(); },
        forEach(m.inputVertex_, budget, kQuickRounds, [&](int v) { listFan(v); }),
        [&] {
          release(fans_.outgoing);
          if (const std::size_t size = 3 * m.inputVertex_.size(); size > positions_.size()) {
            positions_.reserve(size);
            positions_.resize(size);
          }
        },
        forEach(m.inputVertex_, budget, 8, [&](int v) { takePosition(v); }),
        [&] {
          positions_.resize(3 * m.inputVertex_.size());
          positions_.shrink_to_fit();
          m.positions_ = std::move(positions_);
        });
  }

  /// The boundary loops, what comes close there without being joined, and what follows from the
  /// number of loops.
  bool findBoundary(long& budget) {
    TriangleMesh& m = mesh_;
    return finding_.run(
        [&] { return fillInSlices(isOnFoundLoop_, m.vertexCount(), '\0', budget); },
        forEach(m.vertexCount(), budget, kQuickRounds, [&](int v) { followLoopFrom(v); }),
        [&] { return runPart(gaps_, budget, m, m.positions_, boundary_, m.topology_); },
        [&] { countTopology(); });
  }

  // --- The manifold ------------------------------------------------------------------------------

  void appendFlat(const std::vector<FlatTriangle>& flat) {
    if (flat.empty()) return;
    for (const FlatTriangle& triangle : flat) {
      triangles_.insert(triangles_.end(), triangle.vertices.begin(), triangle.vertices.end());
      mesh_.joining_.push_back({selection_.input[triangle.beside], triangle.corners});
    }
    requireTriples(positions_.size(), triangles_.size());
    mesh_.repairs_ = {};
    mesh_.repairs_.joinedVertices = static_cast<int>(flat.size());
  }

  /// The faces and their input triangles become the mesh's; the input is not needed any more.
  void takeFaces() {
    mapping_.reset();
    release(triangles_);
    release(representative_);
    mesh_.inputFace_ = std::move(selection_.input);
    mesh_.faces_ = std::move(selection_.faces);
    selection_ = {};
    mesh_.flipped_ = std::move(oriented_.flipped);
    mesh_.repairs_.flippedTriangles =
        static_cast<int>(std::count(mesh_.flipped_.begin(), mesh_.flipped_.end(), true));
    mesh_.component_ = std::move(oriented_.component);
  }

  void takeFans() {
    mesh_.inputVertex_ = std::move(fans_.representative);
    mesh_.fanBegin_.reserve(mesh_.inputVertex_.size() + 1);
    mesh_.fanBegin_.push_back(0);
  }

  /// Appends the halfedges that leave a vertex. Vertices come in order.
  void listFan(int vertex) {
    int end = mesh_.fanBegin_.back();
    int h = fans_.outgoing[vertex];
    do {
      mesh_.fanHalfedges_[end++] = h;
      h = mesh_.rotate(h);
    } while (h >= 0 && h != fans_.outgoing[vertex]);
    mesh_.fanBegin_.push_back(end);
  }

  /// Moves positions in place: vertices keep the order of the input, so positions only move towards
  /// the front. A copy takes its position from the first fan of its vertex, which has moved
  /// already.
  void takePosition(int vertex) {
    const auto at = [&](int v) { return positions_.begin() + 3 * static_cast<std::ptrdiff_t>(v); };
    const int firstCopy = mesh_.vertexCount() - mesh_.repairs_.splitVertices;
    int from = mesh_.inputVertex_[vertex];
    if (vertex >= firstCopy) {
      const auto begin = mesh_.inputVertex_.begin();
      from = static_cast<int>(std::lower_bound(begin, begin + firstCopy, from) - begin);
    }
    std::copy(at(from), at(from + 1), at(vertex));
  }

  // --- Topology ----------------------------------------------------------------------------------

  void followLoopFrom(int vertex) {
    if (!mesh_.onBoundary(vertex) || isOnFoundLoop_[vertex]) return;
    mesh_.boundaryLoops_.push_back(mesh_.outgoing(vertex));
    for (int v = vertex; !isOnFoundLoop_[v]; v = mesh_.tip(mesh_.outgoing(v))) {
      isOnFoundLoop_[v] = true;
      boundary_.push_back(v);
    }
  }

  void countTopology() {
    const int boundaryEdges = static_cast<int>(boundary_.size());  // each vertex begins one
    MeshTopology& topology = mesh_.topology_;
    topology.edges = (mesh_.halfedgeCount() + boundaryEdges) / 2;
    topology.components = static_cast<int>(oriented_.size.size());
    topology.eulerCharacteristic = mesh_.vertexCount() - topology.edges + mesh_.faceCount();
    topology.boundaryLoops = static_cast<int>(mesh_.boundaryLoops_.size());
    topology.genus =
        genusOf(topology.components, topology.boundaryLoops, topology.eulerCharacteristic);
  }

  WeldedTriangles welded() const { return {triangles_, representative_}; }
  int inputVertexCount() const { return static_cast<int>(positions_.size() / 3); }

  std::vector<double> positions_;  ///< the input's, later the mesh's
  std::vector<int> triangles_;     ///< the input's
  const MeshOptions options_;
  TriangleMesh mesh_;

  SlicedSequence making_, placing_, finding_;  ///< the stages
  MeshMeasuring measuring_{mesh_};             ///< the stage before the last
  SlicedSequence selectingRound_, joining_;
  std::optional<VertexWelding> welding_;
  double weldTolerance_ = 0;
  std::vector<int> representative_;
  std::optional<TriangleSelection> selecting_;
  Selection selection_;
  std::optional<HalfedgeMatching> matching_;
  std::vector<std::vector<int>> nonManifold_;  ///< the halfedges of each edge
  std::optional<TJunctionFilling> filling_;
  std::optional<TriangleOrienting> orienting_;
  OrientedComponents oriented_;
  std::optional<SmallComponents> dropping_;
  std::optional<FanSplitting> splitting_;
  Fans fans_;
  std::optional<InputMap> mapping_;
  std::vector<char> isOnFoundLoop_;  ///< vertices
  std::vector<int> boundary_;        ///< vertices, along the loops
  std::optional<BoundaryGaps> gaps_;
};

std::unique_ptr<SlicedWork<TriangleMesh>> startMesh(std::vector<double> positions,
                                                    std::vector<int> triangles,
                                                    const MeshOptions& options) {
  return std::make_unique<MeshBuilding>(std::move(positions), std::move(triangles), options);
}

TriangleMesh::TriangleMesh(std::span<const double> positions, std::span<const int> triangles,
                           const MeshOptions& options)
    : TriangleMesh(finished(startMesh({positions.begin(), positions.end()},
                                      {triangles.begin(), triangles.end()}, options))) {}

}  // namespace gvd
