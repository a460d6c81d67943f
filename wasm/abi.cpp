// SPDX-License-Identifier: MIT
//
// The part of the border that every module exports: memory for arguments, results, the last error.

#include "abi.h"

#include <cstdlib>

namespace gvd::abi {
namespace {

/// `ErrorCode` in `src/api/errors.ts` explains them.
constexpr Named<ErrorCode> kErrorCodes[] = {
    {"invalid-mesh", ErrorCode::kInvalidMesh},         {"invalid-gltf", ErrorCode::kInvalidGltf},
    {"invalid-point", ErrorCode::kInvalidPoint},       {"too-few-sites", ErrorCode::kTooFewSites},
    {"invalid-argument", ErrorCode::kInvalidArgument},
};

const char* lastCode = "";
std::string lastMessage;

void setError(const char* code, const char* message) {
  lastCode = code;
  try {
    lastMessage = message;
  } catch (const std::bad_alloc&) {
    lastMessage.clear();  // the code alone has to do
  }
}

}  // namespace

void clearError() { setError("", ""); }

void keepError() {
  constexpr const char* kOutOfMemory = "out-of-memory";
  constexpr const char* kInternal = "internal";
  try {
    throw;
  } catch (const Error& error) {
    setError(nameOf(kErrorCodes, error.code()), error.what());
  } catch (const std::bad_alloc&) {
    setError(kOutOfMemory, "");
  } catch (const std::length_error&) {  // more elements than an address space has bytes
    setError(kOutOfMemory, "");
  } catch (const std::exception& error) {
    setError(kInternal, error.what());
  } catch (...) {
    setError(kInternal, "something was thrown that is no exception");
  }
}

/// Takes the values over without a copy: the entry keeps their container.
template <class Values>
void Record::addValues(const char* name, Type type, Values values, std::size_t numbersPerItem) {
  auto kept = std::make_shared<const Values>(std::move(values));
  const void* data = kept->data();
  const std::size_t length = kept->size() * numbersPerItem;
  entries_.push_back({name, type, std::move(kept), data, length});
}

void Record::add(const char* name, std::vector<int> values) {
  addValues(name, Type::kInts, std::move(values));
}

void Record::add(const char* name, std::vector<double> values) {
  addValues(name, Type::kDoubles, std::move(values));
}

void Record::add(const char* name, std::vector<std::array<int, 2>> values) {
  addValues(name, Type::kInts, std::move(values), 2);
}

void Record::add(const char* name, std::vector<std::array<int, 3>> values) {
  addValues(name, Type::kInts, std::move(values), 3);
}

void Record::add(const char* name, std::vector<Eigen::Vector3d> values) {
  addValues(name, Type::kDoubles, std::move(values), 3);
}

void Record::add(const char* name, std::string utf8) {
  addValues(name, Type::kText, std::move(utf8));
}

void Record::add(const char* name, std::vector<std::string> texts) {
  addValues(name, Type::kTexts, std::string());
  for (std::string& text : texts) add(name, std::move(text));
}

void Record::add(const char* name, double number) {
  addValues(name, Type::kNumber, std::array<double, 1>{number});
}

void Record::add(const char* name, bool truth) {
  addValues(name, Type::kBoolean, std::array<double, 1>{truth ? 1. : 0.});
}

void Record::add(const char* name, Record inner) {
  for (Entry& entry : inner.entries_) entry.name.insert(0, std::string(name) + '.');
  add(std::move(inner));
}

void Record::add(Record others) { entries_.splice(entries_.end(), others.entries_); }

std::vector<Record::Row> Record::rows() const {
  std::vector<Row> rows;
  for (const Entry& entry : entries_)
    rows.push_back({{entry.name.data(), entry.name.size()},
                    entry.data,
                    static_cast<std::uint32_t>(entry.length),
                    entry.type});
  return rows;
}

/// Memory for an argument; null if there is none.
GVD_ABI void* allocate(std::size_t bytes) { return std::malloc(bytes); }
GVD_ABI void release(void* memory) { std::free(memory); }

/// The error of the last call: a code, empty if it succeeded, and a sentence.
GVD_ABI const char* errorCode() { return lastCode; }
GVD_ABI const char* errorMessage() { return lastMessage.c_str(); }

/// Works on an answer, which can be read when that is done.
GVD_ABI SliceEnd stepAnswer(Answer* answer, int budget) {
  return guarded([&] {
    if (!answer->work) return kDone;
    if (!answer->work->step(budget)) return kMoreToDo;
    answer->record = answer->work->take();
    answer->rows = answer->record.rows();
    answer->work.reset();
    return kDone;
  });
}
/// The share that is done, 0 … 1.
GVD_ABI double answerProgress(const Answer* answer) {
  return answer->work ? answer->work->progress() : 1;
}
GVD_ABI std::size_t answerRowCount(const Answer* answer) { return answer->rows.size(); }
GVD_ABI const Record::Row* answerRows(const Answer* answer) { return answer->rows.data(); }
GVD_ABI void freeAnswer(Answer* answer) { delete answer; }

}  // namespace gvd::abi
