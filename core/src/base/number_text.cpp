// SPDX-License-Identifier: MIT
#include "base/number_text.h"

#include <cmath>

namespace gvd {

std::string numberText(double number) {
  if (std::isnan(number)) return "NaN";
  const std::string sign = number < 0 ? "-" : "";
  double size = std::abs(number);
  if (std::isinf(size)) return sign + "Infinity";
  if (size == 0) return "0";
  int exponent = 0;
  for (; size >= 10; size /= 10) ++exponent;
  for (; size < 1; size *= 10) --exponent;
  long digits = std::lround(size * 1e6);
  if (digits == 10000000) {
    digits = 1000000;
    ++exponent;
  }
  std::string text = std::to_string(digits);
  text.erase(text.find_last_not_of('0') + 1);

  const int count = static_cast<int>(text.size());
  if (exponent < -4 || exponent > 6) {
    if (count > 1) text.insert(1, 1, '.');
    return sign + text + (exponent < 0 ? "e" : "e+") + std::to_string(exponent);
  }
  if (exponent < 0) return sign + "0." + std::string(-exponent - 1, '0') + text;
  if (count <= exponent + 1) return sign + text + std::string(exponent + 1 - count, '0');
  return sign + text.insert(exponent + 1, 1, '.');
}

}  // namespace gvd
