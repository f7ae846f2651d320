#include "dupin/io/avoided_meshes.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dupin {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr const char* kDocument = R"({ "units": "mm", "parts": [
  {"name": "mesh", "spline": {"avoid": [{"part": "p"}, {"mesh":  "m.off" }]}},
  {"for": {"i": 2}, "parts": [{"cyclic_blend": {"avoid": [{"mesh": "a/b.stl"}, {"mesh": "m.off"},
                                                          {"mesh": "/c.off"}]}}]}]})";

TEST(AvoidedMeshes, are_told_once_each) {
  EXPECT_THAT(avoided_meshes(kDocument), ElementsAre("m.off", "a/b.stl", "/c.off"));
  EXPECT_THAT(avoided_meshes(R"({"parts": [{"mesh": "x"}], "avoid": {"mesh": "x"}})"), IsEmpty());
  for (const char* const text : {"", "OFF", "{", "[]", "ISOGEN-FILES"}) {
    EXPECT_THAT(avoided_meshes(text), IsEmpty()) << text;
  }
}

TEST(AvoidedMeshes, are_the_same_from_another_folder) {
  const auto seen = [](const char* from, const char* to) {
    return avoided_meshes(with_meshes_seen_from(kDocument, from, to));
  };
  EXPECT_THAT(seen("d.json", "sub/e.json"), ElementsAre("../m.off", "../a/b.stl", "/c.off"));
  EXPECT_THAT(seen("sub/d.json", "e.json"), ElementsAre("sub/m.off", "sub/a/b.stl", "/c.off"));
  EXPECT_THAT(seen("/x/y/d.json", "/x/z/e.json"),
              ElementsAre("../y/m.off", "../y/a/b.stl", "/c.off"));
  for (const char* const to : {"e.json", "", "./e.json", "sub/../e.json"}) {
    EXPECT_EQ(with_meshes_seen_from(kDocument, "d.json", to), kDocument) << to;
  }
}

TEST(AvoidedMeshes, leave_all_else_of_the_text_as_it_is) {
  std::string expected = kDocument;
  expected.replace(expected.find("\"m.off\""), 7, "\"sub/m.off\"");
  expected.replace(expected.find("\"a/b.stl\""), 9, "\"sub/a/b.stl\"");
  expected.replace(expected.rfind("\"m.off\""), 7, "\"sub/m.off\"");
  EXPECT_EQ(with_meshes_seen_from(kDocument, "sub/d.json", "e.json"), expected);
}

}  // namespace
}  // namespace dupin
