#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "rounding/near_shells.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

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
