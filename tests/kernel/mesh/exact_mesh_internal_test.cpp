#include <cmath>
#include <random>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "exact/exact_numbers.h"
#include "mesh/exact_mesh.h"

namespace dupin::mesh {
namespace {

ExactMesh three_points() {
  ExactMesh mesh;
  mesh.points = {Vec3(0.5, -2, 3), Vec3(1.0 / 3, 2.0 / 3, 1)};
  mesh.implicit.push_back({1, 2, 3, 3});
  mesh.triangles = {{0, 1, 0}};
  return mesh;
}

TEST(ExactMesh, points_are_doubles_first_then_implicit) {
  const ExactMesh mesh = three_points();
  EXPECT_EQ(mesh.double_count(), 1U);
  const ExactPoint given{CGAL::Mpzf(0.5), CGAL::Mpzf(-2), CGAL::Mpzf(3), CGAL::Mpzf(1)};
  EXPECT_EQ(exact_point(mesh, 0), given);
  EXPECT_EQ(exact_point(mesh, 1), mesh.implicit[0]);
}

TEST(ExactMesh, views_read_meshes_of_any_owner) {
  const ExactMesh mesh = three_points();
  const MeshView all(mesh), plain(mesh.points, mesh.triangles);
  EXPECT_EQ(all.double_count(), 1U);
  EXPECT_EQ(all.exact(1), mesh.implicit[0]);
  EXPECT_EQ(plain.double_count(), 2U);
  EXPECT_EQ(exact::rational(plain.exact(1)[0]), mpq_class(1.0 / 3)) << "the nearest double";
}

TEST(ExactMesh, nearest_double_has_no_neighbour_that_is_nearer) {
  std::mt19937_64 random(9);
  for (int i = 0; i < 2000; ++i) {
    const CGAL::Mpzf numerator = CGAL::Mpzf(static_cast<double>(random() % (1ULL << 53)) - 0x1p52) *
                                 CGAL::Mpzf(std::ldexp(1.0, static_cast<int>(random() % 80) - 40));
    const CGAL::Mpzf denominator(static_cast<double>(1 + random() % (1ULL << 53)));
    const double nearest = nearest_double(numerator, denominator);
    const mpq_class exact = exact::rational(numerator) / exact::rational(denominator);
    const mpq_class error = abs(mpq_class(nearest) - exact);
    for (const double way : {-HUGE_VAL, HUGE_VAL}) {
      EXPECT_GE(cmp(abs(mpq_class(std::nextafter(nearest, way)) - exact), error), 0);
    }
  }
}

TEST(ExactMesh, nearest_double_takes_the_even_one_of_two) {
  EXPECT_EQ(nearest_double(CGAL::Mpzf(0x1p53) + CGAL::Mpzf(1), CGAL::Mpzf(1)), 0x1p53);
  EXPECT_EQ(nearest_double(CGAL::Mpzf(0x1p53) + CGAL::Mpzf(3), CGAL::Mpzf(1)), 0x1p53 + 4);
}

}  // namespace
}  // namespace dupin::mesh
