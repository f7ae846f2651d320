#include <algorithm>
#include <array>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "tessellation/tessellation_tolerance.h"

namespace dupin::tessellation {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity(),
                 kNoNumber = std::numeric_limits<double>::quiet_NaN();

// The point of the surface that is meant, with 11 more bits, in a frame of given doubles.
double distance_to_meant(const Vec3& found, const RingedSurface& surface, const Frame& frame,
                         double t, double u) {
  const auto& h = std::get<HermiteSpine>(surface.spine);
  const long double s = t, r = std::get<ConstantRadius>(surface.radius).radius, v = u;
  long double squared = 0;
  for (int k = 0; k < 3; ++k) {
    const long double center =
        (1 - s) * (1 - s) * (1 + 2 * s) * h.from[k] + s * s * (3 - 2 * s) * h.to[k] +
        s * (1 - s) * ((1 - s) * h.start_velocity[k] - s * h.end_velocity[k]);
    const long double meant =
        center + r * (std::cos(v) * frame.first[k] + std::sin(v) * frame.second[k]);
    squared += (found[k] - meant) * (found[k] - meant);
  }
  return double(std::sqrt(squared));
}

TEST(PointError, holds_for_computed_and_snapped_points) {
  std::mt19937_64 random(14);
  std::uniform_real_distribution<double> at(-1, 1), parameter(0, 1), angle(0, 6);
  const auto vector = [&] { return Vec3(at(random), at(random), at(random)); };
  // A grid that matters, and places so far out that rounding does.
  for (const auto& [scale, grid] : {std::pair(1., 0x1p-10), {1e6, 0.}, {1e6, 0x1p-30}}) {
    double most = 0, bound = 0;
    for (int i = 0; i < 200; ++i) {
      const Vec3 from = scale * vector(), to = from + vector();
      const RingedSurface surface{
          {from, -Vec3::UnitZ(), 1.5},
          {to, Vec3::UnitZ(), 1.5},
          HermiteSpine{from, to, Vec3(0, 0, 2) + vector(), Vec3(0, 0, 2) + vector()},
          ConstantRadius{1.5}};
      const FrameField frames(surface.spine, Vec3::UnitX());
      bound = point_error(surface, grid);
      for (int k = 0; k < 20; ++k) {
        const double t = parameter(random), u = angle(random);
        const Vec3 found = snapped(evaluate(surface, frames, t, u).position, grid);
        const double error = distance_to_meant(found, surface, frames.at(t), t, u);
        EXPECT_LE(error, bound);
        most = std::max(most, error);
      }
    }
    EXPECT_GE(most, bound / 100) << "the bound would be useless";
  }
}

TEST(PointError, is_half_the_diagonal_of_a_cell_in_the_worst_case) {
  const double grid = 0x1p-4;
  const Vec3 worst = Vec3::Constant(grid / 2);
  EXPECT_NEAR((snapped(worst, grid) - worst).norm(), point_error(0, grid), 1e-16);
  EXPECT_EQ(point_error(Sphere{Vec3(3, 0, 4), 2}, grid), point_error(7, grid));
}

TEST(TessellationTolerance, leaves_to_chords_what_points_do_not_need) {
  EXPECT_EQ(allowed_error(0.5, 0), 0.5);
  EXPECT_EQ(allowed_error(0.5, 0.125), 0.375);
  for (const auto& [tolerance, displacement] : {std::pair(0.5, 0.25),
                                                {0.5, 1.0},
                                                {0.0, 0.0},
                                                {-1.0, 0.0},
                                                {kNoNumber, 0.0},
                                                {0.5, kNoNumber}}) {
    try {
      (void)allowed_error(tolerance, displacement);
      ADD_FAILURE() << tolerance << ' ' << displacement;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
    }
  }
}

TEST(TessellationTolerance, rounds_segments_up_and_limits_them) {
  EXPECT_EQ(segment_count(0), 8U);
  EXPECT_EQ(segment_count(8), 8U);
  EXPECT_EQ(segment_count(8.001), 9U);
  EXPECT_EQ(segment_count(1e6), 1'000'000U);
  for (const double wanted : {1e6 + 0.5, kInfinity, kNoNumber}) {
    try {
      (void)segment_count(wanted);
      ADD_FAILURE() << wanted;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::limit_exceeded);
    }
  }
}

TEST(TessellationTolerance, refuses_meshes_beyond_the_limit) {
  EXPECT_NO_THROW(refuse_too_fine(50'000'000));
  try {
    refuse_too_fine(50'000'001);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
  }
}

}  // namespace
}  // namespace dupin::tessellation
