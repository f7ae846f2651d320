#pragma once

#include <gtest/gtest.h>

#include "dupin/kernel/check.h"

namespace dupin::test {

/// The same counts and measures; of findings only how many.
inline void expect_same_report(const Report& x, const Report& y) {
  EXPECT_EQ(x.points, y.points);
  EXPECT_EQ(x.triangles, y.triangles);
  EXPECT_EQ(x.counts, y.counts);
  EXPECT_EQ(x.findings.size(), y.findings.size());
  EXPECT_EQ(x.shells, y.shells);
  EXPECT_EQ(x.components, y.components);
  EXPECT_EQ(x.euler_number, y.euler_number);
  EXPECT_EQ(x.genus, y.genus);
  EXPECT_EQ(x.volume, y.volume);
  EXPECT_EQ(x.area, y.area);
}

}  // namespace dupin::test
