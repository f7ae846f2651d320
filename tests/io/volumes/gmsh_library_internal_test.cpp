#include <gtest/gtest.h>

#include "dupin/io/volume_mesh.h"
#include "volumes/gmsh_library.h"

namespace dupin::volumes {
namespace {

TEST(GmshLibrary, is_there_as_a_whole_or_not_at_all) {
  EXPECT_EQ(GmshLibrary::instance() != nullptr, has_volume_mesher());
  EXPECT_EQ(GmshLibrary::instance(), GmshLibrary::instance());
  if (const GmshLibrary* const library = GmshLibrary::instance()) {
    int fault = 0;
    library->initialize(0, nullptr, 0, &fault);
    EXPECT_EQ(fault, 0);
    library->finalize(&fault);
  }
}

}  // namespace
}  // namespace dupin::volumes
