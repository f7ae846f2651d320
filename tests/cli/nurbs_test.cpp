#include <string>

#include <gtest/gtest.h>

#include "cli/tool.h"

namespace dupin::test {
namespace {

using Nurbs = Tool;

TEST_F(Nurbs, are_exact_or_within_the_tolerance) {
  const auto report =
      json({"nurbs", example("reducer.json"), "-o", "a.nurbs.json", "--tolerance", "0.001mm"}, 0);
  EXPECT_EQ(report.at("file"), "a.nurbs.json");
  ASSERT_EQ(report.at("parts").size(), 3);
  EXPECT_EQ(report.at("parts")[0].at("error_bound"), 0) << "a pipe";
  EXPECT_GT(report.at("parts")[2].at("error_bound"), 0) << "a cyclic blend";
  EXPECT_LE(report.at("parts")[2].at("error_bound"), 0.001);
}

TEST_F(Nurbs, of_spines_that_turn_back_are_within_the_tolerance) {
  for (const char* const name : {"u-bend.json", "u-bend-cyclide.json", "two-cones.json"}) {
    const auto report = json({"nurbs", example(name), "-o", "a.json", "--tolerance", "0.01mm"}, 0);
    for (const auto& part : report.at("parts")) {
      EXPECT_LE(part.at("error_bound"), 0.01) << name;
    }
  }
}

TEST_F(Nurbs, of_a_junction_are_exact_and_its_hub_is_trimmed) {
  const auto report = json({"nurbs", example("junction.json"), "-o", "a.json"}, 0);
  for (const auto& part : report.at("parts")) {
    EXPECT_EQ(part.at("error_bound"), 0) << part;
  }
  const auto hub = nlohmann::json::parse(folder_.read("a.json")).at("parts").back();
  EXPECT_EQ(hub.at("part"), "hub");
  EXPECT_EQ(hub.at("trims").size(), 5);
  EXPECT_EQ(hub.at("trims")[0].at("degree"), 2);
  EXPECT_EQ(dupin({"nurbs", example("frame.graph"), "-o", "b.json", "--radius", "2"}).exit_code, 0);
}

TEST_F(Nurbs, go_to_standard_output_alone) {
  const std::string nozzle = example("oblique-nozzle.json");
  ASSERT_EQ(dupin({"nurbs", nozzle, "-o", "a.json", "-q"}).exit_code, 0);
  const ProcessResult piped = dupin({"nurbs", nozzle, "-o", "-"});
  EXPECT_EQ(piped.out, folder_.read("a.json"));
  EXPECT_EQ(piped.err, "");
  EXPECT_EQ(dupin({"nurbs", nozzle, "-o", "missing/a.json"}).exit_code, 5);
}

}  // namespace
}  // namespace dupin::test
