#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "mesh/shell_nesting.h"
#include "support/shapes.h"

namespace dupin::mesh {
namespace {

struct Box {
  std::array<int, 3> low, high;
};

bool is_within(const Box& inner, const Box& outer) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (inner.low[k] < outer.low[k] || inner.high[k] > outer.high[k]) {
      return false;
    }
  }
  return true;
}
bool are_apart(const Box& a, const Box& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.high[k] < b.low[k] || b.high[k] < a.low[k]) {
      return true;
    }
  }
  return false;
}
bool share_an_area(const Box& inner, const Box& outer) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (inner.low[k] == outer.low[k] || inner.high[k] == outer.high[k]) {
      return true;
    }
  }
  return false;
}

// Boxes one in another, and beside one another, in all numbers.
std::vector<Box> random_boxes(std::mt19937& random) {
  std::vector<Box> boxes;
  for (int attempt = 0; attempt < 400; ++attempt) {
    Box box{};
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = static_cast<int>(random() % 15);
      box.high[k] = box.low[k] + 1 + static_cast<int>(random() % (16U - box.low[k]));
    }
    const bool fits = std::ranges::all_of(boxes, [&](const Box& other) {
      return are_apart(box, other) ||
             ((is_within(box, other) || is_within(other, box)) && !share_an_area(box, other));
    });
    if (fits) {
      boxes.push_back(box);
    }
  }
  return boxes;
}

Vec3 vector(const std::array<int, 3>& v) { return Vec3(v[0], v[1], v[2]); }

TEST(ShellNesting, of_boxes_is_that_of_their_bounds) {
  std::mt19937 random(5);
  int nested = 0;
  for (int round = 0; round < 20; ++round) {
    const std::vector<Box> boxes = random_boxes(random);
    std::vector<TriMesh> meshes;
    for (const Box& box : boxes) {
      meshes.push_back(test::box(vector(box.low), vector(box.high)));
    }
    const TriMesh all = test::joined(meshes);
    const EdgeTable edges(all.triangles, all.points.size());
    const Shells found = shells(all.triangles.size(), edges);
    ASSERT_EQ(found.count, boxes.size());
    const MeshView mesh(all.points, all.triangles);
    const ShellNest nest(mesh, found);
    std::vector<int> depths(boxes.size());
    for (std::size_t inner = 0; inner < boxes.size(); ++inner) {
      for (std::size_t outer = 0; outer < boxes.size(); ++outer) {
        if (inner != outer) {
          const bool is_inner = is_within(boxes[inner], boxes[outer]);
          EXPECT_EQ(nest.encloses(outer, inner), is_inner);
          depths[inner] += is_inner ? 1 : 0;
          nested += is_inner ? 1 : 0;
        }
      }
    }
    EXPECT_EQ(nesting_depths(mesh, found), depths);
  }
  EXPECT_GT(nested, 20);
}

// The bounds of the frame contain what is in its hole.
TEST(ShellNesting, of_what_lies_in_a_hole_is_outside) {
  const TriMesh all = test::joined({test::frame(), test::box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}),
                                    test::box({-1.5, -2.5, -0.5}, {1.5, -1.5, 0.5})});
  const EdgeTable edges(all.triangles, all.points.size());
  const Shells found = shells(all.triangles.size(), edges);
  EXPECT_EQ(nesting_depths({all.points, all.triangles}, found), (std::vector<int>{0, 0, 1}));
}

// Comparing all pairs of boxes took most of the time of a check. A point that no face has may be
// anything.
TEST(ShellNesting, of_many_shells_takes_no_time_for_those_apart) {
  constexpr int kEdge = 32;
  std::vector<TriMesh> meshes;
  std::vector<int> expected;
  for (int i = 0; i < kEdge * kEdge * kEdge; ++i) {
    const Vec3 low(8 * (i % kEdge), 8 * (i / kEdge % kEdge), 8 * (i / kEdge / kEdge));
    for (int depth = 0; depth < 1 + i % 3; ++depth) {
      const Vec3 inset = Vec3::Constant(depth);
      meshes.push_back(test::box(low + inset, low + Vec3::Constant(7) - inset));
      expected.push_back(depth);
    }
  }
  TriMesh all = test::joined(meshes);
  all.points.push_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  const EdgeTable edges(all.triangles, all.points.size());
  const Shells found = shells(all.triangles.size(), edges);
  EXPECT_EQ(nesting_depths({all.points, all.triangles}, found), expected);
}

TEST(ShellNesting, holds_where_shells_touch_in_a_corner) {
  const TriMesh all =
      test::joined({test::box({0, 0, 0}, {8, 8, 8}), test::tetrahedron({0, 0, 0}, 1)});
  TriMesh inside = all;
  // A corner of the tetrahedron at that of the box, the rest within.
  inside.points[9] = Vec3(3, 1, 1);
  inside.points[10] = Vec3(1, 3, 1);
  inside.points[11] = Vec3(1, 1, 3);
  const EdgeTable edges(inside.triangles, inside.points.size());
  const Shells found = shells(inside.triangles.size(), edges);
  EXPECT_EQ(nesting_depths({inside.points, inside.triangles}, found), (std::vector<int>{0, 1}));
}

}  // namespace
}  // namespace dupin::mesh
