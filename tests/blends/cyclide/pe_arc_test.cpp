#include "dupin/blends/pe_arc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_form.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"
#include "support/message_of.h"

namespace dupin {
namespace {

using std::numbers::pi;

using test::direction;
using test::RandomArcs;
using test::sphere;

void expect_near(const PeVector& a, const PeVector& b, double tolerance) {
  EXPECT_NEAR(a.m.x(), b.m.x(), tolerance);
  EXPECT_NEAR(a.m.y(), b.m.y(), tolerance);
  EXPECT_NEAR(a.m.z(), b.m.z(), tolerance);
  EXPECT_NEAR(a.r, b.r, tolerance);
}

struct Single {
  const char* name;
  PeVector start, tangent, end;
  double chord, w, power;
  PeVector end_tangent;
  CyclideKind kind;
  double area, volume;
};

// Design C4, 40-digit oracle.
const std::vector<Single>& singles() {
  static const PeVector unit = sphere(0, 0, 0, 1), up = direction(Vec3::UnitZ(), 0);
  static const std::vector<Single> table{
      {"elbow", unit, up, sphere(3, 0, 3, 1), 3 * std::sqrt(2), std::sqrt(0.5), 12,
       sphere(1, 0, 0, 0), CyclideKind::torus, 3 * pi * pi, 1.5 * pi * pi},
      {"u_bend", unit, up, sphere(4, 0, 0, 1), 4, 0, 8, sphere(0, 0, -1, 0), CyclideKind::torus,
       39.4784176043574, 19.7392088021787},
      {"three_quarters", unit, up, sphere(3, 0, -3, 1), 3 * std::sqrt(2), -std::sqrt(0.5), 12,
       sphere(-1, 0, 0, 0), CyclideKind::torus, 88.8264396098, 44.4132198049},
      {"reducer", unit, up, sphere(3.06186217847897, 0, 3, 0.387627564304205), 4.24264068711929,
       0.707106781186548, 13.1010205144336, sphere(1.02062072615966, 0, 0, -0.204124145231932),
       CyclideKind::elliptic, 23.8010832178908, 9.71463358402981},
      {"flare", unit, up, sphere(0, 0, 3, 2), 2 * std::sqrt(2), 1.06066017178, 6,
       sphere(0, 0, 1.25, 0.75), CyclideKind::torus, 14.5896398843151, 8.19943142430324},
      {"parabolic", sphere(0, 0, 0, 2), direction(Vec3::UnitX(), 0), sphere(2, .6, 0, 1.4), 2, 1, 4,
       sphere(1, .6, 0, -.6), CyclideKind::parabolic, 32.3913891910421, 27.4549343622203},
      {"cone", unit, direction(Vec3::UnitZ(), 0.25), sphere(0, 0, 4, 2), std::sqrt(15), 1, 15,
       direction(Vec3::UnitZ(), 0.25), CyclideKind::cone, 35.3429173528852, 25.7708772364788},
      {"horned", unit, direction(Vec3::UnitZ(), 0.2), sphere(3, 0, 2.5, .6), 3.88458491991101,
       0.677859160703389, 11.0112246173204,
       sphere(1.04699859780991, 0, -0.148121894651402, -0.343723958273252), CyclideKind::elliptic,
       30.8989745115297, 15.6677817593305}};
  return table;
}

TEST(PeArc, single_pieces_have_the_oracle_values) {
  for (const Single& row : singles()) {
    SCOPED_TRACE(row.name);
    const PeArc arc = PeArc::from(row.start, row.tangent, row.end);
    EXPECT_NEAR(arc.chord(), row.chord, 1e-11 * row.chord);
    EXPECT_NEAR(arc.w(), row.w, 2e-12);
    EXPECT_NEAR(arc.least_power(), row.power, 1e-12 * row.power);
    expect_near(arc.end_tangent(), row.end_tangent, 2e-12);
    EXPECT_NEAR(area(arc), row.area, 1e-12 * row.area);
    EXPECT_NEAR(volume(arc), row.volume, 1e-12 * row.volume);
    EXPECT_EQ(canonical_form(arc).kind, row.kind) << name(canonical_form(arc).kind);
  }
}

TEST(PeArc, points_have_the_oracle_values) {
  const PeArc reducer = PeArc::from(singles()[3].start, singles()[3].tangent, singles()[3].end);
  const Vec3 p = point_at(reducer, 0.5, 1).position;
  EXPECT_NEAR((p - Vec3(1.26258488720747, 0.705188241735665, 1.91550384081204)).norm(), 0, 1e-13);
  const PeArc para = PeArc::from(singles()[5].start, singles()[5].tangent, singles()[5].end);
  const Vec3 q = point_at(para, 0.5, 1).position;
  EXPECT_NEAR((q - Vec3(1.24996141928, 1.166795269066, 1.525171029648)).norm(), 0, 2e-12);
}

TEST(PeArc, canonical_parameters_have_the_oracle_values) {
  const PeArc reducer = PeArc::from(singles()[3].start, singles()[3].tangent, singles()[3].end);
  const CanonicalCyclide f = canonical_form(reducer);
  EXPECT_NEAR(f.a, 3.061862178479, 1e-11);
  EXPECT_NEAR(f.b, 3, 1e-11);
  EXPECT_NEAR(f.c, 0.6123724356958, 1e-11);
  EXPECT_NEAR(f.mu, 0.3876275643042, 1e-11);
  EXPECT_NEAR((f.origin - Vec3(3.061862178479, 0, 0)).norm(), 0, 1e-11);
  EXPECT_NEAR((f.x - Vec3(1, 0, 0)).norm(), 0, 1e-11);
  EXPECT_NEAR((f.y - Vec3(0, 0, -1)).norm(), 0, 1e-11);
  const PeArc flare = PeArc::from(singles()[4].start, singles()[4].tangent, singles()[4].end);
  EXPECT_NEAR(canonical_form(flare).a, 4, 1e-11);
  EXPECT_NEAR(canonical_form(flare).mu, -3, 1e-11);
}

TEST(PeArc, points_satisfy_the_implicit_equation) {
  for (const Single& row : singles()) {
    const PeArc arc = PeArc::from(row.start, row.tangent, row.end);
    const CanonicalCyclide f = canonical_form(arc);
    if (f.kind == CyclideKind::cone) {
      EXPECT_THROW((void)implicit_value(f, Vec3::Zero()), Error);
      continue;
    }
    SCOPED_TRACE(row.name);
    const double size = std::max({std::abs(f.a), std::abs(f.mu), 3.0});
    for (int i = 0; i <= 8; ++i) {
      for (int j = 0; j < 8; ++j) {
        const ArcPoint p = point_at(arc, i / 8.0, 2 * pi * j / 8);
        EXPECT_NEAR(implicit_value(f, p.position), 0, 1e-12 * std::pow(size, 4));
      }
    }
  }
}

TEST(PeArc, patches_lie_on_the_surface_with_positive_weights) {
  for (const Single& row : singles()) {
    SCOPED_TRACE(row.name);
    const PeArc arc = PeArc::from(row.start, row.tangent, row.end);
    for (const BiquadraticPatch& patch : patches(arc)) {
      for (const auto& weights : patch.weights) {
        for (const double w : weights) {
          EXPECT_GT(w, 0);
        }
      }
      for (int i = 0; i <= 4; ++i) {
        for (int j = 0; j <= 4; ++j) {
          EXPECT_NEAR(signed_distance(arc, evaluate(patch, i / 4.0, j / 4.0)), 0, 1e-13 * 40);
        }
      }
    }
  }
}

struct Rejection {
  const char* name;
  PeVector start, tangent, end;
  ArcFault fault;
  double ArcValidity::*value;
  double expected;
};

TEST(PeArc, rejections_give_the_reason_and_the_value) {
  const PeVector unit = sphere(0, 0, 0, 1), up = direction(Vec3::UnitZ(), 0);
  const std::vector<Rejection> table{
      {"nested", unit, up, sphere(.3, 0, 0, 1.5), ArcFault::nested, &ArcValidity::squared_length,
       -0.16},
      {"behind", unit, up, sphere(0, 0, -3, 2), ArcFault::through_infinity, &ArcValidity::w,
       -1.06066017178},
      {"tight", unit, up, sphere(.8, 0, .8, 1), ArcFault::pinched, &ArcValidity::least_power,
       -0.32},
      {"through_zero", unit, direction(Vec3::UnitZ(), -0.7), sphere(5, 0, 3, .2),
       ArcFault::radius_vanishes, &ArcValidity::radius_margin, -2.239163546478 + std::sqrt(0.2)}};
  for (const Rejection& row : table) {
    SCOPED_TRACE(row.name);
    const ArcValidity v = validity(row.start, row.tangent, row.end);
    EXPECT_EQ(v.fault, row.fault);
    EXPECT_NEAR(v.*row.value, row.expected, 2e-12);
    EXPECT_THROW((void)PeArc::from(row.start, row.tangent, row.end), Error);
  }
}

TEST(PeArc, reversal_offset_and_halving_keep_the_surface) {
  RandomArcs arcs;
  for (int i = 0; i < 100; ++i) {
    const PeArc arc = arcs.next();
    const PeArc back = reversed(arc);
    EXPECT_NEAR(back.w(), arc.w(), 1e-11);
    EXPECT_NEAR(area(back), area(arc), 1e-9 * area(arc));
    const double w_half = std::sqrt((1 + arc.w()) / 2);
    EXPECT_NEAR(sub_arc(arc, 0, 0.5).w(), w_half, 1e-10);
    const PeArc larger = offset(arc, 1e-3);
    EXPECT_NEAR(larger.w(), arc.w(), 1e-11);
    expect_near(larger.end_tangent(), arc.end_tangent(), 1e-9);
    EXPECT_NEAR(pe_length(sub_arc(arc, 0, 0.3)) + pe_length(sub_arc(arc, 0.3, 1)), pe_length(arc),
                1e-9 * pe_length(arc));
  }
}

TEST(PeArc, turning_the_data_turns_the_surface) {
  RandomArcs arcs;
  const Eigen::AngleAxisd rotation(1.1, Vec3(1, -2, 3).normalized());
  const Vec3 shift(3, -1, 2);
  const auto turned = [&](const PeVector& b) { return PeVector{rotation * b.m + shift, b.r}; };
  for (int i = 0; i < 100; ++i) {
    const PeArc arc = arcs.next();
    const PeArc other =
        PeArc::from(turned(arc.start()), {rotation * arc.start_tangent().m, arc.start_tangent().r},
                    turned(arc.end()));
    EXPECT_NEAR(other.w(), arc.w(), 1e-12);
    EXPECT_NEAR(other.least_power(), arc.least_power(), 1e-11);
    EXPECT_NEAR(area(other), area(arc), 1e-9 * area(arc));
    EXPECT_NEAR(volume(other), volume(arc), 1e-9 * volume(arc));
    const Vec3 expected = rotation * point_at(arc, 0.4, 2).position + shift;
    const double slack = 1e-13 * 20 / (1 + arc.w());  // of a point where the weight is small
    EXPECT_LT((point_at(other, 0.4, 2).position - expected).norm(), slack);
  }
}

TEST(PeArc, circles_and_points_agree) {
  RandomArcs arcs;
  for (int i = 0; i < 50; ++i) {
    const PeArc arc = arcs.next();
    for (const double t : {0.0, 0.3, 0.8, 1.0}) {
      const Ring ring = circle_at(arc, t);
      const PeVector ball = sphere_at(arc, t);
      for (int j = 0; j < 7; ++j) {
        const ArcPoint p = point_at(arc, t, j);
        EXPECT_NEAR((p.position - ring.center).norm(), ring.radius, 1e-9);
        EXPECT_NEAR((p.position - ring.center).dot(ring.normal), 0, 1e-9);
        EXPECT_NEAR((p.position - ball.m).norm(), ball.r, 1e-9);
        EXPECT_NEAR(p.normal.dot(ring.normal), -ring.slope / std::hypot(1, ring.slope), 1e-8);
      }
    }
  }
}

TEST(PeArc, is_regular_exactly_when_its_discs_do_not_overlap_locally) {
  // V1 to V3 given, V4 must have the sign of min(d'.n - rho |n'|), measured on fine differences.
  RandomArcs arcs;
  int pinched = 0, regular = 0;
  while (pinched < 20 || regular < 60) {
    const PeVector a{arcs.vector() * 0.4, arcs.radius(arcs.random)};
    const PeVector b{arcs.vector() * 0.4, arcs.radius(arcs.random)};
    const PeVector t = direction(arcs.vector(), arcs.sine(arcs.random));
    const ArcValidity v = validity(a, t, b);
    // Too close to the border for a measurement by differences.
    if ((v.fault != ArcFault::none && v.fault != ArcFault::pinched) ||
        std::abs(v.least_power) < 0.05 * v.squared_length || v.w < -0.5) {
      continue;
    }
    const double length = std::sqrt(v.squared_length);
    const PeVector middle = v.w * a + (length / 2) * t;
    const auto sphere_of = [&](double s) {
      const double b0 = (1 - s) * (1 - s), b1 = 2 * s * (1 - s), b2 = s * s;
      return (1 / (b0 + b1 * v.w + b2)) * (b0 * a + b1 * middle + b2 * b);
    };
    double least = 1e300;
    const double h = 1e-4;
    const auto ring_of = [&](double s) {
      const PeVector d = sphere_of(s + h) - sphere_of(s - h);
      return contact_ring(sphere_of(s), (1 / std::sqrt(product(d, d))) * d);
    };
    for (int i = 0; i <= 200; ++i) {
      const double s = i / 200.0;
      const Ring r0 = ring_of(s - 2 * h), r1 = ring_of(s + 2 * h), r = ring_of(s);
      least = std::min(
          least, (r1.center - r0.center).dot(r.normal) - r.radius * (r1.normal - r0.normal).norm());
    }
    EXPECT_EQ(least > 0, v.fault == ArcFault::none);
    (least > 0 ? regular : pinched)++;
  }
}

// Where intervals of doubles cannot tell, and a hair on either side.
TEST(PeArc, has_its_faults_up_to_the_very_borders) {
  const PeVector up{{0, 0, 1}, 0}, narrowing{{0, 0, 1.25}, -0.75}, unit{{0, 0, 0}, 1};
  const auto fault = [&](const PeVector& tangent, const Vec3& end, double radius) {
    return validity(unit, tangent, {end, radius}).fault;
  };
  const auto above = [](double x) { return std::nextafter(x, 1e9); };
  const auto below = [](double x) { return std::nextafter(x, -1e9); };
  // |Dm| = 5 and r2 - r0 = 5.
  EXPECT_EQ(fault(up, {0, 3, 4}, 6), ArcFault::nested);
  EXPECT_EQ(fault(up, {0, 3, 4}, above(6)), ArcFault::nested);
  EXPECT_NE(fault(up, {0, 3, 4}, below(6)), ArcFault::nested);
  // w = -1.
  EXPECT_EQ(fault(up, {0, 0, -3}, 1), ArcFault::through_infinity);
  EXPECT_EQ(fault(up, {0, 0, -3}, below(1)), ArcFault::through_infinity);
  EXPECT_NE(fault(up, {0, 1e-9, -3}, 1), ArcFault::through_infinity);
  // 5 h / 4 - 3 h^2 / 8 = -h.
  EXPECT_EQ(fault(narrowing, {0, 0, 6}, 1), ArcFault::radius_vanishes);
  EXPECT_EQ(fault(narrowing, {0, 0, above(6)}, 1), ArcFault::radius_vanishes);
  EXPECT_EQ(fault(narrowing, {0, 0, below(6)}, 1), ArcFault::none);
  // |Dm|^2 = 2 x.
  EXPECT_EQ(fault(up, {1, 0, 1}, 1), ArcFault::pinched);
  EXPECT_EQ(fault(up, {1, 0, below(1)}, 1), ArcFault::pinched);
  EXPECT_EQ(fault(up, {1, 0, above(1)}, 1), ArcFault::none);
}

TEST(PeArc, has_no_numbers_that_overflow) {
  for (const double far : {1e160, 1e250, 1e308}) {
    EXPECT_THROW((void)PeArc::from({Vec3::Zero(), 1}, {Vec3::UnitZ(), 0}, {{far, 0, 5}, 1}), Error)
        << far;
  }
}

TEST(PeArc, needs_numbers_that_are_finite) {
  const PeVector start{Vec3::Zero(), 1}, tangent{Vec3::UnitZ(), 0}, end{{0, 0, 5}, 1};
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    for (int place = 0; place < 12; ++place) {
      std::array<PeVector, 3> given{start, tangent, end};
      PeVector& one = given.at(std::size_t(place / 4));
      (place % 4 == 3 ? one.r : one.m[place % 4]) = bad;
      const std::string message = "spheres and tangent must be finite numbers";
      EXPECT_EQ(test::message_of([&] { (void)validity(given[0], given[1], given[2]); },
                                 Errc::invalid_argument),
                message);
      EXPECT_EQ(test::message_of([&] { (void)PeArc::from(given[0], given[1], given[2]); },
                                 Errc::invalid_argument),
                message);
    }
  }
}

}  // namespace
}  // namespace dupin
