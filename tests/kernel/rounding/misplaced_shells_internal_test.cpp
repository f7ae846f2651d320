#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/check.h"
#include "dupin/kernel/connected_components.h"
#include "mesh/measure.h"
#include "rounding/misplaced_shells.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

std::vector<std::uint32_t> misplaced(const TriMesh& before, const TriMesh& after, double move) {
  return misplaced_shells({before.points, before.triangles},
                          connected_components(before.triangles, before.points.size()),
                          {after.points, after.triangles}, move);
}

/// The last triangle of each shell that `check` finds inside out, or at the wrong depth; none if
/// something else is wrong.
std::optional<std::vector<std::uint32_t>> misplaced_by_check(const TriMesh& mesh) {
  std::vector<std::uint32_t> faces;
  for (const Finding& finding : check(mesh).findings) {
    if (finding.defect != Defect::inside_out_component) {
      return std::nullopt;
    }
    faces.push_back(finding.faces.back());
  }
  std::ranges::sort(faces);
  return faces;
}

TEST(MisplacedShells, are_those_whose_volume_changes_its_sign) {
  std::mt19937 random(1);
  std::size_t turned = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<TriMesh> shells;
    for (int i = 0; i < 5; ++i) {
      shells.push_back(test::tetrahedron(Vec3(10 * i, 0, 0), i % 2 == 0 ? 0.5 : 3));
    }
    const TriMesh before = test::joined(shells);
    TriMesh after = before;
    std::uniform_real_distribution<double> offset(-0.4, 0.4);
    double largest = 0;
    for (std::size_t v = 0; v < after.points.size(); ++v) {
      const Vec3 move(offset(random), offset(random), offset(random));
      after.points[v] += move;
      largest = std::max(largest, move.norm());
    }
    auto faces = misplaced(before, after, largest * 1.001);
    std::ranges::transform(faces, faces.begin(), [](std::uint32_t f) { return f / 4; });
    std::ranges::sort(faces);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < 5; ++i) {
      const auto own = std::span(after.triangles).subspan(4 * std::size_t{i}, 4);
      if (mesh::volume_sign({after.points, own}) != 1) {
        expected.push_back(i);
      }
    }
    ASSERT_EQ(faces, expected) << round;
    turned += expected.size();
  }
  EXPECT_GT(turned, 20);
}

// A corner of the large one moves, and so the sides of it beside which tiny ones float.
TEST(MisplacedShells, are_those_that_a_side_passes_over) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> offset(-1, 1);
  std::size_t passed = 0, kept = 0;
  for (int round = 0; round < 600; ++round) {
    const bool is_void = round % 2 == 0;
    // At (3, 3, 3) the slanted side is near, at (30, 0, 0) none is.
    TriMesh tiny = test::tetrahedron(Vec3(3, 3, 3).array() + (is_void ? 0.2 : 0.4), 0.01);
    tiny = is_void ? test::reversed(tiny) : tiny;
    TriMesh before = test::joined(
        {test::tetrahedron({0, 0, 0}, 10.0), tiny, test::tetrahedron({30, 0, 0}, 0.01)});
    ASSERT_TRUE(check(before).is_solid());
    TriMesh after = before;
    const Vec3 move(offset(random), offset(random), offset(random));
    after.points[1] += 3 * move;
    after.points[2] += 3 * move;
    const auto expected = misplaced_by_check(after);
    if (!expected) {
      continue;
    }
    auto faces = misplaced(before, after, 3.001 * move.norm());
    std::ranges::sort(faces);
    ASSERT_EQ(faces, *expected) << round;
    ++(faces.empty() ? kept : passed);
  }
  EXPECT_GT(passed, 50);
  EXPECT_GT(kept, 50);
}

// No volume changes its sign, and both boxes have places that are far from all that moves, but not
// the wall between them.
TEST(MisplacedShells, are_walls_that_turn) {
  const auto hollow = [](double wall) {
    return test::joined(
        {test::box({0, 0, 0}, {8, 8, 8}),
         test::reversed(test::box(Vec3::Constant(wall), Vec3::Constant(8 - wall)))});
  };
  EXPECT_TRUE(misplaced(hollow(0.25), hollow(0.125), 0.25).empty());
  EXPECT_EQ(misplaced(hollow(0.25), hollow(-0.25), 1).size(), 2);
}

// What is around many is asked for only where it is in doubt.
TEST(MisplacedShells, are_found_among_thousands) {
  std::vector<TriMesh> parts = {test::box({-1, -1, -1}, {41, 41, 41})};
  for (int i = 0; i < 4000; ++i) {
    const Vec3 low(2 * (i % 20), 2 * (i / 20 % 20), 2 * (i / 400));
    parts.push_back(test::reversed(test::box(low, low + Vec3::Ones())));
  }
  const TriMesh before = test::joined(parts);
  EXPECT_TRUE(misplaced(before, before, 0.001).empty());
  TriMesh after = before;
  for (std::size_t v = 8 * 1234; v < 8 * 1235; ++v) {
    after.points[v] += Vec3(100, 0, 0);
  }
  EXPECT_EQ(misplaced(before, after, 101).size(), 1);
}

}  // namespace
}  // namespace dupin::rounding
