#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/fillet_overlap.h"
#include "dupin/blends/build.h"
#include "dupin/blends/certify.h"
#include "dupin/kernel/error.h"
#include "support/named_parts.h"

namespace dupin {
namespace {

using test::fillet;
using test::pipe;

// Two branches on a run, the second at `to`.
Assembly document(const Vec3& from, const Vec3& to, const Part& second) {
  return {"d.json",
          Unit::millimetre,
          0.02,
          {},
          {pipe("run", {-60, 0, 0}, {60, 0, 0}, 15), pipe("a", {0, 0, 0}, {0, 0, 45}, 10),
           pipe("b", from, to, 10), fillet("at-a", "run", "a", 3), second}};
}

std::string refused(const Assembly& assembly) {
  try {
    (void)build(assembly);
    return "built";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
    EXPECT_EQ(error.part(), "at-b");
    EXPECT_THAT(error.where(), testing::HasSubstr("d.json#/parts/4"));
    return error.message();
  }
}

// What is named builds, and 1 % more does not.
TEST(FilletOverlap, names_both_and_the_largest_radius_that_builds) {
  struct Row {
    Vec3 from, to;
  };
  for (const auto& [from, to] :
       {Row{{24, 0, 0}, {24, 0, 45}}, Row{{26, 0, 0}, {26, 0, 45}}, Row{{0, 0, 0}, {0, 45, 0}}}) {
    const auto with = [&](double radius) {
      return document(from, to, fillet("at-b", "run", "b", radius));
    };
    const std::string why = refused(with(4));
    EXPECT_THAT(why, testing::HasSubstr("it overlaps 'at-a' on 'run'; with 'at-a' as it is, the "
                                        "largest radius that fits is "));
    const double named = std::strtod(why.substr(why.rfind(' ')).c_str(), nullptr);
    EXPECT_GT(named, 0.1);
    EXPECT_EQ(refused(with(named)), "built") << named;
    EXPECT_THAT(refused(with(1.01 * named)), testing::HasSubstr("it overlaps 'at-a'")) << named;
    try {
      (void)certify(with(4));
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.message(), why) << "whoever asks";
      EXPECT_EQ(error.part(), "at-b");
    }
  }
}

TEST(FilletOverlap, says_where_no_ball_would_fit) {
  EXPECT_THAT(refused(document({15, 0, 0}, {15, 0, 45}, fillet("at-b", "run", "b", 2))),
              testing::HasSubstr("it overlaps 'at-a' on 'run'; nor does a smaller ball fit"));
  EXPECT_EQ(
      refused(document({15, 0, 0}, {15, 0, 45}, {"at-b", CopeOfEnd{{"b", End::start}, "run"}})),
      "it overlaps 'at-a' on 'run'; without 'at-b' the pipes are united uncut, which may do");
  Assembly without =
      document({15, 0, 0}, {15, 0, 45}, {"at-b", CopeOfEnd{{"b", End::start}, "run"}});
  std::erase_if(without.parts, [](const Part& part) { return part.name == "at-b"; });
  EXPECT_EQ(refused(without), "built");
}

// A branch inside another one: its own edge would be where the other has cut the run away.
TEST(FilletOverlap, is_told_of_what_lies_inside_another) {
  for (const auto& [from, to] :
       {std::pair(Vec3(0, 0, 0), Vec3(0, 0, 50)), {{1, 2, 0}, {2, 2, 50}}}) {
    for (const double radius : {0.5, 3.0}) {
      Assembly nested = document(from, to, fillet("at-b", "run", "b", radius));
      nested.parts[2] = pipe("b", from, to, 3);
      EXPECT_THAT(refused(nested), testing::HasSubstr("it overlaps 'at-a' on 'run'"));
      nested.parts[4] = {"at-b", CopeOfEnd{{"b", End::start}, "run"}};
      EXPECT_THAT(refused(nested),
                  testing::HasSubstr("it overlaps 'at-a' on 'run'; without 'at-b' the pipes"));
      nested.parts.pop_back();
      EXPECT_EQ(refused(nested), "built");
    }
  }
}

// Pipes that are equal, and whose axes miss each other by a hair: not every row of triangles fits.
// Their loops all but meet themselves behind the pipes.
TEST(FilletOverlap, is_not_claimed_of_pipes_that_are_nearly_equal) {
  for (const double tolerance : {0.5, 0.3, 0.2, 0.05}) {
    const Assembly assembly{"d.json",
                            Unit::millimetre,
                            tolerance,
                            {},
                            {pipe("run", {0, 0, -100}, {0, 0, 100}, 30),
                             pipe("branch", {-100, 0.0005, 10}, {100, 0.0005, -30}, 30),
                             fillet("f", "run", "branch", 5)}};
    EXPECT_EQ(build(assembly).solid.components(), 1U) << tolerance;
  }
}

}  // namespace
}  // namespace dupin
