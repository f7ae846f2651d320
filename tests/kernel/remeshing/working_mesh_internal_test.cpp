#include <gtest/gtest.h>

#include "remeshing/working_mesh.h"
#include "support/shapes.h"
#include "workshop_internal.h"

namespace dupin::remeshing {
namespace {

using dupin::test::box;
using test::Bench;

TEST(WorkingMesh, is_as_before_when_an_edit_is_undone) {
  Bench bench(box(Vec3::Zero(), Vec3(1, 1, 1)), {0.01, 1, 0.01});
  WorkingMesh& mesh = bench.working;
  const Face face = mesh.face(0);
  const auto& [a, b, c] = face.corners;
  Edit edit{{0}, {}, WorkingPoint{(mesh.place(a) + mesh.place(b) + mesh.place(c)) / 3}, {}};
  for (int i = 0; i < 3; ++i) {
    edit.after.push_back({{face.corners[i], face.corners[(i + 1) % 3], kAdded}});
  }
  const std::size_t around = mesh.around(a).size();
  const Applied applied = mesh.apply(edit);
  EXPECT_EQ(mesh.alive_count(), 14U);
  EXPECT_TRUE(mesh.faulty(applied.after).empty());
  EXPECT_EQ(mesh.neighbours(applied.added).size(), 3U);
  mesh.undo(applied);
  EXPECT_EQ(mesh.alive_count(), 12U);
  EXPECT_EQ(mesh.around(a).size(), around);
  EXPECT_EQ(mesh.face(0).corners, face.corners);
  EXPECT_FALSE(mesh.is_used(applied.added));
  EXPECT_EQ(mesh.compact().first.points.size(), 8U);
}

TEST(WorkingMesh, finds_what_a_move_makes_cross) {
  Bench bench(box(Vec3::Zero(), Vec3(1, 1, 1)), {0.01, 1, 0.01});
  WorkingMesh& mesh = bench.working;
  Edit edit;
  edit.before.assign(mesh.around(0).begin(), mesh.around(0).end());
  for (const std::uint32_t f : edit.before) {
    edit.after.push_back(mesh.face(f));
  }
  edit.moved = {0, Vec3(2, 2, 2)};
  const Applied applied = mesh.apply(edit);
  EXPECT_FALSE(mesh.faulty(applied.after).empty());
  mesh.undo(applied);
  std::vector<std::uint32_t> all(mesh.face_count());
  for (std::uint32_t f = 0; f < all.size(); ++f) {
    all[f] = f;
  }
  EXPECT_TRUE(mesh.faulty(all).empty());
}

TEST(WorkingMesh, grades_sizes) {
  Bench bench(dupin::test::tube(1, 0, 8, 16), {0.01, 4, 0.01});
  WorkingMesh& mesh = bench.working;
  mesh.point(0).wish = 0.1;
  mesh.grade_sizes(0.25);
  EXPECT_EQ(mesh.point(0).size, 0.1);
  for (std::uint32_t v = 0; v < mesh.point_count(); ++v) {
    for (const std::uint32_t w : mesh.neighbours(v)) {
      EXPECT_LE(mesh.point(w).size, mesh.point(v).size + 0.25 * mesh.length(v, w) + 1e-12);
    }
  }
}

}  // namespace
}  // namespace dupin::remeshing
