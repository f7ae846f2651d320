#include <gtest/gtest.h>

#include "blends/network/piping_network_internal.h"
#include "network/piping_reach.h"

namespace dupin::network {
namespace {

// Where the second pipe's start comes to lie, beside a run of radius 50 along x.
Vec3 start_of(const Vec3& from, const Vec3& to) {
  const PipingLine line = line_of({component(PipingShape::straight, {{0, 0, 0}, {1000, 0, 0}}),
                                   component(PipingShape::straight, {from, to}, {}, 10)});
  LineNotes notes("a.pcf", false);
  PipingSpans spans = spans_of(line, {}, notes);
  reach_runs(line, {}, spans, notes);
  return spans.spans[1].ends[0].point;
}

TEST(PipingReach, goes_on_to_the_axis) {
  EXPECT_EQ(start_of({500, 0, 50}, {500, 0, 300}), Vec3(500, 0, 0));
  EXPECT_EQ(start_of({500, 0, 20}, {500, 0, 300}), Vec3(500, 0, 0));
  EXPECT_EQ(start_of({500, 40, 30}, {500, 40, 300}), Vec3(500, 40, 0));               // beside it
  EXPECT_LT((start_of({540, 0, 40}, {640, 0, 140}) - Vec3(500, 0, 0)).norm(), 1e-9);  // oblique
}

TEST(PipingReach, leaves_ends_elsewhere_alone) {
  for (const auto& [from, to] : {std::pair(Vec3(500, 0, 60), Vec3(500, 0, 300)),
                                 std::pair(Vec3(1001, 0, 40), Vec3(1001, 0, 300)),
                                 std::pair(Vec3(500, 0, 40), Vec3(900, 0, 60)),
                                 std::pair(Vec3(500, 0, -20), Vec3(500, 0, 300))}) {
    EXPECT_EQ(start_of(from, to), from);
  }
}

// Of a pipe of radius 10 that passes the axis of one of radius 50.
TEST(PipingReach, ends_beyond_the_axis_are_none_where_they_lie_in_the_run_as_a_whole) {
  for (const auto& [end, is_hidden] :
       {std::pair(Vec3(500, 0, -20), true), std::pair(Vec3(500, 0, -48.9), true),
        std::pair(Vec3(500, 0, -49.1), false), std::pair(Vec3(500, 35, -20), true),
        std::pair(Vec3(500, 37, -20), false), std::pair(Vec3(9, 0, -20), false),
        std::pair(Vec3(11, 0, -20), true)}) {
    const Vec3 away(end.x(), end.y(), 300);
    const PipingLine line = line_of({component(PipingShape::straight, {{0, 0, 0}, {1000, 0, 0}}),
                                     component(PipingShape::straight, {end, away}, {}, 10)});
    LineNotes notes("a.pcf", false);
    PipingSpans spans = spans_of(line, {}, notes);
    reach_runs(line, {}, spans, notes);
    EXPECT_EQ(spans.spans[1].ends[0].is_hidden, is_hidden) << end.transpose();
    EXPECT_EQ(std::move(notes).take().empty(), is_hidden) << end.transpose();
  }
}

}  // namespace
}  // namespace dupin::network
