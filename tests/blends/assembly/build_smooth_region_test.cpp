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
  EXPECT_TRUE(region.bore.parts.empty());
}

TEST(SmoothRegion, of_a_wall_has_a_bore_that_reaches_out_of_both_ends) {
  const Assembly assembly = pipe(0.5);
  for (const Region asked : {Region::metal, Region::fluid}) {
    BuildOptions options;
    options.region = asked;
    const SmoothRegion region = smooth_region(assembly, build(assembly, options));
    EXPECT_EQ(region.region, asked);
    ASSERT_EQ(region.bore.parts.size(), 3U);  // and what goes on beyond both ends
    EXPECT_EQ(port_ring(region.bore.parts[0].shape, End::start)->radius, 1.5);
    EXPECT_EQ(region.whole.parts.size(), 1U);
  }
}

}  // namespace
}  // namespace dupin
