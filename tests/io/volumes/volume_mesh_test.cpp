#include "dupin/io/volume_mesh.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "dupin/kernel/remesh.h"
#include "dupin/kernel/rounding.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using test::box;
using test::joined;
using test::labelled;
using test::moved;
using test::reversed;
using test::tetrahedron;
using testing::HasSubstr;

/// A single tetrahedron, as its own mesh.
VolumeMesh one() {
  VolumeMesh mesh;
  mesh.surface = labelled(tetrahedron(), "all \"sides\"");
  mesh.points = mesh.surface.points;
  mesh.surface.points.clear();
  mesh.tetrahedra = {{0, 1, 2, 3}};
  return mesh;
}

void expect_refused(const VolumeMesh& mesh, const char* words) {
  try {
    check_volume_mesh(mesh);
    ADD_FAILURE() << words;
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr(words));
  }
}

TEST(VolumeMesh, is_measured) {
  const VolumeMeshReport report = check_volume_mesh(one());
  EXPECT_EQ(report.tetrahedra, 1U);
  EXPECT_NEAR(report.volume, 1.0 / 6, 1e-15);
  EXPECT_NEAR(report.smallest_dihedral_angle, std::acos(1 / std::sqrt(3)), 1e-12);
  EXPECT_EQ(report.flat_tetrahedra, 0U);
}

TEST(VolumeMesh, that_does_not_fill_its_surface_is_refused) {
  VolumeMesh mesh = one();
  mesh.tetrahedra = {{1, 0, 2, 3}};
  expect_refused(mesh, "flat or inside out");
  mesh.tetrahedra = {{0, 1, 2, 9}};
  expect_refused(mesh, "corner that is none");
  mesh.tetrahedra = {};
  expect_refused(mesh, "a face of theirs");
  mesh.tetrahedra = {{0, 1, 2, 3}, {0, 1, 2, 3}};
  expect_refused(mesh, "a face of theirs");
  mesh = one();
  std::swap(mesh.surface.triangles[0][0], mesh.surface.triangles[0][1]);
  expect_refused(mesh, "on one side of a face");
  mesh = one();
  mesh.points[3] = Vec3(0.25, 0.25, 0);
  expect_refused(mesh, "flat or inside out");
  mesh.points[3] = Vec3(0.25, 0.25, 1e-300);  // too little for doubles to multiply
  EXPECT_EQ(check_volume_mesh(mesh).flat_tetrahedra, 1U);
}

TEST(VolumeMesh, is_written_as_msh) {
  EXPECT_EQ(msh_text(one(), "fluid"),
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"all _sides_\"\n"
            "3 2 \"fluid\"\n$EndPhysicalNames\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"
            "$EndNodes\n$Elements\n5\n1 2 2 1 1 1 3 2\n2 2 2 1 1 1 2 4\n3 2 2 1 1 2 3 4\n"
            "4 2 2 1 1 3 1 4\n5 4 2 2 2 1 2 3 4\n$EndElements\n");
}

TEST(VolumeMesh, is_written_as_vtu) {
  const std::string text = vtu_text(one(), "fluid");
  EXPECT_THAT(text, HasSubstr("NumberOfPoints=\"4\" NumberOfCells=\"5\""));
  EXPECT_THAT(text, HasSubstr("102 108 117 105 100 0\n"));
  EXPECT_THAT(text, HasSubstr("0 1 2 3\n0 2 1\n"));
  EXPECT_THAT(text, HasSubstr("4\n7\n10\n13\n16\n"));
  EXPECT_THAT(text, HasSubstr("10\n5\n5\n5\n5\n"));
}

TEST(VolumeMesh, fills_a_solid_with_a_void_and_another_one_beside_it) {
  if (!has_volume_mesher()) {
    GTEST_SKIP() << "gmsh's library is not installed";
  }
  const Solid solid =
      Solid::from(joined({labelled(box(Vec3::Zero(), Vec3(3, 3, 3)), "outside"),
                          labelled(reversed(box(Vec3(1, 1, 1), Vec3(2, 2, 2))), "void"),
                          labelled(box(Vec3(5, 0, 0), Vec3(6, 1, 1)), "other")}));
  const TriMesh surface =
      to_mesh(remesh(solid, {.distance = 0.01, .largest_edge = 0.5}).solid).mesh();
  const VolumeMesh mesh = fill_with_tetrahedra(surface);
  const VolumeMeshReport report = check_volume_mesh(mesh);
  EXPECT_NEAR(report.volume, 27, 1e-9);
  EXPECT_GT(report.points, surface.points.size());
  EXPECT_EQ(std::vector(mesh.points.begin(), mesh.points.begin() + surface.points.size()),
            surface.points);
  EXPECT_EQ(fill_with_tetrahedra(surface).tetrahedra, mesh.tetrahedra);
}

TEST(VolumeMesh, needs_a_generator) {
  if (has_volume_mesher()) {
    GTEST_SKIP() << "there is one";
  }
  EXPECT_THROW((void)fill_with_tetrahedra(tetrahedron()), Error);
}

}  // namespace
}  // namespace dupin
