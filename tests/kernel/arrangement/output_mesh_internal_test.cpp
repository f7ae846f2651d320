#include <gtest/gtest.h>

#include "dupin/kernel/check.h"
#include "kernel/arrangement/stages_internal.h"

namespace dupin::arrangement {
namespace {

using test::cube;

mesh::ExactMesh arranged(const std::vector<TriMesh>& meshes, const BooleanRule& rule) {
  return test::arranged(test::solids_of(meshes), rule).exact();
}

TEST(Extract, copies_what_nothing_touches_in_its_order) {
  const TriMesh first = test::tube(1, 0, 2, 8), second = cube(5, 0, 0);
  const mesh::ExactMesh mesh = arranged({first, second}, union_rule(2));
  ASSERT_EQ(mesh.triangles.size(), first.triangles.size() + second.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto n = static_cast<std::uint32_t>(first.triangles.size());
    const TriMesh& from = t < n ? first : second;
    const Source source{t < n ? 0u : 1u, t < n ? t : t - n};
    EXPECT_EQ(mesh.sources[t], source);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(mesh.points[mesh.triangles[t][k]], from.points[from.triangles[source.triangle][k]]);
    }
  }
}

void expect_doubles_first(const mesh::ExactMesh& mesh) {
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    const mesh::ExactPoint p = mesh::exact_point(mesh, i);
    bool is_exact = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const mpq_class x = exact::rational(p[k]) / exact::rational(p[3]);
      EXPECT_EQ(mesh.points[i][static_cast<int>(k)], exact::nearest_double(x));
      is_exact = is_exact && x == mesh.points[i][static_cast<int>(k)];
    }
    EXPECT_EQ(is_exact, i < mesh.double_count());
  }
}

TEST(Extract, puts_the_points_that_doubles_hold_first) {
  const mesh::ExactMesh mesh =
      arranged({cube(0, 0, 0), test::slanted_tetrahedron()}, union_rule(2));
  ASSERT_FALSE(mesh.implicit.empty());
  expect_doubles_first(mesh);
  for (const auto& [name, solids] : test::meetings()) {
    SCOPED_TRACE(name);
    expect_doubles_first(arranged(solids, union_rule(solids.size())));
  }
}

// Coordinates of either sign, of one that is exact or of none, and next to powers of two, where
// the gaps to both neighbours differ.
TEST(Extract, has_the_nearest_doubles_of_pipes_wherever_they_lie) {
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(-7, -5, -3), Vec3(1, 2, 1024), Vec3(-1e9, 0.1, 3)}) {
    TriMesh across = test::tube(0.75, -3, 3, 32), pipe = test::tube(1, -3, 3, 24);
    for (Vec3& point : across.points) {
      point = Vec3(point[2], point[0] + 0.1, point[1]) + at;
    }
    for (Vec3& point : pipe.points) {
      point += at;
    }
    const mesh::ExactMesh mesh = arranged({pipe, across}, union_rule(2));
    ASSERT_GT(mesh.implicit.size(), 50u);
    expect_doubles_first(mesh);
  }
}

TEST(Extract, keeps_points_as_meetings_from_one_operation_to_the_next) {
  const Solid cut =
      test::arranged(test::solids_of({cube(0, 0, 0), test::slanted_tetrahedron()}), union_rule(2));
  const Solid again =
      test::arranged(std::vector{cut, test::solids_of({cube(50, 0, 0)}).front()}, union_rule(2));
  for (const Solid& solid : {cut, again}) {
    const mesh::ExactPoints& points = solid.exact().implicit;
    ASSERT_FALSE(points.empty());
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NE(points.meeting(i), nullptr) << i;
    }
  }
}

TEST(Extract, names_the_source_of_every_part) {
  for (const auto& [name, solids] : test::meetings()) {
    SCOPED_TRACE(name);
    const mesh::ExactMesh mesh = arranged(solids, union_rule(solids.size()));
    ASSERT_EQ(mesh.sources.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Source source = mesh.sources[t];
      const TriMesh& from = solids.at(source.operand);
      const Triangle& triangle = from.triangles.at(source.triangle);
      const Vec3 a = from.points[triangle[0]], b = from.points[triangle[1]],
                 c = from.points[triangle[2]];
      const std::array<Vec3, 3> plane{a, b, c};
      for (const std::uint32_t corner : mesh.triangles[t]) {
        // Exactly in the plane of the source.
        const mesh::ExactPoint p = mesh::exact_point(mesh, corner);
        const auto coordinate = [&p](std::size_t k) -> mpq_class {
          return exact::rational(p[k]) / exact::rational(p[3]);
        };
        std::array<std::array<mpq_class, 3>, 3> rows;
        for (std::size_t k = 0; k < 3; ++k) {
          const int i = static_cast<int>(k);
          rows[0][k] = mpq_class(plane[1][i]) - plane[0][i];
          rows[1][k] = mpq_class(plane[2][i]) - plane[0][i];
          rows[2][k] = coordinate(k) - plane[0][i];
        }
        mpq_class determinant;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
          determinant += rows[2][k] * (rows[0][i] * rows[1][j] - rows[0][j] * rows[1][i]);
        }
        EXPECT_EQ(determinant, 0);
      }
    }
  }
}

TEST(Extract, gives_each_umbrella_its_own_copy_of_a_point) {
  const struct {
    const char* description;
    std::vector<TriMesh> solids;
    std::size_t points, contacts;
  } table[] = {
      {"a vertex in common", {cube(0, 0, 0), cube(2, 2, 2)}, 16, 1},
      {"an edge in common", {cube(0, 0, 0), cube(2, 2, 0)}, 16, 1},
      {"a face in common", {cube(0, 0, 0), cube(2, 0, 0)}, 12, 0},
      {"two tetrahedra tip to tip",
       {test::tetrahedron(), test::reversed([] {
          TriMesh mesh = test::tetrahedron();
          for (Vec3& p : mesh.points) {
            p = -p;
          }
          return mesh;
        }())},
       8,
       1},
  };
  for (const auto& row : table) {
    SCOPED_TRACE(row.description);
    const mesh::ExactMesh mesh = arranged(row.solids, union_rule(2));
    EXPECT_EQ(mesh.points.size(), row.points);
    EXPECT_EQ(mesh.contacts.size(), row.contacts);
    const Report report = check(TriMesh{mesh.points, mesh.triangles, {}, {}});
    EXPECT_TRUE(report.closed());
    EXPECT_EQ(report.count(Defect::non_manifold_edge) + report.count(Defect::non_manifold_vertex),
              0);
  }
}

}  // namespace
}  // namespace dupin::arrangement
