#include <gtest/gtest.h>

#include "remeshing/batch.h"
#include "support/shapes.h"
#include "workshop_internal.h"

namespace dupin::remeshing {
namespace {

using test::Bench;

/// Moves every point of a box by what a function says.
template <class Place>
EditKind moves(const WorkingMesh& mesh, const Place& place) {
  EditKind kind;
  kind.is_at_points = true;
  kind.collect = [&](std::uint32_t v, std::vector<Candidate>& found) {
    found.push_back({double(v), v, v});
  };
  kind.claim = [&](const Candidate& at) {
    Claim claim{{}, {at.from}, mesh.neighbours(at.from)};
    claim.faces.assign(mesh.around(at.from).begin(), mesh.around(at.from).end());
    claim.marks.push_back(at.from);
    return claim;
  };
  kind.build = [&](const Candidate& at) -> std::optional<Edit> {
    Edit edit;
    edit.before.assign(mesh.around(at.from).begin(), mesh.around(at.from).end());
    for (const std::uint32_t f : edit.before) {
      edit.after.push_back(mesh.face(f));
    }
    edit.moved = {at.from, place(at.from)};
    return edit;
  };
  return kind;
}

TEST(Pass, makes_edits_that_do_not_touch_each_other) {
  Bench bench(dupin::test::box(Vec3::Zero(), Vec3(1, 1, 1)), {0.01, 1, 0.01});
  const WorkingMesh& mesh = bench.working;
  const std::size_t made = Pass(bench.working).round(moves(mesh, [&](std::uint32_t v) {
    return Vec3(1.25 * mesh.place(v));
  }));
  EXPECT_GE(made, 1U);
  EXPECT_LT(made, 8U);
}

TEST(Pass, takes_back_what_makes_faces_cross) {
  Bench bench(dupin::test::box(Vec3::Zero(), Vec3(1, 1, 1)), {0.01, 1, 0.01});
  const WorkingMesh& mesh = bench.working;
  const auto before = mesh.compact().first.points;
  const std::size_t made = Pass(bench.working).round(moves(mesh, [&](std::uint32_t v) {
    return Vec3(Vec3(3, 3, 3) - 4 * mesh.place(v));
  }));
  EXPECT_EQ(made, 0U);
  EXPECT_EQ(mesh.compact().first.points, before);
}

}  // namespace
}  // namespace dupin::remeshing
