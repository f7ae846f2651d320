#include <random>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/repair.h"
#include "dupin/kernel/solid.h"
#include "kernel/healing/soups_internal.h"
#include "support/shapes.h"

// Bodies of cubes that cross along their edges, some of them inside out.
namespace dupin::healing {
namespace {

using test::joined;
using test::reversed;

mpq_class repaired_volume(const std::vector<TriMesh>& bodies) {
  return repair(joined(bodies)).solid.exact_volume();
}

// What they have in common was a void between what the one and the other do not have of it.
TEST(CrossedVoids, have_no_void_in_common_if_one_is_inside_out) {
  const TriMesh first = surface_of_cells({0, 0, 0}, {2, 2, 2}),
                second = surface_of_cells({1, 1, 1}, {3, 3, 3});
  EXPECT_EQ(repaired_volume({first, reversed(second)}), 15);
  EXPECT_EQ(repaired_volume({reversed(first), second}), 15);
  EXPECT_EQ(repaired_volume({reversed(first), reversed(second)}), 15);
}

// Frames, each in two halves that touch along faces: nothing crosses.
TEST(CrossedVoids, that_only_lie_on_each_other_keep_the_void_between_them) {
  std::set<Cell> cup = cells_of_box({0, 0, 0}, {3, 3, 2});
  cup.erase({1, 1, 1});
  const TriMesh lower = surface_of_cells(cup), lid = surface_of_cells({0, 0, 2}, {3, 3, 3});
  EXPECT_EQ(repaired_volume({lower, reversed(lid)}), 26);
  EXPECT_EQ(repaired_volume({reversed(lower), lid}), 26);
}

// It is within both together, and has all of its faces the other way round, too.
TEST(CrossedVoids, that_are_there_both_ways_round_are_no_cavities) {
  const TriMesh first = surface_of_cells({1, 0, 0}, {2, 3, 1}),
                second = surface_of_cells({0, 1, 0}, {3, 3, 1});
  EXPECT_EQ(repaired_volume({reversed(first), reversed(second), second}), 7);
  EXPECT_EQ(repaired_volume({first, reversed(second), second}), 7);
}

// A flat angle and a bar that begins at its side: their ends, top and bottom are in common.
TEST(CrossedVoids, are_filled_that_are_open_where_faces_in_common_were_dropped) {
  std::set<Cell> angle = cells_of_box({0, 0, 0}, {3, 1, 1});
  angle.merge(cells_of_box({0, 0, 0}, {1, 3, 1}));
  const TriMesh both = joined({surface_of_cells(angle), surface_of_cells({1, 0, 0}, {2, 3, 1})});
  std::mt19937 random(34);
  for (int round = 0; round < 100; ++round) {
    SCOPED_TRACE(round);
    TriMesh mesh = both;
    for (Triangle& t : mesh.triangles) {
      if (random() % 2 == 0) {
        std::swap(t[1], t[2]);
      }
    }
    EXPECT_EQ(repaired_volume({mesh}), 7);
  }
}

}  // namespace
}  // namespace dupin::healing
