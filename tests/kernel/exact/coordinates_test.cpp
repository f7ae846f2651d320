#include "dupin/kernel/coordinates.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "dupin/kernel/vec.h"

namespace dupin {
namespace {

TEST(Coordinates, nearest_goes_to_the_format_s_number_ties_to_even) {
  EXPECT_EQ(nearest(0.1, Coordinates::binary64), 0.1);
  EXPECT_EQ(nearest(0.1, Coordinates::binary32), 13421773 * 0x1p-27);
  EXPECT_EQ(nearest(0x1p24 + 1, Coordinates::binary32), 0x1p24);
  EXPECT_EQ(nearest(0x1p24 + 3, Coordinates::binary32), 0x1p24 + 4);
  EXPECT_EQ(nearest(0x1p-160, Coordinates::binary32), 0);
  EXPECT_EQ(nearest(1e39, Coordinates::binary32), std::numeric_limits<double>::infinity());
}

TEST(Coordinates, nearest_rounds_all_coordinates_of_a_point) {
  const Vec3 rounded = nearest(Vec3::Constant(0.1), Coordinates::binary32);
  EXPECT_EQ(rounded, Vec3::Constant(13421773 * 0x1p-27));
}

}  // namespace
}  // namespace dupin
