#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blends/network/piping_line_builder.h"
#include "dupin/blends/piping_line.h"
#include "dupin/kernel/gap.h"

namespace dupin::test {
namespace {

std::size_t verdicts(const Line& line, GapVerdict verdict) {
  std::size_t count = 0;
  for (const GapPair& pair : pair_ends(ports(line.line()), 1)) {
    count += pair.report.verdict == verdict;
  }
  return count;
}

Line& add_reducer(Line& line, const Vec3& from, const Vec3& to, double radius, double next) {
  line.add(PipingShape::straight, {from, to}, radius).last().is_eccentric = true;
  line.last().ports[1].radius = next;
  return line;
}

TEST(PipingLineEnds, are_where_the_file_has_them) {
  Line line;
  line.pipe({0, 0, 0}, {1000, .03, 0}).pipe({1000, -.01, 0}, {2000, 0, 0}, 30);
  const auto all = ports(line.line());
  ASSERT_EQ(all.size(), 4);
  EXPECT_EQ(all[1].name, "c0.2");
  EXPECT_EQ(all[1].ring.center, Vec3(1000, .03, 0));
  EXPECT_EQ(all[2].ring.radius, 30);
  EXPECT_EQ(pair_ends(all, 1).size(), 3);
}

TEST(PipingLineEnds, of_eccentric_reducers_are_parallel) {
  struct Row {
    std::vector<double> heights, radii;
    bool has_before = true, has_after = true;
  };
  const std::vector<Row> rows{{{0, -20}, {50, 30}},
                              {{0, -20}, {50, 30}, false, true},
                              {{0, -20}, {50, 30}, true, false},
                              {{0, 20, 35}, {50, 30, 15}},
                              {{0, 20, 20, 35}, {50, 30, 20, 15}},
                              {{0, 20, 35}, {50, 30, 15}, true, false},
                              {{0, 20, 35}, {50, 30, 15}, false, true}};
  for (const auto& [heights, radii, has_before, has_after] : rows) {
    const std::size_t reducers = heights.size() - 1;
    for (const Vec3& axis : {Vec3(100, 0, 0), Vec3(70, 20, -10)}) {
      const Vec3 up = axis.cross(Vec3(.3, 1, .1)).normalized();
      const auto at = [&](std::size_t i) -> Vec3 { return double(i) * axis + heights[i] * up; };
      Line line;
      if (has_before) {
        line.pipe(-5 * axis, at(0), radii.front());
      }
      for (std::size_t i = 0; i < reducers; ++i) {
        add_reducer(line, at(i), at(i + 1), radii[i], radii[i + 1]);
      }
      if (has_after) {
        line.pipe(at(reducers), at(reducers) + 5 * axis, radii.back());
      }
      for (const GapPair& pair : pair_ends(ports(line.line()), 1)) {
        EXPECT_LT(pair.report.kink.upper, pair.second ? 1e-12 : 4) << heights.size();
      }
      if (axis.y() == 0) {
        EXPECT_EQ(verdicts(line, GapVerdict::welded), reducers - 1 + has_before + has_after);
      }
    }
  }
}

TEST(PipingLineEnds, of_eccentric_reducers_without_a_length_are_parallel) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0});
  add_reducer(line, {500, 0, 0}, {500, 0, 20}, 50, 30).pipe({500, 0, 20}, {900, 0, 20}, 30);
  EXPECT_EQ(verdicts(line, GapVerdict::welded), 2);
}

TEST(PipingLineEnds, of_reducers_lie_across_their_line_where_neighbours_do_not_agree) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0});
  add_reducer(line, {500, 0, 0}, {600, 0, 20}, 50, 30).pipe({600, 0, 20}, {900, 200, 20}, 30);
  EXPECT_EQ(verdicts(line, GapVerdict::kink), 2);
  Line alone;
  add_reducer(alone, {500, 0, 0}, {600, 0, 20}, 50, 30);
  const auto ends = ports(alone.line());
  ASSERT_EQ(ends.size(), 2);
  EXPECT_EQ(ends[1].ring.normal, Vec3(100, 0, 20) / Vec3(100, 0, 20).norm());
}

// Its centre may lie beside it.
TEST(PipingLineEnds, of_a_run_that_goes_straight_on_are_along_it) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).pipe({700, 0, 0}, {1200, 0, 0});
  line.add(PipingShape::fitting, {{500, 0, 0}, {700, 0, 0}, {600, 100, 0}}).last().center =
      Vec3(600, 10, 0);
  line.last().ports[2].radius = 30;
  line.pipe({600, 100, 0}, {600, 300, 0}, 30);
  EXPECT_EQ(verdicts(line, GapVerdict::welded), 3);
}

TEST(PipingLineEnds, without_a_bore_have_that_of_their_neighbours) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).pipe({500.3, 0, 0}, {900, 0, 0});
  line.last().ports[0].radius = line.last().ports[1].radius = {};
  const auto ends = ports(line.line());
  ASSERT_EQ(ends.size(), 4);
  EXPECT_EQ(ends[2].ring.radius, 50);
}

// What is said of components is the same with and without the blends that take long to find.
TEST(PipingLineEnds, are_noted_without_blends) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).pipe({500, 0, 0}, {500, 500, 0});
  line.bend({500, 500, 0}, {500, 700, 0}, {700, 700, 0}).pipe({700, 700, 0}, {900, 700, 200});
  line.pipe({0, 2000, 0}, {500, 2000, 0}).pipe({510, 2010, 0}, {510, 2500, 0});
  line.bend({500, 2000, 0}, {510, 2000, 0}, {510, 2010, 0});  // sharper than its pipe
  PipingOptions options;
  options.keep_going = true;
  const PipingNetwork whole = line.made(options);
  options.blends_kinks = false;
  const PipingNetwork quick = line.made(options);
  EXPECT_EQ(notes(quick), notes(whole));
  EXPECT_THAT(notes(whole), testing::HasSubstr("left out"));
  Line kinked;
  kinked.pipe({0, 0, 0}, {500, 0, 0}).pipe({500, 0, 0}, {500, 500, 0});
  EXPECT_EQ(kinked.made(options).assembly.parts.size(), 2);
  EXPECT_EQ(kinked.made().assembly.parts.size(), 3);
}

TEST(PipingLineEnds, of_a_bend_that_does_not_turn_are_those_of_a_pipe) {
  Line line;
  line.pipe({0, 0, 0}, {500, 0, 0}).bend({500, 0, 0}, {800, 0, 0}, {600, 0, 0});
  line.pipe({600, 0, 0}, {900, 0, 0});
  EXPECT_EQ(verdicts(line, GapVerdict::welded), 2);
}

}  // namespace
}  // namespace dupin::test
