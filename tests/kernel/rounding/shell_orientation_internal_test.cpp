#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include <Eigen/Geometry>
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

std::vector<std::uint32_t> near(const TriMesh& mesh, const std::vector<std::uint32_t>& moving,
                                double reach) {
  return faces_of_near_shells({mesh.points, mesh.triangles}, moving, reach);
}

std::vector<std::uint32_t> faces_up_to(std::uint32_t begin, std::uint32_t end) {
  std::vector<std::uint32_t> faces(end - begin);
  std::iota(faces.begin(), faces.end(), begin);
  return faces;
}

TEST(NearShells, are_whole_ones_that_do_not_move) {
  const TriMesh mesh = test::joined({test::box({0, 0, 0}, {8, 8, 8}),        // faces 0 to 11
                                     test::tetrahedron({8.5, 4, 4}, 0.25),   // 12 to 15
                                     test::box({8.5, 6, 6}, {12, 7, 7}),     // 16 to 27
                                     test::tetrahedron({20, 4, 4}, 0.25)});  // 28 to 31
  const std::vector<std::uint32_t> box = faces_up_to(0, 12);
  EXPECT_EQ(near(mesh, box, 1), faces_up_to(12, 16));
  EXPECT_TRUE(near(mesh, box, 0.25).empty());
  EXPECT_TRUE(near(mesh, {}, 1).empty());
  EXPECT_EQ(near(mesh, {0, 12}, 100), faces_up_to(16, 32)) << "the others' shells move in part";
}

// However triangles are numbered and moved, against a search of all pairs.
TEST(NearShells, are_found_wherever_they_are) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 40), size(0.1, 4);
  for (int round = 0; round < 30; ++round) {
    std::vector<TriMesh> parts;
    for (int i = 0; i < 60; ++i) {
      parts.push_back(
          test::tetrahedron(Vec3(place(random), place(random), place(random)), size(random)));
    }
    TriMesh mesh = test::joined(parts);
    std::ranges::shuffle(mesh.triangles, random);
    std::vector<std::uint32_t> moving;
    for (int i = 0; i < 6; ++i) {
      moving.push_back(static_cast<std::uint32_t>(random() % mesh.triangles.size()));
    }
    const auto box = [&](std::uint32_t face) {
      Eigen::AlignedBox3d result;
      for (const std::uint32_t corner : mesh.triangles[face]) {
        result.extend(mesh.points[corner]);
      }
      return result;
    };
    constexpr double kReach = 2;
    std::vector<std::uint8_t> stays(60, 1);
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
      const bool is_near = std::ranges::any_of(moving, [&](std::uint32_t other) {
        const Eigen::AlignedBox3d a = box(face), b = box(other);
        return (a.min() - b.max()).maxCoeff() <= kReach && (b.min() - a.max()).maxCoeff() <= kReach;
      });
      if (!is_near || std::ranges::find(moving, face) != moving.end()) {
        stays[mesh.triangles[face][0] / 4] = 0;
      }
    }
    std::vector<std::uint32_t> expected;
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
      if (stays[mesh.triangles[face][0] / 4] != 0) {
        expected.push_back(face);
      }
    }
    ASSERT_EQ(near(mesh, moving, kReach), expected) << round;
  }
}

}  // namespace
}  // namespace dupin::rounding
