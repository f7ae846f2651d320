#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/occt/body_shapes_internal.h"
#include "occt/occt_module.h"

namespace dupin::occt {
namespace {

exchange::Model model() {
  exchange::Model result;
  result.name = "plant";
  for (const char* name : {"pipe", "elbow \u65e5", "it's", "e\\0", "e1", "a\nb", "d0", "d1"}) {
    result.labels.push_back({name, {200, 100, 30}});
  }
  result.whole.bodies = {bent_pipe(), branch()};
  return result;
}

TEST(OcctModule, writes_names_that_it_reads_back) {
  const exchange::Written written = dupin_occt_module_3()->write_solids(model());
  EXPECT_EQ(written.fault, "");
  ASSERT_EQ(written.solids.size(), 1U);
  EXPECT_EQ(written.solids.front().name, "plant");
  EXPECT_EQ(written.solids.front().shells, 1U);
  EXPECT_EQ(written.solids.front().euler_number, 2);
  for (const char* name : {"pipe", "elbow \u65e5", "it's", "e\\0", "a\uFFFDb"}) {
    EXPECT_THAT(written.faces, testing::Contains(testing::Key(name)));
  }
  EXPECT_THAT(written.bytes, testing::HasSubstr("COLOUR_RGB"));
  EXPECT_TRUE(std::ranges::all_of(written.bytes, [](char c) { return std::uint8_t(c) < 0x80; }));
}

TEST(OcctModule, writes_the_same_bytes_every_time) {
  exchange::Model apart = model();
  apart.is_united = false;
  for (const exchange::Model& one : {model(), apart}) {
    const exchange::Written first = dupin_occt_module_3()->write_solids(one);
    EXPECT_EQ(first.fault, "");
    EXPECT_EQ(first.bytes, dupin_occt_module_3()->write_solids(one).bytes);
  }
}

TEST(OcctModule, says_what_is_wrong_and_throws_nothing) {
  EXPECT_NE(dupin_occt_module_3()->read_solids("no STEP").fault, "");
  exchange::Model broken = model();
  broken.whole.bodies.front().discs.clear();
  const exchange::Written open = dupin_occt_module_3()->write_solids(broken);
  EXPECT_NE(open.fault, "");
  EXPECT_EQ(open.bytes, "");
}

TEST(OcctModule, writes_surfaces_as_step_and_iges) {
  const NurbsSurface flat{1,
                          1,
                          {0, 0, 1, 1},
                          {0, 0, 1, 1},
                          {{{0, 0, 0, 1}, {1, 0, 0, 1}}, {{0, 1, 0, 1}, {1, 1, 0, 1}}}};
  const auto* const module = dupin_occt_module_3();
  const std::string step = module->write_surfaces("s", {{"flat \u65e5", flat}}, false).bytes;
  EXPECT_THAT(step, testing::HasSubstr("\\X2\\65E5\\X0\\"));
  const std::string iges = module->write_surfaces("s", {{"flat", flat}}, true).bytes;
  EXPECT_EQ(iges, module->write_surfaces("s", {{"flat", flat}}, true).bytes);
  EXPECT_THAT(iges, testing::HasSubstr("128"));  // a rational B-spline surface
}

}  // namespace
}  // namespace dupin::occt
