#include "dupin/io/mesh_file.h"

#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/io/atomic_file.h"
#include "dupin/io/glb.h"
#include "dupin/io/msh.h"
#include "dupin/io/obj.h"
#include "dupin/io/off.h"
#include "dupin/io/ply.h"
#include "dupin/io/stl.h"
#include "dupin/io/three_mf.h"
#include "dupin/io/vtp.h"
#include "dupin/kernel/error.h"
#include "support/known_extensions.h"
#include "support/message_of.h"
#include "support/sample_meshes.h"
#include "support/scratch_directory.h"

namespace dupin {
namespace {

using MeshFile = test::ScratchDirectory;

TEST_F(MeshFile, the_content_tells_the_format) {
  for (const MeshFormat& format : mesh_formats()) {
    const std::string bytes = mesh_bytes(test::tetrahedron(), format);
    for (const std::string file : {"-", "x.off", "x.stl", "x.xyz"}) {
      EXPECT_EQ(read_mesh(bytes, file).triangles.size(), 4U) << format.name << " in " << file;
    }
  }
}

TEST_F(MeshFile, texts_may_begin_with_a_byte_order_mark) {
  const std::string mark = "\xEF\xBB\xBF";
  for (const MeshFormat& format :
       {kOff, kStlAscii, kPlyAscii, kPlyBinary, kObj, kVtp, kMshSurface}) {
    for (const TriMesh& mesh : {test::tetrahedron(), TriMesh()}) {
      const std::string bytes = mesh_bytes(mesh, format, {"in", {}});
      const MeshFormat* const told = format_of_content(mark + bytes, "-");
      ASSERT_NE(told, nullptr) << format.name;
      EXPECT_EQ(told->read, format.read) << format.name;
      EXPECT_EQ(read_mesh(mark + bytes, "-").triangles, read_mesh(bytes, "-").triangles)
          << format.name;
      EXPECT_EQ(mesh_unit(mark + bytes, "-"), mesh_unit(bytes, "-")) << format.name;
    }
  }
}

TEST_F(MeshFile, limits_are_told_with_their_place) {
  std::string points, obj_points, face, obj_face = "f";
  for (int i = 0; i <= 20000; ++i) {
    const std::string point = std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
    points += point;
    obj_points += "v " + point;
    face += " " + std::to_string(i);
    obj_face += " " + std::to_string(i + 1);
  }
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 20001\nproperty int x\nproperty int y\n"
      "property int z\nelement face 1\nproperty list int int vertex_indices\nend_header\n";
  const struct {
    std::string file, text, place;
  } table[] = {{"large.off", "OFF\n20001 1 0\n" + points + "20001" + face + "\n", ":20004"},
               {"large.obj", obj_points + obj_face + "\n", ":20002"},
               {"large.ply", ply + points + "20001" + face + "\n", ":20011"}};
  for (const auto& [file, text, place] : table) {
    try {
      (void)read_mesh(text, file);
      ADD_FAILURE() << file;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::limit_exceeded);
      EXPECT_EQ(error.where(), file + place);
    }
  }
}

TEST_F(MeshFile, the_empty_set_is_known_by_its_content) {
  for (const MeshFormat& format : mesh_formats()) {
    const std::string bytes = mesh_bytes({}, format);
    EXPECT_NE(format_of_content(bytes, "x"), nullptr) << format.key;
    EXPECT_TRUE(read_mesh(bytes, "x").triangles.empty()) << format.key;
  }
}

TEST_F(MeshFile, an_explicit_format_overrules_the_content) {
  const std::string text = mesh_bytes(test::tetrahedron(), kStlAscii);
  EXPECT_THROW((void)kStlBinary.read(text, "x"), Error);
}

TEST_F(MeshFile, the_extension_names_the_format_to_write) {
  EXPECT_EQ(format_of("a/b.off"), kOff);
  EXPECT_EQ(format_of("b.c.STL"), kStlBinary);
  for (const MeshFormat& format : mesh_formats()) {
    if (!format.extension.empty()) {
      EXPECT_EQ(format_of("x" + std::string(format.extension)), format);
    }
  }
  const std::string known = test::known_extensions();
  EXPECT_EQ(known.substr(0, 34), ".off, .stl, .ply, .obj, .3mf, .glb");
  for (const std::string path : {"dir.stl/pipe.step", "pipe", "pipe.stl-ascii", "pipe."}) {
    try {
      (void)format_of(path);
      ADD_FAILURE() << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
      EXPECT_EQ(error.what(), path + ": the extension '" +
                                  std::filesystem::path(path).extension().string() +
                                  "' names no mesh format; known are " + known);
    }
  }
}

TEST_F(MeshFile, every_format_has_a_key_of_its_own) {
  for (const MeshFormat& format : mesh_formats()) {
    EXPECT_EQ(find_mesh_format(format.key), &format) << format.name;
  }
  EXPECT_EQ(find_mesh_format(""), nullptr);
  EXPECT_EQ(find_mesh_format("STL"), nullptr);
}

TEST_F(MeshFile, the_strongest_evidence_decides) {
  std::string stl = mesh_bytes(test::tetrahedron(), kStlBinary);
  const std::vector<std::pair<std::string, std::string>> table = {
      {"v 1 2 3", "stl"}, {"solid x", "stl"}, {"OFF by one", "stl"},  {"OFFSHORE", "stl"},
      {"KICKOFF", "stl"}, {"ply\nx", "stl"},  {"$MeshFormat", "stl"}, {"glTF", "glb"}};
  for (const auto& [start, key] : table) {
    stl.replace(0, start.size(), start);
    for (const MeshFormat& format : mesh_formats()) {
      if (format.key == key) {
        EXPECT_GE(format.recognises(stl), Evidence::size) << start;
      } else if (format != kStlBinary) {
        EXPECT_LT(format.recognises(stl), Evidence::size) << start << format.name;
      }
    }
  }
}

TEST_F(MeshFile, formats_say_what_they_hold) {
  for (const MeshFormat& format : {kOff, kPlyAscii, kPlyBinary, kObj}) {
    EXPECT_EQ(format.coordinates, Coordinates::binary64) << format.name;
  }
  for (const MeshFormat& format : {kStlAscii, kStlBinary, kThreeMf, kGlb}) {
    EXPECT_EQ(format.coordinates, Coordinates::binary32) << format.name;
  }
  for (const MeshFormat& format : mesh_formats()) {
    TriMesh mesh = test::tetrahedron();
    mesh.points[1].x() = 0.1;
    const TriMesh read = format.read(mesh_bytes(mesh, format), "x");
    const std::size_t place = format.merges_points ? 2 : 1;  // in order of first appearance
    EXPECT_EQ(read.points[place], nearest(mesh.points[1], format.coordinates)) << format.name;
    TriMesh doubled = test::tetrahedron();
    doubled.points.push_back(doubled.points[3]);
    doubled.triangles[3][2] = 4;
    EXPECT_EQ(format.read(mesh_bytes(doubled, format), "x").points.size(),
              format.merges_points ? 4U : 5U)
        << format.name;
  }
}

TEST_F(MeshFile, points_without_triangles_are_not_written_as_none_reads_them) {
  TriMesh mesh = test::tetrahedron();
  mesh.triangles.clear();
  for (const MeshFormat& format : mesh_formats()) {
    EXPECT_EQ(test::message_of([&] { (void)mesh_bytes(mesh, format); }, Errc::invalid_argument),
              "the mesh has 4 points and no triangle; files of meshes need some")
        << format.name;
    EXPECT_TRUE(format.read(mesh_bytes({}, format), "x").points.empty()) << format.name;
  }
}

TEST_F(MeshFile, labels_that_would_be_written_alike_are_kept_apart) {
  TriMesh mesh = test::tetrahedron();
  mesh.labels = {0, 1, 2, 3};
  mesh.names = {" a", "a ", "a", "\xEF\xBF\xBE"};
  std::size_t count = 0;
  for (const MeshFormat& format : mesh_formats()) {
    const TriMesh read = format.read(mesh_bytes(mesh, format), "x");
    if (read.labels.empty()) {  // the format has none
      continue;
    }
    ++count;
    const std::set<std::uint32_t> labels(read.labels.begin(), read.labels.end());
    EXPECT_EQ(labels.size(), 4U) << format.name;
    EXPECT_EQ(std::ranges::count(read.names, "a"), 1) << format.name;
    EXPECT_EQ(std::ranges::count(read.names, "a (2)"), 1) << format.name;
    EXPECT_EQ(std::ranges::count(read.names, "a (3)"), 1) << format.name;
  }
  EXPECT_GE(count, 7U);
}

TEST_F(MeshFile, the_unit_is_read_back) {
  for (const MeshFormat& format : {kOff, kStlBinary, kPlyAscii, kPlyBinary, kObj, kThreeMf, kGlb}) {
    const std::string with = mesh_bytes(test::tetrahedron(), format, {"in", "a note"});
    EXPECT_EQ(mesh_unit(with, "x"), "in") << format.name;
  }
  for (const MeshFormat& format : mesh_formats()) {
    const std::string with = mesh_bytes(test::tetrahedron(), format, {"in", "a note"});
    const std::string without = mesh_bytes(test::tetrahedron(), format);
    EXPECT_EQ(mesh_unit(without, "x"), format == kThreeMf ? "mm" : "") << format.name;
    EXPECT_EQ(mesh_unit(with, "x"), with == without ? "" : "in") << format.name;
  }
  EXPECT_EQ(mesh_unit("no mesh, unit: mm", "x"), "");
}

TEST_F(MeshFile, the_same_mesh_gives_the_same_bytes_and_they_write_alike_when_read) {
  for (const MeshFormat& format : mesh_formats()) {
    const std::string bytes = mesh_bytes(test::labelled_tetrahedron(), format, {"mm", "note"});
    EXPECT_EQ(bytes, mesh_bytes(test::labelled_tetrahedron(), format, {"mm", "note"}));
    EXPECT_EQ(bytes, mesh_bytes(read_mesh(bytes, "x"), format, {"mm", "note"})) << format.name;
  }
}

TEST_F(MeshFile, reads_from_disk_what_it_wrote) {
  const TriMesh mesh = test::scattered_mesh(5, 100, true);
  for (const MeshFormat& format : mesh_formats()) {
    write_mesh(path("mesh"), mesh, format);
    EXPECT_TRUE(test::identical(read_mesh(path("mesh")), mesh)) << format.name;
  }
  write_mesh(path("mesh.off"), mesh);
  EXPECT_EQ(read_file(path("mesh.off")), mesh_bytes(mesh, kOff));
}

}  // namespace
}  // namespace dupin
