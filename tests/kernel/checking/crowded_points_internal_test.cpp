#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "boxes/tree_traversal.h"
#include "checking/crowded_points.h"
#include "checking/self_intersection.h"
#include "dupin/kernel/check.h"
#include "predicates/triangle_overlap.h"
#include "support/shapes.h"

namespace dupin::checking {
namespace {

using Overlap = predicates::TriangleOverlap;

struct Faces {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;

  [[nodiscard]] std::vector<std::uint32_t> all() const {
    std::vector<std::uint32_t> indices(triangles.size());
    std::iota(indices.begin(), indices.end(), 0U);
    return indices;
  }
};

/// What is found without boxes. No two points have the same coordinates.
std::vector<FacePair> all_pairs(const Faces& faces) {
  std::vector<FacePair> pairs;
  std::vector<std::uint8_t> flat;
  for (const auto& [a, b, c] : faces.triangles) {
    flat.push_back(predicates::collinear(faces.points[a], faces.points[b], faces.points[c]) ? 1
                                                                                            : 0);
  }
  for (std::uint32_t f = 0; f < flat.size(); ++f) {
    const predicates::TriangleOverlapTest test(faces.points, faces.triangles[f]);
    for (std::uint32_t g = f + 1; g < flat.size() && flat[f] == 0; ++g) {
      const Overlap how = flat[g] != 0 ? Overlap::none : test.meeting(faces.triangles[g]);
      if (how != Overlap::none) {
        pairs.push_back(
            {f, g, how == Overlap::overlap ? FacePair::Kind::overlap : FacePair::Kind::crossing});
      }
    }
  }
  return pairs;
}

/// Triangles about the first point, with sides up to `reach` apart in the list of the others, and
/// some that have nothing to do with it. The others are all different points of a grid.
Faces random_faces(std::mt19937& random, int side, std::size_t count, std::uint32_t reach) {
  Faces faces;
  std::vector<Vec3> grid;
  for (int i = 0; i < (2 * side + 1) * (2 * side + 1) * (2 * side + 1); ++i) {
    const int n = 2 * side + 1;
    grid.emplace_back(i % n - side, i / n % n - side, i / n / n - side);
  }
  std::swap(grid[grid.size() / 2], grid[0]);
  std::shuffle(grid.begin() + 1, grid.end(), random);
  faces.points = grid;
  const auto others = static_cast<std::uint32_t>(grid.size() - 1);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto at = static_cast<std::uint32_t>(random() % others);
    const auto to = static_cast<std::uint32_t>((at + 1 + random() % reach) % others);
    const bool apart = i % 16 == 0;
    faces.triangles.push_back({apart ? 1 + (to + 1) % others : 0, 1 + at, 1 + to});
    if (faces.triangles.back()[0] == 1 + at) {
      faces.triangles.back()[0] = 0;
    }
  }
  return faces;
}

TEST(CrowdedPoints, change_nothing_that_is_found) {
  std::mt19937 random(15);
  std::size_t pairs = 0;
  for (int round = 0; round < 12; ++round) {
    Faces faces = random_faces(random, 3 + round % 4, 300 + 20 * round, 1 + round * round);
    if (round % 3 == 0) {  // crowded twice
      const auto count = faces.triangles.size();
      for (std::size_t i = 0; i < count; ++i) {
        Triangle other = faces.triangles[i];
        std::ranges::replace(other, 0U, 7U);
        if (std::ranges::count(other, 7U) == 1) {
          faces.triangles.push_back(other);
        }
      }
    }
    const auto found = find_self_intersections(faces.points, faces.triangles);
    ASSERT_FALSE(
        crowded_points(faces.triangles, faces.all(), faces.points.size(), {}, 256).empty());
    ASSERT_EQ(found.pairs, all_pairs(faces)) << "round " << round;
    pairs += found.pairs.size();
  }
  EXPECT_GT(pairs, 100000U);
}

TEST(CrowdedPoints, change_nothing_where_few_triangles_are_active) {
  std::mt19937 random(16);
  const Faces faces = random_faces(random, 6, 1500, 900);
  std::vector<std::uint8_t> active(faces.triangles.size(), 0);
  for (std::size_t i = 0; i < 600; ++i) {
    active[i] = 1;
  }
  auto expected = all_pairs(faces);
  std::erase_if(expected, [&](const FacePair& p) { return p.first >= 600 && p.second >= 600; });
  const auto found = find_self_intersections(faces.points, faces.triangles, {.active = active});
  EXPECT_EQ(found.pairs, expected);
}

TEST(CrowdedPoints, with_twins_have_their_contacts) {
  std::mt19937 random(17);
  Faces faces = random_faces(random, 4, 600, 40);
  faces.points.push_back(faces.points[0]);
  const auto twin = static_cast<std::uint32_t>(faces.points.size() - 1);
  for (std::size_t i = 0; i < faces.triangles.size(); i += 2) {
    std::ranges::replace(faces.triangles[i], 0U, twin);
  }
  const auto found = find_self_intersections(faces.points, faces.triangles);
  EXPECT_GT(found.contacts, 10000U) << "of the point and its twin";
}

TEST(CrowdedPoints, have_each_face_at_one_corner) {
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 1, 3}, {0, 3, 4}, {1, 5, 6}, {7, 5, 6}};
  const std::vector<std::uint32_t> all = {0, 1, 2, 3, 4};
  const auto found = crowded_points(triangles, all, 8, {}, 2);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].point, 0U);
  EXPECT_EQ(found[0].faces, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(found[1].point, 1U);
  EXPECT_EQ(found[1].faces, (std::vector<std::uint32_t>{3}));
  const std::vector<std::uint8_t> excluded = {1, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(crowded_points(triangles, all, 8, excluded, 2)[0].faces,
            (std::vector<std::uint32_t>{0, 1, 3}));
  EXPECT_TRUE(crowded_points(triangles, all, 8, {}, 3).empty());
}

/// A double pyramid over a jagged polygon: no axis sees all its faces from one side.
TriMesh jagged_bipyramid(std::uint32_t n) {
  TriMesh mesh;
  mesh.points = {{0, 0, 1}, {0, 0, -1}};
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    const double radius = 2 + i * 7919 % 13 / 13.0;
    mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    const std::uint32_t here = 2 + i, next = 2 + (i + 1) % n;
    mesh.triangles.push_back({0, here, next});
    mesh.triangles.push_back({1, next, here});
  }
  return mesh;
}

TEST(CrowdedPoints, tell_their_triangles_apart) {
  constexpr std::uint32_t kFaces = 10000;
  const TriMesh mesh = jagged_bipyramid(kFaces);
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  const auto crowded = crowded_points(mesh.triangles, all, mesh.points.size(), {}, 256);
  ASSERT_EQ(crowded.size(), 2U);
  const std::vector<std::uint8_t> degenerate(mesh.triangles.size(), 0);
  const auto boxes = direction_boxes(mesh.points, mesh.triangles, crowded[0], degenerate);
  ASSERT_EQ(boxes.size(), kFaces);
  const boxes::BoxTree tree{std::span<const boxes::Box>(boxes)};
  std::size_t pairs = 0;
  boxes::TreeTraversal(tree).visit([&](std::uint32_t, std::uint32_t) { ++pairs; });
  EXPECT_LT(pairs, 20U * kFaces);
}

TEST(CrowdedPoints, are_checked_in_a_moment) {
  const Report report = check(jagged_bipyramid(40000));  // minutes, if all pairs were looked at
  EXPECT_TRUE(report.is_solid());
}

TEST(CrowdedPoints, that_are_many_in_one_place_are_checked_in_a_moment) {
  std::vector<TriMesh> needles;
  for (int i = 0; i < 6000; ++i) {  // from the origin, side by side
    const double x = i % 80 - 39.5, y = i / 80 - 37.25;
    TriMesh needle = test::tetrahedron(Vec3::Zero(), 1);
    needle.points = {{0, 0, 0}, {x, y, 100}, {x + 0.75, y, 100}, {x, y + 0.75, 100}};
    needles.push_back(needle);
  }
  const TriMesh mesh = test::joined(needles);
  const Report report = check(mesh);
  EXPECT_EQ(report.count(Defect::self_intersection), 0U);
  EXPECT_EQ(report.count(Defect::contact), 1U);
}

}  // namespace
}  // namespace dupin::checking
