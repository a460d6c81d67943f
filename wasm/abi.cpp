// SPDX-License-Identifier: MIT
//
// The part of the border that every module exports: memory for arguments, results, the last error.

#include "abi.h"

#include <cstdlib>

namespace gvd::abi {
namespace {

/// `errorCodes` in `src/errors.ts` explains them.
constexpr Named<ErrorCode> kErrorCodes[] = {
    {"invalid-mesh", ErrorCode::kInvalidMesh},
    {"invalid-gltf", ErrorCode::kInvalidGltf},
    {"invalid-point", ErrorCode::kInvalidPoint},
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

void Record::add(const char* name, std::vector<int> values) {
  entries_.push_back({name, Type::kInts, std::move(values)});
}

void Record::add(const char* name, std::vector<double> values) {
  entries_.push_back({name, Type::kDoubles, std::move(values)});
}

void Record::add(const char* name, std::string utf8) {
  entries_.push_back({name, Type::kText, std::move(utf8)});
}

void Record::add(const char* name, std::vector<std::string> texts) {
  entries_.push_back({name, Type::kTexts, std::string()});
  for (std::string& text : texts) entries_.push_back({name, Type::kText, std::move(text)});
}

void Record::add(const char* name, double number) {
  entries_.push_back({name, Type::kNumber, std::vector<double>{number}});
}

void Record::add(const char* name, bool truth) {
  entries_.push_back({name, Type::kBoolean, std::vector<double>{truth ? 1. : 0.}});
}

void Record::add(const char* name, Record inner) {
  for (Entry& entry : inner.entries_) entry.name.insert(0, std::string(name) + '.');
  add(std::move(inner));
}

void Record::add(Record others) { entries_.splice(entries_.end(), others.entries_); }

std::vector<Record::Row> Record::rows() const {
  std::vector<Row> rows;
  for (const auto& [name, type, values] : entries_) {
    std::visit(
        [&, &name = name, type = type](const auto& all) {
          rows.push_back({{name.data(), name.size()},
                          all.data(),
                          static_cast<std::uint32_t>(all.size()),
                          type});
        },
        values);
  }
  return rows;
}

/// Memory for an argument; null if there is none.
GVD_ABI void* allocate(std::size_t bytes) { return std::malloc(bytes); }
GVD_ABI void release(void* memory) { std::free(memory); }

/// Of the last call: a code, empty if it succeeded, and a sentence.
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
