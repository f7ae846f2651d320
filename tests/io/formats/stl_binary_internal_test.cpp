#include <algorithm>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "dupin/io/mesh_file.h"
#include "dupin/io/stl.h"
#include "formats/stl_binary.h"
#include "io/formats/first_use.h"
#include "support/malformed.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

constexpr std::size_t kCount = 80, kPreamble = 84, kNormal = 12, kCorners = 36, kFacet = 50;

const TriMesh& mesh() {
  static const TriMesh sample = test::scattered_mesh(1, 4, true);
  return sample;
}

/// The bytes of a binary STL with its facets in this order.
std::string with_facets(const std::string& bytes, std::initializer_list<std::size_t> order) {
  std::string other = bytes.substr(0, kPreamble);
  other[kCount] = static_cast<char>(order.size());
  for (const std::size_t facet : order) {
    other += bytes.substr(kPreamble + facet * kFacet, kFacet);
  }
  return other;
}

TEST(StlLists, holds_for_what_is_written) {
  EXPECT_TRUE(formats::stl_binary_lists(mesh(), stl_binary_bytes(mesh())));
  EXPECT_TRUE(
      formats::stl_binary_lists(test::tetrahedron(), stl_binary_bytes(test::tetrahedron())));
  EXPECT_TRUE(formats::stl_binary_lists({}, stl_binary_bytes({})));
}

TEST(StlLists, notices_every_bit_of_the_count_and_of_the_corners_and_no_other) {
  const std::string bytes = stl_binary_bytes(mesh());
  for (std::size_t place = 0; place < bytes.size(); ++place) {
    const std::size_t in_facet = place < kPreamble ? 0 : (place - kPreamble) % kFacet;
    const bool counts = (place >= kCount && place < kPreamble) ||
                        (in_facet >= kNormal && in_facet < kNormal + kCorners);
    for (unsigned bit = 0; bit < 8; ++bit) {
      std::string damaged = bytes;
      damaged[place] = static_cast<char>(static_cast<unsigned char>(damaged[place]) ^ (1U << bit));
      EXPECT_NE(formats::stl_binary_lists(mesh(), damaged), counts)
          << "byte " << place << ", bit " << bit;
    }
  }
}

TEST(StlLists, notices_missing_further_repeated_and_exchanged_facets) {
  const std::string bytes = stl_binary_bytes(mesh());
  EXPECT_TRUE(formats::stl_binary_lists(mesh(), with_facets(bytes, {0, 1, 2, 3})));
  EXPECT_FALSE(formats::stl_binary_lists(mesh(), with_facets(bytes, {})));
  EXPECT_FALSE(formats::stl_binary_lists(mesh(), with_facets(bytes, {0, 1, 2})));
  EXPECT_FALSE(formats::stl_binary_lists(mesh(), with_facets(bytes, {0, 1, 2, 3, 3})));
  EXPECT_FALSE(formats::stl_binary_lists(mesh(), with_facets(bytes, {0, 1, 2, 2})));
  EXPECT_FALSE(formats::stl_binary_lists(mesh(), with_facets(bytes, {1, 0, 2, 3})));
  TriMesh turned = mesh();
  std::ranges::rotate(turned.triangles[3], turned.triangles[3].begin() + 1);
  EXPECT_FALSE(formats::stl_binary_lists(turned, bytes)) << "corners in another order";
}

TEST(StlLists, notices_where_the_file_ends) {
  const std::string bytes = stl_binary_bytes(mesh());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(formats::stl_binary_lists(mesh(), bytes.substr(0, size))) << size;
  }
  EXPECT_FALSE(formats::stl_binary_lists(mesh(), bytes + '\0'));
}

TEST(StlLists, notices_numbers_that_the_format_does_not_hold) {
  TriMesh finer = mesh();
  finer.points.back().x() *= 1 + 0x1p-40;
  EXPECT_FALSE(formats::stl_binary_lists(finer, stl_binary_bytes(finer)));
}

TEST(Stl, a_binary_header_states_a_unit_as_we_write_it_or_none) {
  EXPECT_EQ(formats::stl_unit(stl_binary_bytes(mesh(), {"um", ""})), "um");
  EXPECT_EQ(formats::stl_unit(stl_binary_bytes(mesh(), {"in", "moved"})), "in");
  for (const char* const header :
       {"unit: inch", "dupin binary STL; unit: inch", "dupin binary STL; solid x; unit: mm",
        "dupin binary STL; solid pump unit: m", "exported, unit: mm", "dupin binary STL", ""}) {
    EXPECT_EQ(formats::stl_unit(header), "") << header;
  }
}

TEST(Stl, binary_keeps_one_name_and_tells_the_unit) {
  TriMesh mesh = test::by_first_use(test::tetrahedron());
  mesh.labels.assign(4, 0);
  mesh.names = {"pump house"};
  const std::string bytes = stl_binary_bytes(mesh, {"mm", "moved"});
  EXPECT_STREQ(bytes.substr(0, 80).c_str(), "dupin binary STL; unit: mm; moved; solid pump house");
  EXPECT_TRUE(test::identical(read_stl_binary(bytes, "x.stl"), mesh));

  const TriMesh two = read_stl_binary(stl_binary_bytes(test::labelled_tetrahedron()), "x.stl");
  EXPECT_TRUE(two.names.empty());
}

TEST(Stl, a_long_name_is_cut_between_characters) {
  TriMesh mesh = test::by_first_use(test::tetrahedron());
  mesh.labels.assign(4, 0);
  mesh.names = {""};
  for (int i = 0; i < 40; ++i) {
    mesh.names[0] += "\xC3\xA9";
  }
  const TriMesh read = read_stl_binary(stl_binary_bytes(mesh), "x.stl");
  EXPECT_EQ(read.names[0], mesh.names[0].substr(0, 56));  // 80 less "dupin binary STL; solid "
}

TriMesh read_any(std::string_view bytes, std::string_view file) { return read_mesh(bytes, file); }

TEST(MalformedMesh, binary_stl_is_refused_with_its_byte) {
  const std::string good = stl_binary_bytes(test::tetrahedron());
  std::string nan = good;
  nan.replace(84 + 50 + 24, 4, "\xff\xff\xff\x7f");
  std::string infinite = good;
  infinite.replace(84 + 12, 4, std::string("\0\0\x80\xff", 4));
  std::string huge = good;
  huge.replace(80, 4, "\xff\xff\xff\xff");
  std::string solid = good;
  solid.replace(0, 5, "solid");
  test::expect_refused(
      read_any, "a.stl",
      {
          {"",
           "a.stl:byte 0: found a file of 0 bytes, expected at least the 84 that begin a binary "
           "STL, "
           "or the word 'solid'"},
          {good.substr(0, 83),
           "a.stl:byte 0: found a file of 83 bytes, expected at least the 84 that begin a binary "
           "STL, "
           "or the word 'solid'"},
          {good.substr(0, 283),
           "a.stl:byte 80: found a count of 4 triangles in a file of 283 bytes, expected 284 "
           "bytes"},
          {good + "x",
           "a.stl:byte 80: found a count of 4 triangles in a file of 285 bytes, expected 284 "
           "bytes"},
          {solid + "x",
           "a.stl:byte 80: found a count of 4 triangles in a file of 285 bytes, expected 284 "
           "bytes"},
          {huge,
           "a.stl:byte 80: found a count of 4294967295 triangles in a file of 284 bytes, expected "
           "214748364834 bytes"},
          {nan, "a.stl:byte 158: found the point (nan 0 0), expected finite coordinates"},
          {infinite, "a.stl:byte 96: found the point (-inf 0 0), expected finite coordinates"},
      });
}

}  // namespace
}  // namespace dupin
