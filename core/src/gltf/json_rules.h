// SPDX-License-Identifier: MIT
//
// What the members of a glTF that triangles need have to look like: one table.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gvd::gltf {

enum class JsonKind { kObject, kArray, kWholeNumber, kNumber, kText, kBoolean };

struct JsonRule {
  /// Members joined by dots, `[]` for every element of an array: "nodes[].children[]".
  std::string_view path;
  JsonKind kind;
  /// Of a whole number, or of the length of an array.
  std::uint64_t least = 0, most = UINT64_MAX;
  std::uint64_t multipleOf = 1;
};

/// The rule for a path; null if triangles do not need what is there.
const JsonRule* findRule(std::string_view path);

/// What a value has to be: "a whole number from 0 to 10".
std::string expectation(const JsonRule& rule);

}  // namespace gvd::gltf
