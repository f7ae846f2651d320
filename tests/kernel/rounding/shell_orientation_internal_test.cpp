#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/measure.h"
#include "rounding/shell_orientation.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

/// Large enough for a small shell to be a small part of it.
TriMesh pipe() { return test::tube(100, 0, 50, 64); }

std::vector<std::uint8_t> marks(const TriMesh& mesh, std::initializer_list<std::size_t> points) {
  std::vector<std::uint8_t> marked(mesh.points.size(), 0);
  for (const std::size_t point : points) {
    marked[point] = 1;
  }
  return marked;
}

bool keep_their_sides(const TriMesh& mesh, const std::vector<std::uint8_t>& moved, double move) {
  return keeps_shell_orientation({mesh.points, mesh.triangles}, moved, move);
}

/// Of the triangles after the first ones.
int sign_of_rest(const TriMesh& mesh, std::size_t first) {
  return mesh::volume_sign({mesh.points, std::span(mesh.triangles).subspan(first)});
}

TEST(StableShells, are_all_where_nothing_moved) {
  EXPECT_TRUE(keep_their_sides(pipe(), marks(pipe(), {}), 0));
}

TEST(StableShells, are_those_that_move_little_in_few_places) {
  const TriMesh mesh = test::joined({pipe(), test::tetrahedron(Vec3(200, 0, 0), 1)});
  const auto moved = marks(mesh, {5, mesh.points.size() - 1});
  EXPECT_TRUE(keep_their_sides(mesh, moved, 0x1p-20));
  EXPECT_FALSE(keep_their_sides(mesh, moved, 1));  // as far as the tetrahedron is high
}

TEST(StableShells, are_not_known_where_all_of_a_shell_moves) {
  const TriMesh mesh = test::joined({pipe(), test::tetrahedron(Vec3(200, 0, 0), 1)});
  const std::size_t n = mesh.points.size();
  EXPECT_FALSE(keep_their_sides(mesh, marks(mesh, {n - 4, n - 3, n - 2, n - 1}), 0x1p-20));
}

// It stays, but what moves may pass it as a whole.
TEST(StableShells, are_not_known_where_one_is_beside_what_moves) {
  const TriMesh large = pipe();
  std::size_t rim = 0;  // of the upper end, where the tetrahedron is above the second corner
  while (large.points[rim].z() < 50) {
    ++rim;
  }
  const Vec3 above = 0.999 * large.points[rim + 1] + Vec3(0, 0, 0.5);
  const TriMesh mesh = test::joined({large, test::tetrahedron(above, 0.25)});
  EXPECT_TRUE(keep_their_sides(mesh, marks(mesh, {rim + 1}), 0x1p-20));
  EXPECT_TRUE(keep_their_sides(large, marks(large, {rim + 1}), 1));
  EXPECT_FALSE(keep_their_sides(mesh, marks(mesh, {rim + 1}), 1));
}

TEST(StableShells, do_not_turn_inside_out) {
  std::mt19937 random(7);
  const auto number = [&](int largest) {
    return static_cast<double>(std::uniform_int_distribution(-largest, largest)(random));
  };
  const TriMesh large = pipe();
  int stable = 0, turned = 0;
  for (int i = 0; i < 4000; ++i) {
    TriMesh mesh = test::joined({large, test::tetrahedron()});
    const int size = i % 64 + 1;
    for (std::size_t corner = large.points.size(); corner < mesh.points.size(); ++corner) {
      mesh.points[corner] = {number(size), number(size), number(size)};
    }
    const int before = sign_of_rest(mesh, large.triangles.size());
    const Vec3 step(number(2), number(2), number(2));
    mesh.points.back() += step;
    const int after = sign_of_rest(mesh, large.triangles.size());
    if (before == 0 || after == 0) {
      continue;
    }
    const double move = step.norm() * (1 + 0x1p-50);
    const bool is_stable = keep_their_sides(mesh, marks(mesh, {mesh.points.size() - 1}), move);
    EXPECT_TRUE(before == after || !is_stable) << "tetrahedron " << i;
    stable += is_stable ? 1 : 0;
    turned += before != after ? 1 : 0;
  }
  EXPECT_GT(stable, 100);
  EXPECT_GT(turned, 100);
}

}  // namespace
}  // namespace dupin::rounding
