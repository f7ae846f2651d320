#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "tessellation/band_stepper.h"
#include "tessellation/swept_mesh.h"

namespace dupin::tessellation {
namespace {

constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
constexpr double kAround = 0.25;

// The second derivatives fall along the way, then rise again; the tangent turns throughout.
std::vector<ringed::BandBounds> cells(double turning) {
  std::vector<ringed::BandBounds> result;
  for (const double along : {8., 4., 2., 0., 0., 1., 16., 2.}) {
    result.push_back({{along, along / 4, 1}, turning});
  }
  return result;
}

struct Parameters {
  double t, u;
};

// How far a function with these constant second derivatives is from its linear interpolant on the
// triangle, at most, by dense sampling.
double interpolation_error(const SecondDerivativeBounds& second,
                           const std::array<Parameters, 3>& corners) {
  const auto x = [&](double t, double u) {
    return (second.along * t * t + 2 * second.mixed * t * u + second.around * u * u) / 2;
  };
  constexpr int kSteps = 40;
  double largest = 0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; i + j <= kSteps; ++j) {
      const std::array share{double(i) / kSteps, double(j) / kSteps,
                             double(kSteps - i - j) / kSteps};
      double t = 0, u = 0, interpolated = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        t += share.at(k) * corners.at(k).t;
        u += share.at(k) * corners.at(k).u;
        interpolated += share.at(k) * x(corners.at(k).t, corners.at(k).u);
      }
      largest = std::max(largest, std::abs(x(t, u) - interpolated));
    }
  }
  return largest;
}

// Quadrics are the worst surfaces there are, so that the bound is attained.
TEST(BandStepper, bounds_the_error_of_triangles_on_either_diagonal) {
  for (const SecondDerivativeBounds& second :
       {SecondDerivativeBounds{3, 1, 2}, {3, 0, 2}, {0, 1, 2}, {5, 4, 0}}) {
    const BandStepper march({{second, 0}}, kAround);
    for (const double twist : {0., 0.05}) {
      for (const double dt : {0.1, 0.5, 1.0}) {
        const Parameters a{0, 0}, b{0, kAround}, c{dt, kAround + twist}, d{dt, twist};
        double largest = 0;
        for (const auto& triangle : {std::array{a, b, c}, {a, c, d}, {a, b, d}, {b, c, d}}) {
          largest = std::max(largest, interpolation_error(second, triangle));
        }
        const double bound = march.error_bound({0, dt}, twist);
        EXPECT_LE(largest, bound * (1 + 1e-14));
        EXPECT_GE(largest, bound * (1 - 1e-12));
      }
    }
  }
}

TEST(BandStepper, marches_in_the_largest_bands_that_keep_to_the_bound) {
  constexpr double kAllowed = 0.35;
  for (const double turning : {0., 6.}) {
    for (const double twist : {0., 0.02}) {
      const BandStepper march(cells(turning), kAround);
      const std::vector<double> knots = march.knots(kAllowed, twist, kNoLimit);
      EXPECT_EQ(knots.front(), 0);
      EXPECT_EQ(knots.back(), 1);
      EXPECT_GT(knots.size(), 6U);
      EXPECT_LE(8 * march.error_bound(knots, twist), kAllowed);
      for (std::size_t i = 0; i + 2 < knots.size(); ++i) {
        ASSERT_LT(knots[i], knots[i + 1]);
        const double longer = knots[i + 1] - knots[i] + 1e-9;
        EXPECT_TRUE(8 * march.error_bound({knots[i], knots[i] + longer}, twist) > kAllowed ||
                    turning * longer > 1)  // the most that a band may turn
            << i;
      }
      const std::vector<double> first = march.knots(kAllowed, twist, 3);
      EXPECT_TRUE(std::equal(first.begin(), first.end(), knots.begin(), knots.begin() + 4));
    }
  }
}

// The tangent runs around a small circle of the unit sphere, where frames drift most; they are
// carried in kFrameSteps steps, and nearly continuously.
TEST(BandStepper, allows_for_the_drift_of_carried_frames) {
  double worst = 0;
  for (const double opening : {0.02, 0.5, std::numbers::pi / 2}) {
    for (const double turn : {0.25, 1.0}) {
      const auto tangent = [&](double t) {
        const double azimuth = turn * t / std::sin(opening);
        return Vec3(std::sin(opening) * std::cos(azimuth), std::sin(opening) * std::sin(azimuth),
                    std::cos(opening));
      };
      const auto arrived = [&](int steps) {
        Vec3 first = tangent(0).unitOrthogonal();
        for (int i = 0; i < steps; ++i) {
          first = carried(tangent(double(i) / steps), tangent(double(i + 1) / steps), first);
        }
        return first;
      };
      const double drift =
          std::acos(std::min(1.0, arrived(int(kFrameSteps)).dot(arrived(1 << 16))));
      // With |x_uu| = 1 alone, eight errors are the square of a segment and what rows are sheared.
      const BandStepper march({{{0, 0, 1}, turn}}, kAround);
      const double sheared = std::sqrt(8 * march.error_bound({0, 1}, 0)) - kAround;
      EXPECT_LE(drift, sheared + 1e-7);
      worst = std::max(worst, drift / sheared);
    }
  }
  EXPECT_GT(worst, 0.5) << "the allowance would be useless";
}

// Bounds that exceed `along` by so much times a cell's length, and what they were asked for.
struct CountedBounds {
  double along = 8, excess = 0;
  std::uint32_t fewest_that_tell = 1;
  std::vector<std::uint32_t> asked;

  BoundsOfCells bounds() {
    return [this](std::uint32_t count) {
      asked.push_back(count);
      if (count < fewest_that_tell) {
        throw Error(Errc::irregular_surface, "too few cells");
      }
      return std::vector<ringed::BandBounds>(count, {{along + excess / count, along / 4, 1}, 0});
    };
  }
};

constexpr double kEightErrors = 0.35;

TEST(FineMarch, has_so_many_cells_that_more_save_no_bands) {
  for (const double excess : {0., 1., 10., 60., 100., 1e6}) {
    CountedBounds bounds{8, excess, 1, {}};
    const double bands =
        fine_march(bounds.bounds(), kAround, kEightErrors).expected_bands(kEightErrors);
    const double finest = BandStepper(bounds.bounds()(1024), kAround).expected_bands(kEightErrors);
    EXPECT_LE(finest, bands * (1 + 1e-12));
    EXPECT_LE(bands, 1.01 * finest) << excess;
  }
  CountedBounds smooth{8, 1, 1, {}}, rough{8, 1e6, 1, {}}, between{8, 60, 1, {}};
  (void)fine_march(smooth.bounds(), kAround, kEightErrors);
  (void)fine_march(rough.bounds(), kAround, kEightErrors);
  (void)fine_march(between.bounds(), kAround, kEightErrors);
  EXPECT_EQ(smooth.asked, (std::vector<std::uint32_t>{32, 64}));
  EXPECT_EQ(rough.asked, (std::vector<std::uint32_t>{32, 64, 1024}));
  ASSERT_EQ(between.asked.size(), 3U);
  EXPECT_GT(between.asked.back(), 64U);
  EXPECT_LT(between.asked.back(), 1024U);
}

TEST(FineMarch, has_the_most_cells_where_few_tell_nothing) {
  for (const std::uint32_t fewest : {33U, 65U, 1024U}) {
    CountedBounds bounds{8, 1, fewest, {}};
    (void)fine_march(bounds.bounds(), kAround, kEightErrors);
    EXPECT_EQ(bounds.asked.back(), 1024U) << fewest;
  }
  CountedBounds infinite{std::numeric_limits<double>::infinity(), 0, 1, {}};
  (void)fine_march(infinite.bounds(), kAround, kEightErrors);
  EXPECT_EQ(infinite.asked.back(), 1024U);
  CountedBounds none{8, 1, 2000, {}};
  EXPECT_THROW((void)fine_march(none.bounds(), kAround, kEightErrors), Error);
}

TEST(CoarseMarch, has_few_cells_if_they_tell_anything) {
  CountedBounds smooth{8, 1, 1, {}}, rough{8, 1, 129, {}}, none{8, 1, 2000, {}};
  (void)coarse_march(smooth.bounds(), kAround);
  EXPECT_EQ(smooth.asked, (std::vector<std::uint32_t>{128}));
  (void)coarse_march(rough.bounds(), kAround);
  EXPECT_EQ(rough.asked, (std::vector<std::uint32_t>{128, 1024}));
  EXPECT_THROW((void)coarse_march(none.bounds(), kAround), Error);
}

TEST(CellByCell, bounds_equal_parts) {
  const auto cells = cell_by_cell([](double from, double to) {
    return ringed::BandBounds{{from, to, 0}, 0};
  })(4);
  ASSERT_EQ(cells.size(), 4U);
  EXPECT_EQ(cells[3].second.along, 0.75);
  EXPECT_EQ(cells[3].second.mixed, 1);
}

TEST(BandStepper, knows_how_much_the_tangent_turns) {
  const BandStepper march({{{}, 1}, {{}, 3}}, kAround);
  EXPECT_EQ(march.squared_turning(), 5);
}

TEST(BandBudget, is_what_the_tolerance_or_the_segments_ask_for) {
  constexpr double kRadius = 2, kBend = kRadius * kAround * kAround;
  EXPECT_EQ(band_budget(10, kRadius, kAround).enough, 80);
  EXPECT_EQ(band_budget(1e-6, kRadius, kAround).enough, 4 * kBend);
  // With the largest twist every march arrives within the one, and none moves within the other.
  const BandBudget budget = band_budget(1e-6, kRadius, kAround);
  const BandStepper march({{{50, 10, kRadius}, 3}}, kAround);
  EXPECT_EQ(march.knots(budget.enough, kAround / 2, kNoLimit).back(), 1);
  EXPECT_LT(march.knots(budget.too_little, kAround / 2, 10).back(), 1e-15);
}

TEST(EvenKnots, are_as_few_as_the_march_needs_and_share_the_error) {
  const BandBudget budget{0.35, 0.1};
  for (const double twist : {0., 0.02}) {
    const BandStepper march(cells(0.5), kAround);
    const auto greedy = march.knots(budget.enough, twist, kNoLimit);
    const auto even = even_knots(march, budget, twist);
    EXPECT_EQ(even.size(), greedy.size());
    EXPECT_EQ(even.back(), 1);
    EXPECT_LT(march.error_bound(even, twist), march.error_bound(greedy, twist));
  }
  // Where all is the same everywhere, so are the bands.
  const auto equal = even_knots(BandStepper({{{8, 0, 1}, 0}}, kAround), budget, 0);
  ASSERT_GT(equal.size(), 3U);
  for (std::size_t i = 1; i < equal.size(); ++i) {
    EXPECT_NEAR(equal[i] - equal[i - 1], 1 / double(equal.size() - 1), 2e-3);
  }
}

}  // namespace
}  // namespace dupin::tessellation
