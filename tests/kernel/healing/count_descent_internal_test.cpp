#include <gtest/gtest.h>

#include "healing/count_descent.h"

namespace dupin::healing {
namespace {

// A tetrahedron: a closed surface counts each triangle once, this way or the other.
const std::vector<Triangle> kTriangles = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};

std::vector<int> descended(const std::vector<CountRange>& ranges) {
  const mesh::EdgeTable edges(kTriangles, 4);
  return descended_counts(edges, ranges);
}

TEST(CountDescent, turns_what_was_turned_and_drops_what_was_copied) {
  const std::vector<int> closed{1, -1, 1, -1};
  EXPECT_EQ(descended({{1, 1, 1}, {-1, 1, 1}, {1, 1, 1}, {-1, 1, 1}}), closed);
  EXPECT_EQ(descended({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {-1, 1, 1}}), closed);
  EXPECT_EQ(descended({{1, 1, 1}, {-1, 1, 1}, {3, 0, 3}, {-1, 1, 1}}), closed);
  EXPECT_EQ(descended({{0, 0, 2}, {-1, 1, 1}, {1, 1, 1}, {-1, 1, 1}}), closed);
}

TEST(CountDescent, keeps_to_the_ranges) {
  for (const int count : descended({{2, 2, 2}, {-1, 1, 1}, {1, 1, 1}, {-1, 1, 1}})) {
    EXPECT_NE(count, 0);
  }
  EXPECT_EQ(std::abs(descended({{2, 2, 2}, {-1, 1, 1}, {1, 1, 1}, {-1, 1, 1}})[0]), 2);
}

}  // namespace
}  // namespace dupin::healing
