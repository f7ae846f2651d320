#include <gtest/gtest.h>

#include "assembly/line_and_arc.h"
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
