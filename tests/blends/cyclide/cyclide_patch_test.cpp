#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_form.h"
#include "support/cyclide_cases.h"

namespace dupin {
namespace {

using test::RandomArcs;

TEST(PeArc, patches_of_random_pieces_have_positive_weights) {
  RandomArcs arcs;
  std::size_t count = 0;
  for (int i = 0; i < 120; ++i) {
    for (const BiquadraticPatch& patch : patches(arcs.next())) {
      ++count;
      for (const auto& row : patch.weights) {
        EXPECT_GT(*std::min_element(row.begin(), row.end()), 0);
      }
    }
  }
  EXPECT_GT(count, 1000U);
}

TEST(CyclidePatch, lies_on_the_surface_of_random_pieces) {
  RandomArcs arcs;
  for (int i = 0; i < 30; ++i) {
    const PeArc arc = arcs.next();
    for (const BiquadraticPatch& patch : patches(arc)) {
      for (const auto& [t, s] : {std::pair(0., .5), {.3, .7}, {1., 1.}}) {
        EXPECT_NEAR(signed_distance(arc, evaluate(patch, t, s)), 0, 1e-9);
      }
    }
  }
}

// Rows go round: the last column ends where the first begins, and all rows but the last end where
// the next begins.
TEST(CyclidePatch, covers_the_piece_without_gaps) {
  const PeArc arc = PeArc::from(test::sphere(0, 0, 0, 1), test::direction(Vec3::UnitZ(), 0),
                                test::sphere(3, 0, -3, 1));
  const std::vector<BiquadraticPatch> all = patches(arc);
  EXPECT_GE(all.size(), 8u);
  std::size_t open_sides = 0;
  for (const BiquadraticPatch& patch : all) {
    for (const bool along : {true, false}) {
      const auto side = [&](const BiquadraticPatch& p, double edge, double at) {
        return along ? evaluate(p, at, edge) : evaluate(p, edge, at);
      };
      const bool is_met = std::any_of(all.begin(), all.end(), [&](const BiquadraticPatch& other) {
        return (side(patch, 1, .4) - side(other, 0, .4)).norm() < 1e-12;
      });
      open_sides += is_met ? 0 : 1;
      EXPECT_TRUE(is_met || !along);
    }
  }
  EXPECT_GE(open_sides, 4u);  // the end circle's
  EXPECT_LT(open_sides, all.size());
}

TEST(CyclidePatch, boundaries_are_arcs_of_at_most_a_right_angle) {
  RandomArcs arcs;
  for (int i = 0; i < 30; ++i) {
    for (const BiquadraticPatch& patch : patches(arcs.next())) {
      for (const std::size_t i0 : {std::size_t(0), std::size_t(2)}) {
        // cos(half the angle)^2 = w1^2 / (w0 w2)
        const auto& row = patch.weights[i0];
        EXPECT_GE(row[1] * row[1] / (row[0] * row[2]), .5 - 1e-5);
        const double w0 = patch.weights[0][i0], w1 = patch.weights[1][i0],
                     w2 = patch.weights[2][i0];
        EXPECT_GE(w1 * w1 / (w0 * w2), .5 - 1e-5);
      }
    }
  }
}

}  // namespace
}  // namespace dupin
