#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cyclide/pe_arc_search.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"

namespace dupin::cyclide {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Ends {
  PeVector start, start_tangent, end, end_tangent;
};

Ends skew_ends() {
  return {test::sphere(0, 0, 0, 1), test::direction(Vec3::UnitX(), 0), test::sphere(6, 4, 3, .8),
          test::direction(Vec3(0, 1, 1), .1)};
}

DoubleCyclide at(const Ends& e, double tau) {
  return double_at(e.start, e.start_tangent, e.end, e.end_tangent, tau);
}

TEST(PeArcSearch, every_junction_arrives_in_the_end_tangent) {
  const Ends e = skew_ends();
  for (const double tau : {.3, .5, .7}) {
    const DoubleCyclide pair = at(e, tau);
    EXPECT_EQ(pair.first.start(), e.start);
    EXPECT_EQ(pair.second.end(), e.end);
    EXPECT_EQ(pair.first.end(), pair.second.start());
    EXPECT_LT((pair.second.end_tangent().m - e.end_tangent.m).norm(), 1e-12);
    EXPECT_NEAR(pair.second.end_tangent().r, e.end_tangent.r, 1e-12);
  }
}

TEST(PeArcSearch, best_is_no_worse_than_any_sample) {
  const Ends e = skew_ends();
  int calls = 0;
  const auto objective = [&](const DoubleCyclide& d) {
    ++calls;
    return std::abs(d.first.end().m.x() - 2.75);
  };
  const DoubleCyclide best = best_double(e.start, e.start_tangent, e.end, e.end_tangent, objective);
  const double value = std::abs(best.first.end().m.x() - 2.75);
  for (int i = 1; i < 200; ++i) {
    try {
      EXPECT_GE(std::abs(at(e, i / 200.).first.end().m.x() - 2.75), value - 1e-9);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::infeasible_blend);
    }
  }
  EXPECT_LT(value, 1e-9);
  EXPECT_GT(calls, 0);
}

TEST(PeArcSearch, refuses_where_no_junction_will_do) {
  const Ends e = skew_ends();
  const auto code = [](const Ends& ends, const std::function<double(const DoubleCyclide&)>& f) {
    try {
      (void)best_double(ends.start, ends.start_tangent, ends.end, ends.end_tangent, f);
    } catch (const Error& error) {
      return error.code();
    }
    return Errc::invalid_argument;
  };
  EXPECT_EQ(code(e, [](const DoubleCyclide&) { return kInfinity; }), Errc::infeasible_blend);
  Ends nested = e;  // one sphere in the other: there is no locus
  nested.end = test::sphere(.1, 0, 0, 3);
  EXPECT_EQ(code(nested, [](const DoubleCyclide&) { return 0.; }), Errc::infeasible_blend);
  try {
    (void)at(nested, .5);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
  }
}

// What one ulp of a coordinate does to the tangent is within what may be left by rounding.
TEST(PeArcSearch, tangent_rounding_is_more_than_an_ulp_makes) {
  test::RandomArcs arcs;
  for (int i = 0; i < 100; ++i) {
    const PeArc arc = arcs.next();
    PeVector moved = arc.end();
    moved.m.x() = std::nextafter(moved.m.x(), kInfinity);
    const double allowed = tangent_rounding(arc.start(), arc.end());
    const PeArc other = PeArc::from(arc.start(), arc.start_tangent(), moved);
    const PeVector change = other.end_tangent() - arc.end_tangent();
    EXPECT_LT(std::hypot(change.m.norm(), change.r), allowed * 10 / (1 + arc.w()));
    EXPECT_LT(allowed, 1e-10);
  }
  // It grows with the coordinates.
  const PeVector far{Vec3(1e6, 0, 0), 1}, next{Vec3(1e6 + 3, 0, 0), 1};
  EXPECT_GT(tangent_rounding(far, next),
            1e5 * tangent_rounding({Vec3(0, 0, 0), 1}, {Vec3(3, 0, 0), 1}));
}

}  // namespace
}  // namespace dupin::cyclide
