#include "io/formats/mesh_mutation.h"

namespace dupin {
namespace {

class MeshMutation : public ::testing::TestWithParam<MeshFormat> {};

TEST_P(MeshMutation, damaged_files_are_read_or_refused) {
  test::expect_read_or_refused(GetParam(), 20000);
  if (GetParam().has_normals) {
    test::expect_read_or_refused(GetParam(), 20000, true);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshMutation,
                         ::testing::ValuesIn(mesh_formats().begin(), mesh_formats().end()),
                         test::format_name);

}  // namespace
}  // namespace dupin
