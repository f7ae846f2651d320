#include <random>

#include <gtest/gtest.h>

#include "arrangement/faces/plane_frame.h"

namespace dupin::arrangement {
namespace {

// Distances in the plane are those in space, and turns are those seen from the front.
TEST(PlaneFrame, keeps_distances_and_turns) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-5, 5);
  const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
  for (int i = 0; i < 200; ++i) {
    const Vec3 a = vector(), b = vector(), c = vector();
    const PlaneFrame plane(a, b, c);
    EXPECT_EQ(plane.at(a), (std::array{0.0, 0.0}));
    const auto [x, y] = plane.at(b);
    const auto [u, v] = plane.at(c);
    EXPECT_NEAR(x, (b - a).norm(), 1e-12);
    EXPECT_NEAR(y, 0, 1e-12);
    EXPECT_NEAR(u * u + v * v, (c - a).squaredNorm(), 1e-10);
    EXPECT_GT(v, 0);
  }
}

}  // namespace
}  // namespace dupin::arrangement
