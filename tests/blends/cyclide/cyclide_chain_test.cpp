#include "dupin/blends/cyclide_chain.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_form.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"

namespace dupin {
namespace {

using test::crane_hook;
using test::crane_hook_spheres;
using test::jet_engine;
using test::sphere;

double distance(const PeVector& a, const PeVector& b) {
  return std::hypot((a.m - b.m).norm(), a.r - b.r);
}

struct PieceOracle {
  double chord, w, power, tx, ty, tau, area, volume;
};

const std::array<PieceOracle, 6> kHook{
    {{3.79935520845314, 1.00016971078288, 14.3581, 0, -1.00067890073501, 0.0368546113293292,
      13.6064833508378, 3.90374548074486},
     {1.88, 0.848505054980495, 2.16991120741577, 0.902664952106909, -0.443585022636041,
      0.107571781007776, 8.33702848793369, 2.86218262627577},
     {1.87912213546645, 0.848328991216713, 1.99018331023195, 0.000234306228030153,
      -1.00105379069986, 0.0459210929091634, 11.1636849862705, 4.87132459860074},
     {2.82665880502051, 0.706504391724156, 4.1773875571967, -1.00000745248723, 0.00128064444066433,
      0.00406756440379647, 20.2237310288034, 10.2277733326389},
     {3.27070328828526, 0.58253596727086, 5.99392021046129, 0.323199903616044, 0.960498503955229,
      -0.164364089136445, 22.038621514859, 9.89236381750592},
     {0.942072184070839, 0.924187230147962, 0.639378897638901, -0.519402964437648, 1.00153210426081,
      -0.52234662373917, 3.06011206133322, 0.674150429888877}}};

TEST(CyclideChain, crane_hook_has_the_oracle_values) {
  const CyclideChain chain = crane_hook();
  ASSERT_EQ(chain.pieces.size(), kHook.size());
  for (std::size_t i = 0; i < kHook.size(); ++i) {
    SCOPED_TRACE(i);
    const PeArc& piece = chain.pieces[i];
    const PieceOracle& o = kHook[i];
    EXPECT_NEAR(piece.chord(), o.chord, 1e-12 * o.chord);
    EXPECT_NEAR(piece.w(), o.w, 1e-12);
    EXPECT_NEAR(piece.least_power(), o.power, 1e-12 * 15);
    EXPECT_LT(distance(piece.end_tangent(), sphere(o.tx, o.ty, 0, o.tau)), 1e-12);
    EXPECT_NEAR(area(piece), o.area, 1e-12 * o.area);
    EXPECT_NEAR(volume(piece), o.volume, 1e-12 * o.volume);
  }
  EXPECT_TRUE(bias_warnings(chain, crane_hook_spheres()).empty());
}

TEST(CyclideChain, crane_hook_has_the_canonical_parameters) {
  struct Row {
    std::size_t piece;
    double a, b, c, mu;
    Vec3 origin;
  };
  const CyclideChain chain = crane_hook();
  EXPECT_EQ(canonical_form(chain.pieces[0]).kind, CyclideKind::torus);
  EXPECT_NEAR(canonical_form(chain.pieces[0]).a, 103.1078571429, 1e-8);
  EXPECT_NEAR(canonical_form(chain.pieces[0]).mu, -102.5578571429, 1e-8);
  for (const Row& row : {Row{1, 1.786676654481, 1.776308775729, 0.1921993780864, 0.8007067030166,
                             Vec3(1.785464501319, 4.193344643022, 0)},
                         Row{4, 2.041610047863, 2.01198540134, 0.3465347490938, 0.7035619010063,
                             Vec3(0.004023679767023, 1.041589680039, 0)},
                         Row{5, 1.436987957519, 1.233273327962, 0.7375440926424, -0.1091414725567,
                             Vec3(-3.207237695191, 2.261225745876, 0)}}) {
    const CanonicalCyclide f = canonical_form(chain.pieces[row.piece]);
    SCOPED_TRACE(row.piece);
    EXPECT_EQ(f.kind, CyclideKind::elliptic);
    EXPECT_NEAR(f.a, row.a, 2e-12);
    EXPECT_NEAR(f.b, row.b, 2e-12);
    EXPECT_NEAR(f.c, row.c, 2e-12);
    EXPECT_NEAR(f.mu, row.mu, 2e-12);
    EXPECT_LT((f.origin - row.origin).norm(), 2e-12);
  }
}

TEST(CyclideChain, crane_hook_has_the_oracle_points_and_end_circle) {
  const CyclideChain chain = crane_hook();
  const Ring end = circle_at(chain.pieces[5], 1);
  EXPECT_LT((end.center - Vec3(-2.05328774765941, 2.80275141595011, 0)).norm(), 1e-13);
  EXPECT_NEAR(end.radius, 0.221590980117953, 1e-13);
  EXPECT_LT(distance(sphere_at(chain.pieces[1], 0.5),
                     sphere(0.27048884646154, 3.25835358036969, 0, 0.682019486687733)),
            1e-13);
  const std::array<std::pair<std::size_t, Vec3>, 3> points{
      {{0, Vec3(0.477452505587372, 6.11077631578947, -0.306568728296996)},
       {1, Vec3(0.5651908143264, 3.510744258954, 0.560892392284054)},
       {4, Vec3(-1.34336421856451, 0.210688142491639, -0.787752741981483)}}};
  for (const auto& [i, point] : points) {
    EXPECT_LT((point_at(chain.pieces[i], 0.5, 1).position - point).norm(), 1e-12);
  }
}

TEST(CyclideChain, patches_of_neighbours_meet_g1) {
  const CyclideChain chain = crane_hook();
  for (std::size_t i = 0; i + 1 < chain.pieces.size(); ++i) {
    EXPECT_EQ(chain.pieces[i].end(), chain.pieces[i + 1].start());
    EXPECT_EQ(chain.pieces[i].end_tangent(), chain.pieces[i + 1].start_tangent());
    const Ring a = circle_at(chain.pieces[i], 1), b = circle_at(chain.pieces[i + 1], 0);
    EXPECT_EQ(a, b);
    for (int k = 0; k < 12; ++k) {
      const ArcPoint p = point_at(chain.pieces[i + 1], 0, k);
      // The same point lies on the first piece; its normal there is the direction from the common
      // sphere's centre.
      EXPECT_NEAR(signed_distance(chain.pieces[i], p.position), 0, 1e-12);
      EXPECT_LT((p.normal - (p.position - chain.pieces[i].end().m).normalized()).norm(), 1e-12);
    }
  }
}

TEST(CyclideChain, twisting_keeps_lengths_and_gives_the_oracle_tangents) {
  const EditedChain edited = twist(crane_hook(), 3, 25 * std::numbers::pi / 180);
  EXPECT_EQ(edited.changed, (std::vector<std::size_t>{3, 4, 5}));
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(edited.chain.pieces[i].w(), kHook[i].w, 1e-12);
    EXPECT_NEAR(area(edited.chain.pieces[i]), kHook[i].area, 1e-11);
    if (i < 3) {
      EXPECT_EQ(edited.chain.pieces[i], crane_hook().pieces[i]);
    }
  }
  EXPECT_LT(distance(edited.chain.pieces[3].end_tangent(),
                     sphere(-0.906314574500686, 0.00130257415616839, -0.422621273042882,
                            0.00406756440379647)),
            1e-12);
  EXPECT_LT(
      distance(edited.chain.pieces[5].end_tangent(),
               sphere(-0.470760917102782, 1.0015434893979, -0.219410102558981, -0.52234662373917)),
      1e-12);
  EXPECT_LT((circle_at(edited.chain.pieces[5], 1).center -
             Vec3(-1.67356580315168, 2.80284029350828, -1.71281505103544))
                .norm(),
            1e-12);
}

TEST(CyclideChain, jet_engine_shells_have_the_oracle_values) {
  const CyclideChain outer = jet_engine(), inner = offset(outer, -0.08);
  const std::array<std::array<double, 5>, 3> rows{
      {{1.01325490850641, 21.2511354613151, 12.9772102573263, 19.6987056951226, 11.2693195997618},
       {1.0032574751457, 21.9529354898306, 13.7425481826281, 20.4651009368108, 12.0047001606367},
       {1.00004619153011, 13.7273406270989, 5.88194914238694, 12.4496293834597, 4.86708802406844}}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(outer.pieces[i].w(), rows[i][0], 1e-12);
    EXPECT_NEAR(area(outer.pieces[i]), rows[i][1], 1e-12 * rows[i][1]);
    EXPECT_NEAR(volume(outer.pieces[i]), rows[i][2], 1e-12 * rows[i][2]);
    EXPECT_NEAR(area(inner.pieces[i]), rows[i][3], 1e-11 * rows[i][3]);
    EXPECT_NEAR(volume(inner.pieces[i]), rows[i][4], 1e-11 * rows[i][4]);
  }
  EXPECT_NEAR(circle_at(inner.pieces[2], 1).center.x(), 7.70469662505093, 1e-12);
  EXPECT_NEAR(circle_at(inner.pieces[2], 1).radius, 0.529753354593386, 1e-12);
  EXPECT_NEAR(circle_at(outer.pieces[2], 1).center.x(), 7.72020723616958, 1e-12);
}

TEST(DoubleCyclide, skew_pipes_have_the_oracle_junctions) {
  const PeVector b0 = sphere(0, 0, 0, 1), t0{Vec3(0, 0, 1), 0};
  const PeVector b3 = sphere(4, 3, 5, .7), t3{Vec3(.6, .8, 0), 0};
  const DoubleCyclide half = double_cyclide(b0, t0, b3, t3, 0.5);
  EXPECT_LT(distance(half.first.end(),
                     sphere(1.353901073649, 0.6483413358766, 3.527798688864, 0.8512608448442)),
            1e-11);
  const DoubleCyclide quarter = double_cyclide(b0, t0, b3, t3, 0.25);
  EXPECT_LT(distance(quarter.first.end(),
                     sphere(0.4092685914229, 0.04325699849913, 1.830057964619, 0.9354012841345)),
            1e-11);
  EXPECT_LT(distance(half.second.end_tangent(), t3), 1e-12);
  const DoubleCyclide best = double_cyclide(b0, t0, b3, t3);
  EXPECT_LT(distance(best.second.end_tangent(), t3), 1e-12);
}

TEST(DoubleCyclide, every_junction_of_the_locus_ends_in_the_given_tangent) {
  test::RandomArcs random;
  int joined = 0;
  for (int i = 0; i < 400; ++i) {
    const PeVector b0{random.vector(), random.radius(random.random)};
    const PeVector b3{random.vector(), random.radius(random.random)};
    const PeVector t0 = test::direction(random.vector(), random.sine(random.random));
    const PeVector t3 = test::direction(random.vector(), random.sine(random.random));
    for (const double tau : {0.2, 0.5, 0.8}) {
      try {
        const DoubleCyclide pair = double_cyclide(b0, t0, b3, t3, tau);
        ++joined;
        // The tangents divide by the chords and, for the first, by how far it is from a whole turn.
        const double slack = 1e-10 / std::min(pair.first.chord(), pair.second.chord()) /
                             (1 + std::min(pair.first.w(), pair.second.w()));
        EXPECT_LT(distance(pair.second.end_tangent(), t3), slack);
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::infeasible_blend);
      }
    }
  }
  EXPECT_GT(joined, 300);
}

TEST(DoubleCyclide, the_equal_junction_of_the_oracle_is_on_the_locus) {
  const PeVector b0 = sphere(0, 0, 0, 1), t0{Vec3(0, 0, 1), 0};
  const PeVector b3 = sphere(4, 3, 5, .7), t3{Vec3(.6, .8, 0), 0};
  const PeVector equal = sphere(1.37075013397642, 0.661000178635233, 3.54874977670596, 0.85);
  const DoubleCyclide found = double_cyclide_near(b0, t0, b3, t3, equal);
  EXPECT_LT(distance(found.first.end(), equal), 1e-7);  // a minimum is flat: half the digits
  EXPECT_NEAR(found.first.w(), 0.919754142964791, 1e-6);
  EXPECT_NEAR(found.second.w(), 0.906702694470939, 1e-6);
}

TEST(CyclideChain, moving_a_junction_changes_three_pieces_as_the_oracle_says) {
  const CyclideChain chain = crane_hook();
  const EditedChain edited = move_junction(chain, 2, sphere(1.1, 2.5, .2, .8));
  EXPECT_EQ(edited.changed, (std::vector<std::size_t>{1, 2, 3}));
  for (const std::size_t i : {std::size_t{0}, std::size_t{4}, std::size_t{5}}) {
    EXPECT_EQ(edited.chain.pieces[i], chain.pieces[i]);
  }
  EXPECT_NEAR(edited.chain.pieces[1].chord(), 2.02672149048654, 1e-12);
  EXPECT_NEAR(edited.chain.pieces[1].w(), 0.836089373485377, 1e-12);
  EXPECT_NEAR(edited.chain.pieces[1].least_power(), 2.57661523067349, 1e-12);
  EXPECT_LT(
      distance(edited.chain.pieces[1].end_tangent(),
               sphere(0.907572466321584, -0.40193309267107, 0.165013175694833, 0.111657246796021)),
      1e-12);
  EXPECT_LT(distance(edited.chain.pieces[3].end_tangent(), chain.pieces[3].end_tangent()), 1e-12);
}

TEST(CyclideChain, moving_on_the_locus_changes_two_pieces) {
  const CyclideChain chain = crane_hook();
  const EditedChain edited = move_on_locus(chain, 3, sphere(2.1, .9, .1, .97));
  EXPECT_EQ(edited.changed, (std::vector<std::size_t>{2, 3}));
  for (const std::size_t i : {0, 1, 4, 5}) {
    EXPECT_EQ(edited.chain.pieces[i], chain.pieces[i]);
  }
  EXPECT_LT(distance(edited.chain.pieces[3].end_tangent(), chain.pieces[3].end_tangent()), 1e-12);
}

TEST(CyclideChain, a_bad_piece_is_named) {
  auto spheres = crane_hook_spheres();
  spheres[4] = sphere(0, 4.2, 0, 3);
  try {
    (void)compose(spheres, {Vec3(0, -1, 0), 0});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
    EXPECT_EQ(error.part(), "piece 1");
  }
  EXPECT_THROW((void)compose(std::span(spheres).first(2), {Vec3(0, -1, 0), 0}), Error);
}

TEST(CyclideChain, three_spheres_in_the_wrong_order_are_refused) {
  // The middle sphere does not lie between the others: V2 fails.
  try {
    (void)through_three(sphere(0, 0, 0, 1), sphere(9, 0, 0, 1), sphere(4, 0, 0, 1));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
    EXPECT_NE(error.message().find("w = -1"), std::string::npos) << error.message();
  }
}

}  // namespace
}  // namespace dupin
