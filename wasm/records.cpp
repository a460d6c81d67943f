// SPDX-License-Identifier: MIT
//
// Results flattened to arrays, in terms of the input.
#include "records.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace gvd::abi {
namespace {

/// `faceLabel` of an input triangle that the mesh builder dropped.
constexpr int kDropped = -3;

std::vector<int> inputFaces(const TriangleMesh& mesh, std::vector<int> faces) {
  for (int& face : faces) face = mesh.inputFace(face);
  return faces;
}

Record listsRecord(PointLists lists) {
  Record out;
  out.add("offset", std::move(lists.offset));
  out.add("points", std::move(lists.points));
  return out;
}

Record segmentsRecord(const TriangleMesh& mesh, std::span<const Diagram::Segment> segments) {
  std::vector<std::array<int, 2>> points, labels;
  std::vector<int> face, arc;
  points.reserve(segments.size());
  labels.reserve(segments.size());
  face.reserve(segments.size());
  arc.reserve(segments.size());
  for (const Diagram::Segment& segment : segments) {
    points.push_back(segment.points);
    labels.push_back(segment.labels);
    face.push_back(mesh.inputFace(segment.face));
    arc.push_back(segment.arc);
  }
  Record out;
  out.add("points", std::move(points));
  out.add("labels", std::move(labels));
  out.add("face", std::move(face));
  out.add("arc", std::move(arc));
  return out;
}

Record voronoiPointsRecord(std::span<const Diagram::VoronoiPoint> voronoiPoints) {
  std::vector<int> point, labelOffset = {0}, labels;
  for (const Diagram::VoronoiPoint& v : voronoiPoints) {
    point.push_back(v.point);
    labels.insert(labels.end(), v.labels.begin(), v.labels.end());
    labelOffset.push_back(static_cast<int>(labels.size()));
  }
  Record out;
  out.add("point", std::move(point));
  out.add("labelOffset", std::move(labelOffset));
  out.add("labels", std::move(labels));
  return out;
}

std::vector<int> inputFaceLabels(const TriangleMesh& mesh, std::span<const int> faceLabel) {
  std::vector<int> labels(mesh.inputFaceCount(), kDropped);
  for (int f = 0; f < mesh.faceCount(); ++f)
    if (!mesh.isJoining(f)) labels[mesh.inputFace(f)] = faceLabel[f];
  return labels;
}

/// A part of a diagram's record.
struct Piece {
  const char* name;
  Record (*record)(const TriangleMesh& mesh, const Diagram& diagram);
};

/// Of a diagram, or of the part of one that a change replaces. Leaves out `faceLabel`, which has an
/// entry for every face in a diagram, but only for the changed faces in a change.
constexpr Piece kPieces[] = {
    {"segments", [](const TriangleMesh& mesh,
                    const Diagram& diagram) { return segmentsRecord(mesh, diagram.segments); }},
    {"arcs",
     [](const TriangleMesh& /*mesh*/, const Diagram& diagram) {
       Record arcs = listsRecord(diagram.arcs);
       arcs.add("labels", diagram.arcLabels);
       return arcs;
     }},
    {"voronoiPoints",
     [](const TriangleMesh& /*mesh*/, const Diagram& diagram) {
       return voronoiPointsRecord(diagram.voronoiPoints);
     }},
    {"loops",
     [](const TriangleMesh& /*mesh*/, const Diagram& diagram) {
       Record loops = listsRecord(diagram.loops);
       loops.add("label", diagram.loopLabel);
       return loops;
     }},
    {"cells",
     [](const TriangleMesh& mesh, const Diagram& diagram) {
       Record cells = listsRecord(diagram.cells);
       cells.add("face", inputFaces(mesh, diagram.cellFace));
       cells.add("label", diagram.cellLabel);
       return cells;
     }},
};

/// What is not in `kPieces`.
Record restRecord(const TriangleMesh& mesh, const Diagram& diagram, Record points) {
  Record out;
  out.add("points", std::move(points));
  out.add("regionArea", diagram.regionArea);
  out.add("indifferentFaces", inputFaces(mesh, diagram.indifferentFaces));
  return out;
}

/// One fact of every region.
template <class T>
std::vector<T> factOf(std::span<const RegionPatch> regions, T RegionPatch::*fact) {
  std::vector<T> values;
  values.reserve(regions.size());
  for (const RegionPatch& region : regions) values.push_back(region.*fact);
  return values;
}

std::vector<int> triangleOffsets(std::span<const RegionPatch> regions) {
  std::vector<int> offset = {0};
  for (const RegionPatch& region : regions) offset.push_back(offset.back() + region.triangleCount);
  return offset;
}

Record neighboursRecord(std::span<const RegionPatch> regions) {
  std::vector<int> offset = {0}, label;
  std::vector<double> length;
  for (const RegionPatch& region : regions) {
    for (const RegionPatch::Neighbour& neighbour : region.neighbours) {
      label.push_back(neighbour.label);
      length.push_back(neighbour.length);
    }
    offset.push_back(static_cast<int>(label.size()));
  }
  Record out;
  out.add("offset", std::move(offset));
  out.add("label", std::move(label));
  out.add("length", std::move(length));
  return out;
}

Record regionsRecord(const TriangleMesh& mesh, std::span<const RegionPatch> regions) {
  Record out;
  out.add("triangleOffset", triangleOffsets(regions));
  out.add("area", factOf(regions, &RegionPatch::area));
  out.add("perimeter", factOf(regions, &RegionPatch::perimeter));
  out.add("boundaryLength", factOf(regions, &RegionPatch::boundaryLength));
  out.add("centroid", factOf(regions, &RegionPatch::centroid));
  out.add("nearCentroid", pointsRecord(mesh, factOf(regions, &RegionPatch::nearCentroid)));
  out.add("components", factOf(regions, &RegionPatch::components));
  out.add("loops", factOf(regions, &RegionPatch::loops));
  out.add("eulerCharacteristic", factOf(regions, &RegionPatch::eulerCharacteristic));
  out.add("genus", factOf(regions, &RegionPatch::genus));
  out.add("selfTouchings", factOf(regions, &RegionPatch::selfTouchings));
  out.add("neighbours", neighboursRecord(regions));
  return out;
}

Record topologyRecord(const PolygonTopology& topology) {
  Record out;
  out.add("isManifold", topology.isManifold);
  out.add("vertices", topology.vertices);
  out.add("edges", topology.edges);
  out.add("faces", topology.faces);
  out.add("components", topology.components);
  out.add("boundaryLoops", topology.boundaryLoops);
  out.add("eulerCharacteristic", topology.eulerCharacteristic);
  out.add("genus", topology.genus);
  return out;
}

class DiagramRecording final : public SequentialWork<Record> {
 public:
  explicit DiagramRecording(DiagramOnMesh on)
      : on_(std::move(on)), points_(*on_.mesh, on_.diagram->points, true) {}

  bool advance(long budget) override {
    return sequence_.run([&] { return points_.step(budget); }, [&] { return addPiece(); });
  }
  double share() const override { return points_.progress(); }
  Record result() override {
    out_.add("siteCount", on_.diagram->siteCount);
    out_.add("faceLabel", inputFaceLabels(*on_.mesh, on_.diagram->faceLabel));
    out_.add(restRecord(*on_.mesh, *on_.diagram, points_.take()));
    return std::move(out_);
  }

 private:
  /// Of a large diagram, each piece takes as long as a step may take.
  bool addPiece() {
    if (piece_ == std::size(kPieces)) return true;
    const auto& [name, record] = kPieces[piece_++];
    out_.add(name, record(*on_.mesh, *on_.diagram));
    return false;
  }

  const DiagramOnMesh on_;
  PointsRecording points_;
  std::size_t piece_ = 0;  ///< the next one
};

Record recorded(PointsRecording points) {
  long budget = kUnlimited;
  points.step(budget);
  return points.take();
}

}  // namespace

PointsRecording::PointsRecording(const TriangleMesh& mesh, std::span<const SurfacePoint> points,
                                 bool isPlaced)
    : mesh_(mesh), points_(points), isPlaced_(isPlaced) {
  face_.reserve(points.size());
  bary_.reserve(points.size());
  if (isPlaced) position_.reserve(points.size());
}

bool PointsRecording::step(long& budget) {
  constexpr long kPointsPerUnit = 8;
  return loop_.run(points_.size(), budget, kPointsPerUnit, [&](int i) {
    const SurfacePoint input = mesh_.toInput(points_[i]);
    face_.push_back(input.face);
    bary_.push_back(input.bary);
    if (isPlaced_) position_.push_back(mesh_.position(points_[i]));
  });
}

double PointsRecording::progress() const {
  return points_.empty() ? 1
                         : static_cast<double>(face_.size()) / static_cast<double>(points_.size());
}

Record PointsRecording::take() {
  Record out;
  out.add("face", std::move(face_));
  out.add("bary", std::move(bary_));
  if (isPlaced_) out.add("position", std::move(position_));
  return out;
}

Record pointsRecord(const TriangleMesh& mesh, std::span<const SurfacePoint> points) {
  return recorded(PointsRecording(mesh, points, false));
}

Record placedRecord(const TriangleMesh& mesh, std::span<const SurfacePoint> points) {
  return recorded(PointsRecording(mesh, points, true));
}

Record pathRecord(const TriangleMesh& mesh, std::span<const SurfacePoint> path) {
  Record out;
  out.add("points", placedRecord(mesh, path));
  out.add("length", path.empty() ? kInfinity : lengthOf(mesh, path));
  return out;
}

std::unique_ptr<SlicedWork<Record>> diagramRecording(const DiagramOnMesh& on) {
  return std::make_unique<DiagramRecording>(on);
}

Record changeRecord(const TriangleMesh& mesh, int label, DiagramChange change) {
  Record part;
  part.add("faceLabel", std::move(change.part.faceLabel));
  for (const auto& [name, record] : kPieces) part.add(name, record(mesh, change.part));
  part.add(restRecord(mesh, change.part, placedRecord(mesh, change.part.points)));

  Record out;
  out.add("label", label);
  out.add("labels", std::move(change.labels));
  out.add("faces", inputFaces(mesh, std::move(change.faces)));
  out.add("part", std::move(part));
  return out;
}

Record partitionRecord(const TriangleMesh& mesh, Partition partition, Record points,
                       std::vector<Eigen::Vector3d> corners) {
  points.add("position", std::move(partition.positions));

  Record triangles;
  triangles.add("points", std::move(partition.triangles));
  triangles.add("label", std::move(partition.triangleLabel));
  triangles.add("face", std::move(partition.triangleFace));
  triangles.add("bary", std::move(corners));

  Record out;
  out.add("points", std::move(points));
  out.add("triangles", std::move(triangles));
  out.add("regions", regionsRecord(mesh, partition.regions));
  return out;
}

Record polygonRecord(PolygonMesh polygons, Record points, PolygonTriangles cut,
                     const PolygonTopology& topology) {
  points.add("position", std::move(polygons.positions));
  Record triangles;
  triangles.add("points", std::move(cut.triangles));
  triangles.add("face", std::move(cut.face));

  Record out;
  out.add("points", std::move(points));
  out.add("triangles", std::move(triangles));
  out.add("topology", topologyRecord(topology));
  out.add("faces", listsRecord(std::move(polygons.faces)));
  out.add("vertexLabel", std::move(polygons.vertexLabel));
  out.add("faceLabel", std::move(polygons.faceLabel));
  return out;
}

}  // namespace gvd::abi
