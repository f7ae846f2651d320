#include <limits>
#include <string>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/interop/cgal.h"
#include "dupin/kernel/boolean.h"
#include "support/message_of.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

TriMesh two_labels() {
  return test::joined({test::labelled(test::frame(), "frame"),
                       test::labelled(test::tetrahedron(Vec3(0.1, 0.2, 9)), "peak")});
}

template <class Point>
class InteropCgal : public testing::Test {};
using Points = testing::Types<Exact, Inexact>;
TYPED_TEST_SUITE(InteropCgal, Points);

TYPED_TEST(InteropCgal, a_mesh_comes_back_as_it_went) {
  const TriMesh mesh = two_labels();
  const auto surface = interop::to_surface_mesh<TypeParam>(mesh);
  EXPECT_EQ(surface.number_of_vertices(), mesh.points.size());
  EXPECT_TRUE(CGAL::is_closed(surface));
  const TriMesh back = interop::to_tri_mesh(surface, mesh.names);
  EXPECT_EQ(back.points, mesh.points);
  EXPECT_EQ(back.labels, mesh.labels);
  EXPECT_EQ(back.names, mesh.names);
  ASSERT_EQ(back.triangles.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Triangle turned = back.triangles[i];
    while (turned[0] != mesh.triangles[i][0]) {
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    }
    EXPECT_EQ(turned, mesh.triangles[i]);
  }
}

TYPED_TEST(InteropCgal, a_solid_comes_back_through_from) {
  const Solid solid = Solid::from(two_labels());
  const auto surface = interop::to_surface_mesh<TypeParam>(solid);
  const Solid back = Solid::from(interop::to_tri_mesh(surface, solid.names()));
  EXPECT_EQ(back.exact_volume(), solid.exact_volume());
  EXPECT_EQ(back.labels(), solid.labels());
}

// Two tetrahedra whose intersection points are no doubles.
Solid crossing() {
  const std::vector<Solid> both = {Solid::from(test::tetrahedron()),
                                   Solid::from(test::tetrahedron(Vec3(0.1, 0.2, 0.3)))};
  return unite(both);
}

TEST(InteropCgalSolid, exact_coordinates_stay_exact) {
  const Solid solid = crossing();
  const auto surface = interop::to_surface_mesh<Exact>(solid);
  for (const auto vertex : surface.vertices()) {
    EXPECT_EQ(interop::rational_coordinates(surface.point(vertex)), solid.exact_point(vertex));
  }
  try {
    (void)interop::to_tri_mesh(surface);
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::invalid_argument);
  }
}

TEST(InteropCgalSolid, inexact_kernels_get_the_nearest_doubles) {
  const Solid solid = crossing();
  const auto surface = interop::to_surface_mesh<Inexact>(solid);
  EXPECT_EQ(interop::to_tri_mesh(surface).points, solid.nearest_points());
}

TEST(InteropCgalSolid, what_a_halfedge_structure_cannot_hold_is_refused) {
  TriMesh mesh = test::tetrahedron();
  mesh.triangles.push_back(mesh.triangles[0]);
  try {
    (void)interop::to_surface_mesh<Inexact>(mesh);
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::not_manifold);
    EXPECT_EQ(std::string(error.what()).find("face 4 cannot be part"), 0U);
  }
}

TEST(InteropCgalSolid, faces_of_four_corners_are_refused) {
  CGAL::Surface_mesh<Inexact> surface;
  std::vector<CGAL::Surface_mesh<Inexact>::Vertex_index> corners;
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}) {
    corners.push_back(surface.add_vertex(Inexact(p.x(), p.y(), p.z())));
  }
  surface.add_face(corners);
  EXPECT_THROW((void)interop::to_tri_mesh(surface), Error);
}

TYPED_TEST(InteropCgal, meshes_that_are_none_are_refused) {
  const auto refusal = [](const TriMesh& mesh) {
    return test::message_of([&] { (void)interop::to_surface_mesh<TypeParam>(mesh); },
                            Errc::invalid_argument);
  };
  TriMesh mesh = two_labels();
  mesh.points[1].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(mesh), "point 1 has a coordinate that is not finite");
  mesh = two_labels();
  mesh.points[0].z() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(mesh), "point 0 has a coordinate that is not finite");
  mesh = two_labels();
  mesh.labels.pop_back();
  EXPECT_THAT(refusal(mesh), testing::EndsWith("give one for each, or none"));
  mesh = two_labels();
  mesh.triangles[2][1] = 77;
  EXPECT_THAT(refusal(mesh), testing::StartsWith("face 2 has the corner 77, but"));
  mesh = two_labels();
  mesh.triangles[1][1] = mesh.triangles[1][0];
  EXPECT_THAT(refusal(mesh), testing::StartsWith("face 1 has a corner twice"));
}

TEST(InteropCgalSolid, surfaces_with_numbers_that_are_not_finite_are_refused) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    CGAL::Surface_mesh<Inexact> surface;
    surface.add_vertex(Inexact(0, 0, 0));
    surface.add_vertex(Inexact(0, bad, 0));
    EXPECT_EQ(
        test::message_of([&] { (void)interop::to_tri_mesh(surface); }, Errc::invalid_argument),
        "vertex 1 has a coordinate that is not finite");
  }
}

TYPED_TEST(InteropCgal, labels_without_names_are_refused) {
  const auto labelled = interop::to_surface_mesh<TypeParam>(two_labels());
  EXPECT_THAT(test::message_of([&] { (void)interop::to_tri_mesh(labelled, {"only"}); },
                               Errc::invalid_argument),
              testing::EndsWith("has the label 1, but there are 1 names"));
}

}  // namespace
}  // namespace dupin
