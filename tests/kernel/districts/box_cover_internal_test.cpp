#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "districts/box_cover.h"
#include "dupin/kernel/mesh.h"

namespace dupin::districts {
namespace {

using Box = Eigen::AlignedBox3d;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Polygon polygon(const std::vector<Vec3>& corners) {
  Polygon result;
  for (const Vec3& p : corners) {
    result.push_back({mpq_class(p.x()), mpq_class(p.y()), mpq_class(p.z())});
  }
  return result;
}

TEST(BoxCover, is_told_exactly) {
  const Box left(Vec3(0, 0, 0), Vec3(2, 2, 2)), right(Vec3(1, 0, 0), Vec3(4, 1, 2)),
      beside(Vec3(2, 0, 0), Vec3(4, 2, 2));
  const double most = std::nextafter(2, 0), least = std::nextafter(2, 3);
  const Box overlapping(Vec3(most, 0, 0), Vec3(4, 2, 2));
  const std::vector<Vec3> small{{.5, .5, 1}, {1.5, .5, 1}, {.5, 1.5, 1}},
      across{{.5, .25, 1}, {3.5, .5, 1}, {3.5, .75, 1}},
      notch{{.5, 1.75, 1}, {3.5, .5, 1}, {1, .5, 1}}, point{{2, 1, 1}},
      segment{{1, 1, 1}, {3, 1, 1}};
  EXPECT_TRUE(is_covered(polygon(small), std::vector{left}));
  EXPECT_FALSE(is_covered(polygon(small), std::vector{right}));
  EXPECT_FALSE(is_covered(polygon(small), {}));
  EXPECT_FALSE(is_covered(polygon(across), std::vector{left}));
  EXPECT_TRUE(is_covered(polygon(across), std::vector{left, right}));
  EXPECT_TRUE(is_covered(polygon(across), std::vector{right, Box(), left}));
  EXPECT_FALSE(is_covered(polygon(notch), std::vector{left, right})) << "all corners are inside";
  EXPECT_FALSE(is_covered(polygon(across), std::vector{left, beside})) << "but for their side";
  EXPECT_TRUE(is_covered(polygon(across), std::vector{left, overlapping}));
  EXPECT_FALSE(is_covered(polygon(point), std::vector{left, beside}));
  EXPECT_TRUE(is_covered(polygon(point), std::vector{left, overlapping}));
  EXPECT_FALSE(is_covered(polygon(segment), std::vector{left, beside}));
  EXPECT_TRUE(is_covered(polygon(segment), std::vector{overlapping, left}));
  EXPECT_FALSE(
      is_covered(polygon(segment), std::vector{left, Box(Vec3(least, 0, 0), Vec3(4, 2, 2))}));
  EXPECT_TRUE(is_covered(polygon(segment), std::vector{Box(Vec3(-kInfinity, -kInfinity, 0.5),
                                                           Vec3(kInfinity, 9, kInfinity))}));
}

// Whatever the order of boxes; and no corner of a grid on a covered triangle is outside of all.
TEST(BoxCover, agrees_with_places_on_triangles) {
  std::mt19937 random(0);
  std::uniform_real_distribution<double> at(0, 4);
  std::size_t covered = 0;
  for (int scene = 0; scene < 400; ++scene) {
    std::vector<Box> boxes;
    for (int i = 0; i < 6; ++i) {
      Box box(Vec3(at(random), at(random), at(random)));
      box.extend(box.min() + Vec3(1, 1, 1) + Vec3(at(random), at(random), at(random)));
      boxes.push_back(box);
    }
    const Vec3 a(2, 2, 2), b = a + Vec3(at(random), at(random), at(random)) / 2,
                           c = a + Vec3(at(random), at(random), at(random)) / 2;
    const bool is_inside = is_covered(polygon({a, b, c}), boxes);
    std::ranges::reverse(boxes);
    EXPECT_EQ(is_covered(polygon({b, c, a}), boxes), is_inside);
    covered += is_inside ? 1 : 0;
    bool is_inside_everywhere = true;
    constexpr int kSteps = 24;
    for (int i = 0; i <= kSteps; ++i) {
      for (int k = 0; i + k <= kSteps; ++k) {
        const Vec3 p = a + (b - a) * i / kSteps + (c - a) * k / kSteps;
        is_inside_everywhere =
            is_inside_everywhere &&
            std::ranges::any_of(boxes, [&](const Box& box) { return box.contains(p); });
      }
    }
    EXPECT_TRUE(is_inside_everywhere || !is_inside);
  }
  EXPECT_GT(covered, 50U);
  EXPECT_LT(covered, 350U);
}

}  // namespace
}  // namespace dupin::districts
