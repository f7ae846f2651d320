#pragma once

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"

namespace dupin::test {

/// In all that does not depend on the triangulation.
inline void expect_same_solid(const Solid& x, const Solid& y) {
  EXPECT_EQ(x.exact_volume(), y.exact_volume());
  EXPECT_EQ(x.components(), y.components());
  EXPECT_EQ(x.genus(), y.genus());
  EXPECT_EQ(x.contacts().empty(), y.contacts().empty());
  EXPECT_TRUE(subtract(x, {&y, 1}).empty());
  EXPECT_TRUE(subtract(y, {&x, 1}).empty());
}

}  // namespace dupin::test
