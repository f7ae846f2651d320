#include "dupin/io/ply.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "io/formats/creased.h"
#include "support/malformed.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

const std::string kAsciiHead =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
const std::string kAsciiBody = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

TEST(Ply, both_kinds_read_back_bit_for_bit_what_they_write) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    TriMesh mesh = test::scattered_mesh(seed, 300, false);
    EXPECT_TRUE(test::identical(read_ply(ply_ascii_text(mesh), "x.ply"), mesh));
    EXPECT_TRUE(test::identical(read_ply(ply_binary_bytes(mesh), "x.ply"), mesh));
    mesh.names = {"a", "unused", "z\xC3\xA9 #1"};
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      mesh.labels.push_back(i % 7 == 0 ? 2 : 0);
    }
    EXPECT_TRUE(test::identical(read_ply(ply_ascii_text(mesh), "x.ply"), mesh));
    EXPECT_TRUE(test::identical(read_ply(ply_binary_bytes(mesh), "x.ply"), mesh));
  }
}

TEST(Ply, text_is_as_documented) {
  TriMesh mesh = test::labelled_tetrahedron();
  mesh.triangles.resize(3);
  mesh.labels.resize(3);
  mesh.points[0].x() = -0.0;
  EXPECT_EQ(ply_ascii_text(mesh, {"in", "moved"}),
            "ply\nformat ascii 1.0\ncomment dupin\ncomment unit: in\ncomment moved\n"
            "comment label inlet\ncomment label the blend\nelement vertex 4\nproperty double x\n"
            "property double y\nproperty double z\nelement face 3\n"
            "property list uchar int vertex_indices\nproperty int label\nend_header\n"
            "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1 0\n3 0 1 3 0\n3 0 3 2 1\n");
}

TEST(Ply, points_with_several_normals_are_written_as_copies_and_read_as_one) {
  MeshHeader header;
  header.normals = test::creased_normals();
  const TriMesh mesh = test::labelled_tetrahedron();
  const std::string text = ply_ascii_text(mesh, header);
  EXPECT_EQ(text,
            "ply\nformat ascii 1.0\ncomment dupin\ncomment label inlet\ncomment label the blend\n"
            "element vertex 8\nproperty double x\nproperty double y\nproperty double z\n"
            "property float nx\nproperty float ny\nproperty float nz\nproperty int dupin_point\n"
            "element face 4\nproperty list uchar int vertex_indices\nproperty int label\n"
            "end_header\n"
            "0 0 0 0 -0.6 -0.8 0\n1 0 0 0 -0.6 -0.8 1\n0 1 0 0 -0.6 -0.8 2\n0 0 1 0 -0.6 -0.8 3\n"
            "0 0 0 0.36 0.48 0.8 0\n0 0 1 0.36 0.48 0.8 3\n0 1 0 0.36 0.48 0.8 2\n"
            "1 0 0 0.36 0.48 0.8 1\n3 0 2 1 0\n3 0 1 3 0\n3 4 5 6 1\n3 7 6 5 1\n");
  EXPECT_TRUE(test::identical(read_ply(text, "x.ply"), mesh));
  EXPECT_TRUE(test::identical(read_ply(ply_binary_bytes(mesh, header), "x.ply"), mesh));
  header.normals.assign(4, {Direction{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
  const std::string smooth = ply_ascii_text(mesh, header);
  EXPECT_NE(smooth.find("0 0 1 0 0 1\n3 0 2 1 0\n"), std::string::npos);
  EXPECT_EQ(smooth.find("dupin_point"), std::string::npos);
  EXPECT_TRUE(test::identical(read_ply(smooth, "x.ply"), mesh));
}

TEST(Ply, copies_that_are_none_are_refused) {
  MeshHeader header;
  header.normals = test::creased_normals();
  const std::string text = ply_ascii_text(test::tetrahedron(), header);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    return other.replace(other.find(from), from.size(), to);
  };
  const std::string what =
      "found other numbers as 'dupin_point' of the vertices, expected points with their own, and "
      "copies of them behind";
  test::expect_refused(read_ply, "x.ply",
                       {{changed("0.36 0.48 0.8 3", "0.36 0.48 0.8 2"), "x.ply:4: " + what},
                        {changed("0 0 1 0 -0.6 -0.8 3", "0 0 1 0 -0.6 -0.8 1"), "x.ply:4: " + what},
                        {changed("0.36 0.48 0.8 3", "0.36 0.48 0.8 5"), "x.ply:4: " + what}});
}

TEST(Ply, reads_other_writers_text) {
  const std::vector<std::string> files = {
      kAsciiHead + kAsciiBody,
      "ply\r\nformat ascii 1.0\r\nobj_info none\r\nelement camera 2\r\nproperty list uint8 float32 "
      "m\r\n"
      "element vertex 4\r\nproperty uchar red\r\nproperty double z\r\nproperty double y\r\n"
      "property double x\r\nelement face 4\r\nproperty list uint uint vertex_index\r\n"
      "property list uchar float texcoord\r\nelement empty 4000000000\r\nend_header\r\n"
      "2 0.5 nan\r\n0\r\n255 0 0 0\r\n255 0 0 1\r\n255 0 1 0\r\n255 1 0 0\r\n"
      "3 0 2 1 0\r\n3 0 1 3 1 0.5\r\n3 0 3 2 0\r\n3 1 2 3 0\r\n"};
  for (const std::string& file : files) {
    EXPECT_TRUE(test::identical(read_ply(file, "x.ply"), test::tetrahedron()));
  }
}

TEST(Ply, numbers_of_colours_may_be_none) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "property float red\nelement face 4\nproperty list uchar int vertex_indices\n"
      "property float green\nend_header\n0 0 0 nan\n1 0 0 inf\n0 1 0 -nan(ind)\n0 0 1 1e999\n"
      "3 0 2 1 nan\n3 0 1 3 inf\n3 0 3 2 -inf\n3 1 2 3 1.#IND\n";
  EXPECT_TRUE(test::identical(read_ply(text, "x.ply"), test::tetrahedron()));
}

TEST(Ply, points_without_faces_are_no_mesh) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\n";
  const std::string faces = "property list uchar int vertex_indices\nend_header\n0 0 0\n";
  const std::string what = "found 1 vertices and no face, expected an element 'face' with some";
  test::expect_refused(
      read_ply, "x.ply",
      {{head + "end_header\n0 0 0\n", "x.ply:3: " + what},
       {head + "element face 0\n" + faces, "x.ply:7: " + what},
       {head + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n0\n",
        "x.ply:3: " + what}});
  EXPECT_TRUE(test::identical(read_ply(ply_binary_bytes({}), "x.ply"), {})) << "the empty set";
}

TEST(Ply, big_endian_reads_like_little_endian) {
  std::string big =
      "ply\nformat binary_big_endian 1.0\nelement vertex 4\nproperty float x\nproperty short y\n"
      "property double z\nelement face 4\nproperty list uchar ushort vertex_indices\nend_header\n";
  const auto append = [&](auto number) {
    std::string raw(sizeof number, '\0');
    std::memcpy(raw.data(), &number, sizeof number);
    std::reverse(raw.begin(), raw.end());
    big += raw;
  };
  const TriMesh mesh = test::tetrahedron();
  for (const Vec3& point : mesh.points) {
    append(static_cast<float>(point.x()));
    append(static_cast<std::int16_t>(point.y()));
    append(point.z());
  }
  for (const Triangle& triangle : mesh.triangles) {
    append(std::uint8_t{3});
    for (const std::uint32_t corner : triangle) {
      append(static_cast<std::uint16_t>(corner));
    }
  }
  EXPECT_TRUE(test::identical(read_ply(big, "x.ply"), mesh));
}

/// A pyramid over a square in bytes of either order, its lists of these types.
template <typename Count, typename Index>
std::string pyramid(bool big, const std::string& count, const std::string& index) {
  std::string bytes = "ply\nformat binary_" + std::string(big ? "big" : "little") +
                      "_endian 1.0\nelement vertex 5\nproperty char x\nproperty char y\n"
                      "property char z\nelement face 5\nproperty list " +
                      count + ' ' + index + " vertex_indices\nend_header\n";
  bytes += std::string("\0\0\0\1\0\0\1\1\0\0\1\0\0\0\1", 15);
  const auto append = [&](auto number) {
    std::string raw(sizeof number, '\0');
    std::memcpy(raw.data(), &number, sizeof number);
    if (big) {
      std::reverse(raw.begin(), raw.end());
    }
    bytes += raw;
  };
  const std::vector<std::vector<int>> faces = {
      {0, 1, 4}, {0, 3, 2, 1}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  for (const std::vector<int>& face : faces) {
    append(static_cast<Count>(face.size()));
    for (const int corner : face) {
      append(static_cast<Index>(corner));
    }
  }
  return bytes;
}

TEST(Ply, binary_lists_of_all_types_read_alike) {
  const TriMesh mesh = read_ply(pyramid<std::uint8_t, std::int32_t>(false, "uchar", "int"), "x");
  EXPECT_EQ(mesh.triangles.size(), 6U);
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 1, 4}));
  EXPECT_EQ(mesh.triangles[5], (Triangle{3, 0, 4}));
  for (const bool big : {false, true}) {
    for (const std::string& file : {pyramid<std::uint8_t, std::int32_t>(big, "uchar", "int"),
                                    pyramid<std::uint8_t, std::uint32_t>(big, "uchar", "uint"),
                                    pyramid<std::int8_t, std::int32_t>(big, "char", "int"),
                                    pyramid<std::int32_t, std::uint32_t>(big, "int", "uint"),
                                    pyramid<std::uint8_t, std::uint16_t>(big, "uchar", "ushort"),
                                    pyramid<std::uint16_t, std::int8_t>(big, "ushort", "char")}) {
      EXPECT_TRUE(test::identical(read_ply(file, "x"), mesh)) << file.substr(0, 220);
    }
  }
}

TEST(Ply, polygons_are_cut_and_keep_their_label) {
  const TriMesh mesh = read_ply(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty int x\nproperty int y\nproperty int z\n"
      "element face 1\nproperty list uchar int vertex_indices\nproperty int label\nend_header\n"
      "0 0 0\n4 0 0\n1 1 0\n0 4 0\n4 0 1 2 3 5\n",
      "x.ply");
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.labels, (std::vector<std::uint32_t>{0, 0}));
  EXPECT_EQ(mesh.names, std::vector<std::string>{"label 5"});
}

const std::string kStripsHead =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty int x\nproperty int y\nproperty int z\n";
const std::string kStrips = "element tristrips 2\nproperty list int int vertex_indices\n";
const std::string kPoints = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

TEST(Ply, strips_are_triangles_beside_faces) {
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  EXPECT_EQ(read_ply(kStripsHead + kStrips + "end_header\n" + kPoints +
                         "9 0 2 1 -1 0 1 3 -1 2\n5 1 2 2 3 0\n",
                     "x.ply")
                .triangles,
            (std::vector<Triangle>{{0, 2, 1}, {0, 1, 3}, {2, 3, 0}}));
  EXPECT_EQ(
      read_ply(kStripsHead + faces + kStrips + "end_header\n" + kPoints + "3 0 2 1\n4 0 1 3 2\n0\n",
               "x.ply")
          .triangles,
      (std::vector<Triangle>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}));
}

TEST(Ply, triangles_of_strips_have_a_label_where_faces_have) {
  const std::string faces =
      "element face 1\nproperty list uchar int vertex_indices\nproperty int label\n";
  const TriMesh after = read_ply(
      kStripsHead + faces + kStrips + "end_header\n" + kPoints + "3 0 2 1 5\n4 0 1 3 2\n0\n",
      "x.ply");
  EXPECT_EQ(after.labels, (std::vector<std::uint32_t>{0, 1, 1}));
  EXPECT_EQ(after.names, (std::vector<std::string>{"label 5", "tristrips"}));
  const TriMesh before = read_ply(
      kStripsHead + kStrips + faces + "end_header\n" + kPoints + "4 0 1 3 2\n0\n3 0 2 1 5\n",
      "x.ply");
  EXPECT_EQ(before.labels, (std::vector<std::uint32_t>{0, 0, 1}));
  EXPECT_EQ(before.names, (std::vector<std::string>{"tristrips", "label 5"}));
}

TEST(Ply, strips_that_are_none_are_refused) {
  test::expect_refused(
      read_ply, "x.ply",
      {
          {kStripsHead + "element tristrips 1\nproperty int n\nend_header\n" + kPoints + "1\n",
           "x.ply:7: found an element 'tristrips' without a list of integers 'vertex_indices', "
           "expected one"},
          {kStripsHead + kStrips + "end_header\n" + kPoints + "3 0 1 4\n0\n",
           "x.ply:14: found '4', expected the index of a vertex or -1, an integer from -1 to 3"},
      });
}

TEST(Ply, malformed_files_are_refused_with_their_place) {
  const std::string format = "ply\nformat ascii 1.0\n";
  const std::string vertex = "element vertex 1\nproperty float x\nproperty float y\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string binary = ply_binary_bytes(test::tetrahedron());
  std::string nan = binary;
  const std::size_t body = binary.find("end_header\n") + 11;
  nan.replace(body + 8, 8, std::string("\0\0\0\0\0\0\xf8\x7f", 8));
  std::string index = binary;
  index[body + 96 + 1] = '\x04';
  std::string negative = binary;
  negative[body + 96 + 4] = '\xff';
  std::string few = binary;
  few[body + 96] = '\x02';
  std::string many = binary;
  many[body + 96 + 39] = '\x09';
  test::expect_refused(
      read_ply, "x.ply",
      {
          {"", "x.ply:1: found the end of the file, expected 'ply'"},
          {"ply2\n", "x.ply:1: found 'ply2', expected 'ply'"},
          {"ply\nelement\n", "x.ply:2: found 'element', expected 'format'"},
          {"ply\nformat ebcdic 1.0\n",
           "x.ply:2: found 'ebcdic', expected ascii, binary_little_endian or binary_big_endian"},
          {"ply\nformat ascii 2.0\n", "x.ply:2: found '2.0', expected the version 1.0"},
          {format,
           "x.ply:3: found the end of the file, expected 'element', 'comment' or 'end_header'"},
          {format + "property float x\n",
           "x.ply:3: found 'property', expected 'element', 'comment' or 'end_header'"},
          {format + "element vertex many\n", "x.ply:3: found 'many', expected a count, an integer"},
          {format + "element vertex -1\n",
           "x.ply:3: found '-1', expected a count, an integer from 0 to 4294967295"},
          {format + "element\n",
           "x.ply:3: found the end of the line, expected the name of an element"},
          {format + "element vertex 1\nproperty half x\n",
           "x.ply:4: found 'half', expected a type, such as uchar, int, float or double"},
          {format + "element face 1\nproperty list float int vertex_indices\n",
           "x.ply:4: found a list whose length is no integer, expected an integer type"},
          {format + "end_header\n", "x.ply:1: found no element 'vertex', expected one"},
          {format + vertex + "end_header\n1 2\n",
           "x.ply:3: found an element 'vertex' without a number 'z', expected x, y and z"},
          {format + faces + "3 0 0 0\n",
           "x.ply:3: found the element 'face', expected 'vertex' before it"},
          {format + vertex +
               "property float z\nelement face 1\nproperty uchar n\nend_header\n0 0 0\n0\n",
           "x.ply:7: found an element 'face' without a list of integers 'vertex_indices', expected "
           "one"},
          {format + "element vertex 4000000000\nproperty float x\nend_header\n0 0 0\n",
           "x.ply:3: found a count of 4000000000 elements 'vertex', expected at least 8000000000 "
           "bytes for them, not 7"},
          {format + vertex + "property float z\n" + faces + "0 0\n3 0 0 0\n",
           "x.ply:10: found the end of the line, expected a coordinate"},
          {format + vertex + "property float z\n" + faces + "0 0 inf\n3 0 0 0\n",
           "x.ply:10: found 'inf', expected a coordinate that is finite"},
          {format + vertex + "property float z\n" + faces + "0 0 0 0\n3 0 0 0\n",
           "x.ply:10: found '0', expected the end of the element's line"},
          {format + vertex + "property float z\n" + faces + "0 0 0\n3 0 0 1\n",
           "x.ply:11: found '1', expected the index of a vertex, an integer from 0 to 0"},
          {format + vertex + "property float z\n" + faces + "0 0 0\n2 0 0\n",
           "x.ply:11: found '2', expected the number of a face's vertices, an integer from 3 to "
           "4294967295"},
          {format + vertex + "property float z\n" + faces + "0 0 0\n3 0 0\n",
           "x.ply:11: found the end of the line, expected the index of a vertex, an integer"},
          {format + vertex + "property float z\n" + faces + "0 0 0\n3 0 0 0\nmore\n",
           "x.ply:12: found 'more', expected the end of the file behind the last element"},
          {nan, "x.ply:byte " + std::to_string(body + 8) +
                    ": found nan, expected a coordinate that is finite"},
          {index, "x.ply:byte " + std::to_string(body + 97) +
                      ": found 4, expected the index of a vertex, an integer from 0 to 3"},
          {negative,
           "x.ply:byte " + std::to_string(body + 97) +
               ": found -16777216, expected the index of a vertex, an integer from 0 to 3"},
          {few, "x.ply:byte " + std::to_string(body + 96) +
                    ": found 2, expected the number of a face's vertices, an integer from 3 to "
                    "4294967295"},
          {many, "x.ply:byte " + std::to_string(binary.size()) +
                     ": found the end of the file, expected a number of 4 bytes"},
          {binary.substr(0, body + 90),
           "x.ply:4: found a count of 4 elements 'vertex', expected at least 96 bytes for them, "
           "not 90"},
          {binary.substr(0, binary.size() - 1),
           "x.ply:byte " + std::to_string(binary.size() - 4) +
               ": found the end of the file, expected a number of 4 bytes"},
          {binary + "xy",
           "x.ply:byte " + std::to_string(binary.size()) +
               ": found 2 more bytes, expected the end of the file behind the last element"},
      });
}

}  // namespace
}  // namespace dupin
