// SPDX-License-Identifier: MIT
//
// Parts as a CAD program writes them: plane walls at sharp edges, holes, vertices only where an
// outline has them, and so many long thin triangles. Paths bend at the inner corners again and
// again, which is hard for approximate distances; on scans and smooth surfaces it hardly happens.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "shapes.h"

namespace gvd::shapes {

/// A polygon that does not cross itself, without its first corner again at the end.
using Outline = std::vector<Eigen::Vector2d>;

/// What lies between z = 0 and `height` inside of an outline (counterclockwise) and outside of its
/// holes (clockwise). Only the corners of the outlines are vertices.
Shape prism(const std::vector<Outline>& outlines, double height);

/// Boxes of a grid with lines at `coordinates` on the three axes, one for each entry of `cells`
/// (its column on each axis). The outside of all of them.
Shape boxes(const std::array<std::vector<double>, 3>& coordinates,
            const std::vector<std::array<int, 3>>& cells);

struct MechanicalShape {
  std::string name;
  Shape shape;
  int genus;
};

/// Each closed and of one component: plates with holes, a block with holes, an L, sponges, stairs,
/// a comb, a spiral, a gear and a thin plate.
std::vector<MechanicalShape> mechanicalShapes();

}  // namespace gvd::shapes
