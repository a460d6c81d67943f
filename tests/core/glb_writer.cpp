// SPDX-License-Identifier: MIT
#include "glb_writer.h"

#include <cstdint>

namespace gvd {
namespace {

std::string joined(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ",") + text;
  return list;
}

void append(ByteVector& bytes, std::span<const std::byte> more) {
  bytes.insert(bytes.end(), more.begin(), more.end());
}

void append(ByteVector& bytes, std::uint32_t value) {
  append(bytes, std::as_bytes(std::span(&value, 1)));
}

void pad(ByteVector& bytes, char with) {
  while (bytes.size() % 4 != 0) bytes.push_back(static_cast<std::byte>(with));
}

std::string member(const std::string& name, int value) {
  return '"' + name + "\":" + std::to_string(value);
}

}  // namespace

int GlbWriter::addBytes(std::span<const std::byte> bytes, const std::string& members) {
  pad(bin, 0);
  bufferViews.push_back('{' + member("buffer", 0) + ',' +
                        member("byteOffset", static_cast<int>(bin.size())) + ',' +
                        member("byteLength", static_cast<int>(bytes.size())) + members + '}');
  append(bin, bytes);
  return static_cast<int>(bufferViews.size()) - 1;
}

int GlbWriter::addAccessor(int view, int componentType, int count, const std::string& type,
                           const std::string& members) {
  const std::string viewMember = view < 0 ? "" : member("bufferView", view) + ',';
  accessors.push_back('{' + viewMember + member("componentType", componentType) + ',' +
                      member("count", count) + ",\"type\":\"" + type + '"' + members + '}');
  return static_cast<int>(accessors.size()) - 1;
}

int GlbWriter::addPositions(const std::vector<float>& xyz) {
  return addAccessor(addView(xyz), kFloat, static_cast<int>(xyz.size() / 3), "VEC3");
}

std::string GlbWriter::primitive(int positions, int indices, int mode) {
  const std::string indicesMember = indices < 0 ? "" : ',' + member("indices", indices);
  return "{\"attributes\":{" + member("POSITION", positions) + '}' + indicesMember + ',' +
         member("mode", mode) + '}';
}

int GlbWriter::addMesh(const std::vector<std::string>& primitives, const std::string& members) {
  meshes.push_back("{\"primitives\":[" + joined(primitives) + ']' + members + '}');
  return static_cast<int>(meshes.size()) - 1;
}

int GlbWriter::addNode(const std::string& members) {
  nodes.push_back('{' + members + '}');
  return static_cast<int>(nodes.size()) - 1;
}

std::string GlbWriter::json(const std::string& bufferUri) const {
  std::string text = "{\"asset\":" + asset;
  const auto addList = [&](const std::string& name, const std::vector<std::string>& objects) {
    if (!objects.empty()) text += ",\"" + name + "\":[" + joined(objects) + ']';
  };
  addList("accessors", accessors);
  addList("bufferViews", bufferViews);
  addList("meshes", meshes);
  addList("nodes", nodes);
  addList("scenes", scenes);
  const std::string uri = bufferUri.empty() ? "" : ",\"uri\":\"" + bufferUri + '"';
  const std::string ownBuffer =
      '{' + member("byteLength", static_cast<int>(bin.size())) + uri + '}';
  addList("buffers", {buffers.empty() ? ownBuffer : buffers});
  return text + more + '}';
}

ByteVector GlbWriter::glb() const { return glbOf(json(), bin); }

ByteVector GlbWriter::gltf() const {
  return bytesOf(json("data:application/octet-stream;base64," + base64(bin)));
}

ByteVector glbOf(std::string_view json, std::span<const std::byte> bin) {
  constexpr std::uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBin = 0x004E4942;
  ByteVector jsonChunk = bytesOf(json), binChunk(bin.begin(), bin.end());
  pad(jsonChunk, ' ');
  pad(binChunk, 0);
  const std::size_t binTotal = binChunk.empty() ? 0 : 8 + binChunk.size();
  ByteVector bytes;
  append(bytes, kMagic);
  append(bytes, 2u);
  append(bytes, static_cast<std::uint32_t>(20 + jsonChunk.size() + binTotal));
  append(bytes, static_cast<std::uint32_t>(jsonChunk.size()));
  append(bytes, kJson);
  append(bytes, jsonChunk);
  if (!binChunk.empty()) {
    append(bytes, static_cast<std::uint32_t>(binChunk.size()));
    append(bytes, kBin);
    append(bytes, binChunk);
  }
  return bytes;
}

ByteVector bytesOf(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

std::string base64(std::span<const std::byte> bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t j = i; j < i + 3; ++j) {
      bits = bits << 8 | (j < bytes.size() ? std::to_integer<std::uint32_t>(bytes[j]) : 0);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text += i + j <= bytes.size() ? kDigits[bits >> (18 - 6 * j) & 63] : '=';
    }
  }
  return text;
}

}  // namespace gvd
