#include <cmath>

#include <gtest/gtest.h>

#include "remeshing/size_field.h"
#include "support/shapes.h"
#include "workshop_internal.h"

namespace dupin::remeshing {
namespace {

using test::Bench;

TEST(SizeField, follows_curvature_whatever_the_triangles) {
  const double radius = 10, distance = 0.02;
  const Bench bench(dupin::test::tube(radius, 0, 60, 256), {0.01, 50, distance});
  const double wanted = std::sqrt(8 * 0.6 * distance * radius);
  for (const double angle : {0.3, 1.7, 4.0}) {
    const Vec3 place(radius * std::cos(angle), radius * std::sin(angle), 30);
    std::uint32_t region = 0;
    for (std::uint32_t f = 0; f < bench.mesh.triangles.size(); ++f) {
      const auto& [a, b, c] = bench.mesh.triangles[f];
      if (bench.mesh.points[a].z() != bench.mesh.points[b].z()) {
        region = bench.features.regions[f];
      }
    }
    EXPECT_NEAR(bench.field.in_region(place, region), wanted, 0.4 * wanted);
  }
}

TEST(SizeField, is_the_gap_between_sharp_edges) {
  const Bench bench(dupin::test::box(Vec3::Zero(), Vec3(10, 10, 0.5)), {0.01, 3, 0.01});
  std::uint32_t found = 0;
  for (std::uint32_t c = 0; c < bench.features.curves.size(); ++c) {
    const Curve& curve = bench.features.curves[c];
    const Vec3 middle = curve.at(curve.length() / 2);
    if (curve.length() > 5) {
      ++found;
      EXPECT_NEAR(bench.field.on_curve(middle, c, curve.length() / 2), 0.5, 1e-12);
    } else {
      EXPECT_NEAR(bench.field.on_curve(middle, c, curve.length() / 2), 3, 1e-12);
    }
  }
  EXPECT_EQ(found, 8U);
}

}  // namespace
}  // namespace dupin::remeshing
