#include "dupin/io/obj.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "io/formats/creased.h"
#include "support/malformed.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

const std::string kPoints = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

TEST(Obj, a_backslash_continues_the_line_of_a_name) {
  const TriMesh mesh = read_obj(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\ng a \\\nb\nf 1 2 3\no \\\n c\\\r\nd\nf 1 3 2\n", "x.obj");
  EXPECT_EQ(mesh.names, (std::vector<std::string>{"a  b", "c d"}));
  EXPECT_EQ(mesh.triangles.size(), 2U);
}

TEST(Obj, no_name_that_is_written_ends_in_a_backslash) {
  TriMesh mesh = test::labelled_tetrahedron();
  mesh.names = {"a\\", "a/", "b\\c"};
  mesh.labels = {0, 1, 2, 2};
  const std::string text = obj_text(mesh);
  EXPECT_EQ(text.find("\\\n"), std::string::npos) << text;
  EXPECT_EQ(read_obj(text, "x.obj").names, (std::vector<std::string>{"a/ (2)", "a/", "b\\c"}));
}

TEST(Obj, reads_back_bit_for_bit_what_it_writes) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TriMesh mesh = test::scattered_mesh(seed, 300, false);
    EXPECT_TRUE(test::identical(read_obj(obj_text(mesh), "x.obj"), mesh));
  }
  const TriMesh labelled = test::labelled_tetrahedron();
  EXPECT_TRUE(test::identical(read_obj(obj_text(labelled), "x.obj"), labelled));
}

TEST(Obj, text_groups_triangles_by_label) {
  TriMesh mesh = test::labelled_tetrahedron();
  mesh.labels = {1, 0, 1, 0};
  EXPECT_EQ(obj_text(mesh, {"m", ""}),
            "# dupin\n# unit: m\n" + kPoints +
                "g inlet\nf 1 2 4\nf 2 3 4\ng the blend\nf 1 3 2\nf 1 4 3\n");
}

TEST(Obj, normals_are_beside_points_that_stay_shared) {
  MeshHeader header;
  header.normals = test::creased_normals();
  const std::string text = obj_text(test::labelled_tetrahedron(), header);
  std::string normals;
  for (int i = 0; i < 4; ++i) {
    normals += "vn 0 -0.6 -0.8\n";
  }
  for (int i = 0; i < 4; ++i) {
    normals += "vn 0.36 0.48 0.8\n";
  }
  EXPECT_EQ(text, "# dupin\n" + kPoints + normals +
                      "g inlet\nf 1//1 3//3 2//2\nf 1//1 2//2 4//4\n"
                      "g the blend\nf 1//5 4//6 3//7\nf 2//8 3//7 4//6\n");
  EXPECT_TRUE(test::identical(read_obj(text, "x.obj"), test::labelled_tetrahedron()));
}

TEST(Obj, reads_every_dialect) {
  const std::vector<std::string> files = {
      kPoints + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
      "# by hand\r\nmtllib a b.mtl\r\n" + kPoints +
          "vt 0.5 nan\nvn 0 0 1\nusemtl steel\ns off\nf 1/1/1 3/1/1 2/1/1\nf 1//1 2//1 4//1\n"
          "f 1/1 4/1 3/1\nl 1 2\nf 2 3 4 # last\n",
      "v 0 0 0\nv 1 0 0\nv 0 1 0 1.0\nf -3 -1 -2\nv 0 0 1 0.5 0.5 0.5 1\nf 1 2 -1\nf 1 \\\n4 "
      "\\\n3\n"
      "f -3 -2 -1\n",
      "v 0 0 0 \\\n\nv 1 \\\n0 0\nv \\\r\n0 1\\\n0 \\\n1.0\nv 0 0 1 0.5 0.5 \\\n0.5 1\nf 1 3 2\n"
      "f 1 2 4\nf 1 4 3\nf 2 3 4\n",
      kPoints + "f 1 3\\\n2\nf 1\\\r\n2/1/1\\\r\n4\nf 1 4 3\\\n\nf 2 3 4\n",
  };
  for (const std::string& file : files) {
    EXPECT_TRUE(test::identical(read_obj(file, "x.obj"), test::tetrahedron())) << file;
  }
}

TEST(Obj, numbers_of_colours_may_be_none) {
  EXPECT_TRUE(test::identical(
      read_obj("v 0 0 0 nan nan nan\nv 1 0 0 inf -inf 1e999\nv 0 1 0 1 1 1 nan\nv 0 0 1 -nan(ind)\n"
               "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
               "x.obj"),
      test::tetrahedron()));
}

// A backslash glued to what is before it goes on to the next line, whatever is skipped.
TEST(Obj, weights_and_colours_may_end_in_a_backslash) {
  const std::string rest = "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  for (const std::string first :
       {"v 0 0 0 1\\\n0.5 0.5\n", "v 0 0 0 1.#INF\\\n0.5\n", "v 0 0 0 -1.#IND 1\\\n0.5\n",
        "v 0 0 0 1.#QNAN\\ \t\r\n0.5\n", "v 0 0 0 1\\ \n0.5\n", "v 0 0\\ \n0\\\t\n1\n",
        "v 0 0 0 nan\\\r\r\n0.5\r\r\n", "v 0 0 0 -nan(ind)\\\n-nan(ind)\n", "v 0 0 0 1. #\\\n",
        "v 0 0 0 1 1 1\\\n1\\\n\n"}) {
    EXPECT_TRUE(test::identical(read_obj(first + rest, "x.obj"), test::tetrahedron())) << first;
  }
  for (const std::string first : {"v 0 0 0 1\\", "v 0 0 0 1\\ 2\n"}) {
    EXPECT_THROW((void)read_obj(first + rest, "x.obj"), Error) << first;
  }
}

TEST(Obj, points_without_faces_are_no_mesh) {
  test::expect_refused(
      read_obj, "x.obj",
      {{kPoints + "p 1 2\nl 1 2\n\n",
        "x.obj:8: found the end of the file, expected a face behind the 4 vertices"}});
  EXPECT_TRUE(test::identical(read_obj("# dupin\n", "x.obj"), {})) << "the empty set";
}

// What was cut short, or not written at all, is not the empty set.
TEST(Obj, what_says_nothing_is_no_mesh) {
  const std::string why =
      "found the end of the file, expected a face; the empty set is written "
      "as comments alone";
  test::expect_refused(read_obj, "x.obj",
                       {{"", "x.obj:1: " + why},
                        {"\n \n", "x.obj:3: " + why},
                        {"o\n", "x.obj:2: " + why},
                        {"g pump\ns 1\n", "x.obj:3: " + why},
                        {"# dupin\no pump\n", "x.obj:3: " + why},
                        {"mtllib a.mtl\nusemtl b # c\n", "x.obj:3: " + why}});
}

TEST(Obj, the_latest_group_or_object_names_the_label) {
  const TriMesh mesh = read_obj(
      kPoints + "f 1 3 2\no pump\nf 1 2 4\ng two  words\nf 1 4 3\no pump\nf 2 3 4\n", "x.obj");
  EXPECT_EQ(mesh.names, (std::vector<std::string>{"default", "pump", "two  words"}));
  EXPECT_EQ(mesh.labels, (std::vector<std::uint32_t>{0, 1, 2, 1}));
}

TEST(Obj, a_group_may_be_called_as_a_comment_begins) {
  TriMesh mesh = read_obj(kPoints + "g #1 of 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", "x.obj");
  EXPECT_EQ(mesh.names, std::vector<std::string>{"#1 of 2"});
}

TEST(Obj, malformed_files_are_refused_with_their_line) {
  const std::string corner = ", expected a vertex of a face, such as 7, 7/1, 7//3 or -1";
  const std::string range = ", expected the index of one of the 4 vertices before it";
  test::expect_refused(
      read_obj, "x.obj",
      {
          {"hello\n",
           "x.obj:1: found 'hello', expected an OBJ statement for polygons, such as v, f, g or o"},
          {"cstype bezier\n",
           "x.obj:1: found 'cstype', expected an OBJ statement for polygons, such as v, f, g or o"},
          {"\xff\xfe v\n",
           "x.obj:1: found '\\xff\\xfe', expected an OBJ statement for polygons, such as v, f, g "
           "or o"},
          {kPoints + "f 1 2 \\ 3 4\n",
           "x.obj:5: found '3', expected the end of the line behind a backslash"},
          {kPoints + "f 1 2\\ 3 4\n",
           "x.obj:5: found '3', expected the end of the line behind a backslash"},
          {"v 0 0 \\\n\n", "x.obj:2: found the end of the line, expected a coordinate"},
          {"v 0 0 \\ 1\n", "x.obj:1: found '1', expected the end of the line behind a backslash"},
          {"v 0 0\n", "x.obj:1: found the end of the line, expected a coordinate"},
          {"v 0 0", "x.obj:1: found the end of the file, expected a coordinate"},
          {"v 0 0 nan\n", "x.obj:1: found 'nan', expected a coordinate that is finite"},
          {"v 0 0 1e400\n",
           "x.obj:1: found '1e400', expected a coordinate in the range of doubles"},
          {"v 0 0 zero\n", "x.obj:1: found 'zero', expected a coordinate"},
          {"v 0 0 0 red\n", "x.obj:1: found 'red', expected a weight or a colour's component"},
          {"v 0 0 0 1 1 1 1 1\n",
           "x.obj:1: found '1', expected the end of the line behind a vertex"},
          {kPoints + "f\n",
           "x.obj:5: found the end of the line, expected a face of at least 3 vertices"},
          {kPoints + "f 1 2\n",
           "x.obj:5: found the end of the line, expected a face of at least 3 vertices"},
          {kPoints + "f 1 2 3.0\n", "x.obj:5: found '3.0'" + corner},
          {kPoints + "f 1 2 /3\n", "x.obj:5: found '/3'" + corner},
          {kPoints + "f 1 2 3-\n", "x.obj:5: found '3-'" + corner},
          {kPoints + "f a b c\n", "x.obj:5: found 'a'" + corner},
          {kPoints + "f 0 1 2\n", "x.obj:5: found '0'" + range},
          {kPoints + "f 1 2 5\n", "x.obj:5: found '5'" + range},
          {kPoints + "f 1 2 -5/1\n", "x.obj:5: found '-5/1'" + range},
          {kPoints + "f 1 2 99999999999999999999\n",
           "x.obj:5: found '99999999999999999999'" + range},
      });
}

}  // namespace
}  // namespace dupin
