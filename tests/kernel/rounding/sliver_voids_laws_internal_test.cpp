// Slits between random ends of one ring, filled, against the solid that has no ends there.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "mesh/coincident_points.h"
#include "rounding/sliver_voids.h"

namespace dupin::rounding {
namespace {

constexpr double kTip = 16;

/// The triangles of a random triangulation of a convex polygon with corners 0 .. n - 1.
std::vector<Triangle> triangulation(std::uint32_t n, std::mt19937& random) {
  std::vector<std::uint32_t> left;
  for (std::uint32_t i = 0; i < n; ++i) {
    left.push_back(i);
  }
  std::vector<Triangle> triangles;
  while (left.size() > 2) {
    const std::size_t m = left.size(), i = random() % m;
    triangles.push_back({left[(i + m - 1) % m], left[i], left[(i + 1) % m]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return triangles;
}

/// A ring about the z axis at random heights, and the tips below and above it.
std::vector<Vec3> points(std::uint32_t n, std::mt19937& random) {
  std::vector<Vec3> result;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    const double height = static_cast<double>(random() % 9) / 8;
    result.emplace_back(std::round(4096 * std::cos(angle)) / 4096,
                        std::round(4096 * std::sin(angle)) / 4096, height);
  }
  result.emplace_back(0, 0, -kTip);
  result.emplace_back(0, 0, kTip);
  return result;
}

/// The sides that join the ring to one of the tips.
std::vector<Triangle> sides(std::uint32_t n, bool is_high) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    triangles.push_back(is_high ? Triangle{i, j, n + 1} : Triangle{j, i, n});
  }
  return triangles;
}

TEST(FilledSlits, leave_the_solid_around_them) {
  std::mt19937 random(11);
  std::size_t several = 0, touching = 0;
  for (int round = 0; round < 300; ++round) {
    const std::uint32_t n = 4 + static_cast<std::uint32_t>(round) % 12;
    TriMesh low, high, whole;
    low.points = high.points = whole.points = points(n, random);
    low.triangles = sides(n, false);
    high.triangles = sides(n, true);
    whole.triangles = low.triangles;
    whole.triangles.insert(whole.triangles.end(), high.triangles.begin(), high.triangles.end());
    for (const Triangle& t : triangulation(n, random)) {
      low.triangles.push_back(t);
    }
    for (const Triangle& t : triangulation(n, random)) {
      high.triangles.push_back({t[0], t[2], t[1]});
    }
    const std::vector<Solid> parts = {Solid::from(low), Solid::from(high)};
    const Solid united = unite(parts), expected = Solid::from(whole);
    const auto filled =
        SliverVoids(united.exact(), mesh::coincident_representatives(united.exact()), kTip)
            .filled(kTip);
    ASSERT_EQ(filled.has_value(), united.exact_volume() != expected.exact_volume()) << round;
    if (!filled) {
      continue;
    }
    const Solid result(std::make_shared<const mesh::ExactMesh>(filled->mesh));
    ASSERT_EQ(result.exact_volume(), expected.exact_volume()) << round;
    ASSERT_TRUE(result.contacts().empty()) << round;
    ASSERT_EQ(result.shells(), 1) << round;
    ASSERT_EQ(result.genus(), 0) << round;
    ASSERT_TRUE(subtract(result, std::vector{expected}).empty()) << round;
    several += filled->places.size() > 1 ? 1 : 0;
    touching += united.contacts().empty() ? 0 : 1;
  }
  EXPECT_GT(several, 50);
  EXPECT_GT(touching, 100);
}

}  // namespace
}  // namespace dupin::rounding
