#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "kernel/rounding/edits/edit_fixture_internal.h"
#include "kernel/torus.h"
#include "rounding/edits/mesh_part.h"

namespace dupin::rounding {
namespace {

/// Some triangles of a fine torus, whose points have six each, that are to be repaired, and those
/// around them.
struct Part : Edit {
  Part() : Edit(test::torus(24, 48, 2, 1)) {}
  std::optional<MeshPart> around(const std::vector<std::uint32_t>& broken) {
    const BrokenMesh whole{shape.points, shape.points, shape.triangles, labels, representatives};
    return MeshPart::around(whole, broken, 1e-4, 1e-5);
  }
  [[nodiscard]] TriMesh labelled() const { return {shape.points, shape.triangles, labels}; }
};

TEST_F(Part, has_all_triangles_of_its_complete_points) {
  const auto part = around({100, 101});
  ASSERT_TRUE(part);
  EXPECT_LT(part->faces().size(), shape.triangles.size() / 4);
  EXPECT_EQ(part->faces()[part->face(100)], 100);
  std::vector<std::size_t> in_whole(shape.points.size(), 0), in_part(shape.points.size(), 0);
  for (const Triangle& t : shape.triangles) {
    std::ranges::for_each(t, [&](std::uint32_t v) { ++in_whole[v]; });
  }
  for (const std::uint32_t f : part->faces()) {
    std::ranges::for_each(shape.triangles[f], [&](std::uint32_t v) { ++in_part[v]; });
  }
  const BrokenMesh view = part->view();
  std::size_t complete = 0;
  for (std::uint32_t v = 0; v < part->points().size(); ++v) {
    const std::uint32_t point = part->points()[v];
    EXPECT_EQ(view.doubles[v], shape.points[point]);
    if (view.complete[v] != 0) {
      EXPECT_EQ(in_part[point], in_whole[point]);
      ++complete;
    }
  }
  EXPECT_GT(complete, 3);
  EXPECT_LT(complete, part->points().size());
}

TEST_F(Part, is_edited_where_no_other_triangle_is_near) {
  const auto part = around({100});
  ASSERT_TRUE(part);
  const BrokenMesh view = part->view();
  EditedMesh mesh(view.doubles, view.triangles, view.labels, view.representatives, view.complete);
  const auto move = [&](std::uint32_t v) {
    return mesh.move(v, mesh.point(v) + Vec3(0, 0, 1e-5), rule);
  };
  for (const std::uint32_t v : view.triangles[part->face(100)]) {
    EXPECT_TRUE(move(v));
  }
  for (std::uint32_t v = 0; v < view.complete.size(); ++v) {
    if (view.complete[v] == 0) {
      EXPECT_FALSE(move(v));
    }
  }
}

TEST_F(Part, is_not_taken_if_it_would_be_the_most) {
  std::vector<std::uint32_t> many(shape.triangles.size() / 2);
  std::iota(many.begin(), many.end(), 0U);
  EXPECT_FALSE(around(many));
}

TEST_F(Part, goes_back_to_where_it_came_from) {
  const auto part = around({100});
  ASSERT_TRUE(part);
  const BrokenMesh view = part->view();
  EditedMesh mesh(view.doubles, view.triangles, view.labels, view.representatives, view.complete);
  const std::uint32_t moved = view.triangles[part->face(100)][0];
  ASSERT_TRUE(mesh.move(moved, mesh.point(moved) + Vec3(0, 0, 1e-5), rule));
  TriMesh whole = labelled();
  std::vector<Source> sources;
  for (std::uint32_t f = 0; f < shape.triangles.size(); ++f) {
    sources.push_back({3, f});
  }
  const std::vector<Source> before = sources;
  part->put(mesh, whole, sources);
  EXPECT_EQ(whole.triangles, shape.triangles);
  EXPECT_EQ(whole.labels, labels);
  EXPECT_EQ(sources, before);
  const std::uint32_t point = part->points()[moved];
  for (std::uint32_t v = 0; v < shape.points.size(); ++v) {
    EXPECT_EQ(whole.points[v], shape.points[v] + (v == point ? Vec3(0, 0, 1e-5) : Vec3(0, 0, 0)));
  }
  EXPECT_FALSE(part->meets_rest(mesh, {whole.points, whole.triangles, representatives}));
  part->put_back(whole.points);
  EXPECT_EQ(whole.points, shape.points);
}

TEST_F(Part, tells_when_an_edit_reaches_beyond_it) {
  const auto part = around({100});
  ASSERT_TRUE(part);
  const BrokenMesh view = part->view();
  EditedMesh mesh(view.doubles, view.triangles, view.labels, view.representatives, view.complete);
  // Straight through the torus, which the part has no triangles of on its other side.
  const std::uint32_t moved = view.triangles[part->face(100)][0];
  const Vec3 far = -mesh.point(moved);
  rule.faults = FaultRule::none;
  if (mesh.move(moved, far, rule)) {
    TriMesh whole = labelled();
    std::vector<Source> sources(shape.triangles.size());
    part->put(mesh, whole, sources);
    EXPECT_TRUE(part->meets_rest(mesh, {whole.points, whole.triangles, representatives}));
  } else {
    ADD_FAILURE() << "the part's own triangles do not stand in the way";
  }
}

TEST(ErasePoints, leaves_the_others_in_order) {
  TriMesh mesh;
  for (int i = 0; i < 9; ++i) {
    mesh.points.emplace_back(i, 0, 0);
  }
  mesh.triangles = {{1, 4, 8}, {2, 7, 4}};
  const std::vector<std::uint32_t> unused = {0, 3, 5, 6};
  erase_points(unused, mesh);
  std::vector<double> left;
  std::ranges::transform(mesh.points, std::back_inserter(left),
                         [](const Vec3& p) { return p.x(); });
  EXPECT_EQ(left, (std::vector<double>{1, 2, 4, 7, 8}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 2, 4}, {1, 3, 2}}));
}

}  // namespace
}  // namespace dupin::rounding
