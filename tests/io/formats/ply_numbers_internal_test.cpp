#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "formats/ply_numbers.h"
#include "support/message_of.h"

namespace dupin::formats {
namespace {

using test::message_of;

TEST(PlyNumbers, of_bytes_are_read_in_either_order) {
  std::string bytes = "head";
  text::store(bytes, std::int16_t{-2});
  text::store(bytes, 0.5F);
  text::store(bytes, std::uint8_t{200});
  PlyByteNumbers little(bytes, "x", {PlyEncoding::little_endian, {}, {}, 4});
  EXPECT_EQ(little.integer(PlyType::int16, -5, 5, "n"), -2);
  EXPECT_EQ(little.number(PlyType::float32, "n"), 0.5);
  EXPECT_EQ(little.remaining(), 1U);
  EXPECT_EQ(little.integer(PlyType::uint8, 0, 255, "n"), 200);
  little.end();

  std::reverse(bytes.begin() + 4, bytes.begin() + 6);
  std::reverse(bytes.begin() + 6, bytes.begin() + 10);
  PlyByteNumbers big(bytes, "x", {PlyEncoding::big_endian, {}, {}, 4});
  EXPECT_EQ(big.integer(PlyType::int16, -5, 5, "n"), -2);
  EXPECT_EQ(big.number(PlyType::float32, "n"), 0.5);
  EXPECT_EQ(message_of([&] { big.end(); }),
            "x:byte 10: found 1 more bytes, expected the end of the file behind the last element");
}

TEST(PlyNumbers, of_bytes_are_refused_with_their_byte) {
  std::string bytes(2, '\xff');
  const PlyHeader header{PlyEncoding::little_endian, {}, {}, 0};
  EXPECT_EQ(message_of([&] {
              PlyByteNumbers(bytes, "x", header).integer(PlyType::uint16, 0, 9, "a label");
            }),
            "x:byte 0: found 65535, expected a label from 0 to 9");
  EXPECT_EQ(message_of([&] { PlyByteNumbers(bytes, "x", header).number(PlyType::float32, "n"); }),
            "x:byte 0: found the end of the file, expected a number of 4 bytes");
  bytes.append(2, '\xff');
  EXPECT_EQ(message_of([&] { PlyByteNumbers(bytes, "x", header).number(PlyType::float32, "n"); }),
            "x:byte 0: found -nan, expected n that is finite");
}

TEST(PlyNumbers, plain_triangles_are_recognised_only_if_they_are_valid) {
  std::string bytes(1, '\3');
  text::store(bytes, Triangle{0, 1, 2});
  const PlyHeader little{PlyEncoding::little_endian, {}, {}, 0};
  const PlyProperty list{"vertex_indices", PlyType::int32, true, PlyType::uint8};
  const auto at_triangle = [&](const PlyProperty& property, std::size_t points,
                               const PlyHeader& header) {
    return PlyByteNumbers(bytes, "x", header).at_triangle(property, points);
  };
  EXPECT_TRUE(at_triangle(list, 3, little));
  EXPECT_FALSE(at_triangle(list, 2, little)) << "an index out of range";
  EXPECT_FALSE(at_triangle(list, 3, {PlyEncoding::big_endian, {}, {}, 0}));
  EXPECT_FALSE(at_triangle({"x", PlyType::int16, true, PlyType::uint8}, 3, little));
  EXPECT_FALSE(at_triangle({"x", PlyType::int32, true, PlyType::int32}, 3, little));
  PlyByteNumbers numbers(bytes, "x", little);
  EXPECT_EQ(numbers.take_triangle(), (Triangle{0, 1, 2}));
  EXPECT_EQ(numbers.remaining(), 0U);
  bytes[0] = '\4';
  EXPECT_FALSE(at_triangle(list, 3, little)) << "a quadrilateral";
  bytes = bytes.substr(0, 12);
  bytes[0] = '\3';
  EXPECT_FALSE(at_triangle(list, 3, little)) << "cut off";
}

TEST(PlyNumbers, of_text_stand_one_element_to_a_line) {
  const PlyHeader header{PlyEncoding::ascii, {}, {}, 2};
  PlyTextNumbers numbers("h\n1.5 7 red\n2 8\n", "x", header);
  numbers.begin_element();
  EXPECT_EQ(numbers.number(PlyType::float32, "n"), 1.5);
  EXPECT_EQ(numbers.integer(PlyType::uint8, 0, 9, "n"), 7);
  numbers.skip(PlyType::uint8);
  numbers.end_element();
  numbers.begin_element();
  numbers.skip(PlyType::float32);
  EXPECT_EQ(message_of([&] { numbers.end_element(); }),
            "x:3: found '8', expected the end of the element's line");
  numbers.skip(PlyType::float32);
  EXPECT_EQ(message_of([&] { numbers.skip(PlyType::float32); }),
            "x:3: found the end of the line, expected a number");
}

}  // namespace
}  // namespace dupin::formats
