#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "assembly/parts/part_checks.h"
#include "blends/assembly/part_fixture_internal.h"
#include "dupin/blends/rational_ringed_surface.h"

namespace dupin::assembly {
namespace {

using test::fault_of;
using test::LonePart;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const LonePart kSphere(SphereAt{});

TEST(PartChecks, positive_numbers_are_within_bounds) {
  const auto check = [](double value) {
    return fault_of([&] {
      check_positive(kSphere.context(), value, "radius");
      return 0;
    });
  };
  for (const double value : {1e-12, 1.0, 1e12}) {
    EXPECT_EQ(check(value), "");
  }
  const std::pair<double, const char*> rows[] = {
      {0, "0"}, {-1, "-1"}, {9e-13, "9e-13"}, {2e12, "2e+12"}, {kNan, "nan"}, {kInfinity, "inf"}};
  for (const auto& [value, text] : rows) {
    EXPECT_EQ(check(value),
              "sphere/radius: must be a positive number between 1e-12 and 1e12, not " +
                  std::string(text));
  }
}

TEST(PartChecks, coordinates_are_finite_and_not_too_large) {
  const auto check = [](const Vec3& v) {
    return fault_of([&] {
      check_finite(kSphere.context(), v, "center");
      return 0;
    });
  };
  EXPECT_EQ(check(Vec3(1e12, -1e12, 0)), "");
  for (int k = 0; k < 3; ++k) {
    for (const double bad : {kNan, kInfinity, -2e12}) {
      Vec3 v(1, 2, 3);
      v[k] = bad;
      EXPECT_EQ(check(v), "sphere/center: coordinates must be finite numbers of at most 1e12");
    }
  }
}

TEST(PartChecks, deviations_are_held_against_the_tolerance) {
  const auto check = [](double deviation) {
    return fault_of([&] {
      check_within_tolerance(kSphere.context(), deviation, "center", "it is off");
      return 0;
    });
  };
  EXPECT_EQ(check(0.05), "");
  for (const double deviation : {0.0501, kNan}) {
    EXPECT_EQ(check(deviation), "sphere/center: it is off, more than the tolerance of 0.05 allows");
  }
}

TEST(PartChecks, speeds_are_positive_where_they_are_given) {
  const auto check = [](std::optional<double> k, std::optional<double> l) {
    return fault_of([&] {
             check_speeds(kSphere.context(), k, l);
             return 0;
           })
        .substr(0, 9);
  };
  EXPECT_EQ(check({}, {}), "");
  EXPECT_EQ(check(1, 2), "");
  EXPECT_EQ(check(0, {}), "sphere/k:");
  EXPECT_EQ(check({}, -1), "sphere/l:");
}

// Of circles of radius 2 and 1 from (0, 0, 0) to (a, 0, 4), in planes across z.
PartSurface cone(double aside) {
  return oblique_tube(Vec3::Zero(), Vec3(aside, 0, 4), Vec3::UnitZ(), 2, 1);
}

TEST(PartChecks, right_ends_are_those_whose_circles_do_not_move_aside) {
  const LonePart part(PipeAlong{}, {{"right", cone(0)}, {"oblique", cone(0x1p-20)}});
  for (const End end : {End::start, End::end}) {
    const Ring& ring = right_end(part.context(), {"right", end}, "from");
    EXPECT_EQ(ring, *port_ring(cone(0), end));
    EXPECT_EQ(fault_of([&] {
                return right_end(part.context(), {"oblique", end}, "from");
              }),
              "pipe/from: 'oblique." + std::string(name(end)) +
                  "' ends an oblique cylinder or cone; only a ringed_blend or a junction goes on "
                  "from there");
  }
}

// A torus' circles turn as they move: no obstacle.
TEST(PartChecks, right_ends_may_be_those_of_bends) {
  const RingedSurface bend{{Vec3(3, 0, 0), Vec3(0, -1, 0), 1},
                           {Vec3(0, 3, 0), Vec3(-1, 0, 0), 1},
                           ArcSpine{Vec3::Zero(), Vec3::UnitZ(), Vec3(3, 0, 0), std::acos(0.0)},
                           ConstantRadius{1}};
  const LonePart part(PipeAlong{}, {{"bend", bend}});
  EXPECT_EQ(right_end(part.context(), {"bend", End::end}, "from"), bend.end);
}

}  // namespace
}  // namespace dupin::assembly
