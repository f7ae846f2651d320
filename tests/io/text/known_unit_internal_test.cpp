#include <gtest/gtest.h>

#include "text/known_unit.h"

namespace dupin::text {
namespace {

TEST(KnownUnit, lengths_in_metres_of_units_and_of_nothing_else) {
  EXPECT_EQ(metres_in("mm"), 0.001);
  EXPECT_EQ(metres_in("um"), 1e-6);
  EXPECT_EQ(metres_in("ft"), 0.3048);
  EXPECT_EQ(metres_in(""), std::nullopt);
  EXPECT_EQ(metres_in("MM"), std::nullopt);
  EXPECT_EQ(metres_in("mmm"), std::nullopt);
  EXPECT_EQ(metres_in("kelvin"), std::nullopt);
}

}  // namespace
}  // namespace dupin::text
