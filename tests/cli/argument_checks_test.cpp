#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/kernel/solver_mesh.h"
#include "number_range.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;
using testing::IsSubsetOf;

using Words = std::vector<std::string>;

class ArgumentChecks : public Tool {
 protected:
  ArgumentChecks() {
    put("a.off", box({0, 0, 0}, {2, 2, 2}));
    put("b.off", box({1, 1, 1}, {3, 3, 3}));
    folder_.write("d.json", text_);
    std::filesystem::create_symlink("d.json", folder_.path() / "link.json");
  }

  // Refused for that, and nothing has changed.
  void expect_refused(const Words& words, const std::string& why) const {
    const ProcessResult result = dupin(words);
    EXPECT_EQ(result.exit_code, 2) << testing::PrintToString(words) << result.err;
    EXPECT_THAT(result.err, HasSubstr(why));
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(folder_.files(), IsSubsetOf({"a.off", "b.off", "d.json", "link.json", "in"}));
    EXPECT_EQ(folder_.read("d.json"), text_);
  }

  const std::string text_ =
      R"({"units": "mm", "tolerance": 0.1, "parts": [{"name": "p",
          "pipe": {"from": [0, 0, 0], "to": [0, 0, 9], "radius": 2}}]})";
};

// As of variables that a script has not set: a pipe would be solid instead of hollow.
TEST_F(ArgumentChecks, no_value_is_empty) {
  const std::vector<std::pair<Words, std::string>> table = {
      {{"build", "d.json", "-o", "x.stl", "--wall", ""}, "--wall is empty"},
      {{"build", "d.json", "-o", "x.stl", "--memory", ""}, "--memory is empty"},
      {{"build", "d.json", "-o", "x.stl", "--cache", ""}, "--cache is empty"},
      {{"build", "d.json", "-o", "x.stl", "--patches="}, "--patches"},
      {{"build", "d.json", "-o", ""}, "--output is empty"},
      {{"build", "", "-o", "x.stl"}, "FILE is empty"},
      {{"build", "d.json", "-o", "x.stl", "--tolerance", ""}, "--tolerance is empty"},
      {{"certify", "d.json", "-o", "x.cert", "--margin", ""}, "--margin is empty"},
      {{"convert", "a.off", "x.stl", "--grid", ""}, "--grid is empty"},
      {{"convert", "a.off", "x.stl", "--rounding-tolerance", ""}, "--rounding-tolerance is empty"},
      {{"gaps", "d.json", "--connect", ""}, "--connect is empty"},
      {{"remesh", "a.off", "x.off", "--size", ""}, "--size is empty"},
      {{"draw", "d.json", "-o", "x.svg", "--scale", ""}, "--scale is empty"},
      {{"union", "a.off", "", "-o", "x.off"}, "IN is empty"}};
  for (const auto& [words, why] : table) {
    expect_refused(words, why);
  }
}

TEST_F(ArgumentChecks, every_output_has_a_file_of_its_own) {
  const std::string here = folder_.path().filename();
  const std::vector<Words> table = {{"--patches", "x.stl"},
                                    {"--report", "x.stl"},
                                    {"--report", "./x.stl"},
                                    {"--patches", "../" + here + "/x.stl"},
                                    {"--patches", (folder_.path() / "x.stl").string()},
                                    {"--patches", "r.html", "--report", "r.html"},
                                    {"--patches", "./r.html", "--report", "r.html"}};
  for (const Words& others : table) {
    Words words{"build", "d.json", "-o", "x.stl"};
    words.insert(words.end(), others.begin(), others.end());
    expect_refused(words, "takes a file of its own, not that of --");
  }
  // Links to what is not there yet are followed as others are.
  std::filesystem::create_directory(folder_.path() / "in");
  std::filesystem::create_symlink("new.html", folder_.path() / "in/chain");
  std::filesystem::create_symlink("chain", folder_.path() / "in/new.stl");
  for (const char* const option : {"--patches", "--report"}) {
    expect_refused({"build", "d.json", "-o", "in/new.stl", option, "in/new.html"},
                   "takes a file of its own, not that of --");
  }
  const ProcessResult apart =
      dupin({"build", "d.json", "-o", "x.stl", "--patches", "x.json", "--report", "x.html", "-q"});
  EXPECT_EQ(apart.exit_code, 0) << apart.err;
}

TEST_F(ArgumentChecks, no_output_takes_the_place_of_another_kind_of_input) {
  for (const char* const name : {"d.json", "./d.json", "link.json"}) {
    const std::vector<Words> table = {
        {"certify", "d.json", "-o", name},
        {"certify", "link.json", "-o", name},
        {"nurbs", "d.json", "-o", name},
        {"report", "d.json", "-o", name},
        {"draw", "d.json", "-o", name},
        {"build", "d.json", "-o", name, "--format", "stl"},
        {"build", "d.json", "-o", name, "--format", "stl", "--tiles", "2"},
        {"build", "d.json", "-o", "x.stl", "--patches", name},
        {"build", "d.json", "-o", "x.stl", "--report", name},
        {"watch", "d.json", "-o", name, "--format", "stl"}};
    for (const Words& words : table) {
      expect_refused(words, " would take the place of what is read: ");
    }
  }
  std::filesystem::create_directory(folder_.path() / "in");
  folder_.write("in/p_0.vtu", text_);
  std::filesystem::create_symlink("../d.json", folder_.path() / "in/q_12.vtu");
  for (const Words& words : {Words{"build", "in/p_0.vtu", "-o", "in/p.pvtu"},
                             {"build", "d.json", "-o", "in/q.pvtu"},
                             {"build", "d.json", "-o", "in/q.x", "--format", "pvtu"}}) {
    expect_refused(words, "--output would take the place of what is read: ");
  }
  expect_refused({"build", "in/p_0.vtu", "-o", "in/p.pvtu"}, "in/p_0.vtu");
  expect_refused({"build", "d.json", "-o", "in/r.pvtu", "--report", "in/r_3.vtu"},
                 "takes a file of its own, not that of --");
  expect_refused({"union", "a.off", "b.off", "-o", "x.off", "--patches", "b.off"},
                 "--patches would take the place of what is read: ");
  expect_refused({"boolean", "a + b", "a=a.off", "b=./b.off", "-o", "x.off", "--patches", "b.off"},
                 "--patches would take the place of what is read: ");
}

// Which only the document names.
TEST_F(ArgumentChecks, no_output_takes_the_place_of_a_mesh_that_is_avoided) {
  std::filesystem::create_directory(folder_.path() / "in");
  const std::string ball =
      "OFF\n4 4 0\n40 0 0\n41 0 0\n40 1 0\n40 0 1\n"
      "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  folder_.write("in/ball.off", ball);
  folder_.write("in/a.json", R"({"units": "mm", "tolerance": 0.1, "parts": [
      {"name": "p", "pipe": {"from": [0, 0, 0], "to": [0, 0, 9], "radius": 1}},
      {"name": "q", "pipe": {"from": [9, 0, 20], "to": [9, 0, 29], "radius": 1}},
      {"name": "s", "spline": {"from": "p.end", "to": "q.start", "clearance": 1,
                               "avoid": [{"mesh": "ball.off"}]}}]})");
  for (const Words& words : std::vector<Words>{
           {"build", "in/a.json", "-o", "in/ball.off"},
           {"build", "in/a.json", "-o", "in/../in/ball.off", "--tiles", "2", "--format", "ply"},
           {"build", "in/a.json", "-o", "x.stl", "--report", "in/ball.off"},
           {"build", "in/a.json", "-o", "x.stl", "--patches", "in/ball.off"},
           {"certify", "in/a.json", "-o", "in/ball.off"},
           {"report", "in/a.json", "-o", "in/ball.off"},
           {"edit", "in/a.json", "-o", "in/ball.off", "--translate", "1,0,0"}}) {
    expect_refused(words, " would take the place of what is read: ");
    EXPECT_EQ(folder_.read("in/ball.off"), ball);
  }
  EXPECT_EQ(dupin({"build", "in/a.json", "-o", "in/x.off"}).exit_code, 0);
}

TEST_F(ArgumentChecks, a_page_does_not_become_its_own_document) {
  std::filesystem::copy_file(folder_.path() / "d.json", folder_.path() / "d.html");
  const ProcessResult result = dupin({"report", "d.html"});
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_THAT(result.err, HasSubstr("the page would take the place of what is read, d.html"));
  EXPECT_EQ(folder_.read("d.html"), text_);
}

// Not after minutes of work: the document is not even read.
TEST_F(ArgumentChecks, where_no_file_can_be_put_is_said_at_once) {
  std::filesystem::create_directory(folder_.path() / "folder");
  for (const std::string place : {"nowhere/x.stl", "folder", "d.json/x.stl"}) {
    for (const Words& words :
         std::vector<Words>{{"build", "no.json", "-o", place, "--format", "stl"},
                            {"build", "no.json", "-o", "x.stl", "--report", place},
                            {"union", "no.off", "no.off", "-o", "x.off", "--patches", place},
                            {"certify", "no.json", "-o", place}}) {
      const ProcessResult result = dupin(words);
      EXPECT_EQ(result.exit_code, 5) << testing::PrintToString(words) << result.err;
      EXPECT_THAT(result.err, HasSubstr(place));
    }
  }
}

TEST_F(ArgumentChecks, a_graph_does_not_become_a_document_of_its_name) {
  const std::string graph = "1 0 0 0 0 1 -1\n2 0 9 0 0 1 1\n";
  folder_.write("g.swc", graph);
  for (const char* const name : {"g.swc", "./g.swc"}) {
    const ProcessResult result = dupin({"convert", "g.swc", name});
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_THAT(result.err, HasSubstr("OUT would take the place of what is read: "));
    EXPECT_EQ(folder_.read("g.swc"), graph);
  }
  EXPECT_EQ(dupin({"convert", "g.swc", "g.json"}).exit_code, 0);
}

TEST_F(ArgumentChecks, many_documents_do_not_become_themselves) {
  std::filesystem::create_directory(folder_.path() / "out");
  folder_.write("out/t.stl", text_);
  const ProcessResult result = dupin({"build", "out/t.stl", "d.json", "--out-dir", "out"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("'out/t.stl' would take the place of 'out/t.stl'"));
  EXPECT_EQ(folder_.read("out/t.stl"), text_);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out/d.stl"));
}

TEST_F(ArgumentChecks, new_versions_are_written_in_place) {
  for (const Words& words :
       std::vector<Words>{{"union", "a.off", "b.off", "-o", "a.off"},
                          {"subtract", "a.off", "b.off", "-o", "b.off"},
                          {"repair", "a.off", "-o", "a.off"},
                          {"convert", "a.off", "a.off"},
                          {"edit", "d.json", "-o", "d.json", "--translate", "1,0,0"}}) {
    const ProcessResult result = dupin(words);
    EXPECT_EQ(result.exit_code, 0) << testing::PrintToString(words) << result.err;
  }
}

TEST(NumberRange, takes_numbers_between_its_ends_and_nothing_else) {
  const CLI::Validator range = cli::number_range(0, 30);
  for (std::string typed : {"0", "30", "1e1", "0.5"}) {
    EXPECT_EQ(range(typed), "") << typed;
  }
  for (std::string typed : {"nan", "-nan", "inf", "30.1", "-1", "x", ""}) {
    EXPECT_EQ(range(typed), "Value " + typed + " not in range 0 - 30");
  }
  EXPECT_EQ(range.get_description(), "FLOAT in [0 - 30]");
}

TEST_F(ArgumentChecks, numbers_are_refused_where_they_are_none) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  const std::string plant = example("reducer.json");
  const std::vector<std::pair<std::string, std::vector<std::string>>> table = {
      {"--dpi", {"draw", plant, "-o", "a.png"}},
      {"--angle", {"remesh", "a.off", "b.off", "--tolerance", "0.1"}},
      {"--sharp", {"remesh", "a.off", "b.off", "--tolerance", "0.1"}},
      {"--sharp", {"build", plant, "-o", "a.stl", "--quality", "cfd"}},
      {"--margin", {"certify", plant, "-o", "c.json"}},
      {"--margin", {"edit", example("crane-hook.json"), "--twist", "6=1", "-o", "d.json"}},
      {"--density", {"bom", plant}}};
  for (const auto& [option, command] : table) {
    for (const char* const value : {"nan", "inf"}) {
      std::vector<std::string> arguments = command;
      arguments.insert(arguments.end(), {option, value});
      const ProcessResult result = dupin(arguments);
      EXPECT_EQ(result.exit_code, 2) << command[0] << option << value;
      EXPECT_THAT(result.err, HasSubstr(option)) << command[0];
    }
  }
}

class IdleOptions : public Tool {
 protected:
  // Refused before anything is read, so that there need be no document.
  void expect_refused(Words command, const Words& options, const std::string& why) const {
    command.insert(command.end(), options.begin(), options.end());
    const ProcessResult result = dupin(command);
    EXPECT_EQ(result.exit_code, 2) << testing::PrintToString(command) << result.err;
    EXPECT_THAT(result.err, HasSubstr(options.front()));
    EXPECT_THAT(result.err, HasSubstr(why));
    EXPECT_TRUE(folder_.files().empty());
  }
};

// They were ignored without a word: who gives them expects something of them.
TEST_F(IdleOptions, of_meshes_are_refused_beside_step) {
  for (const Words& options : std::vector<Words>{{"--quality", "cfd"},
                                                 {"--quality", "cad"},
                                                 {"--size", "1mm"},
                                                 {"--distance", "1mm"},
                                                 {"--angle", "20"},
                                                 {"--sharp", "30"},
                                                 {"--origin", "auto"},
                                                 {"--grid", "0.5"},
                                                 {"--rounding-tolerance", "0.1"},
                                                 {"--verify", "full"},
                                                 {"--no-verify"}}) {
    expect_refused({"build", "no.json", "-o", "a.step"}, options, "a STEP file");
    expect_refused({"watch", "no.json", "-o", "a.stp"}, options, "a STEP file");
  }
  expect_refused({"build", "no.json", "-o", "a.step"}, {"--contacts", "separate=1mm"}, "refuse");
  expect_refused({"build", "no.json", "-o", "a.step"}, {"--contacts", "bridge=1mm"}, "refuse");
}

TEST_F(IdleOptions, of_surfaces_are_refused_beside_tetrahedra) {
  for (const Words& command :
       std::vector<Words>{{"build", "no.json", "-o", "a.vtu"},
                          {"build", "no.json", "-o", "a", "--format", "msh"},
                          {"remesh", "no.off", "a.msh", "--tolerance", "1"}}) {
    for (const Words& options : std::vector<Words>{{"--origin", "auto"},
                                                   {"--grid", "0.5"},
                                                   {"--rounding-tolerance", "0.1"},
                                                   {"--verify", "full"}}) {
      expect_refused(command, options, "write a surface");
    }
  }
  expect_refused({"build", "no.json", "-o", "a.vtu"}, {"--quality", "cad"}, "always for solvers");
}

TEST_F(IdleOptions, of_meshes_for_solvers_are_refused_beside_others) {
  for (const Words& options : std::vector<Words>{
           {"--size", "1mm"}, {"--distance", "1mm"}, {"--angle", "25"}, {"--sharp", "40"}}) {
    expect_refused({"build", "no.json", "-o", "a.stl"}, options, "--quality cfd");
    expect_refused({"build", "no.json", "-o", "a.stl", "--quality", "cad"}, options,
                   "--quality cfd");
  }
}

TEST_F(IdleOptions, of_many_documents_are_refused_for_one) {
  expect_refused({"build", "no.json", "-o", "a.stl"}, {"--jobs", "2"}, "--out-dir");
}

// They were settled when a mesh for solvers was rounded, which is not made of what touches itself.
TEST_F(IdleOptions, contacts_are_settled_before_meshes_for_solvers_are_made) {
  if (!has_mesh_generator()) {
    GTEST_SKIP() << "this build makes no meshes for solvers";
  }
  folder_.write("touch.json", R"({"units": "mm", "tolerance": 0.2, "parts": [
      {"name": "a", "sphere": {"center": [0, 0, 0], "radius": 2}},
      {"name": "b", "sphere": {"center": [0, 0, 4], "radius": 2}}]})");
  EXPECT_EQ(dupin({"build", "touch.json", "-o", "a.vtu"}).exit_code, 4);
  for (const Words& output :
       std::vector<Words>{{"-o", "a.vtu"}, {"-o", "a.stl", "--quality", "cfd"}}) {
    for (const std::string policy : {"separate", "bridge"}) {
      Words command{"build", "touch.json", "--contacts", policy + "=0.5mm"};
      command.insert(command.end(), output.begin(), output.end());
      const auto report = json(command, 0).at("output");
      EXPECT_EQ(report.at("settled").at("policy"), policy);
      EXPECT_EQ(report.at("settled").at("contacts").size(), 1U);
      EXPECT_EQ(report.at("check").at("components"), policy == "bridge" ? 1 : 2);
    }
  }
}

}  // namespace
}  // namespace dupin::test
