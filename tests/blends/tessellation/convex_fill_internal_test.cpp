#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "tessellation/convex_fill.h"

namespace dupin::tessellation {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::vector<Triangle> filled(std::uint32_t first, std::uint32_t last) {
  std::vector<Triangle> triangles;
  fill(first, last, triangles);
  return triangles;
}

// Twice the area of the triangle in a regular polygon's circle of radius 1, counter-clockwise.
double doubled_area(const Triangle& triangle, double angle) {
  const auto [a, b, c] = triangle;
  return std::sin((b - a) * angle) + std::sin((c - b) * angle) - std::sin((c - a) * angle);
}

TEST(ConvexFill, covers_the_polygon_once) {
  constexpr std::uint32_t kFirst = 5;
  for (std::uint32_t n = 3; n < 40; ++n) {
    SCOPED_TRACE(n);
    const double angle = 2 * std::numbers::pi / n;
    double area = 0;
    std::map<Edge, int> edges;
    for (const Triangle& triangle : filled(kFirst, kFirst + n - 1)) {
      const double own = doubled_area(triangle, angle);
      EXPECT_GT(own, 0);
      area += own;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto a = triangle.at(i), b = triangle.at((i + 1) % 3);
        ++edges[{a, b}];
        --edges[{b, a}];
      }
    }
    EXPECT_NEAR(area, n * std::sin(angle), 1e-12);
    // What does not cancel is the polygon's edges, once each.
    std::erase_if(edges, [](const auto& edge) { return edge.second <= 0; });
    EXPECT_EQ(edges.size(), n);
    for (std::uint32_t i = 0; i < n; ++i) {
      EXPECT_EQ(edges.count({kFirst + i, kFirst + (i + 1) % n}), 1U);
    }
  }
}

TEST(ConvexFill, shares_the_triangles_out_among_the_corners) {
  std::map<std::uint32_t, int> count;
  for (const Triangle& triangle : filled(0, 1023)) {
    for (const std::uint32_t corner : triangle) {
      ++count[corner];
    }
  }
  for (const auto& [corner, triangles] : count) {
    EXPECT_LE(triangles, 2 * 10) << corner;
  }
}

TEST(ConvexFill, appends_and_fills_nothing_where_there_is_no_area) {
  std::vector<Triangle> triangles{{7, 8, 9}};
  tessellation::fill(3, 3, triangles);
  tessellation::fill(3, 4, triangles);
  EXPECT_EQ(triangles.size(), 1U);
  tessellation::fill(3, 5, triangles);
  EXPECT_EQ(triangles, (std::vector<Triangle>{{7, 8, 9}, {3, 4, 5}}));
}

}  // namespace
}  // namespace dupin::tessellation
