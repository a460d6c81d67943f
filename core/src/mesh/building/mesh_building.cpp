// SPDX-License-Identifier: MIT
//
// Building a mesh: the stages, one after the other, in slices.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/bucket_queue.h"
#include "base/number_text.h"
#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "gvd/sliced_work.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"
#include "mesh/building/boundary_gaps.h"
#include "mesh/building/input_map.h"
#include "mesh/building/manifold_building.h"
#include "mesh/building/mollification.h"
#include "mesh/building/t_junctions.h"
#include "mesh/building/triangle_selection.h"
#include "mesh/building/vertex_welding.h"
#include "mesh/genus.h"
#include "mesh/given_triangles.h"

namespace gvd {
namespace {

/// Between these limits, the products of four lengths in the formulas of areas neither overflow nor
/// underflow, however thin the triangles: no edge is shorter than 2^-38 of the mean edge, see
/// `kMollificationMargin`.
constexpr double kLongestDiagonal = 0x1p200;
constexpr double kShortestMeanEdge = 0x1p-200;

/// A face is a needle if its shortest side is less than this share of its longest. Around wider
/// faces, a line that winds once more is longer by at least the square of this, 1e-10 of its
/// length: far more than a tie (`kDistanceTolerance`), so its windows end by their length alone.
constexpr double kNeedle = 1e-5;

/// Faces per unit: measuring one takes three arctangents.
constexpr long kMeasuredFaces = 2;

void requireValid(const MeshOptions& options) {
  if (!(options.weld >= 0 && options.weld <= 1))
    rejectArgument("weld is " + numberText(options.weld) + ", not a number from 0 to 1");
  if (options.minComponent < 0)
    rejectArgument("minComponent is " + std::to_string(options.minComponent) +
                   ", not a number from 0");
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
    return makeManifold(budget) && placeVertices(budget) && measure(budget) && findBoundary(budget);
  }

  double share() const override {
    double sum = 0;
    for (const SlicedSequence* stage : {&making_, &placing_, &measuring_, &finding_})
      sum += stage->progress();
    return sum / 4;
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

  /// Lengths, angles and areas, with step 10 at `TriangleMesh`.
  bool measure(long& budget) {
    TriangleMesh& m = mesh_;
    return measuring_.run(
        forEach(m.vertexCount(), budget, kQuickRounds, [&](int v) { box_.extend(m.position(v)); }),
        [&] { requireExtent(); },
        forEach(m.faces_, budget, kMeasuredFaces, [&](int f) { measureFace(f); }),
        [&] { requireEdgeLength(); },
        forItems(maybeFlat_, budget, kMeasuredFaces, [&](int f) { noteFlatness(f); }),
        [&](SlicedLoop& loop) {
          return m.repairs_.mollification == 0 ||
                 loop.run(m.faceCount(), budget, kMeasuredFaces, [&](int f) {
                   setFace(f, lengthened(triangle(f), m.repairs_.mollification));
                 });
        },
        [&] {
          m.meanEdgeLength_ += m.repairs_.mollification;
          findShortEdgeLength();
        },
        [&] { return fillInSlices(m.angleSum_, m.vertexCount(), 0., budget); },
        [&] { return fillInSlices(m.longestEdge_, m.vertexCount(), 0., budget); },
        forEach(m.faces_, budget, 8, [&](int f) { sumUp(f); }));
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

  // --- Measures ----------------------------------------------------------------------------------

  void requireExtent() {
    const Eigen::Vector3d size = box_.diagonal();
    mesh_.boundingDiagonal_ = std::sqrt(size[0] * size[0] + size[1] * size[1] + size[2] * size[2]);
    if (!(mesh_.boundingDiagonal_ <= kLongestDiagonal))
      rejectMesh("the positions are too far apart to measure distances");
  }

  void requireEdgeLength() const {
    if (!(mesh_.meanEdgeLength_ >= kShortestMeanEdge))
      rejectMesh("the positions are too close together to measure distances");
  }

  void findShortEdgeLength() {
    constexpr int kSamples = 4096;
    constexpr double kLeastShare = 1.0 / 256;
    constexpr double kMostBuckets = 0x1p30;
    int step = std::max(1, mesh_.halfedgeCount() / kSamples);
    if (step % 3 == 0) ++step;  // of all sides of faces
    std::vector<double> lengths;
    for (std::int64_t h = 0; h < mesh_.halfedgeCount(); h += step)
      lengths.push_back(mesh_.length(static_cast<int>(h)));
    const auto quartile = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 4);
    std::nth_element(lengths.begin(), quartile, lengths.end());
    // No distance is longer than all edges together.
    const double longest = mesh_.meanEdgeLength_ * mesh_.halfedgeCount();
    mesh_.shortEdgeLength_ = std::max({*quartile, kLeastShare * mesh_.meanEdgeLength_,
                                       longest * kMostBucketsPerEdge / kMostBuckets});
  }

  /// Coordinates are not centred first: centring would round them, and their differences are as
  /// accurate as the input anyway.
  IntrinsicTriangle triangle(int face) const {
    const auto& [a, b, c] = mesh_.face(face).vertices;
    return measureTriangle({mesh_.position(a), mesh_.position(b), mesh_.position(c)});
  }

  void measureFace(int face) {
    const IntrinsicTriangle t = triangle(face);
    setFace(face, t);
    // The mean edge, which is not known yet, is no longer than the diagonal.
    if (t.leastExcess() < leastExcessWanted(t.longestSide(), mesh_.boundingDiagonal_))
      maybeFlat_.push_back(face);
    for (const double length : t.lengths) mesh_.meanEdgeLength_ += length / mesh_.halfedgeCount();
  }

  void noteFlatness(int face) {
    const IntrinsicTriangle t = triangle(face);
    const double missing =
        leastExcessWanted(t.longestSide(), mesh_.meanEdgeLength_) - t.leastExcess();
    if (missing <= 0) return;
    MeshRepairs& repairs = mesh_.repairs_;
    ++repairs.mollifiedTriangles;
    repairs.mollification = std::max(repairs.mollification, missing);
  }

  void setFace(int f, const IntrinsicTriangle& t) {
    TriangleMesh::Face& face = mesh_.faces_[f];
    face.lengths = t.lengths;
    for (int i = 0; i < 3; ++i) {
      const double product = t.lengths[i] * t.lengths[cornerBefore(i)];
      face.cosines[i] = t.dots[i] / product;
      face.sines[i] = t.twiceArea / product;
      face.angles[i] = std::atan2(t.twiceArea, t.dots[i]);
    }
    face.area = t.twiceArea / 2;
  }

  /// Adds a face to the sums and longest edges of its vertices, to those of the mesh, and to the
  /// needles. Faces come in order.
  void sumUp(int f) {
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      mesh_.angleSum_[mesh_.tail(h)] += mesh_.cornerAngle(h);
      for (const int v : {mesh_.tail(h), mesh_.tip(h)})
        mesh_.longestEdge_[v] = std::max(mesh_.longestEdge_[v], mesh_.length(h));
    }
    mesh_.area_ += mesh_.faceArea(f);
    const auto& lengths = mesh_.faces_[f].lengths;
    const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
    mesh_.longestOfAll_ = std::max(mesh_.longestOfAll_, *longest);
    if (*shortest < kNeedle * *longest) mesh_.needles_.push_back(f);
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

  SlicedSequence making_, placing_, measuring_, finding_;  ///< the stages
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
  Eigen::AlignedBox3d box_;
  std::vector<int> maybeFlat_;       ///< faces that are flat unless the mean edge is short
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
