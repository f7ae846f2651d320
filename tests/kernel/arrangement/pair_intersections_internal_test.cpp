#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "arrangement/intersection_points.h"
#include "arrangement/pair_intersections.h"
#include "kernel/arrangement/stages_internal.h"
#include "support/pipe_cases.h"
#include "support/tiled_boxes.h"

namespace dupin::arrangement {
namespace {

auto values(const TriangleIntersection& e) {
  const auto of_end = [&e](std::size_t i) {
    return std::tuple(e.ends[i].on_first, e.ends[i].on_second, e.ends[i].first_crosses);
  };
  return std::tuple(e.first, e.second, e.kind, e.coplanar, e.axis, of_end(0), of_end(1));
}

// Those that are found in no other order, and how many of the others are left out: each where two
// edges cross that sheets say are inside of them.
std::size_t left_out(const test::Stages& stages, const Intersections& intersections,
                     const FlatSheets& sheets) {
  std::size_t count = 0;
  auto next = intersections.found.begin();
  for (const TriangleIntersection& e : stages.intersections()) {
    if (next != intersections.found.end() && values(*next) == values(e)) {
      ++next;
      continue;
    }
    ++count;
    const auto& [on_first, on_second, crosses] = e.ends[0];
    EXPECT_TRUE(e.coplanar && e.kind == TriangleIntersection::Kind::point);
    if (!is_edge(on_first) || !is_edge(on_second)) {
      ADD_FAILURE() << "a corner is left out";
      continue;
    }
    EXPECT_NE(sheets.at(edge_of(stages.input.triangles[e.first], on_first)), nullptr);
    EXPECT_NE(sheets.at(edge_of(stages.input.triangles[e.second], on_second)), nullptr);
  }
  EXPECT_EQ(next, intersections.found.end());
  return count;
}

// How many are left out where what follows is as if none were.
std::size_t left_out_without_a_trace(const std::vector<TriMesh>& meshes) {
  test::Stages all(meshes), fewer(meshes);
  const Intersections found = fewer.found();
  const IntersectionPoints expected = create_intersection_points(all.input, all.intersections());
  const std::size_t count = left_out(all, found, expected.sheets);
  const IntersectionPoints points =
      create_intersection_points(fewer.input, found.found, found.crossed_sheets);
  EXPECT_EQ(fewer.input.points.size(), all.input.points.size());
  EXPECT_EQ(points.corners, expected.corners);
  for (std::uint32_t t = 0; t < all.input.triangles.size(); ++t) {
    EXPECT_EQ(points.facets.mate(t), expected.facets.mate(t));
    for (Feature f = 3; f < kInside; ++f) {
      const EdgeKey edge = edge_of(all.input.triangles[t], f);
      const TrianglePair *pair = points.sheets.at(edge), *other = expected.sheets.at(edge);
      EXPECT_EQ(pair == nullptr, other == nullptr);
      EXPECT_TRUE(pair == nullptr || other == nullptr || *pair == *other);
    }
  }
  return count;
}

TEST(FindIntersections, leaves_out_crossings_inside_of_sheets_without_a_trace) {
  std::mt19937 random(0);
  std::size_t scenes_with_some = 0;
  for (int scene = 0; scene < 60; ++scene) {
    std::vector<TriMesh> boxes;
    for (int i = 0; i < 2 + scene % 3; ++i) {
      boxes.push_back(test::random_tiled_box(random));
    }
    scenes_with_some += left_out_without_a_trace(boxes) > 0 ? 1 : 0;
  }
  EXPECT_GT(scenes_with_some, 20U);
}

// Caps overlap in nearly as many pairs as the product of their triangles; nearly all crossings of
// their edges are inside of both.
TEST(FindIntersections, leaves_out_nearly_all_of_flush_pipes) {
  const std::vector<TriMesh> pipes = test::pipe_case("flush_32");
  const test::Stages stages(pipes);
  std::size_t crossings = 0;
  for (const TriangleIntersection& e : stages.intersections()) {
    crossings += e.coplanar && is_edge(e.ends[0].on_first) && is_edge(e.ends[0].on_second) ? 1 : 0;
  }
  EXPECT_GT(4 * left_out_without_a_trace(pipes), 3 * crossings);
}

TEST(FindIntersections, leaves_out_none_where_operands_may_cross_themselves) {
  test::Stages stages(test::pipe_case("flush_16"));
  const test::Stages others(test::pipe_case("flush_16"));
  stages.input.operand_pairs.insert(stages.input.operand_pairs.begin(), {0, 0});
  const std::vector<TrianglePair> pairs = others.candidates();
  const Intersections found = find_intersections(
      stages.input, pairs, support::ProgressStage(Progress(), "intersect", 0, 1));
  EXPECT_TRUE(found.crossed_sheets.empty());
  EXPECT_EQ(found.found.size(), others.intersections().size());
}

}  // namespace
}  // namespace dupin::arrangement
