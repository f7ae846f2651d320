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

}  // namespace
}  // namespace dupin::network
