#include "dupin/kernel/triangulate_region.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/message_of.h"

namespace dupin {
namespace {

struct Drawing {
  std::vector<Vec2> points;
  std::vector<std::vector<std::uint32_t>> polygons;

  void add(const std::vector<Vec2>& corners) {
    std::vector<std::uint32_t> polygon(corners.size());
    std::iota(polygon.begin(), polygon.end(), std::uint32_t(points.size()));
    points.insert(points.end(), corners.begin(), corners.end());
    polygons.push_back(polygon);
  }
  [[nodiscard]] std::vector<Triangle> triangles() const {
    return triangulate_region(points, polygons);
  }
  [[nodiscard]] double area(const Triangle& t) const {
    const Vec2 u = points[t[1]] - points[t[0]], v = points[t[2]] - points[t[0]];
    return (u.x() * v.y() - u.y() * v.x()) / 2;
  }
};

std::vector<Vec2> square(double half) {
  return {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
}

TEST(TriangulateRegion, is_what_lies_within_an_odd_number_of_polygons) {
  Drawing drawing;
  drawing.add(square(1));
  drawing.add(square(4));
  drawing.add(square(2));
  drawing.add(square(3));
  std::reverse(drawing.polygons[2].begin(), drawing.polygons[2].end());
  double area = 0;
  for (const Triangle& triangle : drawing.triangles()) {
    EXPECT_GT(drawing.area(triangle), 0);
    area += drawing.area(triangle);
  }
  EXPECT_EQ(area, (64 - 36) + (16 - 4));
}

TEST(TriangulateRegion, has_inner_points_as_corners_where_they_lie_within) {
  Drawing drawing;
  drawing.add(square(4));
  drawing.add(square(2));
  const auto first = std::uint32_t(drawing.points.size());
  drawing.points.insert(drawing.points.end(), {{3, 0.5}, {-3, 1}, {0, 1}, {0, 5}});
  const std::vector<std::uint32_t> inner{first, first + 1, first + 2, first + 3};
  double area = 0;
  std::set<std::uint32_t> corners;
  for (const Triangle& t : triangulate_region(drawing.points, drawing.polygons, inner)) {
    area += drawing.area(t);
    corners.insert(t.begin(), t.end());
  }
  EXPECT_EQ(area, 64 - 16);
  EXPECT_TRUE(corners.contains(first) && corners.contains(first + 1));
  EXPECT_FALSE(corners.contains(first + 2) || corners.contains(first + 3));
  drawing.points[first] = {4, 0};  // on a side
  EXPECT_THROW((void)triangulate_region(drawing.points, drawing.polygons, inner), Error);
}

// Of a star-shaped polygon with a hole: all sides are there, in one sense, and areas add up.
TEST(TriangulateRegion, keeps_every_side_and_adds_no_corner) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> radius(1, 3);
  for (int round = 0; round < 20; ++round) {
    Drawing drawing;
    const int n = 5 + 7 * round;
    double expected = 0;
    for (const double scale : {1.0, 0.25}) {
      std::vector<Vec2> corners;
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        corners.push_back(scale * radius(random) * Vec2(std::cos(angle), std::sin(angle)));
      }
      for (int i = 0; i < n; ++i) {
        const Vec2 &a = corners[i], &b = corners[(i + 1) % n];
        expected += (scale == 1 ? 1 : -1) * (a.x() * b.y() - a.y() * b.x()) / 2;
      }
      drawing.add(corners);
    }
    std::multiset<std::pair<std::uint32_t, std::uint32_t>> sides;
    double area = 0;
    const auto triangles = drawing.triangles();
    for (const Triangle& t : triangles) {
      area += drawing.area(t);
      for (int i = 0; i < 3; ++i) {
        sides.insert({t[i], t[(i + 1) % 3]});
      }
    }
    EXPECT_NEAR(area, expected, 1e-12 * expected);
    EXPECT_EQ(triangles.size(), std::size_t(2 * n)) << "an annulus has as many as corners";
    for (std::uint32_t i = 0; i < std::uint32_t(n); ++i) {
      const std::uint32_t k = (i + 1) % n;
      EXPECT_EQ(sides.count({i, k}), 1U);
      EXPECT_EQ(sides.count({k, i}), 0U);
      EXPECT_EQ(sides.count({n + k, n + i}), 1U) << "a hole is to the right of its sides";
    }
  }
}

TEST(TriangulateRegion, lets_polygons_have_corners_in_common) {
  Drawing drawing;
  drawing.add(square(3));
  drawing.add({{0, 0}, {1, -1}, {2, 0}, {1, 1}});
  drawing.add({{-1, -1}, {-2, 0}, {-1, 1}});
  drawing.polygons[2].push_back(4);  // (0, 0)
  double area = 0;
  for (const Triangle& triangle : drawing.triangles()) {
    area += drawing.area(triangle);
  }
  EXPECT_EQ(area, 36 - 2 - 2);
}

TEST(TriangulateRegion, does_not_depend_on_where_polygons_begin) {
  Drawing drawing;
  drawing.add(square(2));
  drawing.add(square(1));
  const auto triangles = drawing.triangles();
  std::ranges::rotate(drawing.polygons[0], drawing.polygons[0].begin() + 2);
  EXPECT_EQ(drawing.triangles().size(), triangles.size());
}

Errc refusal(const Drawing& drawing) {
  try {
    (void)drawing.triangles();
  } catch (const Error& error) {
    return error.code();
  }
  return Errc::internal;
}

TEST(TriangulateRegion, refuses_polygons_that_cross_or_touch) {
  const auto with = [](const std::vector<Vec2>& other) {
    Drawing drawing;
    drawing.add(square(2));
    drawing.add(other);
    return drawing;
  };
  EXPECT_EQ(refusal(with({{1, 0}, {3, 0}, {1, 1}})), Errc::self_intersecting) << "they cross";
  EXPECT_EQ(refusal(with({{1, 0}, {2, 0}, {1, 1}})), Errc::self_intersecting) << "corner on a side";
  EXPECT_EQ(refusal(with({{1, 0}, {2, 2}, {1, 1}})), Errc::self_intersecting) << "two corners";
  EXPECT_EQ(refusal(with({{2, -1}, {2, 1}, {1, 0}})), Errc::self_intersecting) << "along a side";
  EXPECT_EQ(refusal(with({{0, 0}, {1, 1}, {1, 0}, {0, 1}})), Errc::self_intersecting) << "itself";
  EXPECT_EQ(refusal(with({{0, 0}, {1, 1}})), Errc::invalid_argument);
  EXPECT_EQ(refusal(with({{0, 0}, {1, 1}, {std::numeric_limits<double>::quiet_NaN(), 0}})),
            Errc::invalid_argument);
}

// Added in any portions; what doubles cannot tell is not among random points.
TEST(RegionTriangulation, has_the_triangles_of_all_points_at_once) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> coordinate(-5, 5);
  for (const std::size_t count : {3U, 40U, 700U}) {
    Drawing drawing;
    drawing.add({{-4, -4.25}, {4.5, -4}, {4, 4.125}, {-4.375, 4}});
    drawing.add({{-1, -1.25}, {1.5, -1}, {0, 1.125}});
    RegionTriangulation region(drawing.points, drawing.polygons);
    std::vector<std::uint32_t> inner;
    while (inner.size() < count) {
      const std::size_t before = drawing.points.size();
      for (std::size_t portion = inner.size() / 2 + 1; portion > 0; --portion) {
        inner.push_back(std::uint32_t(drawing.points.size()));
        drawing.points.emplace_back(coordinate(random), coordinate(random));
      }
      region.add(std::span(drawing.points).subspan(before));
      EXPECT_TRUE(region.triangles() == triangulate_region(drawing.points, drawing.polygons, inner))
          << inner.size();
    }
  }
}

TEST(RegionTriangulation, refuses_points_on_sides_and_points_that_are_there_already) {
  Drawing drawing;
  drawing.add(square(2));
  const auto code = [&](const std::vector<Vec2>& more) {
    RegionTriangulation region(drawing.points, drawing.polygons);
    region.add(std::vector<Vec2>{{0.5, 0.25}});
    try {
      region.add(more);
    } catch (const Error& error) {
      return error.code();
    }
    return Errc::internal;
  };
  EXPECT_EQ(code({{2, 0.5}}), Errc::self_intersecting) << "on a side";
  EXPECT_EQ(code({{2, 2}}), Errc::self_intersecting) << "a corner";
  EXPECT_EQ(code({{1, 1}, {0.5, 0.25}}), Errc::self_intersecting) << "there already";
  EXPECT_EQ(code({{1, 1}, {0, 0}, {1, 1}}), Errc::self_intersecting) << "twice";
  EXPECT_EQ(code({{std::numeric_limits<double>::infinity(), 0}}), Errc::invalid_argument);
  EXPECT_EQ(code({{1, 1}, {1e9, 0}}), Errc::internal) << "nothing to refuse";
}

TEST(TriangulateRegion, of_no_polygons_is_empty) {
  EXPECT_TRUE(triangulate_region({}, {}).empty());
  const std::vector<Vec2> points{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_TRUE(triangulate_region(points, {}).empty());
  EXPECT_TRUE(triangulate_region(points, {}, std::vector<std::uint32_t>{1}).empty());
}

TEST(TriangulateRegion, says_why_points_within_are_refused) {
  const std::vector<Vec2> points{{0, 0}, {1, 0}, {0, 1}, {.25, .125}, {.25, .125}, {.5, 0}};
  const std::vector<std::vector<std::uint32_t>> polygons{{0, 1, 2}};
  const auto reason = [&](const std::vector<std::uint32_t>& inner) {
    return test::message_of([&] { (void)triangulate_region(points, polygons, inner); },
                            Errc::self_intersecting);
  };
  EXPECT_EQ(reason({3, 4}), "two points of a region lie at (0.25, 0.125)");
  const std::string touches =
      "the polygons that bound a region cross or touch each other or a point within";
  EXPECT_EQ(reason({5}), touches);
  EXPECT_EQ(reason({3, 0}), touches) << "a corner";
}

TEST(TriangulateRegion, is_of_numbers_that_can_be_multiplied) {
  const auto triangulated = [](double size) {
    const std::vector<Vec2> points{{-size, -size}, {size, -size}, {0, size}, {0, size / 2}};
    return triangulate_region(points, std::vector<std::vector<std::uint32_t>>{{0, 1, 2}},
                              std::vector<std::uint32_t>{3});
  };
  for (const double size : {1e-200, 1., 1e39}) {
    EXPECT_EQ(triangulated(size).size(), 3) << size;
  }
  for (const double size : {1e40, 1e308}) {
    EXPECT_THROW((void)triangulated(size), Error) << size;
  }
}

TEST(TriangulateRegion, refuses_corners_that_are_no_points) {
  const std::vector<Vec2> points{{0, 0}, {1, 0}, {0, 1}};
  using Polygons = std::vector<std::vector<std::uint32_t>>;
  EXPECT_EQ(test::message_of(
                [&] {
                  (void)triangulate_region(points, Polygons{{0, 1, 3}});
                },
                Errc::invalid_argument),
            "a region has the corner 3, but there are 3 points");
  const std::vector<std::uint32_t> inner{7};
  for (const Polygons& polygons : {Polygons{{0, 1, 2}}, Polygons{}}) {
    EXPECT_EQ(test::message_of([&] { (void)triangulate_region(points, polygons, inner); },
                               Errc::invalid_argument),
              "a region has the corner 7, but there are 3 points");
  }
}

}  // namespace
}  // namespace dupin
