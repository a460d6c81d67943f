// SPDX-License-Identifier: MIT
#include "gltf/buffers.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "gltf/data_uri.h"
#include "gltf/document.h"
#include "gltf/gltf_error.h"

namespace gvd::gltf {
namespace {

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
