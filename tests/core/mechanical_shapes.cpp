// SPDX-License-Identifier: MIT
#include "mechanical_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace gvd::shapes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

// --- Triangulation -------------------------------------------------------------------------------

/// Twice the area of the triangle; positive if it is counterclockwise.
double orientation(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// The greedy triangulation of outlines: of all connections of two corners the shortest that
/// crosses none before it, and so on, sides of the outlines first. It is about as good as
/// Delaunay's, and the few lines that it takes are worth the time, O(n³) for n corners: parts have
/// few.
class GreedyTriangulation {
 public:
  explicit GreedyTriangulation(const std::vector<Outline>& outlines) {
    for (const Outline& outline : outlines) {
      const int first = static_cast<int>(points_.size()), size = static_cast<int>(outline.size());
      points_.insert(points_.end(), outline.begin(), outline.end());
      for (int i = 0; i < size; ++i) sides_.push_back({first + i, first + (i + 1) % size});
    }
    for (const auto& [a, b] : sides_) add(a, b);
    for (const auto& [a, b] : pairsByLength())
      if (isFree(a, b)) add(a, b);
  }

  const std::vector<Vector2d>& points() const { return points_; }
  /// With the inside on the left.
  const std::vector<std::array<int, 2>>& sides() const { return sides_; }

  /// Those inside, counterclockwise.
  std::vector<std::array<int, 3>> triangles() const {
    std::vector<std::array<int, 3>> result;
    for (const auto& [a, b] : edges_) {
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
        const int apex = apexLeftOf(from, to);
        // Every triangle is met from three sides and taken from one.
        if (apex > std::max(from, to)) {
          const Vector2d centre = (points_[from] + points_[to] + points_[apex]) / 3;
          if (isInside(centre)) result.push_back({from, to, apex});
        }
      }
    }
    return result;
  }

 private:
  static constexpr double kFlat = 1e-12;  ///< an area; parts are a few units large

  void add(int a, int b) { edges_.insert(std::minmax(a, b)); }

  std::vector<std::pair<int, int>> pairsByLength() const {
    std::vector<std::pair<double, std::pair<int, int>>> pairs;
    for (int b = 0; b < static_cast<int>(points_.size()); ++b)
      for (int a = 0; a < b; ++a)
        pairs.push_back({(points_[b] - points_[a]).squaredNorm(), {a, b}});
    std::sort(pairs.begin(), pairs.end());
    std::vector<std::pair<int, int>> result;
    for (const auto& [length, pair] : pairs) result.push_back(pair);
    return result;
  }

  /// Whether it crosses no edge and meets no corner on its way, and lies inside.
  bool isFree(int a, int b) const {
    if (!isInside((points_[a] + points_[b]) / 2)) return false;
    const Vector2d &p = points_[a], &q = points_[b];
    for (int c = 0; c < static_cast<int>(points_.size()); ++c) {
      if (c == a || c == b || std::abs(orientation(p, q, points_[c])) > kFlat) continue;
      if ((points_[c] - p).dot(points_[c] - q) < 0) return false;
    }
    return std::none_of(edges_.begin(), edges_.end(), [&](const std::pair<int, int>& edge) {
      const auto [c, d] = edge;
      if (c == a || c == b || d == a || d == b) return false;
      return orientation(p, q, points_[c]) * orientation(p, q, points_[d]) < 0 &&
             orientation(points_[c], points_[d], p) * orientation(points_[c], points_[d], q) < 0;
    });
  }

  bool isInside(const Vector2d& p) const {
    bool inside = false;
    for (const auto& [a, b] : sides_) {
      const Vector2d &from = points_[a], &to = points_[b];
      if ((from.y() > p.y()) == (to.y() > p.y())) continue;
      const bool upwards = to.y() > from.y();
      if ((orientation(from, to, p) > 0) == upwards) inside = !inside;
    }
    return inside;
  }

  /// The corner of the triangle to the left of a connection; -1 if there is none.
  int apexLeftOf(int from, int to) const {
    int best = -1;
    for (int c = 0; c < static_cast<int>(points_.size()); ++c) {
      if (orientation(points_[from], points_[to], points_[c]) <= kFlat) continue;
      if (!edges_.contains(std::minmax(from, c)) || !edges_.contains(std::minmax(to, c))) continue;
      // Of several triangles, one lies in the other: the inner one.
      if (best < 0 || orientation(points_[from], points_[best], points_[c]) < 0) best = c;
    }
    return best;
  }

  std::vector<Vector2d> points_;
  std::vector<std::array<int, 2>> sides_;
  std::set<std::pair<int, int>> edges_;  ///< the lower corner first
};

// --- Outlines ------------------------------------------------------------------------------------

Outline rectangle(const Vector2d& low, const Vector2d& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

Outline roundHole(const Vector2d& centre, double radius, int corners) {
  Outline outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = -2 * pi * i / corners;
    outline.push_back(centre + radius * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return outline;
}

Outline squareHole(const Vector2d& centre, double side) {
  const Vector2d half(side / 2, side / 2);
  Outline outline = rectangle(centre - half, centre + half);
  std::reverse(outline.begin(), outline.end());
  return outline;
}

/// A plate 3 wide and 0.1 thick with rows × rows holes.
template <class Hole>
Shape plateWithHoles(int rows, Hole hole) {
  std::vector<Outline> outlines = {rectangle({0, 0}, {3, 3})};
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j)
      outlines.push_back(hole(3.0 / rows * Vector2d(i + 0.5, j + 0.5)));
  }
  return prism(outlines, 0.1);
}

Outline stairsOutline(int steps) {
  Outline outline = {{0, 0}, {double(steps), 0}};
  for (int i = steps; i > 0; --i) {
    outline.push_back({double(i), double(steps - i + 1)});
    outline.push_back({double(i - 1), double(steps - i + 1)});
  }
  return outline;
}

Outline combOutline(int teeth) {
  constexpr double kTooth = 0.1, kGap = 0.15, kLength = 1.5, kBack = 0.4;
  Outline outline = {{0, 0}, {teeth * kTooth + (teeth - 1) * kGap, 0}};
  for (int i = teeth - 1; i >= 0; --i) {
    const double left = i * (kTooth + kGap);
    outline.push_back({left + kTooth, kBack + kLength});
    outline.push_back({left, kBack + kLength});
    if (i == 0) break;
    outline.push_back({left, kBack});
    outline.push_back({left - kGap, kBack});
  }
  return outline;
}

Outline spiralOutline(double turns, int cornersPerTurn) {
  constexpr double kWidth = 0.3, kPitch = 0.5, kInnerRadius = 0.5;
  const int count = static_cast<int>(turns * cornersPerTurn);
  const auto at = [&](int i, double offset) -> Vector2d {
    const double turn = double(i) / cornersPerTurn;
    const double radius = kInnerRadius + kPitch * turn + offset;
    return {radius * std::cos(2 * pi * turn), radius * std::sin(2 * pi * turn)};
  };
  Outline outline;
  for (int i = 0; i <= count; ++i) outline.push_back(at(i, kWidth));
  for (int i = count; i >= 0; --i) outline.push_back(at(i, 0));
  return outline;
}

Outline gearOutline(int teeth) {
  Outline outline;
  for (int i = 0; i < teeth; ++i) {
    const auto add = [&](double offset, double radius) {
      const double angle = 2 * pi * (i + offset) / teeth;
      outline.push_back(radius * Vector2d(std::cos(angle), std::sin(angle)));
    };
    add(-0.3, 1), add(-0.15, 1.3), add(0.15, 1.3), add(0.3, 1);
  }
  return outline;
}

// --- Sponges -------------------------------------------------------------------------------------

/// A cube in 3 × 3 × 3, of which those in the middle of a side and of the whole are left out, and
/// so on in each that is left.
Shape mengerSponge(int level) {
  const int size = static_cast<int>(std::lround(std::pow(3, level)));
  std::vector<double> lines(size + 1);
  for (int i = 0; i <= size; ++i) lines[i] = i;
  const auto isFull = [&](std::array<int, 3> at) {
    for (int digit = 0; digit < level; ++digit) {
      int middles = 0;
      for (int& x : at) {
        middles += x % 3 == 1;
        x /= 3;
      }
      if (middles >= 2) return false;
    }
    return true;
  };
  std::vector<std::array<int, 3>> cells;
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < size; ++y)
      for (int z = 0; z < size; ++z)
        if (isFull({x, y, z})) cells.push_back({x, y, z});
  return boxes({lines, lines, lines}, cells);
}

Shape thinPlate() {
  const std::vector<double> x = {0, 0.2, 0.6, 1.4, 2.0, 2.1, 3}, y = {0, 0.5, 0.7, 1.5, 2};
  std::vector<std::array<int, 3>> cells;
  for (int i = 0; i + 1 < static_cast<int>(x.size()); ++i)
    for (int j = 0; j + 1 < static_cast<int>(y.size()); ++j) cells.push_back({i, j, 0});
  return boxes({x, y, {0, 0.02}}, cells);
}

}  // namespace

Shape prism(const std::vector<Outline>& outlines, double height) {
  const GreedyTriangulation plane(outlines);
  const int count = static_cast<int>(plane.points().size());
  Shape shape;
  for (const double z : {0.0, height})
    for (const Vector2d& p : plane.points()) shape.addVertex({p.x(), p.y(), z});
  for (const auto& [a, b, c] : plane.triangles()) {
    shape.addTriangle(a, c, b);
    shape.addTriangle(count + a, count + b, count + c);
  }
  for (const auto& [a, b] : plane.sides()) shape.addQuad(a, b, count + b, count + a);
  return shape;
}

Shape boxes(const std::array<std::vector<double>, 3>& coordinates,
            const std::vector<std::array<int, 3>>& cells) {
  Shape shape;
  const std::set<std::array<int, 3>> full(cells.begin(), cells.end());
  std::map<std::array<int, 3>, int> vertexAt;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [entry, isNew] = vertexAt.try_emplace(at, shape.vertexCount());
    if (isNew) {
      shape.addVertex({coordinates[0][at[0]], coordinates[1][at[1]], coordinates[2][at[2]]});
    }
    return entry->second;
  };
  for (const auto& cell : full) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        auto beside = cell;
        beside[axis] += side > 0 ? 1 : -1;
        if (full.contains(beside)) continue;
        // Counterclockwise as seen from the positive side of the axis, and the other way around on
        // the negative side.
        std::array<int, 4> corners;
        for (int i = 0; i < 4; ++i) {
          auto at = cell;
          at[axis] += side;
          at[(axis + 1) % 3] += i == 1 || i == 2;
          at[(axis + 2) % 3] += i >= 2;
          corners[side > 0 ? i : 3 - i] = vertex(at);
        }
        shape.addQuad(corners[0], corners[1], corners[2], corners[3]);
      }
    }
  }
  return shape;
}

std::vector<MechanicalShape> mechanicalShapes() {
  const auto round = [](double radius, int corners) {
    return [=](const Vector2d& centre) { return roundHole(centre, radius, corners); };
  };
  const auto square = [](double side) {
    return [=](const Vector2d& centre) { return squareHole(centre, side); };
  };
  const std::vector<Outline> block = {rectangle({0, 0}, {3, 1}), roundHole({0.5, 0.5}, 0.3, 12),
                                      squareHole({1.5, 0.5}, 0.5), roundHole({2.5, 0.5}, 0.2, 8)};
  const Outline ell = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  return {
      {"plate with a round hole", plateWithHoles(1, round(1, 24)), 1},
      {"plate with nine round holes", plateWithHoles(3, round(0.3, 16)), 9},
      {"plate with a square hole", plateWithHoles(1, square(1.5)), 1},
      {"plate with nine square holes", plateWithHoles(3, square(0.5)), 9},
      {"block with three holes", prism(block, 1), 3},
      {"L", prism({ell}, 1), 0},
      {"Menger sponge of level 1", mengerSponge(1), 5},
      {"Menger sponge of level 2", mengerSponge(2), 81},
      {"stairs", prism({stairsOutline(6)}, 4), 0},
      {"comb", prism({combOutline(8)}, 0.2), 0},
      {"spiral", prism({spiralOutline(2.5, 24)}, 0.2), 0},
      {"gear", prism({gearOutline(12), roundHole({0, 0}, 0.4, 16)}, 0.3), 1},
      {"thin plate", thinPlate(), 0},
  };
}

Shape mechanicalShape(std::string_view name) {
  const auto all = mechanicalShapes();
  return std::ranges::find(all, name, &MechanicalShape::name)->shape;
}

}  // namespace gvd::shapes
