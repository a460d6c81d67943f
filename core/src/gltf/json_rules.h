// SPDX-License-Identifier: MIT
//
// Rules for the members of a glTF that triangles need, as one table.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace gvd::gltf {

enum class JsonKind { kObject, kArray, kWholeNumber, kNumber, kText, kBoolean };

struct JsonRule {
  /// Members joined by dots, `[]` for every element of an array: "nodes[].children[]".
  std::string_view path;
  JsonKind kind;
  /// The range of a whole number, or of the length of an array.
  std::uint64_t least = 0, most = UINT64_MAX;
  std::uint64_t multipleOf = 1;
  bool isRequired = false;   ///< in the object that it is a member of
  std::string_view oneOf{};  ///< allowed texts, separated by ", "; empty: any

  /// The path of the object, and the name of the member in it.
  std::string_view object() const { return path.substr(0, path.rfind('.')); }
  std::string_view name() const { return path.substr(path.rfind('.') + 1); }
};

std::span<const JsonRule> jsonRules();

/// The rule for a path; null if triangles do not need its value.
const JsonRule* findRule(std::string_view path);

/// Whether the rule allows a text.
bool isAllowed(const JsonRule& rule, std::string_view text);

/// What the rule requires: "a whole number from 0 to 10".
std::string expectation(const JsonRule& rule);

}  // namespace gvd::gltf
