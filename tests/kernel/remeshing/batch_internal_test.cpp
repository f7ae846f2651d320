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
  kind.places = mesh.point_count();
  kind.collect = [&](std::uint32_t v, std::vector<Candidate>& found) {
    Candidate candidate{double(v), v, v, {}, {v}, mesh.neighbours(v)};
    candidate.faces.assign(mesh.around(v).begin(), mesh.around(v).end());
    candidate.marks.push_back(v);
    found.push_back(std::move(candidate));
  };
  kind.build = [&](const Candidate& at) -> std::optional<Edit> {
    Edit edit;
    edit.before = at.faces;
    for (const std::uint32_t f : at.faces) {
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
