#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "blends/verification/solids_internal.h"
#include "support/cyclide_cases.h"
#include "verification/mesh_claim.h"

namespace dupin::verification {
namespace {

using std::numbers::pi;

MeshClaim claim(std::uint32_t segments, const std::vector<double>& knots, double error_bound,
                double grid = 0) {
  return {segments, grid, knots, error_bound};
}

double sagitta(double radius, int segments) { return radius * (1 - std::cos(pi / segments)); }

std::vector<double> equal_knots(int bands) {
  std::vector<double> knots;
  for (int i = 0; i <= bands; ++i) {
    knots.push_back(double(i) / bands);
  }
  return knots;
}

// The least bound that follows, to 1e-3 of it.
double least_bound(const Solid& solid, MeshClaim about) {
  double low = 0, high = 1e3;
  about.error_bound = high;
  EXPECT_TRUE(follows(solid, about));
  while (high - low > 1e-3 * high) {
    about.error_bound = (low + high) / 2;
    (follows(solid, about) ? high : low) = about.error_bound;
  }
  return high;
}

// How far the middles of the facets of the elbow's mesh are from its torus; frames do not turn.
double measured(double bend, double angle, double radius, int segments, int bands) {
  const auto point = [&](double t, double u) {
    const double out = bend + radius * std::cos(u), a = angle * t;
    return Vec3(out * std::cos(a), out * std::sin(a), radius * std::sin(u));
  };
  double most = 0;
  for (int i = 0; i < bands; ++i) {
    for (int j = 0; j < segments; ++j) {
      const double t0 = double(i) / bands, t1 = double(i + 1) / bands;
      const double u0 = 2 * pi * j / segments, u1 = 2 * pi * (j + 1) / segments;
      const Vec3 a = point(t0, u0), b = point(t1, u0), c = point(t1, u1), d = point(t0, u1);
      for (const Vec3& x : {Vec3((a + b + c) / 3), Vec3((a + c + d) / 3), Vec3((a + c) / 2),
                            Vec3((a + b) / 2), Vec3((a + d) / 2)}) {
        const double off = std::hypot(std::hypot(x.x(), x.y()) - bend, x.z()) - radius;
        most = std::max(most, std::abs(off));
      }
    }
  }
  return most;
}

TEST(MeshClaim, of_a_cylinder_is_its_sagitta) {
  const Solid solid = test::solid(test::cylinder({0, 0, 0}, {9, 1, 2}, 2));
  for (const int segments : {3, 8, 64}) {
    const auto n = std::uint32_t(segments);
    EXPECT_TRUE(follows(solid, claim(n, {0, 1}, sagitta(2, segments) + 1e-12)));
    EXPECT_FALSE(follows(solid, claim(n, {0, 1}, sagitta(2, segments) - 1e-12)));
  }
}

TEST(MeshClaim, of_a_cone_is_the_sagitta_of_its_larger_ring) {
  const Solid solid = test::solid(test::cone({0, 0, 0}, {9, 1, 2}, .5, 2));
  EXPECT_TRUE(follows(solid, claim(16, {0, 1}, sagitta(2, 16) + 1e-12)));
  EXPECT_FALSE(follows(solid, claim(16, {0, 1}, sagitta(2, 16) - 1e-12)));
}

TEST(MeshClaim, of_similar_ellipses_needs_the_larger_sagitta_of_others_nothing_follows) {
  EllipticTube tube;
  tube.start = {Vec3(0, 0, 0), -Vec3::UnitX(), 2, 0, Ellipse{Vec3::UnitY(), 1, 0}};
  tube.end = {Vec3(5, 0, 0), Vec3::UnitX(), 4, 0, Ellipse{Vec3::UnitY(), 2, 0}};
  tube.spine = LineSpine{Vec3(0, 0, 0), Vec3(5, 0, 0)};
  tube.first = LinearRadius{2, 4};
  tube.second = LinearRadius{1, 2};
  tube.axis = Vec3::UnitY();
  EXPECT_TRUE(follows(test::solid(tube), claim(16, {0, 1}, sagitta(4, 16) + 1e-12)));
  EXPECT_FALSE(follows(test::solid(tube), claim(16, {0, 1}, sagitta(4, 16) - 1e-12)));
  tube.end.ellipse->across = 2.5;  // no longer similar: rows of facets would be twisted
  EXPECT_FALSE(follows(test::solid(tube), claim(16, {0, 1}, 100)));
}

TEST(MeshClaim, of_an_elbow_is_no_less_than_its_mesh_has) {
  const double bend = 4, angle = 1.5, radius = 1;
  const Solid solid = test::solid(test::elbow(bend, angle, radius));
  for (const auto& [segments, bands] : {std::pair(16, 8), {32, 8}, {64, 32}}) {
    const double least = least_bound(solid, claim(std::uint32_t(segments), equal_knots(bands), 0));
    EXPECT_GE(least, measured(bend, angle, radius, segments, bands));
    // dt^2 Mtt + 2 dt du Mtu + du^2 Muu, by the spine's length, on which the facets' middles take
    // but the first and last term; du includes what the last ring may be turned by.
    const double dt = angle * bend / bands, du = (2 + 1. / bands) * pi / segments;
    const double along = (1 + radius / bend) / bend, mixed = radius / bend;
    const double expected = (dt * dt * along + 2 * dt * du * mixed + du * du * radius) / 8;
    EXPECT_LE(least, 1.1 * expected);
    EXPECT_GE(least, 0.99 * expected) << "all three terms";
  }
}

TEST(MeshClaim, of_a_cyclide_is_that_of_the_torus_it_is) {
  const PeArc arc = PeArc::from(test::sphere(4, 0, 0, 1), test::direction(Vec3::UnitY(), 0),
                                test::sphere(0, 4, 0, 1));
  const double least =
      least_bound(test::solid(test::cyclide_piece(arc)), claim(32, equal_knots(16), 0));
  EXPECT_GE(least, measured(4, pi / 2, 1, 32, 16));
  EXPECT_LE(least, 3 * measured(4, pi / 2, 1, 32, 16));
}

TEST(MeshClaim, of_a_sphere_is_the_distance_of_its_nearest_facet) {
  const Solid solid = test::ball({0, 0, 0}, 3);
  // A cube-like graticule: quadrilaterals of the equator's band and triangles at the poles.
  for (const int segments : {4, 8, 33}) {
    const auto n = std::uint32_t(segments);
    const int bands = (segments + 1) / 2;
    double nearest = 1;
    for (int i = 0; i < bands; ++i) {
      const auto corner = [&](int row, int column) {
        const double a = pi * row / bands, b = 2 * pi * column / segments;
        return Vec3(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
      };
      const bool is_north = 2 * i < bands;  // the triangle with two corners on the larger row
      const Vec3 a = corner(is_north ? i + 1 : i, 0), b = corner(is_north ? i + 1 : i, 1),
                 c = corner(is_north ? i : i + 1, 0);
      nearest = std::min(nearest, std::abs((b - a).cross(c - a).normalized().dot(a)));
    }
    const double sag = 3 * (1 - nearest);
    EXPECT_TRUE(follows(solid, claim(n, {}, sag + 1e-9))) << segments;
    EXPECT_FALSE(follows(solid, claim(n, {}, sag - 1e-9))) << segments;
  }
  EXPECT_FALSE(follows(solid, claim(2, {}, 100)));
  EXPECT_FALSE(follows(solid, claim(8, {0, 1}, 100)));
}

TEST(MeshClaim, adds_half_the_diagonal_of_the_grids_cell) {
  const double grid = .01, half = std::sqrt(3.) / 2 * grid;
  const Solid pipe = test::solid(test::cylinder({0, 0, 0}, {9, 1, 2}, 2));
  EXPECT_TRUE(follows(pipe, claim(64, {0, 1}, sagitta(2, 64) + half + 1e-12, grid)));
  EXPECT_FALSE(follows(pipe, claim(64, {0, 1}, sagitta(2, 64) + half - 1e-12, grid)));
  const Solid ball = test::ball({0, 0, 0}, 3);
  const double plain = least_bound(ball, claim(16, {}, 0));
  EXPECT_NEAR(least_bound(ball, claim(16, {}, 0, grid)), plain + half, 2e-3 * plain);
}

TEST(MeshClaim, adds_the_rounding_of_large_coordinates) {
  const double far = 1e12, rounding = std::ldexp(far, -47);
  const Solid solid = test::solid(test::cylinder({far, 0, 0}, {far + 8, 0, 0}, 2));
  EXPECT_TRUE(follows(solid, claim(64, {0, 1}, sagitta(2, 64) + 1.01 * rounding)));
  EXPECT_FALSE(follows(solid, claim(64, {0, 1}, sagitta(2, 64) + .99 * rounding)));
}

// Multiples of a negative spacing are those of a positive one; nothing gets nearer by rounding.
TEST(MeshClaim, is_not_helped_by_a_negative_grid) {
  const Solid pipe = test::solid(test::cylinder({0, 0, 0}, {9, 1, 2}, 2));
  for (const double grid : {-1., std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(follows(pipe, claim(64, {0, 1}, .9 * sagitta(2, 64), grid)));
    EXPECT_FALSE(follows(pipe, claim(64, {0, 1}, 10, grid)));
    EXPECT_FALSE(follows(test::ball({0, 0, 0}, 3), claim(64, {}, 10, grid)));
  }
}

TEST(MeshClaim, needs_knots_that_ascend_from_whole_number_to_whole_number) {
  const Solid solid =
      test::solid(test::elbow(4, .5, 1), test::elbow(4, .5, 1));  // pieces need not meet here
  const double large = 10;
  EXPECT_TRUE(follows(solid, claim(8, {0, .5, 1, 1.5, 2}, large)));
  const std::vector<std::vector<double>> bad{{},
                                             {0},
                                             {0, 1},
                                             {0, 2},
                                             {0, .5, 1.5, 2},
                                             {.5, 1, 2},
                                             {0, 1, 1.5},
                                             {0, .5, .5, 1, 2},
                                             {0, .75, .5, 1, 2},
                                             {0, 1, 2, 3},
                                             {0, 1, 2, 2}};
  for (std::size_t i = 0; i < bad.size(); ++i) {
    EXPECT_FALSE(follows(solid, claim(8, bad[i], large))) << i;
  }
  EXPECT_FALSE(follows(solid, claim(2, {0, .5, 1, 1.5, 2}, large)));
  EXPECT_FALSE(
      follows(solid, claim(8, {0, .5, 1, 1.5, 2}, std::numeric_limits<double>::quiet_NaN())));
}

TEST(MeshClaim, of_a_hollow_chain_never_follows) {
  const PeArc arc = PeArc::from(test::sphere(4, 0, 0, 1), test::direction(Vec3::UnitY(), 0),
                                test::sphere(0, 4, 0, 1));
  CertifiedPart part = test::part(test::cyclide_piece(arc));
  EXPECT_TRUE(follows(Solid(part), claim(32, equal_knots(16), 1)));
  std::get<Chain>(part.shape).wall = .5;
  EXPECT_FALSE(follows(Solid(part), claim(32, equal_knots(16), 1)));
}

}  // namespace
}  // namespace dupin::verification
