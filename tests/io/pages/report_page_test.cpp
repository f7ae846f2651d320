#include "dupin/io/report_page.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dupin/kernel/error.h"
#include "io/pages/page_data.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using testing::HasSubstr;
using testing::Not;

ReportPage small_page() {
  ReportPage page{"tee.json",        "1 part", "mm", test::box({0, 0, 0}, {1, 2, 3}),
                  {{"box", "pipe"}}, {}};
  page.parts[0].labels = {0};
  PagePlace place{{1, 2, 3}, 0.5, {{{0, 0, 0}, {1, 1, 1}}}, true};
  page.sections.push_back({"Gaps", "one", {"verdict"}, {{{"gap"}, true, place, 0}}, true});
  return page;
}

class ReportPages : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_page_viewer()) {
      GTEST_SKIP() << "this build makes no report pages (Debian: libjs-three)";
    }
  }
};

TEST_F(ReportPages, hold_data_and_geometry) {
  const std::string html = report_page_html(small_page());
  EXPECT_EQ(html, report_page_html(small_page()));
  const nlohmann::json data = test::page_data(html);
  EXPECT_EQ(data.at("title"), "tee.json");
  EXPECT_EQ(data.at("unit"), "mm");
  EXPECT_EQ(data.at("mesh").at("triangles"), 12);
  EXPECT_EQ(data.at("mesh").at("points"), 8);
  const auto& row = data.at("sections").at(0).at("rows").at(0);
  EXPECT_EQ(row.at("finding"), true);
  EXPECT_EQ(row.at("part"), 0);
  EXPECT_EQ(row.at("place").at("at"), nlohmann::json({1, 2, 3}));
  EXPECT_EQ(row.at("place").at("lines").at(0).at(1), nlohmann::json({1, 1, 1}));
  EXPECT_THAT(html, HasSubstr("Permission is hereby granted"));
}

// Nothing is fetched: no address but those in texts of the library, and a policy that forbids it.
TEST_F(ReportPages, need_nothing_else) {
  const std::string html = report_page_html(small_page());
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  for (const char* const tag : {"<link", "src=\"", "@import", "<iframe"}) {
    EXPECT_THAT(html, Not(HasSubstr(tag))) << tag;
  }
}

TEST_F(ReportPages, show_whatever_texts_hold_as_text) {
  const std::string bad = "</script><script>alert(1)</script><!--{{data}}&\"'\xff\u2028";
  ReportPage page = small_page();
  const std::size_t scripts = test::count_of(report_page_html(page), "<script");
  page.title = page.summary = page.unit = bad;
  page.parts[0].name = page.parts[0].kind = bad;
  page.sections[0] = {bad, bad, {bad}, {{{bad}}}};
  page.mesh.names = {bad};
  page.mesh.labels.assign(12, 0);
  const std::string html = report_page_html(page);
  EXPECT_EQ(test::count_of(html, "<script"), scripts);
  EXPECT_EQ(test::count_of(html, "</script"), scripts);
  EXPECT_THAT(html, Not(HasSubstr("<!--{{")));
  const nlohmann::json data = test::page_data(html);
  const std::string shown = data.at("parts").at(0).at("name");
  EXPECT_EQ(shown.substr(0, 30), bad.substr(0, 30));
  EXPECT_THAT(shown, HasSubstr("\uFFFD"));
}

TEST_F(ReportPages, refuse_labels_of_no_part_and_points_that_are_none) {
  ReportPage page = small_page();
  page.parts[0].labels.clear();
  EXPECT_THROW((void)report_page_html(page), Error);
  page.parts[0].labels = {0, 0};
  EXPECT_THROW((void)report_page_html(page), Error);
  page.parts[0].labels = {1};
  EXPECT_THROW((void)report_page_html(page), Error);
  page = small_page();
  page.mesh.points[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)report_page_html(page), Error);
}

TEST(ReportPage, a_command_says_where_it_went) {
  EXPECT_EQ(nlohmann::json::parse(page_report_json("a.html", 2)),
            nlohmann::json({{"file", "a.html"}, {"findings", 2}}));
}

}  // namespace
}  // namespace dupin
