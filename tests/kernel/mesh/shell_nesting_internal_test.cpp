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

// Askew to the axes, each is within the bounds of all longer ones.
TEST(ShellNesting, of_long_rods_side_by_side_asks_few) {
  std::vector<TriMesh> rods;
  for (int i = 0; i < 400; ++i) {
    TriMesh rod = test::box({0, 0, i - 2000.}, {1, 1, 2000. - i});
    const Vec3 place(2 * (i % 20), i / 20 * 2, 0);
    for (Vec3& p : rod.points) {
      p += place;
      p = p.x() * Vec3(2, -1, 0) + p.y() * Vec3(1, 2, -5) + p.z() * Vec3(1, 2, 1);
    }
    rods.push_back(rod);
  }
  const TriMesh all = test::joined(rods);
  const EdgeTable edges(all.triangles, all.points.size());
  const Shells found = shells(all.triangles.size(), edges);
  ASSERT_EQ(found.count, 400U);
  const MeshView mesh(all.points, all.triangles);
  EXPECT_EQ(nesting_depths(mesh, found), std::vector<int>(400));
  const ShellNest nest(mesh, found);
  std::size_t in_bounds = 0, asked = 0;
  for (std::size_t inner = 0; inner < found.count; ++inner) {
    for (const Eigen::AlignedBox3d& box : nest.boxes()) {
      in_bounds += box.contains(nest.boxes()[inner]) ? 1 : 0;
    }
    nest.visit_boxes_around(inner, 0, [&](std::size_t) { ++asked; });
  }
  EXPECT_GT(in_bounds, 10000U);
  EXPECT_LT(asked, 10U);
}

// Their boxes along the main directions, with the rounding of these, are in each other still.
TEST(ShellNesting, holds_in_any_direction) {
  std::mt19937 random(8);
  for (int round = 0; round < 200; ++round) {
    const auto below = [&](unsigned n) { return double(random() % n); };
    const Vec3 u(1 + below(9), below(9), below(9)), v(below(9), -1 - below(9), below(9));
    const Vec3 w = u.cross(v);
    if (w.norm() == 0) {
      continue;
    }
    std::vector<TriMesh> nested;
    for (int depth = 0; depth < 6; ++depth) {
      const Vec3 inset = Vec3::Constant(depth * 0x1p-30);
      TriMesh box = test::box(inset, Vec3(4, 8, 256) - inset);
      for (Vec3& p : box.points) {
        p = p.x() * u + p.y() * v + p.z() * w;
      }
      nested.push_back(box);
    }
    const TriMesh all = test::joined(nested);
    const EdgeTable edges(all.triangles, all.points.size());
    const Shells found = shells(all.triangles.size(), edges);
    EXPECT_EQ(nesting_depths({all.points, all.triangles}, found),
              (std::vector<int>{0, 1, 2, 3, 4, 5}));
  }
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
