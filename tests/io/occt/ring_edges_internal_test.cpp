#include <numbers>

#include <BRep_Tool.hxx>
#include <gtest/gtest.h>

#include "occt/ring_edges.h"

namespace dupin::occt {
namespace {

TEST(RingEdges, are_as_many_as_there_are_seams) {
  const exchange::RingCurve circle{{1, 2, 3}, {0, 0, 1}, {1, 0, 0}, 2, 2};
  RingEdges one(circle), two(circle), none(circle);
  one.add_seam(0.5);
  one.add_seam(0.5 + 2 * std::numbers::pi);  // the same
  two.add_seam(-1);
  two.add_seam(1);
  for (RingEdges* ring : {&one, &two, &none}) {
    ring->make();
  }
  EXPECT_EQ(one.arcs().size(), 1U);
  EXPECT_EQ(two.arcs().size(), 2U);
  EXPECT_EQ(none.arcs().size(), 1U);
  EXPECT_NE(two.arc_at(1), two.arc_at(-1));
  EXPECT_TRUE(two.vertex_at(1).IsSame(two.vertex_at(1 + 4 * std::numbers::pi)));
}

TEST(RingEdges, of_ellipses_have_their_vertices_at_our_angles) {
  for (const auto& [first, second] : std::vector<std::pair<double, double>>{{3, 1}, {1, 3}}) {
    RingEdges ring({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, first, second});
    ring.add_seam(0.3);
    ring.make();
    const gp_Pnt at = BRep_Tool::Pnt(ring.vertex_at(0.3));
    EXPECT_NEAR(at.X(), first * std::cos(0.3), 1e-12);
    EXPECT_NEAR(at.Y(), second * std::sin(0.3), 1e-12);
  }
}

}  // namespace
}  // namespace dupin::occt
