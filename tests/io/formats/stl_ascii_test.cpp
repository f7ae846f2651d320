#include <algorithm>
#include <charconv>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/io/mesh_file.h"
#include "dupin/io/stl.h"
#include "dupin/kernel/error.h"
#include "io/formats/first_use.h"
#include "support/malformed.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

TriMesh read_any(std::string_view bytes, std::string_view file) { return read_mesh(bytes, file); }

TEST(Stl, names_of_words_that_files_are_made_of_are_names) {
  for (const char* const name : {"facet normal west", "facet normal 1 2 3", "facet normal 0 0 1",
                                 "facet", "endfacet", "endsolid", "solid facet normal 0 0 1"}) {
    const TriMesh mesh = test::labelled_tetrahedron();
    TriMesh named = mesh;
    named.names.front() = name;
    const TriMesh read = read_stl_ascii(stl_ascii_text(named), "x.stl");
    EXPECT_EQ(read.names.front(), name);
    EXPECT_EQ(read.triangles.size(), mesh.triangles.size()) << name;
  }
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

TEST(Stl, ascii_may_be_of_one_line) {
  std::string facet = kFacet;
  std::ranges::replace(facet, '\n', ' ');
  const std::string solid = "solid the facet A " + facet + facet + "endsolid the facet A ";
  for (const auto& [text, names, triangles] :
       {std::tuple(solid, std::vector<std::string>{"the facet A"}, 2),
        {solid + "solid b " + facet + "endsolid b", {"the facet A", "b"}, 3},
        {solid + "solid " + facet + "endsolid\nsolid c\n" + kFacet + "endsolid c\n",
         {"the facet A", "solid 2", "c"},
         4},
        {"solid " + facet + "endsolid", {}, 1}}) {
    const TriMesh mesh = read_stl_ascii(text, "x.stl");
    EXPECT_EQ(mesh.names, names) << text;
    EXPECT_EQ(mesh.triangles.size(), triangles) << text;
  }
  EXPECT_THROW((void)read_stl_ascii(solid + facet, "x.stl"), Error) << "a facet of no solid";
}

// A backslash goes on with a line in other formats; here names end in it, as folders do.
TEST(Stl, ascii_names_may_end_in_a_backslash) {
  for (const std::string name : {"C:\\parts\\", "\\", "a \\", "a \\ ", "a\\\r", "\\ \\\t\r\r"}) {
    const TriMesh mesh =
        read_stl_ascii("solid " + name + "\n" + kFacet + "endsolid " + name + "\n", "x.stl");
    EXPECT_EQ(mesh.triangles.size(), 1U) << name;
  }
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
