// SPDX-License-Identifier: MIT
#include "gltf/glb_container.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "gltf/gltf_error.h"

namespace gvd::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is read as it lies in memory");

std::string_view asText(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::uint32_t uint32At(Bytes bytes, std::size_t offset) {
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

struct Chunk {
  std::uint32_t type = 0;
  Bytes content;
};

/// Takes the first chunk (length, type, content) off `rest`; an empty one of type 0 if `rest` is
/// shorter than a header.
Chunk takeChunk(Bytes& rest) {
  constexpr std::size_t kHeaderSize = 8;
  if (rest.size() < kHeaderSize) return {};
  const std::uint32_t length = uint32At(rest, 0), type = uint32At(rest, 4);
  rest = rest.subspan(kHeaderSize);
  if (length > rest.size()) reject("a chunk of the GLB reaches past its end");
  const Bytes content = rest.first(length);
  rest = rest.subspan(length);
  return {type, content};
}

/// A GLB is a header (magic, version, length) and chunks: the first is JSON, the second may be
/// binary, further ones are ignored.
Container openGlb(Bytes bytes) {
  constexpr std::size_t kHeaderSize = 12;
  constexpr std::uint32_t kJson = 0x4E4F534A, kBin = 0x004E4942;

  if (bytes.size() < kHeaderSize) reject("the GLB is truncated within its header");
  const std::uint32_t version = uint32At(bytes, 4), length = uint32At(bytes, 8);
  if (version != 2)
    reject("this is GLB version " + std::to_string(version) + "; only version 2 is read");
  if (length > bytes.size())
    reject("the GLB is truncated: it should have " + std::to_string(length) + " bytes but has " +
           std::to_string(bytes.size()));
  Bytes rest = bytes.first(length).subspan(std::min<std::size_t>(kHeaderSize, length));
  const Chunk json = takeChunk(rest), bin = takeChunk(rest);
  if (json.type != kJson) reject("the GLB does not begin with a JSON chunk");
  if (bin.type != kBin) return {asText(json.content), std::nullopt};
  return {asText(json.content), bin.content};
}

}  // namespace

Container openContainer(Bytes bytes) {
  const std::string_view text = asText(bytes);
  if (text.empty()) reject("the file is empty");
  if (text.starts_with("glTF")) return openGlb(bytes);
  const std::string_view withoutMark = text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
  const std::size_t first = withoutMark.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || withoutMark[first] != '{')
    reject("this is neither GLB nor glTF JSON");
  return {withoutMark, std::nullopt};
}

}  // namespace gvd::gltf
