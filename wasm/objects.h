// SPDX-License-Identifier: MIT
//
// The objects that JavaScript holds by address: meshes, diagrams, tessellations. Also the only
// conversion of faces, vertices and points from the numbers of the input to those of a
// `TriangleMesh`; `records.h` converts results back.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "abi.h"
#include "gvd/closest_point.h"
#include "gvd/cvt.h"
#include "gvd/diagram.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/geodesic.h"
#include "gvd/sampling.h"
#include "gvd/sliced_work.h"
#include "gvd/surface_point.h"
#include "gvd/triangle_mesh.h"
#include "records.h"

namespace gvd::abi {

/// A mesh, shared so that its diagrams may outlive the caller's handle.
struct MeshHandle {
  std::shared_ptr<const TriangleMesh> mesh;
  /// Made when it is first asked for, of the mesh or of a diagram on it.
  std::shared_ptr<std::optional<ClosestPointQuery>> closestPoints;
};

/// A diagram of sites, which may change.
struct DiagramHandle {
  MeshHandle surface;
  std::vector<SurfacePoint> sites;
  Metric metric;
  DiagramOptions options;
  // One of three has the distances: what the diagram was made from, the tessellation that it is an
  // iteration of, or, once a site has changed, the `DynamicDiagram`.
  std::shared_ptr<DistanceField> distances;
  std::shared_ptr<const DistanceField> sharedDistances;
  std::unique_ptr<DynamicDiagram> dynamic;
  std::shared_ptr<const Diagram> traced;       ///< none after a change, until it is asked for
  std::unique_ptr<WorstRegions> worstRegions;  ///< once they have been asked for

  const TriangleMesh& mesh() const { return *surface.mesh; }
  const DistanceField& field() const {
    return dynamic ? dynamic->distances() : distances ? *distances : *sharedDistances;
  }
  /// The sites by label; face -1 where one has been removed. Labels at the end that have none do
  /// not count.
  std::vector<SurfacePoint> sitesByLabel() const;
  /// Begins to make `dynamic`, which `takeDynamic` then takes.
  std::unique_ptr<SlicedWork<DynamicDiagram>> startDynamic() const;
  void takeDynamic(DynamicDiagram made);
};

/// Work on the diagram of the present sites. After changes, its pieces are first joined to a whole.
class DiagramWork final : public SlicedWork<Record> {
 public:
  /// Begins the work; it may keep what it is given.
  using Start = std::function<std::unique_ptr<SlicedWork<Record>>(const DiagramOnMesh& on)>;

  /// The handle must outlive the steps.
  DiagramWork(DiagramHandle& voronoi, Start start) : voronoi_(voronoi), start_(std::move(start)) {}
  bool advance(long budget) override;
  double share() const override { return work_ ? work_->progress() : 0; }
  Record result() override { return work_->take(); }

 private:
  bool join(long budget);

  DiagramHandle& voronoi_;
  const Start start_;
  std::unique_ptr<SlicedWork<Diagram>> joining_;
  std::unique_ptr<SlicedWork<Record>> work_;
};

/// The answer of work on a diagram.
inline Answer* answerOn(DiagramHandle* voronoi, DiagramWork::Start start) {
  return guarded(
      [&] { return answerOf(std::make_unique<DiagramWork>(*voronoi, std::move(start))); });
}

/// A centroidal tessellation under way.
struct CvtHandle {
  MeshHandle surface;
  Metric metric;
  std::unique_ptr<Cvt> cvt;
};

/// An answer about points that are looked up one after the other.
class PointLookup : public SlicedWork<Record> {
 public:
  explicit PointLookup(std::size_t count) : count_(count) {}
  bool advance(long budget) final;
  double share() const override { return count_ > 0 ? static_cast<double>(next_) / count_ : 1; }

 protected:
  /// Prepares the look-ups in steps; true when they can begin.
  virtual bool prepare(long /*budget*/) { return true; }
  /// Looks one up; lowers the budget if that takes long.
  virtual void lookUp(std::size_t i, long& budget) = 0;

 private:
  const std::size_t count_;
  std::size_t next_ = 0;
};

Metric metricOf(Text name);
WorstRegion worstRegionOf(Text name);

/// Calls `f`; its error, if any, is said to be about `what`, or number `index` of several.
template <class F>
auto naming(const char* what, std::optional<std::size_t> index, F&& f) -> decltype(f()) {
  try {
    return f();
  } catch (const Error& error) {
    const std::string number = index ? " " + std::to_string(*index) : "";
    throw Error(error.code(), what + number + ": " + error.what());
  }
}

/// Sites of the input, by label; one of face -1 and coordinates 0, as results have it, is a label
/// without a site.
std::vector<SurfacePoint> sitesFromInput(const TriangleMesh& mesh, Ints face, Doubles bary);

/// One point of the input, `bary` being its three coordinates.
SurfacePoint pointFromInput(const TriangleMesh& mesh, int face, const double* bary);
SurfacePoint pointFromInput(const TriangleMesh& mesh, Ints face, Doubles bary);

/// Turns a density per input vertex into one per vertex of the mesh; none stays none.
std::vector<double> densityFromInput(const TriangleMesh& mesh, Doubles density);

/// Turns values per vertex of the mesh into values per input vertex, `otherwise` at isolated ones.
std::vector<double> valuesAtInput(const TriangleMesh& mesh, std::span<const double> values,
                                  double otherwise);

}  // namespace gvd::abi
