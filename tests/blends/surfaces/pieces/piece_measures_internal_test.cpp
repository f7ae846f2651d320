#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "surfaces/pieces/piece_measures.h"

namespace dupin::surfaces {
namespace {

using std::numbers::pi;

TEST(CutBall, in_half_balances_at_three_eighths_of_the_radius) {
  const Sphere ball{Vec3(1, 2, 3), 2};
  const SolidMoments half = cut_ball(ball, {{Vec3::UnitX(), 0}});
  EXPECT_NEAR(half.volume, 2 * pi / 3 * 8, 1e-13);
  EXPECT_LT((half.centroid - Vec3(1 - 0.75, 2, 3)).norm(), 1e-14);
  EXPECT_NEAR(inertia(half)(0, 0), 0.4 * half.volume * 4, 1e-12);
}

TEST(CutBall, twice_is_a_slab) {
  const double h = 0.5;
  const SolidMoments slab = cut_ball({Vec3::Zero(), 1}, {{Vec3::UnitZ(), h}, {-Vec3::UnitZ(), h}});
  EXPECT_NEAR(slab.volume, 2 * pi * (h - h * h * h / 3), 1e-14);
  EXPECT_LT(slab.centroid.norm(), 1e-15);
  EXPECT_NEAR(slab.spread(2, 2), 2 * pi * (h * h * h / 3 - std::pow(h, 5) / 5), 1e-14);
}

// A segment beyond a plane behind the centre is more than half of the ball.
TEST(CutBall, and_what_was_cut_off_are_the_ball) {
  const Sphere ball{Vec3(1, 0, 0), 3};
  const Vec3 direction = Vec3(1, 2, 2) / 3;
  const SolidMoments whole = cut_ball(ball, {}),
                     sum = cut_ball(ball, {{direction, -1}}) + cut_ball(ball, {{-direction, 1}});
  EXPECT_NEAR(sum.volume, whole.volume, 1e-12);
  EXPECT_LT((sum.centroid - whole.centroid).norm(), 1e-13);
  EXPECT_LT((sum.spread - whole.spread).norm(), 1e-11);
}

// Of the same surface, told by curves, it is done by quadrature with ever more panels.
TEST(PieceMeasures, of_cylinders_and_cones_are_those_of_quadrature) {
  const Vec3 from(100, -20, 3), to(104, -17, 15);
  const Vec3 along = (to - from).normalized();
  for (const double tip : {2.0, 0.5, 7.0}) {
    const Ring start{from, -along, 2, 0}, end{to, along, tip, 0};
    const PartMeasures closed =
        measures(Piece(RingedSurface{start, end, LineSpine{from, to}, LinearRadius{2, tip}}));
    const PartMeasures found =
        measures(Piece(RingedSurface{start, end, BezierSpine{{from, (from + to) / 2, to}},
                                     BezierRadius{{2, (2 + tip) / 2, tip}}}));
    EXPECT_NEAR(*closed.length, 13, 1e-13);
    EXPECT_NEAR(closed.area / (pi * (2 + tip) * std::hypot(13, tip - 2)), 1, 1e-15);
    EXPECT_NEAR(closed.area / found.area, 1, 1e-13);
    EXPECT_NEAR(closed.solid->volume / (pi * 13 / 3 * (4 + 2 * tip + tip * tip)), 1, 1e-15);
    EXPECT_NEAR(closed.solid->volume / found.solid->volume, 1, 1e-13);
    EXPECT_LT((closed.solid->centroid - found.solid->centroid).norm(), 1e-12);
    EXPECT_LT((closed.solid->spread - found.solid->spread).norm(),
              1e-13 * found.solid->spread.norm());
  }
}

// A knuckle of which a thick wall leaves little: the turning of its spine is all rounding, which
// was taken for what 64 panels do not reach.
TEST(PieceMeasures, of_a_short_wide_piece_far_away_are_those_of_its_cylinder) {
  constexpr int kDegree = 9;
  constexpr double kRadius = 1525, kHeight = 0.75;
  const Vec3 along = Vec3(3, 4, 0) / 5, from(0x1p20 / 3, -0x1p20, 0x1p19);
  BezierSpine spine;
  BezierRadius radius;
  for (int i = 0; i <= kDegree; ++i) {
    spine.points.emplace_back(from + i * kHeight / kDegree * along);
    radius.coefficients.push_back(kRadius);
  }
  const Ring start{from, -along, kRadius, 0}, end{spine.points.back(), along, kRadius, 0};
  const Piece piece = RingedSurface{start, end, spine, radius};
  const PartMeasures found = measures(piece);
  EXPECT_NEAR(*found.length, kHeight, 1e-9);
  EXPECT_NEAR(found.solid->volume / (pi * kRadius * kRadius * kHeight), 1, 1e-9);
  EXPECT_LT((found.solid->centroid - from - kHeight / 2 * along).norm(), 1e-9 * kRadius);
}

}  // namespace
}  // namespace dupin::surfaces
