#include "dupin/blends/part_surface.h"

#include <gtest/gtest.h>

#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/spline_pipe.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"
#include "support/message_of.h"

namespace dupin {
namespace {

RationalRingedTube oblique(const Vec3& from, const Vec3& to) {
  return oblique_tube(from, to, Vec3::UnitZ(), 1, 1);
}

TEST(PartSurface, ends_in_the_rings_of_its_first_and_last_piece) {
  const RationalRingedTube first = oblique(Vec3(0, 0, 0), Vec3(1, 0, 3));
  const RationalRingedTube second = oblique(Vec3(1, 0, 3), Vec3(0, 1, 6));
  const PartSurface surface = Chain(std::vector{first, second});
  EXPECT_EQ(*port_ring(surface, End::start), first.start);
  EXPECT_EQ(*port_ring(surface, End::end), second.end);
  EXPECT_EQ(leaving(surface, End::end).center, second.end.center);
  EXPECT_LT(
      (leaving(surface, End::end).center_rate.normalized() - Vec3(-1, 1, 3).normalized()).norm(),
      1e-13);
}

TEST(PartSurface, that_is_closed_has_no_ports) {
  const Chain round(
      closed_spline_pipe({{Vec3(5, 0, 0), 1}, {Vec3(-3, 4, 0), 1}, {Vec3(-3, -4, 0), 1}}), true);
  for (const PartSurface& surface :
       {PartSurface(Sphere{}), PartSurface(round), PartSurface(Chain()),
        PartSurface(cyclide_tube(test::jet_engine(), 0.08))}) {
    EXPECT_EQ(port_ring(surface, End::start), nullptr);
    EXPECT_EQ(port_ring(surface, End::end), nullptr);
  }
}

TEST(PartSurface, has_the_very_arcs_that_its_cyclide_pieces_were_made_of) {
  for (const CyclideChain& chain :
       {test::crane_hook(), test::twisted_crane_hook(), test::jet_engine()}) {
    EXPECT_EQ(cyclide_pieces(cyclide_tube(chain)), chain.pieces);
  }
  EXPECT_TRUE(cyclide_pieces(PartSurface(Sphere{})).empty());
  EXPECT_TRUE(cyclide_pieces(Chain(oblique(Vec3(0, 0, 0), Vec3(0, 0, 3)))).empty());
}

TEST(PartSurface, of_pieces_of_several_kinds_is_meshed_as_one_tube) {
  const RationalRingedTube lower = oblique(Vec3(0, 0, 0), Vec3(0, 0, 3));
  const Ring joint = lower.end;
  const Ring top{Vec3(0, 0, 5), Vec3::UnitZ(), 1};
  Chain chain = lower;
  chain.pieces.emplace_back(
      RingedSurface{flipped(joint), top, LineSpine{joint.center, top.center}, ConstantRadius{1}});
  const RingSampling sampling{segments_for(chain, 0.01), 0.2, std::ldexp(1.0, -30)};
  const Tessellation result = tessellate(chain, sampling, {0.01});
  EXPECT_EQ(result.mesh.points.size(), (result.bands + 1) * sampling.segments);
  EXPECT_EQ(result.knots.front(), 0);
  EXPECT_EQ(result.knots.back(), 2);
  EXPECT_LE(result.error_bound, 0.01);
}

TEST(PartSurface, has_a_wall_of_cyclides_only) {
  Chain tube = oblique(Vec3(0, 0, 0), Vec3(0, 0, 3));
  tube.wall = 0.1;
  EXPECT_THROW((void)tessellate(tube, {16}), Error);
}

TEST(PieceError, says_which_piece_is_at_fault_as_a_number_and_in_words) {
  try {
    (void)cyclide_tube(test::crane_hook(), 0.4);
    FAIL();
  } catch (const PieceError& error) {
    EXPECT_EQ(error.piece(), 5U);
    EXPECT_EQ(error.part(), "piece 5");
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
  }
}

TEST(PartSurface, of_no_pieces_has_no_ends) {
  for (const End end : {End::start, End::end}) {
    EXPECT_EQ(test::message_of([&] { (void)end_ring(Chain(), end); }, Errc::invalid_argument),
              "a chain needs at least one piece");
    EXPECT_EQ(test::message_of([&] { (void)leaving(Chain(), end); }, Errc::invalid_argument),
              "a chain needs at least one piece");
  }
}

}  // namespace
}  // namespace dupin
