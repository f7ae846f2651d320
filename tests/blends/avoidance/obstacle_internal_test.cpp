#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "avoidance/obstacle.h"
#include "blends/tubes.h"
#include "dupin/kernel/error.h"
#include "support/shapes.h"
#include "surfaces/pieces/surface_piece.h"

namespace dupin::avoidance {
namespace {

const Obstacle kBall{{0, 0, 0}, {}, 1}, kCapsule{{0, 0, 0}, {{4, 0, 0}}, 1},
    kBox{{0, 0, 0}, {{4, 0, 0}, {0, 2, 0}, {0, 0, 1}}, 0};

TEST(Obstacle, has_nearest_points) {
  EXPECT_EQ(nearest_core_point(kBall, {5, 6, 7}), Vec3(0, 0, 0));
  EXPECT_EQ(nearest_core_point(kCapsule, {3, 6, 7}), Vec3(3, 0, 0));
  EXPECT_EQ(nearest_core_point(kCapsule, {-3, 6, 7}), Vec3(0, 0, 0));
  EXPECT_EQ(nearest_core_point(kBox, {5, 1, -7}), Vec3(4, 1, 0));
  EXPECT_EQ(nearest_core_point(kBox, {1, 1, 0.5}), Vec3(1, 1, 0.5));
}

// [mathematics A8]: closed forms of discs and balls.
TEST(Obstacle, is_approached_by_discs) {
  const TravelRing disc{{0, 0, 5}, Vec3::UnitZ(), 2};
  EXPECT_NEAR(approach(disc, kBall).distance, 4, 1e-14);
  EXPECT_NEAR(approach({{5, 0, 3}, Vec3::UnitZ(), 1}, kBall).distance, 5 - 1, 1e-12);  // 4, 0, 3
  EXPECT_NEAR(approach(disc, kCapsule).distance, 4, 1e-14);
  EXPECT_NEAR(approach(disc, kBox).distance, 4, 1e-14);
  EXPECT_NEAR(approach({{2, 1, 9}, Vec3::UnitX(), 3}, kBox).distance, 5, 1e-9);
  EXPECT_LE(approach({{2, 1, 2}, Vec3::UnitX(), 3}, kBox).distance, 1e-9);
}

// The bound never exceeds the distance of any two points, and nearly attains it.
TEST(Obstacle, is_separated_by_no_more_than_it_is_apart) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> at(-6, 6);
  const auto point = [&] { return Vec3(at(random), at(random), at(random)); };
  int close = 0;
  for (int i = 0; i < 300; ++i) {
    const Obstacle obstacle{point(),
                            i % 3 == 0   ? std::vector<Vec3>{}
                            : i % 3 == 1 ? std::vector<Vec3>{point()}
                                         : std::vector<Vec3>{point(), point(), point()},
                            i % 2 == 0 ? 0.5 : 0.0};
    const RingedSurface tube = test::cylinder(point(), point() + Vec3(0, 0, 0.1), 0.7);
    const TravelRing disc{(tube.start.center + tube.end.center) / 2, tube.end.normal, 0.7};
    const Approach found = approach(disc, obstacle);
    const double bound =
        separation(surfaces::discs(tube).hull({0.49, 0.51}), obstacle, found.direction);
    EXPECT_LE(bound, found.distance + 1e-9);
    for (int k = 0; k < 100; ++k) {
      Vec3 inside = obstacle.corner;
      for (const Vec3& edge : obstacle.edges) {
        inside += (at(random) + 6) / 12 * edge;
      }
      const Vec3 first = disc.normal.unitOrthogonal();
      const Vec3 out = std::cos(k) * first + std::sin(k) * disc.normal.cross(first);
      EXPECT_LE(bound, (disc.center + 0.7 * out - inside).norm() - obstacle.radius + 1e-12);
    }
    close += found.distance > 0.1 && bound > found.distance - 0.3 ? 1 : 0;
  }
  EXPECT_GT(close, 100);
}

TEST(Obstacle, is_not_separated_by_no_direction) {
  const surfaces::DiscHull hull =
      surfaces::discs(test::cylinder({9, 9, 9}, {9, 9, 12}, 1)).hull({0, 1});
  EXPECT_EQ(separation(hull, kBall, {0, 0, 0}), -std::numeric_limits<double>::infinity());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(separation(hull, kBall, {nan, 0, 0}) > -1e300);
}

// By points of the triangle, and the regions of its corners and sides.
TEST(Obstacle, may_be_a_triangle) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> at(-3, 3), share(0, 1);
  const auto point = [&] { return Vec3(at(random), at(random), at(random)); };
  for (int i = 0; i < 200; ++i) {
    const Vec3 a = point(), b = point(), c = point(), p = point();
    const Obstacle triangle{a, {b - a, c - a}, 0, true};
    const Vec3 nearest = nearest_core_point(triangle, p);
    const RingedSurface tube = test::cylinder(p, p + Vec3(0, 0, 0.1), 0.2);
    const double bound = separation(surfaces::discs(tube).hull({0, 1}), triangle, nearest - p);
    for (int k = 0; k < 50; ++k) {
      double s = share(random), t = share(random);
      if (s + t > 1) {
        s = 1 - s, t = 1 - t;
      }
      const Vec3 inside = a + s * (b - a) + t * (c - a);
      EXPECT_LE((nearest - p).norm(), (inside - p).norm() + 1e-12);
      EXPECT_LE(bound, (inside - p).norm() - 0 + 1e-12);
    }
    EXPECT_NEAR((b - a).cross(c - a).normalized().dot(nearest - a), 0, 1e-12);
  }
}

TEST(Obstacle, of_a_mesh_is_boxes_that_hold_its_triangles) {
  const TriMesh mesh = test::tube(2, 0, 7, 40);
  const NamedObstacle obstacle = obstacle_of("m", mesh);
  std::size_t triangles = 0;
  const auto walk = [&](const auto& self, const Obstacle& box,
                        const std::vector<ObstacleBox>& parts) -> void {
    for (const ObstacleBox& part : parts) {
      if (part.parts.empty()) {
        ++triangles;
        EXPECT_TRUE(part.shape.is_triangle);
      }
      for (const Vec3& corner : {part.shape.corner, Vec3(part.shape.corner + part.shape.edges[0]),
                                 Vec3(part.shape.corner + part.shape.edges[1])}) {
        EXPECT_LT((nearest_core_point(box, corner) - corner).norm(), 1e-12);
      }
      self(self, part.shape, part.parts);
    }
  };
  walk(walk, obstacle.shape, obstacle.parts);
  EXPECT_EQ(triangles, mesh.triangles.size());
  EXPECT_THROW((void)obstacle_of("m", TriMesh{}), Error);
  TriMesh bad = mesh;
  bad.points[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)obstacle_of("m", bad), Error);
}

TEST(Obstacle, of_a_part_contains_it) {
  const RingedSurface bend = test::elbow(10, 2, 3);
  const auto stretches = obstacles_of("bend", Chain(bend));
  for (int i = 0; i <= 50; ++i) {
    const double angle = 2 * i / 50.;
    for (int k = 0; k < 8; ++k) {
      const double around = k * std::numbers::pi / 4, out = 10 + 3 * std::cos(around);
      const Vec3 point(out * std::cos(angle), out * std::sin(angle), 3 * std::sin(around));
      double least = std::numeric_limits<double>::infinity();
      for (const NamedObstacle& stretch : stretches) {
        EXPECT_EQ(stretch.name, "bend");
        least = std::min(least, (point - nearest_core_point(stretch.shape, point)).norm() -
                                    stretch.shape.radius);
      }
      EXPECT_LE(least, 1e-12);
      EXPECT_GE(least, -0.5);  // and not much more
    }
  }
  EXPECT_EQ(obstacles_of("pipe", Chain(test::cylinder({0, 0, 0}, {9, 0, 0}, 1))).size(), 1);
  EXPECT_EQ(obstacles_of("ball", Sphere{{0, 0, 0}, 1}).size(), 1);
}

}  // namespace
}  // namespace dupin::avoidance
