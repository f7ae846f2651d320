#include <gtest/gtest.h>

#include "numbers/point_order.h"

namespace dupin::numbers {
namespace {

TEST(PointOrder, takes_the_first_coordinate_that_differs) {
  const PointOrder before;
  const Vec3 rows[] = {{-1, 9, 9}, {0, -2, 5}, {0, 1, -7}, {0, 1, 2}};
  for (std::size_t i = 0; i < std::size(rows); ++i) {
    for (std::size_t j = 0; j < std::size(rows); ++j) {
      EXPECT_EQ(before(rows[i], rows[j]), i < j) << i << " " << j;
    }
  }
}

}  // namespace
}  // namespace dupin::numbers
