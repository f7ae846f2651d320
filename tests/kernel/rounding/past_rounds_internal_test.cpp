#include <gtest/gtest.h>

#include "rounding/past_rounds.h"

namespace dupin::rounding {
namespace {

TEST(PastRounds, let_edits_reach_farther_where_snaps_change_nothing) {
  PastRounds past;
  for (const std::size_t broken : {300U, 6U, 2U}) {
    past.count_snap(broken);
  }
  EXPECT_EQ(past.idle_snaps, 0);
  EXPECT_EQ(past.snap_reach(), kSnapReach);
  past.count_snap(2);
  EXPECT_EQ(past.snap_reach(), kSnapReach) << "edits go to any length first";
  past.count_snap(4);
  EXPECT_EQ(past.snap_reach(), 4 * kSnapReach) << "fewer there were before";
  past.count_snap(2);
  EXPECT_EQ(past.snap_reach(), 16 * kSnapReach);
  EXPECT_EQ(past.snaps, 6);
}

TEST(PastRounds, take_places_as_far_as_they_fill_and_move) {
  PastRounds past;
  past.void_width = 3;
  past.slit_reach = 1;
  past.moved = 0.25;
  EXPECT_EQ(past.filled(), 1.5);
  EXPECT_EQ(past.distance(), 1.75);
}

}  // namespace
}  // namespace dupin::rounding
