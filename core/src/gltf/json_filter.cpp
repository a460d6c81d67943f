// SPDX-License-Identifier: MIT
#include "gltf/json_filter.h"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "gltf/gltf_error.h"
#include "gltf/json_rules.h"

namespace gvd::gltf {
namespace {

using nlohmann::json;

/// Real files nest about a dozen levels.
constexpr int kMaxDepth = 128;

/// Digits of a number, and signs, points and exponents. nlohmann's parser holds a number as text
/// several times.
constexpr std::size_t kMaxNumberLength = 4096;

/// On average: an accessor has five members, and six more if it is sparse. A member takes 100
/// bytes.
constexpr std::uint64_t kMaxMembersPerObject = 8;
/// On average: a node with a matrix and children has seventeen or more elements, but its mesh,
/// primitives and accessors have few. An element takes 16 bytes.
constexpr std::uint64_t kMaxElementsPerObject = 16;

/// Receives the events of nlohmann's SAX parser. Skips values without a rule, and values that break
/// their rule, which are faults.
class JsonFilter {
 public:
  explicit JsonFilter(const GltfLimits& limits) : limits_(limits) {}

  FilteredJson take() { return {std::move(document_), std::move(fault_)}; }

  bool null() { return skip(next(), "null"); }

  bool boolean(bool value) {
    const JsonRule* rule = next();
    if (!rule || rule->kind != JsonKind::kBoolean) return skip(rule, value ? "true" : "false");
    return keep(value);
  }

  bool number_unsigned(std::uint64_t value) {
    const JsonRule* rule = next();
    if (!rule) return true;
    const bool fits = rule->kind == JsonKind::kWholeNumber && value >= rule->least &&
                      value <= rule->most && value % rule->multipleOf == 0;
    if (!fits && rule->kind != JsonKind::kNumber) return skip(rule, std::to_string(value));
    return keep(value);
  }

  /// nlohmann passes only negative integers here.
  bool number_integer(std::int64_t value) {
    const JsonRule* rule = next();
    if (!rule || rule->kind != JsonKind::kNumber) return skip(rule, std::to_string(value));
    return keep(value);
  }

  bool number_float(double value, const std::string& text) {
    constexpr double kMostExact = 9007199254740992;  // 2^53
    if (value >= 0 && value <= kMostExact && value == std::floor(value))
      return number_unsigned(static_cast<std::uint64_t>(value));  // 3.0, 1e2
    const JsonRule* rule = next();
    if (!rule || rule->kind != JsonKind::kNumber) return skip(rule, text.substr(0, 40));
    return keep(value);
  }

  bool string(std::string& value) {
    const JsonRule* rule = next();
    if (!rule || rule->kind != JsonKind::kText) return skip(rule, "a string");
    if (!isAllowed(*rule, value)) return skip(rule, '"' + value.substr(0, 40) + '"');
    return keep(std::move(value));
  }

  static bool binary(json::binary_t&) { return true; }  // JSON has none

  bool start_object(std::size_t) { return open(JsonKind::kObject, "an object"); }
  bool start_array(std::size_t) { return open(JsonKind::kArray, "an array"); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    if (skippedLevels_ == 0) key_ = std::move(name);
    return true;
  }

  static bool parse_error(std::size_t position, const std::string&, const json::exception& error) {
    constexpr int kNumberOverflow = 406;
    if (error.id == kNumberOverflow) reject("the JSON has a number that is too large");
    reject("the JSON is malformed at byte " + std::to_string(position));
  }

 private:
  /// An array or object that is open.
  struct Level {
    const JsonRule* rule;
    json* value;
    std::uint64_t length = 0;  ///< of an array: the elements so far
  };

  /// Finds the rule for the next value, and counts the value if it is an element of an array.
  const JsonRule* next() {
    if (skippedLevels_ > 0) return nullptr;
    path_.clear();
    if (!levels_.empty()) {
      Level& level = levels_.back();
      path_ = level.rule->path;
      if (level.rule->kind == JsonKind::kArray) {
        path_ += "[]";
        if (++level.length > level.rule->most) return nullptr;
      } else {
        // A name like "a.b" could be taken for the member b of a member a.
        if (key_.empty() || key_.find_first_of(".[") != std::string::npos) return nullptr;
        if (!path_.empty()) path_ += '.';
        path_ += key_;
      }
    }
    return findRule(path_);
  }

  /// Skips a value, which is `what`; if it has a rule, that is a fault.
  bool skip(const JsonRule* rule, const std::string& what) {
    if (rule)
      setFault(pathWithIndices(rule->path) + " is " + what + "; it must be " + expectation(*rule));
    return true;
  }

  bool keep(json value) {
    add(std::move(value));
    return true;
  }

  json& add(json value) {
    if (levels_.empty()) return document_ = std::move(value);
    const Level& level = levels_.back();
    if (level.rule->kind == JsonKind::kObject) {
      count(members_, kMaxMembersPerObject * limits_.maxObjects, "members of objects");
      return (*level.value)[key_] = std::move(value);
    }
    count(elements_, kMaxElementsPerObject * limits_.maxObjects, "elements of arrays");
    level.value->push_back(std::move(value));
    return level.value->back();
  }

  static void count(std::uint64_t& sum, std::uint64_t most, const char* what) {
    if (++sum <= most) return;
    reject("the glTF has more than " + std::to_string(most) + ' ' + what + toRaise("maxObjects"));
  }

  bool open(JsonKind kind, const char* what) {
    if (++depth_ > kMaxDepth)
      reject("the JSON is nested more than " + std::to_string(kMaxDepth) + " levels deep");
    const JsonRule* rule = next();
    if (!rule || rule->kind != kind) {
      skip(rule, what);
      ++skippedLevels_;
      return true;
    }
    if (kind == JsonKind::kObject && rule->path.ends_with("[]"))
      count(objects_, limits_.maxObjects, "nodes, meshes, accessors and other objects");
    json& value = add(kind == JsonKind::kObject ? json::object() : json::array());
    levels_.push_back({rule, &value});
    return true;
  }

  bool close() {
    --depth_;
    if (skippedLevels_ > 0) {
      --skippedLevels_;
      return true;
    }
    const Level level = levels_.back();
    levels_.pop_back();
    const bool isArray = level.rule->kind == JsonKind::kArray;
    if (isArray && (level.length < level.rule->least || level.length > level.rule->most)) {
      setFault(pathWithIndices(level.rule->path) + " has " + std::to_string(level.length) +
               " elements; it must have " + std::to_string(level.rule->least));
    }
    if (!isArray) {
      for (const JsonRule& member : jsonRules()) {
        const bool isMissing = member.isRequired && member.object() == level.rule->path &&
                               !level.value->contains(member.name());
        if (isMissing)
          setFault(pathWithIndices(level.rule->path) + " has no " + std::string(member.name()));
      }
    }
    return true;
  }

  void setFault(std::string text) {
    if (fault_.empty()) fault_ = std::move(text);
  }

  /// "nodes[].children[]" as "nodes[3].children[0]".
  std::string pathWithIndices(std::string_view path) const {
    std::string text;
    auto level = levels_.begin();
    for (char c : path) {
      if (c == ']') {
        while (level->rule->kind != JsonKind::kArray) ++level;
        text += std::to_string(level++->length - 1);
      }
      text += c;
    }
    return text;
  }

  const GltfLimits& limits_;
  json document_;
  std::string fault_;
  std::vector<Level> levels_;
  int depth_ = 0;
  std::size_t skippedLevels_ = 0;
  std::string key_;   ///< of the current member
  std::string path_;  ///< of the current value; a member, to reuse its memory
  std::uint64_t objects_ = 0, members_ = 0, elements_ = 0;
};

/// Throws if a number is too long.
void requireShortNumbers(std::string_view text) {
  std::size_t length = 0;  // of the number so far
  bool isInString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') isInString = !isInString;
    if (isInString && c == '\\') ++i;  // the next character does not end the string
    const bool isOfNumber = !isInString && ((c >= '0' && c <= '9') || c == '.' || c == '-');
    length = isOfNumber ? length + 1 : 0;
    if (length > kMaxNumberLength)
      reject("the JSON has a number of more than " + std::to_string(kMaxNumberLength) +
             " characters");
  }
}

}  // namespace

FilteredJson filterJson(std::string_view text, const GltfLimits& limits) {
  if (text.size() > limits.maxJsonBytes)
    reject("the JSON has " + std::to_string(text.size()) + " bytes, more than " +
           std::to_string(limits.maxJsonBytes) + toRaise("maxJsonBytes"));
  requireShortNumbers(text);
  JsonFilter filter(limits);
  json::sax_parse(text, &filter);
  return filter.take();
}

}  // namespace gvd::gltf
