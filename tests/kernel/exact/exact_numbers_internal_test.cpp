#include <cmath>
#include <limits>
#include <random>

#include <CGAL/Interval_nt.h>
#include <gtest/gtest.h>

#include "exact/exact_numbers.h"
#include "mesh/exact_mesh.h"
#include "mesh/measure.h"
#include "support/shapes.h"

namespace dupin::exact {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

mpq_class power_of_two(int exponent) {
  const mpq_class one = 1;
  const auto shift = static_cast<mp_bitcnt_t>(std::abs(exponent));
  return exponent >= 0 ? mpq_class(one << shift) : mpq_class(one >> shift);
}

TEST(NearestDouble, rounds_to_nearest_and_ties_to_even) {
  const mpq_class half_ulp = power_of_two(-53), tiny = power_of_two(-300);
  const struct {
    const char* description;
    mpq_class value;
    double expected;
  } table[] = {
      {"zero", 0, 0},
      {"one", 1, 1},
      {"a third", mpq_class(1, 3), 1.0 / 3},
      {"minus two thirds", mpq_class(-2, 3), -2.0 / 3},
      {"tie to even below", 1 + half_ulp, 1},
      {"just above a tie", 1 + half_ulp + tiny, 1 + 0x1p-52},
      {"just below a tie", 1 + half_ulp - tiny, 1},
      {"tie to even above", 1 + 3 * half_ulp, 1 + 0x1p-51},
      {"tie below a power of two", 1 - half_ulp / 2, 1},
      {"nearest below a power of two", 1 - half_ulp, 1 - 0x1p-53},
      {"an integer beyond 2^53", power_of_two(60) + 1, 0x1p60},
      {"largest", mpq_class(kLargest), kLargest},
      {"rounds up to infinity", mpq_class(kLargest) + power_of_two(970), kInfinity},
      {"just below that", mpq_class(kLargest) + power_of_two(970) - 1, kLargest},
      {"far beyond", power_of_two(5000), kInfinity},
      {"far beyond, negative", -power_of_two(5000), -kInfinity},
      {"smallest", power_of_two(-1074), kSmallest},
      {"half the smallest", power_of_two(-1075), 0},
      {"more than half the smallest", power_of_two(-1075) + power_of_two(-2000), kSmallest},
      {"subnormal tie", 3 * power_of_two(-1075), 2 * kSmallest},
      {"vanishing", power_of_two(-5000), 0},
  };
  for (const auto& row : table) {
    SCOPED_TRACE(row.description);
    EXPECT_EQ(nearest_double(row.value), row.expected);
  }
}

TEST(NearestDouble, inverts_the_exact_value_of_any_double) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 2000; ++i) {
    const double value = std::ldexp(static_cast<double>(random() >> 11) - 0x1p52,
                                    static_cast<int>(random() % 2000) - 1100);
    EXPECT_EQ(nearest_double(mpq_class(value)), value);
  }
}

TEST(NearestDouble, takes_fractions_of_mpzf_that_are_not_reduced) {
  const CGAL::Mpzf scale = integer(mpz_class("123456789012345678901234567890"));
  EXPECT_EQ(mesh::nearest_double(CGAL::Mpzf(-2) * scale, CGAL::Mpzf(3) * scale), -2.0 / 3);
  EXPECT_EQ(mesh::nearest_double(CGAL::Mpzf(0x1p-900), CGAL::Mpzf(0x1p-1000)), 0x1p100);
}

TEST(ExactIntegers, survive_the_way_to_mpzf_and_back) {
  for (const char* digits : {"0", "1", "-1", "18446744073709551616", "-36893488147419103232",
                             "-123456789012345678901234567890123456789"}) {
    EXPECT_EQ(rational(integer(mpz_class(digits))), mpq_class(digits));
  }
}

TEST(BallsOfExactNumbers, enclose_them) {
  const CGAL::Protect_FPU_rounding<true> upward;
  std::mt19937_64 random(8);
  const auto part = [&] {
    return CGAL::Mpzf(std::ldexp(static_cast<double>(random() >> 11) - 0x1p52,
                                 static_cast<int>(random() % 400) - 200));
  };
  for (int i = 0; i < 2000; ++i) {
    const CGAL::Mpzf number = part() + part() * part() + part() * part() * part();
    const CGAL::Mpzf divisor = part() * part();
    const mpq_class exact = rational(number), quotient = exact / rational(divisor);
    const auto expect_enclosed = [](const Ball& ball, const mpq_class& value) {
      const mpq_class off = abs(value - mpq_class(ball.high()) - mpq_class(ball.low()));
      EXPECT_LE(off, mpq_class(ball.radius()));
      EXPECT_LE(mpq_class(ball.radius()), mpq_class(abs(value) * 0x1p-100 + 0x1p-1000));
    };
    expect_enclosed(ball(number), exact);
    expect_enclosed(ball(quotient), quotient);
  }
  EXPECT_EQ(ball(CGAL::Mpzf(0)).sign(), 0);
  for (const double side : {1, -1}) {
    const CGAL::Mpzf beyond = CGAL::Mpzf(side * 0x1p1000) * CGAL::Mpzf(0x1p1000);
    EXPECT_EQ(ball(beyond).radius(), kInfinity);
    EXPECT_EQ(ball(beyond).sign(), 0);
    EXPECT_EQ(ball(rational(beyond)).sign(), 0);
  }
}

// A unit cube scaled by 1/3 and moved by 10/7 along x, all points but the first implicit.
mesh::ExactMesh cube_of_thirds() {
  const TriMesh cube = test::box(Vec3::Zero(), Vec3::Ones());
  mesh::ExactMesh mesh;
  mesh.triangles = cube.triangles;
  for (const Vec3& point : cube.points) {
    const auto corner = [&](int axis) { return CGAL::Mpzf(point[axis] * 7); };
    mesh.points.push_back(point / 3 + Vec3(10.0 / 7, 0, 0));
    mesh.implicit.push_back({corner(0) + CGAL::Mpzf(30), corner(1), corner(2), 21});
  }
  return mesh;
}

TEST(Measure, implicit_points_count_with_their_exact_coordinates) {
  const mesh::ExactMesh mesh = cube_of_thirds();
  const mesh::MeshView view(mesh);
  EXPECT_EQ(mesh::exact_volume(view), mpq_class(1, 27));
  EXPECT_EQ(mesh::nearest_volume(view), 1.0 / 27);
  EXPECT_EQ(mesh::volume_sign(view), 1);
  EXPECT_NEAR(mesh::area(view), 6.0 / 9, 1e-13);
}

TEST(Measure, the_sign_of_a_volume_of_nothing_is_found_in_the_end) {
  mesh::ExactMesh mesh = cube_of_thirds();
  for (const Triangle& t : std::vector<Triangle>(mesh.triangles)) {
    mesh.triangles.push_back({t[0], t[2], t[1]});
  }
  EXPECT_EQ(mesh::volume_sign(mesh::MeshView(mesh)), 0);
  EXPECT_EQ(mesh::nearest_volume(mesh::MeshView(mesh)), 0);
}

TEST(Neighbours, are_next_to_a_double_on_both_sides) {
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  for (const double value : {1.0, -1.0, 0.1, -3e300, kLeast}) {
    EXPECT_LT(next_below(value), value);
    EXPECT_EQ(next_above(next_below(value)), value);
    EXPECT_EQ(next_below(value), -next_above(-value));
  }
  EXPECT_EQ(next_above(1), 1 + 0x1p-52);
  EXPECT_EQ(next_below(1), 1 - 0x1p-53);
  EXPECT_EQ(next_above(0), kLeast);
}

}  // namespace
}  // namespace dupin::exact
