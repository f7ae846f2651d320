#pragma once

#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"

namespace dupin::test {

/// What the error says that `action` throws, which has this code if one is given; "no error" if it
/// throws none.
std::string message_of(const auto& action, std::optional<Errc> code = {}) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code.value_or(error.code())) << error.what();
    return error.what();
  }
  return "no error";
}

}  // namespace dupin::test
