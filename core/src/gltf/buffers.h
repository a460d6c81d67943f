// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gltf/glb_container.h"
#include "gltf/gltf_json.h"
#include "gvd/gltf.h"

namespace gvd::gltf {

/// The buffers of a document. Each is loaded on first access, because a file may list buffers that
/// no triangle needs.
class Buffers {
 public:
  Buffers(std::vector<BufferObject> objects, std::optional<Bytes> bin,
          std::span<const GltfResource> resources);

  /// The `byteLength` bytes of a buffer that `owner` names.
  Bytes at(int index, const std::string& owner);

 private:
  struct Buffer {
    BufferObject object;
    std::string decoded;           ///< the content of a data URI; the URI is dropped
    std::optional<Bytes> content;  ///< once it is loaded; may have more bytes than the buffer
  };

  Bytes content(Buffer& buffer, int index, const std::string& name);

  std::optional<Bytes> bin_;
  std::span<const GltfResource> resources_;
  std::vector<Buffer> buffers_;
};

}  // namespace gvd::gltf
