// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#if __has_include(<nlohmann/json.hpp>)
#include <nlohmann/json.hpp>
#else  // beside tinygltf
#include <json.hpp>
#endif

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
