#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "support/known_extensions.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

using Usage = Tool;

const std::vector<std::string>& commands() {
  static const std::vector<std::string> names{
      "build", "union",   "intersect", "subtract", "boolean", "check", "gaps",       "info",
      "edit",  "convert", "simplify",  "certify",  "verify",  "nurbs", "completion", "draw",
      "bom",   "repair",  "schema",    "manual",   "watch",   "report"};
  return names;
}

TEST_F(Usage, faults_are_one_line_on_standard_error) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  const std::vector<std::pair<std::vector<std::string>, std::string>> table{
      {{}, "A subcommand is required"},
      {{"unite", "a.off"}, "'unite' is no command"},
      {{"check"}, "FILE is required"},
      {{"check", "a.off", "--fast"}, "The following argument was not expected: --fast"},
      {{"check", "a.off", "--tolerance", "1"}, "check has no use for --tolerance"},
      {{"info", "a.off", "--tolerance", "1"}, "info has no use for --tolerance"},
      {{"gaps", "a.off", "--tolerance", "1"}, "gaps has no use for --tolerance"},
      {{"union", "a.off", "-o", "b.off"}, "IN: At least 2 required but received 1"},
      {{"union", "a.off", "a.off"}, "--output is required"},
      {{"union", "a.off", "a.off", "-o", "-"}, "standard output needs --format"},
      {{"union", "a.off", "a.off", "-o", "b.off", "--contacts", "hide"},
       "--contacts takes report, refuse, separate=LENGTH or bridge=LENGTH, not 'hide'"},
      {{"union", "a.off", "a.off", "-o", "b.off", "--contacts", "bridge"},
       "--contacts takes report, refuse, separate=LENGTH or bridge=LENGTH, not 'bridge'"},
      {{"union", "a.off", "a.off", "-o", "b.off", "--contacts", "bridge=far"},
       "'far' is not a length such as 0.05, 1mm or 0.5in"},
      {{"boolean", "a + (b", "a=a.off", "b=a.off", "-o", "b.off"},
       "in the expression \"a + (b\": ')' is expected, at column 7"},
      {{"boolean", "a + * b", "a=a.off", "b=a.off", "-o", "b.off"},
       "in the expression \"a + * b\": an operand is expected, not '*', at column 5"},
      {{"boolean", "a + b", "a=a.off", "-o", "b.off"},
       "the expression names 'b', but there is no b=FILE"},
      {{"boolean", "a", "a=a.off", "b=a.off", "-o", "b.off"},
       "the operand 'b' is not in the expression"},
      {{"boolean", "a", "a=a.off", "a=a.off", "-o", "b.off"}, "the operand 'a' is given twice"},
      {{"boolean", "a", "a.off", "-o", "b.off"}, "an operand must be NAME=FILE, not 'a.off'"},
      {{"convert", "a.off", "b"},
       "b: the extension '' names no mesh format; known are " + known_extensions() +
           "; or say --format"},
      {{"convert", "a.off", "b.stp"},
       "b.stp: the extension '.stp' names no mesh format; known are " + known_extensions() +
           "; or say --format"},
      {{"build", "a.json", "-o", "b.xyz"},
       "b.xyz: the extension '.xyz' names no mesh format; known are " + known_extensions() +
           ", and here .msh, .vtu, .step, .pvtu; or say --format"},
      {{"draw", "a.json", "-o", "b.jpg"},
       "b.jpg: the extension '.jpg' names nothing that is written here; known are .svg, .pdf, "
       ".png"},
      {{"nurbs", "a.json", "-o", "b.stl"},
       "b.stl: the extension '.stl' names nothing that is written here; known are .json, .step, "
       ".stp, .iges, .igs"},
      {{"convert", "a.off", "b.off", "--tolerance", "1"},
       "convert has no use for --tolerance; did you mean --rounding-tolerance?"},
      {{"union", "a.off", "a.off", "-o", "b.off", "--tolerance", "1"},
       "union has no use for --tolerance; did you mean --rounding-tolerance?"},
      {{"boolean", "a", "a=a.off", "-o", "b.off", "--tolerance", "1"},
       "boolean has no use for --tolerance; did you mean --rounding-tolerance?"},
      {{"convert", "a.off", "b.off", "--rounding-tolerance", "wide"},
       "'wide' is not a length such as 0.05, 1mm or 0.5in"},
      {{"convert", "a.off", "b.off", "--rounding-tolerance", "-1mm"},
       "a length must be positive, not '-1mm'"},
      {{"convert", "a.off", "b.off", "--rounding-tolerance", "1yd"},
       "the unit must be mm, cm, m, in or ft, not 'yd'"},
      {{"convert", "a.off", "b.off", "--origin", "1,2"},
       "the origin must be keep, auto or three coordinates such as 1000,2000,0, not '1,2'"},
      {{"convert", "a.off", "b.off", "--origin", "1,2,3x"},
       "the origin must be keep, auto or three coordinates such as 1000,2000,0, not '1,2,3x'"},
      {{"convert", "a.off", "b.off", "--grid", "0.001"},
       "the grid must be a power of two, such as 0.0009765625, not '0.001'"},
      {{"certify", "a.json"}, "--output is required"},
      {{"verify"}, "CERTIFICATE is required"},
      {{"verify", "a.off", "--tolerance", "1"}, "verify has no use for --tolerance"},
      {{"simplify", "a.off", "b.off"}, "simplify needs --tolerance"},
      {{"completion", "csh"}, "SHELL: csh not in {bash,zsh,fish}"},
  };
  for (const auto& [arguments, message] : table) {
    const ProcessResult result = dupin(arguments);
    EXPECT_EQ(result.exit_code, 2) << message;
    EXPECT_EQ(result.err, "dupin: " + message + " (see dupin --help)\n");
    EXPECT_EQ(result.out, "") << message;
  }
  EXPECT_THAT(folder_.files(), ElementsAre("a.off"));
}

// Who gives an option expects something of it.
TEST_F(Usage, options_that_would_do_nothing_are_refused) {
  const std::string tee = example("tee.json"), line = example("line.pcf");
  folder_.write("p.json", R"({"units": "mm", "tolerance": 1, "parts": [
      {"name": "p", "pipe": {"from": [0, 0, 0], "to": [9, 0, 0], "radius": 3}}]})");
  ASSERT_EQ(dupin({"certify", "p.json", "-o", "p.cert.json"}).exit_code, 0);
  const std::vector<std::pair<std::vector<std::string>, std::string>> table{
      {{"bom", tee, "--insulation", "3mm"}, "--insulation changes nothing that bom lists"},
      {{"build", tee, "-o", "b.stl", "--insulation", "3mm"}, "give --region insulation, too"},
      {{"build", tee, "-o", "b.stl", "--insulation", "3mm", "--region", "outer"},
       "give --region insulation, too"},
      {{"draw", tee, "-o", "b.svg", "--insulation", "3mm"}, "give --region insulation, too"},
      {{"report", tee, "-o", "b.html", "--insulation", "3mm"}, "give --region insulation, too"},
      {{"draw", tee, "-o", "b.svg", "--dpi", "30"}, "--dpi is for pictures"},
      {{"draw", tee, "-o", "b.pdf", "--dpi", "30"}, "--dpi is for pictures"},
      {{"verify", "p.cert.json", "--snap", "1mm"}, "say how FILE is read, and none is given"},
      {{"verify", "p.cert.json", "--radius", "1mm"}, "say how FILE is read, and none is given"},
      {{"edit", tee, "-o", "b.json"}, "edit needs either --move or --twist"},
      {{"edit", "none.json", "-o", "b.json"}, "edit needs either --move or --twist"},
      {{"edit", tee, "-o", "b.json", "--scale", "2", "--margin", "0.1"}, "or --margin; edit twice"},
      {{"edit", tee, "-o", "b.json", "--move", "1=0,0,0,1", "--margin", "5"},
       "--margin takes a number of at least 0"},
  };
  for (const auto& [arguments, message] : table) {
    const ProcessResult result = dupin(arguments);
    EXPECT_EQ(result.exit_code, 2) << message << result.err;
    EXPECT_THAT(result.err, testing::HasSubstr(message));
  }
  for (const std::string command : {"build", "draw", "bom", "report", "convert"}) {
    std::vector<std::string> arguments{command, command == "convert" ? line : "p.json",
                                       "--wall-side", "outwards"};
    if (command == "convert") {
      arguments.push_back("b.json");
    } else if (command != "bom") {
      arguments.insert(arguments.end(), {"-o", command == "draw"     ? "b.svg"
                                               : command == "report" ? "b.html"
                                                                     : "b.stl"});
    }
    const ProcessResult result = dupin(arguments);
    EXPECT_EQ(result.exit_code, 2) << command << result.err;
    EXPECT_THAT(result.err, testing::HasSubstr("--wall-side says where walls are, and nothing in"));
    arguments.insert(arguments.end(), {"--wall", "1mm"});
    EXPECT_NE(dupin(arguments).exit_code, 2) << command;
  }
}

TEST_F(Usage, faults_are_json_when_asked) {
  const ProcessResult result = dupin({"check", "--json"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  const auto error = nlohmann::json::parse(result.err).at("error");
  EXPECT_EQ(error.at("code"), "usage");
  EXPECT_EQ(error.at("exit"), 2);
  EXPECT_EQ(error.at("message"), "FILE is required (see dupin --help)");
}

TEST_F(Usage, help_of_the_tool_lists_every_command) {
  const ProcessResult result = dupin({"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, HasSubstr("Examples:\n"));
  for (const std::string& command : commands()) {
    EXPECT_THAT(result.out, HasSubstr("\n  " + command + " "));
  }
}

TEST_F(Usage, help_of_every_command_has_an_example_of_it) {
  for (const std::string& command : commands()) {
    const ProcessResult result = dupin({command, "--help"});
    EXPECT_EQ(result.exit_code, 0) << command;
    const std::size_t examples = result.out.find("Examples:\n");
    ASSERT_NE(examples, std::string::npos) << command;
    EXPECT_THAT(result.out.substr(examples), HasSubstr("dupin " + command));
  }
}

TEST_F(Usage, lines_of_help_fit_a_terminal) {
  for (const std::string& command : commands()) {
    const std::string help = dupin({command, "--help"}).out;
    for (std::size_t begin = 0; begin < help.size();) {
      const std::size_t end = std::min(help.find('\n', begin), help.size());
      EXPECT_LE(end - begin, 110) << help.substr(begin, end - begin);
      begin = end + 1;
    }
  }
}

TEST_F(Usage, version_is_one_line) {
  const ProcessResult result = dupin({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, StartsWith("dupin 0."));
}

TEST_F(Usage, memory_is_of_huge_pages) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitiser has an allocator of its own";
#endif
  const ProcessResult result = shell("MALLOC_CONF=stats_print:true dupin --version");
  EXPECT_THAT(result.err, HasSubstr("opt.thp: \"always\""));
}

TEST_F(Usage, common_options_stand_before_or_after_the_command) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  const std::string before = dupin({"--json", "check", "a.off"}).out;
  EXPECT_THAT(before, StartsWith("{\n"));
  EXPECT_EQ(dupin({"check", "a.off", "--json"}).out, before);
  EXPECT_EQ(dupin({"-q", "check", "a.off"}).out, "");
  EXPECT_EQ(dupin({"check", "a.off", "--quiet"}).out, "");
}

}  // namespace
}  // namespace dupin::test
