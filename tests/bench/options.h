// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace gvd::bench {

/// What gvd_bench is asked for: `--name value` each, `kUsage` says which.
struct Options {
  int sites = 300;
  std::uint64_t seed = 1;
  int runs = 5;
  int detail = 0;
  std::string only;  ///< measures the meshes with this in their name
  std::vector<std::filesystem::path> models;
  std::vector<std::filesystem::path> cases;
  std::filesystem::path meshFolder;  ///< gets the meshes that speed was measured on; empty: none
  std::vector<std::filesystem::path> tessellations;
  std::set<std::string> parts = {"speed", "accuracy", "convergence", "cvt"};
  int oracleSites = 30;
  int oraclePoints = 1000;
  int oracleFaces = 6000;
};

extern const char* const kUsage;

/// Throws `std::invalid_argument` with one line for people.
Options parseOptions(const std::vector<std::string>& arguments);

}  // namespace gvd::bench
