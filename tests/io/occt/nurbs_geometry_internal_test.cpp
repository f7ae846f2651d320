#include <numbers>

#include <gtest/gtest.h>

#include "dupin/blends/nurbs.h"
#include "occt/nurbs_geometry.h"

namespace dupin::occt {
namespace {

// Quarters of circles about the z axis, as surfaces of revolution have them.
NurbsSurface cone() {
  NurbsSurface result{1, 2, {0, 0, 1, 1}, {0, 0, 0, .25, .25, .5, .5, .75, .75, 1, 1, 1}, {}};
  constexpr int kCos[] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, kSin[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
  for (const double z : {0., 5.}) {
    auto& row = result.net.emplace_back();
    for (std::size_t i = 0; i < 9; ++i) {
      const double w = i % 2 == 0 ? 1 : std::sqrt(0.5), r = 2 + z / 5;
      row.push_back({w * r * kCos[i], w * r * kSin[i], w * z, w});
    }
  }
  return result;
}

TEST(NurbsGeometry, is_the_same_surface) {
  const auto surface = bspline_surface(cone());
  for (const double u : {0., 0.1, 0.25, 0.6, 1.}) {
    for (const double v : {0., 0.3, 1.}) {
      const gp_Pnt at = surface->Value(u, v);
      EXPECT_NEAR(std::hypot(at.X(), at.Y()), 2 + v, 1e-12);
      EXPECT_NEAR(at.Z(), 5 * v, 1e-12);
    }
  }
}

TEST(NurbsGeometry, borders_follow_the_angle) {
  const auto surface = bspline_surface(cone());
  for (const double sense : {1., -1.}) {
    const exchange::RingCurve ring{{0, 0, 5}, {0, 0, sense}, {1, 0, 0}, 3, 3};
    const double seam = 2 * std::numbers::pi;
    const auto border = boundary_by_angle(surface, 1, ring, seam);
    for (int i = 0; i <= 100; ++i) {
      const double angle = seam + 2 * std::numbers::pi * i / 100;
      const gp_Pnt2d uv = border->Value(angle);
      const gp_Pnt at = surface->Value(uv.X(), uv.Y());
      EXPECT_NEAR(at.X(), 3 * std::cos(angle), 1e-9);
      EXPECT_NEAR(at.Y(), sense * 3 * std::sin(angle), 1e-9);
    }
  }
}

}  // namespace
}  // namespace dupin::occt
