#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tessellation/unrolled_face.h"

namespace dupin::tessellation {
namespace {

// A cylinder, a cone, and one that is all but a cylinder; x counts segments.
TEST(UnrolledFace, is_conformal_but_for_its_compression) {
  for (const double slope : {0.0, 0.4, -0.2, 1e-14}) {
    const Ring start{{1, 2, 3}, {0, 0, -1}, 3, -slope},
        end{{1, 2, 8}, {0, 0, 1}, 3 + 5 * slope, slope};
    const UnrolledFace face(start, end, {48});
    EXPECT_EQ(face.around(), 48);
    for (const Vec2& place : {Vec2(0, 0.1), Vec2(-7, 2), Vec2(23.5, 1)}) {
      const Vec3 point = face.point(place);
      EXPECT_LT((face.place(point) - place).norm(), 1e-12);
      EXPECT_NEAR(face.height(point), face.level(place.y()), 1e-14);
      const Ring ring = face.ring(place.y());
      EXPECT_NEAR((point - ring.center).norm(), ring.radius, 1e-14);
      EXPECT_NEAR(ring.radius, 3 + slope * (point.z() - 3), 1e-13);
      constexpr double kStep = 1e-5;
      const Vec3 around = (face.point(place + Vec2(kStep, 0)) - point) / kStep;
      const Vec3 along = (face.point(place + Vec2(0, kStep)) - point) / kStep;
      EXPECT_NEAR(along.norm(), UnrolledFace::kCompression * around.norm(), 1e-4);
      EXPECT_NEAR(along.dot(around), 0, 1e-4);
      EXPECT_GT(around.cross(along).dot(point - ring.center), 0) << "seen from outside";
    }
  }
}

TEST(UnrolledCurve, goes_once_around_or_not_at_all) {
  std::vector<Vec2> places;
  std::vector<std::uint32_t> corners;
  for (int i = 0; i < 12; ++i) {  // backwards
    places.emplace_back(std::remainder(5 - i, 12), i % 2);
    corners.push_back(std::uint32_t(i));
  }
  const UnrolledCurve ring = unrolled(corners, places, 12);
  EXPECT_EQ(ring.turns, 1);
  EXPECT_EQ(ring.corners[1], 11U) << "it was turned round";
  EXPECT_EQ(ring.low, 0);
  EXPECT_EQ(ring.high, 1);
  const UnrolledCurve hole = unrolled({0, 1, 2}, {{5, 0}, {-6, 0}, {5.5, 1}}, 12);
  EXPECT_EQ(hole.turns, 0);
  EXPECT_EQ(hole.places[1].x(), 6);
}

}  // namespace
}  // namespace dupin::tessellation
