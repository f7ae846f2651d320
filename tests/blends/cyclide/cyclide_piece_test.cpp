#include "dupin/blends/cyclide_piece.h"

#include <array>
#include <cmath>
#include <tuple>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"

namespace dupin {
namespace {

TEST(CyclidePiece, gives_back_the_very_arc_it_was_made_of) {
  test::RandomArcs arcs;
  for (int i = 0; i < 200; ++i) {
    const PeArc arc = arcs.next();
    EXPECT_EQ(arc_of(cyclide_piece(arc)), arc);
  }
}

TEST(CyclidePiece, ends_in_the_circles_where_its_end_spheres_touch_it) {
  test::RandomArcs arcs;
  for (int i = 0; i < 50; ++i) {
    const PeArc arc = arcs.next();
    const CyclidePiece piece = cyclide_piece(arc);
    // Seen in travel direction, their cones are the tangents.
    for (const auto& [ring, sphere, tangent] :
         {std::tuple(flipped(piece.start), arc.start(), arc.start_tangent()),
          {piece.end, arc.end(), arc.end_tangent()}}) {
      EXPECT_LT((contact_sphere(ring).m - sphere.m).norm(), 1e-12);
      EXPECT_NEAR(contact_sphere(ring).r, sphere.r, 1e-12);
      EXPECT_LT((contact_tangent(ring).m - tangent.m).norm(), 1e-12);
      EXPECT_NEAR(contact_tangent(ring).r, tangent.r, 1e-12);
    }
  }
}

// A homogeneous quadratic with the header's points and weights.
TEST(CyclidePiece, is_the_curve_of_spheres_that_its_numbers_define) {
  test::RandomArcs arcs;
  for (int i = 0; i < 50; ++i) {
    const PeArc arc = arcs.next();
    const CyclidePiece piece = cyclide_piece(arc);
    const PeVector d = piece.last - piece.first;
    const double squared = product(d, d), e = product(d, piece.tangent), chord = piece.chord;
    const PeVector middle = (1 / chord) * (e * piece.first + (squared / 2) * piece.tangent);
    for (const double t : {0., 0.2, 0.5, 0.9, 1.}) {
      const std::array basis{(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
      const double last = squared / (chord * chord),
                   weight = basis[0] + basis[1] * e / chord + basis[2] * last;
      const PeVector sphere = (1 / weight) * (basis[0] * piece.first + basis[1] * middle +
                                              (basis[2] * last) * piece.last);
      const PeVector expected = sphere_at(arc, t);
      EXPECT_LT((sphere.m - expected.m).norm(), 1e-12 / weight);
      EXPECT_NEAR(sphere.r, expected.r, 1e-12 / weight);
    }
  }
}

TEST(CyclidePiece, refuses_numbers_that_are_no_arcs) {
  test::RandomArcs arcs;
  const CyclidePiece good = cyclide_piece(arcs.next());
  CyclidePiece nested = good, backwards = good;
  nested.last.r += 20;
  backwards.tangent.m = -good.tangent.m;
  backwards.last = good.first + 5 * good.tangent;  // ahead, where the arc leaves to behind
  for (const CyclidePiece& piece : {nested, backwards}) {
    try {
      (void)arc_of(piece);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::infeasible_blend);
    }
  }
}

}  // namespace
}  // namespace dupin
