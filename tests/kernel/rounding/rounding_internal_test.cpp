#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/check.h"
#include "dupin/kernel/rounding.h"
#include "exact/exact_numbers.h"
#include "exact/float_lattice.h"
#include "kernel/torus.h"
#include "mesh/exact_mesh.h"
#include "mesh/self_contact.h"
#include "rounding/edit_strategy.h"
#include "rounding/edited_mesh.h"
#include "rounding/mesh_part.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

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

TEST(Lattice, rounds_to_the_nearest_float_with_ties_to_even) {
  const exact::FloatLattice floats(Coordinates::binary32);
  std::mt19937_64 random(5);
  for (int i = 0; i < 100000; ++i) {
    const auto bits = random();
    const double value =
        std::ldexp(static_cast<double>(bits >> 11), static_cast<int>(bits % 260) - 190);
    const auto expected = static_cast<double>(static_cast<float>(value));
    for (const double sign : {1.0, -1.0}) {
      ASSERT_EQ(floats.nearest(sign * value), sign * expected) << value;
      ASSERT_EQ(floats.nearest(sign * value, [] { return 0; }), sign * expected) << value;
    }
  }
}

TEST(Lattice, asks_which_side_of_a_tie_the_exact_number_lies) {
  const exact::FloatLattice floats(Coordinates::binary32);
  const double even = 1, odd = 1 + 0x1p-23, between = 1 + 0x1p-24;
  EXPECT_EQ(floats.nearest(between, [] { return -1; }), even);
  EXPECT_EQ(floats.nearest(between, [] { return 0; }), even);
  EXPECT_EQ(floats.nearest(between, [] { return 1; }), odd);
  EXPECT_EQ(floats.nearest(-between, [] { return -1; }), -odd);
  EXPECT_EQ(floats.nearest(-between, [] { return 1; }), -even);
}

TEST(Lattice, steps_from_number_to_number) {
  const exact::FloatLattice floats(Coordinates::binary32), doubles(Coordinates::binary64);
  for (const float start : {0.0F, 1.0F, -1.0F, 1.5F, 0x1p-149F, -0x1p-126F, 3e38F}) {
    float up = start, down = start;
    for (int count = 1; count <= 3; ++count) {
      up = std::nextafterf(up, kInfinity);
      down = std::nextafterf(down, -kInfinity);
      EXPECT_EQ(floats.shifted(start, count), static_cast<double>(up)) << start;
      EXPECT_EQ(floats.shifted(start, -count), static_cast<double>(down)) << start;
    }
    EXPECT_EQ(doubles.shifted(start, 1), std::nextafter(static_cast<double>(start), 1e300));
    EXPECT_EQ(doubles.shifted(start, -1), std::nextafter(static_cast<double>(start), -1e300));
  }
}

TEST(Lattice, may_have_a_uniform_spacing) {
  const exact::FloatLattice grid(Coordinates::binary64, 0.25);
  EXPECT_EQ(grid.nearest(1.1), 1);
  EXPECT_EQ(grid.nearest(1.125), 1);
  EXPECT_EQ(grid.nearest(1.375), 1.5);
  EXPECT_EQ(grid.nearest(-1e9 - 0.2), -1e9 - 0.25);
  EXPECT_EQ(grid.shifted(1, -3), 0.25);
  EXPECT_EQ(grid.shifted(0, -1), -0.25);
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
  exact->implicit = {{0, 0, weight + CGAL::Mpzf(0x1p56) + CGAL::Mpzf(1), weight}};
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

struct Edit : testing::Test {
  explicit Edit(const TriMesh& start = test::tube(1, 0, 1, 8))
      : shape(start), classes(shape.triangles.size(), 0), twins(shape.points.size()) {
    std::iota(twins.begin(), twins.end(), 0);
  }
  EditedMesh mesh() { return {shape.points, shape.triangles, classes, twins}; }
  static TriMesh result(const EditedMesh& mesh) {
    TriMesh alive{{mesh.points().begin(), mesh.points().end()}};
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      if (mesh.alive(f)) {
        alive.triangles.push_back(mesh.triangle(f));
      }
    }
    return alive;
  }
  TriMesh shape;
  std::vector<std::uint32_t> classes, twins;
  EditRule terms{EditRule::Rule::none_bad, 10};
};

TEST_F(Edit, collapses_keep_a_solid_until_none_is_possible) {
  EditedMesh tube = mesh();
  std::size_t collapses = 0;
  for (bool any = true; any;) {
    any = false;
    for (std::uint32_t f = 0; f < tube.face_count() && !any; ++f) {
      for (int edge = 0; edge < 3 && tube.alive(f) && !any; ++edge) {
        const Triangle t = tube.triangle(f);
        any = tube.collapse(t[edge], t[(edge + 1) % 3], terms);
      }
    }
    collapses += any ? 1 : 0;
    ASSERT_TRUE(check(result(tube)).is_solid());
  }
  EXPECT_EQ(collapses, shape.points.size() - 4);
  EXPECT_EQ(check(result(tube)).triangles, 4) << "a tetrahedron is the least";
}

TEST_F(Edit, is_refused_beyond_the_reach) {
  EditedMesh tube = mesh();
  const Triangle t = tube.triangle(0);
  const double length = (tube.point(t[0]) - tube.point(t[1])).norm();
  terms.reach = length * 0.999;
  EXPECT_FALSE(tube.collapse(t[0], t[1], terms));
  EXPECT_FALSE(tube.move(t[0], tube.point(t[1]), terms));
  terms.reach = length * 1.001;
  EXPECT_TRUE(tube.collapse(t[0], t[1], terms));
  EXPECT_GE(tube.reach(t[1]), length);
}

TEST_F(Edit, that_makes_the_mesh_worse_is_refused) {
  EditedMesh tube = mesh();
  EXPECT_FALSE(tube.move(0, Vec3(0, 0, 5), terms)) << "a bottom corner through the top";
  EXPECT_TRUE(tube.move(0, Vec3(1.5, 0, 0), terms));
  EXPECT_TRUE(check(result(tube)).is_solid());
}

TEST_F(Edit, leaves_points_of_contacts_alone) {
  twins[1] = 0;
  EditedMesh tube = mesh();
  EXPECT_FALSE(tube.move(0, Vec3(1.5, 0, 0), terms));
  EXPECT_FALSE(tube.move(1, Vec3(1.5, 0, 0), terms));
  EXPECT_TRUE(tube.move(2, tube.point(2) * 1.25, terms));
}

TEST_F(Edit, gives_no_area_to_another_class) {
  std::iota(classes.begin(), classes.end(), 0);
  EditedMesh tube = mesh();
  terms.reach = 1e-3;
  for (std::uint32_t f = 0; f < tube.face_count(); ++f) {
    for (int edge = 0; edge < 3; ++edge) {
      EXPECT_FALSE(tube.flip(f, edge, terms)) << f;
    }
  }
  std::ranges::fill(classes, 0);
  EditedMesh plain = mesh();
  std::size_t flips = 0;
  for (std::uint32_t f = 0; f < plain.face_count(); ++f) {
    for (int edge = 0; edge < 3; ++edge) {
      flips += plain.flip(f, edge, terms) ? 1 : 0;
    }
  }
  EXPECT_GT(flips, 0) << "within a flat end or side";
  EXPECT_TRUE(check(result(plain)).is_solid());
}

TEST_F(Edit, repairs_what_random_moves_have_broken) {
  const exact::FloatLattice lattice(Coordinates::binary64, 0x1p-10);
  std::mt19937 random(17);
  std::uniform_int_distribution<int> offset(-200, 200);
  std::size_t broken = 0;
  for (int round = 0; round < 30; ++round) {
    shape = test::tube(1, 0, 1, 64);
    for (Vec3& p : shape.points) {
      p = lattice.nearest(p) + Vec3(offset(random), offset(random), offset(random)) * 0x1p-10;
    }
    classes.assign(shape.triangles.size(), 0);
    twins.resize(shape.points.size());
    std::iota(twins.begin(), twins.end(), 0);
    EditedMesh tube = mesh();
    tube.find_faults(std::vector<std::uint8_t>(shape.triangles.size(), 1));
    const std::size_t before = tube.bad_items().size();
    repair(tube, lattice, 2, 1'000'000);
    const Report after = check(result(tube));
    EXPECT_EQ(tube.bad_items().empty(),
              after.count(Defect::self_intersection) + after.count(Defect::degenerate_face) == 0)
        << "the books are right";
    EXPECT_TRUE(after.closed());
    EXPECT_LE(tube.bad_items().size(), before);
    broken += before > 0 && tube.bad_items().empty() ? 1 : 0;
  }
  EXPECT_GE(broken, 25) << "most can be repaired";
}

/// Some triangles of a fine torus, whose points have six each, that are to be repaired, and those
/// around them.
struct Part : Edit {
  Part() : Edit(test::torus(24, 48, 2, 1)) {}
  std::optional<MeshPart> around(const std::vector<std::uint32_t>& broken) {
    const BrokenMesh whole{shape.points, shape.points, inexact, shape.triangles, classes, twins};
    return MeshPart::around(whole, broken, 1e-4, 1e-5);
  }
  std::vector<std::uint8_t> inexact = std::vector<std::uint8_t>(shape.points.size(), 0);
};

TEST_F(Part, has_all_triangles_of_its_complete_points) {
  const auto part = around({100, 101});
  ASSERT_TRUE(part);
  EXPECT_LT(part->faces().size(), shape.triangles.size() / 4);
  EXPECT_EQ(part->faces()[part->face(100)], 100);
  std::vector<std::size_t> in_whole(shape.points.size(), 0), in_part(shape.points.size(), 0);
  for (const Triangle& t : shape.triangles) {
    std::ranges::for_each(t, [&](std::uint32_t v) { ++in_whole[v]; });
  }
  for (const std::uint32_t f : part->faces()) {
    std::ranges::for_each(shape.triangles[f], [&](std::uint32_t v) { ++in_part[v]; });
  }
  const BrokenMesh view = part->view();
  std::size_t complete = 0;
  for (std::uint32_t v = 0; v < part->points().size(); ++v) {
    const std::uint32_t point = part->points()[v];
    EXPECT_EQ(view.doubles[v], shape.points[point]);
    if (view.complete[v] != 0) {
      EXPECT_EQ(in_part[point], in_whole[point]);
      ++complete;
    }
  }
  EXPECT_GT(complete, 3);
  EXPECT_LT(complete, part->points().size());
}

TEST_F(Part, is_edited_where_no_other_triangle_is_near) {
  const auto part = around({100});
  ASSERT_TRUE(part);
  const BrokenMesh view = part->view();
  EditedMesh mesh(view.doubles, view.triangles, view.labels, view.twins, view.complete);
  const auto move = [&](std::uint32_t v) {
    return mesh.move(v, mesh.point(v) + Vec3(0, 0, 1e-5), terms);
  };
  for (const std::uint32_t v : view.triangles[part->face(100)]) {
    EXPECT_TRUE(move(v));
  }
  for (std::uint32_t v = 0; v < view.complete.size(); ++v) {
    if (view.complete[v] == 0) {
      EXPECT_FALSE(move(v));
    }
  }
}

TEST_F(Part, is_not_taken_if_it_would_be_the_most) {
  std::vector<std::uint32_t> many(shape.triangles.size() / 2);
  std::iota(many.begin(), many.end(), 0U);
  EXPECT_FALSE(around(many));
}

}  // namespace
}  // namespace dupin::rounding
