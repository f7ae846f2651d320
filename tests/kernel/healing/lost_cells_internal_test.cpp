#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

#include <gtest/gtest.h>

#include "healing/lost_cells.h"
#include "kernel/healing/soups_internal.h"
#include "support/shapes.h"

namespace dupin::healing {
namespace {

using Flags = std::vector<std::uint8_t>;

// Two cubes side by side, with one wall between them: the first one's.
PolygonSoup two_cubes() {
  PolygonSoup soup = merge_duplicate_points(test::joined({surface_of_cells({0, 0, 0}, {1, 1, 1}),
                                                          surface_of_cells({1, 0, 0}, {2, 1, 1})}))
                         .soup;
  std::vector<Triangle> kept(soup.triangles.begin(), soup.triangles.begin() + 12);
  std::copy_if(soup.triangles.begin() + 12, soup.triangles.end(), std::back_inserter(kept),
               [&](const Triangle& t) {
                 return std::ranges::any_of(
                     t, [&](std::uint32_t corner) { return soup.points[corner].x() == 2; });
               });
  soup.triangles = kept;
  return soup;
}

TEST(LostCells, are_all_that_faces_bound_where_there_is_no_solid) {
  const PolygonSoup soup = two_cubes();
  ASSERT_EQ(soup.triangles.size(), 22U);
  const Flags none(22, 0);
  const auto lost = find_lost_cells({soup.points, soup.triangles, none, none, {}});
  ASSERT_EQ(lost.size(), 2U);
  for (const LostCell& cell : lost) {
    EXPECT_EQ(cell.walls.size(), 12U);
    EXPECT_TRUE(cell.is_of_bodies);
  }
}

// A sheet could close it: not certainly a body.
TEST(LostCells, may_lie_beside_the_solid) {
  const PolygonSoup soup = two_cubes();
  const Flags none(22, 0);
  Flags behind = none;
  std::fill_n(behind.begin(), 12, 1);
  const auto lost = find_lost_cells({soup.points, soup.triangles, none, behind, {}});
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_FALSE(lost[0].is_of_bodies);
  for (const CellFace& wall : lost[0].walls) {
    EXPECT_EQ(wall.is_turned, wall.face < 12);
  }
  // It was none before, either, by the way its walls face.
  EXPECT_TRUE(find_lost_cells({soup.points, soup.triangles, none, behind, none}).empty());
}

}  // namespace
}  // namespace dupin::healing
