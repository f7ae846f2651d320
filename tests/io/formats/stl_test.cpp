#include "dupin/io/stl.h"

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

/// `mesh` with its points in the order in which its triangles, by label, name them first.
TriMesh by_first_use(const TriMesh& mesh) {
  TriMesh sorted{{}, {}, {}, mesh.names};
  std::vector<std::uint32_t> index(mesh.points.size(), std::numeric_limits<std::uint32_t>::max());
  for (std::uint32_t label = 0; label < std::max<std::size_t>(mesh.names.size(), 1); ++label) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (!mesh.labels.empty() && mesh.labels[i] != label) {
        continue;
      }
      Triangle triangle = mesh.triangles[i];
      for (std::uint32_t& corner : triangle) {
        if (index[corner] > mesh.points.size()) {
          index[corner] = static_cast<std::uint32_t>(sorted.points.size());
          sorted.points.push_back(mesh.points[corner]);
        }
        corner = index[corner];
      }
      sorted.triangles.push_back(triangle);
      if (!mesh.labels.empty()) {
        sorted.labels.push_back(label);
      }
    }
  }
  return sorted;
}

TEST(Stl, both_kinds_read_back_bit_for_bit_what_they_write) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TriMesh mesh = test::scattered_mesh(seed, 300, true);
    EXPECT_TRUE(test::identical(read_stl_binary(stl_binary_bytes(mesh), "x.stl"), mesh)) << seed;
    EXPECT_TRUE(test::identical(read_stl_ascii(stl_ascii_text(mesh), "x.stl"), mesh)) << seed;
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

TEST(Stl, corners_with_equal_coordinates_become_one_point_in_order_of_appearance) {
  const TriMesh expected = by_first_use(test::tetrahedron());
  EXPECT_TRUE(
      test::identical(read_stl_binary(stl_binary_bytes(test::tetrahedron()), "x.stl"), expected));
  EXPECT_TRUE(
      test::identical(read_stl_ascii(stl_ascii_text(test::tetrahedron()), "x.stl"), expected));
}

TEST(Stl, minus_zero_and_zero_are_the_same_corner) {
  std::string text = "solid\n" + kFacet + kFacet + "endsolid\n";
  text.replace(text.rfind("vertex 0 0 0"), 12, "vertex -0 0 -0.0");
  EXPECT_EQ(read_stl_ascii(text, "x.stl").points.size(), 3U);
}

TEST(Stl, ascii_blocks_keep_their_names_as_labels) {
  TriMesh mesh = test::labelled_tetrahedron();
  mesh.labels = {1, 0, 1, 0};
  mesh.names = {"inlet",
                "la r\xC3\xA9"
                "duction",
                "unused"};
  TriMesh expected = by_first_use(mesh);
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

TEST(Stl, an_empty_mesh_is_a_file) {
  EXPECT_TRUE(test::identical(read_stl_ascii(stl_ascii_text({}), "x.stl"), {}));
  EXPECT_TRUE(test::identical(read_stl_binary(stl_binary_bytes({}), "x.stl"), {}));
}

TEST(Stl, binary_keeps_one_name_and_tells_the_unit) {
  TriMesh mesh = by_first_use(test::tetrahedron());
  mesh.labels.assign(4, 0);
  mesh.names = {"pump house"};
  const std::string bytes = stl_binary_bytes(mesh, {"mm", "moved"});
  EXPECT_STREQ(bytes.substr(0, 80).c_str(), "dupin binary STL; unit: mm; moved; solid pump house");
  EXPECT_TRUE(test::identical(read_stl_binary(bytes, "x.stl"), mesh));

  const TriMesh two = read_stl_binary(stl_binary_bytes(test::labelled_tetrahedron()), "x.stl");
  EXPECT_TRUE(two.names.empty());
}

TEST(Stl, a_long_name_is_cut_between_characters) {
  TriMesh mesh = by_first_use(test::tetrahedron());
  mesh.labels.assign(4, 0);
  mesh.names = {""};
  for (int i = 0; i < 40; ++i) {
    mesh.names[0] += "\xC3\xA9";
  }
  const TriMesh read = read_stl_binary(stl_binary_bytes(mesh), "x.stl");
  EXPECT_EQ(read.names[0], mesh.names[0].substr(0, 56));  // 80 less "dupin binary STL; solid "
}

TEST(Stl, a_binary_file_may_begin_with_solid) {
  std::string bytes = stl_binary_bytes(test::tetrahedron());
  bytes.replace(0, 16, "solid from a tool");
  bytes.resize(bytes.size() - 1);
  EXPECT_TRUE(is_binary_stl(bytes));
  EXPECT_TRUE(is_binary_stl(bytes + std::string(3, '\0')));
  EXPECT_FALSE(is_binary_stl(stl_ascii_text(test::tetrahedron())));
  EXPECT_FALSE(is_binary_stl("solid"));
  EXPECT_TRUE(is_binary_stl("hello"));
}

TEST(Stl, a_point_beyond_binary32_is_unroundable) {
  TriMesh mesh = test::tetrahedron();
  mesh.points[1].x() = 1e39;
  for (const bool binary : {false, true}) {
    try {
      (void)(binary ? stl_binary_bytes(mesh) : stl_ascii_text(mesh));
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::unroundable);
      EXPECT_STREQ(error.what(),
                   "point 1 lies beyond the numbers this format holds (3.4e38); use OFF");
    }
  }
}

}  // namespace
}  // namespace dupin
