#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"

namespace dupin::test {

/// Bytes that a reader must refuse, and all that its error says.
struct Malformed {
  std::string bytes;
  std::string what;
};

/// With this code. `read` takes the bytes and the file's name.
template <typename Read>
void expect_refused(const Read& read, const std::string& file, const std::vector<Malformed>& table,
                    Errc code = Errc::parse_failed) {
  for (const Malformed& row : table) {
    try {
      (void)read(row.bytes, file);
      ADD_FAILURE() << "accepted, expected: " << row.what;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), code) << row.what;
      EXPECT_EQ(error.what(), row.what);
    }
  }
}

}  // namespace dupin::test
