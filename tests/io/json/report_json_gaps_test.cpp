#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dupin/io/report_json.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using nlohmann::json;

TEST(ReportJson, gaps_keep_their_rationals) {
  const Ring end{{0, 0, 0}, {0, 0, 1}, 1, 0};
  Ring start = flipped(end);
  start.center.z() = 0.5;
  start.radius = 1.25;
  GapSummary summary{"a.json", Unit::inch, 1, {{"a.end", end, "a"}, {"b.start", start, "b"}}, {}};
  summary.pairs = pair_ends(summary.ports, summary.connect);
  EXPECT_EQ(summary.findings(), 1);
  const json parsed = json::parse(to_json(summary));
  EXPECT_EQ(parsed.at("unit"), "in");
  const json& pair = parsed.at("pairs").at(0);
  EXPECT_EQ(pair.at("verdict"), "gap");
  EXPECT_EQ(pair.at("axial"), json::parse(R"({"lower": 0.5, "upper": 0.5})"));
  EXPECT_EQ(pair.at("exact").at("axial_dot"), "1/2");
  EXPECT_EQ(pair.at("exact").at("radius_difference"), "1/4");
  EXPECT_EQ(pair.at("deviations").size(), 2);
}

TEST(ReportJson, an_end_that_stands_alone_has_no_partner_and_no_measures) {
  GapSummary summary{
      "a.json", Unit::millimetre, 1, {{"a.end", {{0, 0, 0}, {0, 0, 1}, 1, 0}, "a"}}, {}};
  summary.pairs = pair_ends(summary.ports, summary.connect);
  EXPECT_EQ(summary.findings(), 0U) << "an open end is none";
  EXPECT_EQ(json::parse(to_json(summary)).at("pairs"),
            json::parse(R"([{"from": "a.end", "to": null, "verdict": "open"}])"));
}

TEST(ReportJson, gaps_of_meshes_count_boundaries_slits_and_pieces) {
  TriMesh open = box({0, 0, 0}, {1, 1, 1});
  open.triangles.erase(open.triangles.begin());
  const MeshGapSummary one{"a", "", 0, measure_gaps(open, {})};
  EXPECT_EQ(one.findings(), 1U);
  const json alone = json::parse(to_json(one));
  EXPECT_EQ(alone.at("boundary_a").size(), 1U);
  EXPECT_EQ(alone.at("boundary_a").at(0).at("points").size(), 3U);
  EXPECT_EQ(alone.at("boundary_a").at(0).at("closed"), true);
  EXPECT_EQ(alone.at("file_b"), "");

  const MeshGapSummary two{
      "a", "b", 0.5,
      measure_gaps(box({0, 0, 0}, {1, 1, 1}), box({1.25, 0, 0}, {2, 1, 1}), {.connect = 0.5})};
  EXPECT_EQ(two.findings(), 2U) << "a slit, and a union in two pieces";
  const json both = json::parse(to_json(two));
  EXPECT_EQ(both.at("components"), 2);
  EXPECT_EQ(both.at("touching"), false);
  EXPECT_EQ(both.at("connect"), 0.5);
  EXPECT_EQ(both.at("facing").at(0).at("least_squared"), "1/16");
  EXPECT_EQ(both.at("facing").at(0).at("least"), json::parse(R"({"lower": 0.25, "upper": 0.25})"));
}

}  // namespace
}  // namespace dupin::test
