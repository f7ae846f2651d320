#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "assembly/bore.h"
#include "assembly/districts/common_rings.h"
#include "dupin/blends/build.h"
#include "support/named_parts.h"

namespace dupin::assembly {
namespace {

using test::pipe;

// Three pipes one after the other, the second larger or thicker.
Assembly line(double wall, std::optional<double> of_second = {}) {
  Assembly result{"line.json", Unit::millimetre, 0.1, {}, {pipe("p0", {0, 0, 0}, {10, 0, 0}, 1)}};
  result.parts.push_back({"p1", PipeAlong{PortReference{"p0", End::end}, 10}});
  result.parts.push_back({"p2", PipeAlong{PortReference{"p1", End::end}, 10}});
  result.parts[1].wall = of_second;
  result.wall = wall;
  return result;
}

bool end_alike(const Assembly& assembly, std::optional<Region> region) {
  const ResolvedAssembly resolved = resolve(assembly);
  return ends_alike(resolved, {0, End::end}, distances_between(assembly, resolved, region), region);
}

TEST(CommonRings, are_where_both_parts_are_as_thick) {
  EXPECT_TRUE(end_alike(line(.1), {}));
  EXPECT_TRUE(end_alike(line(.1), Region::fluid));
  EXPECT_FALSE(end_alike(line(.1, .2), {}));
  EXPECT_FALSE(end_alike(line(.1, 0), {}));
  Assembly solid = line(.1, 0);
  EXPECT_FALSE(end_alike(solid, Region::metal));
  solid.parts[0].wall = 0;
  EXPECT_TRUE(end_alike(solid, Region::metal));
  EXPECT_FALSE(end_alike(solid, Region::fluid)) << "there is nothing";
  solid.wall.reset();
  solid.parts[0].wall.reset();
  solid.parts[1].wall.reset();
  EXPECT_TRUE(end_alike(solid, {}));
}

TEST(CommonRings, are_where_both_parts_are_insulated_alike) {
  Assembly assembly = line(.1, .2);
  EXPECT_FALSE(end_alike(assembly, Region::insulation)) << "there is nothing";
  assembly.insulation = .5;
  EXPECT_TRUE(end_alike(assembly, Region::insulation));
  assembly.parts[1].insulation = .25;
  EXPECT_FALSE(end_alike(assembly, Region::insulation));
}

TEST(CommonRings, have_samplings_of_both_surfaces) {
  Assembly assembly = line(.1, 0);
  const auto common = [&](std::optional<Region> region) {
    const ResolvedAssembly resolved = resolve(assembly);
    return common_rings(district(assembly, resolved, districts_of_parts(resolved, .1).at(0)),
                        region);
  };
  const PieceOf of_walls = common({});
  EXPECT_EQ(of_walls.tolerance, .1 / 4);
  ASSERT_EQ(of_walls.samplings.size(), 3);
  ASSERT_EQ(of_walls.second_samplings.size(), 3);
  EXPECT_GT(of_walls.samplings[1].segments, 6);
  EXPECT_GT(of_walls.second_samplings[0].segments, 6);
  EXPECT_EQ(of_walls.second_samplings[1].segments, 0);
  EXPECT_TRUE(of_walls.discs.empty());
  assembly.insulation = .5;
  const PieceOf of_insulation = common(Region::insulation);
  EXPECT_EQ(of_insulation.tolerance, .1);
  EXPECT_GT(of_insulation.second_samplings[1].segments, of_insulation.samplings[1].segments);
}

TEST(CommonRings, go_on_with_the_sampling_of_what_goes_on) {
  const Assembly assembly = line(.1);
  const ResolvedAssembly outer = reaching_out(resolve(assembly), assembly, 1);
  ASSERT_EQ(outer.parts.size(), 5);
  const std::vector<RingSampling> all =
      with_what_goes_on({{7, 0, .5}, {8, 0, .5}, {9, 0, .5}}, outer);
  ASSERT_EQ(all.size(), 5);
  EXPECT_EQ(all[3].segments, 7);
  EXPECT_EQ(all[4].segments, 9);
}

TEST(CommonRings, do_not_reach_out_where_ends_are_kept) {
  const Assembly assembly = line(.1);
  const ResolvedAssembly outer = resolve(assembly);
  EXPECT_EQ(reaching_out(outer, assembly, 1, {"p0.start"}).parts.size(), 4);
}

}  // namespace
}  // namespace dupin::assembly
