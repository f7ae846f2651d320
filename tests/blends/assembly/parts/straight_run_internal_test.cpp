#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "assembly/parts/line_and_arc.h"
#include "assembly/parts/straight_run.h"
#include "blends/assembly/part_fixture_internal.h"

namespace dupin::assembly {
namespace {

TEST(StraightRun, has_the_axis_of_a_pipe_or_cone) {
  const test::LonePart part(PipeOn{},
                            {{"cone", line({{1, 2, 3}, {0, 0, -1}, 2}, {1, 2, 8}, {1, {}}, true)}});
  const RunAxis run = run_axis(part.context(), "cone", "on");
  EXPECT_EQ(run.from, Vec3(1, 2, 3));
  EXPECT_EQ(run.direction, Vec3(0, 0, 1));
  EXPECT_EQ(run.length, 5);
  EXPECT_EQ(point_on_run(part.context(), run, 2), Vec3(1, 2, 5));
  EXPECT_EQ(test::fault_of([&] { return point_on_run(part.context(), run, 5.5); }),
            "pipe/at: must be from 0 to the length of the part it is on, 5, not 5.5");
}

// Of a part of that length: its ends' coordinates are rounded, so that they are nearer or further.
TEST(StraightRun, has_the_length_that_a_document_gives_it) {
  const Vec3 along = Vec3(.98, .12, -.31).normalized();
  int shorter = 0;
  for (int i = 1; i <= 50; ++i) {
    const Vec3 from(1e3 + i, -2e3, .1 * i);
    const double length = .0165 * i;
    const test::LonePart part(
        PipeOn{}, {{"cone", line({from, -along, 2}, from + length * along, {1, {}}, true)}});
    const RunAxis run = run_axis(part.context(), "cone", "on");
    shorter += run.length < length ? 1 : 0;
    EXPECT_EQ(point_on_run(part.context(), run, length),
              point_on_run(part.context(), run, std::min(run.length, length)));
    EXPECT_NE(test::fault_of([&] { return point_on_run(part.context(), run, length + 1e-11); }),
              "");
  }
  EXPECT_GT(shorter, 10);
}

TEST(StraightRun, prints_what_is_too_long_as_longer) {
  const test::LonePart part(PipeOn{},
                            {{"cone", line({{0, 0, 0}, {0, 0, -1}, 2}, {0, 0, 5}, {1, {}}, true)}});
  const RunAxis run = run_axis(part.context(), "cone", "on");
  const std::string said = "pipe/at: must be from 0 to the length of the part it is on, 5, not ";
  EXPECT_EQ(test::fault_of([&] { return point_on_run(part.context(), run, 5 + 1e-9); }),
            said + "5.00001");
  EXPECT_EQ(test::fault_of([&] { return point_on_run(part.context(), run, -1e-9); }),
            said + "-1e-09");
}

TEST(StraightRun, is_no_bend_and_no_ball) {
  const test::LonePart part(
      PipeOn{},
      {{"bend", arc({{0, 0, 0}, {0, 0, -1}, 1}, {{3, 0, 3}, {1, 0, 0}, 1}, {1, 0, 0}, 3, 1.5)},
       {"ball", Sphere{}}});
  for (const char* name : {"bend", "ball"}) {
    EXPECT_EQ(test::fault_of([&] { return run_axis(part.context(), name, "on"); }),
              std::string("pipe/on: '") + name + "' is no straight pipe or cone");
  }
}

}  // namespace
}  // namespace dupin::assembly
