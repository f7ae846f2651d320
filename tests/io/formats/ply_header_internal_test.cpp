#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "formats/ply_header.h"

namespace dupin::formats {
namespace {

const std::string kHeader =
    "ply\r\nformat binary_big_endian 1.0\ncomment by hand\ncomment label  the inlet \n"
    "obj_info 1\nelement vertex 3\nproperty float x\nproperty float64 y\n"
    "element face 7\nproperty list uchar int32 vertex_indices\nproperty short label\n"
    "end_header\n";

TEST(PlyHeader, tells_all_elements_and_where_the_numbers_begin) {
  const PlyHeader header = read_ply_header(kHeader + "\1\2", "x.ply");
  EXPECT_EQ(header.encoding, PlyEncoding::big_endian);
  EXPECT_EQ(header.size, kHeader.size());
  EXPECT_EQ(header.label_names, std::vector<std::string>{"the inlet"});
  ASSERT_EQ(header.elements.size(), 2U);
  EXPECT_EQ(header.elements[0].name, "vertex");
  EXPECT_EQ(header.elements[0].count, 3U);
  EXPECT_EQ(header.elements[0].place, kHeader.find("element vertex"));
  ASSERT_EQ(header.elements[0].properties.size(), 2U);
  EXPECT_EQ(header.elements[0].properties[0].type, PlyType::float32);
  EXPECT_EQ(header.elements[0].properties[1].type, PlyType::float64);
  EXPECT_EQ(header.elements[0].properties[1].name, "y");
  ASSERT_EQ(header.elements[1].properties.size(), 2U);
  EXPECT_TRUE(header.elements[1].properties[0].is_list);
  EXPECT_EQ(header.elements[1].properties[0].count_type, PlyType::uint8);
  EXPECT_EQ(header.elements[1].properties[0].type, PlyType::int32);
  EXPECT_FALSE(header.elements[1].properties[1].is_list);
  EXPECT_EQ(header.elements[1].properties[1].type, PlyType::int16);
}

TEST(PlyHeader, knows_the_least_room_of_an_element) {
  const PlyHeader header = read_ply_header(kHeader, "x.ply");
  EXPECT_EQ(header.elements[0].smallest_size(PlyEncoding::little_endian), 12U);
  EXPECT_EQ(header.elements[1].smallest_size(PlyEncoding::little_endian), 3U) << "an empty list";
  EXPECT_EQ(header.elements[0].smallest_size(PlyEncoding::ascii), 4U);
}

TEST(PlyHeader, types_have_their_sizes_under_both_names) {
  const std::vector<std::pair<std::string, std::size_t>> types = {
      {"char", 1},   {"int8", 1},    {"uchar", 1},  {"uint8", 1},  {"short", 2}, {"int16", 2},
      {"ushort", 2}, {"uint16", 2},  {"int", 4},    {"int32", 4},  {"uint", 4},  {"uint32", 4},
      {"float", 4},  {"float32", 4}, {"double", 8}, {"float64", 8}};
  for (const auto& [name, size] : types) {
    const PlyHeader header = read_ply_header(
        "ply\nformat ascii 1.0\nelement e 1\nproperty " + name + " p\nend_header\n", "x.ply");
    const PlyType type = header.elements.at(0).properties.at(0).type;
    EXPECT_EQ(size_of(type), size) << name;
    EXPECT_EQ(is_integer(type), name[0] != 'f' && name[0] != 'd') << name;
    EXPECT_EQ(is_4_byte_integer(type), is_integer(type) && size == 4) << name;
  }
}

TEST(PlyHeader, faults_are_told_with_their_line) {
  const auto message_of = [](const std::string& text) -> std::string {
    try {
      (void)read_ply_header(text, "x.ply");
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(message_of("plx\n"), "x.ply:1: found 'plx', expected 'ply'");
  EXPECT_EQ(message_of("ply\nformat ascii 2.0\n"),
            "x.ply:2: found '2.0', expected the version 1.0");
  EXPECT_EQ(message_of("ply\nformat ascii 1.0\nproperty int x\n"),
            "x.ply:3: found 'property', expected 'element', 'comment' or 'end_header'");
  EXPECT_EQ(message_of("ply\nformat ascii 1.0\nelement e 1\nproperty list float int x\n"),
            "x.ply:4: found a list whose length is no integer, expected an integer type");
  const std::string one = "ply\nformat ascii 1.0\nelement e 1\nproperty int x\n";
  EXPECT_EQ(message_of(one + "property float y\nproperty float x\n"),
            "x.ply:6: the element 'e' has the property 'x' twice");
  EXPECT_EQ(message_of(one + "element f 1\nproperty int x\nend_header\n"), "no error");
  EXPECT_EQ(message_of("ply\nformat ascii 1.0\nelement e -1\n").substr(0, 22),
            "x.ply:3: found '-1', e");
}

}  // namespace
}  // namespace dupin::formats
