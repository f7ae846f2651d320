#include <gtest/gtest.h>

#include "drawing/linked_lines.h"

namespace dupin::drawing {
namespace {

using Line = std::vector<Vec3>;

Vec3 at(double x) { return {x, 0, 0}; }

TEST(LinkedLines, go_on_either_way) {
  const auto lines =
      linked({{at(1), at(2)}, {at(3), at(2)}, {at(0), at(1)}, {at(3), at(4), at(5)}});
  ASSERT_EQ(lines.size(), 1);
  Line line = lines[0];
  if (line[0] != at(0)) {
    line = Line(line.rbegin(), line.rend());
  }
  EXPECT_EQ(line, (Line{at(0), at(1), at(2), at(3), at(4), at(5)}));
}

TEST(LinkedLines, close) {
  const auto lines = linked({{at(0), at(1)}, {at(2), at(0)}, {at(1), at(2)}});
  ASSERT_EQ(lines.size(), 1);
  EXPECT_EQ(lines[0].size(), 4);
  EXPECT_EQ(lines[0].front(), lines[0].back());
}

TEST(LinkedLines, end_where_three_meet) {
  EXPECT_EQ(linked({{at(0), at(1)}, {at(0), at(2)}, {at(0), at(3)}}).size(), 3);
}

TEST(LinkedLines, may_be_closed_from_the_start) {
  const auto lines = linked({{at(0), at(1), at(2), at(0)}, {at(5), at(6)}});
  ASSERT_EQ(lines.size(), 2);
  EXPECT_EQ(lines[0].size(), 4);
}

}  // namespace
}  // namespace dupin::drawing
