// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace gvd {

/// Writes a JSON document from start to end. Values, lists and objects have a name in an object,
/// and none in a list.
class JsonWriter {
 public:
  explicit JsonWriter(std::ostream& out) : out_(out) {}

  void beginObject(std::string_view name = {}) { begin(name, '{'); }
  void endObject() { end('}'); }
  void beginList(std::string_view name = {}) { begin(name, '['); }
  void endList() { end(']'); }

  void number(std::string_view name, double value);
  void text(std::string_view name, std::string_view value);

 private:
  void begin(std::string_view name, char bracket);
  void end(char bracket);
  void startValue(std::string_view name);
  void quoted(std::string_view text);

  std::ostream& out_;
  std::vector<bool> isEmpty_;  ///< every open list and object, the outermost first
};

}  // namespace gvd
