#include "dupin/io/off.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/malformed.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

const std::string kBody = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

TEST(Off, reads_back_bit_for_bit_what_it_writes) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TriMesh mesh = test::scattered_mesh(seed, 300, false);
    EXPECT_TRUE(test::identical(read_off(off_text(mesh), "x.off"), mesh)) << seed;
  }
  TriMesh extremes = test::tetrahedron();
  extremes.points[1].x() = std::numeric_limits<double>::max();
  extremes.points[2].y() = std::numeric_limits<double>::denorm_min();
  extremes.points[3].z() = std::nextafter(0.1, 1);
  EXPECT_TRUE(test::identical(read_off(off_text(extremes), "x.off"), extremes));
}

TEST(Off, writes_the_shortest_decimals_and_no_negative_zero) {
  TriMesh mesh = test::tetrahedron();
  mesh.points[0] = Vec3(-0.0, 0.1, 1e22);
  mesh.triangles.resize(1);
  EXPECT_EQ(off_text(mesh, {"mm", "origin at\n(1, 2, 3)"}),
            "OFF\n# dupin\n# unit: mm\n# origin at (1, 2, 3)\n4 1 0\n"
            "0 0.1 1e+22\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n");
}

TEST(Off, reads_every_dialect) {
  const std::string coloured =
      "0 0 0 255 0 0 1\n1 0 0 1 1 1\n0 1 0 0 0 0\n0 0 1\n"
      "3 0 2 1\n3 0 1 3 0.5 0.5 0.5\n3 0 3 2 1 2 3 4\n3 1 2 3 7\n";
  const std::vector<std::string> dialects = {
      "OFF\n4 4 0\n" + kBody,
      "OFF 4 4 0\n" + kBody,
      "OFF4 4 6\n" + kBody,
      "OFF\n4 4\n" + kBody,
      "\xEF\xBB\xBFOFF\n4 4 0\n" + kBody,
      "# made by hand\n\nOFF # of a tetrahedron\n# \xff\xfe\n4 4 0 # counts\n\n" + kBody +
          "\n# end",
      "COFF\n4 4 0\n" + coloured,
      "NOFF\n4 4 0\n" + coloured,
      "CNOFF\n4 4 0\n" + coloured,
      "STOFF\n4 4 0\n" + coloured,
      "STCNOFF\n4 4 0\n" + coloured,
      "  OFF  \n\t4 4 0\n" + kBody.substr(0, kBody.size() - 1),
      "OFF\n4 4 0\n+0 -0 0e5\n1. 0 .0\n0 1.0 0\n0 0 1E0\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
  };
  for (const std::string& text : dialects) {
    EXPECT_TRUE(test::identical(read_off(text, "x.off"), test::tetrahedron())) << text;
  }
}

TEST(Off, faces_may_run_over_several_lines) {
  const std::string points = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  for (const std::string faces : {"3\n0\n2\n1\n3 0\n 1 3\n3 0 3\n2\n3\n1 2 3\n",
                                  "3 # three\n\n# of them\n0 2 1 255 0 0\n3 0 1\n3 nan inf -nan "
                                  "1.#IND\n3\r\n0 3 2\r3 1 2\n3"}) {
    EXPECT_TRUE(test::identical(read_off(points + faces, "x.off"), test::tetrahedron())) << faces;
  }
  const TriMesh square =
      read_off("OFF 4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1\n2 3\n3\n0\n1\n2\n", "x.off");
  EXPECT_EQ(square.triangles.size(), 3U);
}

TEST(Off, numbers_of_colours_may_be_none) {
  const TriMesh mesh = read_off(
      "COFF\n4 4 0\n0 0 0 nan 0 0 1\n1 0 0 inf -inf 1e999\n0 1 0 -nan(ind) +0.5 1.#QNAN\n0 0 1\n"
      "3 0 2 1 nan nan nan nan\n3 0 1 3 inf\n3 0 3 2 1.#INF\n3 1 2 3 -1.#IND00\n",
      "x.off");
  EXPECT_TRUE(test::identical(mesh, test::tetrahedron()));
}

TEST(Off, points_without_faces_are_no_mesh) {
  test::expect_refused(read_off, "x.off",
                       {{"OFF\n# a cloud\n2 0 0\n0 0 0\n1 0 0\n",
                         "x.off:3: found 2 vertices and no face, expected faces"}});
  EXPECT_TRUE(test::identical(read_off("OFF\n0 0 0\n", "x.off"), {})) << "the empty set";
}

TEST(Off, reads_any_mixture_of_line_ends) {
  const std::string text = "OFF\n4 4 0\n" + kBody;
  for (const std::string end : {"\r\n", "\r"}) {
    std::string changed;
    std::size_t lines = 0;
    for (const char c : text) {
      changed += c == '\n' && lines++ % 3 != 1 ? end : std::string(1, c);
    }
    EXPECT_TRUE(test::identical(read_off(changed, "x.off"), test::tetrahedron()));
  }
}

TEST(Off, counts_lines_of_any_kind_in_errors) {
  try {
    (void)read_off("OFF\r\n3 1 0\r0 0 0\n\r\n1 0 0\nx 0 0\n3 0 1 2\n", "x.off");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "x.off:6");
    EXPECT_EQ(error.message(), "found 'x', expected a coordinate");
  }
}

TEST(Off, keeps_isolated_and_equal_points_and_degenerate_triangles) {
  const TriMesh mesh = read_off("OFF\n4 1 0\n0 0 0\n0 0 0\n1 0 0\n5 5 5\n3 0 0 1\n", "x.off");
  EXPECT_EQ(mesh.points.size(), 4U);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 0, 1}}));
}

// Large enough to be read by pieces; each row one line of points and triangles.
std::vector<std::string> lines_of(const TriMesh& mesh) {
  std::vector<std::string> lines;
  std::istringstream text(off_text(mesh));
  for (std::string line; std::getline(text, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines, const char* end = "\n") {
  std::string text;
  for (const std::string& line : lines) {
    text += line + end;
  }
  return text;
}

TEST(Off, reads_large_files_as_it_reads_small_ones) {
  const TriMesh mesh = test::scattered_mesh(7, 20000, false);
  const std::vector<std::string> lines = lines_of(mesh);
  const std::size_t first = lines.size() - mesh.points.size() - mesh.triangles.size();
  const auto changed = [&](std::size_t index, const std::string& before, const char* end = "\n") {
    std::vector<std::string> result = lines;
    result.at(index).insert(0, before);
    return joined(result, end);
  };
  const std::string plain = joined(lines);
  ASSERT_EQ(plain, off_text(mesh));
  const std::size_t vertex = first + mesh.points.size() / 2,
                    face = first + mesh.points.size() + mesh.triangles.size() / 2;
  const std::vector<std::string> alike = {
      plain,
      plain.substr(0, plain.size() - 1),
      joined(lines, "\r\n"),
      joined(lines, "\r"),
      joined(lines, " # behind\n"),
      joined(lines, " \t\n"),
      joined(lines, "\n\n"),
      plain + "\n# end",
      changed(vertex, "# between\n"),
      changed(vertex, "  "),
      changed(face, "\n"),
      changed(face, " "),
      changed(face, "# a\r# b\n"),
  };
  for (std::size_t i = 0; i < alike.size(); ++i) {
    EXPECT_TRUE(test::identical(read_off(alike[i], "x.off"), mesh)) << i;
  }
}

TEST(Off, tells_the_line_of_a_fault_in_a_large_file) {
  const TriMesh mesh = test::scattered_mesh(8, 20000, false);
  const std::vector<std::string> lines = lines_of(mesh);
  const std::size_t first = lines.size() - mesh.points.size() - mesh.triangles.size();
  const std::size_t vertex = first + 3 * mesh.points.size() / 4,
                    face = first + mesh.points.size() + mesh.triangles.size() / 4;
  const std::vector<std::pair<std::size_t, std::string>> faults = {
      {vertex, "1 2 x"},     {vertex, "1 2"},        {vertex, "1 2 3 4"},
      {vertex, "1e999 0 0"}, {face, "3 0 1 999999"}, {face, "3 0 1 2 3 4 5 6 7"},
      {face, "2 0 1"},       {face, "3 0 1 -1"}};
  for (const auto& [at, line] : faults) {
    std::vector<std::string> broken = lines;
    broken[at] = line;
    try {
      (void)read_off(joined(broken), "x.off");
      ADD_FAILURE() << line;
    } catch (const Error& error) {
      EXPECT_EQ(error.where(), "x.off:" + std::to_string(at + 1)) << line << ": " << error.what();
    }
  }
  // One line more than lines end in LF, of either kind.
  for (const std::size_t at : {vertex, face}) {
    std::vector<std::string> joined_by_cr = lines;
    joined_by_cr[at] += "\r" + lines[at];
    EXPECT_THROW((void)read_off(joined(joined_by_cr), "x.off"), Error);
  }
  std::vector<std::string> fewer = lines, more = lines;
  fewer.pop_back();
  EXPECT_THROW((void)read_off(joined(fewer), "x.off"), Error);
  more.push_back(lines.back());
  EXPECT_THROW((void)read_off(joined(more), "x.off"), Error);
}

TEST(Off, refuses_to_write_a_broken_mesh) {
  const auto message = [](const TriMesh& mesh) -> std::string {
    try {
      return off_text(mesh);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
      return error.what();
    }
  };
  TriMesh mesh = test::labelled_tetrahedron();
  mesh.points[2].y() = std::nan("");
  EXPECT_EQ(message(mesh), "point 2 of the mesh is not finite");
  mesh = test::labelled_tetrahedron();
  mesh.triangles[3][1] = 4;
  EXPECT_EQ(message(mesh), "triangle 3 names point 4 of a mesh with 4 points");
  mesh = test::labelled_tetrahedron();
  mesh.labels.pop_back();
  EXPECT_EQ(message(mesh), "the mesh has 3 labels for 4 triangles");
  mesh = test::labelled_tetrahedron();
  mesh.labels[1] = 2;
  EXPECT_EQ(message(mesh), "triangle 1 has label 2 of 2");
}

}  // namespace
}  // namespace dupin
