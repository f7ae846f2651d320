#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/sample_meshes.h"
#include "text/mesh_text.h"

namespace dupin::text {
namespace {

TEST(MeshText, points_are_rounded_to_what_the_format_holds) {
  TriMesh mesh = test::tetrahedron();
  mesh.points[1] = Vec3(0.1, -0.0, 16777217);
  const Vec3 held = writable_points(mesh, Coordinates::binary32)[1];
  EXPECT_EQ(held, Vec3(static_cast<double>(0.1F), 0, 16777216));
  EXPECT_FALSE(std::signbit(held.y()));
  EXPECT_EQ(writable_points(mesh, Coordinates::binary64)[1], mesh.points[1]);
}

TEST(MeshText, what_no_file_can_hold_is_refused) {
  const auto code_of = [](const TriMesh& mesh, Coordinates coordinates) {
    try {
      (void)writable_points(mesh, coordinates);
    } catch (const Error& error) {
      return error.code();
    }
    return Errc::cancelled;
  };
  TriMesh mesh = test::labelled_tetrahedron();
  EXPECT_EQ(code_of(mesh, Coordinates::binary32), Errc::cancelled) << "it is writable";
  mesh.points[0].x() = 1e39;
  EXPECT_EQ(code_of(mesh, Coordinates::binary32), Errc::unroundable);
  EXPECT_EQ(code_of(mesh, Coordinates::binary64), Errc::cancelled);
  mesh.points[0].x() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(code_of(mesh, Coordinates::binary64), Errc::invalid_argument);
  mesh = test::labelled_tetrahedron();
  mesh.triangles[0][2] = 4;
  EXPECT_EQ(code_of(mesh, Coordinates::binary64), Errc::invalid_argument);
  mesh = test::labelled_tetrahedron();
  mesh.labels.push_back(0);
  EXPECT_EQ(code_of(mesh, Coordinates::binary64), Errc::invalid_argument);
  mesh = test::labelled_tetrahedron();
  mesh.names.pop_back();
  EXPECT_EQ(code_of(mesh, Coordinates::binary64), Errc::invalid_argument);
}

TEST(MeshText, lines_are_valid_utf8_without_control_characters) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"", ""},
      {"  ", ""},
      {" a\tb\n", "a b"},
      {"\x7f", ""},
      {"\xC3\xA9", "\xC3\xA9"},
      {"\xE2\x82\xAC", "\xE2\x82\xAC"},
      {"\xF0\x9F\x98\x80", "\xF0\x9F\x98\x80"},
      {"\xC3", "\xEF\xBF\xBD"},
      {"\xC0\x80", "\xEF\xBF\xBD\xEF\xBF\xBD"},                  // overlong
      {"\xED\xA0\x80", "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD"},  // a surrogate
      {"\xF5"
       "a",
       "\xEF\xBF\xBD"
       "a"},
  };
  for (const auto& [line, clean] : table) {
    EXPECT_EQ(clean_line(line), clean);
    EXPECT_EQ(clean_line(clean), clean);
  }
}

TEST(MeshText, names_that_would_be_written_alike_have_numbers) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(written_names({"a\tb", "a\nb", "a b", "c", "c"}),
            (Names{"a b (2)", "a b (3)", "a b", "c", "c"}))
      << "equal names stay so";
  EXPECT_EQ(written_names({"a\tb", "a\nb", "a b (2)"}), (Names{"a b", "a b (3)", "a b (2)"}));
  EXPECT_EQ(written_names({"", "\t", "\n", "\t"}), (Names{"", "(2)", "(3)", "(2)"}));
  EXPECT_EQ(written_names({}), Names());
}

TEST(MeshText, header_lines_state_writer_unit_and_note) {
  EXPECT_EQ(header_lines({}, "# "), "# dupin\n");
  EXPECT_EQ(header_lines({"mm", "moved\nby 1"}, "# "), "# dupin\n# unit: mm\n# moved by 1\n");
}

TEST(MeshText, the_unit_is_found_in_a_line_of_its_own_among_the_first) {
  EXPECT_EQ(noted_unit("OFF\n" + header_lines({"in", ""}, "# "), "# "), "in");
  EXPECT_EQ(noted_unit("ply\r\ncomment unit: um \r\n", "comment "), "um");
  EXPECT_EQ(noted_unit("\xEF\xBB\xBF# unit: mm\n", "# "), "mm");
  EXPECT_EQ(noted_unit("# unit: mm\n", "comment "), "");
  EXPECT_EQ(noted_unit("no unit\n", "# "), "");
  const std::string late(600, '\n');
  EXPECT_EQ(noted_unit(late + "# unit: mm\n", "# "), "");
}

TEST(MeshText, a_unit_within_other_words_is_none) {
  for (const char* const line :
       {"# Temperature unit: m", "# unit: kelvin", "# unit: m8", "# unit: m, say",
        "# unit: ", "#unit: m", "g unit: m", "unit: m", "g x # unit: m", " # unit: m"}) {
    EXPECT_EQ(noted_unit(std::string(line) + '\n', "# "), "") << line;
  }
  EXPECT_EQ(noted_unit("ply\nend_header\ncomment unit: m\n", "comment "), "");
  EXPECT_EQ(noted_unit("comment label unit: m\n", "comment "), "");
}

TEST(MeshText, triangles_are_grouped_by_label_in_the_order_of_names) {
  TriMesh mesh = test::labelled_tetrahedron();
  mesh.labels = {2, 0, 2, 0};
  mesh.names = {"a", "unused", "c"};
  EXPECT_EQ(triangles_by_label(mesh),
            (std::vector<std::vector<std::uint32_t>>{{1, 3}, {}, {0, 2}}));
  EXPECT_EQ(triangles_by_label(test::tetrahedron()),
            (std::vector<std::vector<std::uint32_t>>{{0, 1, 2, 3}}));
}

TEST(MeshText, equal_names_share_one_label) {
  LabelBuilder builder;
  EXPECT_EQ(builder.label("b"), 0U);
  EXPECT_EQ(builder.label("a"), 1U);
  EXPECT_EQ(builder.label("b"), 0U);
  TriMesh mesh;
  std::move(builder).name_labels(mesh);
  EXPECT_EQ(mesh.names, (std::vector<std::string>{"b", "a"}));
}

}  // namespace
}  // namespace dupin::text
