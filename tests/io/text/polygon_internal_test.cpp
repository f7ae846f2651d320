#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "text/polygon.h"

namespace dupin {
namespace {

std::string nowhere() { return {}; }

std::vector<std::uint32_t> all_corners(std::size_t size) {
  std::vector<std::uint32_t> corners(size);
  std::iota(corners.begin(), corners.end(), 0U);
  return corners;
}

mpq_class twice_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return mpq_class((mpq_class(b.x()) - a.x()) * (mpq_class(c.y()) - a.y()) -
                   (mpq_class(b.y()) - a.y()) * (mpq_class(c.x()) - a.x()));
}

/// A triangulation of a simple polygon in z = 0: all triangles strictly positive and their areas
/// add up to the polygon's.
void expect_exact_cover(const std::vector<Vec3>& points) {
  std::vector<Triangle> triangles;
  text::triangulate(all_corners(points.size()), points, triangles, nowhere);
  ASSERT_EQ(triangles.size(), points.size() - 2);
  mpq_class covered = 0;
  for (const Triangle& t : triangles) {
    const mpq_class area = twice_area(points[t[0]], points[t[1]], points[t[2]]);
    EXPECT_GT(area, 0);
    covered += area;
  }
  mpq_class polygon = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    polygon += twice_area(Vec3::Zero(), points[i], points[(i + 1) % points.size()]);
  }
  EXPECT_EQ(covered, polygon);
}

TEST(Polygon, non_convex_faces_are_covered_exactly) {
  const std::vector<std::vector<Vec3>> polygons = {
      {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}},                        // dart
      {{1, 1, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}},                        // dart, reflex first
      {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}},  // L
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}},  // straight
                                                                                      // corners
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0x1p-60, 0}},  // a sliver of 2^-60
      {{0, 0, 0},
       {5, 0, 0},
       {5, 3, 0},
       {4, 3, 0},
       {4, 1, 0},
       {3, 1, 0},
       {3, 3, 0},
       {2, 3, 0},
       {2, 1, 0},
       {1, 1, 0},
       {1, 3, 0},
       {0, 3, 0}},  // comb
  };
  for (const auto& polygon : polygons) {
    expect_exact_cover(polygon);
  }
}

TEST(Polygon, random_star_shaped_polygons_are_covered_exactly) {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> radius(0.1, 1);
  for (int i = 0; i < 200; ++i) {
    const int size = 4 + i % 60;
    std::vector<Vec3> polygon;
    for (int k = 0; k < size; ++k) {
      const double angle = 2 * 3.141592653589793 * k / size;
      const double r = radius(random);
      polygon.emplace_back(1000 + r * std::cos(angle), r * std::sin(angle), 0);
    }
    expect_exact_cover(polygon);
  }
}

TEST(Polygon, orientation_is_kept_in_every_plane) {
  const std::vector<Vec3> dart = {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool reversed : {false, true}) {
      std::vector<Vec3> points;
      for (const Vec3& p : dart) {
        Vec3 turned;
        turned[(axis + 1) % 3] = p.x();
        turned[(axis + 2) % 3] = p.y();
        turned[axis] = 7 + p.x() / 4;
        points.push_back(turned);
      }
      if (reversed) {
        std::reverse(points.begin(), points.end());
      }
      std::vector<Triangle> triangles;
      text::triangulate(all_corners(4), points, triangles, nowhere);
      for (const Triangle& t : triangles) {
        const double x1 = points[t[1]][(axis + 1) % 3] - points[t[0]][(axis + 1) % 3];
        const double y1 = points[t[1]][(axis + 2) % 3] - points[t[0]][(axis + 2) % 3];
        const double x2 = points[t[2]][(axis + 1) % 3] - points[t[0]][(axis + 1) % 3];
        const double y2 = points[t[2]][(axis + 2) % 3] - points[t[0]][(axis + 2) % 3];
        EXPECT_GT((x1 * y2 - y1 * x2) * (reversed ? -1 : 1), 0);
      }
    }
  }
}

TEST(Polygon, one_that_is_not_simple_still_gives_all_its_triangles) {
  const std::vector<std::vector<Vec3>> polygons = {
      {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},             // bow tie
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}},  // a line
      {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},             // a point
      {{0, 0, 0}, {2, 3, 0}, {4, 0, 0}, {0, 2, 0}, {4, 2, 0}},  // pentagram
  };
  for (const auto& polygon : polygons) {
    std::vector<Triangle> triangles;
    text::triangulate(all_corners(polygon.size()), polygon, triangles, nowhere);
    EXPECT_EQ(triangles.size(), polygon.size() - 2);
  }
}

TEST(Polygon, too_many_corners_are_refused_with_their_place) {
  std::vector<Triangle> triangles;
  const std::vector<std::uint32_t> corners = all_corners(text::kLargestPolygon + 1);
  try {
    text::triangulate(corners, {}, triangles, [] { return "x.off:7"; });
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
    EXPECT_STREQ(error.what(),
                 "x.off:7: a face of 20001 vertices is more than the 20000 that are cut into "
                 "triangles; write it as triangles");
  }
}

TEST(Polygon, a_hole_joined_by_a_bridge_is_covered) {
  // A square with a square hole; corners 0 and 4 appear twice along the bridge.
  const std::vector<Vec3> points = {{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0},
                                    {2, 2, 0}, {2, 4, 0}, {4, 4, 0}, {4, 2, 0}};
  const std::vector<std::uint32_t> corners = {0, 1, 2, 3, 0, 4, 5, 6, 7, 4};
  std::vector<Triangle> triangles;
  text::triangulate(corners, points, triangles, nowhere);
  ASSERT_EQ(triangles.size(), 8U);
  mpq_class covered = 0;
  for (const Triangle& t : triangles) {
    const mpq_class area = twice_area(points[t[0]], points[t[1]], points[t[2]]);
    EXPECT_GT(area, 0);
    covered += area;
  }
  EXPECT_EQ(covered, 2 * (36 - 4));
}

}  // namespace
}  // namespace dupin
