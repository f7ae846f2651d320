#include "dupin/blends/assembly.h"

#include <gtest/gtest.h>

namespace dupin {
namespace {

TEST(Assembly, knows_places_in_its_document) {
  Assembly assembly;
  assembly.parts = {{"a", CapAt()}, {"b", SphereAt()}};
  EXPECT_EQ(document_place(assembly, "/tolerance"), "/tolerance");
  assembly.source = "d.json";
  EXPECT_EQ(document_place(assembly, "/tolerance"), "d.json#/tolerance");
  EXPECT_EQ(document_place(assembly, 1), "d.json#/parts/1");
  EXPECT_EQ(document_place(assembly, 1, "center/0"), "d.json#/parts/1/sphere/center/0");
  EXPECT_EQ(document_place(assembly, 999, "center/0"), "d.json#/parts/999");  // there is none
}

}  // namespace
}  // namespace dupin
