#include <array>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "healing/shell_enclosure.h"
#include "kernel/healing/soups_internal.h"
#include "support/shapes.h"

namespace dupin::healing {
namespace {

using test::box;
using test::joined;

std::vector<int> depths(const ShellEnclosure& enclosure, std::size_t shells) {
  std::vector<int> depths;
  for (std::size_t shell = 0; shell < shells; ++shell) {
    depths.push_back(static_cast<int>(enclosure.around(shell).size()));
  }
  return depths;
}

// The second shell about the first, and the other way round.
std::vector<int> depths(const TriMesh& first, const TriMesh& second) {
  const PolygonSoup soup = soup_of(joined({first, second}));
  std::vector<std::uint32_t> lowest(soup.triangles.size(), 0);
  for (std::size_t face = first.triangles.size(); face < lowest.size(); ++face) {
    lowest[face] = static_cast<std::uint32_t>(first.triangles.size());
  }
  const PolygonSoup merged = merge_duplicate_points({soup.points, soup.triangles, {}, {}}).soup;
  return depths(ShellEnclosure(merged, mesh::grouped(lowest), std::array{1, 1}), 2);
}

const TriMesh kOuter = box({0, 0, 0}, {8, 8, 8});

TEST(ShellEnclosure, boxes_within_may_touch_the_outer_one) {
  EXPECT_EQ(depths(kOuter, box({1, 1, 1}, {2, 2, 2})), (std::vector{0, 1}));
  EXPECT_EQ(depths(kOuter, box({0, 1, 1}, {2, 2, 2})), (std::vector{0, 1}));
  EXPECT_EQ(depths(box({0, 0, 0}, {2, 2, 2}), kOuter), (std::vector{1, 0}));
}

TEST(ShellEnclosure, what_crosses_or_coincides_is_not_within) {
  EXPECT_EQ(depths(kOuter, kOuter), (std::vector{0, 0}));
  EXPECT_EQ(depths(kOuter, test::cut_otherwise(kOuter)), (std::vector{0, 0}));
  EXPECT_EQ(depths(kOuter, box({7, 7, 7}, {9, 9, 9})), (std::vector{0, 0}));
  // In its box, but for a corner outside of it.
  const TriMesh outer = test::tetrahedron({0, 0, 0}, 8);
  EXPECT_EQ(depths(outer, box({1, 1, 1}, {3, 3, 3})), (std::vector{0, 0}));
  EXPECT_EQ(depths(outer, box({1, 1, 1}, {2, 2, 2})), (std::vector{0, 1}));
}

// A bar through an edge of the notch of the outer one, which has edges there, too.
TEST(ShellEnclosure, what_crosses_at_edges_is_not_within) {
  std::set<Cell> notched = cells_of_box({0, 0, 0}, {3, 3, 1});
  notched.erase({2, 2, 0});
  const TriMesh outer = surface_of_cells(notched);
  EXPECT_EQ(depths(outer, surface_of_cells({0, 2, 0}, {2, 3, 1})), (std::vector{0, 1}));
  EXPECT_EQ(depths(outer, surface_of_cells({0, 2, 0}, {3, 3, 1})), (std::vector{0, 0}));
  EXPECT_EQ(depths(outer, surface_of_cells({2, 0, 0}, {3, 3, 1})), (std::vector{0, 0}));
}

// Each counts, whichever way it turns.
TEST(ShellEnclosure, copies_are_around_what_one_of_them_is_around) {
  const TriMesh inner = box({1, 1, 1}, {2, 2, 2}), crossing = box({7, 7, 7}, {9, 9, 9});
  const PolygonSoup soup =
      soup_of(joined({kOuter, inner, test::reversed(kOuter), kOuter, test::reversed(inner), inner,
                      crossing, test::reversed(crossing)}));
  std::vector<std::uint32_t> lowest;
  for (std::uint32_t face = 0; face < soup.triangles.size(); ++face) {
    lowest.push_back(face - face % 12);
  }
  const PolygonSoup merged = merge_duplicate_points({soup.points, soup.triangles, {}, {}}).soup;
  const ShellEnclosure enclosure(merged, mesh::grouped(lowest),
                                 std::array{1, 1, -1, 1, -1, 1, 1, -1});
  EXPECT_EQ(depths(enclosure, 8), (std::vector{0, 3, 0, 0, 3, 3, 0, 0}));
  for (const std::size_t shell : {1, 4, 5}) {
    const auto around = enclosure.around(shell);
    EXPECT_EQ(std::vector(around.begin(), around.end()), (std::vector{0U, 2U, 3U}));
  }
}

TEST(ShellEnclosure, shells_may_share_faces) {
  TriMesh inner = test::tetrahedron({0, 0, 0}, 8);
  inner.points[3] = {0, 0, 1};
  EXPECT_EQ(depths(test::tetrahedron({0, 0, 0}, 8), inner), (std::vector{0, 1}));
}

}  // namespace
}  // namespace dupin::healing
