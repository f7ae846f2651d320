#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "healing/sorted_copies.h"

namespace dupin::healing {
namespace {

std::vector<std::uint32_t> faces_of(const std::vector<Copy>& copies) {
  std::vector<std::uint32_t> faces;
  faces.reserve(copies.size());
  for (const Copy& copy : copies) {
    faces.push_back(copy.face);
  }
  return faces;
}

TEST(SortedCopies, are_side_by_side_even_ones_first) {
  const std::vector<Triangle> triangles = {{5, 3, 4}, {2, 1, 0}, {1, 2, 0}, {4, 3, 5},
                                           {0, 2, 1}, {3, 4, 5}, {2, 0, 1}};
  const std::vector<Copy> copies = sorted_copies(triangles);
  EXPECT_EQ(faces_of(copies), (std::vector{2U, 6U, 1U, 4U, 0U, 5U, 3U}));
  for (const Copy& copy : copies) {
    const bool is_of_last = copy.face == 0 || copy.face == 3 || copy.face == 5;
    EXPECT_EQ(copy.corners, is_of_last ? (Triangle{3, 4, 5}) : (Triangle{0, 1, 2}));
    EXPECT_EQ(copy.is_odd, copy.face == 1 || copy.face == 4 || copy.face == 3) << copy.face;
  }
  EXPECT_EQ(faces_of(sorted_copies(triangles, std::array{4U, 5U, 6U})), (std::vector{6U, 4U, 5U}));
}

}  // namespace
}  // namespace dupin::healing
