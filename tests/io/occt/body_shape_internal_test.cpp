#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "io/occt/body_shapes_internal.h"
#include "occt/body_shape.h"

namespace dupin::occt {
namespace {

TEST(BodyShape, of_a_run_is_valid_and_has_its_volume) {
  const LabelledShape made = solid_of(bent_pipe());
  EXPECT_TRUE(is_valid(made.shape));
  EXPECT_NEAR(volume(made.shape), kBentVolume, 1e-6);
  EXPECT_EQ(made.labels.Extent(), 5);
}

TEST(BodyShape, of_a_wall_has_flat_rims) {
  exchange::Body wall;
  wall.rings = {{{0, 0, 0}, {0, 0, -1}, {1, 0, 0}, 2, 2},
                {{0, 0, 5}, {0, 0, 1}, {1, 0, 0}, 2, 2},
                {{0, 0, 0}, {0, 0, -1}, {1, 0, 0}, 1, 1},
                {{0, 0, 5}, {0, 0, 1}, {1, 0, 0}, 1, 1}};
  wall.tubes = {{0, 0, 1, exchange::CylinderOrCone{}},
                {0, 2, 3, exchange::CylinderOrCone{}, true},
                {1, 0, 2, exchange::Rim{{0, 0, -1}}},
                {2, 1, 3, exchange::Rim{{0, 0, 1}}}};
  const LabelledShape made = solid_of(wall);
  EXPECT_TRUE(is_valid(made.shape));
  EXPECT_NEAR(volume(made.shape), std::numbers::pi * 3 * 5, 1e-6);
}

TEST(BodyShape, of_a_ball_and_of_a_hub) {
  exchange::Body ball;
  ball.hubs = {{0, {1, 2, 3}, 2, {}}};
  const LabelledShape whole = solid_of(ball);
  EXPECT_TRUE(is_valid(whole.shape));
  EXPECT_NEAR(volume(whole.shape), std::numbers::pi * 32 / 3, 1e-6);
  // A hub of radius 2 whose one arm is a cylinder of radius 1.
  const double level = std::sqrt(3.0);
  exchange::Body arm;
  arm.rings = {{{0, 0, level}, {0, 0, 1}, {1, 0, 0}, 1, 1},
               {{0, 0, 6}, {0, 0, 1}, {1, 0, 0}, 1, 1}};
  arm.tubes = {{0, 0, 1, exchange::CylinderOrCone{}}};
  arm.discs = {{1, 1, {0, 0, 1}}};
  arm.hubs = {{2, {0, 0, 0}, 2, {0}}};
  const LabelledShape joined = solid_of(arm);
  EXPECT_TRUE(is_valid(joined.shape));
  const double cap = std::numbers::pi * std::pow(2 - level, 2) * (6 - (2 - level)) / 3;
  EXPECT_NEAR(volume(joined.shape),
              std::numbers::pi * 32 / 3 - cap + std::numbers::pi * (6 - level), 1e-4);
}

// Half a ball between two cylinders that end in its middle, at a right angle: a quarter of it, and
// what the cylinders do not share.
TEST(BodyShape, of_several_closed_surfaces_and_a_sector_is_their_union) {
  exchange::Body body;
  body.rings = {{{-5, 0, 0}, {-1, 0, 0}, {0, 1, 0}, 1, 1},
                {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, 1},
                {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, 1},
                {{0, -5, 0}, {0, -1, 0}, {0, 0, 1}, 1, 1}};
  body.tubes = {{0, 0, 1, exchange::CylinderOrCone{}}, {1, 2, 3, exchange::CylinderOrCone{}}};
  body.discs = {{0, 0, {-1, 0, 0}}, {0, 1, {1, 0, 0}}, {1, 2, {0, 1, 0}}, {1, 3, {0, -1, 0}}};
  body.sectors = {{2,
                   {0, 0, 0},
                   1,
                   {exchange::RingCurve{{0, 0, 0}, {-1, 0, 0}, {0, 1, 0}, 1, 1},
                    exchange::RingCurve{{0, 0, 0}, {0, -1, 0}, {0, 0, 1}, 1, 1}},
                   {-std::sqrt(0.5), std::sqrt(0.5), 0},
                   {-std::sqrt(0.5), -std::sqrt(0.5), 0}}};
  const LabelledShape made = solid_of(body);
  EXPECT_TRUE(is_valid(made.shape));
  // Of crossing cylinders (16/3) both have the quarter that lies behind either disc.
  EXPECT_NEAR(volume(made.shape), 10 * std::numbers::pi - 4. / 3 + std::numbers::pi / 3, 1e-4);
  std::set<std::uint32_t> labels;
  for (FaceLabels::Iterator face(made.labels); face.More(); face.Next()) {
    labels.insert(face.Value());
  }
  EXPECT_EQ(labels, (std::set<std::uint32_t>{0, 1, 2}));
}

}  // namespace
}  // namespace dupin::occt
