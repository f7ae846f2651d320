#include <gtest/gtest.h>

#include "cross_check/surface_mesh.h"
#include "dupin/kernel/error.h"
#include "kernel/cross_check/cut_wedge_internal.h"

namespace dupin::cross_check {
namespace {

Solid solid(mesh::ExactMesh mesh) {
  return Solid(std::make_shared<const mesh::ExactMesh>(std::move(mesh)));
}

Surface of(const TriMesh& mesh) { return surface_mesh(Solid::from(mesh).exact()); }

TEST(SurfaceMesh, has_the_very_points) {
  const Solid wedge = test::cut_wedge(Vec3(5, 0, 0));
  ASSERT_EQ(wedge.exact().implicit.size(), 2U);
  const Surface surface = surface_mesh(wedge.exact());
  EXPECT_TRUE(surface.is_valid());
  int thirds = 0;
  for (const Surface::Vertex_index vertex : surface.vertices()) {
    const auto& point = surface.point(vertex);
    thirds += point == Kernel::Point_3(Kernel::FT(17) / 3, 1, 0) ? 1 : 0;
    thirds += point == Kernel::Point_3(5, 1, Kernel::FT(2) / 3) ? 1 : 0;
  }
  EXPECT_EQ(thirds, 2);
}

TEST(SurfaceMesh, and_back_is_the_same_solid) {
  const Solid wedge = test::cut_wedge(Vec3(5, 0, 0));
  const Solid back = solid(exact_mesh(surface_mesh(wedge.exact()), "x"));
  EXPECT_EQ(back.exact_volume(), test::kCutWedgeVolume);
  EXPECT_EQ(test::sorted_points(back), test::sorted_points(wedge));
  EXPECT_TRUE(back.labels().empty());
  ASSERT_EQ(back.sources().size(), wedge.triangle_count());
  for (std::uint32_t i = 0; i < back.sources().size(); ++i) {
    EXPECT_EQ(back.sources()[i], (Source{0, i}));
  }
}

// As ExactMesh demands, whatever the order of the vertices.
TEST(SurfaceMesh, points_of_doubles_come_first) {
  Surface surface = of(test::tetrahedron());
  surface.point(Surface::Vertex_index(0)) = Kernel::Point_3(Kernel::FT(-1) / 3, 0, 0);
  surface.point(Surface::Vertex_index(2)) = Kernel::Point_3(0, Kernel::FT(1) / 7, 0);
  const mesh::ExactMesh mesh = exact_mesh(surface, "x");
  ASSERT_EQ(mesh.points.size(), 4U);
  ASSERT_EQ(mesh.double_count(), 2U);
  EXPECT_EQ(mesh.points[0], Vec3(1, 0, 0));
  EXPECT_EQ(mesh.points[1], Vec3(0, 0, 1));
  EXPECT_EQ(mesh.points[2], Vec3(-1.0 / 3, 0, 0));
  EXPECT_EQ(mesh.points[3], Vec3(0, 1.0 / 7, 0));
  EXPECT_EQ(solid(mesh).exact_volume(), mpq_class(4, 3) * mpq_class(1, 7) / 6);
}

TEST(SurfaceMesh, skips_what_was_removed_from_it) {
  Surface surface =
      of(test::joined({test::tetrahedron(), test::box(Vec3(2, 2, 2), Vec3(3, 3, 3))}));
  for (std::uint32_t i = 0; i < 4; ++i) {
    surface.remove_face(Surface::Face_index(i));
    surface.remove_vertex(Surface::Vertex_index(i));
  }
  ASSERT_TRUE(surface.has_garbage());
  const Solid rest = solid(exact_mesh(surface, "x"));
  EXPECT_EQ(rest.point_count(), 8U);
  EXPECT_EQ(rest.exact_volume(), 1);
}

TEST(SurfaceMesh, that_is_open_is_no_boundary) {
  Surface surface = of(test::tetrahedron());
  CGAL::Euler::remove_face(surface.halfedge(Surface::Face_index(2)), surface);
  try {
    (void)exact_mesh(surface, "the cut");
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::boolean_failed);
    EXPECT_STREQ(error.what(), "the cut left a surface that is not closed");
  }
}

// Two surfaces of one vertex each at a place that no double holds.
TEST(SurfaceMesh, that_touches_itself_has_contacts) {
  Surface surface = of(test::joined({test::tetrahedron(), test::tetrahedron(Vec3(-4, -4, -4))}));
  const Kernel::Point_3 tip(Kernel::FT(-1) / 3, 0, 0);
  surface.point(Surface::Vertex_index(0)) = tip;
  surface.point(Surface::Vertex_index(5)) = tip;
  const mesh::ExactMesh mesh = exact_mesh(surface, "x");
  EXPECT_EQ(mesh.points.size(), 8U);
  ASSERT_EQ(mesh.contacts.size(), 1U);
  EXPECT_EQ(mesh.contacts[0].kind, Contact::Kind::vertex);
  EXPECT_EQ(mesh.contacts[0].from, Vec3(-1.0 / 3, 0, 0));
}

}  // namespace
}  // namespace dupin::cross_check
