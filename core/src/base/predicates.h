// SPDX-License-Identifier: MIT
//
// Determinants of doubles and their signs: by floating-point arithmetic if its error bound permits,
// otherwise by exact expansion arithmetic (Shewchuk, Adaptive precision floating-point arithmetic
// and fast robust geometric predicates, 1997). Valid while no product of three coordinates
// overflows or underflows.
#pragma once

#include <array>

namespace gvd {

/// The sign (-1, 0, 1) of | b-a ; c-a |.
int orientation(const std::array<double, 2>& a, const std::array<double, 2>& b,
                const std::array<double, 2>& c);

/// The sign (-1, 0, 1) of | b-a ; c-a ; d-a |.
int orientation(const std::array<double, 3>& a, const std::array<double, 3>& b,
                const std::array<double, 3>& c, const std::array<double, 3>& d);

/// | b-a ; c-a | with a relative error of at most 1e-12, however much of it cancels; so of the
/// right sign, and zero only if it is.
double determinant(const std::array<double, 2>& a, const std::array<double, 2>& b,
                   const std::array<double, 2>& c);

}  // namespace gvd
