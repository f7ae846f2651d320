#include "dupin/blends/nurbs.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_chain.h"
#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/ringed_blend.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"
#include "support/paper_surfaces.h"

namespace dupin {
namespace {

constexpr double kPi = std::numbers::pi;

// How far a point is from the part's surface, by what the surface is.
using Distance = std::function<double(const Vec3&)>;

struct Row {
  const char* name;
  PartSurface surface;
  int degree_along;
  Distance distance;
};

double off_cone(const Vec3& x, const Vec3& apex, const Vec3& axis, double half_angle) {
  const Vec3 d = x - apex;
  const double along = d.dot(axis), aside = (d - along * axis).norm();
  return aside * std::cos(half_angle) - along * std::sin(half_angle);
}

std::vector<Row> exact_surfaces() {
  const Ring start{Vec3(0, 0, 0), -Vec3::UnitZ(), 1}, end{Vec3(0, 0, 4), Vec3::UnitZ(), 3};
  const Ring out{Vec3(3, 0, 3), Vec3::UnitX(), 1};
  const Vec3 flat_axis(.6, .8, 0);
  const Ellipse flat{flat_axis, .5};
  const ArcSpine quarter{Vec3(3, 0, 0), Vec3::UnitY(), Vec3(0, 0, 0), kPi / 2};
  const ArcSpine long_arc{Vec3(3, 0, 0), Vec3::UnitY(), Vec3(0, 0, 0), 5};
  const auto off_torus = [](const Vec3& x) {
    const Vec3 d = x - Vec3(3, 0, 0);
    return std::hypot(std::hypot(d.x(), d.z()) - 3, d.y()) - 1;
  };
  const auto off_oval = [=](const Vec3& x) {
    return std::hypot(x.dot(flat_axis), x.dot(Vec3::UnitZ().cross(flat_axis)) / .5) - 1;
  };
  const auto off_reducer = [](const Vec3& x) {
    const double t = x.x() / 6;  // k = l = 6 is the straight spine of constant speed
    return std::hypot(x.y(), x.z()) - (1 + 8 * t * t * (3 - 2 * t));
  };
  const auto r1 = test::straight_reducer(6, CubicRadius{1, 9});
  return {
      {"cylinder",
       RingedSurface{start, end, LineSpine{start.center, end.center}, ConstantRadius{1}}, 1,
       [](const Vec3& x) { return std::hypot(x.x(), x.y()) - 1; }},
      {"cone", RingedSurface{start, end, LineSpine{start.center, end.center}, LinearRadius{1, 3}},
       1, [](const Vec3& x) { return off_cone(x, Vec3(0, 0, -2), Vec3::UnitZ(), std::atan(.5)); }},
      {"elbow", RingedSurface{start, out, quarter, ConstantRadius{1}}, 2, off_torus},
      {"long elbow", RingedSurface{start, out, long_arc, ConstantRadius{1}}, 2, off_torus},
      {"straight blend", r1, 3, off_reducer},
      {"elliptic cylinder",
       elliptic_tube(
           {Vec3(0, 0, 0), -Vec3::UnitZ(), 1, 0, flat}, {Vec3(0, 0, 4), Vec3::UnitZ(), 1, 0, flat},
           LineSpine{Vec3(0, 0, 0), Vec3(0, 0, 4)}, ConstantRadius{1}, ConstantRadius{.5}),
       1, off_oval},
      {"sphere", Sphere{Vec3(1, 2, 3), 2}, 2,
       [](const Vec3& x) { return (x - Vec3(1, 2, 3)).norm() - 2; }},
      {"oblique cylinder", oblique_tube(Vec3(0, 0, 0), Vec3(2, 0, 4), Vec3::UnitZ(), 1, 1), 9,
       [](const Vec3& x) { return std::hypot(x.x() - x.z() / 2, x.y()) - 1; }},
  };
}

TEST(Nurbs, of_rational_surfaces_is_exact) {
  for (const Row& row : exact_surfaces()) {
    SCOPED_TRACE(row.name);
    const NurbsForm form = nurbs(row.surface, .01);
    EXPECT_EQ(form.error_bound, 0);
    ASSERT_EQ(form.surfaces.size(), 1U);
    const NurbsSurface& surface = form.surfaces.front();
    EXPECT_EQ(surface.degree_along, row.degree_along);
    EXPECT_EQ(surface.knots_along.size(), surface.net.size() + surface.degree_along + 1);
    EXPECT_EQ(surface.knots_around.size(), surface.net[0].size() + surface.degree_around + 1);
    for (int i = 0; i <= 40; ++i) {
      for (int j = 0; j <= 40; ++j) {
        EXPECT_NEAR(row.distance(evaluate(surface, i / 40., j / 40.)), 0, 1e-13);
      }
    }
    for (const auto& points : surface.net) {
      for (const auto& point : points) {
        EXPECT_GT(point[3], 0);
      }
    }
  }
}

// Mathematics C9: the pieces' patches and the sphere at their joint, all of which the kneecap
// needs.
TEST(Nurbs, of_a_chain_with_kneecaps_are_its_pieces_and_spheres) {
  const Chain chain = kneecap_chain(test::lune_spheres());
  const std::vector<PeArc> pieces = cyclide_pieces(chain);
  const NurbsForm form = nurbs(chain, .01);
  EXPECT_EQ(form.error_bound, 0);
  std::size_t patch_count = 0;
  for (const PeArc& piece : pieces) {
    patch_count += patches(piece).size();
  }
  ASSERT_EQ(form.surfaces.size(), patch_count + 1);
  for (std::size_t k = 0; k < form.surfaces.size(); ++k) {
    for (int i = 0; i <= 8; ++i) {
      for (int j = 0; j <= 8; ++j) {
        const Vec3 point = evaluate(form.surfaces[k], i / 8., j / 8.);
        const double off = k == patch_count ? (point - Vec3(4, 1, 0)).norm() - 1
                                            : std::min(std::abs(signed_distance(pieces[0], point)),
                                                       std::abs(signed_distance(pieces[1], point)));
        EXPECT_NEAR(off, 0, 1e-12);
      }
    }
  }
}

// The parameters of both forms differ, so points are compared with the ring of equal t.
TEST(Nurbs, of_a_ringed_blend_has_its_rings) {
  const auto surface =
      ringed_blend(along_oblique_cone({Vec3(0, 0, 0), Vec3::UnitZ(), 1}, Vec3(.6, 0, -3), 3.6),
                   along_canal({Vec3(4, 1, 3.5), Vec3::UnitX(), .8}, 0, 3.5));
  const RationalRingedTube tube{
      {Vec3(0, 0, 0), -Vec3::UnitZ(), 1}, {Vec3(4, 1, 3.5), Vec3::UnitX(), .8}, surface};
  const NurbsForm form = nurbs(tube, .01);
  ASSERT_EQ(form.surfaces.size(), 1U);
  EXPECT_EQ(form.surfaces[0].degree_along, 9);
  for (const double t : {0., .1, .35, .5, .8, 1.}) {
    const MovingRing ring = ring_at(surface, t);
    for (int j = 0; j <= 32; ++j) {
      const Vec3 d = evaluate(form.surfaces[0], t, j / 32.) - ring.center;
      EXPECT_NEAR(d.dot(ring.normal), 0, 1e-13);
      EXPECT_NEAR(d.norm(), ring.radius, 1e-13);
    }
  }
}

// Certified: points of the loft are no further from the circle of some parameter than stated.
TEST(Nurbs, of_other_blends_keeps_the_bound_it_states) {
  // Turns back, so that intervals of its velocity over half of it contain zero (examples/u-bend).
  const RingedSurface u_bend{
      Ring{Vec3(0, 0, 0), -Vec3::UnitX(), 2}, Ring{Vec3(0, 15.1327459504216, 0), -Vec3::UnitX(), 4},
      HermiteSpine{Vec3(0, 0, 0), Vec3(0, 15.1327459504216, 0), Vec3(30, 0, 0), Vec3(-30, 0, 0)},
      CubicRadius{2, 4}};
  for (const RingedSurface& surface :
       {test::figure6(CubicRadius{1, 2}), test::figure6(CyclideRadius{1, 2}), u_bend}) {
    const RadiusLaw& law = surface.radius;
    for (const double tolerance : {1e-2, 1e-4}) {
      const NurbsForm form = nurbs(surface, tolerance);
      EXPECT_GT(form.error_bound, 0);
      EXPECT_LE(form.error_bound, tolerance);
      double measured = 0;
      for (int i = 0; i <= 300; ++i) {
        const double t = i / 300.;
        const SpinePoint y = evaluate(surface.spine, t);
        for (int j = 0; j < 16; ++j) {
          const Vec3 d = evaluate(form.surfaces[0], t, j / 16.) - y.position;
          const double along = d.dot(y.first.normalized());
          const double aside = std::sqrt(std::max(0., d.squaredNorm() - along * along));
          measured = std::max(measured, std::hypot(along, aside - evaluate(law, t).value));
        }
      }
      EXPECT_LE(measured, form.error_bound);
      EXPECT_GE(measured, form.error_bound / 50);
    }
  }
}

TEST(Nurbs, of_an_elliptic_blend_keeps_the_bound_it_states) {
  const Ring from{Vec3(0, 0, 0), Vec3::UnitX(), 1.2, 0, Ellipse{Vec3(0, .6, .8), .7}};
  const Ring to{Vec3(14, 6, 3), -test::skew_axis(), 1.1};
  const EllipticTube tube = elliptic_blend(from, to);
  const NurbsForm form = nurbs(tube, 1e-2);
  EXPECT_LE(form.error_bound, 1e-2);
  const FrameField field = frames(tube);
  for (const double t : {0., .2, .5, .7, 1.}) {
    // Corner j / 8 of the row lies at the ellipse's parameter 2 pi j / 8.
    for (int j = 0; j < 8; j += 2) {
      const Vec3 there = evaluate(tube, field, t, 2 * kPi * j / 8).position;
      EXPECT_LE((evaluate(form.surfaces[0], t, j / 8.) - there).norm(), form.error_bound);
    }
  }
}

TEST(Nurbs, ends_in_the_exact_circles_tangent_to_the_pipes) {
  const RingedSurface surface = test::figure6();
  const NurbsForm form = nurbs(surface, 1e-3);
  const auto& net = form.surfaces[0].net;
  for (std::size_t j = 0; j < net[0].size(); ++j) {
    const auto at = [&](std::size_t i) {
      return Vec3(Vec3(net[i][j][0], net[i][j][1], net[i][j][2]) / net[i][j][3]);
    };
    EXPECT_NEAR((at(1) - at(0)).cross(Vec3::UnitX()).norm(), 0, 1e-14);
    EXPECT_NEAR((at(net.size() - 1) - at(net.size() - 2)).cross(test::skew_axis()).norm(), 0,
                1e-14);
  }
}

TEST(Nurbs, refuses_tolerances_beyond_reach) {
  EXPECT_THROW((void)nurbs(test::figure6(), 1e-17), Error);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double none : {0., -1., kInfinity, std::nan("")}) {
    for (const PartSurface& surface :
         {exact_surfaces().front().surface, PartSurface(test::figure6())}) {
      EXPECT_THROW((void)nurbs(surface, none), Error) << none;
    }
  }
}

}  // namespace
}  // namespace dupin
