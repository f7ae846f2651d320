#include <gtest/gtest.h>

#include "cross_check/boundary.h"
#include "dupin/kernel/boolean.h"
#include "support/shapes.h"

namespace dupin::cross_check {
namespace {

Boundary box(const Vec3& low, const Vec3& high) {
  return boundary_of(Solid::from(test::box(low, high)).exact());
}

// The frame of test::frame() with a facet for each flat side, two of them with a hole.
Boundary frame_of_whole_sides() {
  Boundary frame;
  for (const int size : {3, 1}) {
    for (const int z : {-1, 1}) {
      for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        frame.points.push_back({size * x, size * y, z});
      }
    }
  }
  const auto ring = [](std::uint32_t first, bool forward) {
    std::vector<DirectedEdge> edges;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t a = first + i, b = first + (i + 1) % 4;
      edges.push_back(forward ? DirectedEdge{a, b} : DirectedEdge{b, a});
    }
    return edges;
  };
  for (const std::uint32_t z : {0U, 1U}) {
    auto& side = frame.facets.emplace_back(ring(4 * z, z == 1));
    for (const DirectedEdge& edge : ring(8 + 4 * z, z == 0)) {
      side.push_back(edge);
    }
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4;
    frame.facets.push_back({{i, j}, {j, j + 4}, {j + 4, i + 4}, {i + 4, i}});
    frame.facets.push_back({{8 + j, 8 + i}, {8 + i, 12 + i}, {12 + i, 12 + j}, {12 + j, 8 + j}});
  }
  return frame;
}

TEST(Boundary, of_facets_with_holes_is_that_of_triangles) {
  const Boundary triangles = boundary_of(Solid::from(test::frame()).exact());
  Boundary sides = frame_of_whole_sides();
  EXPECT_EQ(volume(sides), 64);
  EXPECT_EQ(volume(triangles), 64);
  EXPECT_FALSE(corner_of_difference(sides, triangles));
  sides.points[10][0] += mpq_class(1, 1000);  // a corner of the hole
  EXPECT_TRUE(corner_of_difference(sides, triangles));
}

TEST(Boundary, differs_by_the_least_move_of_a_point) {
  const Boundary cube = box(Vec3::Zero(), Vec3::Ones());
  for (std::size_t i = 0; i < cube.points.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      Boundary moved = cube;
      moved.points[i][k] += mpq_class("1/1000000000000000000000000000000");
      const auto corner = corner_of_difference(cube, moved);
      ASSERT_TRUE(corner);
      EXPECT_EQ(corner, corner_of_difference(moved, cube));
    }
  }
}

TEST(Boundary, differs_first_in_the_least_corner) {
  const Boundary small = box(Vec3::Zero(), Vec3::Ones());
  const RationalPoint origin{0, 0, 0};
  EXPECT_EQ(corner_of_difference(small, {}), origin);
  EXPECT_EQ(corner_of_difference({}, small), origin);
  EXPECT_EQ(corner_of_difference(small, box(Vec3::Zero(), Vec3(1, 1, 2))), (RationalPoint{0, 0, 1}))
      << "within a side of the larger one";
  EXPECT_EQ(
      corner_of_difference(
          box(Vec3::Zero(), Vec3::Constant(4)),
          boundary_of(subtract(Solid::from(test::box(Vec3::Zero(), Vec3::Constant(4))),
                               std::vector{Solid::from(test::box(Vec3::Ones(), Vec3::Constant(2)))})
                          .exact())),
      (RationalPoint{1, 1, 1}));
  EXPECT_FALSE(corner_of_difference({}, {}));
}

TEST(Boundary, of_the_same_place_inside_out_differs) {
  const Boundary cube = box(Vec3::Zero(), Vec3::Ones());
  Boundary reversed = cube;
  for (auto& facet : reversed.facets) {
    for (DirectedEdge& edge : facet) {
      std::swap(edge[0], edge[1]);
    }
  }
  EXPECT_EQ(volume(reversed), -1);
  EXPECT_TRUE(corner_of_difference(cube, reversed));
}

TEST(Boundary, may_be_cut_up_and_double_points) {
  // Two halves with a wall between them, once each way, and points of their own.
  Boundary halves = box(Vec3::Zero(), Vec3(1, 1, 0.5));
  const Boundary upper = box(Vec3(0, 0, 0.5), Vec3::Ones());
  const auto shift = static_cast<std::uint32_t>(halves.points.size());
  halves.points.insert(halves.points.end(), upper.points.begin(), upper.points.end());
  for (auto facet : upper.facets) {
    for (DirectedEdge& edge : facet) {
      edge = {edge[0] + shift, edge[1] + shift};
    }
    halves.facets.push_back(facet);
  }
  EXPECT_EQ(volume(halves), 1);
  EXPECT_FALSE(corner_of_difference(halves, box(Vec3::Zero(), Vec3::Ones())));
}

}  // namespace
}  // namespace dupin::cross_check
