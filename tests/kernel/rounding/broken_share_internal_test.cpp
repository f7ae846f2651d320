#include <gtest/gtest.h>

#include "rounding/broken_share.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

TEST(BrokenShare, is_of_needles_where_many_triangles_have_two_corners_in_one_place) {
  const TriMesh tube = test::tube(1, 0, 1, 512);
  EXPECT_FALSE(is_full_of_needles(tube.points, tube.triangles));
  std::vector<Vec3> rounded = tube.points;
  for (Vec3& p : rounded) {
    p = (p * 64).array().round() / 64;
  }
  EXPECT_TRUE(is_full_of_needles(rounded, tube.triangles));
}

TEST(BrokenShare, is_of_crossings_where_they_are_many_and_edges_long) {
  const TriMesh tube = test::tube(1, 0, 1, 512);
  std::vector<Fault> faults;
  for (std::uint32_t f = 0; f < kManyFaults; ++f) {
    faults.push_back({f, f + 512});
  }
  const FaultySurface surface{tube.points, tube.triangles, faults};
  EXPECT_TRUE(is_full_of_crossings(surface, 0x1p-10));
  EXPECT_FALSE(is_full_of_crossings(surface, 0x1p-5)) << "the edges are shorter";
  EXPECT_FALSE(is_full_of_crossings(
      {tube.points, tube.triangles, std::span(faults).first(kManyFaults - 1)}, 0x1p-10));
  const TriMesh large = test::tube(1, 0, 1, 8192);
  EXPECT_FALSE(is_full_of_crossings({large.points, large.triangles, faults}, 0x1p-20));
}

}  // namespace
}  // namespace dupin::rounding
