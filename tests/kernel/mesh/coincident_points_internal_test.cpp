#include <random>

#include <gtest/gtest.h>

#include "exact/exact_numbers.h"
#include "mesh/coincident_points.h"
#include "mesh/exact_mesh.h"

namespace dupin::mesh {
namespace {

TEST(CoincidentPoints, are_found_as_by_comparing_all_with_all) {
  std::mt19937 random(8);
  for (const std::uint32_t count : {0U, 1U, 7U, 400U}) {
    std::vector<Vec3> points(count);
    for (Vec3& p : points) {
      for (int k = 0; k < 3; ++k) {
        p[k] = static_cast<double>(random() % 5) / 4 * (random() % 2 == 0 ? 1 : -1);
      }
    }
    std::vector<std::uint32_t> expected;
    for (const Vec3& p : points) {
      const auto first = std::find(points.begin(), points.end(), p);
      expected.push_back(static_cast<std::uint32_t>(first - points.begin()));
    }
    EXPECT_EQ(coincident_representatives(points), expected);
  }
}

TEST(CoincidentPoints, zeros_of_either_sign_are_the_same) {
  EXPECT_EQ(hash_of(Vec3(0, -0.0, 1)), hash_of(Vec3(-0.0, 0, 1)));
  const std::vector<Vec3> points{Vec3(0, 1, -0.0), Vec3(-0.0, 1, 0)};
  EXPECT_EQ(coincident_representatives(points), (std::vector<std::uint32_t>{0, 0}));
}

// Points within one double of each other that differ, and equal ones of different weights.
TEST(CoincidentPoints, implicit_ones_are_told_apart_exactly) {
  std::mt19937 random(2);
  ExactMesh mesh;
  mesh.points = {Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(1.0 / 3, 0, 0)};
  for (int i = 0; i < 200; ++i) {
    const double weight = 3 * static_cast<double>(1 + random() % 4);
    const double tiny = std::ldexp(static_cast<double>(random() % 3), -100);
    mesh.implicit.push_back({CGAL::Mpzf(weight / 3) + CGAL::Mpzf(tiny) * CGAL::Mpzf(weight),
                             CGAL::Mpzf(0), CGAL::Mpzf(0), CGAL::Mpzf(weight)});
    mesh.points.push_back(Vec3(1.0 / 3, 0, 0));
  }
  const auto x = [&](std::uint32_t i) {
    const ExactPoint p = exact_point(mesh, i);
    return mpq_class(exact::rational(p[0]) / exact::rational(p[3]));
  };
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    std::uint32_t first = 0;
    while (x(first) != x(i)) {
      ++first;
    }
    expected.push_back(first);
  }
  EXPECT_EQ(coincident_representatives(mesh), expected);
}

TEST(CoincidentPoints, without_contacts_every_point_stands_for_itself) {
  ExactMesh mesh;
  mesh.points = {Vec3(1, 2, 3), Vec3(1, 2, 3)};
  EXPECT_EQ(representatives_at_contacts(mesh), (std::vector<std::uint32_t>{0, 1}));
  mesh.contacts.resize(1);
  EXPECT_EQ(representatives_at_contacts(mesh), (std::vector<std::uint32_t>{0, 0}));
}

}  // namespace
}  // namespace dupin::mesh
