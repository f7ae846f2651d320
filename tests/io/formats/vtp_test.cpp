#include "dupin/io/vtp.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

using testing::HasSubstr;

TEST(Vtp, reads_back_bit_for_bit_what_it_writes) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TriMesh mesh = test::scattered_mesh(seed, 300, false);
    EXPECT_TRUE(test::identical(read_vtp(vtp_text(mesh), "x.vtp"), mesh));
  }
  const TriMesh labelled = test::labelled_tetrahedron();
  EXPECT_TRUE(test::identical(read_vtp(vtp_text(labelled), "x.vtp"), labelled));
  EXPECT_TRUE(test::identical(read_vtp(vtp_text({}), "x.vtp"), {}));
}

TEST(Vtp, says_parts_patches_unit_and_colours) {
  TriMesh mesh = test::labelled_tetrahedron();
  mesh.names = {"tee.start", "tee"};
  const std::string text = vtp_text(mesh, {"mm", "here", "", {{"tee", "#102030"}}});
  // "tee.start" and "tee", and the part "tee" alone.
  EXPECT_THAT(text, HasSubstr("Name=\"label_names\" NumberOfTuples=\"2\" format=\"ascii\">\n"
                              "116 101 101 46 115 116 97 114 116 0\n116 101 101 0\n"));
  EXPECT_THAT(text, HasSubstr("Name=\"part_names\" NumberOfTuples=\"1\""));
  EXPECT_THAT(text, HasSubstr("type=\"UInt8\" Name=\"colour\" NumberOfComponents=\"3\""));
  EXPECT_EQ(unit_of_vtp(text, "x"), "mm");
  EXPECT_THAT(vtp_text(mesh), testing::Not(HasSubstr("colour")));
}

}  // namespace
}  // namespace dupin
