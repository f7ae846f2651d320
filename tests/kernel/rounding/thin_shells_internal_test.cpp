#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/rounding.h"
#include "support/shapes.h"

namespace dupin {
namespace {

// Out there, neighbouring floats are 0.125 apart.
const Vec3 kFar(1.5e6, 1.2e6, 1.1e6);

std::vector<ThinShell> thin_shells_of(const TriMesh& mesh,
                                      Coordinates coordinates = Coordinates::binary32) {
  return to_mesh(Solid::from(test::moved(mesh, kFar)), coordinates).report().thin_shells;
}

TriMesh plate(double thickness) {
  return test::box(Vec3(0.03, 0.04, 0.05), Vec3(20, 20, 0.05 + thickness));
}

TEST(ThinShells, are_those_that_rounding_moves_by_more_than_they_are_thick) {
  EXPECT_TRUE(thin_shells_of(plate(5)).empty());
  const auto thin = thin_shells_of(plate(0.02));
  ASSERT_EQ(thin.size(), 1U);
  EXPECT_NEAR(thin[0].thickness, 0.02, 1e-3);
  EXPECT_GT(thin[0].move, thin[0].thickness);
  EXPECT_LT((thin[0].place - kFar).norm(), 30);
  EXPECT_TRUE(thin_shells_of(plate(0.02), Coordinates::binary64).empty());
}

TEST(ThinShells, are_told_from_thick_ones_beside_them) {
  const TriMesh both = test::joined({test::moved(plate(10), Vec3(0, 0, 40)), plate(0.02)});
  const auto thin = thin_shells_of(both);
  ASSERT_EQ(thin.size(), 1U);
  EXPECT_LT(thin[0].place.z() - kFar.z(), 20);
}

}  // namespace
}  // namespace dupin
