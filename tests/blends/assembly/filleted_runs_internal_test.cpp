#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <set>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/filleted_runs.h"
#include "blends/assembly/filleted_tee.h"
#include "dupin/blends/build.h"
#include "dupin/blends/canal_fillet.h"
#include "dupin/kernel/error.h"
#include "support/named_parts.h"

namespace dupin {
namespace {

using test::fillet;
using test::FilletIntegrals;
using test::Measures;
using test::pipe;
using test::Tee;

constexpr double kPi = std::numbers::pi;

Assembly assembly(std::vector<Part> parts, double tolerance = 0.02) {
  return {"d.json", Unit::millimetre, tolerance, {}, std::move(parts)};
}

void expect_second_order(const std::function<Assembly(double)>& document) {
  const Measures expected = FilletIntegrals(resolve(document(0.02))).whole();
  const auto faults = [&](double tolerance) {
    const Built built = build(document(tolerance));
    const double volume = built.solid.exact_volume().get_d(), area = built.solid.area();
    EXPECT_LT(std::abs(volume - expected.flux / 3), tolerance * area);
    return std::array{std::abs(volume - expected.flux / 3), std::abs(area - expected.area)};
  };
  const auto coarse = faults(0.02), fine = faults(0.001);
  EXPECT_LT(fine[0], coarse[0] / 10) << "a twentieth of the tolerance";
  EXPECT_LT(fine[1], coarse[1] / 10);
}

TEST(FilletedRuns, volumes_and_areas_tend_to_those_of_independent_integrals_at_second_order) {
  for (const Tee& tee : {Tee{0.5, 0, kPi / 2, 0.3}, Tee{0.75, 0, kPi / 3, 0.2}}) {
    expect_second_order([&](double tolerance) { return tee.document(true, tolerance); });
  }
}

// Pipes of one radius, or nearly so, that pass through each other: by one pipe, or by a branch on
// either side.
Assembly cross(double degrees, double radius, bool of_branches, double tolerance = 0.02) {
  const double angle = degrees * kPi / 180;
  const Vec3 end = 60 * Vec3(std::cos(angle), std::sin(angle), 0);
  std::vector<Part> parts{pipe("run", {-60, 0, 0}, {60, 0, 0}, 4)};
  if (of_branches) {
    parts.push_back(pipe("there", {0, 0, 0}, end, radius));
    parts.push_back(pipe("back", {0, 0, 0}, -end, radius));
    parts.push_back(fillet("throat-there", "run", "there", 0.6));
    parts.push_back(fillet("throat-back", "run", "back", 0.9));
  } else {
    parts.push_back(pipe("through", -end, end, radius));
    parts.push_back(fillet("throats", "run", "through", 0.6));
  }
  return assembly(std::move(parts), tolerance);
}

TEST(FilletedRuns, equal_pipes_may_pass_through_each_other) {
  for (const double degrees : {90, 70, 45, 30}) {
    for (const bool of_branches : {false, true}) {
      SCOPED_TRACE(testing::Message() << degrees << ' ' << of_branches);
      Assembly document = cross(degrees, 4, of_branches);
      const Built built = build(document);
      EXPECT_EQ(built.solid.genus(), 0);
      EXPECT_EQ(built.solid.components(), 1U);
      EXPECT_EQ(built.pieces, 1U) << "nothing is intersected";
      document.wall = 0.2;
      EXPECT_EQ(build(document).solid.genus(), 3) << "four openings";
    }
  }
  expect_second_order([](double tolerance) { return cross(90, 4, false, tolerance); });
  expect_second_order([](double tolerance) { return cross(55, 4, true, tolerance); });
}

// Two on one run, turned against each other, so that the holes of one reach between those of the
// other.
TEST(FilletedRuns, crosses_of_nearly_equal_pipes_may_be_nested) {
  const Vec3 along = Vec3::UnitX();
  for (const double less : {0., 1e-3, 0.02, 0.1}) {
    for (const double degrees : {90., 60., 45., 30., 10.}) {
      for (const bool touch : {false, true}) {
        const double radius = 4 - less, reach = radius + 0.2, turn = degrees * kPi / 180;
        const double apart = 1.02 * reach * 2 * std::max(std::cos(turn / 2), std::sin(turn / 2));
        std::vector<Part> parts{pipe("run", -60 * along, 60 * along, 4)};
        for (const double sign : {-1., 1.}) {
          const double angle = sign * turn / 2;
          const Vec3 ahead(0, std::cos(angle), std::sin(angle)), aside = along.cross(ahead);
          const Vec3 at = sign * apart / 2 * along + (touch ? less : 0) * aside;
          const std::string name = sign < 0 ? "a" : "b";
          parts.push_back(pipe(name, at - 30 * ahead, at + 30 * ahead, radius));
          parts.push_back(fillet("f" + name, "run", name, 0.2));
        }
        for (const double tolerance : {0.2, 0.02}) {
          SCOPED_TRACE(testing::Message()
                       << less << ' ' << degrees << ' ' << touch << ' ' << tolerance);
          const Built built = build(assembly(parts, tolerance));
          EXPECT_EQ(built.solid.genus(), 0);
          EXPECT_EQ(built.pieces, 1U);
        }
      }
    }
  }
}

// However few triangles an unrolled run is wide: what is near the cross on it is no part of it.
TEST(FilletedRuns, an_equal_cross_goes_with_other_branches_at_any_tolerance) {
  for (const double tolerance : {1., 0.4, 0.1, 0.02}) {
    for (const double at : {-22, 24}) {
      for (const double angle : {0., 40., 90.}) {
        SCOPED_TRACE(testing::Message() << tolerance << ' ' << at << ' ' << angle);
        const Vec3 from(at, 0, 0);
        const Vec3 along(0, std::cos(angle * kPi / 180), std::sin(angle * kPi / 180));
        for (const double begins : {-20, 0}) {
          Assembly document = cross(90, 4, true, tolerance);
          document.parts.push_back(pipe("other", from + begins * along, from + 20 * along, 2));
          document.parts.push_back(fillet("other-throat", "run", "other", 0.5));
          EXPECT_EQ(build(document).solid.genus(), 0);
        }
      }
    }
  }
}

// It touches the run from inside on one side, and leaves a way of two segments on the other.
TEST(FilletedRuns, pipes_may_touch_and_all_but_touch) {
  const Assembly document = assembly(
      {pipe("run", {-120, 0, 0}, {120, 0, 0}, 10),
       pipe("through", {0, -60, 0.1}, {0, 60, 0.1}, 9.9), fillet("f", "run", "through", 0.495)},
      0.05);
  const Built built = build(document);
  EXPECT_EQ(built.solid.genus(), 0);
  for (const PartReport& part : built.parts) {
    EXPECT_LE(part.error_bound, 0.05) << part.name;
  }
}

// Their curves leave a narrow way past each other, as those of pipes whose axes miss do.
TEST(FilletedRuns, pipes_may_be_equal_but_for_rounding) {
  const double equal = build(cross(60, 4, false)).solid.exact_volume().get_d();
  for (const double less : {1e-2, 1e-3, 1e-5, 1e-7, 1e-12}) {
    SCOPED_TRACE(less);
    const Built thinner = build(cross(60, 4 * (1 - less), false));
    EXPECT_EQ(thinner.solid.genus(), 0);
    for (const PartReport& part : thinner.parts) {
      EXPECT_LE(part.error_bound, 0.02) << part.name;
    }
    EXPECT_NEAR(thinner.solid.exact_volume().get_d(), equal, 1 + equal * less);
    std::vector<Part> parts = cross(60, 4, false).parts;
    auto& through = std::get<PipeBetween>(parts[1].shape);
    through.from.z() = through.to.z() = 4 * less;
    const Built aside = build(assembly(parts));
    EXPECT_EQ(aside.solid.genus(), 0);
    EXPECT_NEAR(aside.solid.exact_volume().get_d(), equal, 1 + equal * less);
  }
}

struct RandomPlant {
  std::mt19937 engine;

  double in(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  // Coordinates of plants: few digits, or many.
  double coordinate() {
    const double x = in(-5000, 5000);
    return engine() % 2 == 0 ? std::round(x * 10) / 10 : x;
  }
  // A pipe of one radius that goes through another, or ends in it.
  Assembly filleted_pipes() {
    const bool is_along_axes = engine() % 2 == 0, passes = engine() % 3 != 0;
    const Vec3 at(coordinate(), coordinate(), coordinate());
    const Vec3 any = Vec3(in(-1, 1), in(-1, 1), in(-1, 1)).normalized();
    const Vec3 along = is_along_axes ? Vec3(Vec3::Unit(engine() % 3)) : any;
    const Vec3 first = along.unitOrthogonal(), second = along.cross(first);
    const double turn = is_along_axes ? kPi / 2 * double(engine() % 4) : in(0, 2 * kPi);
    const double lean = engine() % 2 == 0 ? 0 : in(-0.7, 0.7);  // away from perpendicular
    const Vec3 aside = std::cos(turn) * first + std::sin(turn) * second;
    const Vec3 direction = std::cos(lean) * aside + std::sin(lean) * along;
    const double radius = in(15, 40), branch = radius * in(0.3, 0.9);
    const double tolerance = std::vector{0.5, 0.2, 0.1, 0.05}[engine() % 4];
    return assembly({pipe("run", at - 8 * radius * along, at + 8 * radius * along, radius),
                     pipe("branch", passes ? Vec3(at - 6 * radius * direction) : at,
                          at + 6 * radius * direction, branch),
                     fillet("throat", "run", "branch", branch * in(0.05, 0.2))},
                    tolerance);
  }
};

TEST(FilletedRuns, are_made_wherever_a_plant_has_them) {
  RandomPlant plant{std::mt19937(20)};
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    const Built built = build(plant.filleted_pipes());
    EXPECT_EQ(built.solid.genus(), 0);
    EXPECT_EQ(built.pieces, 1U);
  }
}

TEST(FilletedRuns, names_every_patch) {
  const Built built = build(Tee{0.5, 0, kPi / 2, 0.3}.document(true));
  EXPECT_THAT(built.solid.names(), testing::UnorderedElementsAre("run", "run.start", "run.end",
                                                                 "branch", "branch.end", "throat"));
  const std::set<std::uint32_t> used(built.solid.labels().begin(), built.solid.labels().end());
  EXPECT_EQ(used.size(), built.solid.names().size());
  ASSERT_EQ(built.parts.size(), 3U);
  EXPECT_EQ(built.parts[2].kind, "fillet");
  EXPECT_GT(built.parts[2].triangles, 0U);
  for (const PartReport& part : built.parts) {
    EXPECT_GT(part.error_bound, 0) << part.name;
    EXPECT_LE(part.error_bound, 0.02) << part.name;
    EXPECT_GT(part.segments, 0U) << part.name;
  }
  ASSERT_EQ(built.ports.size(), 3U) << "branch.start is inside the run";
}

// Whatever is joined to the pipes' other ends stays: a header of elbows and caps.
TEST(FilletedRuns, join_any_number_of_runs) {
  std::vector<Part> parts{pipe("run", {0, 0, 0}, {60, 0, 0}, 4)};
  for (int i = 0; i < 5; ++i) {
    const std::string name = "branch-" + std::to_string(i);
    parts.push_back({"throat-" + std::to_string(i), FilletBetween{{name, "run"}, 0.5}});
    parts.push_back(pipe(name, {6. + 12 * i, 0, 0}, {6. + 12 * i, 0, 12}, 2));
    parts.push_back({"elbow-" + std::to_string(i),
                     ElbowTurning{PortReference{name, End::end}, 5, kPi / 2, {0, 1, 0}}});
  }
  const Built built = build(assembly(parts));
  EXPECT_EQ(built.pieces, 1U);
  EXPECT_EQ(built.runs, 6U);
  EXPECT_EQ(built.solid.genus(), 0);
  EXPECT_EQ(built.parts[1].name, "throat-0") << "reports are in the document's order";
  EXPECT_EQ(built.parts.size(), 16U);
}

// A part that crosses the solid elsewhere is united with it.
TEST(FilletedRuns, are_united_with_what_crosses_them) {
  std::vector<Part> parts = Tee{0.5, 0, kPi / 2, 0.3}.document(true).parts;
  parts.push_back({"ball", SphereAt{{4, 4, 0}, 2}});
  const Built built = build(assembly(parts));
  EXPECT_EQ(built.pieces, 2U);
  EXPECT_EQ(built.solid.components(), 1U);
}

}  // namespace
}  // namespace dupin
