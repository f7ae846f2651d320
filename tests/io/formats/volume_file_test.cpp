#include "dupin/io/volume_file.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/io/mesh_file.h"
#include "dupin/io/msh.h"
#include "dupin/io/vtu.h"
#include "dupin/kernel/error.h"
#include "io/formats/volume_sample.h"
#include "support/message_of.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

using testing::HasSubstr;

using test::volume_sample;

TEST(VolumeFile, reads_back_what_it_writes) {
  for (const VolumeFormat& format : volume_formats()) {
    SCOPED_TRACE(format.key);
    const VolumeMesh mesh = volume_sample();
    const std::string bytes = verified_volume_bytes(mesh, format, {"mm", "a note", "part"}, "x");
    EXPECT_EQ(bytes, format.write(mesh, {"mm", "a note", "part"}));
    const VolumeMesh read = format.read(bytes, "x");
    ASSERT_EQ(read.point_count(), mesh.point_count());
    EXPECT_EQ(read.tetrahedra.size(), mesh.tetrahedra.size());
    EXPECT_EQ(read.inner_points, mesh.inner_points);
  }
}

TEST(VolumeFile, that_gives_back_another_mesh_is_refused) {
  // A writer that turns a corner of what it writes.
  const auto refused = [](const VolumeFormat& honest, auto write) {
    VolumeFormat forged = honest;
    forged.write = write;
    try {
      (void)verified_volume_bytes(volume_sample(), forged, {}, "x");
      ADD_FAILURE() << honest.key;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::unroundable);
    }
  };
  const auto moved_inside = [](const VolumeMesh& mesh) {
    VolumeMesh other = mesh;
    other.inner_points[0].x() += 0x1p-50;
    return other;
  };
  const auto moved_outside = [](const VolumeMesh& mesh) {
    VolumeMesh other = mesh;
    other.surface.points[2].z() += 0x1p-50;
    return other;
  };
  static_assert(std::is_empty_v<decltype(moved_inside)>);
  refused(kMshVolume, [](const VolumeMesh& mesh, const MeshHeader& header) {
    return msh_volume_text(decltype(moved_inside)()(mesh), header);
  });
  refused(kMshVolume, [](const VolumeMesh& mesh, const MeshHeader& header) {
    return msh_volume_text(decltype(moved_outside)()(mesh), header);
  });
  refused(kVtu, [](const VolumeMesh& mesh, const MeshHeader& header) {
    return vtu_text(decltype(moved_inside)()(mesh), header);
  });
  refused(kVtu, [](const VolumeMesh& mesh, const MeshHeader& header) {
    VolumeMesh fewer = mesh;
    fewer.tetrahedra.pop_back();
    return vtu_text(fewer, header);
  });
}

TEST(VolumeFile, of_gmsh_has_physical_groups) {
  const std::string text = msh_volume_text(volume_sample(), {"m", "", "tee"});
  EXPECT_THAT(text,
              HasSubstr("$PhysicalNames\n3\n2 1 \"inlet\"\n2 2 \"the blend\"\n3 3 \"tee\"\n"));
  EXPECT_THAT(text, HasSubstr("$Elements\n8\n1 2 2 1 1 1 3 2\n"));
  EXPECT_THAT(text, HasSubstr("\n5 4 2 3 3 5 1 3 2\n"));
  EXPECT_THAT(msh_volume_text(volume_sample()), HasSubstr("3 3 \"volume\"\n"));
}

TEST(VolumeFile, of_gmsh_is_read_as_its_surface) {
  const TriMesh surface = read_mesh(msh_volume_text(volume_sample()), "x.msh");
  EXPECT_TRUE(test::identical(surface, volume_sample().surface));
}

TEST(VolumeFile, of_gmsh_may_have_its_nodes_in_any_order) {
  const VolumeMesh mesh = read_msh_volume(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n9 0.1 0.1 0.1\n1 0 0 0\n2 1 0 0\n3 0 1 "
      "0\n4 "
      "0 0 1\n$EndNodes\n$Elements\n2\n1 4 2 0 1 9 1 2 3\n2 2 2 0 1 1 2 4\n$EndElements\n",
      "x");
  EXPECT_EQ(mesh.surface.points.size(), 3U);
  EXPECT_EQ(mesh.inner_points.size(), 2U);
  EXPECT_EQ(mesh.point(mesh.tetrahedra[0][0]), Vec3(0.1, 0.1, 0.1));
  EXPECT_EQ(mesh.point(mesh.tetrahedra[0][3]), Vec3(0, 1, 0));
}

TEST(VolumeFile, of_gmsh_without_tetrahedra_is_refused) {
  try {
    (void)read_msh_volume(msh_text(test::labelled_tetrahedron()), "x");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::parse_failed);
    EXPECT_THAT(error.what(), HasSubstr("expected tetrahedra"));
  }
}

TEST(VolumeFile, of_gmsh_without_tetrahedra_or_surface_is_not_written_as_it_is_not_read) {
  VolumeMesh hollow = test::volume_sample(), bare = hollow;
  hollow.tetrahedra.clear();
  bare.surface.triangles.clear();
  bare.surface.labels.clear();
  const auto said = [](const VolumeMesh& mesh) {
    return test::message_of([&] { (void)msh_volume_text(mesh); }, Errc::invalid_argument);
  };
  EXPECT_EQ(said(hollow),
            "the mesh has 5 points and 0 tetrahedra within 4 triangles; a gmsh volume needs some "
            "of both");
  EXPECT_EQ(said(bare),
            "the mesh has 5 points and 4 tetrahedra within 0 triangles; a gmsh volume needs some "
            "of both");
  for (const VolumeMesh& mesh : {hollow, bare}) {  // VTK may have either
    EXPECT_EQ(read_vtu(vtu_text(mesh), "x").tetrahedra, mesh.tetrahedra);
  }
}

TEST(VolumeFile, of_the_empty_set_is_read_back) {
  for (const VolumeFormat& format : volume_formats()) {
    EXPECT_TRUE(verified_volume_bytes({}, format, {}, "x").size() > 0) << format.key;
  }
}

TEST(VolumeFile, formats_are_found_by_key_and_by_extension) {
  EXPECT_EQ(find_volume_format("msh")->name, kMshVolume.name);
  EXPECT_EQ(find_volume_format(".vtu")->name, kVtu.name);
  EXPECT_EQ(find_volume_format(".stl"), nullptr);
  EXPECT_EQ(find_volume_format(""), nullptr);
}

}  // namespace
}  // namespace dupin
