// Fillets of 192 tees: by the ratio of radii, the offset of the axes, their angle, and the size of
// the ball; general, equal and touching pipes.
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/filleted_runs.h"
#include "blends/assembly/filleted_tee.h"
#include "dupin/blends/build.h"
#include "dupin/blends/canal_fillet.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using test::FilletIntegrals;
using test::Measures;
using test::Tee;

constexpr double kPi = std::numbers::pi, kTolerance = 0.02;

// A mesh that is so near to the smooth solid everywhere is as large as that, but for a layer.
double layer(const Built& built) {
  double sum = 0;
  for (const PartReport& part : built.parts) {
    sum = std::max(sum, part.error_bound);
  }
  return sum * built.solid.area();
}

// Closed and embedded as every `Solid` is.
void expect_fillet(const Tee& tee, const Built& built) {
  const double volume = built.solid.exact_volume().get_d();
  EXPECT_GT(built.solid.exact_volume(), build(tee.document(false)).solid.exact_volume());
  EXPECT_EQ(built.solid.genus(), 0);
  EXPECT_EQ(built.solid.components(), 1U);
  EXPECT_EQ(built.pieces, 1U) << "nothing is intersected";
  const ResolvedAssembly resolved = resolve(tee.document(true));
  const Measures smooth = FilletIntegrals(resolved).whole();
  EXPECT_NEAR(volume, smooth.flux / 3, layer(built));
  EXPECT_NEAR(built.solid.area(), smooth.area, 0.01 * smooth.area);
  for (const PartReport& part : built.parts) {
    EXPECT_LE(part.error_bound, kTolerance) << part.name;
    // No slivers; where the pipes touch, their faces end in sharp corners.
    const bool touch = !corners(resolved.fillets.front().shape.loops.front()).empty();
    const bool is_sharp = part.kind == "fillet" || touch;
    EXPECT_GT(part.smallest_angle, (is_sharp ? 0.01 : 1) * kPi / 180) << part.name;
  }
}

// How far the envelope is from folding at its worst place, by where the balls are, and nothing
// else: 1 less the ball's radius by the curvature of its way, towards the arc.
double sampled_regularity(const std::array<Ring, 2>& pipes, double radius) {
  constexpr double kStep = 1e-4;
  double least = 1;
  const auto loops = rolling_ball_fillets(pipes, radius);
  for (int i = 0; i < 2000; ++i) {
    const double t = 2 * kPi * i / 2000;
    const auto at = [&](double parameter) { return ball(loops.front(), parameter).center; };
    const Vec3 before = at(t - kStep), here = at(t), after = at(t + kStep);
    const Vec3 velocity = (after - before) / (2 * kStep);
    const Vec3 acceleration = (after - 2 * here + before) / (kStep * kStep);
    const Vec3 ahead = velocity.normalized();
    const Vec3 curvature =
        (acceleration - acceleration.dot(ahead) * ahead) / velocity.squaredNorm();
    const ContactArc arc = contact_arc(loops.front().quadrics, ball(loops.front(), t));
    for (int k = 0; k <= 50; ++k) {
      const Vec3 arm = point(arc, arc.angle * k / 50) - here;
      least = std::min(least, 1 - curvature.dot(arm));
    }
  }
  return least;
}

std::array<Ring, 2> pipes_of(const Tee& tee) {
  const ResolvedAssembly resolved = resolve(tee.document(false));
  return {end_ring(std::get<Chain>(resolved.parts[0].shape), End::end),
          end_ring(std::get<Chain>(resolved.parts[1].shape), End::end)};
}

// It folds, the ball that is named does not, and one 1 % larger does.
void expect_folds(const Tee& tee, const Error& error) {
  EXPECT_EQ(error.code(), Errc::infeasible_blend);
  EXPECT_THAT(error.what(), testing::HasSubstr("the fillet folds"));
  EXPECT_LT(sampled_regularity(pipes_of(tee), tee.radius_of_ball()), 0);
  const std::string before = "the largest ball that fits, to 1 %, has a radius of ";
  const std::string why = error.what();
  const auto at = why.find(before);
  ASSERT_NE(at, std::string::npos) << why;
  const double named = std::stod(why.substr(at + before.size()));
  Tee smaller = tee;
  smaller.ball = named / (tee.ratio * Tee::kRun);
  EXPECT_GT(sampled_regularity(pipes_of(tee), named), 0);
  EXPECT_LT(sampled_regularity(pipes_of(tee), 1.01 * named), 0);
  expect_fillet(smaller, build(smaller.document(true)));
}

TEST(FilletedRunsGrid, tees_are_as_large_as_integrals_say_or_their_balls_fold) {
  int solids = 0, folds = 0;
  for (const double ratio : {0.25, 0.5, 0.75, 1.0}) {
    for (const double offset : {0.0, 0.25, 0.75}) {
      for (const double degrees : {90, 60, 45, 30}) {
        for (const double ball : {0.05, 0.1, 0.2, 0.5}) {
          SCOPED_TRACE(testing::Message()
                       << ratio << ' ' << offset << ' ' << degrees << ' ' << ball);
          const Tee tee{ratio, offset, degrees * kPi / 180, ball};
          try {
            expect_fillet(tee, build(tee.document(true)));
            ++solids;
          } catch (const Error& error) {
            expect_folds(tee, error);
            ++folds;
          }
        }
      }
    }
  }
  EXPECT_EQ(solids, 183);
  EXPECT_EQ(folds, 9);
}

}  // namespace
}  // namespace dupin
