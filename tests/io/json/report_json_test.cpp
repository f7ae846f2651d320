#include "dupin/io/report_json.h"

#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/shapes.h"

namespace dupin::test {
namespace {

using nlohmann::json;

TEST(ReportJson, numbers_read_back_to_the_same_double) {
  Report report = check(box({0, 0, 0}, {1, 1, 1}));
  for (const double value : {0.1, 1.0 / 3, 1e-300, std::numeric_limits<double>::denorm_min()}) {
    report.volume = value;
    EXPECT_EQ(json::parse(to_json(report)).at("volume"), value);
  }
}

TEST(ReportJson, numbers_that_are_not_finite_are_null) {
  Report report = check(box({0, 0, 0}, {1, 1, 1}));
  report.area = std::numeric_limits<double>::infinity();
  report.volume = std::numeric_limits<double>::quiet_NaN();
  const json parsed = json::parse(to_json(report));
  EXPECT_TRUE(parsed.at("area").is_null());
  EXPECT_TRUE(parsed.at("volume").is_null());
}

TEST(ReportJson, names_that_are_no_utf8_do_not_break_it) {
  OutputReport report;
  report.file = "a\xff.off";
  report.check = check(box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(json::parse(to_json(report)).at("file"), "a\xef\xbf\xbd.off");
}

TEST(ReportJson, points_are_lists_of_three_even_beside_strings) {
  OutputReport report;
  report.check = check(box({0, 0, 0}, {1, 1, 1}));
  report.contacts.push_back({Contact::Kind::edge, {1, 2, 3}, {4, 5, 6}, {"a", "b"}});
  const json contact = json::parse(to_json(report)).at("contacts").at(0);
  EXPECT_EQ(contact.at("from"), json::parse("[1, 2, 3]"));
  EXPECT_EQ(contact.at("to"), json::parse("[4, 5, 6]"));
  EXPECT_EQ(contact.at("names"), json::parse(R"(["a", "b"])"));
}

TEST(ReportJson, a_placement_is_told_where_there_was_one) {
  OutputReport report;
  EXPECT_FALSE(json::parse(to_json(report)).contains("placement"));
  report.placement = {false, 0.5};
  const json expected = json::parse(R"({"exact": false, "largest_move": 0.5})");
  EXPECT_EQ(json::parse(to_json(report)).at("placement"), expected);
  const PlacedDocumentReport document{"a.json", Unit::inch, {false, 0.5}};
  EXPECT_EQ(json::parse(to_json(document)),
            json({{"file", "a.json"}, {"unit", "in"}, {"placement", expected}}));
}

TEST(ReportJson, only_defects_that_occur_are_counted) {
  TriMesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh.triangles.pop_back();
  const json parsed = json::parse(to_json(check(mesh)));
  EXPECT_EQ(parsed.at("counts"), json::parse(R"({"boundary_edge": 3})"));
  EXPECT_EQ(parsed.at("solid"), false);
  EXPECT_EQ(parsed.at("watertight"), false);
}

TEST(ReportJson, what_is_not_closed_has_neither_genus_nor_volume) {
  const TriMesh solid = box({0, 0, 0}, {1, 1, 1});
  TriMesh open = solid, turned = solid, fan = solid;
  open.triangles.pop_back();
  std::swap(turned.triangles[3][0], turned.triangles[3][1]);
  fan.triangles.push_back(fan.triangles.front());
  fan.points.emplace_back(5, 5, 5);
  fan.triangles.back()[2] = std::uint32_t(fan.points.size() - 1);
  for (const TriMesh& mesh : {open, turned, fan}) {
    const Report report = check(mesh);
    EXPECT_FALSE(has_volume(report));
    const json parsed = json::parse(to_json(report));
    EXPECT_TRUE(parsed.at("volume").is_null());
    EXPECT_TRUE(parsed.at("genus").is_null());
    EXPECT_EQ(parsed.at("area"), report.area);
    ASSERT_FALSE(parsed.at("shells").empty());
    EXPECT_TRUE(parsed.at("shells")[0].at("volume").is_null());
    EXPECT_TRUE(json::parse(to_json(MeshSummary{"a.off", "", mesh, report}))
                    .at("check")
                    .at("volume")
                    .is_null());
  }
  EXPECT_TRUE(has_volume(check(solid)));
  const json closed = json::parse(to_json(check(solid)));
  EXPECT_EQ(closed.at("genus"), 0);
  EXPECT_EQ(closed.at("shells")[0].at("volume"), 1);
}

TEST(ReportJson, an_error_says_what_the_exception_says) {
  const Error error(Errc::parse_failed, "expected a number", "inlet", "a.json#/parts/0");
  const json parsed = json::parse(error_json(error, name(error.code()), 3)).at("error");
  EXPECT_EQ(parsed.at("code"), "parse_failed");
  EXPECT_EQ(parsed.at("exit"), 3);
  EXPECT_EQ(parsed.at("message"), "expected a number");
  EXPECT_EQ(parsed.at("part"), "inlet");
  EXPECT_EQ(parsed.at("where"), "a.json#/parts/0");
}

TEST(BoundingBox, is_none_without_points) {
  EXPECT_TRUE(bounding_box(TriMesh()).isEmpty());
  const auto box_of_box = bounding_box(box({-1, 2, -3}, {4, 5, 6}));
  ASSERT_FALSE(box_of_box.isEmpty());
  EXPECT_EQ(box_of_box.min(), Vec3(-1, 2, -3));
  EXPECT_EQ(box_of_box.max(), Vec3(4, 5, 6));
}

}  // namespace
}  // namespace dupin::test
