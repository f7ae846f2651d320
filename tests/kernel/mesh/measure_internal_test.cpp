#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "exact/exact_numbers.h"
#include "kernel/torus.h"
#include "mesh/exact_mesh.h"
#include "mesh/measure.h"
#include "support/shapes.h"

namespace dupin::mesh {
namespace {

using Rational3 = std::array<mpq_class, 3>;

Rational3 rationals(const MeshView& mesh, std::uint32_t i) {
  const ExactPoint p = mesh.exact(i);
  const mpq_class w = exact::rational(p[3]);
  return {exact::rational(p[0]) / w, exact::rational(p[1]) / w, exact::rational(p[2]) / w};
}

// Summed tetrahedron by tetrahedron from a point outside, not from the origin.
mpq_class volume_from(const MeshView& mesh, const Rational3& apex) {
  mpq_class six = 0;
  for (const Triangle& t : mesh.triangles) {
    std::array<Rational3, 3> d;
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational3 p = rationals(mesh, t[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        d[i][k] = p[k] - apex[k];
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
      six += d[0][k] * (d[1][l] * d[2][m] - d[1][m] * d[2][l]);
    }
  }
  return six / 6;
}

// A closed surface with some points at thirds and sevenths of doubles.
ExactMesh shaken_torus(unsigned seed, std::size_t implicit) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> offset(-0.1, 0.1);
  TriMesh torus = test::torus(8, 12, 2, 1);
  ExactMesh mesh;
  mesh.triangles = torus.triangles;
  mesh.points = torus.points;
  for (std::size_t i = torus.points.size() - implicit; i < torus.points.size(); ++i) {
    ExactPoint p;
    for (int k = 0; k < 3; ++k) {
      p[static_cast<std::size_t>(k)] = CGAL::Mpzf(torus.points[i][k] * 16 + offset(random));
    }
    p[3] = CGAL::Mpzf(static_cast<double>(16 + random() % 7) / 4) * CGAL::Mpzf(3);
    for (int k = 0; k < 3; ++k) {
      mesh.points[i][k] = nearest_double(p[static_cast<std::size_t>(k)], p[3]);
    }
    mesh.implicit.push_back(p);
  }
  return mesh;
}

TEST(Measure, volumes_do_not_depend_on_the_origin) {
  for (const std::size_t implicit : {0U, 1U, 40U}) {
    const ExactMesh mesh = shaken_torus(static_cast<unsigned>(implicit), implicit);
    const mpq_class expected = volume_from(MeshView(mesh), {mpq_class(1, 3), -7, mpq_class(22, 7)});
    EXPECT_EQ(exact_volume(MeshView(mesh)), expected);
    EXPECT_EQ(nearest_volume(MeshView(mesh)), exact::nearest_double(expected));
    EXPECT_EQ(volume_sign(MeshView(mesh)), sgn(expected));
  }
}

TEST(Measure, the_same_surface_from_inside_has_the_opposite_volume) {
  ExactMesh mesh = shaken_torus(3, 25);
  const mpq_class volume = exact_volume(MeshView(mesh));
  for (Triangle& t : mesh.triangles) {
    std::swap(t[0], t[1]);
  }
  EXPECT_EQ(exact_volume(MeshView(mesh)), -volume);
}

TEST(Measure, areas_are_right_to_1e_12) {
  const double side = 3, height = std::sqrt(2) / 3;
  const TriMesh box = test::box({0, 0, 0}, {side, side, height});
  const double expected = 2 * side * side + 4 * side * height;
  EXPECT_NEAR(area({box.points, box.triangles}), expected, 1e-12 * expected);
}

// Doubles lose all digits of these areas: only exact differences tell them.
TEST(Measure, areas_of_slivers_far_away_are_right_to_1e_12) {
  const double far = 0x1p40, thin = 0x1p-12;
  const std::vector<Vec3> points{Vec3(far, far, far), Vec3(far + 1, far + 1, far + 1),
                                 Vec3(far + 0.5, far + 0.5, far + 0.5 + thin)};
  const std::vector<Triangle> triangles{{0, 1, 2}};
  // Half the base, sqrt(3), times the height, sqrt(2/3) thin.
  const double expected = thin * std::sqrt(2) / 2;
  EXPECT_NEAR(area({points, triangles}), expected, 1e-12 * expected);
}

// So many that they are added up in parts; rounding is bounded for all of them together, though it
// takes much of some.
TEST(Measure, areas_of_many_are_right_to_1e_12) {
  constexpr std::uint32_t kSide = 100;
  const double thin = 0x1p-40;
  std::vector<Vec3> points;
  for (std::uint32_t i = 0; i <= kSide; ++i) {
    const double x = 0x1p12 + (i == kSide ? kSide - 1 + thin : i);  // the last row is of slivers
    for (std::uint32_t j = 0; j <= kSide; ++j) {
      points.emplace_back(x, j, x);
    }
  }
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < kSide; ++i) {
    for (std::uint32_t j = 0; j < kSide; ++j) {
      const std::uint32_t at = i * (kSide + 1) + j, next = at + kSide + 1;
      triangles.push_back({at, next, next + 1});
      triangles.push_back({at, next + 1, at + 1});
    }
  }
  const double expected = std::sqrt(2) * (kSide - 1 + thin) * kSide;
  EXPECT_NEAR(area({points, triangles}), expected, 1e-13 * expected);
}

// Blocks, slivers and no triangle at all.
TEST(Measure, areas_one_after_the_other_have_the_same_sum) {
  std::mt19937 random(5);
  for (const std::size_t count : {0, 1, 4096, 4097, 20'000}) {
    for (const bool is_flat : {false, true}) {
      TriMesh mesh;
      AreaSum sum;
      const auto number = [&] { return double(random()) * 1e-3; };
      for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3 a(number(), number(), number()), b(number(), number(), number());
        const std::array<Vec3, 3> corners{
            a, b, is_flat ? Vec3(a / 2 + b / 2) : Vec3(number(), number(), number())};
        sum.add(corners);
        mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
      }
      EXPECT_EQ(sum.value(), area(MeshView(mesh.points, mesh.triangles)));
    }
  }
}

}  // namespace
}  // namespace dupin::mesh
