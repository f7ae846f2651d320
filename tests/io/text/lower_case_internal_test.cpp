#include <gtest/gtest.h>

#include "text/lower_case.h"

namespace dupin::text {
namespace {

TEST(LowerCase, changes_ascii_letters_only) {
  EXPECT_EQ(lower_case("aZ.StL_[@\xC4"), "az.stl_[@\xC4");
  EXPECT_EQ(lower_case(""), "");
}

}  // namespace
}  // namespace dupin::text
