#include <gtest/gtest.h>

#include "assembly/districts/built_district.h"
#include "support/named_parts.h"

namespace dupin::assembly {
namespace {

using test::pipe;

District of(const Assembly& assembly) {
  const ResolvedAssembly resolved = resolve(assembly);
  return district(assembly, resolved, districts_of_parts(resolved, 0).at(0));
}

TEST(BuiltDistrict, is_built_as_a_document) {
  const Assembly assembly{"", Unit::millimetre, 0.01, {}, {pipe("a", {0, 0, 0}, {10, 0, 0}, 1)}};
  const Built built = built_district(of(assembly), {});
  const Built whole = build(assembly);
  EXPECT_EQ(built.solid.exact_volume(), whole.solid.exact_volume());
  EXPECT_EQ(built.solid.names(), whole.solid.names());
  EXPECT_TRUE(built.ports.empty());
}

TEST(BuiltDistrict, without_insulation_has_none_of_it) {
  const Assembly assembly{"", Unit::millimetre, 0.01, {}, {pipe("a", {0, 0, 0}, {10, 0, 0}, 1)}};
  const Built built = built_district(of(assembly), {.region = Region::insulation});
  EXPECT_TRUE(built.solid.empty());
  EXPECT_EQ(built.insulation, 0);
  EXPECT_EQ(built.parts.at(0).name, "a");
  EXPECT_GT(built.parts.at(0).triangles, 0);
}

}  // namespace
}  // namespace dupin::assembly
