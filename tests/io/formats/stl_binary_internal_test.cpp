#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "dupin/io/stl.h"
#include "formats/stl_binary.h"
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

}  // namespace
}  // namespace dupin
