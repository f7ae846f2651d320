#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "predicates/triangle_overlap.h"

namespace dupin::predicates {
namespace {

using Corners = std::array<Vec3, 3>;
using Integer = mpz_class;

// All below is exact: coordinates are small integers.
int side(const Corners& plane, const Vec3& p) {
  const double value = (plane[1] - plane[0]).cross(plane[2] - plane[0]).dot(p - plane[0]);
  return (value > 0) - (value < 0);
}

// A polygon of what the triangle has in the half-space before the plane through q, clipped by
// Sutherland and Hodgman in homogeneous integers: (X, Y, Z, W), W > 0.
using Homogeneous = std::array<Integer, 4>;

Integer height(const std::array<Integer, 4>& plane, const Homogeneous& p) {
  return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3] * p[3];
}

std::vector<Homogeneous> clipped(const std::vector<Homogeneous>& polygon,
                                 const std::array<Integer, 4>& plane) {
  std::vector<Homogeneous> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Homogeneous &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Integer at_p = height(plane, p), at_q = height(plane, q);
    if (at_p >= 0) {
      result.push_back(p);
    }
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
      Homogeneous between;
      for (std::size_t k = 0; k < 4; ++k) {
        between[k] = at_p > 0 ? at_p * q[k] - at_q * p[k] : at_q * p[k] - at_p * q[k];
      }
      result.push_back(between);
    }
  }
  return result;
}

std::array<Integer, 4> plane_of(const Vec3& normal, const Vec3& through) {
  const auto integer = [](double x) { return Integer(x); };
  return {integer(normal[0]), integer(normal[1]), integer(normal[2]),
          integer(-normal.dot(through))};
}

// What b has in common with a: b, clipped to the plane of a and to the inner sides of its edges.
std::vector<Homogeneous> common_part(const Corners& a, const Corners& b) {
  std::vector<Homogeneous> polygon;
  for (const Vec3& p : b) {
    polygon.push_back({Integer(p[0]), Integer(p[1]), Integer(p[2]), 1});
  }
  const Vec3 normal = (a[1] - a[0]).cross(a[2] - a[0]);
  polygon = clipped(polygon, plane_of(normal, a[0]));
  polygon = clipped(polygon, plane_of(-normal, a[0]));
  for (std::size_t k = 0; k < 3; ++k) {
    polygon = clipped(polygon, plane_of(normal.cross(a[(k + 1) % 3] - a[k]), a[k]));
  }
  return polygon;
}

bool is_corner_of(const Homogeneous& p, const Corners& corners) {
  return std::ranges::any_of(corners, [&](const Vec3& c) {
    return p[0] == p[3] * Integer(c[0]) && p[1] == p[3] * Integer(c[1]) &&
           p[2] == p[3] * Integer(c[2]);
  });
}

// The corners that the two share are common anyway, and so is the edge between two of them.
TriangleOverlap expected_overlap(const Corners& a, const Corners& b) {
  const std::vector<Homogeneous> common = common_part(a, b);
  const bool all_shared = std::ranges::all_of(
      common, [&](const Homogeneous& p) { return is_corner_of(p, a) && is_corner_of(p, b); });
  const bool coplanar = std::ranges::all_of(b, [&](const Vec3& p) { return side(a, p) == 0; });
  if (coplanar) {
    // An area, if three of the common points are not on one line.
    for (const Homogeneous& p : common) {
      for (const Homogeneous& q : common) {
        for (const Homogeneous& r : common) {
          for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
            const Integer turn = p[i] * (q[j] * r[3] - q[3] * r[j]) -
                                 p[j] * (q[i] * r[3] - q[3] * r[i]) +
                                 p[3] * (q[i] * r[j] - q[j] * r[i]);
            if (turn != 0) {
              return TriangleOverlap::overlap;
            }
          }
        }
      }
    }
  }
  return common.empty() || all_shared ? TriangleOverlap::none : TriangleOverlap::crossing;
}

TEST(TriangleOverlapTest, finds_what_clipping_finds_on_a_coarse_grid) {
  std::mt19937 random(13);
  std::array<int, 3> seen{};
  std::array<int, 4> shared{};
  int apart = 0;
  for (int round = 0; round < 20000; ++round) {
    std::vector<Vec3> points;
    std::array<Triangle, 2> triangles{};
    std::array<Corners, 2> corners;
    for (std::size_t t = 0; t < 2; ++t) {
      do {
        for (Vec3& p : corners[t]) {
          p = Vec3(static_cast<double>(random() % 4), static_cast<double>(random() % 4),
                   static_cast<double>(random() % 3 / 2));
        }
      } while ((corners[t][1] - corners[t][0]).cross(corners[t][2] - corners[t][0]).isZero(0));
      for (std::size_t k = 0; k < 3; ++k) {
        auto at = std::ranges::find(points, corners[t][k]);
        triangles[t][k] = static_cast<std::uint32_t>(at - points.begin());
        if (at == points.end()) {
          points.push_back(corners[t][k]);
        }
      }
    }
    const std::size_t common = 6 - points.size();
    if (common == 3) {
      continue;  // the same triangle, which faces of a mesh are never asked about
    }
    ++shared[common];
    const TriangleOverlap expected = expected_overlap(corners[0], corners[1]);
    ++seen[static_cast<std::size_t>(expected)];
    ASSERT_EQ(TriangleOverlapTest(points, triangles[0]).meeting(triangles[1]), expected) << round;
    ASSERT_EQ(TriangleOverlapTest(points, triangles[1]).meeting(triangles[0]), expected) << round;
    const bool is_apart =
        TriangleOverlapTest(points, triangles[0]).certainly_apart_from(corners[1]);
    ASSERT_FALSE(is_apart && (common > 0 || expected != TriangleOverlap::none)) << round;
    apart += is_apart ? 1 : 0;
  }
  EXPECT_GT(apart, 1000);
  for (const int count : seen) {
    EXPECT_GT(count, 500) << "each kind occurs";
  }
  for (std::size_t common = 0; common < 3; ++common) {
    EXPECT_GT(shared[common], 300) << "so does each number of shared corners";
  }
}

// Far from the origin, where products are rounded by far more than what the triangles are apart.
TEST(TriangleOverlapTest, tells_long_triangles_that_pass_over_each_other_exactly) {
  for (const double far : {1.0, 1e5, 1e9}) {
    const double ulp = std::nextafter(far, 2 * far) - far;
    for (const int steps : {-2, -1, 0, 1, 2}) {
      const double height = far + steps * ulp;
      const std::vector<Vec3> points = {{far, far, far},
                                        {9 * far, far, far},
                                        {5 * far, far, 2 * far},
                                        {5 * far, -3 * far, height},
                                        {5 * far, 5 * far, height},
                                        {5 * far, far, -far}};
      const TriangleOverlapTest test(points, {0, 1, 2});
      EXPECT_EQ(test.meeting({3, 4, 5}),
                steps < 0 ? TriangleOverlap::none : TriangleOverlap::crossing)
          << far << " " << steps;
    }
  }
}

TEST(TriangleOverlapTest, collinear_means_exactly) {
  const Vec3 a(0.1, 0.2, 0.3);
  EXPECT_TRUE(collinear(a, 2 * a, 4 * a));
  EXPECT_TRUE(collinear(a, a, Vec3(7, 8, 9)));
  Vec3 beside = 4 * a;
  beside.z() = std::nextafter(beside.z(), 2);
  EXPECT_FALSE(collinear(a, 2 * a, beside));
}

TEST(TriangleOverlapTest, sides_of_lines_are_exact) {
  const Vec3 a(0.1, 0.1, 0), b(0.3, 0.3, 0);
  EXPECT_EQ(exact_side_of_line(a, b, Vec3(0.2, 0.2, 5), 2), 0);
  EXPECT_EQ(exact_side_of_line(a, b, Vec3(0.2, std::nextafter(0.2, 1), 5), 2), 1);
  EXPECT_EQ(exact_side_of_line(a, b, Vec3(0.2, std::nextafter(0.2, 0), 5), 2), -1);
}

}  // namespace
}  // namespace dupin::predicates
