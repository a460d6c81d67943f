// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "gvd/error.h"

namespace gvd::checks {

/// The message of the error that a call throws; fails the test if it throws none of this code.
template <class Call>
std::string errorOf(Call call, ErrorCode code) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return "";
}

}  // namespace gvd::checks
