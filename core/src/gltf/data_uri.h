// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace gvd::gltf {

std::string percentDecoded(std::string_view text);

bool isDataUri(std::string_view uri);

/// The content of `data:<media type>[;base64],<content>`; `owner` names the object that has the
/// URI.
std::string dataUriContent(std::string_view uri, const std::string& owner);

}  // namespace gvd::gltf
