#include "dupin/io/stl.h"

#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "io/formats/first_use.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

TEST(Stl, both_kinds_read_back_bit_for_bit_what_they_write) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TriMesh mesh = test::scattered_mesh(seed, 300, true);
    EXPECT_TRUE(test::identical(read_stl_binary(stl_binary_bytes(mesh), "x.stl"), mesh)) << seed;
    EXPECT_TRUE(test::identical(read_stl_ascii(stl_ascii_text(mesh), "x.stl"), mesh)) << seed;
  }
}

TEST(Stl, corners_with_equal_coordinates_become_one_point_in_order_of_appearance) {
  const TriMesh expected = test::by_first_use(test::tetrahedron());
  EXPECT_TRUE(
      test::identical(read_stl_binary(stl_binary_bytes(test::tetrahedron()), "x.stl"), expected));
  EXPECT_TRUE(
      test::identical(read_stl_ascii(stl_ascii_text(test::tetrahedron()), "x.stl"), expected));
}

TEST(Stl, an_empty_mesh_is_a_file) {
  EXPECT_TRUE(test::identical(read_stl_ascii(stl_ascii_text({}), "x.stl"), {}));
  EXPECT_TRUE(test::identical(read_stl_binary(stl_binary_bytes({}), "x.stl"), {}));
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

TEST(Stl, each_kind_knows_its_files) {
  const std::string binary = stl_binary_bytes(test::tetrahedron());
  const std::string text = stl_ascii_text(test::tetrahedron());
  std::string solid = binary;
  solid.replace(0, 5, "solid");
  EXPECT_EQ(kStlBinary.recognises(binary), Evidence::size);
  EXPECT_EQ(kStlBinary.recognises(solid), Evidence::size);
  EXPECT_EQ(kStlBinary.recognises(solid + "x"), Evidence::first_word);
  EXPECT_EQ(kStlBinary.recognises(binary + "x"), Evidence::none);
  EXPECT_EQ(kStlBinary.recognises(text), Evidence::none);
  EXPECT_EQ(kStlAscii.recognises(text), Evidence::first_word);
  EXPECT_EQ(kStlAscii.recognises(" \n SOLID x"), Evidence::first_word);
  EXPECT_EQ(kStlAscii.recognises(solid), Evidence::none);
  EXPECT_EQ(kStlAscii.recognises("solids"), Evidence::none);
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
