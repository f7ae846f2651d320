#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/build.h"
#include "dupin/blends/certify.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/atomic_file.h"
#include "dupin/io/certificate_json.h"
#include "dupin/io/edit_json.h"
#include "dupin/io/place_json.h"
#include "dupin/io/sha256.h"
#include "dupin/kernel/rounding.h"
#include "io/json/document_fault.h"
#include "json/expansion.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

using test::document;
using test::expect_fault;
using test::Malformed;

std::string with_values(const std::string& values, const std::string& parts) {
  return R"({"units": "mm", "tolerance": 0.05, "values": {)" + values + R"(}, "parts": [)" + parts +
         "]}";
}

std::string ball(const std::string& radius, const std::string& more = {}) {
  return R"({"name": "a", )" + more + R"("sphere": {"center": [0, 0, 0], "radius": )" + radius +
         "}}";
}

constexpr const char* kRow =
    R"({"for": {"i": 3}, "name": "n{i + 1}", "sphere": {"center": ["=4 * i", 0, 0], "radius": 1}})";

TEST(Expansion, puts_values_in_their_places) {
  const Assembly assembly = parse_assembly(
      R"({"units": "cm", "tolerance": "=t", "segments": "=2 * 12", "wall": "=1 mm",
          "values": {"r": "=big / 2 + 3 mm", "big": "150 mm", "t": 0.1, "here": [1, "=t", 3], "n": "x"},
          "parts": [{"name": "=n", "comment": "=no expression", "sphere": {"center": "=here", "radius": "=r"}}]})");
  EXPECT_EQ(assembly.tolerance, 0.1);
  EXPECT_EQ(assembly.segments, 24U);
  EXPECT_EQ(assembly.wall, 0.1);
  EXPECT_EQ(assembly.parts[0].name, "x");
  const auto& sphere = std::get<SphereAt>(assembly.parts[0].shape);
  EXPECT_DOUBLE_EQ(sphere.radius, 7.8);
  EXPECT_EQ(sphere.center, Vec3(1, 0.1, 3));
}

TEST(Expansion, makes_copies_the_last_variable_fastest) {
  const Assembly assembly = parse_assembly(document(
      R"({"for": {"s": ["x", "y"], "i": 2}, "parts": [
            {"name": "{s}{i}", "sphere": {"center": ["=i", 0, 0], "radius": 1}},
            {"for": {"j": ["=i + 5"]}, "name": "{s}{i}-{j}", "sphere": {"center": [0, "=j", 0], "radius": 1}}]})"));
  std::string names;
  for (const Part& part : assembly.parts) {
    names += part.name + " ";
  }
  EXPECT_EQ(names, "x0 x0-5 x1 x1-6 y0 y0-5 y1 y1-6 ");
  EXPECT_EQ(assembly.parts[3].pointer, "/parts/0/parts/1");
  EXPECT_EQ(std::get<SphereAt>(assembly.parts[3].shape).center, Vec3(0, 6, 0));
}

TEST(Expansion, says_what_is_wrong_with_values) {
  const Malformed rows[] = {
      {with_values(R"("a": null)", ball("1")), "d.json#/values/a",
       "must be a number, a text or a list of these, not null"},
      {with_values(R"("a": [[1]])", ball("1")), "d.json#/values/a/0",
       "must be a number, a text or a list of these, not array"},
      {with_values(R"("a": [1], "b": ["=a"])", ball("1")), "d.json#/values/b/0",
       "a list holds numbers and texts, not lists"},
      {with_values(R"("2a": 1)", ball("1")), "d.json#/values/2a",
       "a value's name has letters, digits and _, begins with no digit and is no unit"},
      {with_values(R"("mm": 1)", ball("1")), "d.json#/values/mm",
       "a value's name has letters, digits and _, begins with no digit and is no unit"},
      {with_values(R"("a": "=b", "b": "=2 * c", "c": "=a")", ball("1")), "d.json#/values/c",
       "in \"=a\", column 2: values must not need each other in a circle: 'a' -> 'b' -> 'c' -> "
       "'a'"},
      {with_values(R"("a": "=a + 1")", ball("1")), "d.json#/values/a",
       "in \"=a + 1\", column 2: values must not need each other in a circle: 'a' -> 'a'"},
      {with_values(R"("a": "=nan")", ball("1")), "d.json#/values/a",
       "in \"=nan\", column 2: there is no value named 'nan'"},
      {with_values(R"("a": "=1/0")", ball("1")), "d.json#/values/a",
       "in \"=1/0\", column 3: division by zero"},
      {document(ball(R"("=r")")), "d.json#/parts/0/sphere/radius",
       "in \"=r\", column 2: there is no value named 'r'"},
      {document(ball(R"x("=3 * (2 + q)")x")), "d.json#/parts/0/sphere/radius",
       "in \"=3 * (2 + q)\", column 11: there is no value named 'q'"},
      {with_values(R"("r": "thick")", ball(R"("=r")")), "d.json#/parts/0/sphere/radius",
       "must be a number, not string"},
      {R"({"units": "mm", "tolerance": 1, "values": [], "parts": []})", "d.json#/values",
       "must be an object, not array"},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

TEST(Expansion, says_what_is_wrong_with_copies) {
  const std::string count = "must be a whole number from 1 to 100000 or a list of as many values";
  const std::string name =
      "a variable's name has letters, digits and _, begins with no digit and is no unit";
  const Malformed rows[] = {
      {document(ball("1", R"("for": 3, )")), "d.json#/parts/0/for",
       "must be an object, not number"},
      {document(ball("1", R"("for": {}, )")), "d.json#/parts/0/for",
       R"(must name a variable and say how often, like {"i": 40})"},
      {document(ball("1", R"("for": {"i": 0}, )")), "d.json#/parts/0/for/i", count},
      {document(ball("1", R"("for": {"i": 1e9}, )")), "d.json#/parts/0/for/i", count},
      {document(ball("1", R"("for": {"i": 1000000000}, )")), "d.json#/parts/0/for/i", count},
      {document(ball("1", R"("for": {"i": -1}, )")), "d.json#/parts/0/for/i", count},
      {document(ball("1", R"("for": {"i": 2.5}, )")), "d.json#/parts/0/for/i", count},
      {document(ball("1", R"("for": {"i": []}, )")), "d.json#/parts/0/for/i", count},
      {document(ball("1", R"("for": {"i": [[1]]}, )")), "d.json#/parts/0/for/i/0",
       "must be a number or a text"},
      {document(ball("1", R"("for": {"in": 3}, )")), "d.json#/parts/0/for/in", name},
      {with_values(R"("i": 3)", ball("1", R"("for": {"i": 3}, )")), "d.json#/parts/0/for/i",
       "there is a value named 'i' already"},
      {document(R"({"for": {"i": 3}, "name": "x", "parts": []})"), "d.json#/parts/0/name",
       "unknown key; known here are for, comment, parts, wall, wall_side, insulation"},
      {document(R"({"for": {"i": 3}, "sphere": {}})"), "d.json#/parts/0",
       "the key 'name' is missing"},
      {document(R"({"for": {"i": 3}, "name": "n{i", "sphere": {}})"), "d.json#/parts/0/name",
       "in \"n{i\", column 2: the brace is not closed"},
      {document(
           R"({"for": {"i": 3}, "name": "n{i}", "sphere": {"center": [0, 0, 0], "radius": "=2/(1-i) "}})"),
       "d.json#/parts/0/sphere/radius", "'n1': in \"=2/(1-i) \", column 3: division by zero"},
      {document(
           R"({"for": {"i": 3}, "name": "n{i}", "sphere": {"center": [0, 0, 0], "radius": "=1-i"}})"),
       "d.json#/parts/0/sphere/radius",
       "'n1': must be a positive number between 1e-12 and 1e12, not 0", Errc::invalid_argument},
      {document(ball("1", R"("for": {"i": 3}, )")), "d.json#/parts/0/name",
       "'a': the name is already taken by /parts/0", Errc::invalid_argument},
      {document(
           R"({"for": {"i": 1000, "j": 1000}, "name": "{i}-{j}", "sphere": {"center": [0, 0, 0], "radius": 1}})"),
       "d.json#/parts/0", "copies make more than 100000 parts"},
      {document(R"({"for": {"i": 100000, "j": 100000}, "parts": []})"), "d.json#/parts/0",
       "copies make more than 100000 parts"},
      {document(
           R"({"for": {"i": 100000}, "parts": [{"parts": [{"for": {"j": 100000}, "parts": []}]}]})"),
       "d.json#/parts/0/parts/0/parts/0", "copies make more than 100000 parts"},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

TEST(Expansion, names_the_first_fault_whoever_finds_it) {
  const std::string good = ball("1"), unread = ball("null"), unknown = ball(R"("=nothing")");
  const std::string type = "must be a number, not null",
                    name = "in \"=nothing\", column 2: there is no value named 'nothing'";
  const Malformed rows[] = {
      {document(good + "," + unread + "," + unknown), "d.json#/parts/1/sphere/radius", type},
      {document(good + "," + unknown + "," + unread), "d.json#/parts/1/sphere/radius", name},
      {document(good + "," + unread + "," + unread), "d.json#/parts/1/sphere/radius", type}};
  for (const Malformed& row : rows) {
    expect_fault(row);
  }
}

TEST(Expansion, bounds_how_many_values_need_each_other) {
  std::string values = R"("v0": 1)";
  const auto one_more = [&](int i) {
    values.append(", \"v").append(std::to_string(i)).append("\": \"=v");
    values.append(std::to_string(i - 1)).append(" + 1\"");
  };
  for (int i = 1; i < 64; ++i) {
    one_more(i);
  }
  EXPECT_NO_THROW((void)parse_assembly(with_values(values, ball(R"("=v63")"))));
  one_more(64);  // whose own value is known when it is evaluated
  expect_fault({with_values(values, ball("1")), "d.json#/values/v64",
                "more than 64 values need each other in a row"});
  const std::string backwards = [] {
    std::string text = R"("last": 1)";
    for (int i = 0; i <= 64; ++i) {
      text.insert(0, "\"w" + std::to_string(64 - i) +
                         "\": \"=" + (i == 0 ? "last" : "w" + std::to_string(65 - i)) + "\", ");
    }
    return text;
  }();
  expect_fault({with_values(backwards, ball("1")), "d.json#/values/w63",
                "in \"=w64\", column 2: more than 64 values need each other in a row"});
}

// What is written is said part by part, and builds to the same bytes.
TEST(Expansion, is_written_in_full_and_builds_the_same) {
  const Assembly read = read_assembly(test::source_folder() / "examples/header_forty.json");
  ASSERT_EQ(read.parts.size(), 81U);
  const std::string text = document_text(read);
  EXPECT_FALSE(json::is_abbreviated(json::parse_json(text, {})));
  const Solid one = build(read).solid, other = build(parse_assembly(text)).solid;
  EXPECT_EQ(to_mesh(one).mesh().points, to_mesh(other).mesh().points);
  EXPECT_EQ(to_mesh(one).mesh().triangles, to_mesh(other).mesh().triangles);
}

TEST(Expansion, is_placed_in_full) {
  const std::string text = document(kRow);
  Placement placement;
  placement.translate({0, 8, 0});
  const auto in_place = [&](const std::string& written) {
    return document_text(parse_assembly(placed_document(written, {}, placement).text));
  };
  EXPECT_EQ(in_place(text), in_place(document_text(parse_assembly(text))));
  EXPECT_THAT(in_place(text), testing::HasSubstr("[8.0,8.0,0.0]"));
}

TEST(Expansion, is_certified_as_what_it_stands_for) {
  const std::string text = document(kRow);
  Certificate certificate = certify(parse_assembly(text));
  EXPECT_EQ(certificate.parts.size(), 3U);
  certificate.document_sha256 = sha256(text);
  EXPECT_NO_THROW(require_about(certificate, text, ""));
  const std::string other =
      document(std::string(kRow).replace(std::string(kRow).find("4 *"), 1, "5"));
  certificate.document_sha256 = sha256(other);
  EXPECT_THROW(require_about(certificate, other, ""), Error);
}

TEST(Expansion, lets_chains_beside_copies_be_edited) {
  const std::string chain =
      R"({"name": "c", "cyclide_chain": {"spheres": [[0,0,"=z",1],[0,0,3,1],[0,0,6,1]]}})";
  const std::string text = with_values(R"("z": 1)", std::string(kRow) + ", " + chain);
  auto after = std::get<CyclideChainThrough>(parse_assembly(text).parts.at(3).shape);
  after.spheres[2].r = 2;
  const std::string written = with_chain(text, {}, 3, after);
  EXPECT_EQ(written, std::string(text).replace(text.find("[0,0,6,1]"), 9, "[0.0, 0.0, 6.0, 2.0]"));
  const std::string copied = document(R"({"for": {"i": 2}, "name": "c{i}",
      "cyclide_chain": {"spheres": [[0,"=9*i",0,1],[0,"=9*i",3,1],[0,"=9*i",6,1]]}})");
  EXPECT_THROW((void)with_chain(copied, {}, 1, after), Error);
}

}  // namespace
}  // namespace dupin
