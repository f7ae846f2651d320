#include <new>
#include <stdexcept>

#include <gtest/gtest.h>

#include "cross_check/guarded.h"

namespace dupin::cross_check {
namespace {

TEST(Guarded, turns_failures_of_algorithms_into_errors) {
  try {
    (void)guarded("'cut'", []() -> int { throw std::logic_error("x"); });
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::boolean_failed);
    EXPECT_STREQ(error.what(), "'cut' failed: x");
  }
  EXPECT_EQ(guarded("'cut'", [] { return 3; }), 3);
}

TEST(Guarded, lets_errors_and_lack_of_memory_through) {
  EXPECT_THROW((void)guarded("", []() -> int { throw std::bad_alloc(); }), std::bad_alloc);
  try {
    (void)guarded("", []() -> int { throw Error(Errc::cancelled, "stop"); });
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::cancelled);
  }
}

}  // namespace
}  // namespace dupin::cross_check
