// SPDX-License-Identifier: MIT
//
// The pieces of a dynamic diagram: an edit replaces some, and all of them can be joined to one
// diagram.
#include "diagram/dynamic/diagram_pieces.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/hashing.h"

namespace gvd {
namespace {

/// Numbers places, each once: two are the same if their faces and coordinates are equal.
class PlaceIndex {
 public:
  /// Makes room, in slices; true when it is there.
  bool prepare(size_t faceCount, long& budget) {
    return fillInSlices(last_, faceCount + kListsOfFace, -1, budget);
  }

  int add(const SurfacePoint& place) {
    int& last = last_[place.face + hashBelow(kListsOfFace, place.bary)];
    for (int i = last; i >= 0; i = before_[i])
      if (places_[i].face == place.face && places_[i].bary == place.bary) return i;
    const int added = static_cast<int>(places_.size());
    places_.push_back(place);
    before_.push_back(std::exchange(last, added));
    return added;
  }

  std::vector<int> addAll(std::span<const SurfacePoint> places) {
    std::vector<int> indices;
    for (const SurfacePoint& p : places) indices.push_back(add(p));
    return indices;
  }

  std::vector<SurfacePoint> take() { return std::move(places_); }

 private:
  /// The lists that the places of one face are spread over, because there may be thousands. Near
  /// faces have most of their lists in common, which stay in the cache.
  static constexpr int kListsOfFace = 1024;

  std::vector<SurfacePoint> places_;
  std::vector<int> last_;    ///< of each list, -1: none
  std::vector<int> before_;  ///< the place before it in its list, or -1
};

void setPlaces(const Diagram& part, std::span<const int> points, std::vector<SurfacePoint>& to) {
  to.clear();
  for (const int p : points) to.push_back(part.points[p]);
}

}  // namespace

bool DiagramPieces::replace(const DiagramChange& change, long& budget) {
  constexpr long kPiecesPerUnit = 4;
  const Diagram& part = change.part;
  const auto forNumbers = [&](const auto& list, auto visit) {
    return forEach(list, budget, kPiecesPerUnit, visit);
  };
  const auto forAll = [&](const auto& list, auto visit) {
    return forItems(list, budget, kPiecesPerUnit, visit);
  };
  return replacing_.runRound(
      [&] {
        if (!change.labels.empty() && change.labels.back() >= static_cast<int>(regions_.size()))
          regions_.resize(change.labels.back() + 1);
        beside_.clear();
        arcOf_.clear();
      },
      forAll(change.labels, [&](int label) { removePiecesOf(label); }), [&] { makeSet(beside_); },
      forAll(beside_, [&](int label) { unlistRemoved(label); }),
      forAll(change.faces, [&](int face) { removePiecesIn(face); }),
      forNumbers(part.loops,
                 [&](int i) {
                   setPlaces(part, part.loops[i], regions_[part.loopLabel[i]].loops.emplace_back());
                 }),
      forNumbers(part.arcs, [&](int i) { addArc(part, i); }),
      forAll(part.segments,
             [&](const Diagram::Segment& s) {
               arcs_[arcOf_[s.arc]].segments.push_back(
                   {part.points[s.points[0]], part.points[s.points[1]], s.face});
             }),
      forAll(part.voronoiPoints, [&](const Diagram::VoronoiPoint& v) { addVoronoiPoint(part, v); }),
      forNumbers(change.faces,
                 [&](int i) {
                   const int label = faceLabel_[change.faces[i]] = part.faceLabel[i];
                   if (label >= 0) regions_[label].faces.push_back(change.faces[i]);
                 }),
      [&] {
        for (const int face : part.indifferentFaces) isIndifferent_[face] = true;
      },
      forNumbers(part.cells, [&](int i) { addCell(part, i); }));
}

void DiagramPieces::removePiecesOf(int label) {
  Region& region = regions_[label];
  region.loops.clear();
  remove(region.arcs, arcs_);
  remove(region.voronoiPoints, voronoiPoints_);
}

/// Removes arcs or Voronoi points of a region, and notes the labels beside it that list them, too.
template <class Piece>
void DiagramPieces::remove(std::vector<int>& pieces, Pool<Piece>& pool) {
  for (const int piece : std::exchange(pieces, {})) {
    if (!pool.isUsed(piece)) continue;  // removed with the region on its other side
    beside_.insert(beside_.end(), pool[piece].labels.begin(), pool[piece].labels.end());
    pool.remove(piece);
  }
}

/// Takes removed pieces from the lists of a label. No new piece has taken their numbers yet.
void DiagramPieces::unlistRemoved(int label) {
  Region& region = regions_[label];
  std::erase_if(region.arcs, [&](int arc) { return !arcs_.isUsed(arc); });
  std::erase_if(region.voronoiPoints, [&](int point) { return !voronoiPoints_.isUsed(point); });
}

void DiagramPieces::removePiecesIn(int face) {
  if (const int cells = std::exchange(cellsOf_[face], -1); cells >= 0) cells_.remove(cells);
  isIndifferent_[face] = false;
}

void DiagramPieces::addArc(const Diagram& part, int arc) {
  arcOf_.push_back(arcs_.add());
  Arc& added = arcs_[arcOf_.back()];
  added.labels = part.arcLabels[arc];
  setPlaces(part, part.arcs[arc], added.points);
  added.segments.clear();
  for (const int label : added.labels) regions_[label].arcs.push_back(arcOf_.back());
}

void DiagramPieces::addVoronoiPoint(const Diagram& part, const Diagram::VoronoiPoint& point) {
  const int number = voronoiPoints_.add();
  voronoiPoints_[number].place = part.points[point.point];
  voronoiPoints_[number].labels = point.labels;
  for (const int label : point.labels) regions_[label].voronoiPoints.push_back(number);
}

void DiagramPieces::addCell(const Diagram& part, int cell) {
  int& number = cellsOf_[part.cellFace[cell]];
  if (number < 0) {
    number = cells_.add();
    cells_[number].cells.clear();
    cells_[number].points.clear();
  }
  auto& [cells, points] = cells_[number];
  for (const int p : part.cells[cell]) points.push_back(part.points[p]);
  cells.push_back({part.cellLabel[cell], static_cast<int>(points.size())});
}

const std::vector<int>& DiagramPieces::regionTriangles(int label) {
  std::vector<int>& faces = regions_[label].faces;
  std::erase_if(faces, [&](int f) { return faceLabel_[f] != label; });
  makeSet(faces);
  return faces;
}

/// Joins all pieces to one diagram.
class DiagramPieces::Joining final : public SequentialWork<Diagram> {
 public:
  explicit Joining(const DiagramPieces& pieces) : pieces_(pieces) {}

  bool advance(long budget) override {
    const std::vector<int>& faceLabel = pieces_.faceLabel_;
    return sequence_.run(
        [&] { out_.faceLabel.reserve(faceLabel.size()); },
        [&] { return points_.prepare(faceLabel.size(), budget); },
        forEach(pieces_.arcs_.limit(), budget, 1, [&](int arc) { addArc(arc); }),
        forEach(pieces_.voronoiPoints_.limit(), budget, 4, [&](int v) { addVoronoiPoint(v); }),
        forEach(pieces_.regions_, budget, 1, [&](int label) { addRegion(label); }),
        forEach(faceLabel, budget, 4, [&](int f) { addFace(f); }));
  }
  Diagram result() override {
    out_.siteCount = static_cast<int>(pieces_.regions_.size());
    out_.points = points_.take();
    return std::move(out_);
  }

 private:
  void addArc(int number) {
    if (!pieces_.arcs_.isUsed(number)) return;
    const Arc& arc = pieces_.arcs_[number];
    const int index = out_.arcs.size();
    for (const Segment& s : arc.segments)
      out_.segments.push_back(
          {{points_.add(s.from), points_.add(s.to)}, arc.labels, s.face, index});
    out_.arcs.add(points_.addAll(arc.points));
    out_.arcLabels.push_back(arc.labels);
  }

  void addVoronoiPoint(int number) {
    if (!pieces_.voronoiPoints_.isUsed(number)) return;
    const auto& [place, labels] = pieces_.voronoiPoints_[number];
    out_.voronoiPoints.push_back({points_.add(place), labels});
  }

  void addRegion(int label) {
    for (const auto& loop : pieces_.regions_[label].loops) {
      out_.loops.add(points_.addAll(loop));
      out_.loopLabel.push_back(label);
    }
    out_.regionArea.push_back(pieces_.regions_[label].area);
  }

  void addFace(int f) {
    out_.faceLabel.push_back(pieces_.faceLabel_[f]);
    if (pieces_.isIndifferent_[f]) out_.indifferentFaces.push_back(f);
    if (pieces_.cellsOf_[f] < 0) return;
    const Cells& here = pieces_.cells_[pieces_.cellsOf_[f]];
    int begin = 0;
    for (const Cells::Cell& cell : here.cells) {
      const auto count = static_cast<size_t>(cell.end - begin);
      out_.cells.add(points_.addAll(std::span(here.points).subspan(begin, count)));
      out_.cellFace.push_back(f);
      out_.cellLabel.push_back(cell.label);
      begin = cell.end;
    }
  }

  const DiagramPieces& pieces_;
  PlaceIndex points_;
};

std::unique_ptr<SlicedWork<Diagram>> DiagramPieces::startDiagram() const {
  return std::make_unique<Joining>(*this);
}

DiagramChange changeTo(Diagram diagram) {
  const int faceCount = static_cast<int>(diagram.faceLabel.size());
  return {indicesBelow(diagram.siteCount), indicesBelow(faceCount), std::move(diagram)};
}

Diagram extract(const Diagram& from, const IndexSet& labels, std::span<const int> faces) {
  Diagram out;
  out.siteCount = from.siteCount;
  std::vector<int> pointOf(from.points.size(), -1);
  const auto point = [&](int p) {
    if (pointOf[p] < 0) {
      pointOf[p] = static_cast<int>(out.points.size());
      out.points.push_back(from.points[p]);
    }
    return pointOf[p];
  };
  const auto addList = [&](std::span<const int> points, PointLists& to) {
    for (const int p : points) to.points.push_back(point(p));
    to.close();
  };
  std::vector<int> arcOf(from.arcs.size(), -1);
  for (int i = 0; i < from.arcs.size(); ++i) {
    const auto [left, right] = from.arcLabels[i];
    if (!labels.contains(left) && !labels.contains(right)) continue;
    arcOf[i] = out.arcs.size();
    addList(from.arcs[i], out.arcs);
    out.arcLabels.push_back({left, right});
  }
  for (const Diagram::Segment& s : from.segments)
    if (arcOf[s.arc] >= 0)
      out.segments.push_back(
          {{point(s.points[0]), point(s.points[1])}, s.labels, s.face, arcOf[s.arc]});
  for (const Diagram::VoronoiPoint& v : from.voronoiPoints)
    if (std::any_of(v.labels.begin(), v.labels.end(), [&](int l) { return labels.contains(l); }))
      out.voronoiPoints.push_back({point(v.point), v.labels});
  for (int i = 0; i < from.loops.size(); ++i) {
    if (!labels.contains(from.loopLabel[i])) continue;
    addList(from.loops[i], out.loops);
    out.loopLabel.push_back(from.loopLabel[i]);
  }
  auto face = faces.begin();  // cells are ascending by face, too
  for (int i = 0; i < from.cells.size(); ++i) {
    while (face != faces.end() && *face < from.cellFace[i]) ++face;
    if (face == faces.end() || *face != from.cellFace[i]) continue;
    addList(from.cells[i], out.cells);
    out.cellFace.push_back(from.cellFace[i]);
    out.cellLabel.push_back(from.cellLabel[i]);
  }
  std::set_intersection(from.indifferentFaces.begin(), from.indifferentFaces.end(), faces.begin(),
                        faces.end(), std::back_inserter(out.indifferentFaces));
  return out;
}

}  // namespace gvd
