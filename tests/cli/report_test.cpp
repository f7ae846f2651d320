#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/io/report_page.h"
#include "io/pages/page_data.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

class ReportCommand : public Tool {
 protected:
  void SetUp() override {
    if (!has_page_viewer()) {
      EXPECT_THAT(dupin({"report", example("tee.json")}).err, HasSubstr("libjs-three"));
      GTEST_SKIP() << "this build makes no report pages (Debian: libjs-three)";
    }
  }

  [[nodiscard]] nlohmann::json page(const std::string& file) const {
    return page_data(folder_.read(file));
  }
};

TEST_F(ReportCommand, of_a_document_is_named_like_it) {
  const auto report = json({"report", example("tee.json")}, 0);
  EXPECT_EQ(report.at("file"), "tee.html");
  EXPECT_EQ(report.at("findings"), 0);
  EXPECT_GT(page("tee.html").at("mesh").at("triangles"), 100);
  EXPECT_EQ(dupin({"report", example("tee.json"), "-o", "-", "-q"}).out, folder_.read("tee.html"));
}

TEST_F(ReportCommand, of_a_piping_file_a_graph_and_a_mesh) {
  const auto line = json(
      {"report", example("line.pcf"), "-o", "a.html", "--tolerance", "1mm", "--wall", "3mm"}, 0);
  EXPECT_EQ(page("a.html").at("unit"), "mm");
  (void)json({"report", example("frame.graph"), "-o", "b.html", "--radius", "2"}, 0);
  EXPECT_GT(page("b.html").at("parts").size(), 5);
  put("open.off", open_box());
  EXPECT_GT(json({"report", "open.off"}, 1).at("findings"), 0);
  EXPECT_THAT(page("open.html").at("summary").get<std::string>(), HasSubstr("no solid"));
}

TEST_F(ReportCommand, shows_certificates) {
  EXPECT_EQ(dupin({"certify", example("reducer.json"), "-o", "c.json", "-q"}).exit_code, 0);
  (void)json({"report", example("reducer.json"), "--certificate", "c.json"}, 0);
  EXPECT_EQ(page("reducer.html").at("sections").back().at("title"), "Certificate");
  (void)json({"report", example("reducer.json"), "--certify", "-o", "b.html"}, 0);
  EXPECT_EQ(folder_.read("b.html"), folder_.read("reducer.html"));
  EXPECT_EQ(dupin({"report", example("tee.json"), "--certificate", "c.json"}).exit_code, 3);
}

TEST_F(ReportCommand, build_writes_the_page_beside_the_mesh) {
  const ProcessResult built =
      dupin({"build", example("tee.json"), "-o", "tee.stl", "--report", "tee.html"});
  EXPECT_EQ(built.exit_code, 0) << built.err;
  EXPECT_THAT(built.out, HasSubstr("report               tee.html"));
  const auto data = page("tee.html");
  EXPECT_THAT(data.at("sections").at(0).dump(), HasSubstr("tee.stl, binary STL"));
}

TEST_F(ReportCommand, refuses_places_and_options_that_make_no_sense) {
  const std::string tee = example("tee.json");
  for (const auto& [arguments, code] : std::vector<std::pair<std::vector<std::string>, int>>{
           {{"build", tee, "-o", "a.stl", "--report", "a.stl"}, 2},
           {{"build", tee, "-o", "a.stl", "--report", "-"}, 2},
           {{"report", "-"}, 2},
           {{"report", tee, "-o", "no/such/page.html"}, 5},
           {{"report", "missing.json"}, 3}}) {
    const ProcessResult refused = dupin(arguments);
    EXPECT_EQ(refused.exit_code, code) << refused.err;
    EXPECT_TRUE(folder_.files().empty());
  }
  put("box.off", open_box());
  EXPECT_EQ(dupin({"report", "box.off", "--certify"}).exit_code, 2);
  EXPECT_EQ(dupin({"report", "box.off", "--tolerance", "1mm"}).exit_code, 2);
}

}  // namespace
}  // namespace dupin::test
