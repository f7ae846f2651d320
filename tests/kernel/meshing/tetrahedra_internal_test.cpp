#include <gtest/gtest.h>

#include "meshing/tetrahedra.h"

namespace dupin::meshing {
namespace {

TEST(Tetrahedra, orientation_is_exact) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_TRUE(is_positive(a, b, c, Vec3(0.3, 0.3, 0x1p-1000)));
  EXPECT_FALSE(is_positive(a, b, c, Vec3(0.3, 0.3, 0)));
  EXPECT_FALSE(is_positive(a, b, c, Vec3(0.3, 0.3, -0x1p-1000)));
}

TEST(Tetrahedra, faces_turn_outward) {
  const Vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto faces = faces_of({0, 1, 2, 3});
  for (std::uint32_t k = 0; k < 4; ++k) {
    const auto& [a, b, c] = faces[k];
    EXPECT_TRUE(is_positive(corners[k], corners[a], corners[b], corners[c])) << k;
  }
}

}  // namespace
}  // namespace dupin::meshing
