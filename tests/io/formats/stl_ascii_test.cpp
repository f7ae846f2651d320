#include <charconv>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/io/mesh_file.h"
#include "dupin/io/stl.h"
#include "io/formats/first_use.h"
#include "support/malformed.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

TriMesh read_any(std::string_view bytes, std::string_view file) { return read_mesh(bytes, file); }

TEST(MalformedMesh, off_is_refused_with_its_line) {
  const std::string head = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  const std::string keyword = "expected the keyword OFF (or COFF, NOFF, CNOFF, STOFF)";
  test::expect_refused(
      read_any, "a.off",
      {
          {"", "a.off:1: found the end of the file, " + keyword},
          {"\n# no mesh\n3 1 0\n", "a.off:3: found '3', " + keyword},
          {"4OFF\n3 1 0\n", "a.off:1: found '4OFF', " + keyword},
          {"OFFICE\n", "a.off:1: found 'OFFICE', " + keyword},
          {"OFF BINARY\n", "a.off:1: found 'BINARY', expected the text form of OFF"},
          {"OFF\n",
           "a.off:2: found the end of the file, expected the number of vertices, an integer"},
          {"OFF\n3\n",
           "a.off:2: found the end of the line, expected the number of faces, an integer"},
          {"OFF\nthree 1 0\n",
           "a.off:2: found 'three', expected the number of vertices, an integer"},
          {"OFF\n-3 1 0\n",
           "a.off:2: found '-3', expected the number of vertices, an integer from 0 to 4294967295"},
          {"OFF\n3.5 1 0\n", "a.off:2: found '3.5', expected the number of vertices, an integer"},
          {"OFF\n99999999999999999999 1 0\n",
           "a.off:2: found '99999999999999999999', expected the number of vertices, an integer "
           "from 0 "
           "to 4294967295"},
          {"OFF\n3 1 0 0\n", "a.off:2: found '0', expected the end of the line behind the counts"},
          {"OFF\n4000000000 4000000000 0\n0 0 0\n",
           "a.off:2: found counts of 4000000000 vertices and 4000000000 faces, expected at least "
           "56000000000 bytes after them, not 6"},
          {"OFF\n2 0 0\n0 0 0\n",
           "a.off:2: found counts of 2 vertices and 0 faces, expected at least 12 bytes after "
           "them, "
           "not 6"},
          {"OFF\n1 0 0\n0 0\n  \n", "a.off:3: found the end of the line, expected a coordinate"},
          {"OFF\n1 0 0\n0 0 0 0\n",
           "a.off:3: found '0', expected the end of the line behind a vertex"},
          {"OFF\n1 0 0\n0 nan 0\n", "a.off:3: found 'nan', expected a coordinate that is finite"},
          {"OFF\n1 0 0\n0 0 -inf\n", "a.off:3: found '-inf', expected a coordinate that is finite"},
          {"OFF\n1 0 0\n1e999 0 0\n",
           "a.off:3: found '1e999', expected a coordinate in the range of doubles"},
          {"OFF\n1 0 0\n1,5 0 0\n", "a.off:3: found '1,5', expected a coordinate"},
          {"OFF\n1 0 0\n0x1p3 0 0\n", "a.off:3: found '0x1p3', expected a coordinate"},
          {"OFF\n1 0 0\n+-1 0 0 0\n", "a.off:3: found '+-1', expected a coordinate"},
          {"OFF\n1 0 0\n0 0 \xff\xfe\n", "a.off:3: found '\\xff\\xfe', expected a coordinate"},
          {std::string("OFF\n1 0 0\n0 0 \0\n", 16),
           "a.off:3: found '\\x00', expected a coordinate"},
          {"COFF\n1 0 0\n0 0 0 red\n",
           "a.off:3: found 'red', expected a component of a normal, colour or texture coordinate"},
          {head + "         ",
           "a.off:6: found the end of the file, expected a face: its number of vertices, an "
           "integer"},
          {head + "2 0 1 \n",
           "a.off:6: found '2', expected a face: its number of vertices, an integer from 3 to "
           "4294967295"},
          {head + "3 0 1 3\n",
           "a.off:6: found '3', expected the index of a vertex, an integer from 0 to 2"},
          {head + "3 0 1 -1\n",
           "a.off:6: found '-1', expected the index of a vertex, an integer from 0 to 2"},
          {head + "3 0 1 0.5\n",
           "a.off:6: found '0.5', expected the index of a vertex, an integer"},
          {head + "3 0 1   \n2\n",
           "a.off:6: found the end of the line, expected the index of a vertex, an integer"},
          {head + "3 0 1 2 1 2 3 4 5\n",
           "a.off:6: found more than 4 numbers behind a face of 3 vertices, expected at most a "
           "colour"},
          {head + "3 0 1 2 blue\n", "a.off:6: found 'blue', expected a colour's component"},
          {head + "3 0 1 2\n3 0 1 2\n",
           "a.off:7: found '3', expected the end of the file behind the last face"},
          {"OFF\n0 1 0\n3 0 0 0\n", "a.off:2: found 1 faces of no vertices, expected vertices"},
      });
}

TEST(Stl, ascii_numbers_read_alike_as_floats_and_as_doubles) {
  const TriMesh mesh = test::scattered_mesh(77, 2000, false);
  std::istringstream words(stl_ascii_text(mesh));
  std::string word;
  std::size_t corner = 0;
  while (words >> word) {
    if (word != "vertex") {
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) {
      words >> word;
      double as_double = 0;
      float as_float = 0;
      std::from_chars(word.data(), word.data() + word.size(), as_double);
      std::from_chars(word.data(), word.data() + word.size(), as_float);
      ASSERT_EQ(as_double, static_cast<double>(as_float)) << word;
      ASSERT_EQ(as_float, static_cast<float>(mesh.points[corner][axis])) << word;
    }
    ++corner;
  }
  EXPECT_EQ(corner, 6000U);
}

TEST(Stl, ascii_numbers_are_the_shortest) {
  TriMesh mesh = test::tetrahedron();
  mesh.triangles.resize(1);
  mesh.points = {Vec3(0.1, -0.0, 16777217), Vec3(0.1, 0, 0), Vec3(0.1, 1, 0)};
  EXPECT_EQ(stl_ascii_text(mesh),
            "solid \nfacet normal -1 0 0\nouter loop\n"
            "vertex 0.10000000149011612 0 16777216\nvertex 0.10000000149011612 1 0\n"
            "vertex 0.10000000149011612 0 0\nendloop\nendfacet\nendsolid \n");
}

TEST(Stl, ascii_blocks_keep_their_names_as_labels) {
  TriMesh mesh = test::labelled_tetrahedron();
  mesh.labels = {1, 0, 1, 0};
  mesh.names = {"inlet",
                "la r\xC3\xA9"
                "duction",
                "unused"};
  TriMesh expected = test::by_first_use(mesh);
  expected.names.pop_back();
  EXPECT_TRUE(test::identical(read_stl_ascii(stl_ascii_text(mesh), "x.stl"), expected));
}

TEST(Stl, ascii_names_are_cleaned) {
  const TriMesh mesh = read_stl_ascii("solid  \xE9t\xC3\xA9\tor  \r\n" + kFacet + "endsolid\n" +
                                          "SOLID\n" + kFacet + "ENDSOLID\n" + "solid a\nendsolid\n",
                                      "x.stl");
  EXPECT_EQ(mesh.names, (std::vector<std::string>{"\xEF\xBF\xBDt\xC3\xA9 or", "solid 2"}));
  EXPECT_EQ(mesh.labels, (std::vector<std::uint32_t>{0, 1}));
}

TEST(Stl, ascii_blocks_of_one_name_are_one_label) {
  const std::string block = "solid a\n" + kFacet + "endsolid a\n";
  const TriMesh mesh = read_stl_ascii(block + block, "x.stl");
  EXPECT_EQ(mesh.names, std::vector<std::string>{"a"});
  EXPECT_EQ(mesh.labels, (std::vector<std::uint32_t>{0, 0}));
}

TEST(Stl, ascii_normals_may_be_no_numbers) {
  std::string text = "solid\n" + kFacet + "endsolid\n";
  text.replace(text.find("0 0 1"), 5, "nan -nan(ind) inf");
  EXPECT_EQ(read_stl_ascii(text, "x.stl").triangles.size(), 1U);
}

TEST(Stl, minus_zero_and_zero_are_the_same_corner) {
  std::string text = "solid\n" + kFacet + kFacet + "endsolid\n";
  text.replace(text.rfind("vertex 0 0 0"), 12, "vertex -0 0 -0.0");
  EXPECT_EQ(read_stl_ascii(text, "x.stl").points.size(), 3U);
}

TEST(MalformedMesh, ascii_stl_is_refused_with_its_line) {
  const std::string loop =
      "outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  const std::string facet = "facet normal 0 0 1\n" + loop;
  test::expect_refused(
      read_any, "a.stl",
      {
          {"solid", "a.stl:1: found the end of the file, expected 'facet' or 'endsolid'"},
          {"solid a\n" + facet,
           "a.stl:9: found the end of the file, expected 'facet' or 'endsolid'"},
          {"solid a\nfacet\n" + loop, "a.stl:3: found 'outer', expected 'normal'"},
          {"solid a\nfacet normal 0 0\n" + loop,
           "a.stl:3: found 'outer', expected a component of the facet's normal"},
          {"solid a\nfacet normal 0 0 0\nloop\n", "a.stl:3: found 'loop', expected 'outer'"},
          {"solid a\nfacet normal 0 0 0\nouter loop\nendloop\n",
           "a.stl:4: found 'endloop', expected 'vertex'"},
          {"solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0\nvertex 1 0 0\n",
           "a.stl:4: found the end of the line, expected a coordinate"},
          {"solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 nan\n",
           "a.stl:4: found 'nan', expected a coordinate that is finite"},
          {"solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0 0\n",
           "a.stl:4: found '0', expected 'vertex'"},
          {"solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
           "0\nvertex "
           "0 2 0\n",
           "a.stl:7: found 'vertex', expected 'endloop'"},
          {"solid a\n" + facet + "endsolid a\ngarbage\n",
           "a.stl:10: found 'garbage', expected 'solid'"},
          {"solid a\n" + facet + "end\n", "a.stl:9: found 'end', expected 'facet' or 'endsolid'"},
          {"solid a\n" + facet.substr(0, 54),
           "a.stl:5: found the end of the file, expected a coordinate"},
      });
}

}  // namespace
}  // namespace dupin
