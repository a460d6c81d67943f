// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace gvd {

/// A number for people, in seven significant digits, which tell a number from 1 that tolerances do:
/// 0.25, -1e-09, 3e+07, nan. For messages of errors: `std::to_string` prints small numbers as
/// 0.000000, and needs all of printf.
std::string numberText(double number);

}  // namespace gvd
