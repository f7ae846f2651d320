#include <fstream>
#include <map>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

using Pcf = Tool;

const std::string kHead = "UNITS-BORE MM\nUNITS-CO-ORDS MM\n";

std::string pipe(double from, double to, double aside = 0) {
  const auto point = [&](double x) {
    return "    END-POINT " + std::to_string(x) + " " + std::to_string(aside) + " 0 168.3\n";
  };
  return "PIPE\n" + point(from) + point(to);
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

TEST_F(Pcf, lines_become_one_solid_and_say_how) {
  const ProcessResult result = dupin({"build", example("line.pcf"), "-o", "a.stl"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* row : {"met                  12 joints\n", "open ends            3\n",
                          "moved                at most 0.00304",
                          "bore                 line 30: bore 80: outside diameter 88.9 mm (NPS 3, "
                          "DN 80, ASME B36.10M)\n",
                          "components           1\n", "euler number         2\n",
                          "self-intersections   0\n", "gaps                 0\n"}) {
    EXPECT_THAT(result.out, HasSubstr(row));
  }
}

TEST_F(Pcf, regions_of_lines_add_up) {
  std::map<std::string, double> volumes;
  for (const std::string region : {"outer", "metal", "fluid"}) {
    const auto report = json({"build", example("line.pcf"), "-o", "a.off", "--wall", "3mm",
                              "--region", region, "--tolerance", "0.5mm"},
                             0);
    volumes[region] = report.at("output").at("check").at("volume");
    EXPECT_EQ(report.at("output").at("check").at("components"), 1) << region;
  }
  EXPECT_NEAR(volumes["outer"], volumes["metal"] + volumes["fluid"], 1e-9 * volumes["outer"]);
}

TEST_F(Pcf, walls_are_those_of_a_schedule) {
  const auto volumes = json({"build", example("line.pcf"), "-o", "a.off", "--schedule", "40",
                             "--tolerance", "0.5mm"},
                            0)
                           .at("volumes");
  write(folder_.path() / "one.pcf", kHead + pipe(0, 1000));
  const auto one =
      json({"build", "one.pcf", "-o", "a.off", "--schedule", "std", "--tolerance", "0.01mm"}, 0)
          .at("volumes");
  const double metal = std::numbers::pi * (168.3 - 7.11) * 7.11 * 1000;  // DN 150, both sides' area
  const double area = 2 * std::numbers::pi * (168.3 - 7.11) * 1000;
  EXPECT_NEAR(one.at("metal"), metal, 0.01 * area);
  EXPECT_GT(volumes.at("metal"), 0.1 * volumes.at("outer").get<double>());
  for (const auto& [options, code, text] :
       {std::tuple(std::vector<std::string>{"--schedule", "41"}, 3,
                   "there is no schedule '41', but 5"),
        std::tuple(std::vector<std::string>{"--schedule", "100"}, 3, "made in schedule 100"),
        std::tuple(std::vector<std::string>{"--schedule", "40", "--wall", "3mm"}, 2,
                   "one of them")}) {
    std::vector<std::string> arguments{"build", "one.pcf", "-o", "b.off"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProcessResult refused = dupin(arguments);
    EXPECT_EQ(refused.exit_code, code);
    EXPECT_THAT(refused.err, HasSubstr(text));
  }
}

TEST_F(Pcf, lines_are_written_as_documents_that_build_the_same) {
  EXPECT_EQ(dupin({"convert", example("line.pcf"), "line.json"}).exit_code, 0);
  EXPECT_EQ(dupin({"build", "line.json", "-o", "a.off"}).exit_code, 0);
  EXPECT_EQ(dupin({"build", example("line.pcf"), "-o", "b.off"}).exit_code, 0);
  EXPECT_EQ(shell("cmp a.off b.off").exit_code, 0);
  for (const std::vector<std::string>& mesh : {std::vector<std::string>{"line.stl"},
                                               {"line.GLB"},
                                               {"line.msh", "--format", "msh-surface"}}) {
    std::vector<std::string> arguments{"convert", example("line.pcf")};
    arguments.insert(arguments.end(), mesh.begin(), mesh.end());
    const ProcessResult refused = dupin(arguments);
    EXPECT_EQ(refused.exit_code, 2) << refused.out;
    EXPECT_THAT(refused.err, HasSubstr("convert makes a document of a graph or piping file"));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / mesh.front()));
  }
  EXPECT_THAT(dupin({"convert", example("line.pcf"), "-"}).out, HasSubstr("\"parts\": ["));
  EXPECT_EQ(dupin({"convert", example("line.pcf"), "l.json", "--scale", "2"}).exit_code, 2);
}

TEST_F(Pcf, misfits_are_found_bridged_and_reported) {
  write(folder_.path() / "a.pcf", kHead + pipe(0, 1000) + pipe(1000.25, 2000));
  const auto gaps = json({"gaps", "a.pcf"}, 1);
  EXPECT_EQ(gaps.at("findings"), 1);
  const auto apart = json({"build", "a.pcf", "-o", "a.stl"}, 1);
  EXPECT_EQ(apart.at("output").at("check").at("components"), 2);
  EXPECT_EQ(apart.at("piping").at("joints").at(0).at("state"), "apart");
  EXPECT_EQ(apart.at("piping").at("open_ends"), 2);
  const auto report = json({"build", "a.pcf", "-o", "a.stl", "--bridge", "0.5mm"}, 0);
  EXPECT_EQ(report.at("output").at("check").at("components"), 1);
  const auto& joint = report.at("piping").at("joints").at(0);
  EXPECT_EQ(joint.at("state"), "bridged");
  EXPECT_NEAR(joint.at("distance"), .25, 1e-9);
  EXPECT_EQ(joint.at("lines"), (nlohmann::json{5, 7}));
  EXPECT_EQ(joint.at("part"), "bridge-5-7");
}

TEST_F(Pcf, what_is_not_understood_counts_if_asked_to) {
  write(folder_.path() / "a.pcf", kHead + pipe(0, 1000) + "    WOBBLE 7\n");
  const ProcessResult lax = dupin({"build", "a.pcf", "-o", "a.stl"});
  EXPECT_EQ(lax.exit_code, 0);
  EXPECT_THAT(lax.out, HasSubstr("warning              line 6: 'WOBBLE' is not understood\n"));
  EXPECT_EQ(dupin({"build", "a.pcf", "-o", "a.stl", "--strict"}).exit_code, 1);
}

TEST_F(Pcf, what_cannot_be_built_is_refused_or_left_out) {
  write(folder_.path() / "a.pcf", kHead + pipe(0, 1000) + "PIPE\n    END-POINT 0 500 0 100\n");
  const ProcessResult refused = dupin({"build", "a.pcf", "-o", "a.stl"});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, HasSubstr("a.pcf:6: 'pipe-6': it has one end instead of two"));
  const ProcessResult rest = dupin({"build", "a.pcf", "-o", "a.stl", "--keep-going"});
  EXPECT_EQ(rest.exit_code, 1);
  EXPECT_THAT(rest.out, HasSubstr("refused              line 6: pipe-6: left out"));
  EXPECT_EQ(dupin({"check", "a.stl"}).exit_code, 0);
}

TEST_F(Pcf, lines_are_named_where_a_part_is_refused) {
  write(folder_.path() / "a.pcf", kHead + pipe(0, 1000));
  const ProcessResult refused =
      dupin({"build", "a.pcf", "-o", "a.stl", "--wall", "90mm", "--region", "metal"});
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_THAT(refused.err, HasSubstr("a.pcf:3: 'pipe-3': a wall of 90 leaves no bore"));
  EXPECT_THAT(refused.err, HasSubstr("--keep-going leaves it out"));
}

TEST_F(Pcf, malformed_lines_are_named) {
  write(folder_.path() / "a.pcf", kHead + "PIPE\n    END-POINT 0 zero 0 100\n");
  const ProcessResult result = dupin({"build", "a.pcf", "-o", "a.stl"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("a.pcf:4: found 'zero', expected a coordinate"));
}

TEST_F(Pcf, tees_get_fillets) {
  const auto plain = json({"build", example("line.pcf"), "-o", "a.off"}, 0),
             filleted = json({"build", example("line.pcf"), "-o", "a.off", "--fillet", "auto"}, 0);
  EXPECT_GT(filleted.at("output").at("check").at("volume"),
            plain.at("output").at("check").at("volume"));
  EXPECT_EQ(filleted.at("output").at("check").at("euler_number"), 2);
  EXPECT_THAT(dupin({"build", example("line.pcf"), "-o", "a.stl", "--fillet", "10mm"}).out,
              HasSubstr("tee-26-branch-fillet has a ball of radius 10\n"));
  const ProcessResult refused =
      dupin({"build", example("line.pcf"), "-o", "a.stl", "--fillet", "1m"});
  EXPECT_EQ(refused.exit_code, 4);  // as of a document
  EXPECT_THAT(refused.err, HasSubstr("line.pcf:26: 'tee-26': tee-26-branch-fillet does not fit"));
}

TEST_F(Pcf, options_of_piping_files_are_for_them) {
  EXPECT_EQ(dupin({"build", example("reducer.json"), "-o", "a.stl", "--bridge", "1mm"}).exit_code,
            2);
  EXPECT_EQ(dupin({"build", example("line.pcf"), "-o", "a.stl", "--radius", "1mm"}).exit_code, 2);
}

TEST_F(Pcf, lines_come_from_standard_input) {
  EXPECT_EQ(shell("dupin build - -o a.off < examples/line.pcf").exit_code, 0);
  EXPECT_EQ(dupin({"build", example("line.pcf"), "-o", "b.off"}).exit_code, 0);
  EXPECT_EQ(shell("cmp a.off b.off").exit_code, 0);
  EXPECT_EQ(shell("dupin convert - a.json < examples/line.pcf").exit_code, 0);
  EXPECT_EQ(shell("dupin gaps - < examples/line.pcf").exit_code,
            dupin({"gaps", example("line.pcf")}).exit_code);
}

TEST_F(Pcf, documents_keep_what_is_taken_off) {
  EXPECT_EQ(dupin({"convert", example("line.pcf"), "line.json", "--wall", "3mm"}).exit_code, 0);
  const auto of_line = json({"bom", example("line.pcf"), "--wall", "3mm"}, 0),
             of_document = json({"bom", "line.json"}, 0);
  EXPECT_EQ(of_line.at("take_off"), of_document.at("take_off"));
  EXPECT_EQ(of_line.at("parts"), of_document.at("parts"));
}

TEST_F(Pcf, reports_begin_with_a_summary) {
  write(folder_.path() / "a.pcf", kHead + pipe(0, 1000) + pipe(1000.25, 2000) + pipe(2000, 2500));
  EXPECT_THAT(dupin({"build", "a.pcf", "-o", "a.stl", "--bridge", "0.5mm"}).out,
              HasSubstr("summary              3 components, 4 parts, 2 open ends; joints: 1 met, 0 "
                        "stepped, 0 blended, 1 bridged, 0 apart; 0 refused\n"));
}

TEST_F(Pcf, insulation_goes_round_lines) {
  const auto report = json({"build", example("line.pcf"), "-o", "a.off", "--insulation", "30mm",
                            "--region", "insulation", "--tolerance", "1mm"},
                           0);
  EXPECT_EQ(report.at("region"), "insulation");
  EXPECT_GT(report.at("volumes").at("insulation"), 1e6);
  EXPECT_EQ(report.at("output").at("check").at("components"), 1);
  EXPECT_EQ(
      dupin({"build", example("line.pcf"), "-o", "a.off", "--region", "insulation"}).exit_code, 3);
}

TEST_F(Pcf, lines_can_be_looked_at) {
  EXPECT_THAT(dupin({"info", example("line.pcf")}).out, HasSubstr("  elbow-14: elbow\n"));
  EXPECT_EQ(dupin({"nurbs", example("line.pcf"), "-o", "a.json"}).exit_code, 0);
}

// Whose points lie beside the axis of what goes on, by more than the tolerance.
TEST_F(Pcf, documents_of_eccentric_reducers_are_built_whatever_the_snap_tolerance) {
  write(folder_.path() / "line.pcf",
        kHead +
            "REDUCER-ECCENTRIC\n    END-POINT 4863.3 0.1 573 50\n"
            "    END-POINT 4890 4.1 657.4 100\n"
            "ELBOW\n    END-POINT 4889.8 4.5 657.7 100\n"
            "    END-POINT 5232.7 4.5 1000.6 100\n    CENTRE-POINT 4889.8 4.5 1000.6\n");
  const auto converted = json({"convert", "line.pcf", "line.json", "--snap", "1"}, 0);
  EXPECT_NEAR(double(converted.at("piping").at("largest_move")), 0.538516, 1e-6);
  for (const char* file : {"line.pcf", "line.json"}) {
    std::vector<std::string> arguments{"build", file, "-o", "a.stl"};
    if (file == std::string("line.pcf")) {
      arguments.insert(arguments.end(), {"--snap", "1"});
    }
    const ProcessResult result = dupin(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
}

TEST_F(Pcf, the_largest_move_is_that_of_any_end) {
  write(folder_.path() / "line.pcf",
        kHead +
            "PIPE\n    END-POINT 0 0 0 100\n    END-POINT 1000 0 0 100\n"
            "ELBOW\n    END-POINT 1000 0 0 100\n    END-POINT 1152.1 152 0 100\n"
            "    CENTRE-POINT 1152.1 0 0\n");
  EXPECT_THAT(dupin({"convert", "line.pcf", "line.json"}).out,
              HasSubstr("moved                at most 0.05 mm"));
}

}  // namespace
}  // namespace dupin::test
