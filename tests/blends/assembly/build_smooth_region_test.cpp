#include <gtest/gtest.h>

#include "dupin/blends/build.h"

namespace dupin {
namespace {

Assembly pipe(std::optional<double> wall) {
  Assembly assembly;
  assembly.wall = wall;
  assembly.parts.push_back({"a", PipeBetween{{0, 0, 0}, {0, 0, 10}, 2}});
  return assembly;
}

TEST(SmoothRegion, of_what_has_no_walls_is_the_whole) {
  const Assembly assembly = pipe({});
  const SmoothRegion region = smooth_region(assembly, build(assembly));
  EXPECT_EQ(region.region, Region::outer);
  EXPECT_EQ(region.whole.parts.size(), 1U);
  EXPECT_TRUE(region.inside.parts.empty());
}

TEST(SmoothRegion, of_a_wall_has_a_bore_that_reaches_out_of_both_ends) {
  const Assembly assembly = pipe(0.5);
  for (const Region asked : {Region::metal, Region::fluid}) {
    BuildOptions options;
    options.region = asked;
    const SmoothRegion region = smooth_region(assembly, build(assembly, options));
    EXPECT_EQ(region.region, asked);
    ASSERT_EQ(region.inside.parts.size(), 3U);  // and what goes on beyond both ends
    EXPECT_EQ(port_ring(region.inside.parts[0].shape, End::start)->radius, 1.5);
    EXPECT_EQ(region.whole.parts.size(), 1U);
  }
}

TEST(SmoothRegion, of_insulation_has_pipes_inside_that_hardly_reach_out) {
  Assembly assembly = pipe(0.5);
  assembly.insulation = 3;
  BuildOptions options;
  options.region = Region::insulation;
  const Built built = build(assembly, options);
  const SmoothRegion region = smooth_region(assembly, built);
  ASSERT_EQ(region.whole.parts.size(), 1U);
  EXPECT_EQ(port_ring(region.whole.parts[0].shape, End::start)->radius, 5);
  ASSERT_EQ(region.inside.parts.size(), 3U);
  EXPECT_EQ(port_ring(region.inside.parts[0].shape, End::start)->radius, 2);
  const Ring* const out = port_ring(region.inside.parts[1].shape, End::end);
  const double reach = std::max(-out->center.z(), out->center.z() - 10);
  EXPECT_GT(reach, 0);
  EXPECT_LE(reach, mesh_error(built) / 10);
}

}  // namespace
}  // namespace dupin
