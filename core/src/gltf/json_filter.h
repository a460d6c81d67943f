// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "gvd/gltf.h"

namespace gvd::gltf {

struct FilteredJson {
  nlohmann::json document;  ///< only what has a rule and keeps it
  std::string fault;        ///< the first value that breaks its rule, named by its path; else empty
};

/// Parses JSON and keeps of it what the rules (json_rules.h) name: the rest, however much of it and
/// however deep, takes no memory. Throws if the text is not JSON or goes beyond the limits.
FilteredJson filterJson(std::string_view text, const GltfLimits& limits);

}  // namespace gvd::gltf
