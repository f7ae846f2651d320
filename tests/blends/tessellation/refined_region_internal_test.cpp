#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "tessellation/refined_region.h"

namespace dupin::tessellation {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

double smallest_angle(const Vec2& a, const Vec2& b, const Vec2& c) {
  double least = std::numbers::pi;
  for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}}) {
    least = std::min(least, std::acos((q - p).normalized().dot((r - p).normalized())));
  }
  return least;
}

struct Shape {
  std::vector<Vec2> points;
  std::vector<std::vector<std::uint32_t>> polygons;

  // Sides as long as a circle's, or a rectangle's.
  void append(const std::vector<Vec2>& polygon) {
    polygons.emplace_back();
    for (const Vec2& point : polygon) {
      polygons.back().push_back(std::uint32_t(points.size()));
      points.push_back(point);
    }
  }
  void append_circle(const Vec2& center, double radius, int corners) {
    std::vector<Vec2> polygon;
    for (int i = 0; i < corners; ++i) {
      const double t = 2 * std::numbers::pi * i / corners;
      polygon.emplace_back(center + radius * Vec2(std::cos(t), std::sin(t)));
    }
    append(polygon);
  }
  // No triangle has to be wider than this, or than 1.
  [[nodiscard]] double widest_side() const {
    double widest = 1;
    for (const auto& polygon : polygons) {
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        widest = std::max(widest, std::abs(points[polygon[i]].x() -
                                           points[polygon[(i + 1) % polygon.size()]].x()));
      }
    }
    return widest * (1 + 1e-8);
  }
  void append_rectangle(int width, int height) {
    std::vector<Vec2> polygon;
    for (int i = 0; i < width; ++i) polygon.emplace_back(i, 0);
    for (int i = 0; i < height; ++i) polygon.emplace_back(width, i);
    for (int i = width; i > 0; --i) polygon.emplace_back(i, height);
    for (int i = height; i > 0; --i) polygon.emplace_back(0, i);
    append(polygon);
  }
};

double area(const Shape& shape) {
  double sum = 0;
  for (const auto& polygon : shape.polygons) {
    double own = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 &a = shape.points[polygon[i]],
                 &b = shape.points[polygon[(i + 1) % polygon.size()]];
      own += (a.x() * b.y() - a.y() * b.x()) / 2;
    }
    sum += sum == 0 ? std::abs(own) : -std::abs(own);
  }
  return sum;
}

// Every side is one of a triangle, and the triangles fill the region without slivers.
TEST(RefinedRegion, is_filled_without_slivers) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(0.2, 0.8);
  for (int i = 0; i < 20; ++i) {
    Shape shape;
    shape.append_rectangle(40, 12);
    for (int k = 0; k < 3; ++k) {
      const double radius = 0.5 + 3 * at(random);
      shape.append_circle({40 * (k + 0.5) / 3 + at(random), 12 * (0.4 + at(random) / 5)}, radius,
                          int(8 + 12 * at(random) * radius));
    }
    const RefinedRegion region = refined_region(shape.points, shape.polygons);
    EXPECT_TRUE(std::equal(shape.points.begin(), shape.points.end(), region.points.begin()));
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
    double sum = 0;
    for (const auto& [a, b, c] : region.triangles) {
      const Vec2 &p = region.points[a], &q = region.points[b], &r = region.points[c];
      const double doubled = (q - p).x() * (r - p).y() - (q - p).y() * (r - p).x();
      EXPECT_GT(doubled, 0);
      EXPECT_GT(smallest_angle(p, q, r), 18 * kDegree);
      EXPECT_LE(std::max({p.x(), q.x(), r.x()}) - std::min({p.x(), q.x(), r.x()}),
                shape.widest_side());
      sum += doubled / 2;
      for (const auto& side : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        EXPECT_TRUE(sides.insert(side).second);
      }
    }
    EXPECT_NEAR(sum, area(shape), 1e-9);
    for (const auto& polygon : shape.polygons) {
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const std::uint32_t a = polygon[k], b = polygon[(k + 1) % polygon.size()];
        EXPECT_EQ(sides.count({a, b}) + sides.count({b, a}), 1U);
      }
    }
  }
}

TEST(RefinedRegion, has_triangles_that_grow_away_from_short_sides) {
  Shape shape;
  shape.append_rectangle(16, 16);
  shape.append_circle({8, 8}, 1, 200);  // sides of 0.03
  const RefinedRegion region = refined_region(shape.points, shape.polygons);
  EXPECT_LT(region.triangles.size(), 3500U);
  for (const auto& [a, b, c] : region.triangles) {
    EXPECT_GT(smallest_angle(region.points[a], region.points[b], region.points[c]), 18 * kDegree);
  }
}

TEST(RefinedRegion, keeps_sharp_corners) {
  Shape shape;
  shape.append({{0, 0}, {8, 0}, {8, 0.1}});
  const RefinedRegion region = refined_region(shape.points, shape.polygons);
  EXPECT_GE(region.triangles.size(), 1U);
  EXPECT_LT(region.triangles.size(), 100U);
}

// The circles about triangles in the way between them reach far beyond it.
TEST(RefinedRegion, is_filled_where_holes_leave_a_narrow_way) {
  const auto arch = [](double x) { return 0.1 * x * (8 - x); };
  for (const auto& [gap, lean] :
       {std::pair(0.1, 0.), {0.1, 0.2}, {0.01, 0.}, {0.01, 0.2}, {1e-3, 0.}, {1e-5, 0.}}) {
    Shape shape;
    shape.append_rectangle(16, 12);
    std::vector<Vec2> lower, upper;  // a lens, and a sickle over it
    for (double x = 0; x <= 8; x += 0.5) {
      lower.emplace_back(4 + x, 5 + arch(x));
      upper.emplace_back(4 + x, 5.2 + 2 * arch(x));
    }
    for (double x = 7.5; x > 0; x -= 0.5) {
      lower.emplace_back(4 + x, 5 - arch(x));
      upper.emplace_back(4 + x + lean, 5 + gap + arch(x + lean));
    }
    shape.append(lower);
    shape.append(upper);
    const RefinedRegion region = refined_region(shape.points, shape.polygons);
    EXPECT_LT(region.triangles.size(), 2000U);
  }
}

TEST(RefinedRegion, refuses_polygons_that_cross) {
  Shape shape;
  shape.append_rectangle(8, 4);
  shape.append_circle({8, 2}, 1, 12);
  EXPECT_THROW((void)refined_region(shape.points, shape.polygons), Error);
}

}  // namespace
}  // namespace dupin::tessellation
