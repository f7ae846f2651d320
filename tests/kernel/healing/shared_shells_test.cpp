#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/repair.h"
#include "dupin/kernel/rounding.h"
#include "support/shapes.h"

// Closed shells, some of them inside out, that have faces, edges and points in common: none of what
// they bound is lost, and the order of faces does not matter.
namespace dupin {
namespace {

using test::box;
using test::joined;
using test::reversed;

using Random = std::mt19937;

int below(Random& random, int count) {
  return static_cast<int>(random() % static_cast<unsigned>(count));
}

mpq_class repaired_volume(const TriMesh& mesh) { return repair(mesh).solid.exact_volume(); }

// The diagonals of a side that two such boxes share are the same.
TriMesh flat_cube(int x, int y, int z) {
  TriMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.points.emplace_back(x + 2 * (i / 4), y + 2 * (i / 2 % 2), z + 2 * (i % 2));
  }
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return mesh;
}

TEST(SharedShells, a_wall_between_boxes_of_which_one_is_inside_out_loses_none) {
  const TriMesh first = flat_cube(0, 0, 0), second = flat_cube(2, 0, 0);
  EXPECT_EQ(repaired_volume(joined({first, second})), 16);
  EXPECT_EQ(repaired_volume(joined({reversed(first), reversed(second)})), 16);
  for (const TriMesh& mesh :
       {joined({first, reversed(second)}), joined({reversed(first), second})}) {
    const Repaired repaired = repair(mesh);
    EXPECT_EQ(repaired.solid.exact_volume(), 16);
    EXPECT_EQ(repaired.report.duplicate_faces, 4U);
    EXPECT_EQ(repaired.report.turned_faces, 10U);  // and two that are dropped
  }
}

TEST(SharedShells, boxes_that_meet_in_an_edge_or_apart_lose_none) {
  const TriMesh first = flat_cube(0, 0, 0);
  for (const TriMesh& second : {flat_cube(2, 2, 0), flat_cube(2, 2, 2), flat_cube(5, 0, 0)}) {
    for (const TriMesh& other : {second, reversed(second)}) {
      EXPECT_EQ(repaired_volume(joined({first, other})), 16);
      EXPECT_EQ(repaired_volume(joined({reversed(first), other})), 16);
    }
  }
}

TEST(SharedShells, a_wall_that_is_part_of_a_side_loses_none) {
  const TriMesh first = flat_cube(0, 0, 0), second = box({2, 0.5, 0.5}, {4, 1.5, 1.5});
  EXPECT_EQ(repaired_volume(joined({first, reversed(second)})), 10);
  EXPECT_EQ(repaired_volume(joined({reversed(first), second})), 10);
}

TEST(SharedShells, every_block_of_a_grid_counts_whichever_are_inside_out) {
  for (unsigned turned = 0; turned < 16; ++turned) {
    std::vector<TriMesh> blocks;
    for (int i = 0; i < 4; ++i) {
      const TriMesh block = flat_cube(2 * (i / 2), 2 * (i % 2), 0);
      blocks.push_back((turned >> i & 1) != 0 ? reversed(block) : block);
    }
    EXPECT_EQ(repaired_volume(joined(blocks)), 32) << turned;
  }
}

TEST(SharedShells, blocks_that_fill_a_grid_all_count) {
  Random random(26);
  for (int round = 0; round < 10; ++round) {
    std::vector<TriMesh> blocks;
    for (int i = 0; i < 125; ++i) {
      const TriMesh block = flat_cube(2 * (i / 25), 2 * (i / 5 % 5), 2 * (i % 5));
      blocks.push_back(random() % 3 == 0 ? reversed(block) : block);
    }
    EXPECT_EQ(repaired_volume(joined(blocks)), 1000) << round;
  }
}

TEST(SharedShells, cavities_that_touch_the_outside_stay) {
  // In an edge, and in a point.
  const TriMesh outer = box({0, 0, 0}, {8, 8, 8});
  TriMesh at_point = test::tetrahedron({2, 2, 2}, 2);
  at_point.points[0] = {0, 0, 0};
  TriMesh both = joined({outer, reversed(at_point)});
  const mpq_class cavity = Solid::from(at_point).exact_volume();
  EXPECT_EQ(repaired_volume(both), 512 - cavity);
  EXPECT_EQ(repaired_volume(reversed(both)), 512 - cavity);
}

/// Shells that are solids each, and the volume of their union.
struct Shells {
  std::vector<TriMesh> meshes;
  mpq_class volume;
};

// Turning shells must not take one for the wall of a cavity: none is within another one.
bool is_nested(const std::vector<Solid>& solids) {
  for (const Solid& inner : solids) {
    for (const Solid& outer : solids) {
      if (&inner != &outer && subtract(inner, std::array{outer}).exact_volume() == 0) {
        return true;
      }
    }
  }
  return false;
}

TriMesh random_shell(Random& random) {
  const auto any = [&] { return Vec3(below(random, 3), below(random, 3), below(random, 3)); };
  if (random() % 3 == 0) {
    const Vec3 low = any() - Vec3::Ones();
    return box(low, low + Vec3(1 + below(random, 2), 1 + below(random, 2), 1 + below(random, 2)));
  }
  for (;;) {
    TriMesh mesh = test::tetrahedron();
    std::ranges::generate(mesh.points, any);
    const Vec3 a = mesh.points[1] - mesh.points[0], b = mesh.points[2] - mesh.points[0],
               c = mesh.points[3] - mesh.points[0];
    if (const double volume = a.cross(b).dot(c); volume != 0) {
      return volume > 0 ? mesh : reversed(mesh);
    }
  }
}

Shells random_shells(Random& random) {
  for (;;) {
    Shells shells;
    std::vector<Solid> solids;
    for (int n = 2 + below(random, 7); n > 0; --n) {
      const TriMesh mesh = random_shell(random);
      solids.push_back(Solid::from(mesh));
      if (is_nested(solids)) {
        solids.pop_back();
      } else {
        shells.meshes.push_back(random() % 2 == 0 ? mesh : reversed(mesh));
      }
    }
    if (solids.size() > 1) {
      shells.volume = unite(solids).exact_volume();
      return shells;
    }
  }
}

// The same faces in another order, with other numbers of points and other first corners.
TriMesh shuffled(TriMesh mesh, Random& random) {
  std::vector<std::uint32_t> places(mesh.points.size());
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    places[i] = i;
  }
  std::ranges::shuffle(places, random);
  std::vector<Vec3> points(mesh.points.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    points[places[i]] = mesh.points[i];
  }
  mesh.points = std::move(points);
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) {
      corner = places[corner];
    }
    std::ranges::rotate(t, t.begin() + below(random, 3));
  }
  std::ranges::shuffle(mesh.triangles, random);
  return mesh;
}

// Corners of tetrahedra, some inside out, by their numbers in a grid; sums of them had other
// volumes when their faces came in another order.
const std::vector<std::vector<std::array<std::uint32_t, 4>>> kTetrahedra = {
    {{9, 10, 19, 22}, {11, 25, 12, 4}, {9, 25, 20, 13}, {11, 16, 1, 18}},
    {{22, 12, 14, 25}, {21, 1, 17, 4}, {25, 13, 11, 18}, {0, 21, 24, 16}, {6, 9, 2, 0}},
    {{10, 3, 9, 2},
     {9, 22, 10, 13},
     {13, 2, 9, 5},
     {16, 13, 3, 14},
     {13, 2, 7, 0},
     {18, 17, 9, 20}},
    {{4, 2, 14, 10},
     {1, 9, 25, 11},
     {13, 19, 18, 3},
     {5, 0, 14, 4},
     {23, 9, 1, 18},
     {3, 18, 24, 22},
     {9, 13, 21, 7},
     {1, 13, 14, 9}},
    {{15, 14, 2, 18},
     {4, 23, 8, 22},
     {2, 25, 4, 3},
     {14, 7, 24, 25},
     {21, 23, 15, 13},
     {26, 15, 2, 12},
     {14, 9, 10, 7},
     {15, 0, 25, 4},
     {0, 21, 26, 8},
     {14, 20, 17, 12}}};

TriMesh on_grid(const std::array<std::uint32_t, 4>& corners) {
  TriMesh mesh;
  for (const std::uint32_t i : corners) {
    mesh.points.emplace_back(i / 9, i / 3 % 3, i % 3);
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  return mesh;
}

TEST(SharedShells, tetrahedra_that_share_points_and_edges_are_united_in_any_order) {
  Random random(25);
  for (const auto& corners : kTetrahedra) {
    std::vector<TriMesh> meshes;
    std::vector<Solid> solids;
    for (const auto& four : corners) {
      meshes.push_back(on_grid(four));
      const bool is_inside_out = check(meshes.back()).volume < 0;
      solids.push_back(Solid::from(is_inside_out ? reversed(meshes.back()) : meshes.back()));
    }
    const TriMesh mesh = joined(meshes);
    const mpq_class volume = unite(solids).exact_volume();
    for (int i = 0; i < 10; ++i) {
      EXPECT_EQ(repaired_volume(shuffled(mesh, random)), volume);
      EXPECT_EQ(repaired_volume(shuffled(reversed(mesh), random)), volume);
    }
  }
}

TEST(SharedShells, random_shells_are_united_whichever_are_inside_out) {
  Random random(23);
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE(round);
    const Shells shells = random_shells(random);
    const TriMesh mesh = joined(shells.meshes);
    const Solid solid = repair(mesh).solid;
    EXPECT_EQ(solid.exact_volume(), shells.volume);
    EXPECT_TRUE(check(to_mesh(solid, Coordinates::binary64).mesh()).is_solid());
    EXPECT_EQ(repaired_volume(reversed(mesh)), solid.exact_volume());
    EXPECT_EQ(repaired_volume(shuffled(mesh, random)), solid.exact_volume());
  }
}

// Whatever they are, and however they nest.
TEST(SharedShells, the_order_of_faces_does_not_matter) {
  Random random(24);
  for (int round = 0; round < 600; ++round) {
    SCOPED_TRACE(round);
    std::vector<TriMesh> meshes;
    for (int n = 2 + below(random, 7); n > 0; --n) {
      const TriMesh mesh = random_shell(random);
      meshes.push_back(random() % 2 == 0 ? mesh : reversed(mesh));
    }
    const TriMesh mesh = joined(meshes);
    const mpq_class volume = repaired_volume(mesh);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(repaired_volume(shuffled(mesh, random)), volume);
    }
  }
}

}  // namespace
}  // namespace dupin
