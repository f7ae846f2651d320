#include <cmath>

#include <gtest/gtest.h>

#include "dupin/kernel/interior_point.h"
#include "support/shapes.h"

namespace dupin {
namespace {

TEST(WindingNumber, is_of_points_inside) {
  const TriMesh mesh = test::box({0, 0, 0}, {2, 3, 4});
  EXPECT_EQ(winding_number(mesh, {1, 1, 1}), 1);
  EXPECT_EQ(winding_number(mesh, {1, 1, -0.1}), 0);
  EXPECT_EQ(winding_number(test::reversed(mesh), {1, 1, 1}), -1);
  EXPECT_EQ(winding_number(test::joined({mesh, mesh}), {1, 1, 1}), 2);
  EXPECT_EQ(winding_number({}, {1, 1, 1}), 0);
}

TEST(WindingNumber, tells_neighbouring_doubles_apart) {
  const TriMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(winding_number(mesh, {std::nextafter(1.0, 0.0), 0.5, 0.5}), 1);
  EXPECT_EQ(winding_number(mesh, {std::nextafter(1.0, 2.0), 0.5, 0.5}), 0);
}

}  // namespace
}  // namespace dupin
