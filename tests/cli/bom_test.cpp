#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"

namespace dupin::test {
namespace {

using std::numbers::pi;
using testing::HasSubstr;

using Bom = Tool;

TEST_F(Bom, of_a_document_is_what_its_formulas_say) {
  const auto bill = json({"bom", example("reducer.json"), "--density", "7850"}, 0);
  const auto& inlet = bill.at("parts").at(0);
  EXPECT_EQ(inlet.at("name"), "inlet");
  EXPECT_NEAR(inlet.at("metal").at("volume").get<double>(), 10 * pi, 1e-11);
  EXPECT_NEAR(inlet.at("metal").at("mass").get<double>(), 10 * pi * 7850e-9, 1e-15);
  EXPECT_NEAR(inlet.at("area").get<double>(), 20 * pi, 1e-11);
  EXPECT_EQ(bill.at("density"), 7850);
}

TEST_F(Bom, refuses_a_component_by_its_line) {
  folder_.write("a.pcf",
                "UNITS-BORE INCH\nUNITS-CO-ORDS MM\nPIPE\n END-POINT 0 0 0 4\n"
                " END-POINT 1000 0 0 4\n WALL-THICKNESS 6.02\n");
  const ProcessResult refused = dupin({"bom", "a.pcf"}),
                      built = dupin({"build", "a.pcf", "-o", "a.off"});
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_THAT(refused.err, HasSubstr("a.pcf:3: 'pipe-3': a wall of 152.908 leaves no bore"));
  EXPECT_EQ(built.err.substr(0, 40), refused.err.substr(0, 40));
}

TEST_F(Bom, of_a_line_names_components_and_takes_off_pipe_by_the_metre) {
  const auto bill = json({"bom", example("line.pcf"), "--wall", "3mm"}, 0);
  bool has_elbow = false, has_pipe = false;
  for (const auto& entry : bill.at("take_off")) {
    has_elbow |= entry.at("component_kind") == "ELBOW" && entry.at("size") == "DN100" &&
                 entry.at("bend_degrees") == 90 && entry.at("count") == 1;
    has_pipe |= entry.at("component_kind") == "PIPE" && entry.at("size") == "DN100" &&
                entry.at("count") == 2;
  }
  EXPECT_TRUE(has_elbow);
  EXPECT_TRUE(has_pipe);
  EXPECT_TRUE(bill.contains("piping"));
  for (const auto& part : bill.at("parts")) {
    EXPECT_GT(part.at("line"), 0);
    EXPECT_GT(part.at("metal").at("volume"), 0);
  }
}

// It is built with its wall, which was taken for the whole.
TEST_F(Bom, with_a_mesh_has_the_regions_of_a_hollow_chain) {
  folder_.write("chain.json", R"({"units": "mm", "tolerance": 0.02, "parts": [
    {"name": "x", "cyclide_chain": {"spheres": [[0, 1.8, -2.6, 3.9], [15, 3.6, -0.6, 2.3],
    [30, -3.6, -2.9, 3.7]], "direction": [1, 0, 0], "wall": 1}}]})");
  const auto volumes = json({"bom", "chain.json", "--mesh"}, 0).at("mesh").at("volumes");
  for (const std::string region : {"outer", "metal", "fluid"}) {
    const auto report = json({"build", "chain.json", "-o", "x.off", "--region", region}, 0);
    EXPECT_EQ(volumes.at(region), report.at("volumes").at(region)) << region;
    EXPECT_GT(volumes.at(region), 0) << region;
  }
}

// A branch that begins on the axis of its run: what lies in both counts once in the mesh alone.
TEST_F(Bom, with_a_mesh_says_what_counts_twice) {
  folder_.write("tee.json", R"({"units": "mm", "tolerance": 0.01, "parts": [
    {"name": "run", "pipe": {"from": [-10, 0, 0], "to": [10, 0, 0], "radius": 2}},
    {"name": "branch", "pipe": {"from": [0, 0, 0], "to": [0, 0, 8], "radius": 2}}]})");
  const auto bill = json({"bom", "tee.json", "--mesh"}, 0);
  const double sum = bill.at("sum").at("metal").at("volume"),
               mesh = bill.at("mesh").at("volumes").at("metal");
  // Half of two equal cylinders' common part, 16 r^3 / 3.
  EXPECT_NEAR(sum - mesh, 64. / 3, 0.01 * bill.at("sum").at("area").get<double>());
  EXPECT_EQ(bill.at("mesh").at("tolerance"), 0.01);
  const auto finer = json({"bom", "tee.json", "--mesh", "--tolerance", "0.002"}, 0);
  EXPECT_LT(std::abs(sum - finer.at("mesh").at("volumes").at("metal").get<double>() - 64. / 3),
            std::abs(sum - mesh - 64. / 3) / 3);
  EXPECT_THAT(dupin({"bom", "tee.json", "--mesh"}).out, HasSubstr("mesh of the union    outer "));
  EXPECT_EQ(dupin({"bom", "tee.json", "--mesh", "--csv"}).exit_code, 2);
}

TEST_F(Bom, of_a_graph_has_a_row_for_each_junction) {
  const auto bill = json({"bom", example("frame.graph"), "--radius", "2"}, 0);
  int junctions = 0;
  for (const auto& part : bill.at("parts")) {
    junctions += part.at("kind") == "junction" ? 1 : 0;
  }
  EXPECT_EQ(junctions, 3);
  EXPECT_TRUE(bill.contains("graph"));
}

TEST_F(Bom, as_csv_and_text_leaves_standard_output_to_results) {
  const auto csv = dupin({"bom", example("line.pcf"), "--csv"});
  EXPECT_EQ(csv.exit_code, 0);
  EXPECT_TRUE(csv.out.starts_with("\"name\",\"kind\","));
  EXPECT_TRUE(csv.out.ends_with("\r\n"));
  EXPECT_THAT(csv.err, HasSubstr("components"));
  EXPECT_EQ(dupin({"bom", example("line.pcf"), "--csv", "-q"}).err, "");
  EXPECT_EQ(dupin({"bom", example("line.pcf"), "--csv"}).out, csv.out);
  EXPECT_THAT(dupin({"bom", example("line.pcf")}).out, HasSubstr("R 152.4, 90 deg"));
}

TEST_F(Bom, refuses_what_makes_no_sense) {
  for (const char* density :
       {"0", "-1", "nan", "inf", "1e999", "1e300", "0x10", "heavy", "7850kg"}) {
    EXPECT_EQ(dupin({"bom", example("reducer.json"), "--density", density}).exit_code, 2)
        << density;
  }
  EXPECT_EQ(dupin({"bom", example("reducer.json"), "--csv", "--json"}).exit_code, 2);
  EXPECT_EQ(dupin({"bom", example("reducer.json"), "--tolerance", "1"}).exit_code, 2);
  EXPECT_EQ(dupin({"bom", "missing.json"}).exit_code, 3);
  const auto folded = dupin({"bom", example("tight.json")});
  EXPECT_EQ(folded.exit_code, 4);
  EXPECT_EQ(folded.out, "");
  EXPECT_THAT(folded.err, HasSubstr("the blend folds there"));
}

}  // namespace
}  // namespace dupin::test
