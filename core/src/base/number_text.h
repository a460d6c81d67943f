// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace gvd {

/// A number for people, in seven significant digits, with the words and exponents of JavaScript:
/// 0.25, -1e-9, 3e+7, NaN, Infinity. So 1.000002, which the tolerance of barycentric coordinates
/// tells from 1, is not shown as 1. For messages of errors: `std::to_string` prints small numbers
/// as 0.000000, and needs all of printf.
std::string numberText(double number);

}  // namespace gvd
