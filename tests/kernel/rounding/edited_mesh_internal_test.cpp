#include <numeric>

#include <gtest/gtest.h>

#include "dupin/kernel/check.h"
#include "kernel/rounding/edit_fixture_internal.h"
#include "rounding/edited_mesh.h"

namespace dupin::rounding {
namespace {

TEST_F(Edit, collapses_keep_a_solid_until_none_is_possible) {
  EditedMesh tube = mesh();
  std::size_t collapses = 0;
  for (bool any = true; any;) {
    any = false;
    for (std::uint32_t f = 0; f < tube.face_count() && !any; ++f) {
      for (int edge = 0; edge < 3 && tube.alive(f) && !any; ++edge) {
        const Triangle t = tube.triangle(f);
        any = tube.collapse(t[edge], t[(edge + 1) % 3], rule);
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
  rule.reach = length * 0.999;
  EXPECT_FALSE(tube.collapse(t[0], t[1], rule));
  EXPECT_FALSE(tube.move(t[0], tube.point(t[1]), rule));
  rule.reach = length * 1.001;
  EXPECT_TRUE(tube.collapse(t[0], t[1], rule));
  EXPECT_GE(tube.reach(t[1]), length);
}

TEST_F(Edit, that_makes_the_mesh_worse_is_refused) {
  EditedMesh tube = mesh();
  EXPECT_FALSE(tube.move(0, Vec3(0, 0, 5), rule)) << "a bottom corner through the top";
  EXPECT_TRUE(tube.move(0, Vec3(1.5, 0, 0), rule));
  EXPECT_TRUE(check(result(tube)).is_solid());
}

TEST_F(Edit, leaves_points_of_contacts_alone) {
  representatives[1] = 0;
  EditedMesh tube = mesh();
  EXPECT_FALSE(tube.move(0, Vec3(1.5, 0, 0), rule));
  EXPECT_FALSE(tube.move(1, Vec3(1.5, 0, 0), rule));
  EXPECT_TRUE(tube.move(2, tube.point(2) * 1.25, rule));
}

TEST_F(Edit, lets_one_point_of_a_contact_take_the_place_of_another) {
  representatives[1] = 0;
  EditedMesh apart = mesh();
  EXPECT_FALSE(apart.collapse(1, 0, rule)) << "they are not in one place";
  shape.points[1] = shape.points[0];
  EditedMesh tube = mesh();
  tube.find_faults(std::vector<std::uint8_t>(shape.triangles.size(), 1));
  EXPECT_FALSE(tube.faults().empty());
  EXPECT_TRUE(tube.collapse(1, 0, rule));
  EXPECT_TRUE(check(result(tube)).is_solid());
}

TEST_F(Edit, gives_no_area_to_another_class) {
  std::iota(labels.begin(), labels.end(), 0);
  EditedMesh tube = mesh();
  rule.reach = 1e-3;
  for (std::uint32_t f = 0; f < tube.face_count(); ++f) {
    for (int edge = 0; edge < 3; ++edge) {
      EXPECT_FALSE(tube.flip(f, edge, rule)) << f;
    }
  }
  std::ranges::fill(labels, 0);
  EditedMesh plain = mesh();
  std::size_t flips = 0;
  for (std::uint32_t f = 0; f < plain.face_count(); ++f) {
    for (int edge = 0; edge < 3; ++edge) {
      flips += plain.flip(f, edge, rule) ? 1 : 0;
    }
  }
  EXPECT_GT(flips, 0) << "within a flat end or side";
  EXPECT_TRUE(check(result(plain)).is_solid());
}

TEST_F(Edit, finds_the_faces_around_points_after_any_edits) {
  EditedMesh tube = mesh();
  for (std::uint32_t f = 0; f < tube.face_count(); ++f) {
    if (tube.alive(f)) {
      const Triangle t = tube.triangle(f);
      tube.flip(f, static_cast<int>(f % 3), rule);
      tube.collapse(t[f % 3], t[(f + 1) % 3], rule);
    }
  }
  std::vector<std::vector<std::uint32_t>> around(shape.points.size());
  std::size_t alive = 0;
  for (std::uint32_t f = 0; f < tube.face_count(); ++f) {
    for (int k = 0; k < 3 && tube.alive(f); ++k) {
      const Triangle& t = tube.triangle(f);
      around[t[k]].push_back(f);
      EXPECT_EQ(tube.face_with_edge(t[k], t[(k + 1) % 3]), f);
    }
    alive += tube.alive(f) ? 1 : 0;
  }
  ASSERT_LT(alive, shape.triangles.size());
  for (std::uint32_t v = 0; v < shape.points.size(); ++v) {
    std::vector<std::uint32_t> known(tube.faces(v).begin(), tube.faces(v).end());
    std::ranges::sort(known);
    EXPECT_EQ(known, around[v]) << v;
  }
  EXPECT_EQ(tube.alive_faces().size(), alive);
}

TEST(ThirdCorner, is_the_other_one) {
  EXPECT_EQ(third_corner({4, 7, 9}, 9, 4), 7);
  EXPECT_EQ(third_corner({4, 7, 9}, 7, 9), 4);
}

}  // namespace
}  // namespace dupin::rounding
