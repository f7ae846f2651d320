#include "dupin/io/vtu.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "io/formats/volume_sample.h"

namespace dupin {
namespace {

using testing::HasSubstr;

TEST(Vtu, has_triangles_and_tetrahedra_as_cells) {
  const std::string text = vtu_text(test::volume_sample());
  EXPECT_THAT(text, HasSubstr("NumberOfPoints=\"5\" NumberOfCells=\"8\""));
  EXPECT_THAT(text, HasSubstr("Name=\"label\""));
}

TEST(Vtu, that_is_broken_is_refused) {
  std::string text = vtu_text(test::volume_sample());
  for (const std::string name : {"connectivity", "offsets", "Points"}) {
    std::string broken = text;
    const std::size_t at = broken.find("binary\">", broken.find("Name=\"" + name)) + 8;
    broken.replace(at, 8, "AAAAAAAA");
    try {
      (void)read_vtu(broken, "x.vtu");
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::parse_failed) << name;
    }
  }
}

}  // namespace
}  // namespace dupin
