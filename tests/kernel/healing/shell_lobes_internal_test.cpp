#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "healing/shell_lobes.h"
#include "support/sequences.h"
#include "support/shapes.h"

namespace dupin::healing {
namespace {

using test::box;
using test::joined;
using test::reversed;

// Two boxes with one edge in common.
std::vector<std::uint32_t> lobes(const TriMesh& first, const TriMesh& second, int sign) {
  const PolygonSoup soup = merge_duplicate_points(joined({first, second})).soup;
  return lobe_faces(soup, support::numbers_below(soup.triangles.size()), sign);
}

TEST(ShellLobes, are_what_is_wound_around_the_other_way) {
  const TriMesh large = box({0, 0, 0}, {2, 2, 1}), small = box({2, 2, 0}, {3, 3, 1});
  EXPECT_TRUE(lobes(large, small, 1).empty());
  EXPECT_TRUE(lobes(reversed(large), reversed(small), -1).empty());
  EXPECT_EQ(lobes(large, reversed(small), 1).size(), 12);
  EXPECT_EQ(lobes(reversed(large), small, -1).size(), 12);
  for (const std::uint32_t face : lobes(large, reversed(small), 1)) {
    EXPECT_GE(face, 12);
  }
}

TEST(ShellLobes, are_none_where_faces_would_have_to_be_cut) {
  EXPECT_TRUE(lobes(box({0, 0, 0}, {2, 2, 2}), reversed(box({1, 1, 1}, {3, 3, 3})), 1).empty());
}

}  // namespace
}  // namespace dupin::healing
