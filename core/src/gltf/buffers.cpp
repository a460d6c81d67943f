// SPDX-License-Identifier: MIT
#include "gltf/buffers.h"

#include <utility>

#include "gltf/data_uri.h"
#include "gltf/document.h"
#include "gltf/gltf_error.h"

namespace gvd::gltf {

Buffers::Buffers(std::vector<BufferObject> objects, std::optional<Bytes> bin,
                 std::span<const GltfResource> resources)
    : bin_(bin), resources_(resources) {
  buffers_.reserve(objects.size());
  for (BufferObject& object : objects) buffers_.push_back({std::move(object), {}, {}});
}

Bytes Buffers::at(int index, const std::string& owner) {
  requireIndex(index, buffers_.size(), "buffer", owner);
  Buffer& buffer = buffers_[index];
  if (!buffer.bytes) buffer.bytes = load(buffer, index);
  return *buffer.bytes;
}

Bytes Buffers::load(Buffer& buffer, int index) {
  const std::string name = "buffer " + std::to_string(index);
  if (!buffer.object.byteLength) reject(name + " has no byteLength");
  const std::uint64_t length = *buffer.object.byteLength;
  const Bytes bytes = content(buffer, index, name);
  if (length > bytes.size()) {
    reject(name + " should have " + number(length) + " bytes but has " + number(bytes.size()));
  }
  return bytes.first(length);
}

Bytes Buffers::content(Buffer& buffer, int index, const std::string& name) {
  if (!buffer.object.uri) {
    if (index == 0 && bin_) return *bin_;
    if (!buffer.object.compression.empty()) {
      reject(name + " stands for data compressed with " + buffer.object.compression +
             kDecompressFirst);
    }
    reject(name + " has no uri, and there is no binary chunk for it");
  }
  const std::string& uri = *buffer.object.uri;
  if (isDataUri(uri)) {
    buffer.decoded = dataUriContent(uri, name);
    buffer.object.uri.reset();
    return std::as_bytes(std::span(buffer.decoded));
  }
  const std::string path = percentDecoded(uri);
  for (const GltfResource& resource : resources_) {
    if (percentDecoded(resource.uri) == path) return resource.bytes;
  }
  reject("it needs the file \"" + uri + "\" (" + name + "), which is missing");
}

}  // namespace gvd::gltf
