// SPDX-License-Identifier: MIT
// This work is based on:
// Jonathan Richard Shewchuk. Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates. 1997
#include "base/predicates.h"

#include <cmath>
#include <limits>

namespace gvd {
namespace {

constexpr double kUnitRoundoff = std::numeric_limits<double>::epsilon() / 2;
// Shewchuk's A-bounds: the rounded determinant has the right sign beyond bound × permanent.
constexpr double kBound2 = (3 + 16 * kUnitRoundoff) * kUnitRoundoff;
constexpr double kBound3 = (7 + 56 * kUnitRoundoff) * kUnitRoundoff;

struct Sum {
  double high, low;  // high + low is exact, high the rounded result
};

Sum exactSum(double a, double b) {
  const double high = a + b;
  const double bVirtual = high - a;
  return {high, (a - (high - bVirtual)) + (b - bVirtual)};
}

struct Split {
  double high, low;
};

Split split(double a) {
  constexpr double kSplitter = 134217729;  // 2^27 + 1: halves of 26 bits
  const double c = kSplitter * a;
  const double high = c - (c - a);
  return {high, a - high};
}

Sum exactProduct(double a, double b) {
  const double high = a * b;
  const Split x = split(a), y = split(b);
  const double error = high - x.high * y.high - x.low * y.high - x.high * y.low;
  return {high, x.low * y.low - error};
}

/// An exact sum of at most `kCapacity` doubles, kept as a non-overlapping expansion: components in
/// increasing magnitude, so the last one that is not zero has the sign of the whole.
template <int kCapacity>
class Expansion {
 public:
  void add(double term) {
    int kept = 0;
    for (int i = 0; i < size_; ++i) {
      const Sum s = exactSum(term, component_[i]);
      if (s.low != 0) component_[kept++] = s.low;
      term = s.high;
    }
    if (term != 0) component_[kept++] = term;
    size_ = kept;
  }
  /// The sum, up to rounding; of the right sign.
  double value() const {
    double sum = 0;
    for (int i = 0; i < size_; ++i) sum += component_[i];
    return sum;
  }

 private:
  std::array<double, kCapacity> component_;
  int size_ = 0;
};

int signOf(double x) { return (x > 0) - (x < 0); }

double exactDeterminant(const std::array<double, 2>& a, const std::array<double, 2>& b,
                        const std::array<double, 2>& c) {
  Expansion<12> determinant;
  const auto addProduct = [&](double x, double y) {
    const Sum p = exactProduct(x, y);
    determinant.add(p.low);
    determinant.add(p.high);
  };
  addProduct(b[0], c[1]);
  addProduct(-b[1], c[0]);
  addProduct(c[0], a[1]);
  addProduct(-c[1], a[0]);
  addProduct(a[0], b[1]);
  addProduct(-a[1], b[0]);
  return determinant.value();
}

double exactDeterminant(const std::array<double, 3>& a, const std::array<double, 3>& b,
                        const std::array<double, 3>& c, const std::array<double, 3>& d) {
  Expansion<96> determinant;
  const auto addProduct = [&](double x, double y, double z) {
    const Sum p = exactProduct(x, y);
    for (const double part : {p.low, p.high}) {
      const Sum q = exactProduct(part, z);
      determinant.add(q.low);
      determinant.add(q.high);
    }
  };
  // |p q r| of rows, added with a sign: the expansion of | 1 a ; 1 b ; 1 c ; 1 d | by its first
  // column.
  const auto addTriple = [&](const std::array<double, 3>& p, const std::array<double, 3>& q,
                             const std::array<double, 3>& r, double sign) {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      addProduct(sign * p[i], q[j], r[k]);
      addProduct(-sign * p[i], q[k], r[j]);
    }
  };
  addTriple(b, c, d, 1);
  addTriple(a, c, d, -1);
  addTriple(a, b, d, 1);
  addTriple(a, b, c, -1);
  return determinant.value();
}

/// | b-a ; c-a | with at most this relative error; with 1, of the right sign.
double determinantWithin(double relativeError, const std::array<double, 2>& a,
                         const std::array<double, 2>& b, const std::array<double, 2>& c) {
  const double left = (b[0] - a[0]) * (c[1] - a[1]);
  const double right = (b[1] - a[1]) * (c[0] - a[0]);
  const double rounded = left - right;
  const double error = kBound2 * (std::abs(left) + std::abs(right));
  return relativeError * std::abs(rounded) > error ? rounded : exactDeterminant(a, b, c);
}

}  // namespace

int orientation(const std::array<double, 2>& a, const std::array<double, 2>& b,
                const std::array<double, 2>& c) {
  return signOf(determinantWithin(1, a, b, c));
}

int orientation(const std::array<double, 3>& a, const std::array<double, 3>& b,
                const std::array<double, 3>& c, const std::array<double, 3>& d) {
  const double b0 = b[0] - a[0], b1 = b[1] - a[1], b2 = b[2] - a[2];
  const double c0 = c[0] - a[0], c1 = c[1] - a[1], c2 = c[2] - a[2];
  const double d0 = d[0] - a[0], d1 = d[1] - a[1], d2 = d[2] - a[2];
  const double c1d2 = c1 * d2, c2d1 = c2 * d1;
  const double c2d0 = c2 * d0, c0d2 = c0 * d2;
  const double c0d1 = c0 * d1, c1d0 = c1 * d0;
  const double determinant = b0 * (c1d2 - c2d1) + b1 * (c2d0 - c0d2) + b2 * (c0d1 - c1d0);
  const double permanent = std::abs(b0) * (std::abs(c1d2) + std::abs(c2d1)) +
                           std::abs(b1) * (std::abs(c2d0) + std::abs(c0d2)) +
                           std::abs(b2) * (std::abs(c0d1) + std::abs(c1d0));
  if (std::abs(determinant) > kBound3 * permanent) return signOf(determinant);
  return signOf(exactDeterminant(a, b, c, d));
}

double determinant(const std::array<double, 2>& a, const std::array<double, 2>& b,
                   const std::array<double, 2>& c) {
  return determinantWithin(1e-12, a, b, c);
}

}  // namespace gvd
