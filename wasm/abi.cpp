// SPDX-License-Identifier: MIT
#include "abi.h"

#include <cstdlib>

namespace gvd::abi {
namespace {

Failure lastFailure = Failure::kNone;
std::string lastMessage;

}  // namespace

void setFailure(Failure failure, const char* message) {
  lastFailure = failure;
  try {
    lastMessage = message;
  } catch (const std::bad_alloc&) {
    lastMessage.clear();  // the code alone has to do
  }
}

/// Memory for an argument; null if there is none.
GVD_ABI void* allocate(std::size_t bytes) { return std::malloc(bytes); }
GVD_ABI void release(void* memory) { std::free(memory); }

/// The error of the last call that failed.
GVD_ABI int errorCode() { return static_cast<int>(lastFailure); }
GVD_ABI const char* errorMessage() { return lastMessage.data(); }
GVD_ABI std::size_t errorMessageLength() { return lastMessage.size(); }

GVD_ABI std::size_t arrayCount(const Arrays* arrays) { return arrays->rows().size(); }
GVD_ABI const Arrays::Row* arrayRows(const Arrays* arrays) { return arrays->rows().data(); }
GVD_ABI void freeArrays(Arrays* arrays) { delete arrays; }

}  // namespace gvd::abi
