#include "dupin/io/nurbs_json.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dupin {
namespace {

using nlohmann::json;

std::vector<NamedNurbs> bilinear_patch() {
  NurbsSurface patch;
  patch.degree_along = 1;
  patch.degree_around = 1;
  patch.knots_along = {0, 0, 1, 1};
  patch.knots_around = {0, 0, 0.5, 1, 1};
  patch.net = {{{0, 0, 0, 1}, {0.1, 0, 0, 1}}, {{0, 1, 0, 1}, {1, 1, 0, 0.5}}};
  return {{"inlet", "pipe", {{patch, patch}, 0.125}}};
}

TEST(NurbsJson, tells_degrees_knots_and_homogeneous_points) {
  const json parsed = json::parse(nurbs_json(bilinear_patch(), Unit::metre));
  EXPECT_EQ(parsed.at("unit"), "m");
  const json& part = parsed.at("parts").at(0);
  EXPECT_EQ(part.at("part"), "inlet");
  EXPECT_EQ(part.at("kind"), "pipe");
  EXPECT_EQ(part.at("error_bound"), 0.125);
  ASSERT_EQ(part.at("surfaces").size(), 2U);
  EXPECT_EQ(part.at("surfaces").at(1),
            json::parse(R"({"degree": [1, 1], "knots": [[0, 0, 1, 1], [0, 0, 0.5, 1, 1]],
      "net": [[[0, 0, 0, 1], [0.1, 0, 0, 1]], [[0, 1, 0, 1], [1, 1, 0, 0.5]]]})"));
}

TEST(NurbsJson, has_trims_where_there_are_any) {
  auto parts = bilinear_patch();
  EXPECT_FALSE(json::parse(nurbs_json(parts, Unit::metre)).at("parts").at(0).contains("trims"));
  parts[0].form.trims = {{1, {0, 0, 1, 1}, {{0, 0, 0, 1}, {1, 0, 0, 1}}}};
  EXPECT_EQ(json::parse(nurbs_json(parts, Unit::metre)).at("parts").at(0).at("trims"),
            json::parse(R"([{"degree": 1, "knots": [0, 0, 1, 1],
      "net": [[0, 0, 0, 1], [1, 0, 0, 1]]}])"));
}

TEST(NurbsJson, the_report_counts_the_surfaces) {
  EXPECT_EQ(json::parse(nurbs_report_json(bilinear_patch(), "out.json")),
            json::parse(R"({"file": "out.json", "parts": [{"part": "inlet", "kind": "pipe",
      "error_bound": 0.125, "surfaces": 2}]})"));
}

}  // namespace
}  // namespace dupin
