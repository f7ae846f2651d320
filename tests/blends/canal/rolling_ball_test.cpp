// The tables of the mathematics B.9 for constant radius, computed with 40 digits, and residuals in
// random positions.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "blends/canal/residuals.h"
#include "dupin/blends/canal_fillet.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using test::kPi;

struct Row {
  double parameter;
  Vec3 center, first_foot, second_foot;
  double angle, regularity;
};

struct Table {
  std::string name;
  std::array<Ring, 2> cylinders;
  double radius;
  std::vector<Row> rows;
  double length, area, regularity;
};

Ring cylinder(const Vec3& center, const Vec3& normal, double radius) {
  return {center, normal, radius};
}

std::vector<Table> tables() {
  const double sine = std::sqrt(0.75);
  return {
      {"R1",
       {cylinder(Vec3::Zero(), Vec3::UnitX(), 2), cylinder(Vec3::Zero(), Vec3::UnitY(), 1)},
       .5,
       {{0, {1.5, 2.5, 0}, {1.5, 2, 0}, {1, 2.5, 0}, 1.5707963267949, .61168967},
        {0.52359877559829887,
         {1.29903810567666, 2.38484800354236, .75},
         {1.29903810567666, 1.90787840283389, .6},
         {.866025403784439, 2.38484800354236, .5},
         1.42022805401821,
         .67154502},
        {0.78539816339744831,
         {1.06066017177982, 2.26384628453435, 1.06066017177982},
         {1.06066017177982, 1.81107702762748, .848528137423857},
         {.707106781186548, 2.26384628453435, .707106781186548},
         1.2661036727795,
         .6989763},
        {kPi / 2, {0, 2, 1.5}, {0, 1.6, 1.2}, {0, 2, 1}, .927295218001612, .66666667},
        {kPi, {-1.5, 2.5, 0}, {-1.5, 2, 0}, {-1, 2.5, 0}, 1.5707963267949, .61168967},
        {-kPi / 2, {0, 2, -1.5}, {0, 1.6, -1.2}, {0, 2, -1}, .927295218001612, .66666667}},
       9.68136135658787,
       4.51597104068934,
       .6112698737},
      {"R2",
       {cylinder(Vec3::Zero(), Vec3::UnitX(), 2), cylinder(Vec3::Zero(), Vec3(.5, sine, 0), 1)},
       .5,
       {{0,
         {3.17542648054294, 2.5, 0},
         {3.17542648054294, 2, 0},
         {2.74241377865072, 2.75, 0},
         2.0943951023932,
         .46135333},
        {0.52359877559829887,
         {2.87689263682153, 2.38484800354236, .75},
         {2.87689263682153, 1.90787840283389, .6},
         {2.50189263682153, 2.60135435448847, .5},
         1.83699694947579,
         .68924038},
        {0.78539816339744831,
         {2.53177713317143, 2.26384628453435, 1.06066017177982},
         {2.53177713317143, 1.81107702762748, .848528137423857},
         {2.22559091532354, 2.44062297983099, .707106781186548},
         1.59095390373648,
         .78033373},
        {kPi / 2,
         {1.15470053837925, 2, 1.5},
         {1.15470053837925, 1.6, 1.2},
         {1.15470053837925, 2, 1},
         .927295218001612,
         .75},
        {kPi,
         {-.288675134594813, 2.5, 0},
         {-.288675134594813, 2, 0},
         {.144337567297406, 2.25, 0},
         1.0471975511966,
         .66454885},
        {-kPi / 2,
         {1.15470053837925, 2, -1.5},
         {1.15470053837925, 1.6, -1.2},
         {1.15470053837925, 2, -1},
         .927295218001612,
         .75}},
       10.4411890699572,
       4.99814121848321,
       // The printed .4666666667 is above the least of the table's own rows.
       .4611397488},
      {"R3",
       {cylinder(Vec3(0, 0, .25), Vec3::UnitX(), 2), cylinder(Vec3(0, 0, -.25), Vec3::UnitY(), 1)},
       .3,
       {{0,
         {1.3, 2.24499443206436, -.25},
         {1.3, 1.95216907136032, -.184782608695652},
         {1, 2.24499443206436, -.25},
         1.5707963267949,
         .7445776},
        {0.52359877559829887,
         {1.12583302491977, 2.2951034835057, .4},
         {1.12583302491977, 1.99574215957017, .380434782608696},
         {.866025403784439, 2.2951034835057, .25},
         1.5381818494245,
         .75289085},
        {0.78539816339744831,
         {.919238815542512, 2.26146828753854, .669238815542512},
         {.919238815542512, 1.96649416307699, .614555491776097},
         {.707106781186548, 2.26146828753854, .457106781186548},
         1.44154693651332,
         .77007315},
        {kPi / 2,
         {0, 2.15638586528478, 1.05},
         {0, 1.8751181437259, .945652173913043},
         {0, 2.15638586528478, .75},
         1.21554491785666,
         .76923077},
        {kPi,
         {-1.3, 2.24499443206436, -.25},
         {-1.3, 1.95216907136032, -.184782608695652},
         {-1, 2.24499443206436, -.25},
         1.5707963267949,
         .7445776},
        {-kPi / 2,
         {0, 1.43178210632764, -1.55},
         {0, 1.24502791854577, -1.31521739130435},
         {0, 1.43178210632764, -1.25},
         .671950896495914,
         .76923077}},
       8.53900636058633,
       2.67445086821745,
       .7372790396}};
}

void expect_close(const Vec3& found, const Vec3& expected) {
  EXPECT_LT((found - expected).norm(), 2e-14 * std::max(1.0, expected.norm()))
      << found.transpose() << " is not " << expected.transpose();
}

/// By the trapezoidal rule, whose error falls geometrically for periodic functions.
template <class Function>
double loop_integral(const Function& f) {
  constexpr int kNodes = 512;
  double sum = 0;
  for (int k = 0; k < kNodes; ++k) {
    sum += f(2 * kPi * k / kNodes);
  }
  return 2 * kPi / kNodes * sum;
}

double length(const CanalFillet& fillet) {
  return loop_integral([&](double t) { return ball(fillet, t).velocity.norm(); });
}

/// By the element of area of the envelope, in the parameter and the angle, with Simpson's rule.
double area(const CanalFillet& fillet) {
  constexpr int kPanels = 64;
  return loop_integral([&](double t) {
    const MovingBall at = ball(fillet, t);
    const ContactArc arc = contact_arc(fillet.quadrics, at);
    double sum = 0;
    for (int k = 0; k <= kPanels; ++k) {
      const Vec3 n = (point(arc, arc.angle * k / kPanels) - at.center) / at.radius;
      const double element =
          at.velocity.norm() - at.radius * at.acceleration.dot(n) / at.velocity.norm();
      const double weight = k == 0 || k == kPanels ? 1 : 2 + 2 * (k % 2);
      sum += weight / (3 * kPanels) * at.radius * element;
    }
    return arc.angle * sum;
  });
}

/// The same by B.7: the inner integral in closed form, with the curvature vector of the spine.
double area_by_curvature(const CanalFillet& fillet) {
  return loop_integral([&](double t) {
    const MovingBall at = ball(fillet, t);
    const ContactArc arc = contact_arc(fillet.quadrics, at);
    const double speed = at.velocity.norm(), a = arc.angle;
    const Vec3 ahead = at.velocity / speed;
    const Vec3 curvature = (at.acceleration - at.acceleration.dot(ahead) * ahead) / (speed * speed);
    const Vec3 u = arc.normals[0];
    const Vec3 w = (arc.normals[1] - arc.normals[1].dot(u) * u).normalized();
    return at.radius * speed *
           (a +
            at.radius * (curvature.dot(u) * std::sin(a) + curvature.dot(w) * (1 - std::cos(a))));
  });
}

double sampled_regularity(const MovingBall& ball, const ContactArc& arc) {
  double least = 1;
  for (int k = 0; k <= 4000; ++k) {
    const Vec3 n = (point(arc, arc.angle * k / 4000) - ball.center) / ball.radius;
    least =
        std::min(least, 1 - ball.radius * ball.acceleration.dot(n) / ball.velocity.squaredNorm());
  }
  return least;
}

TEST(RollingBallFillets, AreThoseOfTheTables) {
  for (const Table& table : tables()) {
    SCOPED_TRACE(table.name);
    const auto fillets = rolling_ball_fillets(table.cylinders, table.radius);
    ASSERT_EQ(fillets.size(), 2);
    for (const Row& row : table.rows) {
      SCOPED_TRACE(row.parameter);
      const MovingBall at = ball(fillets[0], row.parameter);
      const ContactArc arc = contact_arc(fillets[0].quadrics, at);
      expect_close(at.center, row.center);
      expect_close(arc.feet[0], row.first_foot);
      expect_close(arc.feet[1], row.second_foot);
      EXPECT_NEAR(arc.angle, row.angle, 2e-14);
      // The table's are the least of samples over the arc.
      EXPECT_LT(least_regularity(at, arc), row.regularity + 6e-9);
      EXPECT_GT(least_regularity(at, arc), row.regularity - 5e-4);
      EXPECT_NEAR(least_regularity(at, arc), sampled_regularity(at, arc), 1e-7);
    }
    EXPECT_NEAR(length(fillets[0]), table.length, 1e-13 * table.length);
    EXPECT_NEAR(area(fillets[0]), table.area, 1e-8 * table.area);
    EXPECT_NEAR(area_by_curvature(fillets[0]), table.area, 1e-13 * table.area);
    double regularity = 1;
    for (int k = 0; k < 720; ++k) {
      const MovingBall at = ball(fillets[0], 2 * kPi * k / 720);
      regularity = std::min(regularity, least_regularity(at, contact_arc(fillets[0].quadrics, at)));
    }
    EXPECT_LT(regularity, table.regularity + 2e-6);  // of samples over the arcs
    EXPECT_GT(regularity, table.regularity - 1e-4);
    EXPECT_LT(test::residual(fillets[0]), 1e-15);
    EXPECT_LT(test::residual(fillets[1]), 1e-15);
  }
}

TEST(RollingBallFillets, OfOneLoopAreThoseOfTheTable) {
  const auto fillets = rolling_ball_fillets(
      {cylinder(Vec3(0, 0, .4), Vec3::UnitX(), 2), cylinder(Vec3(0, 0, -.4), Vec3::UnitY(), 1.8)},
      .3);
  ASSERT_EQ(fillets.size(), 1);
  expect_close(ball(fillets[0], 0).center, Vec3(1.46969384566991, 0, -1.9));
  expect_close(ball(fillets[0], kPi / 6).center, Vec3(2.01246117974981, 1.82482875908947, -1));
  expect_close(ball(fillets[0], kPi / 4).center, Vec3(2.07846096908265, 2.24499443206436, -.1));
  expect_close(ball(fillets[0], kPi / 2).center, Vec3(0, 1.89736659610103, 1.7));
  EXPECT_NEAR(length(fillets[0]), 24.94236926865, 1e-11);
  EXPECT_LT(test::residual(fillets[0]), 1e-15);
}

struct Crossing {
  std::array<Ring, 2> cylinders;
  double radius;
};

/// Two cylinders of which the distance of axes is `share` of the sum of radii, anywhere in space.
Crossing random_crossing(std::mt19937& random, double share) {
  std::uniform_real_distribution<double> uniform;
  const test::Placement place = test::random_placement(random);
  const double first = .2 + 2 * uniform(random), second = .2 + 2 * uniform(random);
  const double psi = .3 + (kPi - .6) * uniform(random);
  const Vec3 direction(std::cos(psi), std::sin(psi), 0);
  return {{place(cylinder(Vec3(3 * uniform(random), 0, share * (first + second)), Vec3::UnitX(),
                          first)),
           place(cylinder(uniform(random) * direction, direction, second))},
          .05 + uniform(random)};
}

TEST(RollingBallFillets, TouchBothCylindersInAnyPosition) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(-.9, .9);
  std::array<int, 2> seen{};
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const Crossing crossing = random_crossing(random, uniform(random));
    const auto fillets = rolling_ball_fillets(crossing.cylinders, crossing.radius);
    ++seen.at(fillets.size() - 1);
    for (const CanalFillet& fillet : fillets) {
      EXPECT_EQ(fillet.quadrics, crossing.cylinders);
      EXPECT_TRUE(corners(fillet).empty());
      EXPECT_LT(test::residual(fillet), 1e-14);
      EXPECT_LT((ball(fillet, 1).center - ball(fillet, 1 + 2 * kPi).center).norm(), 1e-13);
    }
  }
  EXPECT_GT(seen[0], 50);
  EXPECT_GT(seen[1], 50);
}

TEST(RollingBallFillets, HaveTheStatedDerivatives) {
  std::mt19937 random(18);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const Crossing crossing = random_crossing(random, i % 2 == 0 ? .05 : .5);
    for (const CanalFillet& fillet : rolling_ball_fillets(crossing.cylinders, crossing.radius)) {
      for (const double t : {.1, 1.2, 2.9, 4.7}) {
        EXPECT_LT(test::derivative_error(fillet, t, 1e-3), 1e-8) << t;
      }
    }
  }
}

TEST(RollingBallFillets, TheFirstIsOnTheSideThatTheThinnerOnesNormalPointsTo) {
  const Ring run = cylinder(Vec3::Zero(), Vec3::UnitX(), 2);
  for (const double sign : {1.0, -1.0}) {
    const Ring branch = cylinder(Vec3::Zero(), sign * Vec3(.6, .8, 0), 1);
    for (const auto& quadrics : {std::array{run, branch}, std::array{branch, run}}) {
      const auto fillets = rolling_ball_fillets(quadrics, .5);
      for (const double t : {0.0, 1.0, 2.0, 4.0}) {
        EXPECT_GT(sign * ball(fillets[0], t).center.y(), 2);
        EXPECT_LT(sign * ball(fillets[1], t).center.y(), -2 + 1e-15);
      }
    }
  }
}

TEST(RollingBallFillets, NearTangencyFromInsideAreAsAccurate) {
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12}) {
    SCOPED_TRACE(gap);
    const auto fillets = rolling_ball_fillets(
        {cylinder(Vec3::Zero(), Vec3::UnitX(), 2), cylinder(Vec3(0, 0, 1 - gap), Vec3::UnitY(), 1)},
        .5);
    ASSERT_EQ(fillets.size(), 2);
    EXPECT_LT(test::residual(fillets[0]), 1e-15);
    // At the top, y^2 = (2.5 - z) (2.5 + z) for z = 2.5 - gap, and the gap is known to 2^-52.
    const double exact = std::sqrt((1 - (1 - gap)) * (5 - (1 - (1 - gap))));
    EXPECT_NEAR(ball(fillets[0], kPi / 2).center.y(), exact, 1e-15 * exact);
    EXPECT_NEAR(ball(fillets[1], kPi / 2).center.y(), -exact, 1e-15 * exact);
    EXPECT_TRUE(corners(fillets[0]).empty());
  }
}

TEST(RollingBallFillets, OfEqualCylindersHaveCornersWhereTheFeetCoincide) {
  std::mt19937 random(19);
  for (int i = 0; i < 20; ++i) {
    const test::Placement place = test::random_placement(random);
    const double psi = kPi * (i + 1) / 21;
    const std::array<Ring, 2> equal{
        place(cylinder(Vec3(2, 0, 0), Vec3::UnitX(), 1.25)),
        place(cylinder(Vec3::Zero(), Vec3(std::cos(psi), std::sin(psi), 0), 1.25))};
    const auto fillets = rolling_ball_fillets(equal, .25);
    ASSERT_EQ(fillets.size(), 2);
    for (const CanalFillet& fillet : fillets) {
      EXPECT_EQ(corners(fillet), (std::vector<double>{-kPi / 2, kPi / 2}));
      EXPECT_LT(test::residual(fillet, 64), 1e-14);
      for (const double corner : corners(fillet)) {
        const MovingBall at = ball(fillet, corner);
        const ContactArc arc = contact_arc(equal, at);
        EXPECT_NEAR(arc.angle, 0, 1e-14);
        EXPECT_TRUE(at.velocity.allFinite() && at.acceleration.allFinite());
        EXPECT_TRUE(point(arc, 0).allFinite() && arc.middle.allFinite());
        EXPECT_GT(least_regularity(at, arc), 0);
        // On both sides the ball runs along an ellipse's half, y = 1.5 |cos|.
        const MovingBall before = ball(fillet, corner - 1e-6), after = ball(fillet, corner + 1e-6);
        const Vec3 across = place.rotation * Vec3::UnitY();
        EXPECT_NEAR(std::abs(before.velocity.dot(across)), 1.5, 1e-9);
        EXPECT_NEAR((before.velocity + after.velocity).dot(across), 0, 1e-5);
      }
    }
  }
}

TEST(RollingBallFillets, OfACylinderThatTouchesFromInsideHaveOneCorner) {
  const Ring run = cylinder(Vec3::Zero(), Vec3::UnitX(), 2);
  const auto above = rolling_ball_fillets({run, cylinder(Vec3(0, 0, 1), Vec3::UnitY(), 1)}, .5);
  ASSERT_EQ(above.size(), 2);
  EXPECT_EQ(corners(above[0]), std::vector<double>{kPi / 2});
  EXPECT_EQ(ball(above[0], kPi / 2).center, ball(above[1], kPi / 2).center);
  EXPECT_LT(test::residual(above[0]), 1e-15);
  const auto below = rolling_ball_fillets({run, cylinder(Vec3(0, 0, -1), Vec3::UnitY(), 1)}, .5);
  EXPECT_EQ(corners(below[0]), std::vector<double>{-kPi / 2});
  EXPECT_LT(test::residual(below[1]), 1e-15);
}

TEST(RollingBallFillets, TakeTangencyWithinRoundingForTangency) {
  std::mt19937 random(20);
  for (int i = 0; i < 50; ++i) {
    const test::Placement place = test::random_placement(random);
    const auto fillets =
        rolling_ball_fillets({place(cylinder(Vec3::Zero(), Vec3::UnitX(), 2)),
                              place(cylinder(Vec3(.3, 0, .7), Vec3(.6, .8, 0), 1.3))},
                             .2);
    ASSERT_EQ(fillets.size(), 2) << i;
    EXPECT_EQ(corners(fillets[0]).size(), 1);
    EXPECT_LT(test::residual(fillets[0]), 1e-14);
  }
}

TEST(RollingBallFillets, OnConesTouchBoth) {
  std::mt19937 random(24);
  std::uniform_real_distribution<double> uniform;
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    const test::Placement place = test::random_placement(random);
    const double psi = .8 + (kPi - 1.6) * uniform(random);
    Ring thick{Vec3(uniform(random), 0, .8 * uniform(random) - .4), Vec3::UnitX(), 3,
               i % 3 == 0 ? 0 : .2 * uniform(random) - .1};
    Ring thin{Vec3::Zero(), Vec3(std::cos(psi), std::sin(psi), 0), 1.5,
              i % 3 == 1 ? 0 : .2 * uniform(random) - .1};
    const auto fillets = rolling_ball_fillets({place(thin), place(thick)}, .3);
    ASSERT_EQ(fillets.size(), 2);
    const Vec3 normal = place.rotation * thin.normal, start = place(thin.center);
    for (const double t : {.1, 1.2, 2.9, 4.7}) {
      EXPECT_GT((ball(fillets[0], t).center - start).dot(normal),
                (ball(fillets[1], t).center - start).dot(normal));
      EXPECT_LT(test::derivative_error(fillets[0], t, 1e-3), 1e-8) << t;
    }
    for (const CanalFillet& fillet : fillets) {
      EXPECT_LT(test::residual(fillet), 1e-14);
      EXPECT_TRUE(corners(fillet).empty());
    }
  }
}

// Neither passes through the other: one loop, round both.
TEST(RollingBallFillets, OnConesThatCrossInPartTouchBoth) {
  std::mt19937 random(25);
  std::uniform_real_distribution<double> uniform;
  int loops = 0;
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    const test::Placement place = test::random_placement(random);
    const double psi = .8 + (kPi - 1.6) * uniform(random);
    const double aside = (i % 2 == 0 ? 1 : -1) * (2.2 + 1.6 * uniform(random));
    const std::array<Ring, 2> quadrics{
        place(Ring{Vec3(uniform(random), 0, aside), Vec3::UnitX(), 3,
                   i % 3 == 0 ? 0 : .2 * uniform(random) - .1}),
        place(Ring{Vec3::Zero(), Vec3(std::cos(psi), std::sin(psi), 0), 1.5,
                   i % 3 == 1 ? 0 : .2 * uniform(random) - .1})};
    for (const auto& pair : {quadrics, std::array{quadrics[1], quadrics[0]}}) {
      const auto fillets = rolling_ball_fillets(pair, .3);
      if (fillets.size() == 2) {
        continue;  // it passes, with this slope
      }
      ASSERT_EQ(fillets.size(), 1);
      ++loops;
      EXPECT_LT(test::residual(fillets[0], 256), 1e-14);
      EXPECT_TRUE(corners(fillets[0]).empty());
      for (const double t : {0.0, .1, 1.2, 2.9, 3.1415926, 4.7}) {
        EXPECT_LT(test::derivative_error(fillets[0], t, 1e-3), 1e-7) << t;
      }
    }
  }
  EXPECT_GT(loops, 150);
}

// The loop is the same whatever says it, up to how it is passed.
TEST(RollingBallFillets, OnConesOfNearlyNoSlopeThatCrossInPartAreThoseOnCylinders) {
  const std::array<Ring, 2> cylinders{cylinder(Vec3(0, 0, 1.5), Vec3::UnitX(), 2),
                                      cylinder(Vec3::Zero(), Vec3(.6, .8, 0), 1)};
  std::array<Ring, 2> cones = cylinders;
  cones[1].slope = 1e-13;
  const auto length = [](const CanalFillet& loop) {
    double sum = 0;
    for (int i = 0; i < 2000; ++i) {
      sum += ball(loop, 2 * kPi * i / 2000).velocity.norm() * 2 * kPi / 2000;
    }
    return sum;
  };
  const auto expected = rolling_ball_fillets(cylinders, .3),
             found = rolling_ball_fillets(cones, .3);
  ASSERT_EQ(expected.size(), 1);
  ASSERT_EQ(found.size(), 1);
  EXPECT_NEAR(length(found[0]), length(expected[0]), 1e-10);
}

// A pipe that turns less from a cone's axis than the cone opens leaves it at one place.
TEST(RollingBallFillets, OnWideConesAreOneLoopRoundThePipe) {
  const Ring cone{{0, 0, 0}, Vec3::UnitZ(), 4, -1};
  for (const double tilt : {0.05, 0.3, 0.6}) {
    const Ring pipe{{1, 0.2, 0}, Vec3(std::sin(tilt), 0, std::cos(tilt)), 0.7, 0};
    for (const auto& pair : {std::array{cone, pipe}, std::array{pipe, cone}}) {
      const auto fillets = rolling_ball_fillets(pair, 0.3);
      ASSERT_EQ(fillets.size(), 1) << tilt;
      EXPECT_LT(test::residual(fillets[0]), 1e-14) << tilt;
    }
  }
}

TEST(RollingBallFillets, OnConesOfNearlyNoSlopeAreThoseOnCylinders) {
  const std::array<Ring, 2> cylinders{cylinder(Vec3(0, 0, .25), Vec3::UnitX(), 2),
                                      cylinder(Vec3::Zero(), Vec3(.6, .8, 0), 1)};
  std::array<Ring, 2> cones = cylinders;
  cones[1].slope = 1e-14;
  const auto expected = rolling_ball_fillets(cylinders, .3),
             found = rolling_ball_fillets(cones, .3);
  for (std::size_t side = 0; side < 2; ++side) {
    for (const double t : {0.0, 1.0, 2.0, 4.0, 5.0}) {
      const MovingBall one = ball(expected[side], t), two = ball(found[side], t);
      EXPECT_LT((one.center - two.center).norm(), 1e-12);
      EXPECT_LT((one.velocity - two.velocity).norm(), 1e-12);
      EXPECT_LT((one.acceleration - two.acceleration).norm(), 1e-11);
    }
  }
}

void expect_refused(const std::array<Ring, 2>& quadrics, double radius, Errc code,
                    const std::string& why) {
  try {
    (void)rolling_ball_fillets(quadrics, radius);
    ADD_FAILURE() << "not refused: " << why;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    EXPECT_NE(error.message().find(why), std::string::npos) << error.message();
  }
}

TEST(RollingBallFillets, SayWhyThereAreNone) {
  const Ring run = cylinder(Vec3::Zero(), Vec3::UnitX(), 2);
  const Ring branch = cylinder(Vec3(0, 0, 3.5), Vec3::UnitY(), 1);
  expect_refused({run, cylinder(Vec3(0, 2, 0), -Vec3::UnitX(), 1)}, .5, Errc::irregular_surface,
                 "parallel");
  expect_refused({run, branch}, .5, Errc::irregular_surface, "3.5 apart");
  expect_refused({branch, run}, .5, Errc::irregular_surface, "3.5 apart");
  // The apex is inside the run.
  Ring cone = cylinder(Vec3(0, 1, 0), Vec3::UnitY(), 1);
  cone.slope = -1.2;
  expect_refused({run, cone}, .2, Errc::irregular_surface, "apex");
  cone = cylinder(Vec3(0, 0, 1), Vec3::UnitY(), 1);
  cone.slope = 1e-13;
  expect_refused({run, cone}, .2, Errc::irregular_surface, "touches the other from inside");
  cone = cylinder(Vec3(0, 0, 9), Vec3::UnitY(), 1);
  cone.slope = .1;
  expect_refused({run, cone}, .2, Errc::irregular_surface, "neither");
  expect_refused({run, branch}, -1, Errc::invalid_argument, "positive");
  expect_refused({run, branch}, std::nan(""), Errc::invalid_argument, "positive");
  EXPECT_THROW((void)rolling_ball_fillets({run, branch}, .2, std::nan("")), Error);
  Ring bad = branch;
  bad.radius = -1;
  expect_refused({run, bad}, 1, Errc::invalid_argument, "");
  bad = branch;
  bad.ellipse = Ellipse{Vec3::UnitX(), 3, 0};
  expect_refused({run, bad}, 1, Errc::invalid_argument, "circular");
}

}  // namespace
}  // namespace dupin
