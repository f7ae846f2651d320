#include <cstdint>
#include <vector>

#include "arrangement/face_crossings.h"
#include "kernel/arrangement/stages_internal.h"
#include "support/pipe_cases.h"
#include "support/shapes.h"

namespace dupin::arrangement {
namespace {

// The first triangle of the first operand with all of the others.
std::vector<TrianglePair> pairs_of_first(const ArrangementInput& input) {
  std::vector<TrianglePair> pairs;
  for (auto t = input.first_triangle[1]; t < input.triangles.size(); ++t) {
    pairs.push_back({0, t});
  }
  return pairs;
}

double crossings_of(const std::vector<TriMesh>& meshes) {
  const test::Stages stages(meshes);
  return crossings_per_face(stages.input, stages.candidates());
}

// Boards cut a large triangle in two lines each; where the diagonals of their sides are is no
// matter. What ends beyond the triangle crosses nothing there.
TEST(FaceCrossings, of_boards_in_a_triangle_are_those_of_their_sides) {
  TriMesh large;
  large.points = {Vec3(-20, -20, 0), Vec3(40, -20, 0), Vec3(-20, 40, 0), Vec3(0, 0, -30)};
  large.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  std::vector<TriMesh> meshes = {large};
  for (const double x : {0.0, 3.0}) {
    meshes.push_back(test::box(Vec3(x, -1, -1), Vec3(x + 1, 9, 1.5)));
  }
  meshes.push_back(test::box(Vec3(-1, 2, -1.5), Vec3(7, 2.5, 1)));
  const auto count = [&meshes] {
    const test::Stages stages(meshes);
    return crossings_per_face(stages.input, pairs_of_first(stages.input));
  };
  EXPECT_EQ(count(), 8);
  meshes.push_back(test::box(Vec3(-1, 50, -1.5), Vec3(7, 51, 1)));
  EXPECT_EQ(count(), 8);
  for (TriMesh& mesh : meshes) {
    for (Vec3& point : mesh.points) {
      point = Vec3(point.z() + 1e5, point.x() - 2e5, point.y());
    }
  }
  EXPECT_EQ(count(), 8);
}

TEST(FaceCrossings, are_few_where_lines_have_one_point_in_common) {
  EXPECT_EQ(crossings_of(test::pipe_case("star_9")), 0);
  EXPECT_LT(crossings_of(test::pipe_case("star_general_7")), 3);
  const double few = crossings_of(test::pipe_case("coaxial_5"));
  const double many = crossings_of(test::pipe_case("coaxial_9"));
  EXPECT_GT(few, 1);
  EXPECT_GT(many, 2 * few);
}

TEST(FaceCrossings, are_none_without_candidates) {
  const test::Stages stages({test::box(Vec3(0, 0, 0), Vec3(1, 1, 1))});
  EXPECT_EQ(crossings_per_face(stages.input, {}), 0);
}

}  // namespace
}  // namespace dupin::arrangement
