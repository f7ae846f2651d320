#include "dupin/kernel/gap.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using testing::ElementsAre;
using Kind = Deviation::Kind;

double next(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
double previous(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }
mpq_class squared(const mpq_class& x) { return x * x; }

/// 2 to the power of -n.
mpq_class ulp(unsigned n) { return {1, mpz_class(1) << n}; }

// What a port pair must measure as. Everything exact.
struct Case {
  const char* name;
  Ring a, b;
  GapVerdict verdict;
  mpq_class axial_dot, offset_squared, radius_difference, kink_sine_squared;
  std::vector<Kind> deviations;
};

const Ring kStraight{{1, 2, 3}, {1, 0, 0}, 2};
const Ring kOblique{{1, 2, 3}, {0.6, 0, 0.8}, 2};
const mpq_class kSix = 0.6, kEight = 0.8;

Ring beside(Ring ring, const Vec3& center) {
  ring = flipped(ring);
  ring.center = center;
  return ring;
}
Ring with_radius(Ring ring, double radius) {
  ring.radius = radius;
  return ring;
}
Ring with_normal(Ring ring, const Vec3& normal) {
  ring.normal = normal;
  return ring;
}

std::vector<Case> cases() {
  const mpq_class tilt = 1e-15;
  return {
      {"identical", kStraight, flipped(kStraight), GapVerdict::welded, 0, 0, 0, 0, {}},
      {"identical, oblique", kOblique, flipped(kOblique), GapVerdict::welded, 0, 0, 0, 0, {}},
      {"one ulp apart along the axis",
       kStraight,
       beside(kStraight, {next(1), 2, 3}),
       GapVerdict::gap,
       ulp(52),
       0,
       0,
       0,
       {Kind::axial}},
      {"one ulp into each other",
       kStraight,
       beside(kStraight, {previous(1), 2, 3}),
       GapVerdict::overlap,
       -ulp(53),
       0,
       0,
       0,
       {Kind::axial}},
      {"one ulp apart across the axis",
       kStraight,
       beside(kStraight, {1, next(2), 3}),
       GapVerdict::offset,
       0,
       ulp(102),
       0,
       0,
       {Kind::offset}},
      {"one ulp apart across the axis, twice",
       kStraight,
       beside(kStraight, {1, next(2), next(3)}),
       GapVerdict::offset,
       0,
       2 * ulp(102),
       0,
       0,
       {Kind::offset}},
      {"one ulp apart along x, oblique",
       kOblique,
       beside(kOblique, {next(1), 2, 3}),
       GapVerdict::gap,
       ulp(52) * kSix,
       ulp(104) * squared(kEight) / (squared(kSix) + squared(kEight)),
       0,
       0,
       {Kind::axial, Kind::offset}},
      {"one ulp apart across, oblique",
       kOblique,
       beside(kOblique, {1, next(2), 3}),
       GapVerdict::offset,
       0,
       ulp(102),
       0,
       0,
       {Kind::offset}},
      {"radius off by one ulp",
       kStraight,
       with_radius(flipped(kStraight), next(2)),
       GapVerdict::step,
       0,
       0,
       ulp(51),
       0,
       {Kind::radius}},
      {"radius off by one ulp, oblique",
       kOblique,
       with_radius(flipped(kOblique), previous(2)),
       GapVerdict::step,
       0,
       0,
       -ulp(52),
       0,
       {Kind::radius}},
      {"kinked by 1e-15",
       kStraight,
       with_normal(flipped(kStraight), {-1, 1e-15, 0}),
       GapVerdict::kink,
       0,
       0,
       0,
       squared(tilt) / (1 + squared(tilt)),
       {Kind::kink}},
      {"kinked by 1e-15 one ulp apart",
       kStraight,
       with_normal(beside(kStraight, {next(1), 2, 3}), {-1, 1e-15, 0}),
       GapVerdict::gap,
       ulp(52),
       0,
       0,
       squared(tilt) / (1 + squared(tilt)),
       {Kind::axial, Kind::kink}},
      {"normals of different length",
       kStraight,
       with_normal(flipped(kStraight), {-next(1), 0, 0}),
       GapVerdict::kink,
       0,
       0,
       0,
       0,
       {Kind::kink}},
      {"overlapping",
       kStraight,
       beside(kStraight, {-1.5, 2, 3}),
       GapVerdict::overlap,
       -2.5,
       0,
       0,
       0,
       {Kind::axial}},
      {"far",
       kStraight,
       beside(kStraight, {1e6, 2, 7}),
       GapVerdict::gap,
       999999,
       16,
       0,
       0,
       {Kind::axial, Kind::offset}},
      {"everything at once",
       kStraight,
       with_radius(with_normal(beside(kStraight, {3, 2, 7}), {-0.6, 0, 0.8}), 5),
       GapVerdict::gap,
       2,
       16,
       3,
       squared(kEight) / (squared(kSix) + squared(kEight)),
       {Kind::axial, Kind::radius, Kind::kink, Kind::offset}},
      {"looking the same way",
       kStraight,
       beside(flipped(kStraight), {3, 2, 3}),
       GapVerdict::open,
       2,
       0,
       0,
       0,
       {Kind::axial, Kind::kink}},
      {"at a right angle",
       kStraight,
       with_normal(kStraight, {0, 1, 0}),
       GapVerdict::open,
       0,
       0,
       0,
       1,
       {Kind::kink}},
  };
}

std::vector<Kind> kinds(const GapReport& report) {
  std::vector<Kind> found;
  for (const Deviation& deviation : report.deviations) {
    found.push_back(deviation.kind);
  }
  return found;
}

/// Whether the enclosure holds the root of `square` and is at most one double wide.
bool tightly_encloses_root(const Enclosure& e, const mpq_class& square) {
  return squared(e.lower) <= square && square <= squared(e.upper) && e.upper <= next(e.lower);
}

TEST(Gap, is_measured_exactly) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const GapReport report = measure_gap(c.a, c.b);
    EXPECT_EQ(name(report.verdict), name(c.verdict));
    EXPECT_EQ(report.axial_dot, c.axial_dot);
    EXPECT_EQ(report.offset_squared, c.offset_squared);
    EXPECT_EQ(report.radius_difference, c.radius_difference);
    EXPECT_EQ(report.kink_sine_squared, c.kink_sine_squared);
    EXPECT_EQ(report.kink_cosine_squared, 1 - c.kink_sine_squared);
    EXPECT_EQ(kinds(report), c.deviations);
    EXPECT_TRUE(tightly_encloses_root(report.offset, c.offset_squared));
    const Enclosure length = c.axial_dot < 0 ? -report.axial : report.axial;
    EXPECT_TRUE(tightly_encloses_root(length, squared(c.axial_dot) / report.normal_squared));
  }
}

TEST(Gap, of_one_ulp_is_reported_with_its_size) {
  const double size = std::ldexp(1.0, -52);
  const GapReport report = measure_gap(kStraight, beside(kStraight, {next(1), 2, 3}));
  EXPECT_EQ(report.axial, (Enclosure{size, size}));
  EXPECT_THAT(report.deviations, ElementsAre(Deviation{Kind::axial, {size, size}}));
}

TEST(Gap, divides_by_the_length_of_the_stored_normal) {
  Ring a = kStraight;
  a.normal = {next(next(1)), 0, 0};
  const GapReport report = measure_gap(a, beside(a, {4, 2, 3}));
  EXPECT_EQ(report.axial_dot, 3 + 3 * ulp(51));
  EXPECT_EQ(report.normal_squared, squared(1 + ulp(51)));
  EXPECT_EQ(report.axial, (Enclosure{3, 3}));
}

TEST(Gap, kink_angle_is_enclosed) {
  const auto kink = [](const Vec3& normal) {
    return measure_gap(kStraight, with_normal(kStraight, normal)).kink;
  };
  EXPECT_EQ(kink({-1, 0, 0}), (Enclosure{0, 0}));
  const Enclosure tiny = kink({-1, 1e-15, 0});
  // atan x lies between x - x^3/3 and x; x^3/3 is far below an ulp of x.
  EXPECT_EQ(tiny, (Enclosure{previous(1e-15), 1e-15}));
  EXPECT_TRUE(kink({0, 1, 0}).contains(std::numbers::pi / 2));
  EXPECT_TRUE(kink({1, 0, 0}).contains(std::numbers::pi));
  const Enclosure obtuse = kink({std::sqrt(0.5), 0, std::sqrt(0.5)});
  EXPECT_TRUE(obtuse.contains(3 * std::numbers::pi / 4));
  EXPECT_LE(obtuse.upper, next(obtuse.lower));
}

TEST(Gap, swapped_ends_measure_the_same) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const GapReport there = measure_gap(c.a, c.b), back = measure_gap(c.b, c.a);
    EXPECT_EQ(there.distance_squared, back.distance_squared);
    EXPECT_EQ(there.radius_difference, -back.radius_difference);
    EXPECT_EQ(there.kink_sine_squared, back.kink_sine_squared);
    EXPECT_EQ(there.kink, back.kink);
    if (c.b.normal == -c.a.normal) {
      EXPECT_EQ(there.verdict, back.verdict);
      EXPECT_EQ(there.axial_dot, back.axial_dot);
      EXPECT_EQ(there.offset_squared, back.offset_squared);
      EXPECT_EQ(kinds(there), kinds(back));
    }
  }
}

TEST(Gap, does_not_change_when_turned_by_right_angles) {
  const auto turned = [](Ring ring, int axis) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    for (Vec3* v : {&ring.center, &ring.normal}) {
      std::swap((*v)[i], (*v)[j]);
      (*v)[i] = 0 - (*v)[i];
    }
    return ring;
  };
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(measure_gap(turned(c.a, axis), turned(c.b, axis)), measure_gap(c.a, c.b));
    }
  }
}

TEST(Gap, change_of_slope_is_listed_but_opens_nothing) {
  Ring cone = flipped(kStraight);
  cone.slope = 0.25;
  const GapReport report = measure_gap(kStraight, cone);
  EXPECT_EQ(report.verdict, GapVerdict::welded);
  EXPECT_EQ(report.slope_difference, mpq_class(1, 4));
  EXPECT_THAT(report.deviations, ElementsAre(Deviation{Kind::slope, {0.25, 0.25}}));
}

const Ellipse kFlat{Vec3(0, 0.6, 0.8), 1};

Ring elliptic(const Ellipse& ellipse) {
  Ring ring = kStraight;
  ring.ellipse = ellipse;
  return ring;
}

TEST(Gap, of_ellipses_compares_both_semi_axes_and_their_directions) {
  const Ring a = elliptic(kFlat);
  struct Row {
    const char* name;
    Ring b;
    GapVerdict verdict;
    mpq_class across_difference, turn_sine_squared;
    std::vector<Kind> deviations;
  };
  Ring exchanged = elliptic({Vec3(0, -0.8, 0.6), 2});
  exchanged.radius = 1;
  const mpq_class long_side = kSix * kSix + kEight * kEight;
  const std::vector<Row> rows{
      {"the same", flipped(a), GapVerdict::welded, 0, 0, {}},
      {"axis reversed", flipped(elliptic({-kFlat.axis, 1})), GapVerdict::welded, 0, 0, {}},
      {"axes exchanged", flipped(exchanged), GapVerdict::welded, 0, 0, {}},
      {"a circle", flipped(kStraight), GapVerdict::step, 1, 0, {Kind::across}},
      {"thinner",
       flipped(elliptic({kFlat.axis, 0.75})),
       GapVerdict::step,
       mpq_class(-1, 4),
       0,
       {Kind::across}},
      {"turned",
       flipped(elliptic({Vec3(0, 0, 1), 1})),
       GapVerdict::turn,
       0,
       kSix * kSix / long_side,
       {Kind::turn}},
      {"of another slope",
       flipped(elliptic({kFlat.axis, 1, 0.5})),
       GapVerdict::welded,
       0,
       0,
       {Kind::slope}}};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    const GapReport report = measure_gap(a, row.b);
    EXPECT_EQ(name(report.verdict), name(row.verdict));
    EXPECT_EQ(report.across_difference, row.across_difference);
    EXPECT_EQ(report.turn_sine_squared, row.turn_sine_squared);
    EXPECT_EQ(kinds(report), row.deviations);
    EXPECT_TRUE(report.turn.contains(std::asin(std::sqrt(row.turn_sine_squared.get_d()))) ||
                report.turn.upper - report.turn.lower < 1e-15);
  }
}

TEST(Gap, of_an_invalid_ring_is_refused) {
  EXPECT_THROW((void)measure_gap(kStraight, with_radius(kStraight, -1)), Error);
  EXPECT_THROW((void)measure_gap(with_normal(kStraight, {0, 0, 0}), kStraight), Error);
}

}  // namespace
}  // namespace dupin
