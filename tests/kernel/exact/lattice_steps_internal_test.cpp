#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "exact/lattice_steps.h"

namespace dupin::exact {
namespace {

constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

TEST(LatticeSteps, give_the_numbers_back) {
  for (const double scale : {0x1p-800, 0x1p-30, 1.0, 0x1p700}) {
    const std::array x{scale, -0x1p-59 * scale, 0x1.fffffffffffffp0 * scale, 0.0, -0.0};
    const auto found = lattice_steps(x);
    ASSERT_TRUE(found.are_whole) << scale;
    for (std::size_t i = 0; i < x.size(); ++i) {
      EXPECT_LT(std::abs(found.steps[i]), std::int64_t{1} << 60);
      EXPECT_EQ(std::ldexp(static_cast<double>(found.steps[i]), found.unit), x[i]) << i;
    }
  }
}

TEST(LatticeSteps, of_zeros_are_none) {
  const auto found = lattice_steps(std::array{0.0, -0.0});
  EXPECT_TRUE(found.are_whole);
  EXPECT_EQ(found.steps, (std::array<std::int64_t, 2>{0, 0}));
}

TEST(LatticeSteps, are_not_whole_beyond_60_bits) {
  EXPECT_TRUE(lattice_steps(std::array{1.0, 0x1p-59}).are_whole);
  EXPECT_FALSE(lattice_steps(std::array{1.0, 0x1p-60}).are_whole);
  EXPECT_FALSE(lattice_steps(std::array{1.0, 0x1p-59, 0x1.8p-59}).are_whole);
  EXPECT_FALSE(lattice_steps(std::array{0x1p900, kSmallest}).are_whole) << "underflows";
  EXPECT_FALSE(lattice_steps(std::array{0x1p1000}).are_whole);
  EXPECT_FALSE(lattice_steps(std::array{kSmallest}).are_whole);
}

TEST(LatticeSteps, have_determinants_of_all_their_bits) {
  constexpr std::int64_t kMost = (std::int64_t{1} << 61) - 1;
  const std::array<std::int64_t, 3> u{kMost, -kMost, kMost}, v{kMost, kMost, -kMost},
      w{kMost, kMost, kMost};
  // (m, -m, m) x (m, m, -m) = (0, 2 m^2, 2 m^2), times w: 4 m^3 = 2^2 (2^183 - 3 2^122 + 3 2^61 -
  // 1)
  const Int192 found = dot(cross(u, v), w);
  EXPECT_EQ(found.low, (std::uint64_t{3} << 63) - 4);
  EXPECT_TRUE(found.high == (Int128{1} << 121) - (Int128{3} << 60) + 1);
}

}  // namespace
}  // namespace dupin::exact
