#include "placement_options.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/io/mesh_file.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

using PlacementOptions = Tool;

TEST_F(PlacementOptions, are_applied_in_the_order_of_the_command_line) {
  put("a.off", box({0, 0, 0}, {1, 2, 4}));
  const auto corner = [&](std::vector<std::string> steps) {
    steps.insert(steps.begin(), {"convert", "a.off", "b.off"});
    const auto report = json(steps, 0);
    EXPECT_EQ(report.at("placement").at("exact"), true);
    EXPECT_EQ(report.at("placement").at("largest_move"), 0);
    EXPECT_EQ(report.at("check").at("solid"), true);
    return Vec3(read_mesh(folder_.read("b.off"), "b.off").points[7]);  // was (1, 2, 4)
  };
  EXPECT_EQ(corner({"--translate", "-10mm,0.5cm,1"}), Vec3(-9, 7, 5));
  EXPECT_EQ(corner({"--translate", "1,0,0", "--rotate", "0,0,1,90"}), Vec3(-2, 2, 4));
  EXPECT_EQ(corner({"--rotate", "0,0,1,90", "--translate", "1,0,0"}), Vec3(-1, 1, 4));
  EXPECT_EQ(corner({"--rotate=0,0,1,90,1,0,0mm"}), Vec3(-1, 0, 4));
  EXPECT_EQ(
      corner({"--scale", "2", "--translate", "1,0,0", "--scale", "0.5", "--translate", "0,0,-4"}),
      Vec3(1.5, 2, 0));
}

TEST_F(PlacementOptions, of_a_solid_keep_it_one_and_say_what_was_rounded) {
  put("a.off", tube(1.0 / 3, 0, 1, 24));
  const auto before = json({"check", "a.off"}, 0);
  const std::vector<std::string> slanted = {"--rotate", "1,2,3,33", "--translate", "0.1,1e5,3"};
  for (const std::string name : {"b.off", "b.stl"}) {
    std::vector<std::string> arguments = {"convert", "a.off", name};
    arguments.insert(arguments.end(), slanted.begin(), slanted.end());
    const auto report = json(arguments, 0);
    EXPECT_EQ(report.at("placement").at("exact"), false);
    EXPECT_GT(report.at("placement").at("largest_move"), 0);
    EXPECT_LT(report.at("placement").at("largest_move"), name == "b.off" ? 1e-10 : 0.1);
    EXPECT_EQ(report.at("check").at("solid"), true);
  }
  const ProcessResult text = dupin({"convert", "a.off", "c.off", "--scale", "3"});
  EXPECT_THAT(text.out, HasSubstr("placed               not exactly, points at most "));
  EXPECT_THAT(dupin({"convert", "a.off", "c.off", "--scale", "4"}).out,
              HasSubstr("placed               exactly\n"));
}

TEST_F(PlacementOptions, of_what_is_no_solid_round_each_point) {
  put("a.off", open_box());
  const auto report = json({"convert", "a.off", "b.off", "--rotate", "0,0,1,90"}, 0);
  EXPECT_EQ(report.at("placement").at("exact"), true);
  EXPECT_EQ(report.at("check").at("triangles"), 11);
  const auto moved = json({"convert", "a.off", "b.stl", "--translate", "0.1,0,0"}, 0);
  EXPECT_EQ(moved.at("placement").at("exact"), false);
}

TEST_F(PlacementOptions, lengths_are_in_the_unit_of_the_file) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  folder_.write("in.off", "OFF\n# unit: in\n" + folder_.read("a.off").substr(4));
  const auto moved = [&](const std::string& by) {
    EXPECT_EQ(dupin({"convert", "in.off", "b.off", "-q", "--translate", by}).exit_code, 0);
    return read_mesh(folder_.read("b.off"), "b.off").points[0].x();
  };
  EXPECT_EQ(moved("1,0,0"), 1);
  EXPECT_EQ(moved("-50.8mm,0,0"), -2);
}

TEST_F(PlacementOptions, put_a_document_elsewhere_that_builds) {
  const auto before = json({"build", example("reducing-elbow.json"), "-o", "a.off"}, 0);
  const auto report = json({"edit", example("reducing-elbow.json"), "-o", "b.json", "--scale", "2",
                            "--rotate", "1,0,0,90", "--translate", "1m,0,0"},
                           0);
  EXPECT_EQ(report.at("file"), "b.json");
  EXPECT_TRUE(report.at("placement").contains("exact"));
  const auto after = json({"build", "b.json", "-o", "b.off"}, 0);
  const auto volume = [](const nlohmann::json& built) {
    return built.at("output").at("check").at("volume").get<double>();
  };
  EXPECT_NEAR(volume(after) / volume(before), 8, 1e-3);
  const ProcessResult piped =
      shell("dupin edit examples/reducer.json -o - --rotate 0,0,1,33 | dupin build - -o c.off -q");
  EXPECT_EQ(piped.exit_code, 0) << piped.err;
  EXPECT_THAT(piped.err, HasSubstr("placed               not exactly, points at most "));
}

TEST_F(PlacementOptions, put_no_document_where_it_would_not_build) {
  const ProcessResult far =
      dupin({"edit", example("tee.json"), "-o", "b.json", "--translate", "1e11,0,0"});
  EXPECT_EQ(far.exit_code, 3);
  EXPECT_THAT(far.err, HasSubstr("the tolerance, 0.02, is too small for coordinates of 1e+11"));
  EXPECT_THAT(folder_.files(), IsEmpty());
}

TEST_F(PlacementOptions, that_make_no_sense_are_refused) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  const std::string lengths = "--translate takes three lengths X,Y,Z such as 10mm,0,-5, not '";
  const std::string turn =
      "--rotate takes an axis and degrees AX,AY,AZ,DEGREES, and a point X,Y,Z of the axis if it is "
      "not the origin, such as 0,0,1,90, not '";
  const std::string factor = "--scale takes a positive factor such as 25.4, not '";
  const std::vector<std::vector<std::string>> table = {
      {"--translate", "1,2", lengths + "1,2'"},
      {"--translate", "1,2,x", lengths + "1,2,x'"},
      {"--translate", "1,2,", lengths + "1,2,'"},
      {"--translate", "1,2,3yd", "the unit must be mm, cm, m, in or ft, not 'yd'"},
      {"--translate", "1,2,0yd", "the unit must be mm, cm, m, in or ft, not 'yd'"},
      {"--translate", "nan,2,3", lengths + "nan,2,3'"},
      {"--rotate", "0,0,1", turn + "0,0,1'"},
      {"--rotate", "0,0,0,90", turn + "0,0,0,90'"},
      {"--rotate", "0,0,1,90deg", turn + "0,0,1,90deg'"},
      {"--rotate", "0,0,1,90,1,2", turn + "0,0,1,90,1,2'"},
      {"--scale", "0", factor + "0'"},
      {"--scale", "-1", factor + "-1'"},
      {"--scale", "2mm", factor + "2mm'"},
      {"--scale", "inf", factor + "inf'"}};
  for (const auto& row : table) {
    const ProcessResult result = dupin({"convert", "a.off", "b.off", row[0], row[1]});
    EXPECT_EQ(result.exit_code, 2) << row[1];
    EXPECT_EQ(result.err, "dupin: " + row[2] + " (see dupin --help)\n");
  }
  EXPECT_EQ(
      dupin({"edit", example("crane-hook.json"), "-o", "b.json", "--scale", "2", "--twist", "6=25"})
          .exit_code,
      2);
  EXPECT_EQ(dupin({"convert", "a.off", "b.off", "--scale", "1e50"}).exit_code, 3);
  EXPECT_EQ(folder_.files(), std::vector<std::string>{"a.off"});
}

}  // namespace
}  // namespace dupin::test
