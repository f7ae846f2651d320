#include "dupin/blends/cyclide_blend.h"

#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_form.h"
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

}  // namespace
}  // namespace dupin
