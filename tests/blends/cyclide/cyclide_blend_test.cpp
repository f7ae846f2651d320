#include "dupin/blends/cyclide_blend.h"

#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

// The rings at the ends must be the contact circles of the chain's end tangents, and neighbours
// must meet.
void expect_g1(const Chain& blend) {
  const auto pieces = cyclide_pieces(blend);
  const Ring &start = end_ring(blend, End::start), &end = end_ring(blend, End::end);
  const Ring first = circle_at(pieces.front(), 0), last = circle_at(pieces.back(), 1);
  const double size = (first.center - last.center).norm() + first.radius + last.radius;
  EXPECT_NEAR((first.center - start.center).norm(), 0, 1e-12 * size);
  EXPECT_NEAR((last.center - end.center).norm(), 0, 1e-12 * size);
  EXPECT_NEAR((first.normal + start.normal).norm(), 0, 1e-12);
  EXPECT_NEAR((last.normal - end.normal).norm(), 0, 1e-11);
  EXPECT_NEAR(last.radius, end.radius, 1e-12 * size);
  EXPECT_NEAR(last.slope, end.slope, 1e-11);
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    EXPECT_EQ(pieces[i].end(), pieces[i + 1].start());
    EXPECT_EQ(pieces[i].end_tangent(), pieces[i + 1].start_tangent());
  }
}

TEST(CyclideBlend, equal_cylinders_with_meeting_axes_take_one_torus) {
  const Chain blend =
      cyclide_blend({Vec3::Zero(), Vec3::UnitZ(), 1}, {Vec3(3, 0, 3), -Vec3::UnitX(), 1});
  EXPECT_EQ(kind(blend), "single");
  EXPECT_EQ(canonical_form(cyclide_pieces(blend)[0]).kind, CyclideKind::torus);
  expect_g1(blend);
}

TEST(CyclideBlend, unequal_cylinders_take_two_pieces) {
  // Design C5: the junctions with their regular range contain the equal choice alpha = beta.
  const Chain blend =
      cyclide_blend({Vec3::Zero(), Vec3::UnitZ(), 1}, {Vec3(3, 0, 3), -Vec3::UnitX(), .6});
  EXPECT_EQ(kind(blend), "double");
  expect_g1(blend);
  double bent = 0;
  for (const PeArc& piece : cyclide_pieces(blend)) {
    bent += bending(piece);
  }
  const PeVector b0{Vec3::Zero(), 1}, b3{Vec3(3, 0, 3), .6};
  const PeVector equal{Vec3(0.883398951148328, 0, 2.11660104885167), 0.8};
  const DoubleCyclide other =
      double_cyclide_near(b0, {Vec3::UnitZ(), 0}, b3, {Vec3::UnitX(), 0}, equal);
  EXPECT_NEAR(other.first.w(), 0.926376177433505, 1e-7);
  EXPECT_NEAR(area(other.first), 14.5456632731456, 1e-5);
  EXPECT_LE(bent, bending(other.first) + bending(other.second));
}

TEST(CyclideBlend, skew_cones_take_two_pieces) {
  const double q0 = .15 / std::sqrt(1 - .15 * .15), q3 = -.1 / std::sqrt(1 - .1 * .1);
  const PeVector b0{Vec3::Zero(), 1}, b3{Vec3(4, 3, 5), .7};
  const Ring start = contact_ring(b0, {std::hypot(1, q0) * Vec3::UnitZ(), q0});
  const Ring end = contact_ring(b3, {std::hypot(1, q3) * Vec3(.6, .8, 0), q3});
  const Chain blend = cyclide_blend(start, flipped(end));
  EXPECT_EQ(kind(blend), "double");
  expect_g1(blend);
}

TEST(CyclideBlend, ellipses_are_refused) {
  const Ring circle{Vec3::Zero(), Vec3::UnitZ(), 1};
  const Ring ellipse{Vec3(3, 0, 3), -Vec3::UnitX(), 1, 0, Ellipse{Vec3::UnitY(), 0.5, 0}};
  EXPECT_THROW((void)cyclide_blend(circle, ellipse), Error);
  EXPECT_THROW((void)cyclide_blend(ellipse, circle), Error);
}

TEST(CyclideBlend, random_ends_are_joined_g1_or_refused) {
  std::mt19937_64 random(58);
  std::uniform_real_distribution<double> place(-4, 4), radius(0.3, 1.2), slope(-0.4, 0.4);
  int joined = 0, doubles = 0;
  const int count = 30;
  for (int i = 0; i < count; ++i) {
    const auto vector = [&] { return Vec3(place(random), place(random), place(random)); };
    const Ring from{vector(), vector().normalized(), radius(random), slope(random)};
    const Ring to{vector(), vector().normalized(), radius(random), slope(random)};
    try {
      const Chain blend = cyclide_blend(from, to);
      expect_g1(blend);
      ++joined;
      doubles += kind(blend) == "double" ? 1 : 0;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::infeasible_blend);
    }
  }
  // The design's statistics: 91 % by two pieces, nearly all by three.
  EXPECT_GE(doubles, count * 8 / 10);
  EXPECT_GE(joined, count * 9 / 10);
}

struct RingPair {
  const char* name;
  Ring from, to;
};

// The pipes' rings of examples/cyclide-blends.json and of shapes that are special: straight ahead,
// planar, S-shaped, back beside, and askew.
std::vector<RingPair> ring_pairs() {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ(), o = Vec3::Zero();
  return {{"single", {o, z, 1}, {Vec3(3, 0, 3), -x, 1}},
          {"double", {Vec3(0, 5, 0), z, 1}, {Vec3(3, 5, 3), -x, 0.6}},
          {"triple", {Vec3(0, 15, 0), z, 0.5}, {Vec3(3, 15, -4), -z, 0.5}},
          {"triple, unequal", {Vec3(0, 15, 0), z, 0.5}, {Vec3(3, 15, -4), -z, 0.4}},
          {"ringed", {Vec3(0, 26, 0), z, 4}, {Vec3(0.25, 26, 3.5), -z, 1}},
          {"straight", {o, z, 1}, {Vec3(0, 0, 5), -z, 1}},
          {"straight, unequal", {o, z, 1}, {Vec3(0, 0, 5), -z, 0.7}},
          {"planar", {o, z, 0.5}, {Vec3(2, 0, 5), Vec3(-0.6, 0, -0.8), 0.5}},
          {"planar, unequal", {o, z, 0.5}, {Vec3(2, 0, 5), Vec3(-0.6, 0, -0.8), 0.3}},
          {"S", {o, z, 0.5}, {Vec3(3, 0, 4), -z, 0.5}},
          {"S, unequal", {o, z, 0.5}, {Vec3(3, 0, 4), -z, 0.8}},
          {"U", {o, z, 0.5}, {Vec3(3, 0, 0), z, 0.5}},
          {"U, unequal", {o, z, 0.5}, {Vec3(3, 0, 0), z, 0.3}},
          {"from behind on one line", {o, z, 0.5}, {Vec3(0, 0, -8), -z, 0.5}},
          {"askew", {o, z, 0.5}, {Vec3(3, 4, 2), -y, 0.4}}};
}

TEST(CyclideBlend, turned_ends_take_the_turned_blend) {
  std::mt19937_64 random(33);
  std::uniform_real_distribution<double> unit(-1, 1), shift(-20, 20);
  for (const RingPair& pair : ring_pairs()) {
    SCOPED_TRACE(pair.name);
    const CyclideSearch plain = search_cyclide_blend(pair.from, pair.to);
    for (int i = 0; i < 10; ++i) {
      SCOPED_TRACE(i);
      const Eigen::Quaterniond turn =
          Eigen::Quaterniond(unit(random), unit(random), unit(random), unit(random)).normalized();
      const Vec3 way(shift(random), shift(random), shift(random));
      const auto moved = [&](Ring ring) {
        ring.center = turn * ring.center + way;
        ring.normal = (turn * ring.normal).normalized();
        return ring;
      };
      const CyclideSearch turned = search_cyclide_blend(moved(pair.from), moved(pair.to));
      ASSERT_EQ(turned.tube.has_value(), plain.tube.has_value());
      ASSERT_EQ(turned.rejected.size(), plain.rejected.size());
      if (plain.tube) {
        EXPECT_NEAR(volume(*turned.tube) / volume(*plain.tube), 1, 1e-6);
        EXPECT_NEAR(area(*turned.tube) / area(*plain.tube), 1, 1e-6);
      }
    }
  }
}

TEST(CyclideBlend, a_slight_turn_of_the_end_leads_no_further_away) {
  const Ring from{Vec3::Zero(), Vec3::UnitZ(), 0.5};
  const double plain = volume(cyclide_blend(from, {Vec3(3, 0, -4), -Vec3::UnitZ(), 0.5}));
  for (const double angle : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) {
    for (const double sign : {-1.0, 1.0}) {
      const Vec3 normal(sign * std::sin(angle), 0, -std::cos(angle));
      EXPECT_NEAR(volume(cyclide_blend(from, {Vec3(3, 0, -4), normal, 0.5})) / plain, 1,
                  1e-6 + 4 * angle)
          << sign * angle;
    }
  }
}

}  // namespace
}  // namespace dupin
