#include <gtest/gtest.h>

#include "dupin/kernel/cross_check.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

TEST(CrossCheckAbsent, says_so) {
  EXPECT_FALSE(has_cross_check());
  try {
    (void)second_opinion({}, CrossCheckEngine::nef, SetOperation::unite, {});
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::invalid_argument);
    EXPECT_STREQ(error.what(),
                 "this build has no other engines to check with; build with DUPIN_CROSS_CHECK=ON");
  }
}

}  // namespace
}  // namespace dupin
