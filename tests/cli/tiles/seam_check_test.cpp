#include "tiles/seam_check.h"

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace dupin::cli {
namespace {

// A triangle, or the same one from its other side.
SeamSide side(double x, bool is_turned) {
  SeamSide result;
  result.is_end = true;
  result.borders = {{0, 3}};
  result.end = is_turned ? std::vector<Vec3>{{x, 0, 0}, {x, 0, 1}, {x, 1, 0}}
                         : std::vector<Vec3>{{x, 0, 0}, {x, 1, 0}, {x, 0, 1}};
  return result;
}

const std::vector<Seam> kSeams{{{0, 2}, "a", {}}, {{1, 2}, "b", {}}};

TEST(SeamCheck, knows_the_seams_of_pieces) {
  const SeamCheck seams(kSeams);
  EXPECT_EQ(seams.of(0), (std::vector<Seam>{kSeams[0]}));
  EXPECT_EQ(seams.of(1), (std::vector<Seam>{kSeams[1]}));
  EXPECT_EQ(seams.of(2), kSeams);
  EXPECT_TRUE(seams.of(3).empty());
}

TEST(SeamCheck, joins_the_shells_of_what_fits) {
  SeamCheck seams(kSeams);
  SeamSide second = side(0, true);
  second.borders[0].shell = 1;
  seams.add(0, {side(0, false)}, 0);
  seams.add(1, {side(5, false)}, 1);
  seams.add(2, {second, side(5, true)}, 2);
  EXPECT_TRUE(seams.misfits().empty());
  Report report;
  report.points = 20;
  report.euler_number = 4;
  report.shells = {{0, 10, 1, 0, 1}, {10, 20, 2, 0, 1}, {30, 30, 3, 0, 1}, {60, 40, 4, 0, 1}};
  seams.join(report);
  EXPECT_EQ(report.points, 14);
  EXPECT_EQ(report.components, 2);
  EXPECT_EQ(report.euler_number, 4);
  EXPECT_EQ(report.shells, (std::vector<ShellReport>{{0, 50, 5, 0, 2}, {10, 50, 5, 0, 2}}));
}

TEST(SeamCheck, names_what_does_not_fit) {
  SeamCheck seams(kSeams);
  seams.add(0, {side(0, false)}, 0);
  seams.add(1, {side(5, false)}, 1);
  seams.add(2, {side(0, false), side(5, true)}, 2);
  EXPECT_EQ(seams.misfits(), std::set<std::string>{"a"});
}

// Two pieces along two borders, which enclose a void: there may be what lies in it.
TEST(SeamCheck, names_what_may_lie_around_others) {
  SeamSide one = side(0, false), other = side(0, true);
  one.borders = other.borders = {{0, 3}, {1, 3}};
  for (const bool has_others : {false, true}) {
    other.has_others = has_others;
    SeamCheck seams(kSeams);
    seams.add(0, {one}, 0);
    seams.add(2, {other, side(5, true)}, 2);
    seams.add(1, {side(5, false)}, 4);
    EXPECT_EQ(seams.misfits().contains("a"), has_others);
  }
}

}  // namespace
}  // namespace dupin::cli
