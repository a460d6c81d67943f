// SPDX-License-Identifier: MIT
/// \file
/// The exception that the functions of the library throw on bad input.
#pragma once

#include <stdexcept>
#include <string>

namespace gvd {

/// What went wrong, for programs; `Error::what()` says it in one sentence, for people.
enum class ErrorCode {
  kInvalidMesh,   ///< the triangles cannot be made into a surface
  kInvalidGltf,   ///< the bytes are not a glTF this library reads
  kInvalidPoint,  ///< a site or query point is not on the surface
  kTooFewSites,   ///< the dual is not valid with as many sites as may be added, or more do not help
  kInvalidArgument,  ///< an option, count or list does not fit, as the function says
};

/// Thrown because of bad input, and for no other reason. The message is one sentence that names
/// what is wrong and where (index, value). Three more exceptions can come from the library:
/// `std::bad_alloc`, `std::length_error` for a list longer than memory can be, and otherwise
/// `std::logic_error` if intermediate results contradict each other: a bug to be reported, unless a
/// `DistanceField` of the caller's own lacks distances (`traceDiagram`).
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

}  // namespace gvd
