// SPDX-License-Identifier: MIT
#include "diagram_pieces.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <utility>

#include "index_set.h"

namespace gvd {
namespace {

/// Numbers places, each once: two are the same if they are written the same.
class PlaceIndex {
 public:
  int add(const SurfacePoint& place) {
    const auto [entry, isNew] = index_.try_emplace(place, static_cast<int>(places_.size()));
    if (isNew) places_.push_back(place);
    return entry->second;
  }

  std::vector<int> addAll(std::span<const SurfacePoint> places) {
    std::vector<int> indices;
    for (const SurfacePoint& p : places) indices.push_back(add(p));
    return indices;
  }

  std::vector<SurfacePoint> take() { return std::move(places_); }

 private:
  struct Hash {
    size_t operator()(const SurfacePoint& p) const {
      std::uint64_t hash = static_cast<std::uint64_t>(p.face);
      for (int i = 0; i < 2; ++i)
        hash = (hash ^ std::hash<double>()(p.bary[i])) * 0x9e3779b97f4a7c15u;
      return static_cast<size_t>(hash ^ hash >> 32);
    }
  };
  struct Equal {
    bool operator()(const SurfacePoint& a, const SurfacePoint& b) const {
      return a.face == b.face && a.bary == b.bary;
    }
  };

  std::unordered_map<SurfacePoint, int, Hash, Equal> index_;
  std::vector<SurfacePoint> places_;
};

/// Copies what is wanted of a diagram, points numbered anew.
class Extract {
 public:
  Extract(const Diagram& from, std::span<const char> isWanted)
      : from_(from), isWanted_(isWanted), pointOf_(from.points.size(), -1) {}

  /// The loops, arcs and Voronoi points of the labels, and the cells of the faces.
  Diagram run(std::span<const int> faces) {
    out_.siteCount = from_.siteCount;
    addArcs();
    for (const Diagram::VoronoiPoint& v : from_.voronoiPoints)
      if (std::any_of(v.labels.begin(), v.labels.end(), [&](int l) { return isWanted_[l]; }))
        out_.voronoiPoints.push_back({point(v.point), v.labels});
    for (int i = 0; i < from_.loops.size(); ++i) {
      if (!isWanted_[from_.loopLabel[i]]) continue;
      addList(from_.loops[i], out_.loops);
      out_.loopLabel.push_back(from_.loopLabel[i]);
    }
    for (int i = 0; i < from_.cells.size(); ++i) {
      if (!std::binary_search(faces.begin(), faces.end(), from_.cellFace[i])) continue;
      addList(from_.cells[i], out_.cells);
      out_.cellFace.push_back(from_.cellFace[i]);
      out_.cellLabel.push_back(from_.cellLabel[i]);
    }
    std::set_intersection(from_.indifferentFaces.begin(), from_.indifferentFaces.end(),
                          faces.begin(), faces.end(), std::back_inserter(out_.indifferentFaces));
    return std::move(out_);
  }

 private:
  void addArcs() {
    std::vector<int> arcOf(from_.arcs.size(), -1);
    for (int i = 0; i < from_.arcs.size(); ++i) {
      const auto& labels = from_.arcLabels[i];
      if (!isWanted_[labels[0]] && !isWanted_[labels[1]]) continue;
      arcOf[i] = out_.arcs.size();
      addList(from_.arcs[i], out_.arcs);
      out_.arcLabels.push_back(labels);
    }
    for (const Diagram::Segment& s : from_.segments)
      if (arcOf[s.arc] >= 0)
        out_.segments.push_back(
            {{point(s.points[0]), point(s.points[1])}, s.labels, s.face, arcOf[s.arc]});
  }

  void addList(std::span<const int> points, PointLists& to) {
    list_.clear();
    for (const int p : points) list_.push_back(point(p));
    to.add(list_);
  }

  int point(int p) {
    if (pointOf_[p] < 0) {
      pointOf_[p] = static_cast<int>(out_.points.size());
      out_.points.push_back(from_.points[p]);
    }
    return pointOf_[p];
  }

  const Diagram& from_;
  std::span<const char> isWanted_;
  std::vector<int> pointOf_;
  std::vector<int> list_;
  Diagram out_;
};

}  // namespace

void DiagramPieces::replace(const DiagramChange& change) {
  removePieces(change);
  const Diagram& part = change.part;
  const auto places = [&](std::span<const int> points) {
    std::vector<SurfacePoint> list;
    list.reserve(points.size());
    for (const int p : points) list.push_back(part.points[p]);
    return list;
  };
  for (int i = 0; i < part.loops.size(); ++i)
    regions_[part.loopLabel[i]].loops.push_back(places(part.loops[i]));
  const size_t firstArc = arcs_.size();
  for (int i = 0; i < part.arcs.size(); ++i) {
    arcs_.push_back({part.arcLabels[i], places(part.arcs[i]), {}});
    arcs_.back().segments.reserve(part.arcs[i].size());
  }
  for (const Diagram::Segment& s : part.segments)
    arcs_[firstArc + s.arc].segments.push_back(
        {part.points[s.points[0]], part.points[s.points[1]], s.face});
  for (const Diagram::VoronoiPoint& v : part.voronoiPoints)
    voronoiPoints_.push_back({part.points[v.point], v.labels});
  for (size_t i = 0; i < change.faces.size(); ++i) {
    faceLabel_[change.faces[i]] = part.faceLabel[i];
    if (part.faceLabel[i] >= 0) regions_[part.faceLabel[i]].faces.push_back(change.faces[i]);
  }
  for (const int face : part.indifferentFaces) isIndifferent_[face] = true;
  for (int i = 0; i < part.cells.size(); ++i)
    cells_[part.cellFace[i]].push_back({part.cellLabel[i], places(part.cells[i])});
}

void DiagramPieces::removePieces(const DiagramChange& change) {
  if (!change.labels.empty() && change.labels.back() >= static_cast<int>(regions_.size()))
    regions_.resize(change.labels.back() + 1);
  std::vector<char> isOne(regions_.size());
  for (const int label : change.labels) {
    isOne[label] = true;
    regions_[label].loops.clear();
  }
  const auto is = [&](int label) { return isOne[label] != 0; };
  std::erase_if(arcs_, [&](const Arc& a) { return is(a.labels[0]) || is(a.labels[1]); });
  std::erase_if(voronoiPoints_, [&](const VoronoiPoint& v) {
    return std::any_of(v.labels.begin(), v.labels.end(), is);
  });
  for (const int face : change.faces) {
    cells_.erase(face);
    isIndifferent_[face] = false;
  }
}

const std::vector<int>& DiagramPieces::wholeFaces(int label) {
  std::vector<int>& faces = regions_[label].faces;
  std::erase_if(faces, [&](int f) { return faceLabel_[f] != label; });
  makeSet(faces);
  return faces;
}

Diagram DiagramPieces::whole() const {
  Diagram out;
  PlaceIndex points;
  out.siteCount = static_cast<int>(regions_.size());
  for (const Arc& arc : arcs_) {
    const int index = out.arcs.size();
    for (const Segment& s : arc.segments)
      out.segments.push_back({{points.add(s.from), points.add(s.to)}, arc.labels, s.face, index});
    out.arcs.add(points.addAll(arc.points));
    out.arcLabels.push_back(arc.labels);
  }
  for (const VoronoiPoint& v : voronoiPoints_)
    out.voronoiPoints.push_back({points.add(v.place), v.labels});
  for (int label = 0; label < out.siteCount; ++label) {
    for (const auto& loop : regions_[label].loops) {
      out.loops.add(points.addAll(loop));
      out.loopLabel.push_back(label);
    }
    out.regionArea.push_back(regions_[label].area);
  }
  out.faceLabel = faceLabel_;
  for (int f = 0; f < static_cast<int>(faceLabel_.size()); ++f) {
    if (isIndifferent_[f]) out.indifferentFaces.push_back(f);
    const auto cells = cells_.find(f);
    if (cells == cells_.end()) continue;
    for (const Cell& cell : cells->second) {
      out.cells.add(points.addAll(cell.outline));
      out.cellFace.push_back(f);
      out.cellLabel.push_back(cell.label);
    }
  }
  out.points = points.take();
  return out;
}

Diagram extract(const Diagram& from, std::span<const char> isWanted, std::span<const int> faces) {
  return Extract(from, isWanted).run(faces);
}

}  // namespace gvd
