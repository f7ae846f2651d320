#include <string>

#include <gtest/gtest.h>

#include "dupin/io/mesh_file.h"
#include "io/text/utf16_text.h"
#include "text/utf16.h"

namespace dupin::text {
namespace {

using test::utf16;

TEST(Utf16, is_told_by_its_mark_and_by_zeros) {
  for (const bool is_big : {false, true}) {
    EXPECT_TRUE(is_utf16(utf16("UNITS-BORE MM\r\nPIPE and more\r\n", is_big, false)));
    EXPECT_TRUE(is_utf16(utf16("{}", is_big, false)));
    EXPECT_TRUE(is_utf16(utf16("", is_big, true)));
  }
  for (const std::string& other :
       {std::string(), std::string("{}"), std::string("\0a", 2), std::string(80, '\0'),
        std::string("\0a\0\0", 4), std::string("a\0bc", 4), std::string("\xEF\xBB\xBF{}")}) {
    EXPECT_FALSE(is_utf16(other)) << other;
    EXPECT_NO_THROW(refuse_utf16(other, "a"));
  }
}

TEST(Utf16, is_said_by_every_reader_of_meshes) {
  const auto mesh = [](const std::string& text, const std::string& file) {
    (void)read_mesh(text, file);
  };
  test::expect_utf16_refused("OFF\n0 0 0\n", "a.off", mesh);
  test::expect_utf16_refused("v 0 0 0\n", "a.obj", mesh);
  test::expect_utf16_refused("ply\nformat ascii 1.0\n", "a.ply", mesh);
  test::expect_utf16_refused("solid a\nendsolid a\n", "a.stl", mesh);
  test::expect_utf16_refused("OFF\n0 0 0\n", "standard input", mesh);
}

}  // namespace
}  // namespace dupin::text
