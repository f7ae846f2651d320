#include <algorithm>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/check.h"
#include "kernel/rounding/edits/edit_fixture_internal.h"
#include "rounding/edits/edited_mesh.h"
#include "support/sequences.h"

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

// A plate of a quadrilateral b c a d, whose top is divided from a to b; a may be a notch, and
// lower.
TriMesh plate(const Vec3& a) {
  TriMesh mesh;
  for (const double z : {0., 1.}) {
    for (const Vec3& corner : {Vec3(3, 0, 0), Vec3(-1, 1, 0), a, Vec3(-1, -1, 0)}) {
      mesh.points.emplace_back(corner.x(), corner.y(), z > 0 ? z + corner.z() : z);
    }
  }
  mesh.triangles = {{4, 5, 6}, {4, 6, 7}, {0, 2, 1}, {0, 3, 2}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t next = (i + 1) % 4;
    mesh.triangles.push_back({i, next, next + 4});
    mesh.triangles.push_back({i, next + 4, i + 4});
  }
  return mesh;
}

// Two triangles that lie on each other beside their edge are gone once that is flipped.
TEST_F(Edit, flips_no_edge_of_what_is_folded_there) {
  shape = {};
  shape.points = {{-1, 0, 0}, {1, 0, 0}, {0, 3, 1e-6}, {0, 3, -1e-6}, {0, 6, 0}};
  shape.triangles = {{0, 1, 2}, {1, 4, 2}, {4, 0, 2}, {1, 0, 3}, {4, 1, 3}, {0, 4, 3}};
  ASSERT_TRUE(check(shape).is_solid());
  labels.assign(shape.triangles.size(), 0);
  representatives = support::numbers_below(shape.points.size());
  const auto flips = [this](double reach) {
    EditedMesh edited = mesh();
    return edited.flip(0, 2, {FaultRule::none, reach}) ||
           edited.flip(0, 0, {FaultRule::none, reach});
  };
  EXPECT_FALSE(flips(1e-5));
  EXPECT_FALSE(flips(2.99));
  EXPECT_TRUE(flips(3.01)) << "as far as they reach beside the new edge";
}

TEST_F(Edit, flips_no_triangle_out_of_a_notch) {
  const auto flips = [this](const Vec3& a, double reach) {
    shape = plate(a);
    EXPECT_TRUE(check(shape).is_solid());
    labels.assign(shape.triangles.size(), 0);
    representatives = support::numbers_below(shape.points.size());
    EditedMesh edited = mesh();
    return edited.flip(0, 2, {FaultRule::none, reach});
  };
  EXPECT_TRUE(flips({-2, 0, -1e-6}, 1e-5)) << "a convex one stays where it is";
  EXPECT_FALSE(flips({0, 0, -1e-6}, 0.99));
  EXPECT_TRUE(flips({0, 0, -1e-6}, 1.01)) << "as far as the notch is deep";
  EXPECT_TRUE(flips({-1 + 1e-3, 0, -1e-6}, 1.01e-3));
  EXPECT_FALSE(flips({-1 + 1e-3, 0, -1e-6}, 0.99e-3));
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

// As if the edits had been made here.
TEST_F(Edit, takes_over_what_was_made_of_a_part) {
  std::vector<std::uint32_t> faces, points;
  for (std::uint32_t f = 0; f < shape.triangles.size(); ++f) {
    if (std::ranges::none_of(shape.triangles[f], [](std::uint32_t v) { return v == 2; })) {
      faces.push_back(f);
    }
  }
  std::vector<std::uint32_t> number(shape.points.size(), 0);
  std::vector<std::uint8_t> complete;
  TriMesh some;
  for (std::uint32_t v = 0; v < shape.points.size(); ++v) {
    if (v != 2) {
      number[v] = static_cast<std::uint32_t>(points.size());
      points.push_back(v);
      some.points.push_back(shape.points[v]);
      const bool is_complete = std::ranges::none_of(shape.triangles, [&](const Triangle& t) {
        return std::ranges::find(t, v) != t.end() && std::ranges::find(t, 2U) != t.end();
      });
      complete.push_back(is_complete ? 1 : 0);
    }
  }
  for (const std::uint32_t f : faces) {
    const auto& [a, b, c] = shape.triangles[f];
    some.triangles.push_back({number[a], number[b], number[c]});
  }
  const std::vector<std::uint32_t> own(representatives.begin(),
                                       representatives.begin() + points.size());
  EditedMesh part(some.points, some.triangles, {}, own, complete), taken = mesh(), made = mesh();
  std::size_t edits = 0;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (int edge = 0; edge < 3 && part.alive(f); ++edge) {
      const std::uint32_t from = part.triangle(f)[edge], to = part.triangle(f)[(edge + 1) % 3];
      if (part.flip(f, edge, rule)) {
        ASSERT_TRUE(made.flip(faces[f], edge, rule));
        ++edits;
      } else if (part.collapse(from, to, rule)) {
        ASSERT_TRUE(made.collapse(points[from], points[to], rule));
        ++edits;
      }
    }
  }
  ASSERT_GT(edits, 2);
  taken.take_over(part, faces, points);
  EXPECT_EQ(taken.edits(), edits);
  ASSERT_EQ(result(taken).triangles, result(made).triangles);
  for (std::uint32_t v = 0; v < shape.points.size(); ++v) {
    EXPECT_EQ(taken.reach(v), made.reach(v));
    const auto around = [&](const EditedMesh& edited) {
      std::vector<std::uint32_t> all(edited.faces(v).begin(), edited.faces(v).end());
      std::ranges::sort(all);
      return all;
    };
    EXPECT_EQ(around(taken), around(made)) << v;
  }
  for (std::uint32_t f = 0; f < shape.triangles.size(); ++f) {
    EXPECT_EQ(taken.deviation(f), made.deviation(f));
    EXPECT_EQ(taken.parent(f), made.parent(f));
    EXPECT_EQ(taken.last_edit(f), made.last_edit(f));
  }
  EXPECT_EQ(taken.take_edited(), made.take_edited());
  EXPECT_TRUE(check(result(taken)).is_solid());
}

TEST_F(Edit, takes_over_moved_points_and_faults_of_a_part) {
  std::vector<std::uint32_t> points, faces;  // all but some at the end
  for (std::uint32_t f = 0; f + 4 < shape.triangles.size(); ++f) {
    faces.push_back(f);
    points.insert(points.end(), shape.triangles[f].begin(), shape.triangles[f].end());
  }
  support::sort_unique(points);
  ASSERT_EQ(points.size(), shape.points.size());
  EditedMesh part(shape.points, std::span(shape.triangles).first(faces.size()), {},
                  representatives);
  std::vector<Vec3> moved = shape.points;
  moved[0] = Vec3(0, 0, 5);  // through the top
  part.place(moved);
  part.find_faults(std::vector<std::uint8_t>(faces.size(), 1));
  const std::vector<Fault> faults = part.faults();
  ASSERT_FALSE(faults.empty());
  EditedMesh whole = mesh();
  whole.take_over(part, faces, points);
  EXPECT_TRUE(whole.faults() == faults);
  EXPECT_EQ(whole.point(0), moved[0]);
  EXPECT_EQ(whole.reach(0), (moved[0] - shape.points[0]).norm());
  EXPECT_EQ(whole.reach(1), 0);
  const std::vector<std::uint32_t> shell(faces.begin(), faces.end());
  part.remove(shell);
  EditedMesh removed = mesh();
  removed.take_over(part, faces, points);
  EXPECT_TRUE(removed.faults().empty());
  EXPECT_EQ(removed.alive_faces().size(), 4);
}

TEST(ThirdCorner, is_the_other_one) {
  EXPECT_EQ(third_corner({4, 7, 9}, 9, 4), 7);
  EXPECT_EQ(third_corner({4, 7, 9}, 7, 9), 4);
}

}  // namespace
}  // namespace dupin::rounding
