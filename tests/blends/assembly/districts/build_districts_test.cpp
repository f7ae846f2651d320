#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/build.h"
#include "dupin/kernel/error.h"
#include "support/message_of.h"
#include "support/named_parts.h"

namespace dupin {
namespace {

using test::pipe;
using testing::ElementsAre;
using testing::HasSubstr;

// Crosses of two pipes, so many, each apart from the next.
Assembly crosses(int count) {
  Assembly assembly{"", Unit::millimetre, 0.02, {}, {}};
  for (int i = 0; i < count; ++i) {
    const double y = 10 * i;
    assembly.parts.push_back(
        pipe("run" + std::to_string(i), {-5, y, 0}, {5, y, 0}, 1 + .125 * (i % 3)));
  }
  for (int i = 0; i < count; ++i) {
    const double y = 10 * i;
    assembly.parts.push_back(pipe("branch" + std::to_string(i), {0, y, 0}, {0, y, 4}, .5));
  }
  return assembly;
}

TEST(BuildDistricts, each_is_built_as_if_there_were_no_others) {
  const Built built = build(crosses(3));
  ASSERT_EQ(built.districts.size(), 3);
  EXPECT_EQ(built.solid.components(), 3);
  mpq_class volume = 0;
  for (const Solid& district : built.districts) {
    volume += district.exact_volume();
  }
  EXPECT_EQ(built.solid.exact_volume(), volume);
  const Built alone = build(crosses(1));
  EXPECT_EQ(alone.solid.exact_volume(), built.districts[0].exact_volume());
  EXPECT_EQ(alone.solid.triangles(), built.districts[0].triangles());
}

TEST(BuildDistricts, reports_are_in_document_order) {
  const Built built = build(crosses(2));
  std::vector<std::string> names;
  for (const PartReport& part : built.parts) {
    names.push_back(part.name);
  }
  EXPECT_THAT(names, ElementsAre("run0", "run1", "branch0", "branch1"));
  EXPECT_EQ(built.parts[2].index, 2);
  EXPECT_EQ(built.runs, 4);
  EXPECT_EQ(built.ports.size(), 8);
}

TEST(BuildDistricts, regions_are_those_of_the_whole_document) {
  Assembly assembly = crosses(2);
  assembly.parts[1].wall = .25;
  assembly.parts[3].wall = .25;
  const Built metal = build(assembly);
  EXPECT_EQ(metal.region, Region::metal);
  ASSERT_TRUE(metal.volumes);
  EXPECT_NEAR(metal.volumes->metal + metal.volumes->fluid, metal.volumes->outer, 1e-9);
  EXPECT_EQ(metal.districts[0].exact_volume(),
            build(crosses(1)).solid.exact_volume());  // without a wall, it is all metal
  EXPECT_LT(metal.districts[1].volume(), .7 * metal.districts[0].volume());
  const Built fluid = build(assembly, {.region = Region::fluid});
  EXPECT_TRUE(fluid.districts[0].empty());
  EXPECT_EQ(fluid.solid.exact_volume(), fluid.districts[1].exact_volume());
  assembly.parts[0].insulation = 1;
  const Built insulation = build(assembly, {.region = Region::insulation});
  EXPECT_GT(insulation.districts[0].volume(), 0);
  EXPECT_TRUE(insulation.districts[1].empty());
}

TEST(BuildDistricts, patches_are_known_in_all_of_them) {
  Assembly assembly = crosses(2);
  assembly.patches = {{"run1.start", "inlet"}};
  const Built built = build(assembly);
  EXPECT_EQ(std::ranges::count(built.solid.names(), "inlet"), 1);
  assembly.patches = {{"run2.start", "inlet"}};
  EXPECT_THROW((void)build(assembly), Error);
}

// Of many, each district has those of its own parts and caps: looking through all for each would
// take time, and what is kept of a district would be made again for the names of others.
TEST(BuildDistricts, patches_of_others_are_not_in_them) {
  Assembly assembly = crosses(12);
  assembly.parts.push_back({"lid", CapAt{{"run1", End::start}}});
  assembly.patches = {{"lid", "inlet"},       {"run1.end", "outlet"}, {"run10", "hull"},
                      {"run10.start", "low"}, {"run11.end", "high"},  {"branch1.end", "top"}};
  const DistrictBuild plan(assembly, {});
  const auto patches = [&](std::size_t district) { return plan.document(district).patches; };
  EXPECT_THAT(patches(0), testing::IsEmpty());
  EXPECT_THAT(patches(1), ElementsAre(std::pair("branch1.end", "top"), std::pair("lid", "inlet"),
                                      std::pair("run1.end", "outlet")));
  EXPECT_THAT(patches(10),
              ElementsAre(std::pair("run10", "hull"), std::pair("run10.start", "low")));
  const Solid solid = build(assembly).solid;
  const std::set<std::string> names(solid.names().begin(), solid.names().end());
  for (const auto& [patch, name] : assembly.patches) {
    EXPECT_TRUE(names.contains(name)) << name;
    EXPECT_FALSE(names.contains(patch)) << patch;
  }
}

// Branches as thick as their run, whose inner ends touch its surface.
TEST(BuildDistricts, ends_that_are_called_as_their_part_are_none) {
  Assembly assembly = crosses(2);
  assembly.wall = .25;
  assembly.parts[0].shape = PipeBetween{{-5, .3, .1}, {5, -.2, .1}, 1, {}};
  for (const std::size_t i : {2, 3}) {
    auto& branch = std::get<PipeBetween>(assembly.parts[i].shape);
    branch.radius = std::get<PipeBetween>(assembly.parts[i - 2].shape).radius;
    assembly.patches[assembly.parts[i].name + ".start"] = assembly.parts[i].name;
  }
  EXPECT_EQ(build(assembly).ports.size(), 6);
  for (const Region region : {Region::outer, Region::metal, Region::fluid}) {
    const Built built = build(assembly, {.region = region});
    for (const std::uint32_t label : built.solid.labels()) {
      EXPECT_FALSE(built.solid.names()[label].starts_with("branch") &&
                   built.solid.names()[label].ends_with(".start"));
    }
  }
  const Assembly other = DistrictBuild(assembly, {}).document(1);
  EXPECT_EQ(other.patches.size(), 1);
  EXPECT_EQ(build(other).solid.components(), 1);
}

TEST(BuildDistricts, the_limit_is_that_of_all_triangles) {
  const Built built = build(crosses(4));
  std::size_t triangles = 0;
  for (const PartReport& part : built.parts) {
    triangles += part.triangles;
  }
  BuildOptions options;
  options.most_triangles = triangles / 3;
  try {
    (void)build(crosses(4), options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
  }
  EXPECT_NO_THROW((void)build(crosses(1), options));
  options.most_triangles = 0;
  try {
    (void)build(crosses(1), options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::invalid_argument);
  }
}

TEST(BuildDistricts, errors_name_the_place_in_the_whole_document) {
  Assembly assembly = crosses(2);
  assembly.source = "plant.json";
  assembly.parts[3].wall = 2;
  try {
    (void)build(assembly);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.part(), "branch1");
    EXPECT_THAT(error.where(), HasSubstr("plant.json#/parts/3"));
  }
}

TEST(BuildDistricts, built_one_by_one_are_the_same) {
  const Assembly assembly = crosses(5);
  const DistrictBuild plan(assembly);
  ASSERT_EQ(plan.size(), 5);
  std::vector<Built> built;
  double expected = 0;
  for (std::size_t i = plan.size(); i-- > 0;) {
    built.insert(built.begin(), plan.build(i));
    expected += plan.expected_triangles(i);
  }
  const Built all = plan.joined(std::move(built)), whole = build(assembly);
  EXPECT_EQ(all.solid.triangles(), whole.solid.triangles());
  EXPECT_EQ(all.solid.nearest_points(), whole.solid.nearest_points());
  // With those where parts cross.
  const auto triangles = double(whole.solid.triangles().size());
  EXPECT_GT(expected, .8 * triangles);
  EXPECT_LT(expected, 2 * triangles);
}

std::vector<std::string> names_of(const Assembly& assembly) {
  std::vector<std::string> names;
  for (const Part& part : assembly.parts) {
    names.push_back(part.name);
  }
  return names;
}

TEST(BuildDistricts, the_document_of_one_has_all_that_decides_about_it) {
  Assembly assembly = crosses(2);
  assembly.parts.push_back({"inlet", CapAt{{"run1", End::start}}});
  assembly.parts.push_back(pipe("a", {0, 0, 50}, {5, 0, 50}, 1));
  assembly.parts.push_back(pipe("b", {20, 0, 50}, {25, 0, 50}, 1));
  SplineBetween hose;
  hose.from = {"a", End::end};
  hose.to = {"b", End::start};
  hose.avoid.emplace();
  hose.avoid->obstacles.push_back(std::string("run1"));
  assembly.parts.push_back({"hose", hose});
  const DistrictBuild plan(assembly);
  ASSERT_EQ(plan.size(), 3);
  EXPECT_THAT(plan.parts(1), ElementsAre(1, 3));
  EXPECT_THAT(names_of(plan.document(0)), ElementsAre("run0", "branch0"));
  EXPECT_THAT(names_of(plan.document(1)), ElementsAre("run1", "branch1", "inlet"));
  EXPECT_THAT(names_of(plan.document(2)), ElementsAre("run1", "inlet", "a", "b", "hose"));
}

TEST(BuildDistricts, one_that_is_cancelled_is_not_built) {
  BuildOptions options;
  options.progress = [](std::string_view stage, double) { return stage != "build"; };
  EXPECT_THROW((void)build(crosses(2), options), Error);
}

TEST(BuildDistricts, have_margins_that_are_finite_and_not_negative) {
  for (const double bad : {-1e-3, -1000.0, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    BuildOptions absolute, relative;
    absolute.margin = bad;
    relative.relative_margin = bad;
    for (const BuildOptions& options : {absolute, relative}) {
      const std::string message =
          test::message_of([&] { (void)build(crosses(2), options); }, Errc::invalid_argument);
      EXPECT_THAT(message, HasSubstr("a margin that is finite and not negative"));
      EXPECT_EQ(test::message_of([&] { (void)DistrictBuild(crosses(2), options); }), message);
    }
  }
}

TEST(BuildDistricts, are_asked_for_by_their_numbers) {
  const DistrictBuild plan(crosses(2));
  for (const auto& ask : std::vector<std::function<void()>>{
           [&] { (void)plan.build(2); }, [&] { (void)plan.parts(2); },
           [&] { (void)plan.document(2); }, [&] { (void)plan.expected_triangles(2); },
           [&] { (void)plan.taken_from_whole(2); }}) {
    EXPECT_EQ(test::message_of(ask, Errc::invalid_argument),
              "there is no district 2; the last is 1");
  }
}

// One that was moved from had no plan: whatever was asked of it ended the program.
TEST(BuildDistricts, moved_ones_stay_what_they_are) {
  DistrictBuild plan(crosses(2));
  const DistrictBuild moved(std::move(plan));
  EXPECT_EQ(plan.size(), moved.size());  // NOLINT(bugprone-use-after-move)
  EXPECT_EQ(plan.build(1).solid.volume(), moved.build(1).solid.volume());
  DistrictBuild other(crosses(3));
  plan = std::move(other);
  EXPECT_EQ(plan.size(), other.size());  // NOLINT(bugprone-use-after-move)
  EXPECT_THROW((void)DistrictBuild(crosses(1), {.most_of_piece = std::nan("")}), Error);
}

}  // namespace
}  // namespace dupin
