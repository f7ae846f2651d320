#include <cmath>
#include <numbers>
#include <set>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/filleted_runs.h"
#include "dupin/blends/build.h"
#include "dupin/blends/canal_fillet.h"
#include "dupin/kernel/error.h"
#include "support/named_parts.h"

namespace dupin {
namespace {

using test::fillet;
using test::pipe;

constexpr double kPi = std::numbers::pi;

Assembly assembly(std::vector<Part> parts, double tolerance = 0.02) {
  return {"d.json", Unit::millimetre, tolerance, {}, std::move(parts)};
}

struct Tee {
  double ratio, offset, angle, ball;

  static constexpr double kRun = 4;

  [[nodiscard]] Assembly document(bool with_fillet, double tolerance = 0.02) const {
    const double branch = ratio * kRun, aside = offset * kRun, rho = ball * branch;
    const Vec3 direction(std::cos(angle), std::sin(angle), 0);
    const double length =
        (kRun + branch + 3 * rho + branch * std::cos(angle)) / std::sin(angle) + 6;
    const double half = 2 * length;
    // Beside the axis it may leave the run: it has to pass through then.
    const bool passes = offset + ratio > 1;
    const Vec3 at(0, 0, aside);
    std::vector<Part> parts{pipe("run", {-half, 0, 0}, {half, 0, 0}, kRun),
                            pipe("branch", passes ? Vec3(at - length * direction) : at,
                                 at + length * direction, branch)};
    if (with_fillet) {
      parts.push_back(fillet("throat", "run", "branch", rho));
    }
    return assembly(std::move(parts), tolerance);
  }
};

CanalFillet loop_of(const Tee& tee) {
  return resolve(tee.document(true)).fillets.front().shape.loops.front();
}

// Radius ratio, offset, angle and size of the ball as far as issues of fillets know them: general,
// equal and touching pipes. Every one is a solid, larger than the sharp one, or folds.
TEST(FilletedRuns, tees_of_all_kinds_are_solids_or_their_balls_fold) {
  int solids = 0, folds = 0;
  for (const double ratio : {0.25, 0.5, 0.75, 1.0}) {
    for (const double offset : {0.0, 0.25, 0.75}) {
      for (const double degrees : {90, 60, 45, 30}) {
        for (const double ball : {0.05, 0.1, 0.2, 0.5}) {
          SCOPED_TRACE(testing::Message()
                       << ratio << ' ' << offset << ' ' << degrees << ' ' << ball);
          const Tee tee{ratio, offset, degrees * kPi / 180, ball};
          try {
            const Built built = build(tee.document(true));
            EXPECT_GT(built.solid.exact_volume(), build(tee.document(false)).solid.exact_volume());
            EXPECT_EQ(built.solid.genus(), 0);
            EXPECT_EQ(built.solid.components(), 1U);
            for (const PartReport& part : built.parts) {
              EXPECT_LE(part.error_bound, 0.02) << part.name;
              // No slivers; where the pipes touch, their faces end in sharp corners.
              const bool is_sharp = part.kind == "fillet" || !corners(loop_of(tee)).empty();
              EXPECT_GT(part.smallest_angle, (is_sharp ? 0.01 : 1) * kPi / 180) << part.name;
            }
            ++solids;
          } catch (const Error& error) {
            EXPECT_EQ(error.code(), Errc::infeasible_blend);
            EXPECT_THAT(error.what(), testing::HasSubstr("the fillet folds"));
            EXPECT_THAT(error.what(), testing::HasSubstr("the largest ball that fits"));
            EXPECT_EQ(degrees, 30);
            EXPECT_EQ(ball, 0.5);
            ++folds;
          }
        }
      }
    }
  }
  EXPECT_EQ(solids, 183);
  EXPECT_EQ(folds, 9);
}

// Of a region on a cylinder about an axis through the origin, x.n is the radius: the volume is a
// third of the sum of areas by radius, of discs by height, and of the integral over the fillet.
double volume_by_integrals(const Tee& tee) {
  const Assembly document = tee.document(true);
  const ResolvedAssembly resolved = resolve(document);
  const CanalFillet& loop = resolved.fillets.front().shape.loops.front();
  constexpr int kAlong = 4000, kAcross = 40;
  double sum = 0;
  std::array<double, 2> area_under{};  // of what the feet's heights bound
  for (int i = 0; i < kAlong; ++i) {
    const double step = 2 * kPi / kAlong, t = (i + 0.5) * step;
    const MovingBall at = ball(loop, t);
    const ContactArc arc = contact_arc(loop.quadrics, at);
    for (int j = 0; j < kAcross; ++j) {
      const double angle = (j + 0.5) * arc.angle / kAcross;
      const Vec3 x = point(arc, angle), out = (at.center - x) / at.radius;
      const double bend = 1 + at.radius * at.acceleration.dot(out) / at.velocity.squaredNorm();
      sum += x.dot(out) * bend * at.velocity.norm() * at.radius * step * arc.angle / kAcross;
    }
    for (std::size_t side = 0; side < 2; ++side) {
      const Ring& quadric = loop.quadrics.at(side);
      const auto foot = [&](double parameter) {
        return contact_arc(loop.quadrics, ball(loop, parameter)).feet.at(side);
      };
      const Vec3 a = foot(i * step), b = foot((i + 1) * step);
      const Vec3 u = quadric.normal.cross(a), v = quadric.normal.cross(b);
      const double turn = std::atan2(u.cross(v).dot(quadric.normal), u.dot(v));
      area_under.at(side) += quadric.radius * turn * (a + b).dot(quadric.normal) / 2;
    }
  }
  const auto& chain = [&](std::size_t i) -> const Chain& {
    return std::get<Chain>(resolved.parts[i].shape);
  };
  const auto volume_of = [](double radius, double height) {
    return kPi * radius * radius * height;
  };
  const double run = 2 * end_ring(chain(0), End::end).center.norm();
  const double branch = end_ring(chain(1), End::end).center.norm();
  const double r = loop.quadrics[1].radius;
  sum += Tee::kRun * (2 * kPi * Tee::kRun * run - std::abs(area_under[0]));
  sum += r * (2 * kPi * r * branch - std::abs(area_under[1]));
  return sum / 3 + (volume_of(Tee::kRun, run) + volume_of(r, branch)) / 3;
}

TEST(FilletedRuns, volumes_tend_to_those_of_independent_integrals_at_second_order) {
  for (const Tee& tee : {Tee{0.5, 0, kPi / 2, 0.3}, Tee{0.75, 0, kPi / 3, 0.2}}) {
    const double expected = volume_by_integrals(tee);
    const auto fault = [&](double tolerance) {
      const Built built = build(tee.document(true, tolerance));
      const double found = std::abs(built.solid.exact_volume().get_d() - expected);
      EXPECT_LT(found, tolerance * built.solid.area());
      return found;
    };
    const double coarse = fault(0.02), fine = fault(0.001);
    EXPECT_LT(fine, coarse / 10) << "a twentieth of the tolerance";
  }
}

TEST(FilletedRuns, names_every_patch) {
  const Built built = build(Tee{0.5, 0, kPi / 2, 0.3}.document(true));
  EXPECT_THAT(built.solid.names(), testing::UnorderedElementsAre("run", "run.start", "run.end",
                                                                 "branch", "branch.end", "throat"));
  const std::set<std::uint32_t> used(built.solid.labels().begin(), built.solid.labels().end());
  EXPECT_EQ(used.size(), built.solid.names().size());
  ASSERT_EQ(built.parts.size(), 3U);
  EXPECT_EQ(built.parts[2].kind, "fillet");
  EXPECT_GT(built.parts[2].triangles, 0U);
  for (const PartReport& part : built.parts) {
    EXPECT_GT(part.error_bound, 0) << part.name;
    EXPECT_LE(part.error_bound, 0.02) << part.name;
    EXPECT_GT(part.segments, 0U) << part.name;
  }
  ASSERT_EQ(built.ports.size(), 3U) << "branch.start is inside the run";
}

// Whatever is joined to the pipes' other ends stays: a header of elbows and caps.
TEST(FilletedRuns, join_any_number_of_runs) {
  std::vector<Part> parts{pipe("run", {0, 0, 0}, {60, 0, 0}, 4)};
  for (int i = 0; i < 5; ++i) {
    const std::string name = "branch-" + std::to_string(i);
    parts.push_back({"throat-" + std::to_string(i), FilletBetween{{name, "run"}, 0.5}});
    parts.push_back(pipe(name, {6. + 12 * i, 0, 0}, {6. + 12 * i, 0, 12}, 2));
    parts.push_back({"elbow-" + std::to_string(i),
                     ElbowTurning{PortReference{name, End::end}, 5, kPi / 2, {0, 1, 0}}});
  }
  const Built built = build(assembly(parts));
  EXPECT_EQ(built.pieces, 1U);
  EXPECT_EQ(built.runs, 6U);
  EXPECT_EQ(built.solid.genus(), 0);
  EXPECT_EQ(built.parts[1].name, "throat-0") << "reports are in the document's order";
  EXPECT_EQ(built.parts.size(), 16U);
}

// A part that crosses the solid elsewhere is united with it.
TEST(FilletedRuns, are_united_with_what_crosses_them) {
  std::vector<Part> parts = Tee{0.5, 0, kPi / 2, 0.3}.document(true).parts;
  parts.push_back({"ball", SphereAt{{4, 4, 0}, 2}});
  const Built built = build(assembly(parts));
  EXPECT_EQ(built.pieces, 2U);
  EXPECT_EQ(built.solid.components(), 1U);
}

}  // namespace
}  // namespace dupin
