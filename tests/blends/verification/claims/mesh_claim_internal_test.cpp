#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/verification/least_bound_internal.h"
#include "blends/verification/solids_internal.h"
#include "dupin/blends/elliptic_tube.h"
#include "dupin/blends/ringed_blend.h"
#include "support/cyclide_cases.h"
#include "verification/claims/mesh_claim.h"

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

double least_bound(const Solid& solid, MeshClaim about) {
  return least_bound(solid, std::move(about), 1e3, 1e-3);
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

TEST(MeshClaim, has_no_more_segments_than_the_limit) {
  const Solid solid = test::solid(test::cylinder({0, 0, 0}, {9, 1, 2}, 2));
  EXPECT_TRUE(follows(solid, claim(CertificateLimits::kSegments, {0, 1}, 1)));
  EXPECT_FALSE(follows(solid, claim(CertificateLimits::kSegments + 1, {0, 1}, 1)));
}

TEST(MeshClaim, of_a_cone_is_the_sagitta_of_its_larger_ring) {
  const Solid solid = test::solid(test::cone({0, 0, 0}, {9, 1, 2}, .5, 2));
  EXPECT_TRUE(follows(solid, claim(16, {0, 1}, sagitta(2, 16) + 1e-12)));
  EXPECT_FALSE(follows(solid, claim(16, {0, 1}, sagitta(2, 16) - 1e-12)));
}

TEST(MeshClaim, of_similar_ellipses_needs_the_larger_sagitta) {
  EllipticTube tube;
  tube.start = {Vec3(0, 0, 0), -Vec3::UnitX(), 2, 0, Ellipse{Vec3::UnitY(), 1, 0}};
  tube.end = {Vec3(5, 0, 0), Vec3::UnitX(), 4, 0, Ellipse{Vec3::UnitY(), 2, 0}};
  tube.spine = LineSpine{Vec3(0, 0, 0), Vec3(5, 0, 0)};
  tube.first = LinearRadius{2, 4};
  tube.second = LinearRadius{1, 2};
  tube.axis = Vec3::UnitY();
  EXPECT_TRUE(follows(test::solid(tube), claim(16, {0, 1}, sagitta(4, 16) + 1e-12)));
  EXPECT_FALSE(follows(test::solid(tube), claim(16, {0, 1}, sagitta(4, 16) - 1e-12)));
  tube.turn = pi;
  EXPECT_FALSE(follows(test::solid(tube), claim(16, {0, 1}, sagitta(4, 16) + 1e-2)))
      << "half a turn, and the axes are the same again";
  tube.turn = 0;
  tube.second = CubicRadius{1, 2};  // similar at its ends only
  EXPECT_FALSE(follows(test::solid(tube), claim(16, {0, 1}, sagitta(4, 16) + 1e-2)));
  tube.second = LinearRadius{1, 2};
  tube.end.ellipse->across = 2.5;  // no longer similar: rows of facets would be twisted
  EXPECT_FALSE(follows(test::solid(tube), claim(16, {0, 1}, sagitta(4, 16) + 1e-2)));
}

// Ellipses with semi-axes 2 and 1 along x, the second of which is turned.
EllipticTube twisted(double turn, double length) {
  const Vec3 axis = Eigen::AngleAxisd(turn, Vec3::UnitX()) * Vec3::UnitY();
  const Ring start{Vec3::Zero(), -Vec3::UnitX(), 2, 0, Ellipse{Vec3::UnitY(), 1, 0}};
  const Ring end{Vec3(length, 0, 0), Vec3::UnitX(), 2, 0, Ellipse{axis, 1, 0}};
  return elliptic_tube(start, end, LineSpine{start.center, end.center}, ConstantRadius{2},
                       ConstantRadius{1});
}

TEST(MeshClaim, of_ellipses_that_turn_is_of_how_fast) {
  const double turn = .4;
  const Solid solid = test::solid(twisted(turn, 9));
  for (const auto& [segments, bands] : {std::pair(16, 4), {64, 16}}) {
    double expected = 0;
    const double dt = 1. / bands, du = (2 + dt) * pi / segments;
    for (int i = 0; i < bands; ++i) {
      const double a = dt * i, b = dt * (i + 1), middle = std::clamp(.5, a, b);
      const double rate = 6 * turn * middle * (1 - middle);
      const double change = 6 * turn * std::max(std::abs(1 - 2 * a), std::abs(1 - 2 * b));
      expected = std::max(
          expected,
          (dt * dt * 2 * (change + rate * rate) + 2 * dt * du * 2 * rate + du * du * 2) / 8);
    }
    const double least = least_bound(solid, claim(std::uint32_t(segments), equal_knots(bands), 0));
    EXPECT_LE(least, 1.02 * expected);
    EXPECT_GE(least, .9 * expected) << "the largest values need not be at one place";
  }
}

TEST(MeshClaim, of_ellipses_does_not_follow_where_nothing_tells_how_they_turn) {
  EllipticTube tube = twisted(.4, 9);
  tube.spine = HermiteSpine{tube.start.center, tube.end.center, Vec3::Zero(), Vec3::Zero()};
  EXPECT_FALSE(follows(test::solid(tube), claim(64, equal_knots(16), 1e9)));
}

TEST(MeshClaim, of_ellipses_includes_what_their_axes_are_turned_by) {
  const Solid solid = test::solid(twisted(.4, 9)), round = test::solid(test::elbow(4, 1.5, 1));
  MeshClaim about = claim(32, equal_knots(8), 0);
  const double least = least_bound(solid, about);
  about.axes = .01;
  EXPECT_NEAR(least_bound(solid, about), least + .01 * 2, 2e-3 * least);
  for (const double axes : {-1e-9, std::nan(""), std::numeric_limits<double>::infinity(), 1e9}) {
    about.axes = axes;
    about.error_bound = 1;
    EXPECT_FALSE(follows(solid, about)) << axes;
  }
  about = claim(32, equal_knots(8), 10);
  EXPECT_TRUE(follows(round, about));
  about.axes = 1e-9;
  EXPECT_FALSE(follows(round, about)) << "circles have no axes";
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

// A disc as the evaluators of the surfaces say it is, the rate of the length that bands are
// measured by, and how the frame turns, where it does.
struct Moving {
  Vec3 center, normal;
  double radius = 0, pace = 1;
  std::optional<Vec3> spin = {};
};

using Surface = std::function<Moving(double)>;

template <class Value>
Value rate(const std::function<Value(double)>& f, double t) {
  const double h = 1e-4, a = std::max(t - h, 0.), b = std::min(t + h, 1.);
  return (f(b) - f(a)) / (b - a);
}

// The bound of docs/certificate_format.md, from differences at many places of every band.
double band_bound(const Surface& at, std::uint32_t segments, int band, int bands, double sharing) {
  constexpr int kPlaces = 200;
  double along = 0, mixed = 0, around = 0, turning = 0, length = 0;
  for (int i = 0; i <= kPlaces; ++i) {
    const double t = std::clamp((band + double(i) / kPlaces) / bands, 2e-4, 1 - 2e-4);
    const auto per_length = [&](const auto& f) { return f / at(t).pace; };
    const auto c1 = [&](double s) -> Vec3 {
      return rate<Vec3>([&](double x) { return at(x).center; }, s) / at(s).pace;
    };
    const auto n1 = [&](double s) -> Vec3 {
      return rate<Vec3>([&](double x) { return at(x).normal; }, s) / at(s).pace;
    };
    const auto r1 = [&](double s) {
      return rate<double>([&](double x) { return at(x).radius; }, s) / at(s).pace;
    };
    const Vec3 n = at(t).normal, c2 = per_length(rate<Vec3>(c1, t)),
               n2 = per_length(rate<Vec3>(n1, t));
    const double r2 = std::abs(per_length(rate<double>(r1, t))), slope = std::abs(r1(t));
    const double radius = at(t).radius, turn = n1(t).norm();
    around = std::max(around, radius);
    length += at(t).pace / bands / (kPlaces + 1);
    if (at(t).spin) {
      const double spin = at(t).spin->norm();
      const double change = rate<Vec3>([&](double x) { return *at(x).spin; }, t).norm();
      along = std::max(along, c2.norm() + r2 + 2 * slope * spin + radius * (change + spin * spin));
      mixed = std::max(mixed, slope + radius * spin);
      continue;
    }
    along = std::max(
        along, std::hypot(std::abs(c2.dot(n)) + 2 * slope * turn + radius * n2.cross(n).norm(),
                          c2.cross(n).norm() + r2 + radius * turn * turn));
    mixed = std::max(mixed, std::hypot(slope, radius * turn));
    turning = std::max(turning, turn);
  }
  const double du =
      2 * pi / segments + pi / segments / sharing + .27 * std::pow(length * turning, 2) / 16;
  return (length * length * along + 2 * length * du * mixed + du * du * around) / 8;
}

// By the length of the way or by the parameter, whichever tells more of a band.
double expected_bound(const Surface& surface, std::uint32_t segments, int bands, double sharing) {
  const Surface by_parameter = [&](double t) {
    Moving moving = surface(t);
    moving.pace = 1;
    return moving;
  };
  double worst = 0;
  for (int band = 0; band < bands; ++band) {
    worst = std::max(worst, std::min(band_bound(surface, segments, band, bands, sharing),
                                     band_bound(by_parameter, segments, band, bands, sharing)));
  }
  return worst;
}

RationalRingedTube tube_of(const RationalRingedSurface& surface) {
  const MovingRing from = ring_at(surface, 0), to = ring_at(surface, 1);
  return {{from.center, -from.normal, from.radius}, {to.center, to.normal, to.radius}, surface};
}

Vec3 spin(const RationalRingedSurface& surface, double t) {
  const auto blended = [](std::vector<Eigen::Vector4d> points, double s) {
    for (; points.size() > 1; points.pop_back()) {
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        points[i] = (1 - s) * points[i] + s * points[i + 1];
      }
    }
    return points.front();
  };
  std::vector<Eigen::Vector4d> points, steps;
  for (const auto& q : surface.rotation) {
    points.emplace_back(q[0], q[1], q[2], q[3]);
  }
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    steps.emplace_back(double(points.size() - 1) * (points[i + 1] - points[i]));
  }
  const Eigen::Vector4d a = blended(points, t), b = blended(steps, t);
  const Vec3 v = a.tail<3>(), w = b.tail<3>();
  return 2 * (a[0] * w - b[0] * v - w.cross(v)) / a.squaredNorm();
}

// Few bands, on which all that the bound is made of varies: where less than the largest values of a
// band were taken, less would follow.
TEST(MeshClaim, is_made_of_the_largest_values_on_each_band) {
  const auto ringed = [](const RingedSurface& surface) -> Surface {
    return [=](double t) -> Moving {
      const SpinePoint y = evaluate(surface.spine, t);
      return {y.position, y.first.normalized(), evaluate(surface.radius, t).value, y.first.norm()};
    };
  };
  RingedSurface straight = test::cylinder({0, 0, 0}, {0, 8, 0}, 1), bent = test::elbow(5, .9, 1);
  straight.radius = CubicRadius{1, 2.5};
  bent.radius = CubicRadius{1, 1.6};
  const RingedSurface free{
      {}, {}, HermiteSpine{{0, 0, 0}, {6, 3, 1}, {9, 0, 0}, {2, 7, -3}}, CyclideRadius{.5, .9}};
  const PeArc arc = PeArc::from(test::sphere(4, 0, 0, .7), test::direction(Vec3(.1, 1, .2), .2),
                                test::sphere(.5, 5, .4, 1.6));
  const RationalRingedSurface spinning =
      ringed_blend(along_oblique_cone({Vec3(0, 0, 0), Vec3::UnitZ(), 1}, Vec3(.6, 0, -3), 1.2),
                   along_canal({Vec3(4, 1, 4), Vec3::UnitX(), .8}, 0, 3));
  struct Row {
    std::string name;
    Solid solid;
    Surface surface;
    int bands;
  };
  const std::vector<Row> table = {
      {"straight", test::solid(straight), ringed(straight), 1},
      {"straight", test::solid(straight), ringed(straight), 3},
      {"bent", test::solid(bent), ringed(bent), 1},
      {"free", test::solid(free), ringed(free), 5},
      {"free", test::solid(free), ringed(free), 8},
      {"cyclide", test::solid(test::cyclide_piece(arc)),
       [=](double t) -> Moving {
         const Ring ring = circle_at(arc, t);
         const double m = rate<Vec3>([&](double x) { return sphere_at(arc, x).m; }, t).norm(),
                      r = rate<double>([&](double x) { return sphere_at(arc, x).r; }, t);
         return {ring.center, ring.normal, ring.radius, std::sqrt(m * m - r * r)};
       },
       4},
      {"spinning", test::solid(tube_of(spinning)),
       [=](double t) -> Moving {
         const MovingRing ring = ring_at(spinning, t);
         return {ring.center, ring.normal, ring.radius, 1, spin(spinning, t)};
       },
       2}};
  for (const auto& [name, solid, surface, bands] : table) {
    for (const std::uint32_t segments : {8U, 64U}) {
      const double expected = expected_bound(surface, segments, bands, bands);
      const auto bound = [&](double share) {
        return claim(segments, equal_knots(bands), share * expected);
      };
      EXPECT_FALSE(follows(solid, bound(.995))) << name << " " << bands << " " << segments;
      EXPECT_TRUE(follows(solid, bound(1.03))) << name << " " << bands << " " << segments;
    }
  }
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
  const double plain = least_bound(test::ball({0, 0, 0}, 2), claim(64, {}, 0));
  const Solid ball = test::ball({far, 0, 0}, 2);
  EXPECT_TRUE(follows(ball, claim(64, {}, 1.001 * plain + 1.01 * rounding)));
  EXPECT_FALSE(follows(ball, claim(64, {}, .998 * plain + .99 * rounding)));
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

// The spine turns back at its middle.
TEST(MeshClaim, does_not_follow_where_nothing_is_known_of_the_discs) {
  RingedSurface back = test::cylinder({0, 0, 0}, {1, 0, 0}, 1);
  back.spine = BezierSpine{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 0)}, {}};
  EXPECT_FALSE(follows(test::solid(back), claim(64, equal_knots(3), 1e3)));
  EXPECT_TRUE(follows(test::solid(test::elbow(4, 1, 1)), claim(64, equal_knots(3), 1e3)));
}

// A cone whose spheres slow down, by 1/(1 + t)^2: a cell holds the fast ones and the slow ones.
TEST(MeshClaim, bounds_the_length_of_a_way_by_its_fastest_part) {
  const PeVector first = test::sphere(0, 0, 0, 3), last = test::sphere(4, 0, 0, 1.5);
  const double length = std::sqrt(16 - 1.5 * 1.5);
  const CyclidePiece cone{
      {}, {}, first, {(last.m - first.m) / length, (last.r - first.r) / length}, last, length / 2};
  for (const int cells : {1, 4, 1024}) {
    const auto found = bounds_over(motion(cone, 0), 0, .03125, cells);
    ASSERT_TRUE(found);
    EXPECT_GE((*found)[0].length, length * .0625 / 1.03125) << cells;
    EXPECT_LE((*found)[0].length, length * .0625 * (1 + .2 / cells)) << cells;
  }
}

TEST(MeshClaim, is_about_coordinates_as_large_as_those_of_all_centres) {
  const PeArc arc = PeArc::from(test::sphere(4, 0, 0, .7), test::direction(Vec3(.1, 1, .2), .2),
                                test::sphere(.5, 5, .4, 1.6));
  double most = 0;
  for (int i = 0; i <= 64; ++i) {
    most = std::max(most, circle_at(arc, i / 64.).center.norm());
  }
  const double found = size_of(test::solid(test::cyclide_piece(arc)));
  EXPECT_GE(found, most);
  EXPECT_LE(found, 2 * most);
}

// The normals turn at once at 1/2, or so fast next to 1/3 that cells of 1/16 do not tell.
TEST(MeshClaim, is_about_no_coordinates_where_nothing_is_known_of_the_discs) {
  RationalRingedTube tube;
  tube.surface.center = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)};
  tube.surface.radius = {1, 1, 1, 1};
  tube.surface.rotation = {{1, 0, 0, 0}, {-1, 0, 0, 0}};
  EXPECT_EQ(size_of(test::solid(tube)), std::numeric_limits<double>::infinity());
  tube.surface.rotation = {{1, 0, 0, .01}, {-2, 0, 0, .01}};
  EXPECT_FALSE(test::solid(tube).discs({5. / 16, 6. / 16}));
  EXPECT_LT(size_of(test::solid(tube)), 4);
}

}  // namespace
}  // namespace dupin::verification
