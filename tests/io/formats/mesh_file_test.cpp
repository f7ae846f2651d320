#include "dupin/io/mesh_file.h"

#include <string>

#include <gtest/gtest.h>

#include "dupin/io/atomic_file.h"
#include "dupin/kernel/error.h"
#include "support/sample_meshes.h"
#include "support/scratch_directory.h"

namespace dupin {
namespace {

using MeshFile = test::ScratchDirectory;

TEST_F(MeshFile, the_content_tells_the_format) {
  for (const MeshFormat format : kMeshFormats) {
    const std::string bytes = mesh_bytes(test::tetrahedron(), format);
    for (const std::string file : {"-", "x.off", "x.stl", "x.xyz"}) {
      EXPECT_EQ(read_mesh(bytes, file).triangles.size(), 4U) << name(format) << " in " << file;
    }
  }
}

TEST_F(MeshFile, an_explicit_format_overrules_the_content) {
  const std::string text = mesh_bytes(test::tetrahedron(), MeshFormat::stl_ascii);
  EXPECT_THROW((void)read_mesh(text, "x", MeshFormat::stl_binary), Error);
}

TEST_F(MeshFile, the_extension_names_the_format_to_write) {
  EXPECT_EQ(format_of("a/b.off"), MeshFormat::off);
  EXPECT_EQ(format_of("b.c.STL"), MeshFormat::stl_binary);
  try {
    (void)format_of("dir.stl/pipe.step");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::invalid_argument);
    EXPECT_STREQ(
        error.what(),
        "dir.stl/pipe.step: the extension '.step' names no mesh format; known are .off, .stl, "
        ".ply, .obj, .3mf, .glb");
  }
}

TEST_F(MeshFile, formats_say_what_they_hold) {
  for (const MeshFormat format : kMeshFormats) {
    const bool doubles = format == MeshFormat::off || format == MeshFormat::ply_ascii ||
                         format == MeshFormat::ply_binary || format == MeshFormat::obj;
    EXPECT_EQ(coordinates(format), doubles ? Coordinates::binary64 : Coordinates::binary32);
    TriMesh mesh = test::tetrahedron();
    mesh.points[1].x() = 0.1;
    const double held = read_mesh(mesh_bytes(mesh, format), "x", format).points[1].x();
    const double read_first = format == MeshFormat::stl_ascii || format == MeshFormat::stl_binary
                                  ? read_mesh(mesh_bytes(mesh, format), "x", format).points[2].x()
                                  : held;
    EXPECT_EQ(read_first, doubles ? 0.1 : static_cast<double>(0.1F)) << name(format);
  }
}

TEST_F(MeshFile, the_unit_is_read_back) {
  for (const MeshFormat format : kMeshFormats) {
    const bool has_place = format != MeshFormat::stl_ascii;
    const std::string with = mesh_bytes(test::tetrahedron(), format, {"in", "a note"});
    EXPECT_EQ(mesh_unit(with, "x"), has_place ? "in" : "") << name(format);
    const std::string without = mesh_bytes(test::tetrahedron(), format);
    EXPECT_EQ(mesh_unit(without, "x"), format == MeshFormat::three_mf ? "mm" : "") << name(format);
  }
}

TEST_F(MeshFile, the_same_mesh_gives_the_same_bytes_and_they_write_alike_when_read) {
  for (const MeshFormat format : kMeshFormats) {
    const std::string bytes = mesh_bytes(test::labelled_tetrahedron(), format, {"mm", "note"});
    EXPECT_EQ(bytes, mesh_bytes(test::labelled_tetrahedron(), format, {"mm", "note"}));
    EXPECT_EQ(bytes, mesh_bytes(read_mesh(bytes, "x"), format, {"mm", "note"})) << name(format);
  }
}

TEST_F(MeshFile, reads_from_disk_what_it_wrote) {
  const TriMesh mesh = test::scattered_mesh(5, 100, true);
  for (const MeshFormat format : kMeshFormats) {
    write_mesh(path("mesh"), mesh, format);
    EXPECT_TRUE(test::identical(read_mesh(path("mesh")), mesh)) << name(format);
  }
  write_mesh(path("mesh.off"), mesh);
  EXPECT_EQ(read_file(path("mesh.off")), mesh_bytes(mesh, MeshFormat::off));
}

}  // namespace
}  // namespace dupin
