#include "io/formats/mesh_mutation.h"

namespace dupin {
namespace {

class MeshMutationLong : public ::testing::TestWithParam<MeshFormat> {};

TEST_P(MeshMutationLong, damaged_files_are_read_or_refused) {
  test::expect_read_or_refused(GetParam(), 200000);
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshMutationLong,
                         ::testing::ValuesIn(mesh_formats().begin(), mesh_formats().end()),
                         test::format_name);

}  // namespace
}  // namespace dupin
