#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "formats/vtk_arrays.h"
#include "support/sample_meshes.h"
#include "text/little_endian.h"

namespace dupin::formats {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr VtkEncoding kOurs{false, sizeof(std::uint64_t)};

/// The array that was appended, as a reader finds it.
VtkArray array_of(const std::string& text, const std::string& type) {
  const std::size_t begin = text.find('>') + 1, end = text.find('<', begin);
  return {"x", type, "binary", text.substr(begin, end - begin)};
}

TEST(VtkArrays, read_back_as_they_were) {
  std::string bytes, text;
  for (const double number : {0.1, -0.0, 1e300}) {
    text::store(bytes, number);
  }
  append_vtk_array<double>(text, "Name=\"x\"", bytes);
  EXPECT_THAT(text, HasSubstr("<DataArray type=\"Float64\" Name=\"x\" format=\"binary\">"));
  EXPECT_THAT(vtk_numbers<double>(array_of(text, "Float64"), kOurs), ElementsAre(0.1, 0, 1e300));
  EXPECT_THAT(vtk_numbers<std::int64_t>({"x", "Int32", "ascii", " 1 -2\n3 "}, {}),
              ElementsAre(1, -2, 3));
}

TEST(VtkArrays, that_cannot_be_read_say_why) {
  std::string text;
  append_vtk_array<std::int32_t>(text, "Name=\"x\"", std::string(6, '\1'));
  const std::pair<VtkArray, const char*> cases[] = {
      {array_of(text, "Int32"), "expected a multiple of 4"},
      {array_of(text, "Complex"), "expected a number's"},
      {array_of(text, "Float64"), "expected a multiple of 8"},
      {{"x", "Int32", "appended", ""}, "in the format 'appended'"},
      {{"x", "Int32", "ascii", "1 b"}, "expected a number"},
      {{"x", "Int32", "binary", "AAAA"}, "found no base64"},
  };
  for (const auto& [array, words] : cases) {
    try {
      (void)vtk_numbers<std::int64_t>(array, kOurs);
      ADD_FAILURE() << words;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::parse_failed);
      EXPECT_THAT(error.what(), HasSubstr(words));
    }
  }
}

TEST(VtkArrays, parts_are_what_labels_begin_with) {
  const VtkParts parts({"run.start", "branch", "run.end", "run"});
  EXPECT_THAT(parts.names, ElementsAre("run", "branch"));
  EXPECT_THAT(parts.of_label, ElementsAre(0, 1, 0, 0));
}

TEST(VtkArrays, of_cells_without_a_label_have_minus_one) {
  const TriMesh mesh = test::labelled_tetrahedron();
  std::string text;
  append_vtk_cell_data(text, mesh, {}, VtkParts(mesh.names), 2);
  const std::size_t begin = text.find("<DataArray");
  const auto labels = vtk_numbers<std::int64_t>(array_of(text.substr(begin), "Int32"), kOurs);
  ASSERT_EQ(labels.size(), mesh.triangles.size() + 2);
  EXPECT_EQ(labels.back(), -1);
  EXPECT_EQ(labels.front(), mesh.labels.front());
}

}  // namespace
}  // namespace dupin::formats
