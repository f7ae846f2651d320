#include <map>
#include <set>

#include <gtest/gtest.h>

#include "arrangement/manifold_patches.h"
#include "arrangement/non_manifold_vertices.h"
#include "arrangement/output_mesh.h"
#include "arrangement/winding_numbers.h"
#include "kernel/arrangement/stages_internal.h"

namespace dupin::arrangement {
namespace {

using test::cube;

struct Duplicated {
  support::BulkVector<OutputTriangle> before, after;
  VertexDuplicates duplicates;
};

Duplicated duplicated(const std::vector<TriMesh>& solids, const BooleanRule& rule) {
  test::Stages stages(solids, rule);
  const Subdivision subdivision = stages.subdivision(stages.incidences());
  const ManifoldPatches patches(stages.input, rule, subdivision);
  Duplicated result;
  const auto selection = propagate_winding_numbers(stages.input, rule, subdivision, patches).kept;
  result.before =
      collect_output_triangles(stages.input, stages.triangulated(subdivision), patches, selection);
  result.after = result.before;
  result.duplicates = duplicate_non_manifold_vertices(stages.input, result.after);
  return result;
}

// Every edge has one face on each side, and the faces around every point make one fan.
void expect_manifold(const support::BulkVector<OutputTriangle>& triangles) {
  std::map<std::array<PointId, 2>, PointId> beyond;  // of each half-edge
  std::map<PointId, std::map<PointId, PointId>> around;
  for (const OutputTriangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const PointId a = t.corners[k], b = t.corners[(k + 1) % 3], c = t.corners[(k + 2) % 3];
      EXPECT_TRUE(beyond.emplace(std::array{a, b}, c).second) << "run along once each way";
      around[a][b] = c;
    }
  }
  for (const auto& [half_edge, c] : beyond) {
    EXPECT_EQ(beyond.count({half_edge[1], half_edge[0]}), 1U);
  }
  for (const auto& [point, next] : around) {
    std::size_t steps = 0;
    PointId at = next.begin()->first;
    do {
      at = next.at(at);
      ++steps;
    } while (at != next.begin()->first && steps <= next.size());
    EXPECT_EQ(steps, next.size()) << "one fan";
  }
}

class DuplicatesOf : public testing::TestWithParam<test::Meeting> {
 protected:
  std::vector<BooleanRule> rules() {
    const std::size_t n = GetParam().solids.size();
    BooleanRule exclusive{{}, 1, [](std::span<const int> counts) { return counts[0] % 2 == 1; }};
    exclusive.group_of_operand.assign(n, 0);
    return {union_rule(n), intersection_rule(n), difference_rule(n), exclusive};
  }
};

TEST_P(DuplicatesOf, vertices_make_results_manifold) {
  for (const BooleanRule& rule : rules()) {
    expect_manifold(duplicated(GetParam().solids, rule).after);
  }
}

TEST_P(DuplicatesOf, vertices_leave_faces_where_they_were) {
  for (const BooleanRule& rule : rules()) {
    const auto [before, after, duplicates] = duplicated(GetParam().solids, rule);
    const PointId first = duplicates.first_copy;
    ASSERT_GE(after.size(), before.size());
    for (std::size_t f = 0; f < before.size() && after.size() == before.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const PointId id = after[f].corners[k];
        EXPECT_EQ(id < first ? id : duplicates.copies[id - first], before[f].corners[k]);
      }
    }
    for (const PointId copy : duplicates.copies) {
      EXPECT_LT(copy, first);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meetings, DuplicatesOf, testing::ValuesIn(test::meetings()),
                         test::meeting_name);

TEST(NonManifoldVertices, are_listed_with_the_faces_that_meet_there) {
  const auto [before, after, duplicates] =
      duplicated({cube(0, 0, 0), cube(2, 2, 0), cube(0, 0, 5), cube(2, 2, 7)}, union_rule(4));
  ASSERT_EQ(duplicates.touches.size(), 2U) << "an edge and a vertex";
  std::size_t edges = 0;
  for (const Touch& touch : duplicates.touches) {
    edges += touch.from != touch.to ? 1 : 0;
    for (const std::uint32_t f : touch.faces) {
      const Triangle& corners = before[f].corners;
      EXPECT_NE(std::find(corners.begin(), corners.end(), touch.from), corners.end());
      EXPECT_NE(std::find(corners.begin(), corners.end(), touch.to), corners.end());
    }
    EXPECT_GE(touch.faces.size(), 4U);
  }
  EXPECT_EQ(edges, 1U);
  EXPECT_EQ(duplicates.copies.size(), 3U) << "of two ends and a vertex";
}

TEST(NonManifoldVertices, are_none_in_a_manifold) {
  const auto [before, after, duplicates] =
      duplicated({cube(0, 0, 0), cube(1, 1, 1)}, union_rule(2));
  EXPECT_TRUE(duplicates.copies.empty());
  EXPECT_TRUE(duplicates.touches.empty());
}

}  // namespace
}  // namespace dupin::arrangement
