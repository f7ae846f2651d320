#include "dupin/io/glb.h"

#include <gtest/gtest.h>

#include "support/sample_meshes.h"

namespace dupin {
namespace {

TEST(Glb, reads_back_bit_for_bit_what_it_writes) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TriMesh mesh = test::scattered_mesh(seed, 300, true);
    EXPECT_TRUE(test::identical(read_glb(glb_bytes(mesh), "x.glb"), mesh));
  }
  const TriMesh labelled = test::labelled_tetrahedron();
  EXPECT_TRUE(test::identical(read_glb(glb_bytes(labelled, {"mm", "note"}), "x.glb"), labelled));
  EXPECT_TRUE(test::identical(read_glb(glb_bytes({}), "x.glb"), {}));
}

TEST(Glb, is_recognised_by_its_first_bytes) {
  EXPECT_EQ(kGlb.recognises(glb_bytes({})), Evidence::signature);
  EXPECT_EQ(kGlb.recognises("glT"), Evidence::none);
  EXPECT_EQ(kGlb.recognises(""), Evidence::none);
  EXPECT_EQ(kGlb.unit(glb_bytes(test::tetrahedron(), {"ft", ""}), "x"), "ft");
}

}  // namespace
}  // namespace dupin
