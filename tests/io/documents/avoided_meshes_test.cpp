#include "dupin/io/avoided_meshes.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"

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

constexpr const char* kMade = R"({"units": "mm", "values": {"f": "v.stl", "g": "/g.stl"}, "parts": [
  {"name": "a", "spline": {"avoid": [{"mesh": "= f"}, {"mesh": "=g"}, {"mesh": "k{i}.stl"}]}},
  {"for": {"i": 2, "w": ["w.stl", "x.stl"]}, "parts": [
    {"name": "b{i}", "spline": {"avoid": [{"mesh": "k{i}.stl"}, {"mesh": "=w"}, {"mesh": "=g"},
                                          {"mesh": "{g}"}]}}]}]})";

// As parts see them, whether the files are there or not.
TEST(AvoidedMeshes, are_what_expressions_and_copies_make_of_them) {
  EXPECT_THAT(avoided_meshes(kMade),
              ElementsAre("v.stl", "/g.stl", "k{i}.stl", "k0.stl", "k1.stl", "w.stl", "x.stl"));
  std::string faulty = kMade;
  faulty.replace(faulty.find("b{i}"), 4, "b{j}");
  EXPECT_THAT(avoided_meshes(faulty), ElementsAre("v.stl", "/g.stl", "k{i}.stl"));
}

TEST(AvoidedMeshes, that_expressions_make_are_the_same_from_another_folder) {
  const std::string seen = with_meshes_seen_from(kMade, "d.json", "sub/e.json");
  EXPECT_THAT(avoided_meshes(seen), ElementsAre("../v.stl", "/g.stl", "../k{i}.stl", "../k0.stl",
                                                "../k1.stl", "../w.stl", "../x.stl"));
  EXPECT_THAT(avoided_meshes(with_meshes_seen_from(kMade, "=x/d.json", "e.json")),
              ElementsAre("./=x/v.stl", "/g.stl", "./=x/k{i}.stl", "./=x/k0.stl", "./=x/k1.stl",
                          "./=x/w.stl", "./=x/x.stl"));
}

TEST(AvoidedMeshes, are_refused_from_where_no_text_means_the_same) {
  std::string mixed = kMade;
  mixed.replace(mixed.find("w.stl"), 5, "/w.off");
  const auto place = [](const std::string& text, const char* from, const char* to) {
    try {
      (void)with_meshes_seen_from(text, from, to);
    } catch (const Error& error) {
      return error.where();
    }
    return std::string();
  };
  EXPECT_EQ(place(mixed, "d.json", "sub/e.json"), "d.json#/parts/1/parts/0/spline/avoid/1/mesh");
  EXPECT_EQ(place(mixed, "d.json", "e.json"), "");
  EXPECT_EQ(place(kMade, "{x}/d.json", "e.json"),
            "{x}/d.json#/parts/1/parts/0/spline/avoid/0/mesh");
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
