// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "metrics.h"

namespace gvd::bench {

/// The options of gvd_bench; `kUsage` describes them.
struct Options {
  std::vector<int> sites = {1, 10, 100, 300, 1000, 5000};  ///< speed is measured with each number
  std::uint64_t seed = 1;
  int runs = 5;
  int detail = 0;
  int subdivisions = 0;
  std::vector<NamedMetric> metrics{kMetrics.begin(), kMetrics.end()};
  std::string only;  ///< measures only meshes and cases whose name contains this
  std::vector<std::filesystem::path> meshes;
  bool generated = false;  ///< the generated meshes, too, if others are given
  std::vector<std::filesystem::path> cases;
  std::filesystem::path meshFolder;  ///< where meshes of speed tests are written; empty: nowhere
  std::vector<std::filesystem::path> tessellations;
  std::set<std::string> parts = {"speed", "size", "accuracy", "convergence", "cvt"};
  int oracleSites = 30;
  int oraclePoints = 1000;
  int oracleFaces = 6000;
};

extern const char* const kUsage;

/// Throws `std::invalid_argument` with a message of one line.
Options parseOptions(const std::vector<std::string>& arguments);

}  // namespace gvd::bench
