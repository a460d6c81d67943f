// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace gvd {

/// Signs of determinants of doubles, always right: a floating-point filter decides the clear cases,
/// exact expansion arithmetic the rest (Shewchuk, Adaptive precision floating-point arithmetic and
/// fast robust geometric predicates, 1997). Exact while no product of three coordinates over- or
/// underflows.

/// The sign (-1, 0, 1) of | b-a ; c-a |.
int orientation(const std::array<double, 2>& a, const std::array<double, 2>& b,
                const std::array<double, 2>& c);

/// The sign (-1, 0, 1) of | b-a ; c-a ; d-a |.
int orientation(const std::array<double, 3>& a, const std::array<double, 3>& b,
                const std::array<double, 3>& c, const std::array<double, 3>& d);

}  // namespace gvd
