// SPDX-License-Identifier: MIT
//
// What every module of ours shares at its border with JavaScript: how arguments come in, how
// results and errors go out. `src/base/wasm_module.ts` is the other side.
//
// The C++ functions themselves are the only list of what can be called. JavaScript calls them by
// name, with as many arguments as they have; results and the names of options cross by name, too.
// Only `Row`, its `Type` and `SliceEnd` are read by their layout and numbers.
#pragma once

#include <emscripten/em_macros.h>

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <list>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/sliced_loop.h"
#include "gvd/error.h"
#include "gvd/sliced_work.h"

/// A C function that JavaScript calls.
#define GVD_ABI extern "C" EMSCRIPTEN_KEEPALIVE

namespace gvd::abi {

/// An array that JavaScript has copied into this memory for the length of a call. Passed by
/// reference: each argument is one number on the other side.
template <class T>
struct Array {
  const T* data;
  std::size_t size;

  std::span<const T> span() const { return {data, size}; }
};
using Ints = const Array<int>&;
using Doubles = const Array<double>&;
using Bytes = const Array<std::byte>&;
using Text = const Array<char>&;

inline std::string toString(Text text) { return {text.data, text.size}; }

/// A result: named values, of which JavaScript makes an object. A dot in a name leads into an
/// object inside: `points.face`.
class Record {
 public:
  void add(const char* name, std::vector<int> values);
  void add(const char* name, std::vector<double> values);
  /// The numbers of all items, in one list.
  void add(const char* name, std::vector<std::array<int, 2>> values);
  void add(const char* name, std::vector<std::array<int, 3>> values);
  void add(const char* name, std::vector<Eigen::Vector3d> values);
  void add(const char* name, std::string utf8);
  void add(const char* name, const char* utf8) = delete;  ///< it would be taken for a boolean
  void add(const char* name, std::vector<std::string> texts);
  void add(const char* name, double number);
  void add(const char* name, int number) { add(name, static_cast<double>(number)); }
  void add(const char* name, bool truth);
  /// The values of another record, as an object inside.
  void add(const char* name, Record inner);
  /// The values of another record beside these.
  void add(Record others);

  enum class Type : std::uint32_t { kInts, kDoubles, kText, kNumber, kBoolean, kTexts };

  /// One row of the table that JavaScript reads. A number or a boolean is a double in memory.
  /// `kTexts` is an empty list, and the texts of that name which follow are its elements.
  struct Row {
    Array<char> name;
    const void* data;
    std::uint32_t length;
    Type type;
  };
  static_assert(sizeof(void*) != 4 || sizeof(Row) == 20);

  /// Valid as long as this record is, and nothing is added.
  std::vector<Row> rows() const;

 private:
  struct Entry {
    std::string name;
    Type type;
    std::shared_ptr<const void> values;
    const void* data;  ///< of the values
    std::size_t length;
  };

  template <class Values>
  void addValues(const char* name, Type type, Values values, std::size_t numbersPerItem = 1);

  // A list: joining two leaves everything where it is.
  std::list<Entry> entries_;
};

/// How a slice of work ended; zero when it failed, as with every function here.
enum SliceEnd { kFailed = 0, kMoreToDo = 1, kDone = 2 };

/// The answer to a call: work that JavaScript steps through, if any, then the record that it ends
/// in, which JavaScript copies and frees.
struct Answer {
  std::unique_ptr<SlicedWork<Record>> work;
  Record record;
  std::vector<Record::Row> rows = record.rows();
};

/// Keeps the error that is being handled, for JavaScript to read after the call.
void keepError();
void clearError();

/// Runs `f`; when it throws, keeps the error and returns a zero of f's type. An exception never
/// crosses, and the instance stays usable.
template <class F>
auto guarded(F&& f) -> decltype(f()) {
  clearError();
  try {
    return f();
  } catch (...) {
    keepError();
  }
  return {};
}

/// Runs `f`, which returns a `Record`.
template <class F>
Answer* answer(F&& f) {
  return guarded([&] { return new Answer{nullptr, f()}; });
}

/// A record made of the result of sliced work.
template <class Result, class ToRecord>
class RecordOfResult final : public SlicedWork<Record> {
 public:
  RecordOfResult(std::unique_ptr<SlicedWork<Result>> work, ToRecord toRecord)
      : toRecord_(std::move(toRecord)), work_(std::move(work)) {}
  bool advance(long budget) override { return work_->step(budget); }
  double share() const override { return work_->progress(); }
  Record result() override { return toRecord_(work_->take()); }

 private:
  ToRecord toRecord_;  // keeps what the work refers to, so it has to outlive the work
  std::unique_ptr<SlicedWork<Result>> work_;
};

/// Work that ends in a record: `toRecord(result)` of other work.
template <class Result, class ToRecord>
std::unique_ptr<SlicedWork<Record>> recording(std::unique_ptr<SlicedWork<Result>> work,
                                              ToRecord toRecord) {
  return std::make_unique<RecordOfResult<Result, ToRecord>>(std::move(work), std::move(toRecord));
}

/// An answer that is worked on in slices (`stepAnswer`).
inline Answer* answerOf(std::unique_ptr<SlicedWork<Record>> work) {
  return new Answer{std::move(work), {}};
}
template <class Result, class ToRecord>
Answer* answerOf(std::unique_ptr<SlicedWork<Result>> work, ToRecord toRecord) {
  return answerOf(recording(std::move(work), std::move(toRecord)));
}

/// The address of an object, by name, which JavaScript owns from then on.
template <class Object>
Record addressRecord(const char* name, std::unique_ptr<Object> object) {
  Record out;
  out.add(name, static_cast<double>(reinterpret_cast<std::uintptr_t>(object.get())));
  static_cast<void>(object.release());  // only now, as `add` may throw
  return out;
}

/// An enumerator and its name in JavaScript.
template <class Enum>
struct Named {
  const char* name;
  Enum value;
};

/// The enumerator of a name; `what` says what it is for, if there is none.
template <class Enum, std::size_t n>
Enum valueOf(const Named<Enum> (&table)[n], const char* what, Text text) {
  const std::string name = toString(text);
  std::string names;
  for (const Named<Enum>& entry : table) {
    if (entry.name == name) return entry.value;
    names.append(names.empty() ? "" : ", ").append(entry.name);
  }
  throw Error(ErrorCode::kInvalidArgument,
              std::string(what) + " is \"" + name + "\", not one of " + names);
}

template <class Enum, std::size_t n>
const char* nameOf(const Named<Enum> (&table)[n], Enum value) {
  for (const Named<Enum>& entry : table)
    if (entry.value == value) return entry.name;
  throw std::logic_error("an enumerator has no name");
}

}  // namespace gvd::abi
