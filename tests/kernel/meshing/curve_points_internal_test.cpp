#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "meshing/curve_points.h"
#include "support/shapes.h"

namespace dupin::meshing {
namespace {

struct Case {
  explicit Case(TriMesh given, double largest = 1, double distance = 0.01)
      : mesh(std::move(given)),
        features(find_features(mesh, 0.7, 0.01, 0)),
        surface(mesh.points, mesh.triangles, features.regions),
        lengths(surface, features, distance, largest),
        shares(features.curves.size(), 1) {}
  [[nodiscard]] CurvePoints points(std::size_t most = 10'000) const {
    return points_along(features, lengths, shares, most);
  }
  TriMesh mesh;
  Features features;
  mesh::ReferenceSurface surface;
  EdgeLengths lengths;
  std::vector<double> shares;
};

bool share_a_region(const Curve& a, const Curve& b) {
  return a.regions[0] == b.regions[0] || a.regions[0] == b.regions[1] ||
         a.regions[1] == b.regions[0] || a.regions[1] == b.regions[1];
}

/// Balls of neighbours overlap without holding each other's centre, and no others that regions
/// have in common do.
void expect_protected(const Case& given, const CurvePoints& made) {
  ASSERT_EQ(made.chains.size(), given.features.curves.size());
  const auto distance = [&](std::uint32_t i, std::uint32_t k) {
    return (made.points[i].place - made.points[k].place).norm();
  };
  for (std::size_t c = 0; c < made.chains.size(); ++c) {
    const std::vector<std::uint32_t>& chain = made.chains[c];
    ASSERT_GE(chain.size(), 3U);
    EXPECT_EQ(made.points[chain.front()].place, given.features.curves[c].points.front());
    EXPECT_EQ(made.points[chain.back()].place, given.features.curves[c].points.back());
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const double r = made.points[chain[i - 1]].radius, s = made.points[chain[i]].radius;
      EXPECT_GT(r + s, distance(chain[i - 1], chain[i]));
      EXPECT_LT(std::max(r, s), distance(chain[i - 1], chain[i]));
    }
    for (std::size_t d = c; d < made.chains.size(); ++d) {
      if (!share_a_region(given.features.curves[c], given.features.curves[d])) {
        continue;
      }
      for (std::size_t i = 0; i < chain.size(); ++i) {
        for (std::size_t k = 0; k < made.chains[d].size(); ++k) {
          const std::uint32_t p = chain[i], q = made.chains[d][k];
          const bool at_loops_end = c == d && std::max(i, k) + 2 >= chain.size() &&
                                    std::min(i, k) <= 1 && chain.front() == chain.back();
          if (p != q && (c != d || std::max(i, k) - std::min(i, k) > 1) && !at_loops_end &&
              q != made.chains[c][i > 0 ? i - 1 : 0] &&
              q != made.chains[c][std::min(i + 1, chain.size() - 1)] &&
              p != made.chains[d][k > 0 ? k - 1 : 0] &&
              p != made.chains[d][std::min(k + 1, made.chains[d].size() - 1)]) {
            EXPECT_LT(made.points[p].radius + made.points[q].radius, distance(p, q))
                << "curves " << c << " " << d << " points " << i << " " << k;
          }
        }
      }
    }
  }
}

TEST(CurvePoints, protect_the_edges_of_a_box) {
  const Case box(test::box(Vec3::Zero(), Vec3(4, 2, 0.1)));
  const CurvePoints made = box.points();
  expect_protected(box, made);
  std::size_t corners = 0;
  for (const CurvePoint& point : made.points) {
    corners += point.is_corner ? 1 : 0;
  }
  EXPECT_EQ(corners, 8U);
}

TEST(CurvePoints, protect_loops_and_have_no_corners_there) {
  const Case tube(test::tube(2, 0, 1, 64));
  const CurvePoints made = tube.points();
  expect_protected(tube, made);
  for (const CurvePoint& point : made.points) {
    EXPECT_FALSE(point.is_corner);
    EXPECT_LT(std::abs(std::hypot(point.place.x(), point.place.y()) - 2), 0.01);
  }
}

TEST(CurvePoints, protect_edges_that_meet_at_a_small_angle) {
  // A wedge of some 6 degrees.
  TriMesh wedge = test::box(Vec3::Zero(), Vec3(2, 2, 1));
  for (Vec3& p : wedge.points) {
    p.z() *= p.x() > 0 ? 1 : 0.8;
    p.y() *= p.x() > 0 ? 0.1 : 1e-3;
  }
  const Case given(wedge);
  expect_protected(given, given.points());
}

/// A prism over what is below a polyline from the origin, up to x = 4, and above the x-axis.
TriMesh prism_below(const std::vector<std::array<double, 2>>& line, double height) {
  TriMesh mesh;
  const auto n = static_cast<std::uint32_t>(line.size());
  for (const double z : {0.0, height}) {
    for (const auto& [x, y] : line) {
      mesh.points.emplace_back(x, 0, z);
      mesh.points.emplace_back(x, y, z);
    }
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    for (const Triangle& t : {Triangle{a, b, c}, Triangle{a, c, d}}) {
      mesh.triangles.push_back(t);
    }
  };
  const std::uint32_t up = 2 * n;
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    const std::uint32_t a = 2 * i, b = a + 2;
    add(a, a + 1, b + 1, b);
    add(up + a, up + b, up + b + 1, up + a + 1);
    add(a, b, up + b, up + a);
    add(b + 1, a + 1, up + a + 1, up + b + 1);
  }
  add(2 * n - 2, 2 * n - 1, up + 2 * n - 1, up + 2 * n - 2);
  // The first points of the line and of the axis are one.
  for (Triangle& t : mesh.triangles) {
    std::ranges::replace(t, 1U, 0U);
    std::ranges::replace(t, up + 1, up);
  }
  std::erase_if(mesh.triangles,
                [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  return mesh;
}

TEST(CurvePoints,
     get_nearer_each_other_step_by_step_from_a_corner_to_where_two_curves_nearly_meet) {
  // Two curves from one corner come near each other again, further along.
  const Case given(prism_below({{0, 0},
                                {0.3, 0.5},
                                {0.6, 0.62},
                                {0.7, 0.61},
                                {0.8, 0.55},
                                {0.95, 0.38},
                                {1.1, 0.13},
                                {1.25, 0.03},
                                {1.45, 0.03},
                                {1.7, 0.15},
                                {2.2, 0.6},
                                {4, 2}},
                               4),
                   1, 1);
  const CurvePoints made = given.points();
  expect_protected(given, made);
  for (const auto& chain : made.chains) {
    for (std::size_t i = 2; i < chain.size(); ++i) {
      const Vec3 &p = made.points[chain[i - 2]].place, &q = made.points[chain[i - 1]].place,
                 &r = made.points[chain[i]].place;
      const double ratio = (r - q).norm() / (q - p).norm();
      EXPECT_LT(std::max(ratio, 1 / ratio), 2.2) << q.transpose();
    }
  }
}

TEST(CurvePoints, do_not_mind_curves_without_a_region_in_common) {
  // The outer rims of two tubes whose ends nearly touch, and one alone.
  const double gap = 0.01;
  const Case alone(test::tube(2, 0, 3, 64)),
      both(test::joined({test::tube(2, 0, 3, 64), test::tube(2, 3 + gap, 6, 64)}));
  const CurvePoints one = alone.points(), two = both.points();
  EXPECT_EQ(two.points.size(), 2 * one.points.size());
  expect_protected(both, two);
}

TEST(CurvePoints, are_nearer_each_other_where_less_is_asked_for) {
  Case tube(test::tube(2, 0, 4, 64));
  const std::size_t before = tube.points().chains[0].size();
  tube.shares[0] = 0.5;
  EXPECT_GT(tube.points().chains[0].size(), before * 3 / 2);
}

TEST(CurvePoints, more_than_are_allowed_are_refused_with_a_place) {
  const Case box(test::box(Vec3::Zero(), Vec3(4, 2, 1)), 0.01);
  try {
    (void)box.points(10);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
    EXPECT_NE(std::string(error.what()).find("near "), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace dupin::meshing
