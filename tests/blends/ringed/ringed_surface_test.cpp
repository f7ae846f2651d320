#include "dupin/blends/ringed_surface.h"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/paper_surfaces.h"

namespace dupin {
namespace {

constexpr double kPi = std::numbers::pi;

struct PointRow {
  double k, l, t;
  Vec3 y, velocity;
  double curvature, radius;
  Vec3 paper_first, first, second, at_sixty_degrees, normal, paper_at_sixty_degrees;
};

class RingedSurfacePoints : public testing::TestWithParam<PointRow> {};

TEST_P(RingedSurfacePoints, agree_with_the_table) {
  const PointRow row = GetParam();
  const RingedSurface surface =
      test::ringed(test::skew_spine(row.k, row.l), 1, 2, CubicRadius{1, 2});
  // The table has 12 digits; 1024 knots leave the frame an error of 2e-13.
  const FrameField frames(surface.spine, Vec3::UnitY(), {1024});
  const SpinePoint y = evaluate(surface.spine, row.t);
  EXPECT_LT((y.position - row.y).norm(), 1e-11);
  EXPECT_LT((y.first - row.velocity).norm(), 1e-10);
  EXPECT_NEAR(curvature(y), row.curvature, 1e-12);
  EXPECT_EQ(evaluate(surface.radius, row.t).value, row.radius);
  EXPECT_LT((frames.at(row.t).first - row.first).norm(), 2e-12);
  EXPECT_LT((frames.at(row.t).second - row.second).norm(), 2e-12);
  const SurfacePoint x = evaluate(surface, frames, row.t, kPi / 3);
  EXPECT_LT((x.position - row.at_sixty_degrees).norm(), 1e-11);
  EXPECT_LT((x.normal - row.normal).norm(), 2e-12);
}

TEST_P(RingedSurfacePoints, in_the_papers_frame_are_the_same_circle) {
  const PointRow row = GetParam();
  const RingedSurface surface =
      test::ringed(test::skew_spine(row.k, row.l), 1, 2, CubicRadius{1, 2});
  const FrameField frames(surface.spine, Vec3::UnitY(), {1024});
  const Frame frame = frames.at(row.t);
  const double turn =
      std::atan2(row.paper_first.dot(frame.second), row.paper_first.dot(frame.first));
  const SurfacePoint x = evaluate(surface, frames, row.t, kPi / 3 + turn);
  // At the ends of Fig. 5 and 6 the table's horizontal direction has 10 digits.
  EXPECT_LT((x.position - row.paper_at_sixty_degrees).norm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    Figures5And6, RingedSurfacePoints,
    testing::Values(
        PointRow{10, 20, 0, Vec3(0, 0, 0), Vec3(10, 0, 0), 0.422612857915, 1, Vec3(0, 1, 0),
                 Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 0.5, 0.866025403784),
                 Vec3(0, 0.5, 0.866025403784), Vec3(0, 0.5, 0.866025403784)},
        PointRow{10, 20, 0.25, Vec3(2.87725936816, 0.442018736322, -0.914906318389),
                 Vec3(12.5150624544, 3.28012490881, -6.09937545593), 0.0518810254224, 1.15625,
                 Vec3(-0.253530846601, 0.967327302324, 0),
                 Vec3(-0.226257639917, 0.972301058801, 0.0586355816385),
                 Vec3(0.428062155246, 0.0451781068598, 0.902619371555),
                 Vec3(3.17509073043, 1.04936901609, 0.0228229494784),
                 Vec3(0.188809488209, 0.505866207043, 0.841694931513),
                 Vec3(3.14373501528, 1.10951234977, -0.00917066821309)},
        PointRow{10, 20, 0.5, Vec3(6.00602498176, 1.51204996353, -2.43975018237),
                 Vec3(12.0120499635, 5.02409992705, -4.87950036474), 0.0906854967763, 1.5,
                 Vec3(-0.385863592758, 0.922555845347, 0),
                 Vec3(-0.343045301148, 0.932209694145, 0.115347334181),
                 Vec3(0.368813219815, 0.0207362909749, 0.929272196467),
                 Vec3(6.22784343232, 2.23814446628, -1.14607968798),
                 Vec3(0.0397047611164, 0.43556536748, 0.899281014254),
                 Vec3(6.13718785458, 2.37986840658, -1.22332614007)},
        PointRow{10, 20, 0.75, Vec3(8.63177810448, 2.82605620897, -2.74471895517),
                 Vec3(8.49096252736, 5.23192505471, 3.65962527356), 0.468063732055, 1.84375,
                 Vec3(-0.524585860784, 0.851357548076, 0),
                 Vec3(-0.55854365065, 0.820270040464, 0.123231696559),
                 Vec3(-0.221876452072, -0.29089914209, 0.930671010157),
                 Vec3(7.76259292667, 3.11775400338, -1.14508037539),
                 Vec3(-0.835115713033, -0.140954415285, 0.531708189384),
                 Vec3(7.67989428901, 3.32235792174, -1.24571399379)},
        PointRow{10, 20, 1, Vec3(10, 4, 0), Vec3(1.9518001459, 3.90360029179, 19.518001459),
                 0.114625684814, 2, Vec3(-0.894427191, 0.4472135955, 0),
                 Vec3(-0.696619182951, 0.713709348851, -0.0730799514752),
                 Vec3(-0.710772751603, -0.672698838461, 0.205617042853),
                 Vec3(8.07228629864, 3.54856078244, 0.283059213648),
                 Vec3(-0.963856850681, -0.225719608778, 0.141529606824),
                 Vec3(8.34964386298, 2.93535570346, 0.377964473009)},
        PointRow{18, 25, 0, Vec3(0, 0, 0), Vec3(18, 0, 0), 0.15688482732, 1, Vec3(0, 1, 0),
                 Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 0.5, 0.866025403784),
                 Vec3(0, 0.5, 0.866025403784), Vec3(0, 0.5, 0.866025403784)},
        PointRow{18, 25, 0.25, Vec3(3.9793867102, 0.396273420403, -1.14363289799),
                 Vec3(13.862578068, 2.97515613602, -7.62421931991), 0.0829439090233, 1.15625,
                 Vec3(-0.209839524181, 0.97773584065, 0),
                 Vec3(-0.18199969037, 0.981909503714, 0.0522478633119),
                 Vec3(0.474695882457, 0.0412043809325, 0.879184860066),
                 Vec3(4.34950100331, 1.00519952422, -0.233062487407),
                 Vec3(0.261845804393, 0.513113277413, 0.81740537022),
                 Vec3(4.32175771546, 1.06104190061, -0.261715087204)},
        PointRow{18, 25, 0.5, Vec3(6.9450312272, 1.39006245441, -3.04968772796),
                 Vec3(9.89006245441, 4.78012490881, -6.09937545593), 0.121310742711, 1.5,
                 Vec3(-0.435163351318, 0.900351518947, 0),
                 Vec3(-0.348123076108, 0.923780916466, 0.159496527404),
                 Vec3(0.509127089803, 0.0434482122321, 0.859594008403),
                 Vec3(7.34531441041, 2.13933902507, -1.81341996008),
                 Vec3(0.151404860402, 0.439899806566, 0.885191916157),
                 Vec3(7.18643337405, 2.33974638257, -1.91398290712)},
        PointRow{18, 25, 0.75, Vec3(8.9381601306, 2.68882026121, -3.43089869396),
                 Vec3(6.08245315919, 5.41490631839, 4.57453159195), 0.681092365858, 1.84375,
                 Vec3(-0.664931715826, 0.746904152679, 0),
                 Vec3(-0.727130706617, 0.661407544115, 0.183904856058),
                 Vec3(-0.217313373385, -0.475874360126, 0.85224321125),
                 Vec3(7.920844785, 2.53871040944, -1.90055540486),
                 Vec3(0.20558214361, -0.184235471111, -0.961141651066),
                 Vec3(7.74109004199, 2.85738959044, -2.03877023484)},
        PointRow{18, 25, 1, Vec3(10, 4, 0), Vec3(2.43975018237, 4.87950036474, 24.3975018237),
                 0.0531293623419, 2, Vec3(-0.894427191, 0.4472135955, 0),
                 Vec3(-0.83984071817, 0.542281000078, -0.0244721281986),
                 Vec3(-0.533988537873, -0.817212382958, 0.216841330379),
                 Vec3(8.23526400357, 3.12682763222, 0.351108073198),
                 Vec3(-0.882367998213, -0.43658618389, 0.175554036599),
                 Vec3(8.34964386298, 2.93535570346, 0.377964473009)}));

TEST(RingedSurface, has_the_derivatives_and_normal_of_its_points) {
  const RingedSurface surface = test::figure6(CyclideRadius{1, 2});
  const FrameField frames(surface.spine, Vec3::UnitY());
  const double h = 1e-5;  // central differences: errors below 1e-7 here
  for (const double t : {.1, .45, .8}) {
    for (const double u : {.3, 2., 4.4}) {
      const SurfacePoint x = evaluate(surface, frames, t, u);
      const Vec3 along = (evaluate(surface, frames, t + h, u).position -
                          evaluate(surface, frames, t - h, u).position) /
                         (2 * h);
      EXPECT_LT((along - x.along).norm(), 1e-6);
      EXPECT_LT((x.around.cross(x.along).normalized() - x.normal).norm(), 1e-13);
    }
  }
}

struct StraightRow {
  double speed, cubic_area, cubic_volume, cyclide_area, cyclide_volume;
};

class StraightReducer : public testing::TestWithParam<StraightRow> {};

TEST_P(StraightReducer, has_the_tabulated_area_and_volume) {
  const StraightRow row = GetParam();
  const RingedSurface cubic = test::straight_reducer(row.speed, CubicRadius{1, 9});
  const RingedSurface cyclide = test::straight_reducer(row.speed, CyclideRadius{1, 9});
  EXPECT_NEAR(area(cubic), row.cubic_area, 1e-12 * row.cubic_area);
  EXPECT_NEAR(volume(cubic), row.cubic_volume, 1e-14 * row.cubic_volume);
  EXPECT_NEAR(area(cyclide), row.cyclide_area, 1e-12 * row.cyclide_area);
  EXPECT_NEAR(volume(cyclide), row.cyclide_volume, 1e-14 * row.cyclide_volume);
}

INSTANTIATE_TEST_SUITE_P(Figures3And4, StraightReducer,
                         testing::Values(StraightRow{6, 324.030557961554366, 617.726875485855916,
                                                     307.321781014995479, 471.238898038468986},
                                         StraightRow{3, 317.605679125401168, 594.748369219599143,
                                                     298.972927633211933, 425.402274428003129},
                                         StraightRow{12, 342.817294697966123, 663.683888018369463,
                                                     328.891213327177429, 562.912145259400699},
                                         StraightRow{18, 369.304495456925461, 709.640900550883010,
                                                     355.970367218407498, 654.585392480332413},
                                         StraightRow{1, 314.777716863226721, 579.429365042094627,
                                                     294.797145847843196, 394.844525354359225}));

TEST(RingedSurface, of_constant_speed_has_the_closed_form_volumes) {
  EXPECT_NEAR(volume(test::straight_reducer(6, CubicRadius{1, 9})), 6 * kPi * (13 + 81 + 1053) / 35,
              1e-11);
  EXPECT_NEAR(volume(test::straight_reducer(6, CyclideRadius{1, 9})), 6 * kPi * 25, 1e-11);
}

TEST(RingedSurface, of_figures_5_and_6_has_the_tabulated_measures) {
  EXPECT_NEAR(length(test::figure5().spine), 14.332371345198, 1e-12);
  EXPECT_NEAR(length(test::figure6().spine), 13.1814243060667, 1e-12);
  EXPECT_NEAR(area(test::figure5()), 134.4027778397, 1e-10);
  EXPECT_NEAR(area(test::figure6()), 125.151534905, 1e-9);
  EXPECT_NEAR(area(test::figure5(CyclideRadius{1, 2})), 130.9159898691, 1e-10);
  EXPECT_NEAR(area(test::figure6(CyclideRadius{1, 2})), 121.6387667612, 1e-10);
  EXPECT_NEAR(volume(test::figure5()), 104.197352224197, 1e-12);
  EXPECT_NEAR(volume(test::figure6()), 98.7626771261853, 1e-12);
  EXPECT_NEAR(volume(test::figure5(CyclideRadius{1, 2})), 99.3595656202836, 1e-12);
  EXPECT_NEAR(volume(test::figure6(CyclideRadius{1, 2})), 93.712319095944, 1e-12);
}

TEST(RingedSurface, of_the_u_bend_has_the_tabulated_measures) {
  const RingedSurface bend = test::u_bend(CubicRadius{2, 4});
  EXPECT_NEAR(length(bend.spine), 23.89296790349, 1e-11);
  EXPECT_NEAR(volume(bend), 713.7864803597, 1e-9);
  EXPECT_NEAR(volume(test::u_bend(CyclideRadius{2, 4})), 679.0461621655, 1e-9);
  EXPECT_NEAR(evaluate(bend.spine, .5).position.x(), 7.5, 1e-14);
}

TEST(RingedSurface, of_lines_and_arcs_is_a_cylinder_a_cone_and_a_torus) {
  const Ring start{Vec3(0, 0, 0), -Vec3::UnitX(), 2}, end{Vec3(5, 0, 0), Vec3::UnitX(), 2};
  const LineSpine line{start.center, end.center};
  EXPECT_NEAR(area({start, end, line, ConstantRadius{2}}), 20 * kPi, 1e-12);
  EXPECT_NEAR(volume({start, end, line, ConstantRadius{2}}), 20 * kPi, 1e-12);
  EXPECT_NEAR(volume({start, end, line, LinearRadius{2, 1}}), 5 * kPi * 7 / 3, 1e-12);
  EXPECT_NEAR(area({start, end, line, LinearRadius{2, 1}}), kPi * 3 * std::sqrt(26), 1e-12);
  const ArcSpine arc{Vec3(0, 0, 0), Vec3::UnitZ(), Vec3(3, 0, 0), kPi / 2};
  EXPECT_NEAR(area({start, end, arc, ConstantRadius{1}}), 3 * kPi * kPi, 1e-12);
  EXPECT_NEAR(volume({start, end, arc, ConstantRadius{1}}), 1.5 * kPi * kPi, 1e-12);
}

TEST(RingedSurface, measures_the_same_from_both_ends) {
  const HermiteSpine there = test::skew_spine(10, 20);
  const HermiteSpine back{there.to, there.from, -there.end_velocity, -there.start_velocity};
  const RingedSurface reversed = test::ringed(back, 2, 1, CyclideRadius{2, 1});
  const RingedSurface surface = test::figure6(CyclideRadius{1, 2});
  EXPECT_NEAR(area(reversed), area(surface), 1e-11);
  EXPECT_NEAR(volume(reversed), volume(surface), 1e-12);
}

TEST(RingedSurface, measures_the_same_after_a_turn_of_space) {
  std::mt19937_64 random(20065);
  std::normal_distribution<double> gauss;
  const HermiteSpine spine = test::skew_spine(10, 20);
  for (int i = 0; i < 5; ++i) {
    const Eigen::Matrix3d turn =
        Eigen::Quaterniond(gauss(random), gauss(random), gauss(random), gauss(random))
            .normalized()
            .toRotationMatrix();
    const Vec3 shift(gauss(random), gauss(random), gauss(random));
    const RingedSurface moved =
        test::ringed({turn * spine.from + shift, turn * spine.to + shift,
                      turn * spine.start_velocity, turn * spine.end_velocity},
                     1, 2, CubicRadius{1, 2});
    EXPECT_NEAR(area(moved), area(test::figure6()), 1e-11);
    EXPECT_NEAR(volume(moved), volume(test::figure6()), 1e-12);
  }
}

}  // namespace
}  // namespace dupin
