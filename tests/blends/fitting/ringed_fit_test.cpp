#include "dupin/blends/ringed_fit.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blends/fitting/implicit_surfaces.h"
#include "dupin/blends/part_surface.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using std::numbers::pi;
using testing::HasSubstr;

Ring at_angle(double bend, double radius, double angle) {
  return {{bend * std::cos(angle), bend * std::sin(angle), 0},
          {-std::sin(angle), std::cos(angle), 0},
          radius};
}

std::string message(const ImplicitSurface& surface, const Ring& from, const Ring& to,
                    double tolerance) {
  try {
    (void)fit_ringed(surface, from, to, tolerance);
    return "none";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
    return error.message();
  }
}

TEST(RingedFit, of_a_torus_has_its_volume_and_ends) {
  const double bend = 5, radius = 1, angle = 2;
  const Ring from = at_angle(bend, radius, 0), to = at_angle(bend, radius, angle);
  const RingedFit fit = fit_ringed(test::torus(bend, radius), from, to, 1e-6);
  EXPECT_LE(fit.error, 2e-6);
  EXPECT_LT(fit.circularity_defect, 1e-11);
  double volume_of_all = 0;
  for (std::size_t i = 0; i < fit.pieces.size(); ++i) {
    volume_of_all += volume(fit.pieces[i].surface);
    if (i > 0) {
      EXPECT_EQ(fit.pieces[i].start, flipped(fit.pieces[i - 1].end));
    }
  }
  const double exact = pi * radius * radius * bend * angle;
  EXPECT_NEAR(volume_of_all, exact, 4e-6 * 2 * pi * radius * bend * angle);
  EXPECT_LT((fit.pieces.front().start.center - from.center).norm(), 1e-9);
  EXPECT_LT((fit.pieces.back().end.center - to.center).norm(), 1e-9);
  EXPECT_LT((fit.pieces.back().end.normal - to.normal).norm(), 1e-6);
  // It is a part like any other.
  const Chain chain(fit.pieces);
  EXPECT_LE(tessellate(chain, {segments_for(chain, 0.01), 0, 0}, {0.01}).error_bound, 0.01);
}

// Of the fourth order: a tolerance 16 times finer takes about twice as many pieces.
TEST(RingedFit, of_a_cyclide_converges) {
  const double a = 5, c = 1, mu = 2, b = std::sqrt(a * a - c * c);
  const ImplicitSurface cyclide = test::cyclide(a, c, mu);
  const auto ring = [&](double t) {  // nearly: the circles are not across the spine
    return Ring{{a * std::cos(t), b * std::sin(t), 0},
                Vec3(-a * std::sin(t), b * std::cos(t), 0).normalized(),
                mu - c * std::cos(t)};
  };
  const TravelRing last{ring(1.4).center, ring(1.4).normal, ring(1.4).radius};
  // The end ring is a circle of the surface: found by fitting to a loose one first.
  std::vector<std::size_t> pieces;
  for (const double tolerance : {1e-3, 1e-3 / 16, 1e-3 / 256, 1e-3 / 4096}) {
    const RingedFit near =
        fit_ringed(cyclide, ring(0.2), {last.center, last.normal, last.radius}, 0.4);
    const RingedFit fit = fit_ringed(cyclide, ring(0.2), near.pieces.back().end, tolerance);
    EXPECT_LE(fit.error, 2 * tolerance);
    pieces.push_back(fit.pieces.size());
  }
  EXPECT_LT(pieces[3], 5 * pieces[1]);
  EXPECT_GT(pieces[3], pieces[1]);
}

TEST(RingedFit, refuses_what_is_not_ringed_by_how_much) {
  EXPECT_THAT(message(test::torus(5, 1, 1.3), at_angle(5, 1, 0), at_angle(5, 1, 1), 0.01),
              testing::AllOf(HasSubstr("not ringed: the best circle is 0.1"),
                             HasSubstr("the tolerance is 0.01")));
  EXPECT_EQ(message(test::torus(5, 1, 1.001), at_angle(5, 1, 0), at_angle(5, 1, 1), 0.01), "none");
  // Two cylinders at right angles, blended by a functional spline: its sections are no circles.
  const ImplicitSurface elbow = test::by_differences([](const Vec3& p) {
    const double f1 = 1 - p[1] * p[1] - p[2] * p[2], f2 = 1 - p[0] * p[0] - p[2] * p[2];
    const double f0 = 9 - p.squaredNorm();
    return -(0.9 * f1 * f2 - 0.1 * std::pow(std::max(f0, 0.) / 9, 3));
  });
  EXPECT_NE(message(elbow, {{2.9, 0, 0}, -Vec3::UnitX(), 1}, {{0, 2.9, 0}, Vec3::UnitY(), 1}, 0.01),
            "none");
}

// The same surface in other units, and elsewhere.
TEST(RingedFit, is_the_same_at_any_scale) {
  for (const double scale : {1e-9, 1e-5, 1e-2, 1e2, 1e5, 1e9}) {
    const ImplicitSurface torus = test::torus(5, 1);
    const ImplicitSurface scaled{[&](const Vec3& p) { return torus.value(p / scale); },
                                 [&](const Vec3& p) { return torus.gradient(p / scale); }};
    const RingedFit fit =
        fit_ringed({scaled.value, [&](const Vec3& p) { return Vec3(scaled.gradient(p) / scale); }},
                   at_angle(5 * scale, scale, 0), at_angle(5 * scale, scale, 2), 1e-5 * scale);
    EXPECT_LE(fit.error, 1e-5 * scale);
    EXPECT_LT(fit.circularity_defect, 1e-10 * scale);
    EXPECT_EQ(fit.pieces.size(), 40U) << scale;
  }
}

TEST(RingedFit, keeps_to_the_tolerance_or_is_refused) {
  for (const double height : {1., 1.0001, 1.001, 1.005, 1.01, 1.05}) {
    for (const double tolerance : {1e-9, 1e-6, 6e-5, 1e-4, 6e-4, 1e-3, 6e-3, 0.01, 0.1}) {
      try {
        const RingedFit fit =
            fit_ringed(test::torus(5, 1, height), at_angle(5, 1, 0), at_angle(5, 1, 1), tolerance);
        EXPECT_LE(fit.error, tolerance);
        EXPECT_LE(fit.circularity_defect, tolerance);
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::infeasible_blend);
        EXPECT_GT(height, 1);
        EXPECT_THAT(error.message(),
                    testing::AnyOf(HasSubstr("not ringed"), HasSubstr("do not end in the last")));
      }
    }
  }
}

// What cannot be measured is not near.
TEST(RingedFit, refuses_functions_that_are_no_numbers) {
  const ImplicitSurface torus = test::torus(5, 1);
  const Ring from = at_angle(5, 1, 0);
  const Ring along{{5, 9, 0}, Vec3::UnitY(), 1};  // where nothing but f would lead elsewhere
  for (const double bad : {0., std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 1e300}) {
    const auto gradient = [bad](const Vec3&) -> Vec3 { return Vec3::Constant(bad); };
    EXPECT_THAT(message({torus.value, gradient}, from, along, 0.1), HasSubstr("no circle"));
    if (bad != 0 && bad != 1e300) {
      const auto value = [bad](const Vec3&) { return bad; };
      EXPECT_THAT(message({value, torus.gradient}, from, along, 0.1), HasSubstr("no circle"));
    }
  }
  // From there on it is none.
  const auto torn = [&](const Vec3& p) {
    return p.y() > 2 ? std::numeric_limits<double>::quiet_NaN() : torus.value(p);
  };
  EXPECT_THAT(message({torn, torus.gradient}, from, at_angle(5, 1, 2), 1e-3),
              HasSubstr("no circle of the surface was found near (4.7"));
  EXPECT_NE(message({[&](const Vec3& p) { return torus.value(p) + (p.y() > 2 ? 0.5 : 0); },
                     torus.gradient},
                    from, at_angle(5, 1, 2), 1e-3),
            "none");
}

TEST(RingedFit, refuses_other_ends) {
  const ImplicitSurface torus = test::torus(5, 1);
  EXPECT_THAT(message(torus, at_angle(5, 1, 0), at_angle(5, 1.5, 1), 1e-3),
              HasSubstr("do not end in the last ring"));
  EXPECT_THAT(message(torus, at_angle(5, 1, 0), {{0, 0, 900}, Vec3::UnitZ(), 1}, 1e-3),
              HasSubstr("do not reach the last ring's plane"));
}

TEST(RingedFit, refuses_bad_numbers) {
  const ImplicitSurface torus = test::torus(5, 1);
  const Ring good = at_angle(5, 1, 0), end = at_angle(5, 1, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0., -1., nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)fit_ringed(torus, good, end, bad), Error);
    Ring ring = good;
    ring.radius = bad;
    EXPECT_THROW((void)fit_ringed(torus, ring, end, 1e-3), Error);
    EXPECT_THROW((void)implicit_contour(torus, Vec3::UnitZ(), {6, 0, 0}, {bad}), Error);
  }
  for (const ImplicitSurface& empty :
       {ImplicitSurface{}, ImplicitSurface{torus.value, {}}, ImplicitSurface{{}, torus.gradient}}) {
    EXPECT_THROW((void)fit_ringed(empty, good, end, 1e-3), Error);
    EXPECT_THROW((void)implicit_contour(empty, Vec3::UnitZ(), {6, 0, 0}), Error);
  }
  Ring ring = good;
  ring.normal = {0, 0, 0};
  EXPECT_THROW((void)fit_ringed(torus, good, ring, 1e-3), Error);
  EXPECT_THROW((void)implicit_contour(torus, {0, 0, 0}, {6, 0, 0}), Error);
}

}  // namespace
}  // namespace dupin
