#include <gtest/gtest.h>

#include "healing/patch_counts.h"

namespace dupin::healing {
namespace {

using Counts = std::vector<int>;

// Two tetrahedra over and under the face 0 1 2, the first triangle.
const std::vector<Vec3> kPoints = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
const std::vector<Triangle> kTriangles = {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3},
                                          {0, 1, 4}, {1, 2, 4}, {0, 2, 4}};

// How often each triangle is there, the other way round if negative; and once more that way.
Counts counts(const Counts& given, std::size_t both = 99) {
  std::vector<CopyNumbers> numbers;
  for (const int n : given) {
    numbers.push_back(n > 0 ? CopyNumbers{n, 0} : CopyNumbers{0, -n});
  }
  if (both < numbers.size()) {
    numbers[both] = {1, 1};
  }
  return closing_counts(kPoints, kTriangles, numbers);
}

TEST(PatchCounts, a_wall_goes_where_both_sides_agree) {
  EXPECT_EQ(counts({1, 1, 1, -1, -1, -1, 1}, 0), (Counts{0, 1, 1, -1, -1, -1, 1}));
}

TEST(PatchCounts, a_wall_of_which_one_side_was_turned_goes_too) {
  EXPECT_EQ(counts({2, 1, 1, -1, -1, -1, 1}), (Counts{0, 1, 1, -1, -1, -1, 1}));
}

TEST(PatchCounts, copies_stay_where_the_sheets_beside_need_them) {
  EXPECT_EQ(counts({-2, 1, 1, -1, 1, 1, -1}), (Counts{-2, 1, 1, -1, 1, 1, -1}));
}

TEST(PatchCounts, what_is_there_twice_counts_once) {
  EXPECT_EQ(counts({-4, 2, 2, -2, 2, 2, -2}), (Counts{-2, 1, 1, -1, 1, 1, -1}));
}

TEST(PatchCounts, a_turned_triangle_follows_its_patch) {
  EXPECT_EQ(counts({-2, 1, -1, -1, 1, 1, -1}), (Counts{-2, 1, 1, -1, 1, 1, -1}));
}

}  // namespace
}  // namespace dupin::healing
