#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dupin/io/report_json.h"

namespace dupin::test {
namespace {

using nlohmann::json;

TEST(ReportJson, of_a_build_has_null_for_what_a_part_has_not) {
  BuildReport report;
  report.runs = 1;
  report.pieces = 2;
  report.grid = 0x1p-20;
  report.gaps.unit = Unit::inch;
  report.output.file = "a.stl";
  PartReport blend{.name = "b", .kind = "cyclide_blend", .construction = "double"};
  blend.rejected = {"single: no"};
  blend.margin_lower = 0.5;
  blend.margin_upper = 0.75;
  blend.segments = 12;
  report.parts = {PartReport{.name = "s", .kind = "sphere"}, blend};
  const json parsed = json::parse(to_json(report));
  EXPECT_EQ(parsed.at("unit"), "in");
  EXPECT_EQ(parsed.at("runs"), 1);
  EXPECT_EQ(parsed.at("pieces"), 2);
  EXPECT_EQ(parsed.at("grid"), 0x1p-20);
  EXPECT_EQ(parsed.at("output").at("file"), "a.stl");
  EXPECT_EQ(parsed.at("gaps").at("pairs"), json::array());
  const json& sphere = parsed.at("parts").at(0);
  for (const std::string key :
       {"construction", "margin_lower", "margin_upper", "start_tangency", "end_tangency"}) {
    EXPECT_TRUE(sphere.at(key).is_null()) << key;
  }
  const json& part = parsed.at("parts").at(1);
  EXPECT_EQ(part.at("construction"), "double");
  EXPECT_EQ(part.at("rejected"), json::parse(R"(["single: no"])"));
  EXPECT_EQ(part.at("margin_lower"), 0.5);
  EXPECT_EQ(part.at("margin_upper"), 0.75);
  EXPECT_EQ(part.at("segments"), 12);
}

TEST(ReportJson, of_a_document_lists_its_parts) {
  Assembly assembly;
  assembly.source = "a.json";
  assembly.unit = Unit::centimetre;
  assembly.tolerance = 0.25;
  assembly.parts.push_back({.name = "p", .shape = PipeBetween{}});
  EXPECT_EQ(json::parse(to_json(assembly)), json::parse(R"({"file": "a.json", "kind": "assembly",
      "unit": "cm", "tolerance": 0.25, "parts": [{"name": "p", "kind": "pipe"}]})"));
}

TEST(ReportJson, of_an_edit_tells_pieces_and_spheres) {
  EditReport report;
  report.file = "new.json";
  report.part = "hook";
  report.pieces = 3;
  report.changed = {0, 2};
  report.spheres = {{4, {{1, 2, 3}, 0.5}}};
  report.turned = {{1, 3, std::pair(std::size_t{2}, PeVector{{4, 5, 6}, 0.25})}, {2, 5, {}}};
  EXPECT_EQ(json::parse(to_json(report)),
            json::parse(R"({"file": "new.json", "part": "hook", "pieces": 3, "changed": [0, 2],
      "spheres": [{"sphere": 4, "value": [1, 2, 3, 0.5]}],
      "turned": [{"piece": 1, "bias_sphere": 3,
                  "remedy": {"sphere": 2, "value": [4, 5, 6, 0.25]}},
                 {"piece": 2, "bias_sphere": 5, "remedy": null}]})"));
}

}  // namespace
}  // namespace dupin::test
