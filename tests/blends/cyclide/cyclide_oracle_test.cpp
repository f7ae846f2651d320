// The tables C1 to C8 of the mathematics, computed with 40 digits, to 1e-12 relative.
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_chain.h"
#include "dupin/blends/cyclide_form.h"
#include "support/cyclide_cases.h"

namespace dupin {
namespace {

using test::direction;
using test::sphere;

void expect_close(double found, double expected) {
  EXPECT_NEAR(found, expected, 1e-12 * std::max(1.0, std::abs(expected)));
}

void expect_close(const Vec3& found, const Vec3& expected) {
  EXPECT_LT((found - expected).norm(), 1e-12 * std::max(1.0, expected.norm()))
      << found.transpose() << " is not " << expected.transpose();
}

void expect_close(const PeVector& found, const PeVector& expected) {
  expect_close(found.m, expected.m);
  expect_close(found.r, expected.r);
}

struct Ends {
  PeVector b0, t0, b3, t3;
};

struct Pair {
  double beta = 0;
  PeArc first, second;
};

// The junction at the tangent length alpha (mathematics B9).
Pair at_alpha(const Ends& e, double alpha) {
  const PeVector v = e.b3 - e.b0;
  const double vv = squared_tangential_distance(e.b3, e.b0);
  const double beta = (vv - 2 * alpha * product(v, e.t0)) /
                      (2 * product(v, e.t3) - 2 * alpha * (product(e.t0, e.t3) - 1));
  const PeVector q1 = e.b0 + alpha * e.t0, q2 = e.b3 - beta * e.t3;
  const PeVector j = (1 / (alpha + beta)) * (beta * q1 + alpha * q2);
  const PeArc first = PeArc::from(e.b0, e.t0, j);
  return {beta, first, PeArc::from(j, first.end_tangent(), e.b3)};
}

double equal_alpha(const Ends& e) {
  const PeVector v = e.b3 - e.b0;
  const double vv = squared_tangential_distance(e.b3, e.b0);
  const double s = product(v, e.t0 + e.t3), c = product(e.t0, e.t3);
  return vv / (s + std::sqrt(s * s + 2 * vv * (1 - c)));
}

struct PieceRow {
  double w, least_power, area, volume;
};

void expect_piece(const PeArc& piece, const PieceRow& row) {
  expect_close(piece.w(), row.w);
  expect_close(piece.least_power(), row.least_power);
  expect_close(area(piece), row.area);
  expect_close(volume(piece), row.volume);
}

struct PairRow {
  double alpha, beta;
  PeVector junction, tangent;
  PieceRow first, second;
};

void expect_pair(const Ends& ends, const PairRow& row) {
  SCOPED_TRACE(row.alpha);
  const Pair pair = at_alpha(ends, row.alpha);
  expect_close(pair.beta, row.beta);
  expect_close(pair.first.end(), row.junction);
  if (product(row.tangent, row.tangent) > 0) {
    expect_close(pair.first.end_tangent(), row.tangent);
  }
  expect_close(pair.second.end_tangent(), ends.t3);
  expect_piece(pair.first, row.first);
  expect_piece(pair.second, row.second);
  // The locus goes through it; a minimum is flat and has half the digits.
  const DoubleCyclide near =
      double_cyclide_near(ends.b0, ends.t0, ends.b3, ends.t3, pair.first.end());
  EXPECT_LT((near.first.end().m - pair.first.end().m).norm(), 1e-7);
}

constexpr double kNone = 0;

TEST(CyclideOracle, perpendicular_cylinders_take_the_double_blends_of_c5) {
  const Ends ends{sphere(0, 0, 0, 1), direction(Vec3::UnitZ(), 0), sphere(3, 0, 3, .6),
                  direction(Vec3::UnitX(), 0)};
  expect_close(equal_alpha(ends), 1.23320209770334);
  const PairRow rows[] = {
      {equal_alpha(ends),
       equal_alpha(ends),
       sphere(0.883398951148328, 0, 2.11660104885167, 0.8),
       sphere(0.716345644232625, 0, 0.716345644232625, -0.162179419231017),
       {0.926376177433505, 3.85359580459331, 14.5456632731456, 6.75560976421659},
       {0.926376177433505, 3.61982324569743, 9.33902576383028, 3.10970010521439}},
      {1,
       37.0 / 25,
       sphere(19.0 / 31, 0, 56.0 / 31, 26.0 / 31),
       sphere(19.0 / 31, 0, 25.0 / 31, -5.0 / 31),
       {0.950381926622983, 2.70967741935484, 12.3362737850813, 5.80316103963902},
       {0.898026510133875, 4.87529411764706, 11.274070089789, 3.84156893676351}},
      {2,
       0.584,
       sphere(1.86996904024768, 0, 2.77399380804954, 0.690402476780186),
       sphere(0.934984520123839, 0, 0.386996904024768, -0.154798761609907),
       {0.832765544443563, 7.97523219814241, 20.5044364199237, 9.18488139482212},
       {0.983611844205792, 0.901127596439169, 4.17399171664209, 1.30617688766361}},
  };
  for (const PairRow& row : rows) {
    expect_pair(ends, row);
  }
}

TEST(CyclideOracle, equal_tangents_between_perpendicular_cylinders_have_a_closed_form) {
  struct Row {
    double r0, r1, h, alpha;
    PeVector junction;
  };
  for (const Row& row :
       {Row{1, .8, 2, 0.8248893783651, sphere(0.5875553108174, 0, 1.412444689183, .9)},
        Row{1.5, .5, 4, 1.612486080161, sphere(1.19375695992, 0, 2.80624304008, 1)}}) {
    const Ends ends{sphere(0, 0, 0, row.r0), direction(Vec3::UnitZ(), 0),
                    sphere(row.h, 0, row.h, row.r1), direction(Vec3::UnitX(), 0)};
    const double v2 = 2 * row.h * row.h - (row.r0 - row.r1) * (row.r0 - row.r1);
    const double alpha = v2 / (2 * row.h + std::sqrt(4 * row.h * row.h + 2 * v2));
    expect_close(equal_alpha(ends), alpha);
    EXPECT_NEAR(alpha, row.alpha, 1e-12);
    EXPECT_LT((at_alpha(ends, alpha).first.end().m - row.junction.m).norm(), 1e-11);
  }
}

TEST(CyclideOracle, skew_pipes_take_the_double_blends_of_c6) {
  const Ends ends{sphere(0, 0, 0, 1), direction(Vec3::UnitZ(), 0), sphere(4, 3, 5, .7),
                  direction(Vec3(.6, .8, 0), 0)};
  const PairRow rows[] = {
      {equal_alpha(ends),
       equal_alpha(ends),
       sphere(1.37075013397642, 0.661000178635233, 3.54874977670596, 0.85),
       sphere(0.653516293601436, 0.315137220201077, 0.691895367001795, -0.0715137220201077),
       {0.919754142964791, 12.1434008780479, 24.0268624097215, 11.4073337789926},
       {0.906702694470939, 11.5788739638138, 18.2667822485436, 6.87238716838805}},
      {2,
       2.19926470588235,
       sphere(1.27662405883383, 0.590859744353003, 3.42882157240413, 0.857117842759587),
       sphere(kNone, kNone, kNone, kNone),
       {0.925853872434, 11.1875942066458, 23.0916851575679, 10.9898645524919},
       {0.899814179536906, 12.5415659034869, 19.1281565238507, 7.22303227031466}},
      {4,
       0.563068181818182,
       sphere(3.21026024156394, 2.23493960901507, 4.87660316274437, 0.73701905117669),
       sphere(kNone, kNone, kNone, kNone),
       {0.780753094994215, 31.715558742114, 38.7601022857912, 17.6853875597597},
       {0.981969184352952, 0.860821957902146, 4.76702650340175, 1.69585799103207}},
  };
  for (const PairRow& row : rows) {
    expect_pair(ends, row);
  }
  const Pair equal = at_alpha(ends, equal_alpha(ends));
  expect_close(equal_alpha(ends), 2.09749955341192);
  expect_close(point_at(equal.first, 0.5, 1).position,
               Vec3(0.442774656055078, 1.11439290350639, 1.76117059180666));
  expect_close(point_at(equal.second, 0.5, 1).position,
               Vec3(2.25484644424969, 2.16890252567344, 4.58906499357294));
  const CanonicalCyclide first = canonical_form(equal.first);
  const CanonicalCyclide second = canonical_form(equal.second);
  const std::array<double, 4> of_first{4.939233201327, 4.915180976833, 0.4868475963517,
                                       0.5131524036483};
  const std::array<double, 4> of_second{4.5287766982, 4.509109091513, 0.4216083288974,
                                        1.121608328897};
  const auto expect_form = [](const CanonicalCyclide& f, const std::array<double, 4>& e) {
    EXPECT_NEAR(f.a, e[0], 1e-11);
    EXPECT_NEAR(f.b, e[1], 1e-11);
    EXPECT_NEAR(f.c, e[2], 1e-11);
    EXPECT_NEAR(f.mu, e[3], 1e-11);
  };
  expect_form(first, of_first);
  expect_form(second, of_second);
}

TEST(CyclideOracle, skew_cones_take_the_double_blend_of_c6) {
  const Ends ends{sphere(0, 0, 0, 1), direction(Vec3::UnitZ(), .15), sphere(4, 3, 5, .7),
                  direction(Vec3(.6, .8, 0), -.1)};
  expect_pair(ends, {equal_alpha(ends),
                     equal_alpha(ends),
                     sphere(1.3705025704375, 0.660670093916673, 3.55584927236557, 1.11329362911525),
                     sphere(kNone, kNone, kNone, kNone),
                     {0.925853040186326, 12.7777168583354, 30.3367250338765, 17.2332571912264},
                     {0.905670464777703, 10.9192997673338, 22.1963244599443, 10.146325585712}});
  expect_close(equal_alpha(ends), 2.08780678035197);
}

TEST(CyclideOracle, triple_edit_of_the_hook_is_c8) {
  const CyclideChain hook = test::crane_hook();
  const PeArc first =
      PeArc::from(hook.pieces[1].start(), hook.pieces[1].start_tangent(), sphere(1.1, 2.5, .2, .8));
  expect_close(first.chord(), 2.02672149048654);
  expect_piece(first, {0.836089373485377, 2.57661523067349, 9.1380485999681, 3.1765286494173});
  const Ends ends{first.end(), first.end_tangent(), hook.pieces[3].end(),
                  hook.pieces[3].end_tangent()};
  expect_pair(ends,
              {equal_alpha(ends),
               equal_alpha(ends),
               sphere(2.01514732646366, 0.440305227530606, 0.226741014002463, 1.0076359797342),
               sphere(kNone, kNone, kNone, kNone),
               {0.730543999936237, 2.56124382498013, 14.7808621508514, 6.81303968385137},
               {0.80948407617243, 3.2530308393589, 17.3850004111589, 8.98061192309989}});
  expect_close(equal_alpha(ends), 1.53613205089575);
}

TEST(CyclideOracle, the_rest_of_the_hook_is_c1_and_c2) {
  const CyclideChain hook = test::crane_hook(), twisted = test::twisted_crane_hook();
  double area_sum = 0, volume_sum = 0;
  for (std::size_t i = 0; i < hook.pieces.size(); ++i) {
    area_sum += area(hook.pieces[i]);
    volume_sum += volume(hook.pieces[i]);
    expect_close(twisted.pieces[i].w(), hook.pieces[i].w());
    expect_close(twisted.pieces[i].least_power(), hook.pieces[i].least_power());
    expect_close(area(twisted.pieces[i]), area(hook.pieces[i]));
    expect_close(volume(twisted.pieces[i]), volume(hook.pieces[i]));
  }
  expect_close(area_sum, 78.4296614300376);
  expect_close(volume_sum, 32.431540285655);
  const CanonicalCyclide two = canonical_form(hook.pieces[2]),
                         three = canonical_form(hook.pieces[3]);
  EXPECT_NEAR(two.a, 1.7847726259, 1e-10);
  EXPECT_NEAR(two.b, 1.774533029652, 2e-12);
  EXPECT_NEAR(two.c, 0.1909079695477, 2e-12);
  EXPECT_NEAR(two.mu, 0.7773573695864, 2e-12);
  EXPECT_LT((two.origin - Vec3(0.217104415053, 1.00750228889, 0)).norm(), 1e-11);
  EXPECT_NEAR(three.a, 1.999171427091, 2e-12);
  EXPECT_NEAR(three.c, 0.09207967965207, 2e-12);
  EXPECT_NEAR(three.mu, 0.9582793251867, 2e-12);
  EXPECT_LT((three.origin - Vec3(0.002933261775323, 0.9991527719653, 0)).norm(), 2e-12);
  expect_close(twisted.pieces[4].end_tangent(),
               sphere(0.29289752776737, 0.960491411393919, 0.13668518816585, -0.164364089136445));
  const CanonicalCyclide turned = canonical_form(twisted.pieces[3]);
  EXPECT_LT((turned.origin - Vec3(0.1900428722438, 0.9991965667618, -0.8439969341759)).norm(),
            2e-12);
  // The handedness of x and y is a convention.
  const Vec3 z(0.4226182501644, 9.891784938299e-5, -0.9063077870366);
  EXPECT_LT(turned.z.cross(z).norm(), 2e-12);
}

TEST(CyclideOracle, the_rest_of_the_jet_engine_is_c3) {
  struct Row {
    double chord, least_power, inner_least_power;
    PeVector tangent;
    double a, mu, origin;
  };
  const Row rows[] = {
      {2.37434201411675, 6.3775, 6.3183, sphere(1.00012416750489, 0, 0, -0.0157591379001654),
       7.26734087566, 8.618243243243, 2.285472972973},
      {2.58795285892151, 7.2618845867807, 7.22843957423073,
       sphere(1.01573128085583, 0, 0, -0.178073116749904), 16.01833691975, 17.37032587668,
       2.14756481955},
      {2.55530820058951, 6.58279714553713, 6.57892826222534,
       sphere(1.01934229451832, 0, 0, -0.197632774088401), 132.9266640517, 136.1177707371,
       -18.67066536685},
  };
  const CyclideChain outer = test::jet_engine(), inner = offset(outer, -0.08);
  for (std::size_t i = 0; i < outer.pieces.size(); ++i) {
    SCOPED_TRACE(i);
    const PeArc& piece = outer.pieces[i];
    expect_close(piece.chord(), rows[i].chord);
    expect_close(piece.least_power(), rows[i].least_power);
    expect_close(inner.pieces[i].least_power(), rows[i].inner_least_power);
    expect_close(piece.end_tangent(), rows[i].tangent);
    const CanonicalCyclide form = canonical_form(piece);
    EXPECT_EQ(form.kind, CyclideKind::torus);
    // A curvature of nearly zero loses as many digits as the torus is larger than the piece.
    EXPECT_NEAR(form.a, rows[i].a, 1e-12 * rows[i].a * rows[i].a);
    EXPECT_NEAR(form.mu, rows[i].mu, 1e-12 * rows[i].a * rows[i].a);
    EXPECT_NEAR(form.origin.x(), rows[i].origin, 1e-12 * rows[i].a * rows[i].a);
  }
}

// The rows of the control net of a quarter, as far as the patches' splitting leaves it whole.
TEST(CyclideOracle, the_reducer_s_net_is_that_of_c4) {
  const PeArc reducer = PeArc::from(sphere(0, 0, 0, 1), direction(Vec3::UnitZ(), 0),
                                    sphere(3.06186217847897, 0, 3, 0.387627564304205));
  struct Point {
    Vec3 place;
    double weight;
  };
  const double root = std::sqrt(0.5);
  const Point net[3][3] = {{{{1, 0, 0}, 1}, {{1, 1, 0}, root}, {{0, 1, 0}, 1}},
                           {{{1, 0, 2.183503419072}, root},
                            {{1, 1, 2.183503419072}, 0.5},
                            {{0, 1, 3.204124145232}, root}},
                           {{{3.13938769134, 0, 2.620204102887}, 0.8333333333333},
                            {{3.13938769134, .465153077165, 2.620204102887}, 0.5892556509888},
                            {{3.13938769134, .372122461732, 3.075959179423}, 1.041666666667}}};
  // The point of that net at parameters in [0, 1] lies on the same lines of curvature.
  const auto of_net = [&](double t, double s) {
    const double bt[] = {(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
    const double bs[] = {(1 - s) * (1 - s), 2 * s * (1 - s), s * s};
    Vec3 sum = Vec3::Zero();
    double weight = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const double w = bt[i] * bs[j] * net[i][j].weight;
        sum += w * net[i][j].place;
        weight += w;
      }
    }
    return Vec3(sum / weight);
  };
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    for (const double s : {0.0, 0.3, 0.5, 1.0}) {
      const double c = (1 - s) * (1 - s) + 2 * s * (1 - s) * root;
      const double d = s * s + 2 * s * (1 - s) * root;
      EXPECT_LT((of_net(t, s) - point_at(reducer, t, std::atan2(d, c)).position).norm(), 1e-11);
    }
  }
}

Vec3 unit_normal(const BiquadraticPatch& patch, double t, double s) {
  const double bt[] = {(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
  const double bs[] = {(1 - s) * (1 - s), 2 * s * (1 - s), s * s};
  const double dt[] = {-2 * (1 - t), 2 - 4 * t, 2 * t}, ds[] = {-2 * (1 - s), 2 - 4 * s, 2 * s};
  std::array<Vec3, 3> x{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  std::array<double, 3> w{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double basis[] = {bt[i] * bs[j], dt[i] * bs[j], bt[i] * ds[j]};
      for (std::size_t k = 0; k < 3; ++k) {
        x.at(k) += basis[k] * patch.points.at(i).at(j);
        w.at(k) += basis[k] * patch.weights.at(i).at(j);
      }
    }
  }
  const Vec3 along = x[1] * w[0] - x[0] * w[1], around = x[2] * w[0] - x[0] * w[2];
  return along.cross(around).normalized();
}

// At the common circle the normals of the patches on both sides are those of the common sphere.
TEST(CyclideOracle, patches_of_chains_meet_g1_to_1e_12) {
  for (const CyclideChain& chain :
       {test::crane_hook(), test::twisted_crane_hook(), test::jet_engine()}) {
    for (std::size_t i = 0; i < chain.pieces.size(); ++i) {
      const PeArc& piece = chain.pieces[i];
      const Ring start = circle_at(piece, 0), end = circle_at(piece, 1);
      int at_start = 0, at_end = 0;
      for (const BiquadraticPatch& patch : patches(piece)) {
        for (const double s : {0.0, 0.25, 0.5, 0.75, 1.0}) {
          const auto residual = [&](double t, const PeVector& ball) {
            const Vec3 radial = (evaluate(patch, t, s) - ball.m).normalized();
            return unit_normal(patch, t, s).cross(radial).norm();
          };
          const Vec3 first = evaluate(patch, 0, s), last = evaluate(patch, 1, s);
          if (std::abs((first - start.center).dot(start.normal)) < 1e-12) {
            EXPECT_LT(residual(0, piece.start()), 1e-12) << i;
            ++at_start;
          }
          if (std::abs((last - end.center).dot(end.normal)) < 1e-12) {
            EXPECT_LT(residual(1, piece.end()), 1e-12) << i;
            ++at_end;
          }
        }
      }
      EXPECT_GE(at_start, 20);
      EXPECT_GE(at_end, 20);
    }
  }
}

}  // namespace
}  // namespace dupin
