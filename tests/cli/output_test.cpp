#include "output.h"

#include <cstdint>
#include <filesystem>
#include <random>
#include <regex>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "contact_options.h"
#include "dupin/io/mesh_file.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/rounding.h"
#include "support/pipe_unions.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

using Output = Tool;

TEST_F(Output, dash_writes_the_mesh_and_nothing_else_to_standard_output) {
  put("a.off", box({0, 0, 0}, {2, 2, 2}));
  put("b.off", box({1, 1, 1}, {3, 3, 3}));
  for (const std::string format : {"off", "stl", "stl-ascii"}) {
    const ProcessResult result = dupin({"union", "a.off", "b.off", "-o", "-", "--format", format});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(check(read_mesh(result.out, "out")).volume, 15) << format;
    EXPECT_THAT(result.err, HasSubstr("volume               15\n"));
    EXPECT_EQ(dupin({"union", "a.off", "b.off", "-o", "-", "--format", format, "-q"}).err, "");
  }
  EXPECT_THAT(folder_.files(), ElementsAre("a.off", "b.off"));
}

TEST_F(Output, a_chain_of_pipes_needs_no_files) {
  put("a.off", box({0, 0, 0}, {2, 2, 2}));
  put("b.off", box({1, 1, 1}, {3, 3, 3}));
  const ProcessResult result = shell(
      "set -o pipefail; dupin -q union a.off b.off -o - --format off"
      " | dupin -q subtract - b.off -o - --format stl | dupin check - --json");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(nlohmann::json::parse(result.out).at("volume"), 7);
}

// Of solids that are apart, each rounds for itself, but what is said of one has to do for all.
TEST_F(Output, names_a_tolerance_with_which_all_is_written) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> angle(0, 3);
  int named = 0;
  for (int round = 0; round < 12; ++round) {
    std::vector<std::string> command{"union"};
    for (int i = 0; i < 4; ++i) {
      TriMesh tube = test::tube(0.05, 0, 4, 96);
      const Eigen::Matrix3d turn = (Eigen::AngleAxisd(angle(random), Vec3::UnitX()) *
                                    Eigen::AngleAxisd(angle(random), Vec3::UnitY()))
                                       .toRotationMatrix();
      for (Vec3& point : tube.points) {
        point = turn * point + Vec3(1e6 + 40 * i, -3e5, 2e5);
      }
      command.push_back("tube" + std::to_string(i) + ".off");
      put(command.back(), tube);
    }
    const auto with = [&](const std::string& tolerance) {
      std::vector<std::string> all = command;
      all.insert(all.end(), {"-o", "x.stl", "-q", "--rounding-tolerance", tolerance});
      return dupin(all);
    };
    const ProcessResult refused = with("0.015625");
    std::smatch found;
    if (std::regex_search(refused.err, found, std::regex(R"(\(([0-9.]+) would do\))"))) {
      EXPECT_EQ(with(found[1]).exit_code, 0) << round << ": " << found[1];
      ++named;
    }
  }
  EXPECT_GT(named, 6);
}

TEST_F(Output, has_no_contacts_where_they_are_refused_whichever_the_command) {
  const TriMesh left = box({0, 0, 0}, {1, 1, 1}), right = box({1, 1, 0}, {2, 2, 1});
  put("left.off", left);
  put("right.off", right);
  put("touching.off", joined({left, right}));
  const auto before = folder_.files();
  const std::vector<std::vector<std::string>> commands = {
      {"repair", "touching.off"},
      {"union", "touching.off", "touching.off"},
      {"union", "left.off", "right.off"},
      {"intersect", "touching.off", "touching.off"},
      {"boolean", "a + b", "a=left.off", "b=right.off"},
  };
  for (const std::string format : {"off", "obj", "ply", "glb", "3mf", "stl"}) {
    for (std::vector<std::string> line : commands) {
      SCOPED_TRACE(line[0] + " " + format);
      line.insert(line.end(), {"-o", "out." + format, "--contacts", "refuse"});
      EXPECT_EQ(dupin(line).exit_code, 4);
    }
  }
  EXPECT_EQ(dupin({"union", "left.off", "right.off", "-o", "out.ply", "--contacts", "refuse",
                   "--tiles", "2"})
                .exit_code,
            4);
  EXPECT_EQ(folder_.files(), before);
  EXPECT_EQ(dupin({"repair", "touching.off", "-o", "out.off", "--contacts", "refuse"}).err,
            "dupin: out.off: the solid touches itself in 1 place, at (1, 1, 0), which --contacts "
            "refuse forbids; --contacts report writes it as it is, separate=LENGTH or "
            "bridge=LENGTH without\n");
}

// An edge, and the point at its end, in which a third cube touches.
TEST_F(Output, tells_each_place_of_contacts_once) {
  put("three.off",
      joined({box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1}), box({0, 1, 1}, {1, 2, 2})}));
  for (const std::string policy : {"refuse", "report"}) {
    const std::string err =
        dupin({"repair", "three.off", "-o", "out.stl", "--contacts", policy}).err;
    const std::size_t first = err.find("(1, 1, 1)");
    EXPECT_NE(first, std::string::npos) << err;
    EXPECT_EQ(err.find("(1, 1, 1)", first + 1), std::string::npos) << err;
  }
}

// Pipes that rest on others, as exact as they are, touch each other once they are rounded.
TEST_F(Output, has_no_contacts_by_rounding_where_they_are_refused) {
  cli::OutputArguments arguments;
  arguments.path = "out.glb";
  const cli::Destination to = cli::destination(arguments);
  std::size_t touching = 0;
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const Solid solid = unite(resting_pipes(8, seed));
    ASSERT_TRUE(solid.contacts().empty());
    OutputReport report;
    std::string message;
    try {
      (void)cli::settled_and_rounded(solid, to, {}, cli::contact_choice("refuse", "mm"), report);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::contact);
      message = error.message();
    }
    const bool touches = !to_mesh(solid, Coordinates::binary32).contacts().empty();
    EXPECT_EQ(
        message.find("which --contacts refuse forbids, once its points are rounded to the "
                     "numbers of binary glTF; a format of finer numbers") != std::string::npos,
        touches)
        << message;
    touching += touches ? 1 : 0;
  }
  EXPECT_GT(touching, 0U);
}

TEST_F(Output, is_not_read_back_with_no_verify) {
  put("a.off", box({0, 0, 0}, {2, 2, 2}));
  put("b.off", box({1, 1, 1}, {3, 3, 3}));
  const std::vector<std::string> unite = {"union", "a.off", "b.off", "-o", "ab.stl"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), unite.begin(), unite.end());
    const ProcessResult result = dupin(more);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  };
  EXPECT_THAT(with({}), HasSubstr("verified             read back, as it was proved\n"));
  const std::string verified = folder_.read("ab.stl");
  const std::string report = with({"--no-verify"});
  EXPECT_THAT(report, HasSubstr("verified             no\n"));
  EXPECT_THAT(report, Not(HasSubstr("volume")));
  EXPECT_EQ(folder_.read("ab.stl"), verified);
  const auto json = nlohmann::json::parse(with({"--no-verify", "--json"}));
  EXPECT_EQ(json.at("verified"), false);
  EXPECT_EQ(json.at("verification"), "none");
  EXPECT_FALSE(json.contains("check"));
  EXPECT_EQ(dupin({"convert", "a.off", "a.stl", "--no-verify", "-q"}).exit_code, 0);
  EXPECT_EQ(check(read_mesh(folder_.read("a.stl"), "a.stl")).volume, 8);
}

TEST_F(Output, is_compared_with_what_was_proved_or_checked_anew) {
  put("a.off", box({0, 0, 0}, {2, 2, 2}));
  put("b.off", box({1, 1, 1}, {3, 3, 3}));
  put("c.off", box({5, 0, 0}, {8, 3, 3}));
  put("d.off", box({6, 1, 1}, {7, 2, 2}));
  ASSERT_EQ(dupin({"subtract", "c.off", "d.off", "-o", "hollow.off"}).exit_code, 0);
  for (const MeshFormat& format : mesh_formats()) {
    for (const std::string to : {"out", "-"}) {
      const auto run = [&](const std::string& how) {
        const ProcessResult result =
            dupin({"union", "a.off", "b.off", "hollow.off", "-o", to, "--format",
                   std::string(format.key), "--verify", how, "--json"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        auto json = nlohmann::json::parse(to == "-" ? result.err : result.out);
        EXPECT_EQ(json.at("verification"), how);
        EXPECT_EQ(json.at("verified"), true);
        return std::pair(json.at("check"), to == "-" ? result.out : folder_.read(to));
      };
      const auto compared = run("compare"), full = run("full");
      EXPECT_EQ(compared, full) << format.name << " to " << to;
      EXPECT_EQ(compared.first.at("volume"), 15 + 26);
      EXPECT_EQ(compared.first.at("shells").size(), 3);
    }
  }
}

TEST_F(Output, no_verification_is_no_choice_beside_one) {
  put("a.off", box({0, 0, 0}, {2, 2, 2}));
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"--verify", "twice"}, {"--verify", "full", "--no-verify"}}) {
    std::vector<std::string> command = {"convert", "a.off", "b.off"};
    command.insert(command.end(), wrong.begin(), wrong.end());
    EXPECT_EQ(dupin(command).exit_code, 2);
  }
  EXPECT_THAT(folder_.files(), ElementsAre("a.off"));
}

TEST_F(Output, a_file_that_was_there_survives_a_failure) {
  folder_.write("out.stl", "precious");
  EXPECT_EQ(dupin({"build", example("tight.json"), "-o", "out.stl"}).exit_code, 4);
  EXPECT_EQ(folder_.read("out.stl"), "precious");
  EXPECT_THAT(folder_.files(), ElementsAre("out.stl"));
}

TEST_F(Output, no_file_is_left_behind_when_the_disk_is_full) {
  put("a.off", tube(1, 0, 1, 500));
  // A limit on the size of files stands in for the full disk; its signal is ignored, the write
  // fails.
  const ProcessResult result = shell(
      "trap '' XFSZ; ulimit -f 8; dupin convert a.off b.stl; code=$?; rm examples; exit $code");
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_THAT(result.err, HasSubstr("File too large"));
  EXPECT_THAT(folder_.files(), ElementsAre("a.off"));
}

TEST_F(Output, too_large_a_file_is_an_error_of_writing) {
  put("a.off", tube(1, 0, 1, 500));
  const ProcessResult result =
      shell("ulimit -f 8; dupin convert a.off b.stl; echo $?; rm examples");
  EXPECT_EQ(result.out, "5\n");
  EXPECT_EQ(result.err, "dupin: b.stl: cannot write the file: File too large\n");
  EXPECT_THAT(folder_.files(), ElementsAre("a.off"));
}

TEST_F(Output, standard_output_has_other_names) {
  put("a.off", box({0, 0, 0}, {2, 2, 2}));
  for (const std::string name : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
    const ProcessResult result = dupin({"convert", "a.off", name, "--format", "off"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(check(read_mesh(result.out, "out")).volume, 8) << name;
    EXPECT_THAT(result.err, HasSubstr("written              standard output, OFF\n"));
  }
}

TEST_F(Output, a_place_that_cannot_be_written_is_told) {
  put("a.off", box({0, 0, 0}, {2, 2, 2}));
  const std::string longest(251, 'x');
  const std::vector<std::pair<std::string, std::string>> table = {
      {"mkdir out", "out: cannot write the file: Is a directory"},
      {"ln -s out out", "out: cannot write the file: Too many levels of symbolic links"},
      {"ln -s no/where out", "no/where: cannot create a file beside it: No such file or directory"},
      {"ln -s /dev/full out", "out: cannot write the file: No space left on device"},
      {"ln -s a.off/x out", "out: cannot write the file: Not a directory"}};
  for (const auto& [made, message] : table) {
    const ProcessResult result =
        shell(made + "; dupin convert a.off out --format off; echo $?; rm -rf out");
    EXPECT_EQ(result.out, "5\n") << made;
    EXPECT_EQ(result.err, "dupin: " + message + "\n") << made;
  }
  EXPECT_EQ(dupin({"convert", "a.off", longest + ".off", "-q"}).exit_code, 0);
  EXPECT_EQ(dupin({"convert", "a.off", longest + "x.off", "-q"}).exit_code, 5);
  EXPECT_EQ(
      shell("ln -s there.off link.off; dupin convert a.off link.off -q; readlink link.off").out,
      "there.off\n");
  EXPECT_EQ(check(read_mesh(folder_.read("there.off"), "x")).volume, 8);
}

// Nothing is said to be written before it is.
TEST_F(Output, a_full_standard_output_is_told_and_no_success_before) {
  put("a.off", box({0, 0, 0}, {2, 2, 2}));
  for (const std::string command :
       {"convert a.off - --format off", "convert a.off - --format stl --no-verify", "info a.off",
        "--version", "build --help", "build examples/reducer.json -o - --format stl"}) {
    const ProcessResult result = shell("dupin " + command + " >/dev/full; echo $? >&2");
    EXPECT_EQ(result.err, "dupin: standard output: cannot be written: No space left on device\n5\n")
        << command;
  }
}

TEST_F(Output, what_goes_beside_and_fails_leaves_the_mesh_and_says_so) {
  for (const std::string option : {"--report", "--patches"}) {
    const ProcessResult result =
        shell("dupin build examples/reducer.json -o a.stl " + option + " /dev/full; echo $?");
    EXPECT_EQ(result.out, "5\n") << option;
    EXPECT_THAT(result.err, HasSubstr("No space left on device; a.stl is written\n")) << option;
    EXPECT_TRUE(check(read_mesh(folder_.read("a.stl"), "a.stl")).is_solid());
  }
}

TEST_F(Output, standard_error_is_silent_where_it_is_no_terminal) {
  EXPECT_EQ(dupin({"build", example("reducer.json"), "-o", "a.stl"}).err, "");
}

TEST_F(Output, a_terminal_sees_progress_and_then_the_report_alone) {
  const ProcessResult result =
      run_process({"script", "-qec",
                   tool_path() + " build " + example("reducer.json") + " -o a.stl", "/dev/null"},
                  folder_.path());
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, testing::ContainsRegex("[a-z]+ [0-9]+ %"));
  EXPECT_THAT(result.out, HasSubstr("\r\033[Kparts  "));
}

TEST_F(Output, the_same_input_gives_the_same_bytes) {
  EXPECT_EQ(dupin({"build", example("reducer.json"), "-o", "a.stl", "-q"}).exit_code, 0);
  EXPECT_EQ(dupin({"build", example("reducer.json"), "-o", "b.stl", "-q"}).exit_code, 0);
  EXPECT_EQ(folder_.read("a.stl"), folder_.read("b.stl"));
}

TEST_F(Output, lists_patches_beside_the_mesh) {
  write_mesh(folder_.path() / "a.ply", labelled(box({0, 0, 0}, {2, 2, 2}), "a"));
  write_mesh(folder_.path() / "b.ply", labelled(box({1, 1, 1}, {3, 3, 3}), "b"));
  const ProcessResult result =
      dupin({"union", "a.ply", "b.ply", "-o", "ab.off", "--patches", "ab.json", "-q"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto listed = nlohmann::json::parse(folder_.read("ab.json"));
  EXPECT_EQ(listed.at("file"), "ab.off");
  EXPECT_EQ(listed.at("area"), check(read_mesh(folder_.read("ab.off"), "ab.off")).area);
  ASSERT_EQ(listed.at("patches").size(), 2);
  EXPECT_EQ(listed.at("patches").at(0).at("area"), 21);
  EXPECT_EQ(listed.at("components").size(), 1);
}

TEST_F(Output, lists_patches_of_solids_in_files_of_their_own_alone) {
  put("a.off", box({0, 0, 0}, {2, 2, 2}));
  TriMesh open = box({0, 0, 0}, {2, 2, 2});
  open.triangles.pop_back();
  put("open.off", open);
  const auto result = [&](const std::string& in, const std::string& patches) {
    return dupin({"convert", in, "out.ply", "--patches", patches});
  };
  EXPECT_EQ(result("a.off", "a.json").exit_code, 0);
  EXPECT_EQ(result("a.off", "-").exit_code, 2);
  EXPECT_EQ(result("a.off", "out.ply").exit_code, 2);
  std::filesystem::remove(folder_.path() / "out.ply");
  EXPECT_EQ(result("a.off", "none/a.json").exit_code, 5);
  EXPECT_EQ(dupin({"convert", "a.off", "none/out.ply", "--patches", "b.json"}).exit_code, 5);
  const ProcessResult refused = result("open.off", "open.json");
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, HasSubstr("--patches lists those of solids"));
  EXPECT_THAT(folder_.files(), ElementsAre("a.json", "a.off", "open.off"));
}

// Of these meshes, no smooth surface is known.
TEST_F(Output, has_no_normals_of_meshes) {
  put("a.off", box({0, 0, 0}, {2, 2, 2}));
  put("b.off", box({1, 1, 1}, {3, 3, 3}));
  for (const std::string format : {"obj", "ply", "glb"}) {
    ASSERT_EQ(dupin({"union", "a.off", "b.off", "-o", "ab", "--format", format}).exit_code, 0);
    const std::string bytes = folder_.read("ab");
    for (const char* const sign : {"vn ", "property float nx", "NORMAL", "copies"}) {
      EXPECT_THAT(bytes, Not(HasSubstr(sign))) << format;
    }
  }
}

}  // namespace
}  // namespace dupin::test
