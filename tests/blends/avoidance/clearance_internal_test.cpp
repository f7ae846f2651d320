#include <limits>

#include <gtest/gtest.h>

#include "avoidance/clearance.h"
#include "blends/ringed/ringed_blends.h"
#include "blends/tubes.h"
#include "support/shapes.h"

namespace dupin::avoidance {
namespace {

const std::vector<Piece> kPipe{test::cylinder({0, 0, 0}, {10, 0, 0}, 1),
                               test::cylinder({10, 0, 0}, {20, 0, 0}, 1)};

TEST(Clearance, is_proved_up_to_the_very_distance) {
  const std::vector<NamedObstacle> ball{{"ball", {{12, 0, 5}, {}, 2}}};
  for (const double wanted : {0., 1., 1.9, 1.9999, 1.99999999}) {
    const Clearance found = prove_clearance(kPipe, ball, wanted);
    EXPECT_FALSE(found.spot) << wanted;
    EXPECT_GE(found.least, wanted);
    EXPECT_LE(found.least, 2);
  }
  const Clearance refuted = prove_clearance(kPipe, ball, 2.000001);
  ASSERT_TRUE(refuted.spot);
  EXPECT_EQ(refuted.spot->piece, 1);
  EXPECT_NEAR(refuted.spot->distance, 2, 1e-3);
  EXPECT_NEAR(refuted.spot->place[2], 1, 1e-3);
}

TEST(Clearance, is_nobodys_where_there_is_no_obstacle) {
  const Clearance found = prove_clearance(kPipe, {}, 5);
  EXPECT_FALSE(found.spot);
  EXPECT_EQ(found.least, std::numeric_limits<double>::infinity());
}

TEST(Clearance, is_refuted_inside) {
  for (const Obstacle& around :
       {Obstacle{{5, 0, 0}, {}, 50},
        Obstacle{{-50, -50, -50}, {{99, 0, 0}, {0, 99, 0}, {0, 0, 99}}, 0}}) {
    EXPECT_TRUE(prove_clearance(kPipe, std::vector<NamedObstacle>{{"", around}}, 0).spot);
  }
}

TEST(Clearance, is_never_proved_of_what_is_no_number) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<NamedObstacle> bad{{"", {{nan, 0, 0}, {}, 1}}},
      worse{{"", {{0, 99, 0}, {}, nan}}};
  EXPECT_TRUE(prove_clearance(kPipe, bad, 0).spot);
  EXPECT_TRUE(prove_clearance(kPipe, worse, 0).spot);
  const std::vector<NamedObstacle> far{{"", {{0, 99, 0}, {}, 1}}};
  EXPECT_TRUE(prove_clearance(kPipe, far, nan).spot);
}

TEST(Clearance, names_the_tightest_of_all) {
  const std::vector<NamedObstacle> two{{"far", {{3, 0, 5}, {}, 3.5}},
                                       {"near", {{17, 0, 5}, {}, 3.9}}};
  const Clearance found = prove_clearance(kPipe, two, 1);
  ASSERT_TRUE(found.spot);
  EXPECT_EQ(two[found.spot->obstacle].name, "near");
}

// [mathematics C10] R1: an oblique cone blends into a cylinder; distances with 13 digits.
std::vector<Piece> oracle_blend() {
  return {RationalRingedTube{
      {{0, 0, 0}, -Vec3::UnitZ(), 1}, {{4, 1, 3.5}, Vec3::UnitX(), 0.8}, test::cone_to_cylinder()}};
}

TEST(Clearance, of_a_ringed_blend_is_the_oracles) {
  struct Row {
    Obstacle obstacle;
    double distance, parameter;
  };
  const std::vector<Row> rows{
      {{{3.5, .5, .2}, {}, 1}, 0.7974084047886, .5094050449},
      {{{-2.5, -3, 1}, {{.3, 6, 2}}, .4}, 1.3326266990446, .2233656676},
      {{{-1, -1, 4.6}, {{3, 0, 0}, {0, 3, 0}, {0, 0, .9}}, 0}, 0.8087988044306, .7040854566}};
  for (const auto& [obstacle, distance, parameter] : rows) {
    const std::vector<NamedObstacle> one{{"it", obstacle}};
    const auto pipe = oracle_blend();
    EXPECT_FALSE(prove_clearance(pipe, one, distance - 1e-6).spot) << distance;
    const Clearance refuted = prove_clearance(pipe, one, distance + 1e-6);
    ASSERT_TRUE(refuted.spot) << distance;
    EXPECT_NEAR(refuted.spot->parameter, parameter, 0.3);
    // However much more is asked for, the spot is the same.
    for (const double more : {1e-6, 1., 100.}) {
      const Clearance coarse = prove_clearance(pipe, one, distance + more);
      ASSERT_TRUE(coarse.spot);
      const TightSpot spot = tightest_spot(pipe, one, *coarse.spot);
      EXPECT_NEAR(spot.distance, distance, 1.1e-3 * distance) << more;
      EXPECT_NEAR(spot.parameter, parameter, 0.05) << more;
    }
  }
  const std::vector<NamedObstacle> ball{{"ball", rows[0].obstacle}};
  EXPECT_FALSE(prove_clearance(oracle_blend(), ball, 0.796).spot);
  EXPECT_TRUE(prove_clearance(oracle_blend(), ball, 0.798).spot);
}

// The middle of the pipe keeps away from the ball, which stands in its way further on.
TEST(Clearance, of_what_is_run_into_is_none) {
  const std::vector<NamedObstacle> ball{{"ball", {{1, 0, 0}, {}, .2}}};
  const Clearance coarse = prove_clearance(kPipe, ball, 50);
  ASSERT_TRUE(coarse.spot);
  EXPECT_GT(coarse.spot->distance, 0);
  EXPECT_LE(tightest_spot(kPipe, ball, *coarse.spot).distance, 0);
}

TEST(Clearance, of_meshes_is_that_of_their_triangles) {
  const TriMesh cube = test::box({4, 2, -3}, {8, 5, 3});
  const std::vector<NamedObstacle> mesh{obstacle_of("cube.off", cube)};
  EXPECT_FALSE(prove_clearance(kPipe, mesh, 0.999999).spot);  // 2 - 1
  const Clearance refuted = prove_clearance(kPipe, mesh, 1.000001);
  ASSERT_TRUE(refuted.spot);
  EXPECT_TRUE(refuted.spot->shape.is_triangle);
  EXPECT_NEAR(refuted.spot->place.y(), 1, 1e-3);
}

}  // namespace
}  // namespace dupin::avoidance
