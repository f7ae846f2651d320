#include <cmath>

#include <gtest/gtest.h>

#include "dupin/kernel/check.h"
#include "dupin/kernel/solid.h"
#include "mesh/coincident_points.h"
#include "rounding/sliver_voids.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

constexpr double kStep = 0x1p-30;
const std::array<double, 4> kHeights = {0.25, 0.25 + kStep, 0.25, 0.25 + kStep};

std::optional<FilledVoids> filled(const Solid& solid, double width) {
  return SliverVoids(solid.exact(), mesh::coincident_representatives(solid.exact()), width)
      .filled(width);
}

Solid solid(mesh::ExactMesh mesh) {
  return Solid(std::make_shared<const mesh::ExactMesh>(std::move(mesh)));
}

Solid pyramids() {
  const std::vector<TriMesh> parts = test::pyramids(kHeights);
  return Solid::from(test::joined({parts[0], parts[1]}));
}

/// A cube with flat voids of the given heights one above the other.
TriMesh cube_with_voids(std::initializer_list<double> heights) {
  TriMesh mesh = test::box(Vec3(0, 0, 0), Vec3(8, 8, 8));
  double low = 1;
  for (const double height : heights) {
    mesh =
        test::joined({mesh, test::reversed(test::box(Vec3(1, 1, low), Vec3(7, 7, low + height)))});
    low += 2;
  }
  return mesh;
}

TEST(Slits, between_two_ends_of_one_ring_are_filled) {
  const std::vector<TriMesh> parts = test::pyramids(kHeights);
  const Solid touching = Solid::from(
      test::joined({test::labelled(parts[0], "low"), test::labelled(parts[1], "high")}));
  EXPECT_EQ(touching.contacts().size(), 4);
  EXPECT_EQ(touching.components(), 2);
  const auto result = filled(touching, 2 * kStep);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->places.size(), 1);
  // The ring lies between two horizontal planes, and slanted ones cannot be much closer.
  EXPECT_GT(result->width, kStep / 2);
  EXPECT_LT(result->width, kStep * 1.001);
  const Solid whole = solid(result->mesh);
  EXPECT_TRUE(whole.contacts().empty());
  EXPECT_EQ(whole.components(), 1);
  EXPECT_EQ(whole.genus(), 0);
  EXPECT_EQ(whole.point_count(), 6);
  ASSERT_EQ(whole.triangle_count(), 8);
  for (std::uint32_t f = 0; f < 8; ++f) {
    double height = 0;
    for (const std::uint32_t v : whole.triangles()[f]) {
      height += whole.nearest_points()[v].z();
    }
    EXPECT_EQ(whole.names()[whole.labels()[f]], height > 1 ? "high" : "low");
    EXPECT_EQ(whole.sources()[f].triangle < parts[0].triangles.size(), height < 1);
  }
  EXPECT_TRUE(check({whole.nearest_points(), whole.triangles(), {}, {}}).is_solid());
}

TEST(Slits, wider_than_asked_for_stay) {
  EXPECT_FALSE(filled(pyramids(), kStep / 2));
  EXPECT_FALSE(filled(Solid::from(test::box(Vec3(0, 0, 0), Vec3(1, 1, kStep))), 1)) << "no void";
}

TEST(Slits, that_touch_nothing_are_filled_by_width) {
  const Solid cube = Solid::from(cube_with_voids({kStep, 1, 4 * kStep}));
  const SliverVoids voids(cube.exact(), mesh::coincident_representatives(cube.exact()), 0.5);
  const auto one = voids.filled(kStep * 1.5), both = voids.filled(0.5);
  ASSERT_TRUE(one && both);
  EXPECT_EQ(one->places.size(), 1);
  EXPECT_NEAR(one->width, kStep, kStep * 1e-9);
  EXPECT_GE(one->width, kStep);
  EXPECT_EQ(both->places.size(), 2);
  EXPECT_NEAR(both->width, 4 * kStep, kStep * 1e-9);
  EXPECT_EQ(solid(one->mesh).exact_volume(), cube.exact_volume() + 36 * mpq_class(kStep));
  EXPECT_EQ(solid(both->mesh).exact_volume(), 512 - 36);
}

TEST(Slits, in_which_material_floats_stay) {
  const TriMesh island = test::tetrahedron(Vec3(4, 4, 1 + kStep / 4), kStep / 4);
  EXPECT_FALSE(filled(Solid::from(test::joined({cube_with_voids({kStep}), island})), 0.5));
}

TEST(Slits, may_lie_at_any_coordinates) {
  for (const double scale : {0x1p-140, 0x1p120}) {
    TriMesh cube = cube_with_voids({kStep});
    for (Vec3& point : cube.points) {
      point *= scale;
    }
    const auto result = filled(Solid::from(cube), 0.5 * scale);
    ASSERT_TRUE(result) << scale;
    EXPECT_NEAR(result->width / scale, kStep, kStep * 1e-9);
  }
}

TEST(Slits, leave_other_contacts_as_they_are) {
  const std::vector<TriMesh> parts = test::pyramids(kHeights);
  const auto result = filled(
      Solid::from(test::joined({parts[0], parts[1], test::box(Vec3(-1, -1, -2), Vec3(0, 0, -1)),
                                test::box(Vec3(-2, -2, -2), Vec3(-1, -1, -1))})),
      2 * kStep);
  ASSERT_TRUE(result);
  const Solid rest = solid(result->mesh);
  ASSERT_EQ(rest.contacts().size(), 1);
  EXPECT_EQ(rest.contacts()[0].kind, Contact::Kind::edge);
  EXPECT_EQ(rest.components(), 3);
  EXPECT_EQ(rest.genus(), 0);
}

}  // namespace
}  // namespace dupin::rounding
