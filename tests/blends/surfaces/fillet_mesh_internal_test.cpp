#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "surfaces/fillet_mesh.h"

namespace dupin::surfaces {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

std::array<Ring, 2> cylinders(double first, double second, double angle, double apart = 0) {
  return {Ring{{0, 0, 0}, {1, 0, 0}, first},
          Ring{{0, 0, apart}, {std::cos(angle), std::sin(angle), 0}, second}};
}

// How far a point is outside of the union of the balls; negative inside.
double off(const CanalFillet& loop, const Vec3& point) {
  const auto beyond = [&](double t) {
    const MovingBall at = ball(loop, t);
    return (point - at.center).norm() - at.radius;
  };
  constexpr int kSamples = 2000;
  double nearest = 0, step = kTurn / kSamples;
  for (int i = 0; i < kSamples; ++i) {
    nearest = beyond(i * step) < beyond(nearest) ? i * step : nearest;
  }
  for (; step > 1e-8; step /= 2) {
    nearest = beyond(nearest - step) < beyond(nearest) ? nearest - step : nearest;
    nearest = beyond(nearest + step) < beyond(nearest) ? nearest + step : nearest;
  }
  return beyond(nearest);
}

double area(const TriMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm() / 2;
  }
  return sum;
}

std::vector<CanalFillet> samples() {
  std::vector<CanalFillet> result;
  for (const auto& [quadrics, radius] :
       {std::pair(cylinders(2, 1, kTurn / 4), 0.3), std::pair(cylinders(2, 1.9, kTurn / 9), 0.2),
        std::pair(cylinders(2, 2, kTurn / 6), 0.5), std::pair(cylinders(2, 1.5, 1, 0.5), 0.4),
        std::pair(cylinders(2, 1.8, kTurn / 4, 0.8), 0.3)}) {
    const auto loops = rolling_ball_fillets(quadrics, radius);
    result.insert(result.end(), loops.begin(), loops.end());
  }
  const Ring cone{{0, 0, 3}, {0, 0, 1}, 1, -0.3};
  result.push_back(rolling_ball_fillets({cylinders(2, 1, 1)[0], cone}, 0.4).front());
  result.push_back(rational_fillet(cylinders(2, 1, 1.2), {0.5, 0.3, 0.2, 0.4}, 1));
  return result;
}

// Sampled points of the triangles are no further from the balls than is said, and that is not far
// more than they are.
TEST(FilletMesh, is_as_near_to_the_balls_as_it_says) {
  for (const CanalFillet& loop : samples()) {
    const FilletMesh mesh = fillet_mesh(loop, {0.02, {0.2, 0.2}});
    const auto& [points, triangles, labels, names] = mesh.tessellation.mesh;
    EXPECT_LE(mesh.tessellation.error_bound, 0.02);
    double furthest = 0;
    for (std::size_t i = 0; i < triangles.size(); i += 1 + triangles.size() / 50) {
      const Vec3 &a = points[triangles[i][0]], &b = points[triangles[i][1]],
                 &c = points[triangles[i][2]];
      for (const Vec3& p :
           {Vec3((a + b + c) / 3), Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((a + c) / 2)}) {
        furthest = std::max(furthest, std::abs(off(loop, p)));
      }
    }
    EXPECT_LE(furthest, mesh.tessellation.error_bound);
    EXPECT_GT(furthest, mesh.tessellation.error_bound / 20);
  }
}

// Open along the feet and nowhere else; every triangle looks to the balls.
TEST(FilletMesh, is_a_strip_between_its_feet) {
  for (const CanalFillet& loop : samples()) {
    const FilletMesh mesh = fillet_mesh(loop, {0.05, {0.3, 0.3}, 0x1p-16});
    const auto& [points, triangles, labels, names] = mesh.tessellation.mesh;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const Triangle& t : triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        ++sides[{t.at(i), t.at((i + 1) % 3)}];
      }
      const Vec3 middle = (points[t[0]] + points[t[1]] + points[t[2]]) / 3;
      const Vec3 up = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
      EXPECT_LT(off(loop, middle + 1e-4 * up.normalized()), off(loop, middle));
    }
    std::size_t open = 0;
    for (const auto& [side, count] : sides) {
      EXPECT_EQ(count, 1);
      open += sides.contains({side.second, side.first}) ? 0 : 1;
    }
    EXPECT_EQ(open, mesh.feet[0].size() + mesh.feet[1].size());
    for (const auto& feet : mesh.feet) {
      for (std::size_t i = 0; i < feet.size(); ++i) {
        EXPECT_NE(feet[i], feet[(i + 1) % feet.size()]);
        EXPECT_EQ(snapped(feet[i], 0x1p-16), feet[i]);
        EXPECT_TRUE(std::ranges::find(points, feet[i]) != points.end());
      }
    }
  }
}

// Mathematics B.9, R2.
TEST(FilletMesh, tends_to_the_area_of_the_oracle_at_second_order) {
  constexpr double kArea = 4.99814121848321;
  const CanalFillet loop = rolling_ball_fillets(cylinders(2, 1, kTurn / 6), 0.5).front();
  const auto fault = [&](double tolerance) {
    return std::abs(area(fillet_mesh(loop, {tolerance, {1, 1}}).tessellation.mesh) - kArea);
  };
  EXPECT_LT(fault(1e-5), 2e-4 * kArea);
  EXPECT_LT(fault(1e-5), fault(1e-3) / 30) << "errors are as tolerances";
}

TEST(FilletMesh, keeps_the_feet_as_near_as_they_are_asked_to_be) {
  const CanalFillet loop = rolling_ball_fillets(cylinders(2, 1, 1), 0.2).front();
  for (const auto& turns : {std::array{0.05, 1.0}, std::array{1.0, 0.05}}) {
    const FilletMesh mesh = fillet_mesh(loop, {0.1, turns});
    for (std::size_t side = 0; side < 2; ++side) {
      const Vec3& axis = loop.quadrics.at(side).normal;
      const auto& feet = mesh.feet.at(side);
      double widest = 0;
      for (std::size_t i = 0; i < feet.size(); ++i) {
        const Vec3 a = axis.cross(feet[i] - loop.quadrics.at(side).center),
                   b = axis.cross(feet[(i + 1) % feet.size()] - loop.quadrics.at(side).center);
        widest = std::max(widest, std::atan2(a.cross(b).norm(), a.dot(b)));
      }
      EXPECT_LE(widest, turns.at(side) + 1e-12);
    }
  }
}

TEST(FilletMesh, refuses_what_is_too_fine) {
  const CanalFillet loop = rolling_ball_fillets(cylinders(2, 1, 1), 0.2).front();
  const auto refusal = [&](const FilletSampling& sampling) {
    try {
      (void)fillet_mesh(loop, sampling);
    } catch (const Error& error) {
      return error.code();
    }
    return Errc::internal;
  };
  EXPECT_EQ(refusal({1e-3, {1, 1}, 0, 100}), Errc::limit_exceeded);
  EXPECT_EQ(refusal({1e-15, {1, 1}}), Errc::invalid_argument) << "below rounding";
}

}  // namespace
}  // namespace dupin::surfaces
