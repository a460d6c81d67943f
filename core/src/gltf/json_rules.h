// SPDX-License-Identifier: MIT
//
// What the members of a glTF that triangles need have to look like: one table.
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
  /// Of a whole number, or of the length of an array.
  std::uint64_t least = 0, most = UINT64_MAX;
  std::uint64_t multipleOf = 1;
  bool isRequired = false;   ///< of the object that it is a member of
  std::string_view oneOf{};  ///< the texts it may be, with a comma and a space between

  /// The rule's object, and the name that the member has in it.
  std::string_view object() const { return path.substr(0, path.rfind('.')); }
  std::string_view name() const { return path.substr(path.rfind('.') + 1); }
};

std::span<const JsonRule> jsonRules();

/// The rule for a path; null if triangles do not need what is there.
const JsonRule* findRule(std::string_view path);

/// Whether a text is what its rule allows.
bool isAllowed(const JsonRule& rule, std::string_view text);

/// What a value has to be: "a whole number from 0 to 10".
std::string expectation(const JsonRule& rule);

}  // namespace gvd::gltf
