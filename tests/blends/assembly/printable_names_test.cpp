#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/blends/resolve.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

TEST(PrintableNames, of_patches_have_no_control_characters) {
  Assembly assembly;
  assembly.source = "d";
  assembly.parts = {{"a", PipeBetween{Vec3(0, 0, 0), Vec3(4, 0, 0), 1}}};
  assembly.patches = {{"a", "in\u2028let"}};
  try {
    (void)resolve(assembly);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "d#/patches/a");
  }
}

// Bills of materials print them.
TEST(PrintableNames, of_components_have_no_control_characters) {
  Assembly assembly;
  assembly.source = "d";
  const PipeBetween pipe{Vec3(0, 0, 0), Vec3(4, 0, 0), 1};
  for (const auto& [component, key] :
       std::vector<std::pair<Component, std::string>>{{{"t\u202E", "tee"}, "name"},
                                                      {{"t\n", "tee"}, "name"},
                                                      {{"t", "te\x1B[31me"}, "kind"},
                                                      {{"t", "\xC2\x9B"}, "kind"}}) {
    assembly.parts = {{"b", pipe}, {.name = "a", .shape = pipe, .component = component}};
    try {
      (void)resolve(assembly);
      ADD_FAILURE() << key;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
      EXPECT_EQ(error.part(), "a");
      EXPECT_EQ(error.where(), "d#/parts/1/component/" + key);
      EXPECT_EQ(error.message(), "a component's " + key + " must have no control characters");
    }
  }
}

}  // namespace
}  // namespace dupin
