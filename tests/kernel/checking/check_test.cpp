#include "dupin/kernel/check.h"

#include <array>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/message_of.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using test::box;
using test::joined;
using test::reversed;
using test::tetrahedron;

constexpr std::size_t kDefectCount = static_cast<std::size_t>(Defect::isolated_point) + 1;

TriMesh with_points(TriMesh mesh, std::initializer_list<Vec3> points) {
  mesh.points.insert(mesh.points.end(), points.begin(), points.end());
  return mesh;
}

TriMesh with_faces(TriMesh mesh, std::initializer_list<Triangle> faces) {
  mesh.triangles.insert(mesh.triangles.end(), faces.begin(), faces.end());
  return mesh;
}

// The point reflection of the tetrahedron about its corner in the origin.
TriMesh opposite_tetrahedron() { return reversed(tetrahedron(Vec3::Zero(), -1)); }

TriMesh sharing_a_point() {
  const TriMesh other = opposite_tetrahedron();
  TriMesh mesh = with_points(tetrahedron(), {other.points[1], other.points[2], other.points[3]});
  for (Triangle corners : other.triangles) {
    for (std::uint32_t& corner : corners) {
      corner += corner == 0 ? 0 : 3;
    }
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

TriMesh sharing_an_edge() {
  const TriMesh mesh = with_points(tetrahedron(), {Vec3(-1, 0, 0), Vec3(0, -1, 0)});
  return with_faces(mesh, {{0, 5, 4}, {0, 4, 3}, {4, 5, 3}, {5, 0, 3}});
}

TriMesh broken_point() {
  TriMesh mesh = tetrahedron();
  mesh.points[3].z() = std::numeric_limits<double>::quiet_NaN();
  return mesh;
}

TriMesh far_point() {
  TriMesh mesh = tetrahedron();
  mesh.points[3].z() = 1e40;
  return mesh;
}

TriMesh one_face_flipped() {
  TriMesh mesh = tetrahedron();
  std::swap(mesh.triangles[2][0], mesh.triangles[2][1]);
  return mesh;
}

TriMesh without_last_face(TriMesh mesh) {
  mesh.triangles.pop_back();
  return mesh;
}

TriMesh pillow() {
  TriMesh mesh;
  mesh.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
  return mesh;
}

struct Provoked {
  Defect defect;
  const char* description;
  TriMesh mesh;
  std::size_t count;
  std::string sentence;  // about the first finding
};

std::vector<Provoked> provoked() {
  const TriMesh shifted = tetrahedron(Vec3(0.1, 0.1, 0.1));
  return {
      {Defect::non_finite_point, "NaN", broken_point(), 1,
       "point 3 has coordinates that are not finite numbers: (0, 0, nan)"},
      {Defect::point_out_of_range, "a far point", far_point(), 1,
       "point 3 has the z coordinate 1e+40, which must be 0 or from 1e-60 to 1e+39 in size"},
      {Defect::bad_index, "index past the end", with_faces(tetrahedron(), {{0, 1, 7}}), 1,
       "face 4 refers to point 7, but there are only 4 points"},
      {Defect::degenerate_face, "repeated index", with_faces(tetrahedron(), {{0, 1, 1}}), 1,
       "face 4 at (0, 0, 0) has no area: its corners lie on one line"},
      {Defect::duplicate_face, "two faces back to back", pillow(), 1,
       "faces 0 and 1 at (0, 0, 0) have the same three corners"},
      {Defect::boundary_edge, "a face is missing", without_last_face(tetrahedron()), 3,
       "the edge from (0, 0, 0) to (0, 1, 0) belongs to face 0 only"},
      {Defect::non_manifold_edge, "two tetrahedra share an edge", sharing_an_edge(), 1,
       "the edge from (0, 0, 0) to (0, 0, 1) is shared by faces 1, 3, 5 and 7"},
      {Defect::non_manifold_vertex, "two tetrahedra share a point", sharing_a_point(), 1,
       "faces 0, 1, 3, 4, 5 and 7 meet in point 0 at (0, 0, 0) but do not hang together by edges "
       "there"},
      {Defect::inconsistent_orientation, "a face is turned", one_face_flipped(), 3,
       "faces 0 and 2 run along the edge from (1, 0, 0) to (0, 1, 0) in the same direction"},
      {Defect::self_intersection, "the corner of one pokes through a face of the other",
       joined({tetrahedron(), shifted}), 3, "faces 2 and 4 intersect near (0.55, 0.55, 0.1)"},
      {Defect::contact, "two tetrahedra touch in a point",
       joined({tetrahedron(), opposite_tetrahedron()}), 1,
       "faces 0, 1, 3, 4, 5 and 7 touch in (0, 0, 0) without sharing it"},
      {Defect::inside_out_component, "all faces turned", reversed(tetrahedron()), 1,
       "the shell of faces 0, 1, 2 and 3 at (0, 0, 0) is inside out"},
      {Defect::isolated_point, "a point too many", with_points(tetrahedron(), {Vec3(5, 5, 5)}), 1,
       "point 4 at (5, 5, 5) belongs to no face"},
  };
}

TEST(Check, finds_each_defect_alone) {
  const auto table = provoked();
  ASSERT_EQ(table.size(), kDefectCount);
  for (const Provoked& row : table) {
    SCOPED_TRACE(row.description);
    const Report report = check(row.mesh);
    for (std::size_t i = 0; i < kDefectCount; ++i) {
      const auto defect = static_cast<Defect>(i);
      EXPECT_EQ(report.count(defect), defect == row.defect ? row.count : 0) << name(defect);
    }
    ASSERT_EQ(report.findings.size(), row.count);
    EXPECT_EQ(describe(report.findings[0], row.mesh), row.sentence);
    EXPECT_EQ(report.is_solid(), !is_fatal(row.defect));
  }
}

TEST(Check, keeps_findings_up_to_the_limit_and_counts_all) {
  const Report report = check(without_last_face(tetrahedron()), {.limit = 2});
  EXPECT_EQ(report.count(Defect::boundary_edge), 3U);
  EXPECT_EQ(report.findings.size(), 2U);
}

TEST(Check, leaves_out_self_intersections_when_asked) {
  const TriMesh crossing = joined({tetrahedron(), tetrahedron(Vec3::Constant(0.1))});
  EXPECT_TRUE(check(crossing, {.self_intersections = false}).is_solid());
  EXPECT_FALSE(check(crossing).is_solid());
}

TEST(Check, counts_all_that_is_wrong_at_once) {
  TriMesh mesh = joined({tetrahedron(), tetrahedron(Vec3(4, 0, 0)), pillow()});
  mesh.points.emplace_back(7, 7, 7);
  mesh.triangles.pop_back();                                 // boundary
  mesh.triangles.insert(mesh.triangles.end(), {{0, 1, 99},   // bad index
                                               {4, 5, 5},    // repeated index
                                               {0, 2, 1}});  // face 0 again
  const Report report = check(mesh);
  EXPECT_EQ(report.count(Defect::bad_index), 1U);
  EXPECT_EQ(report.count(Defect::degenerate_face), 1U);
  EXPECT_EQ(report.count(Defect::duplicate_face), 1U);
  EXPECT_EQ(report.count(Defect::non_manifold_edge), 3U);
  EXPECT_EQ(report.count(Defect::boundary_edge), 3U);
  EXPECT_EQ(report.count(Defect::isolated_point), 1U);
  EXPECT_EQ(report.points, 12U);
  EXPECT_EQ(report.triangles, 12U);
}

TEST(Check, faces_on_one_line_given_twice_are_degenerate) {
  TriMesh mesh;
  mesh.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
  const Report report = check(mesh);
  EXPECT_EQ(report.count(Defect::degenerate_face), 2U);
  EXPECT_EQ(report.count(Defect::self_intersection), 0U);
}

TEST(Check, an_empty_mesh_is_the_empty_solid) {
  const Report report = check({});
  EXPECT_TRUE(report.is_solid());
  EXPECT_EQ(report.components, 0U);
}

TEST(Check, coordinates_may_be_huge_or_tiny) {
  for (const double size : {2e-60, 1e-45, 1e-30, 1e20, 1e39}) {
    SCOPED_TRACE(size);
    const Report report =
        check(joined({box(Vec3::Constant(-size), Vec3::Constant(size)),
                      reversed(box(Vec3::Constant(-size / 2), Vec3::Constant(size / 2)))}));
    EXPECT_TRUE(report.is_solid());
    EXPECT_EQ(report.components, 1U);
  }
}

// Few points on a small grid, so that all kinds of faults come together.
TriMesh random_mesh(std::mt19937_64& random) {
  const double odd_ones[] = {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(),
                             1e308,
                             -1e308,
                             5e-324,
                             -0.0};
  TriMesh mesh;
  const std::size_t points = random() % 9;
  for (std::size_t i = 0; i < points; ++i) {
    Vec3& point = mesh.points.emplace_back();
    for (double& coordinate : point) {
      coordinate = random() % 60 == 0 ? odd_ones[random() % 6] : static_cast<double>(random() % 3);
    }
  }
  const std::size_t faces = random() % 14;
  for (std::size_t i = 0; i < faces; ++i) {
    Triangle& corners = mesh.triangles.emplace_back();
    for (std::uint32_t& corner : corners) {
      corner = static_cast<std::uint32_t>(random() % (points + (random() % 40 == 0 ? 1 : 0) + 1));
      corner = corner == points && random() % 8 != 0 ? 0 : corner;
    }
  }
  return mesh;
}

TEST(Check, survives_any_mesh) {
  std::mt19937_64 random(2718);
  std::array<std::size_t, kDefectCount> seen{};
  for (int i = 0; i < 5000; ++i) {
    const TriMesh mesh = random_mesh(random);
    const Report report = check(mesh);
    EXPECT_LT(report.count(Defect::self_intersection),
              mesh.triangles.size() * mesh.triangles.size() + 1);  // pairs
    for (const Finding& finding : report.findings) {
      ++seen[static_cast<std::size_t>(finding.defect)];
      EXPECT_NE(describe(finding, mesh), "");
    }
  }
  // Contacts and wrong orientation of whole shells need closed surfaces: chance makes none.
  for (const Defect defect :
       {Defect::non_finite_point, Defect::bad_index, Defect::degenerate_face,
        Defect::duplicate_face, Defect::boundary_edge, Defect::non_manifold_edge,
        Defect::non_manifold_vertex, Defect::inconsistent_orientation, Defect::self_intersection,
        Defect::isolated_point}) {
    EXPECT_GT(seen[static_cast<std::size_t>(defect)], 100U) << name(defect);
  }
}

TEST(Check, describes_findings_of_the_mesh_only) {
  for (const Provoked& row : provoked()) {
    const Report report = check(row.mesh);
    Finding finding = report.findings[0];
    EXPECT_NO_THROW((void)describe(finding, row.mesh));
    const bool is_told_by_points =
        describe(finding, row.mesh).find("point ") != std::string::npos ||
        describe(finding, row.mesh).find("edge ") != std::string::npos;
    finding.points.clear();
    if (is_told_by_points) {
      EXPECT_EQ(
          test::message_of([&] { (void)describe(finding, row.mesh); }, Errc::invalid_argument),
          "the finding names too few points")
          << row.description;
    }
  }
  const Report report = check(without_last_face(tetrahedron()));
  EXPECT_EQ(
      test::message_of([&] { (void)describe(report.findings[0], {}); }, Errc::invalid_argument),
      "the finding is one of another mesh: it names point 2 of 0");
}

TEST(Check, reports_shells_and_their_nesting) {
  const TriMesh mesh = joined({box(Vec3::Zero(), Vec3::Constant(9)),
                               reversed(box(Vec3::Constant(1), Vec3::Constant(8))),
                               box(Vec3::Constant(2), Vec3::Constant(4)), test::frame()});
  TriMesh apart = mesh;
  for (std::size_t i = 24; i < apart.points.size(); ++i) {
    apart.points[i] += Vec3(20, 0, 0);
  }
  const Report report = check(apart);
  ASSERT_TRUE(report.is_solid());
  ASSERT_EQ(report.shells.size(), 4U);
  const ShellReport expected[] = {
      {0, 12, 729, 0, 2}, {12, 12, -343, 1, 2}, {24, 12, 8, 2, 2}, {36, 32, 64, 0, 0}};
  for (std::size_t i = 0; i < 4; ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(report.shells[i], expected[i]);
  }
  EXPECT_EQ(report.components, 3U);
  EXPECT_EQ(report.euler_number, 6);
  EXPECT_EQ(report.genus, 1);
  EXPECT_EQ(report.volume, 729 - 343 + 8 + 64);
}

}  // namespace
}  // namespace dupin
