#include <gtest/gtest.h>

#include "arrangement/sheet_edges.h"
#include "kernel/arrangement/stages_internal.h"
#include "support/shapes.h"

namespace dupin::arrangement {
namespace {

// Two unit squares in one plane, on boxes on both sides of it, one shifted by a quarter.
class TwoTops : public testing::Test {
 protected:
  TwoTops()
      : TwoTops({test::box({0, 0, 0}, {1, 1, 1}), test::box({.25, .25, 1}, {1.25, 1.25, 2})}) {}
  explicit TwoTops(const std::vector<TriMesh>& meshes) : stages(meshes) {
    for (const TrianglePair& pair : stages.candidates()) {
      std::vector<TriangleIntersection> found;
      if (!intersect_across(stages.input, pair.first, pair.second, found)) {
        in_plane.push_back(pair);
      }
    }
  }

  // Of each triangle of pairs the edges that cross one of the other inside of sheets.
  std::size_t crossings(SheetEdges& edges) const {
    std::size_t count = 0;
    for (const auto& [first, second] : in_plane) {
      for (std::size_t e = 0; e < 3; ++e) {
        for (std::size_t f = 0; f < 3; ++f) {
          count += edges.cross(first, e, second, f) ? 1 : 0;
        }
      }
    }
    return count;
  }

  test::Stages stages;
  std::vector<TrianglePair> in_plane;
};

TEST_F(TwoTops, have_their_diagonals_inside) {
  SheetEdges edges(stages.input, in_plane);
  EXPECT_TRUE(edges.crossed().empty()) << "nobody has said so yet";
  EXPECT_EQ(crossings(edges), in_plane.size()) << "of each pair one of nine";
  const std::vector<TrianglePair> crossed = edges.crossed();
  ASSERT_EQ(crossed.size(), 2U);
  for (const auto& [t, u] : crossed) {
    EXPECT_EQ(stages.input.operand_of(t), stages.input.operand_of(u));
  }
  EXPECT_LT(crossed[0], crossed[1]);
}

TEST_F(TwoTops, have_none_where_both_ends_may_have_other_fans) {
  for (PointId id = 0; id < stages.input.first_double[1]; ++id) {
    stages.input.special[id] = 1;  // all of the first
  }
  SheetEdges edges(stages.input, in_plane);
  EXPECT_EQ(crossings(edges), 0U);
  EXPECT_TRUE(edges.crossed().empty());
}

TEST_F(TwoTops, have_none_where_they_may_cross_themselves) {
  stages.input.operand_pairs.push_back({1, 1});
  SheetEdges edges(stages.input, in_plane);
  EXPECT_EQ(crossings(edges), 0U);
}

// Without the others' halves nobody knows that an edge is inside.
TEST_F(TwoTops, need_both_sides) {
  in_plane.resize(1);
  SheetEdges edges(stages.input, in_plane);
  EXPECT_EQ(crossings(edges), 0U);
}

}  // namespace
}  // namespace dupin::arrangement
