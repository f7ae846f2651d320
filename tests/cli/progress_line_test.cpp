#include "progress_line.h"

#include <gtest/gtest.h>

namespace dupin::cli {
namespace {

// Tests have no terminal for their standard error; with one, only the quiet line would be silent.
TEST(ProgressLine, is_silent_when_quiet) {
  testing::internal::CaptureStderr();
  {
    ProgressLine line(true);
    EXPECT_FALSE(line.callback());
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ProgressLine, is_silent_where_standard_error_is_a_file) {
  testing::internal::CaptureStderr();  // into a file
  {
    ProgressLine line(false);
    EXPECT_FALSE(line.callback());
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace dupin::cli
