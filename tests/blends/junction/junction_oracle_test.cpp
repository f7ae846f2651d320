// Table C11 of the mathematics, computed with 40 digits: hub junctions.
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/junction.h"

namespace dupin {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// A pipe towards the origin from this distance.
Ring towards_origin(const Vec3& from, double radius, double distance) {
  const Vec3 direction = from.normalized();
  return {distance * direction, -direction, radius};
}

std::vector<Ring> three_at_120_degrees(double distance) {
  std::vector<Ring> ends;
  for (int i = 0; i < 3; ++i) {
    const double angle = i * 120 * kDegree;
    ends.push_back(towards_origin({std::cos(angle), std::sin(angle), 0}, 1, distance));
  }
  return ends;
}

std::vector<Ring> six(double distance) {
  std::vector<Ring> ends;
  for (int i = 0; i < 3; ++i) {
    ends.push_back(towards_origin(Vec3::Unit(i), 1, distance));
    ends.push_back(towards_origin(-Vec3::Unit(i), 1, distance));
  }
  return ends;
}

std::vector<Ring> tee(double distance, double branch_distance) {
  return {towards_origin(Vec3::UnitX(), 1, distance), towards_origin(-Vec3::UnitX(), 1, distance),
          towards_origin(Vec3::UnitZ(), 0.7, branch_distance)};
}

Junction at_the_ends(const std::vector<Ring>& ends, double radius) {
  return junction_of(ends, {Vec3(0, 0, 0), radius, {}, 1});
}

struct Row {
  std::vector<double> angles, powers;  // of the caps in degrees, of the collars
  double volume, area;
};

void expect_row(const Junction& junction, const Row& row, double digits = 1e-10) {
  for (std::size_t i = 0; i < junction.arms.size(); ++i) {
    const JunctionArm& arm = junction.arms[i];
    EXPECT_FALSE(arm.straight.has_value());
    EXPECT_NEAR(cap_angle(arm) / kDegree, row.angles[i], 1e-9);
    EXPECT_NEAR(arm.collar.least_power(), row.powers[i], digits * 100);
  }
  EXPECT_NEAR(volume(junction), row.volume, 1e-11 * row.volume);
  EXPECT_NEAR(area(junction), row.area, 1e-11 * row.area);
}

TEST(JunctionOracle, rings_at_given_places) {
  const double y = 53.9916767882, x = 41.5445093641, z = 34.6010543839, six_way = 36.8698976458;
  expect_row(at_the_ends(three_at_120_degrees(4), 2.3),
             {{y, y, y}, {11.71, 11.71, 11.71}, 76.3173444209609, 94.2466870366047});
  expect_row(at_the_ends(tee(4, 4), 2.8),
             {{x, x, z}, {9.16, 9.16, 8.65}, 107.047941338127, 112.568136687482});
  expect_row(at_the_ends(six(4), 3),
             {std::vector(6, six_way), std::vector(6, 8.0), 142.109140392094, 134.351013123807});
}

TEST(JunctionOracle, least_hubs_of_disjoint_caps) {
  const auto is_sound = [](const std::vector<Ring>& ends, double radius) {
    return search_junction(ends, {Vec3(0, 0, 0), radius, {}, 1}).junction.has_value();
  };
  const std::array<std::pair<std::vector<Ring>, double>, 3> least{
      {{three_at_120_degrees(4), 2.07179676972449},
       {tee(4, 4), 2.50884263785449},
       {six(4), 2.65685424949238}}};
  for (const auto& [ends, radius] : least) {
    EXPECT_TRUE(is_sound(ends, radius * 1.04));
    const auto refused = search_junction(ends, {Vec3(0, 0, 0), radius * (1 - 1e-9), {}, 1});
    ASSERT_FALSE(refused.junction.has_value());
    EXPECT_NE(refused.reason.find("caps"), std::string::npos) << refused.reason;
  }
}

TEST(JunctionOracle, compact_hubs) {
  const auto compact = [](const std::vector<Ring>& ends, const std::vector<double>& degrees,
                          double radius) {
    JunctionOptions options{Vec3(0, 0, 0), radius};
    for (const double angle : degrees) {
      options.cap_angles.push_back(angle * kDegree);
    }
    return junction_of(ends, options);
  };
  // With room to spare the collars begin at the setback.
  const Junction far = compact(three_at_120_degrees(4), {57, 57, 57}, 1.37121778676134);
  for (const JunctionArm& arm : far.arms) {
    EXPECT_NEAR(straight_length(arm), 4 - 1.25321024556582, 1e-12);
    EXPECT_NEAR(cap_angle(arm) / kDegree, 57, 1e-11);
  }
  expect_row(compact(three_at_120_degrees(1.25321024556582), {57, 57, 57}, 1.37121778676134),
             {{57, 57, 57}, std::vector(3, 0.6902977), 11.7796315717852, 18.093537163397});
  expect_row(compact(tee(1.42622801064659, 1.81742166191411), {48, 48, 40}, 1.54747763904733),
             {{48, 48, 40}, {0.6394393, 0.6394393, 1.3983345}, 16.6169932643474, 25.8914756100555},
             1e-9);
  expect_row(
      compact(six(1.57820039861382), std::vector(6, 43.0), 1.68622106348557),
      {std::vector(6, 43.0), std::vector(6, 0.64737502), 21.2760069920927, 22.2670882541585});
}

// Ends with a half angle of this sine.
Ring skew_end(const Vec3& at, double radius, const Vec3& axis, double sine) {
  const double cosine = std::sqrt(1 - sine * sine);
  // The table's spheres and tangents: (at; radius), sine being that of the half angle.
  return contact_ring({at, radius}, {axis.normalized() / cosine, sine / cosine});
}

TEST(JunctionOracle, four_skew_ends) {
  const std::vector<Ring> ends{
      skew_end({-5, .3, 0}, 1, {1, 0, 0}, 0), skew_end({4.5, -.2, .4}, .8, {-1, .1, 0}, .1),
      skew_end({.2, 5, .3}, .6, {0, -1, .05}, -.05), skew_end({-.1, .2, 5.2}, 1.1, {.1, 0, -1}, 0)};
  const Junction junction =
      junction_of(ends, {{}, 2.0, {39 * kDegree, 41 * kDegree, 39 * kDegree, 39 * kDegree}});
  EXPECT_LT(
      (junction.hub.center - Vec3(0.292594237602506, 0.244018126564582, 0.315578273864794)).norm(),
      1e-12);
  const std::array slides{3.2366053402986, 2.2542740189327, 1.5349079696528, 3.0171301287649};
  const std::array w{1.1267064487142, 1.0982117346347, 1.1491424750115, 1.1363243279494};
  const std::array power{0.688803457275, 1.14764118471, 6.24184527146, 0.532304429937};
  double straights_area = 0, straights_volume = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const JunctionArm& arm = junction.arms[i];
    EXPECT_NEAR(straight_length(arm), slides.at(i), 1e-11);
    EXPECT_NEAR(arm.collar.w(), w.at(i), 1e-11);
    EXPECT_NEAR(arm.collar.least_power(), power.at(i), 1e-10);
    straights_area += area(*arm.straight);
    straights_volume += volume(*arm.straight);
  }
  EXPECT_NEAR(margins(junction).cap_gap / kDegree, 6.638508714913, 1e-10);
  EXPECT_NEAR(volume(junction) - straights_volume, 37.2071679992357, 1e-10);
  EXPECT_NEAR(area(junction) - straights_area, 47.763401072936, 1e-10);
}

}  // namespace
}  // namespace dupin
