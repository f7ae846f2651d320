#include <numbers>

#include <gtest/gtest.h>

#include "dupin/blends/cyclic_blend.h"
#include "ringed/blend_crossing.h"

namespace dupin::ringed {
namespace {

RingedSurface between(const Ring& from, const Ring& to, double k, double l) {
  return {flipped(from), flipped(to),
          HermiteSpine{from.center, to.center, k * from.normal, -l * to.normal},
          CubicRadius{from.radius, to.radius}};
}

TEST(BlendCrossing, of_a_plain_blend_is_none) {
  const Ring from{Vec3(0, 0, 0), Vec3::UnitX(), 1}, to{Vec3(10, 4, 0), -Vec3::UnitX(), 2};
  EXPECT_EQ(crossing(cyclic_blend(from, to, {}), 0.05), std::nullopt);
}

// Half a turn, as tight as the margin allows: the sides all but touch.
TEST(BlendCrossing, of_a_tight_half_turn_is_none) {
  for (const double margin : {0., 0.05, 0.5}) {
    const double radius = (1 - margin) * 0.999;
    const ArcSpine arc{Vec3(0, 0, 0), Vec3::UnitZ(), Vec3::UnitX(), std::numbers::pi};
    const RingedSurface bend{{Vec3(1, 0, 0), -Vec3::UnitY(), radius},
                             {Vec3(-1, 0, 0), -Vec3::UnitY(), radius},
                             arc,
                             LinearRadius{radius, radius}};
    EXPECT_EQ(crossing(bend, margin), std::nullopt) << margin;
  }
}

// It passes through its own end, near its fast start, where samples at equal steps of the
// parameter were further apart than the radius.
TEST(BlendCrossing, of_a_fast_blend_through_its_own_end_is_found) {
  const Ring from{Vec3(0, 0, 0), Vec3::UnitX(), 10.48};
  const Ring to{Vec3(23.922648905970075, 9.786736034982507, 8.113453914430274),
                Vec3(0.5822741603478443, 0.040924235167710155, 0.3391737898709435).normalized(),
                6.89};
  EXPECT_NE(crossing(between(from, to, 976.2, 874.02), 0.05), std::nullopt);
}

// There and back beside it.
TEST(BlendCrossing, of_a_loop_beside_itself_is_found) {
  const auto loop = [](double radius) {
    const Ring from{Vec3(0, 0, 0), Vec3::UnitX(), radius};
    const Ring to{Vec3(0, 3, 0), Vec3::UnitX(), radius};
    const BezierSpine spine{{from.center, Vec3(20, 0, 0), Vec3(60, -40, 0), Vec3(60, 43, 0),
                             Vec3(20, 3, 0), to.center}};
    return RingedSurface{flipped(from), flipped(to), spine, LinearRadius{radius, radius}};
  };
  EXPECT_EQ(crossing(loop(1), 0.05), std::nullopt);
  EXPECT_EQ(crossing(loop(1.6), 0.05), "crosses itself");
}

TEST(BlendCrossing, of_a_blend_that_comes_back_beyond_its_start_is_found) {
  const Ring at{Vec3(0, 0, 0), Vec3::UnitX(), 1}, below{Vec3(-60, -27, 0), Vec3::UnitY(), 1};
  EXPECT_EQ(crossing(between(at, below, 270, 270), 0.05),
            "runs into what would go straight on behind its start");
  EXPECT_EQ(crossing(between(below, at, 270, 270), 0.05),
            "runs into what would go straight on behind its end");
}

}  // namespace
}  // namespace dupin::ringed
