#include <cmath>

#include <gtest/gtest.h>

#include "assembly/parts/start_ring.h"
#include "blends/assembly/part_fixture_internal.h"
#include "dupin/blends/rational_ringed_surface.h"

namespace dupin::assembly {
namespace {

using test::fault_of;
using test::LonePart;

const LonePart kPipe(PipeAlong{});
const Vec3 kZero = Vec3::Zero();

TEST(StartRing, looks_against_the_direction_of_travel) {
  const Ring ring = start_between(kPipe.context(), {1, 2, 3}, {1, 2, 8}, 0.5, {}, kSection);
  EXPECT_EQ(ring, (Ring{Vec3(1, 2, 3), Vec3(0, 0, -1), 0.5}));
  EXPECT_FALSE(std::signbit(ring.normal.x())) << "no -0, which is not 0 bitwise";
  const Place place{{1, 2, 3}, {0, 0, 7}, 0.5};
  EXPECT_EQ(origin(kPipe.context(), place, kSection), ring);
}

TEST(StartRing, of_a_port_is_its_ring_turned_round) {
  const PartSurface cone = oblique_tube(kZero, Vec3(0, 0, 4), Vec3::UnitZ(), 2, 1);
  const LonePart part(PipeAlong{}, {{"a", cone}});
  const Ring ring = origin(part.context(), PortReference{"a", End::end}, kSection);
  EXPECT_EQ(ring.center, Vec3(0, 0, 4));
  EXPECT_EQ(ring.normal, Vec3(0, 0, -1));
  EXPECT_EQ(ring.radius, 1);
  EXPECT_EQ(ring.slope, 0.25) << "against travel, the cone widens";
}

TEST(StartRing, of_an_ellipse_has_the_part_of_its_axis_across_travel) {
  const SectionAxes axes{{3, 4, 12}, 0.25};
  const Ring ring = start_between(kPipe.context(), kZero, {0, 0, 9}, 0.5, axes, kSection);
  ASSERT_TRUE(ring.ellipse);
  EXPECT_LT((ring.ellipse->axis - Vec3(0.6, 0.8, 0)).norm(), 1e-15);
  EXPECT_EQ(ring.radius, 0.5);
  EXPECT_EQ(ring.ellipse->across, 0.25);
  EXPECT_NO_THROW(validate(ring));
  // Any axis but those along the normal, whatever their length.
  EXPECT_EQ(axis_across(kPipe.context(), Vec3::UnitX(), {1, 0, 1e-9}), Vec3(0, 0, 1));
}

TEST(StartRing, says_which_number_is_wrong) {
  const Vec3 bad(0, std::nan(""), 0), x = Vec3::UnitX();
  const auto between = [&](const Vec3& from, const Vec3& to, double radius,
                           const std::optional<SectionAxes>& axes = {}) {
    return fault_of(
        [&] { return start_between(kPipe.context(), from, to, radius, axes, kSection); });
  };
  const auto at = [&](const Vec3& point, const Vec3& direction, double radius) {
    return fault_of([&] {
      return origin(kPipe.context(), Place{point, direction, radius}, kSection);
    });
  };
  const std::string coordinates = "coordinates must be finite numbers of at most 1e12";
  const std::string positive = "must be a positive number between 1e-12 and 1e12, not ";
  const std::pair<std::string, std::string> rows[] = {
      {between(bad, x, 1), "pipe/from: " + coordinates},
      {between(kZero, bad, 1), "pipe/to: " + coordinates},
      {between(x, x, 1), "pipe/to: the point must be 1e-12 or more away from the one at 'from'"},
      {between(kZero, x, 0), "pipe/radius: " + positive + "0"},
      {between(kZero, x, 0, SectionAxes{Vec3::UnitY(), 1}), "pipe/semi_axes/0: " + positive + "0"},
      {between(kZero, x, 1, SectionAxes{Vec3::UnitY(), -2}),
       "pipe/semi_axes/1: " + positive + "-2"},
      {between(kZero, x, 1, SectionAxes{bad, 1}), "pipe/axis: " + coordinates},
      {between(kZero, x, 1, SectionAxes{-2 * x, 1}),
       "pipe/axis: the axis must have a part across the direction of travel"},
      {at(bad, x, 1), "pipe/from: " + coordinates},
      {at(kZero, bad, 1), "pipe/direction: " + coordinates},
      {at(kZero, kZero, 1), "pipe/direction: the direction must not be zero"},
      {at(kZero, x, -1), "pipe/radius: " + positive + "-1"},
  };
  for (const auto& [fault, expected] : rows) {
    EXPECT_EQ(fault, expected);
  }
}

// A cone has its radii in one list.
TEST(StartRing, names_the_keys_it_is_told) {
  const SectionKeys keys{"radii/0", "semi_axes/0/0", "semi_axes/0/1"};
  const auto fault = [&](const Place& place) {
    const std::string text = fault_of([&] { return origin(kPipe.context(), place, keys); });
    return text.substr(0, text.find(':'));
  };
  const SectionAxes axes{Vec3::UnitX(), -1};
  EXPECT_EQ(fault({kZero, Vec3::UnitZ(), -1}), "pipe/radii/0");
  EXPECT_EQ(fault({kZero, Vec3::UnitZ(), -1, axes}), "pipe/semi_axes/0/0");
  EXPECT_EQ(fault({kZero, Vec3::UnitZ(), 1, axes}), "pipe/semi_axes/0/1");
}

}  // namespace
}  // namespace dupin::assembly
