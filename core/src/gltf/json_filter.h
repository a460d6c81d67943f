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
  nlohmann::json document;  ///< only values that have a rule and obey it
  std::string fault;        ///< the first value that breaks its rule, named by its path; else empty
};

/// Parses JSON and keeps only the values that the rules (json_rules.h) name; other values take no
/// memory, however many and however deep they are. Throws if the text is not JSON or exceeds the
/// limits.
FilteredJson filterJson(std::string_view text, const GltfLimits& limits);

}  // namespace gvd::gltf
