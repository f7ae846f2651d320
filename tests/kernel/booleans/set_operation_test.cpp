#include "dupin/kernel/set_operation.h"

#include <gtest/gtest.h>

namespace dupin {
namespace {

// Reports and messages have these words.
TEST(SetOperation, has_the_name_of_the_command) {
  EXPECT_EQ(name(SetOperation::unite), "unite");
  EXPECT_EQ(name(SetOperation::intersect), "intersect");
  EXPECT_EQ(name(SetOperation::subtract), "subtract");
}

}  // namespace
}  // namespace dupin
