#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/io/drawing_page.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

using Draw = Tool;

TEST_F(Draw, takes_as_many_triangles_as_it_is_told) {
  const ProcessResult few =
      dupin({"draw", example("reducer.json"), "-o", "a.svg", "--triangles", "1000"});
  EXPECT_EQ(few.exit_code, 3);
  EXPECT_THAT(few.err, HasSubstr("or a higher limit"));
  EXPECT_EQ(dupin({"bom", example("reducer.json"), "--mesh", "--triangles", "1000"}).exit_code, 3);
  EXPECT_EQ(dupin({"bom", example("reducer.json"), "--triangles", "1000"}).exit_code, 2);
}

TEST_F(Draw, an_option_out_of_range_is_blamed_and_not_the_document) {
  const std::vector<std::pair<std::string, std::string>> outputs = {{"draw", "a.svg"},
                                                                    {"build", "a.stl"},
                                                                    {"certify", "a.json"},
                                                                    {"nurbs", "a.json"},
                                                                    {"report", "a.html"}};
  for (const auto& [command, output] : outputs) {
    const ProcessResult result =
        dupin({command, example("reducer.json"), "-o", output, "--tolerance", "1e-30"});
    EXPECT_EQ(result.exit_code, 2) << command;
    EXPECT_THAT(result.err, HasSubstr("--tolerance 1e-30 is out of range")) << command;
  }
  EXPECT_THAT(dupin({"bom", example("reducer.json"), "--wall", "1e-30"}).err,
              HasSubstr("--wall 1e-30 is out of range"));
}

TEST_F(Draw, writes_the_outline_to_scale) {
  const auto report = json({"draw", example("tee.json"), "-o", "tee.svg", "--hidden"}, 0);
  EXPECT_EQ(report.at("file"), "tee.svg");
  EXPECT_GT(report.at("lines").at("contour"), 4);
  EXPECT_GT(report.at("lines").at("hidden"), 0);
  EXPECT_LE(report.at("size").at(0), 420 - 10);
  const std::string svg = folder_.read("tee.svg");
  EXPECT_THAT(svg, HasSubstr(" 2:1</title>"));
  EXPECT_THAT(svg, HasSubstr("class=\"hidden\""));
  EXPECT_EQ(dupin({"draw", example("tee.json"), "-o", "-", "--hidden"}).out, svg);
  const ProcessResult text = dupin({"draw", example("tee.json"), "-o", "plan.svg", "--direction",
                                    "0,0,-1", "--up", "1,0,0", "--scale", "1:7"});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_THAT(text.out, HasSubstr("1:7, on "));
  EXPECT_THAT(folder_.read("plan.svg"), testing::Not(HasSubstr("class=\"hidden\"")));
}

TEST_F(Draw, takes_piping_files_with_walls) {
  const auto outer = json({"draw", example("line.pcf"), "-o", "a.svg", "--tolerance", "1mm"}, 0);
  const auto metal = json({"draw", example("line.pcf"), "-o", "b.svg", "--tolerance", "1mm",
                           "--wall", "3mm", "--direction", "-1,0,0"},
                          0);
  EXPECT_GT(outer.at("lines").at("edge"), 0);
  EXPECT_EQ(metal.at("direction").at(0), -1);
}

TEST_F(Draw, takes_views_by_name_and_by_place) {
  for (const auto& [view, direction] :
       std::vector<std::pair<std::string, std::vector<int>>>{{"top", {0, 0, -1}},
                                                             {"front", {0, 1, 0}},
                                                             {"side", {-1, 0, 0}},
                                                             {"0,-2,0", {0, 1, 0}}}) {
    const auto report = json({"draw", example("tee.json"), "-o", "a.svg", "--view", view, "--axes",
                              "--names", "--dimensions"},
                             0);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(report.at("direction").at(i), direction.at(i)) << view;
    }
    EXPECT_GT(report.at("lines").at("center"), 0);
    EXPECT_THAT(folder_.read("a.svg"), HasSubstr("</text>"));
  }
}

TEST_F(Draw, writes_pages_and_pictures) {
  if (!can_draw_pages()) {
    GTEST_SKIP() << "built without cairo";
  }
  for (const auto& [file, begin] :
       std::vector<std::pair<std::string, std::string>>{{"a.pdf", "%PDF"}, {"a.png", "\x89PNG"}}) {
    std::vector<std::string> line{"draw", example("tee.json"), "-o", file};
    if (file.ends_with(".png")) {
      line.insert(line.end(), {"--dpi", "30"});
    }
    (void)json(line, 0);
    EXPECT_THAT(folder_.read(file), testing::StartsWith(begin));
  }
  const std::string lines = folder_.read("a.png");
  (void)json({"draw", example("tee.json"), "-o", "a.png", "--dpi", "30", "--shaded"}, 0);
  EXPECT_NE(folder_.read("a.png"), lines);
}

TEST_F(Draw, refuses_bad_views_and_files) {
  const std::string tee = example("tee.json");
  for (const auto& [options, code, text] :
       std::vector<std::tuple<std::vector<std::string>, int, std::string>>{
           {{"--direction", "0,0,0"}, 2, "not zero"},
           {{"--direction", "1,2"}, 2, "direction"},
           {{"--direction", "nan,0,1"}, 2, "finite"},
           {{"--direction", "0,0,1", "--up", "0,0,-3"}, 2, "upwards"},
           {{"--scale", "50"}, 2, "such as 1:50"},
           {{"--view", "bottom"}, 2, "iso, top, front or side"},
           {{"--view", "1,2"}, 2, "iso, top, front or side"},
           {{"--view", "0,0,0"}, 2, "not zero"},
           {{"--view", "top", "--direction", "0,0,1"}, 2, "--view"},
           {{"--shaded"}, 2, ".png"},
           {{"--tolerance", "-1mm"}, 2, "positive"},
           {{"--region", "metal"}, 3, "no metal"},
           {{"--region", "insulation"}, 3, "no insulation"},
           {{"--snap", "1mm"}, 2, "piping files"}}) {
    std::vector<std::string> arguments{"draw", tee, "-o", "out.svg"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProcessResult refused = dupin(arguments);
    EXPECT_EQ(refused.exit_code, code) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(text));
    EXPECT_TRUE(folder_.files().empty());
  }
  EXPECT_EQ(dupin({"draw", tee, "-o", "no/such/folder.svg"}).exit_code, 5);
}

}  // namespace
}  // namespace dupin::test
