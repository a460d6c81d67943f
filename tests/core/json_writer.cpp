// SPDX-License-Identifier: MIT
#include "json_writer.h"

#include <array>
#include <charconv>
#include <cmath>

namespace gvd {

void JsonWriter::number(std::string_view name, double value) {
  startValue(name);
  if (!std::isfinite(value)) {
    out_ << "null";
    return;
  }
  std::array<char, 32> digits;
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  out_.write(digits.data(), result.ptr - digits.data());
}

void JsonWriter::text(std::string_view name, std::string_view value) {
  startValue(name);
  quoted(value);
}

void JsonWriter::begin(std::string_view name, char bracket) {
  startValue(name);
  out_ << bracket;
  isEmpty_.push_back(true);
}

void JsonWriter::end(char bracket) {
  isEmpty_.pop_back();
  out_ << bracket;
  if (isEmpty_.empty()) out_ << '\n';
}

void JsonWriter::startValue(std::string_view name) {
  if (!isEmpty_.empty()) {
    if (!isEmpty_.back()) out_ << ',';
    isEmpty_.back() = false;
  }
  if (name.empty()) return;
  quoted(name);
  out_ << ':';
}

void JsonWriter::quoted(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  out_ << '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out_ << '\\' << c;
    } else if (static_cast<unsigned char>(c) < ' ') {
      out_ << "\\u00" << kHex[c / 16] << kHex[c % 16];
    } else {
      out_ << c;
    }
  }
  out_ << '"';
}

}  // namespace gvd
