#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "exact/float_lattice.h"

namespace dupin::exact {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(Lattice, rounds_to_the_nearest_float_with_ties_to_even) {
  const FloatLattice floats(Coordinates::binary32);
  std::mt19937_64 random(5);
  for (int i = 0; i < 100000; ++i) {
    const auto bits = random();
    const double value =
        std::ldexp(static_cast<double>(bits >> 11), static_cast<int>(bits % 260) - 190);
    const auto expected = static_cast<double>(static_cast<float>(value));
    for (const double sign : {1.0, -1.0}) {
      ASSERT_EQ(floats.nearest(sign * value), sign * expected) << value;
      ASSERT_EQ(floats.nearest(sign * value, [] { return 0; }), sign * expected) << value;
    }
  }
}

TEST(Lattice, asks_which_side_of_a_tie_the_exact_number_lies) {
  const FloatLattice floats(Coordinates::binary32);
  const double even = 1, odd = 1 + 0x1p-23, between = 1 + 0x1p-24;
  EXPECT_EQ(floats.nearest(between, [] { return -1; }), even);
  EXPECT_EQ(floats.nearest(between, [] { return 0; }), even);
  EXPECT_EQ(floats.nearest(between, [] { return 1; }), odd);
  EXPECT_EQ(floats.nearest(-between, [] { return -1; }), -odd);
  EXPECT_EQ(floats.nearest(-between, [] { return 1; }), -even);
}

TEST(Lattice, steps_from_number_to_number) {
  const FloatLattice floats(Coordinates::binary32), doubles(Coordinates::binary64);
  for (const float start : {0.0F, 1.0F, -1.0F, 1.5F, 0x1p-149F, -0x1p-126F, 3e38F}) {
    float up = start, down = start;
    for (int count = 1; count <= 3; ++count) {
      up = std::nextafterf(up, kInfinity);
      down = std::nextafterf(down, -kInfinity);
      EXPECT_EQ(floats.shifted(start, count), static_cast<double>(up)) << start;
      EXPECT_EQ(floats.shifted(start, -count), static_cast<double>(down)) << start;
    }
    if (start != 0) {
      EXPECT_EQ(doubles.shifted(start, 1), std::nextafter(static_cast<double>(start), 1e300));
      EXPECT_EQ(doubles.shifted(start, -1), std::nextafter(static_cast<double>(start), -1e300));
    }
  }
}

TEST(Lattice, has_no_doubles_out_of_range) {
  const FloatLattice doubles(Coordinates::binary64);
  for (const int way : {1, -1}) {
    const double next = doubles.shifted(0, way);
    EXPECT_TRUE(is_in_range(next));
    EXPECT_FALSE(is_in_range(next / 2));
    EXPECT_EQ(doubles.nearest(next), next);
    for (const double tiny : {9e-61, 1e-200, 5e-324}) {
      EXPECT_EQ(doubles.nearest(way * tiny), 0);
      EXPECT_EQ(doubles.nearest(way * tiny, [] { return 1; }), 0);
    }
  }
}

TEST(Lattice, may_have_a_uniform_spacing) {
  const FloatLattice grid(Coordinates::binary64, 0.25);
  EXPECT_EQ(grid.nearest(1.1), 1);
  EXPECT_EQ(grid.nearest(1.125), 1);
  EXPECT_EQ(grid.nearest(1.375), 1.5);
  EXPECT_EQ(grid.nearest(-1e9 - 0.2), -1e9 - 0.25);
  EXPECT_EQ(grid.shifted(1, -3), 0.25);
  EXPECT_EQ(grid.shifted(0, -1), -0.25);
}

TEST(Lattice, steps_there_and_back_again) {
  std::mt19937_64 random(11);
  for (const double spacing : {0.0, 0x1p-10}) {
    for (const Coordinates coordinates : {Coordinates::binary64, Coordinates::binary32}) {
      const FloatLattice lattice(coordinates, spacing);
      for (int i = 0; i < 10000; ++i) {
        const double size = std::ldexp(1.0, static_cast<int>(random() % 40) - 20);
        const double start =
            lattice.nearest((static_cast<double>(random() >> 11) * 0x1p-52 - 1) * size);
        const int count = static_cast<int>(random() % 6);
        const double there = lattice.shifted(start, count);
        ASSERT_EQ(lattice.shifted(there, -count), start);
        ASSERT_EQ(lattice.nearest(there), there) << "belongs to the lattice";
        ASSERT_GE(there - start, count * std::min(lattice.step(start), lattice.step(there)) / 2);
      }
    }
  }
}

}  // namespace
}  // namespace dupin::exact
