// SPDX-License-Identifier: MIT
//
// Mechanical parts as CAD programs write them: plane walls, sharp edges, holes, and vertices only
// on outlines, hence many long thin triangles. Paths bend at many inner corners, which is hard for
// approximate distances and rare on scans and smooth surfaces.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "shapes.h"

namespace gvd::shapes {

/// A simple polygon; the first corner is not repeated at the end.
using Outline = std::vector<Eigen::Vector2d>;

/// The solid between z = 0 and `height`, inside an outline (counterclockwise) and outside its holes
/// (clockwise). Only the corners of the outlines are vertices.
Shape prism(const std::vector<Outline>& outlines, double height);

/// The outer surface of boxes of a grid, one per entry of `cells` (its column on each axis). The
/// grid has lines at `coordinates` on the three axes.
Shape boxes(const std::array<std::vector<double>, 3>& coordinates,
            const std::vector<std::array<int, 3>>& cells);

struct MechanicalShape {
  std::string name;
  Shape shape;
  int genus;
};

/// Closed shapes of one component: plates with holes, a block with holes, an L, sponges, stairs, a
/// comb, a spiral, a gear and a thin plate.
std::vector<MechanicalShape> mechanicalShapes();
/// One of them by its name.
Shape mechanicalShape(std::string_view name);

}  // namespace gvd::shapes
