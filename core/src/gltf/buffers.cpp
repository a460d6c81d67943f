// SPDX-License-Identifier: MIT
#include "gltf/buffers.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "gltf/document.h"
#include "gltf/gltf_error.h"

namespace gvd::gltf {
namespace {

// --- URIs ----------------------------------------------------------------------------------------

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string percentDecoded(std::string_view text) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int high = i + 2 < text.size() && text[i] == '%' ? hexDigit(text[i + 1]) : -1;
    const int low = high >= 0 ? hexDigit(text[i + 2]) : -1;
    if (low >= 0) {
      decoded += static_cast<char>(16 * high + low);
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

/// The value of each base64 digit, -1 for other characters.
constexpr std::array<int, 256> kBase64Value = [] {
  std::array<int, 256> values{};
  values.fill(-1);
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < kDigits.size(); ++i)
    values[static_cast<unsigned char>(kDigits[i])] = static_cast<int>(i);
  return values;
}();

/// Whether a text is a word, given in small letters, but for capitals.
bool isInAnyCase(std::string_view text, std::string_view word) {
  const auto isSame = [](char c, char small) {
    return (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) == small;
  };
  return std::equal(text.begin(), text.end(), word.begin(), word.end(), isSame);
}

/// Padding may be missing; white space may stand anywhere.
std::optional<std::string> base64Decoded(std::string_view text) {
  std::string decoded;
  decoded.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int bitCount = 0;
  for (const char c : text.substr(0, text.find('='))) {
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
    const int value = kBase64Value[static_cast<unsigned char>(c)];
    if (value < 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    bitCount += 6;
    if (bitCount < 8) continue;
    bitCount -= 8;
    decoded += static_cast<char>(bits >> bitCount & 0xFF);
  }
  return decoded;
}

bool isDataUri(std::string_view uri) {
  constexpr std::string_view kScheme = "data:";
  return isInAnyCase(uri.substr(0, kScheme.size()), kScheme);
}

/// The content of `data:<media type>[;base64],<content>`; `owner` names the object that has the
/// URI.
std::string dataUriContent(std::string_view uri, const std::string& owner) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) reject(owner + " has a data URI without content");
  const std::string_view content = uri.substr(comma + 1);
  constexpr std::string_view kBase64 = ";base64";
  const std::string_view head = uri.substr(0, comma);
  if (head.size() < kBase64.size() ||
      !isInAnyCase(head.substr(head.size() - kBase64.size()), kBase64))
    return percentDecoded(content);
  const bool isEscaped = content.find('%') != std::string_view::npos;
  std::optional<std::string> decoded =
      isEscaped ? base64Decoded(percentDecoded(content)) : base64Decoded(content);
  if (!decoded) reject(owner + " has a data URI that is not base64");
  return *std::move(decoded);
}

/// Whether a path has a scheme or a drive, is absolute, or climbs out of the folder it begins in.
bool leadsOutside(std::string_view path) {
  constexpr std::string_view kSeparators = "/\\";
  if (path.find(':') != std::string_view::npos) return true;
  if (path.find_first_of(kSeparators) == 0) return true;
  int depth = 0;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find_first_of(kSeparators), path.size());
    const std::string_view name = path.substr(0, end);
    path.remove_prefix(std::min(end + 1, path.size()));
    if (name == "..") --depth;
    if (name != ".." && name != "." && !name.empty()) ++depth;
    if (depth < 0) return true;
  }
  return false;
}

}  // namespace

// --- Buffers -------------------------------------------------------------------------------------

Buffers::Buffers(std::vector<BufferObject> objects, std::optional<Bytes> bin,
                 std::span<const GltfResource> resources)
    : bin_(bin), resources_(resources) {
  buffers_.reserve(objects.size());
  for (BufferObject& object : objects) buffers_.push_back({std::move(object), {}, {}});
}

Bytes Buffers::at(int index, const std::string& owner) {
  requireIndex(index, buffers_.size(), "buffer", owner);
  Buffer& buffer = buffers_[index];
  const std::string name = "buffer " + std::to_string(index);
  if (!buffer.object.byteLength) reject(name + " has no byteLength");
  if (!buffer.content) buffer.content = content(buffer, index, name);
  const std::uint64_t length = *buffer.object.byteLength, has = buffer.content->size();
  if (length > has)
    reject(name + " should have " + std::to_string(length) + " bytes but has " +
           std::to_string(has));
  return buffer.content->first(length);
}

Bytes Buffers::content(Buffer& buffer, int index, const std::string& name) {
  if (!buffer.object.uri) {
    if (index == 0 && bin_) return *bin_;
    if (!buffer.object.compression.empty())
      reject(name + " stands for data compressed with " + buffer.object.compression +
             kNotDecompressed);
    reject(name + " has no uri, and there is no binary chunk for it");
  }
  const std::string& uri = *buffer.object.uri;
  if (isDataUri(uri)) {
    buffer.decoded = dataUriContent(uri, name);
    buffer.object.uri.reset();
    return std::as_bytes(std::span(buffer.decoded));
  }
  const std::string path = percentDecoded(uri);
  for (const GltfResource& resource : resources_)
    if (percentDecoded(resource.uri) == path) return resource.bytes;
  reject(name + " needs the file \"" + uri + "\", which is missing" +
         (leadsOutside(path) ? ": files outside the model's folder are not read" : ""));
}

}  // namespace gvd::gltf
