#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/cyclide_cases.h"
#include "support/paper_surfaces.h"
#include "surfaces/cyclide_discs.h"
#include "surfaces/pieces/piece_discs.h"

namespace dupin::surfaces {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct RandomDirections {
  std::mt19937_64 random{1414};
  std::normal_distribution<double> normal;

  Vec3 next() { return Vec3(normal(random), normal(random), normal(random)).normalized(); }
};

// The circles of the surface at the parameters of a stretch, normals in travel direction.
template <class CircleAt>
std::vector<Ring> samples(const CircleAt& circle_at, const ParameterInterval& t) {
  std::vector<Ring> result;
  for (int k = 0; k <= 32; ++k) {
    result.push_back(circle_at(std::lerp(t.from, t.to, k / 32.)));
  }
  return result;
}

// The largest x.w of the discs' points.
double reached(const std::vector<Ring>& discs, const Vec3& w) {
  double furthest = -kInfinity;
  for (const Ring& disc : discs) {
    furthest = std::max(furthest, disc.center.dot(w) + disc.radius * disc.normal.cross(w).norm());
  }
  return furthest;
}

template <class CircleAt>
void expect_enclosed(const PieceDiscs& discs, const CircleAt& circle_at) {
  RandomDirections directions;
  for (const ParameterInterval& t :
       {ParameterInterval{0, 1}, {0, .25}, {.5, .5 + 0x1p-5}, {.75, .75 + 0x1p-12}}) {
    SCOPED_TRACE(t.to - t.from);
    const std::vector<Ring> all = samples(circle_at, t);
    const DiscHull hull = discs.hull(t);
    double way = 0;
    for (const Ring& disc : all) {
      EXPECT_LE(hull.radius.lower, disc.radius + 1e-12);
      EXPECT_GE(hull.radius.upper, disc.radius - 1e-12);
      way = std::max(way, (disc.center - all.front().center).norm());
      if (hull.cosine > 0) {
        EXPECT_GE(std::acos(hull.cosine) + hull.spread + 1e-7,
                  std::acos(std::min(1., disc.normal.dot(hull.axis))));
      }
    }
    for (int i = 0; i < 100; ++i) {
      const Vec3 w = (i % 2 == 0 ? 1 : 3) * directions.next();
      const double bound = support(hull, w), least = reached(all, w);
      EXPECT_GE(bound, least - 1e-12);
      const double point = support_point(hull, w).dot(w);
      if (t.to - t.from <= 0x1p-12) {  // where the enclosure has to be good
        EXPECT_LE(bound, least + .05 * w.norm());
        EXPECT_NEAR(point, least, .05 * w.norm());
      }
    }
    if (t.to - t.from <= 0x1p-12) {
      EXPECT_LT((hull.middle() - all[16].center).norm(), way + 1e-9);
      EXPECT_LT(hull.extent(), 3 * way);
    }
    const auto [before, after] = halves(t);
    EXPECT_EQ(before.from, t.from);
    EXPECT_EQ(before.to, after.from);
    EXPECT_EQ(after.to, t.to);
    EXPECT_EQ(size(before), size(after));
    if (hull.extent() < kInfinity) {
      EXPECT_LT(discs.hull(before).extent(), hull.extent());
    }
  }
}

TEST(PieceDiscs, of_a_spine_enclose_its_circles) {
  const ArcSpine arc{Vec3(0, 0, 0), Vec3::UnitZ(), Vec3(4, 0, 0), 5};
  for (const RingedSurface& surface :
       {test::figure6(), test::figure6(CyclideRadius{1, 2}),
        RingedSurface{{}, {}, arc, LinearRadius{1, 2}},
        RingedSurface{{}, {}, LineSpine{Vec3(0, 0, 0), Vec3(3, 1, 2)}, ConstantRadius{2}}}) {
    const PieceDiscs discs = discs_of(SweptDiscTube(surface), true);
    EXPECT_TRUE(discs.full);
    expect_enclosed(discs, [&](double t) {
      const SpinePoint y = evaluate(surface.spine, t);
      return Ring{y.position, y.first.normalized(), evaluate(surface.radius, t).value};
    });
    EXPECT_TRUE(discs.turns_little({.5, .5 + 0x1p-5}, 0));
  }
}

TEST(PieceDiscs, of_a_motion_enclose_its_circles) {
  test::RandomArcs arcs;
  for (int i = 0; i < 10; ++i) {
    const PeArc arc = arcs.next();
    const PieceDiscs discs =
        discs_of([all = CyclideDiscs(cyclide_piece(arc))](const numbers::Interval& t, bool) {
          return all.over(t);
        });
    expect_enclosed(discs, [&](double t) { return circle_at(arc, t); });
    EXPECT_TRUE(discs.pace({.5, .5 + 0x1p-9}).has_value());
    EXPECT_FALSE(discs.turns_little({.5, .5 + 0x1p-9}, 0)) << "is not known";
  }
}

TEST(PieceDiscs, of_which_nothing_is_known_may_be_anywhere) {
  const PieceDiscs discs =
      discs_of([](const numbers::Interval&, bool) { return std::optional<MovingDisc>(); });
  const DiscHull hull = discs.hull({0, 1});
  EXPECT_EQ(hull.radius.upper, kInfinity);
  EXPECT_EQ(hull.extent(), kInfinity);
  EXPECT_EQ(support(hull, Vec3(1, 2, 3)), kInfinity);
  EXPECT_FALSE(discs.pace({0, 1}).has_value());
}

// The paces are asked for steered, so that plates are left; the hulls as they are.
TEST(PieceDiscs, steer_paces_alone) {
  std::vector<bool> asked;
  const PieceDiscs discs = discs_of([&asked](const numbers::Interval&, bool steered) {
    asked.push_back(steered);
    return std::optional(MovingDisc{{}, numbers::interval_vec(Vec3::UnitZ()), {}, {}, 1});
  });
  (void)discs.hull({0, 1});
  EXPECT_EQ(asked, std::vector<bool>(2, false));
  asked.clear();
  EXPECT_NEAR(discs.pace({.25, .75})->width, .5, 1e-15);
  EXPECT_EQ(asked, std::vector<bool>(1, true));
}

TEST(DiscHull, of_a_ball_reaches_equally_far_everywhere) {
  const DiscHull ball{{numbers::interval_vec(Vec3(1, 2, 3))}, {}, Vec3::Zero(), 0, 2, 0};
  RandomDirections directions;
  for (int i = 0; i < 50; ++i) {
    const Vec3 w = directions.next();
    EXPECT_NEAR(support(ball, w), Vec3(1, 2, 3).dot(w) + 2, 1e-12);
    EXPECT_LT((support_point(ball, w) - (Vec3(1, 2, 3) + 2 * w)).norm(), 1e-12);
  }
  EXPECT_EQ(ball.middle(), Vec3(1, 2, 3));
  EXPECT_EQ(ball.extent(), 0);
}

}  // namespace
}  // namespace dupin::surfaces
