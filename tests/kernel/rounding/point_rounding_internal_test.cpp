#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "dupin/kernel/check.h"
#include "dupin/kernel/rounding.h"
#include "exact/exact_numbers.h"
#include "mesh/self_contact.h"
#include "rounding/point_rounding.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

/// The solid bounded by `mesh` divided by 3, whose coordinates are small integers.
Solid thirds(const TriMesh& mesh) {
  auto exact = std::make_shared<mesh::ExactMesh>();
  std::vector<std::uint32_t> order(mesh.points.size()), position(mesh.points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto implicit = [&](std::uint32_t v) {
    return std::ranges::any_of(mesh.points[v], [](double x) { return std::fmod(x, 3) != 0; });
  };
  std::ranges::stable_sort(order, {}, implicit);
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    const Vec3& p = mesh.points[order[i]];
    position[order[i]] = i;
    exact->points.push_back(p / 3);
    if (implicit(order[i])) {
      exact->implicit.push_back({p.x(), p.y(), p.z(), 3});
    }
  }
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const Triangle& t = mesh.triangles[f];
    exact->triangles.push_back({position[t[0]], position[t[1]], position[t[2]]});
    exact->sources.push_back({0, f});
  }
  mesh::separate_contacts(*exact);
  return Solid(exact);
}

mpq_class coordinate(const mesh::ExactMesh& mesh, std::uint32_t point, int axis) {
  const mesh::ExactPoint exact = mesh::exact_point(mesh, point);
  return exact::rational(exact[axis]) / exact::rational(exact[3]);
}

TEST(Rounding, goes_to_the_nearest_number) {
  const TriMesh mesh = test::tube(100, 1, 5, 12);
  TriMesh integers = mesh;
  for (Vec3& p : integers.points) {
    p = p.array().round();
  }
  const Solid solid = thirds(integers);
  for (const Coordinates target : {Coordinates::binary64, Coordinates::binary32}) {
    const Rounded rounded = to_mesh(solid, target);
    ASSERT_EQ(rounded.mesh().points.size(), solid.point_count());
    for (std::uint32_t v = 0; v < solid.point_count(); ++v) {
      for (int k = 0; k < 3; ++k) {
        const double third = solid.exact().points[v][k];  // the quotient of integers by 3, rounded
        EXPECT_EQ(rounded.mesh().points[v][k],
                  target == Coordinates::binary64 ? third
                                                  : static_cast<double>(static_cast<float>(third)));
      }
    }
    EXPECT_EQ(rounded.report().moved, solid.exact().implicit.size());
    EXPECT_TRUE(check(rounded.mesh()).is_solid());
  }
}

TEST(Rounding, is_done_once) {
  // A hair more than the tie between two floats: its nearest double is the tie itself.
  auto exact =
      std::make_shared<mesh::ExactMesh>(thirds(test::tetrahedron(Vec3::Zero(), 3)).exact());
  const CGAL::Mpzf weight(0x1p80);
  exact->points.back() = Vec3(0, 0, 1 + 0x1p-24);
  exact->implicit.push_back({0, 0, weight + CGAL::Mpzf(0x1p56) + CGAL::Mpzf(1), weight});
  EXPECT_EQ(to_mesh(Solid(exact), Coordinates::binary32).mesh().points.back().z(), 1 + 0x1p-23);
}

TEST(Rounding, bounds_every_move) {
  const Solid solid = thirds(test::box(Vec3(1, 2, 4), Vec3(1e6, 3e6 + 1, 5)));
  for (const Vec3& place : {Vec3(0, 0, 0), Vec3(1e5, 0.3, 7)}) {
    const Rounded rounded =
        to_mesh(solid, Coordinates::binary32, {.origin = {Origin::Choice::given, place}});
    ASSERT_EQ(rounded.mesh().points.size(), 8);
    EXPECT_EQ(rounded.report().origin, place);
    const mpq_class bound(rounded.report().largest_move);
    mpq_class largest = 0;
    for (std::uint32_t v = 0; v < 8; ++v) {
      mpq_class squares = 0;
      for (int k = 0; k < 3; ++k) {
        const mpq_class move = coordinate(solid.exact(), v, k) - mpq_class(place[k]) -
                               mpq_class(rounded.mesh().points[v][k]);
        squares += move * move;
      }
      largest = std::max(largest, squares);
    }
    EXPECT_LE(largest, bound * bound);
    EXPECT_GT(largest * 2, bound * bound);
  }
}

TEST(Rounding, keeps_contacts_of_points_that_no_double_holds) {
  const Solid solid = thirds(test::joined({test::box(Vec3::Constant(1), Vec3::Constant(4)),
                                           test::box(Vec3::Constant(4), Vec3::Constant(5))}));
  for (const Coordinates target : {Coordinates::binary64, Coordinates::binary32}) {
    const Rounded rounded = to_mesh(solid, target);
    const Report report = check(rounded.mesh());
    EXPECT_TRUE(report.is_solid());
    EXPECT_EQ(report.count(Defect::contact), 1);
    EXPECT_EQ(rounded.mesh().points.size(), 16);
  }
}

/// Whether `number` is the nearest one of the lattice, by the rational distances to its neighbours.
bool is_nearest(const exact::FloatLattice& lattice, double number, const mpq_class& value) {
  const mpq_class off = abs(mpq_class(number) - value);
  return off <= abs(mpq_class(lattice.shifted(number, 1)) - value) &&
         off <= abs(mpq_class(lattice.shifted(number, -1)) - value);
}

TEST(RoundPoints, says_what_is_not_where_it_was) {
  std::mt19937 random(3);
  TriMesh integers = test::tube(100, 1, 5, 40);
  for (Vec3& p : integers.points) {
    p = (p.array() + static_cast<double>(random() % 3)).round();
  }
  const Solid solid = thirds(integers);
  const mesh::ExactMesh& exact = solid.exact();
  for (const Vec3& origin : {Vec3(0, 0, 0), Vec3(1e5, 0.3, 0x1p-40)}) {
    for (const Coordinates coordinates : {Coordinates::binary64, Coordinates::binary32}) {
      const exact::FloatLattice lattice(coordinates);
      const RoundedPoints rounded = round_points(exact, lattice, origin);
      double largest = 0;
      for (std::uint32_t v = 0; v < exact.points.size(); ++v) {
        bool is_inexact = false, has_moved = false;
        for (int k = 0; k < 3; ++k) {
          const mpq_class value = coordinate(exact, v, k) - mpq_class(origin[k]);
          const double nearest =
              rounded.shifted.empty() ? exact.points[v][k] : rounded.shifted[v][k];
          const double on_lattice = rounded.on_lattice[v][k];
          ASSERT_EQ(nearest, exact::nearest_double(value));
          ASSERT_TRUE(is_nearest(lattice, on_lattice, value));
          is_inexact = is_inexact || mpq_class(nearest) != value;
          has_moved = has_moved || mpq_class(on_lattice) != value;
          largest = std::max(largest, std::abs(nearest));
        }
        EXPECT_TRUE(!is_inexact || rounded.inexact[v] == 1);
        EXPECT_TRUE(!has_moved || rounded.moved[v] == 1);
        const bool is_double = v < exact.double_count();
        EXPECT_TRUE(!is_double || (rounded.moved[v] == 1) == has_moved)
            << "doubles are told exactly";
      }
      EXPECT_EQ(rounded.largest, largest);
      EXPECT_EQ(rounded.any_inexact, std::ranges::count(rounded.inexact, 1) > 0);
    }
  }
}

}  // namespace
}  // namespace dupin::rounding
