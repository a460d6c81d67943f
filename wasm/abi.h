// SPDX-License-Identifier: MIT
#pragma once

#include <emscripten/em_macros.h>

#include <cstdint>
#include <deque>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "gvd/error.h"

/// A C function that JavaScript calls. `src/wasm_module.ts` is the other side.
#define GVD_ABI extern "C" EMSCRIPTEN_KEEPALIVE

/// What every module of ours shares at its border with JavaScript. Arguments are numbers and
/// pointers to arrays that the caller allocated; a result that is more than one number is an
/// `Arrays`. An exception never crosses: a function that fails returns 0 (a null pointer), the
/// error is kept for the caller to read, and the instance stays usable.
namespace gvd::abi {

/// What failed, as a number; `errorCodes` in `src/wasm_module.ts` names them.
enum class Failure {
  kNone = 0,
  kInvalidMesh,
  kInvalidGltf,
  kInvalidPoint,
  kInvalidArgument,
  kOutOfMemory,
  kInternal,
};

void setFailure(Failure failure, const char* message);

/// Runs `f`; when it throws, keeps the error for the caller and returns a zero of f's type.
template <class F>
auto guarded(F&& f) -> decltype(f()) {
  setFailure(Failure::kNone, "");
  try {
    return f();
  } catch (const Error& error) {
    // Failure lists the codes of gvd::ErrorCode in their order, after kNone.
    setFailure(static_cast<Failure>(static_cast<int>(error.code()) + 1), error.what());
  } catch (const std::bad_alloc&) {
    setFailure(Failure::kOutOfMemory, "");
  } catch (const std::length_error&) {  // more elements than an address space has bytes
    setFailure(Failure::kOutOfMemory, "");
  } catch (const std::exception& error) {
    setFailure(Failure::kInternal, error.what());
  } catch (...) {
    setFailure(Failure::kInternal, "something was thrown that is no exception");
  }
  return {};
}

/// An ordered list of arrays on their way out; the caller copies them and frees the whole.
class Arrays {
 public:
  enum class Type : std::uint32_t { kInt32, kFloat64, kText };

  /// One row of the table that JavaScript reads.
  struct Row {
    const void* data;
    std::uint32_t length;
    Type type;
  };
  static_assert(sizeof(void*) != 4 || sizeof(Row) == 12);

  void add(std::vector<int> values) { keep(std::move(values), Type::kInt32); }
  void add(std::vector<double> values) { keep(std::move(values), Type::kFloat64); }
  void add(std::string utf8) { keep(std::move(utf8), Type::kText); }

  const std::vector<Row>& rows() const { return rows_; }

 private:
  template <class Values>
  void keep(Values&& values, Type type) {
    const auto& kept = std::get<std::decay_t<Values>>(values_.emplace_back(std::move(values)));
    rows_.push_back({kept.data(), static_cast<std::uint32_t>(kept.size()), type});
  }

  // A deque: its elements stay where they are, and with them a short string's characters.
  std::deque<std::variant<std::vector<int>, std::vector<double>, std::string>> values_;
  std::vector<Row> rows_;
};

}  // namespace gvd::abi
