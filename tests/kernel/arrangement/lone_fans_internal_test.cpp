#include <algorithm>

#include <gtest/gtest.h>

#include "arrangement/lone_fans.h"
#include "kernel/arrangement/stages_internal.h"

namespace dupin::arrangement {
namespace {

using test::cube;

std::ptrdiff_t special_points(test::Stages& stages, const std::vector<std::uint8_t>& crossing) {
  stages.input.crossing = crossing;
  mark_all_but_lone_fans(stages.input);
  return std::ranges::count(stages.input.special, 1);
}

TEST(LoneFans, leave_points_of_a_solid_as_they_are) {
  test::Stages stages({cube(0, 0, 0)});
  EXPECT_EQ(special_points(stages, std::vector<std::uint8_t>(12, 0)), 0);
}

TEST(LoneFans, are_none_at_triangles_that_may_cross_others) {
  test::Stages stages({cube(0, 0, 0)});
  std::vector<std::uint8_t> crossing(12, 0);
  crossing[5] = 1;
  EXPECT_EQ(special_points(stages, crossing), 3);
  for (const PointId corner : stages.input.triangles[5]) {
    EXPECT_EQ(stages.input.special[corner], 1);
  }
}

TEST(LoneFans, are_none_where_surfaces_touch) {
  // Points of two fans, and edges of four triangles: as in a soup whose equal points are one.
  const struct {
    const char* description;
    TriMesh other;
    std::ptrdiff_t special;
  } table[] = {{"in a point", cube(2, 2, 2), 1}, {"along an edge", cube(2, 2, 0), 2}};
  for (const auto& [description, other, special] : table) {
    SCOPED_TRACE(description);
    test::Stages stages({cube(0, 0, 0), other});
    std::fill(stages.input.special.begin(), stages.input.special.end(), std::uint8_t{0});
    // And their copies, which no triangle has any more.
    EXPECT_EQ(special_points(stages, std::vector<std::uint8_t>(24, 0)), 2 * special);
  }
}

TEST(LoneFans, are_none_at_a_border) {
  test::Stages stages({cube(0, 0, 0)});
  const Triangle open = stages.input.triangles[11];
  stages.input.triangles.resize(11);
  EXPECT_EQ(special_points(stages, std::vector<std::uint8_t>(11, 0)), 3);
  for (const PointId corner : open) {
    EXPECT_EQ(stages.input.special[corner], 1);
  }
}

}  // namespace
}  // namespace dupin::arrangement
