#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

using Draw = Tool;

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

TEST_F(Draw, refuses_bad_views_and_files) {
  const std::string tee = example("tee.json");
  for (const auto& [options, code, text] :
       std::vector<std::tuple<std::vector<std::string>, int, std::string>>{
           {{"--direction", "0,0,0"}, 2, "not zero"},
           {{"--direction", "1,2"}, 2, "direction"},
           {{"--direction", "nan,0,1"}, 2, "finite"},
           {{"--direction", "0,0,1", "--up", "0,0,-3"}, 2, "upwards"},
           {{"--scale", "50"}, 2, "such as 1:50"},
           {{"--tolerance", "-1mm"}, 2, "positive"},
           {{"--region", "metal"}, 3, "no metal"},
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
