#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "dupin/io/assembly_json.h"
#include "dupin/io/graph_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/pcf.h"
#include "dupin/kernel/error.h"
#include "text/utf16.h"

namespace dupin::text {
namespace {

std::string utf16(std::string_view text, bool is_big, bool has_mark) {
  std::string result = !has_mark ? "" : is_big ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : text) {
    result += is_big ? std::string{'\0', c} : std::string{c, '\0'};
  }
  return result;
}

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

TEST(Utf16, is_said_by_every_reader_of_text) {
  const auto expect = [](std::string_view text, const std::string& file, auto read) {
    for (const bool is_big : {false, true}) {
      for (const bool has_mark : {false, true}) {
        try {
          read(utf16(text, is_big, has_mark), file);
          ADD_FAILURE() << file;
        } catch (const Error& error) {
          EXPECT_EQ(std::string(error.what()),
                    file + ": the text is in UTF-16, expected UTF-8; save it as that");
        }
      }
    }
  };
  const auto mesh = [](const std::string& text, const std::string& file) {
    (void)read_mesh(text, file);
  };
  expect("OFF\n0 0 0\n", "a.off", mesh);
  expect("v 0 0 0\n", "a.obj", mesh);
  expect("ply\nformat ascii 1.0\n", "a.ply", mesh);
  expect("solid a\nendsolid a\n", "a.stl", mesh);
  expect("OFF\n0 0 0\n", "standard input", mesh);
  expect(
      R"({"units": "mm", "parts": []})", "a.json",
      [](const std::string& text, const std::string& file) { (void)parse_assembly(text, file); });
  expect("UNITS-BORE MM\n", "a.pcf",
         [](const std::string& text, const std::string& file) { (void)parse_pcf(text, file); });
  for (const std::string name : {"a.swc", "a.graph", "a"}) {
    expect("1 0 0 0 0 2 -1\n", name, [](const std::string& text, const std::string& file) {
      (void)parse_graph_file(text, file);
    });
  }
}

}  // namespace
}  // namespace dupin::text
