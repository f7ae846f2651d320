#include <gtest/gtest.h>

#include "assembly/narrowed_shape.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {
namespace {

TEST(NarrowedShape, has_radii_less_the_wall_or_more) {
  const Ring ring{Vec3(1, 2, 3), Vec3::UnitX(), 5, 0, Ellipse{Vec3::UnitY(), 4}};
  EXPECT_EQ(narrowed(ring, 1).radius, 4);
  EXPECT_EQ(narrowed(ring, 1).ellipse->across, 3);
  EXPECT_EQ(narrowed(ring, -1).radius, 6);
  EXPECT_EQ(std::get<Sphere>(narrowed(PartSurface(Sphere{Vec3(1, 2, 3), 2}), 0.5)).radius, 1.5);
  const Ring a{Vec3::Zero(), -Vec3::UnitX(), 5}, b{Vec3(9, 0, 0), Vec3::UnitX(), 3};
  const PartSurface cone =
      Chain(RingedSurface{a, b, LineSpine{a.center, b.center}, LinearRadius{5, 3}});
  const auto both = narrowed({&cone, &cone}, {1, 2});
  const auto& first = std::get<RingedSurface>(std::get<Chain>(both[0]).pieces.front());
  const auto& second = std::get<RingedSurface>(std::get<Chain>(both[1]).pieces.front());
  EXPECT_EQ(evaluate(first.radius, 1).value, 2);
  EXPECT_EQ(first.start.radius, 4);
  EXPECT_EQ(evaluate(second.radius, 0).value, 3);
  EXPECT_EQ(second.end.radius, 1);
}

TEST(NarrowedShape, leaves_no_more_than_there_is) {
  EXPECT_EQ(less_wall(2, 1.5), 0.5);
  EXPECT_THROW((void)less_wall(2, 2), Error);
  EXPECT_THROW(
      (void)narrowed(Ring{Vec3::Zero(), Vec3::UnitX(), 5, 0, Ellipse{Vec3::UnitY(), 1}}, 1), Error);
}

// The ring goes on along its cone, which moves out of itself by the wall.
TEST(NarrowedShape, of_a_cone_has_a_parallel_ring) {
  Ring ring{Vec3::Zero(), Vec3::UnitX(), 5, 0.75, {}};
  const Ring inner = parallel(ring, 1);
  EXPECT_DOUBLE_EQ(inner.radius, 5 - 1 / 1.25);
  EXPECT_DOUBLE_EQ(inner.center.x(), 0.6);
}

TEST(NarrowedShape, of_a_junction_is_one_or_is_refused) {
  const std::vector<Ring> ends{{{9, 0, 0}, {-1, 0, 0}, 1}, {{0, 9, 0}, {0, -1, 0}, 1.5}};
  const Junction junction = junction_of(ends);
  const Junction inside = narrowed(junction, 0.25);
  EXPECT_EQ(unsoundness(inside), "");
  EXPECT_EQ(inside.hub.radius, junction.hub.radius - 0.25);
  EXPECT_EQ(inside.arms[1].end.radius, 1.25);
  EXPECT_THROW((void)narrowed(junction, 1), Error);
  const Junction outside = narrowed(junction, -0.125);
  EXPECT_EQ(outside.arms[1].end.radius, 1.625);
  EXPECT_THROW((void)narrowed(junction, -0.5), Error);  // too tight a bend
}

std::string advice(double thickness, double limit, InsulationAdvice kind) {
  try {
    refuse_insulation(thickness, Error(Errc::irregular_surface, "it folds"), kind,
                      [limit](double tried) {
                        if (!(tried < limit)) {
                          throw Error(Errc::irregular_surface, "too thick");
                        }
                      });
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::irregular_surface);
    return error.message();
  }
}

TEST(InsulationThatIsTooThick, is_refused_with_the_largest_number_of_so_many_digits_that_fits) {
  const std::string begin = "its insulation of 12 is too thick for its bends; it may be at most ";
  EXPECT_EQ(advice(12, 10, InsulationAdvice::largest), begin + "9.99999");
  EXPECT_EQ(advice(12, 10.00005, InsulationAdvice::largest), begin + "10");
  EXPECT_EQ(advice(12, 1.234567, InsulationAdvice::largest), begin + "1.23456");
  EXPECT_EQ(advice(12, 12, InsulationAdvice::largest), begin + "11.9999");
}

TEST(InsulationThatIsTooThick, may_be_refused_with_one_that_would_do) {
  EXPECT_EQ(advice(12, 10, InsulationAdvice::some),
            "its insulation of 12 is too thick for its bends; 9.98 would do");
}

TEST(InsulationThatIsTooThick, is_refused_as_all_are) {
  EXPECT_EQ(advice(12, 0, InsulationAdvice::largest),
            "its insulation of 12 is too thick for its bends: it folds");
}

}  // namespace
}  // namespace dupin::assembly
