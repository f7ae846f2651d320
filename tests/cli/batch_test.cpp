#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"

namespace dupin::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class Batch : public Tool {
 protected:
  static std::string sphere(const std::string& radius) {
    return R"({"units": "mm", "tolerance": 0.1, "parts": [{"name": "a", "sphere": {"center": [0, 0, 0], "radius": )" +
           radius + "}}]}";
  }
  Batch() {
    folder_.write("a.json", sphere("1"));
    folder_.write("b.json", sphere("-1"));
    folder_.write("c.json", sphere("2"));
    folder_.write("gap.json",
                  R"({"units": "mm", "tolerance": 0.1, "parts": [
      {"name": "a", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "radius": 1}},
      {"name": "b", "pipe": {"from": [1.1, 0, 0], "to": [2, 0, 0], "radius": 1}}]})");
  }
  [[nodiscard]] std::vector<std::string> meshes() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "out")) {
      names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
  }
};

TEST_F(Batch, builds_what_it_can_and_lists_failures_at_the_end) {
  const ProcessResult result =
      dupin({"build", "a.json", "b.json", "c.json", "none.json", "--out-dir", "out", "-j", "3"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out.substr(0, result.out.find("dupin:")),
            "built     a.json -> out/a.stl\n"
            "failed    b.json\n"
            "built     c.json -> out/c.stl\n"
            "failed    none.json\n"
            "4 documents: 2 built, 0 with findings, 2 failed\n");
  EXPECT_THAT(result.out, AllOf(HasSubstr("dupin: b.json#/parts/0/sphere/radius"),
                                HasSubstr("dupin: none.json: cannot read the file")));
  EXPECT_THAT(meshes(), ElementsAre("a.stl", "c.stl"));
}

TEST_F(Batch, says_the_same_whatever_the_number_of_jobs) {
  std::string said;
  for (const char* const jobs : {"1", "2", "8"}) {
    const ProcessResult result = dupin({"build", "c.json", "gap.json", "a.json", "--out-dir", "out",
                                        "--connect", "0.5", "-j", jobs});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.out, HasSubstr("findings  gap.json -> out/gap.stl"));
    EXPECT_EQ(said.empty() ? result.out : said, result.out);
    said = result.out;
  }
}

TEST_F(Batch, writes_what_single_builds_write) {
  ASSERT_EQ(dupin({"build", "c.json", "a.json", "--out-dir", "out", "--format", "off",
                   "--tolerance", "0.01", "-q"})
                .exit_code,
            0);
  ASSERT_EQ(dupin({"build", "a.json", "-o", "a.off", "--tolerance", "0.01"}).exit_code, 0);
  EXPECT_EQ(folder_.read("out/a.off"), folder_.read("a.off"));
}

TEST_F(Batch, reports_all_documents_as_one_object) {
  const nlohmann::json report =
      json({"build", "a.json", "b.json", "gap.json", "--out-dir", "out", "--connect", "0.5"}, 1);
  ASSERT_EQ(report.at("documents").size(), 3);
  EXPECT_EQ(report.at("documents")[0].at("report").at("output").at("file"), "out/a.stl");
  EXPECT_EQ(report.at("documents")[1].at("failure").at("error").at("code"), "invalid_argument");
  EXPECT_EQ(report.at("documents")[1].at("output"), nullptr);
  EXPECT_EQ(report.at("documents")[2].at("exit"), 1);
  EXPECT_EQ(report.at("built"), 1);
  EXPECT_EQ(report.at("findings"), 1);
  EXPECT_EQ(report.at("failed"), 1);
}

TEST_F(Batch, what_makes_no_sense_is_refused_before_anything_is_built) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> table{
      {{"a.json", "c.json"}, "several documents need --out-dir"},
      {{"a.json"}, "--output is required"},
      {{"a.json", "--out-dir", "out", "-o", "a.stl"}, "--output and --out-dir"},
      {{"a.json", "sub/a.json", "--out-dir", "out"}, "'a.json' and 'sub/a.json' would both become"},
      {{"-", "--out-dir", "out"}, "standard input has no name"},
      {{"a.json", "--out-dir", "out", "--patches", "p.json"}, "--patches names one file"},
      {{"a.json", "--out-dir", "out", "-j", "0"}, "--jobs"},
  };
  for (const auto& [arguments, said] : table) {
    std::vector<std::string> all{"build"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const ProcessResult result = dupin(all);
    EXPECT_EQ(result.exit_code, 2) << said;
    EXPECT_THAT(result.err, HasSubstr(said));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out"));
  EXPECT_EQ(dupin({"build", "a.json", "--out-dir", "a.json/out"}).exit_code, 5);
  folder_.write("a.json", R"({"units": "mm", "tolerance": 0.1, "parts": []})");
  EXPECT_EQ(
      dupin({"build", "a.json", "--out-dir", "out", "--format", "obj", "--tiles", "2"}).exit_code,
      2)
      << "as each document says";
}

// Were one to end before it is the tool, it would speak for its parent, and end its siblings.
TEST_F(Batch, without_room_for_processes_says_so_and_nothing_else) {
  const ProcessResult result = shell(
      "for i in {1..20}; do cp a.json a$i.json; done; ulimit -n 20; export TMPDIR=$PWD; "
      "dupin build a*.json --out-dir out -j 20 -q; echo $?");
  EXPECT_EQ(result.out, "5\n");
  EXPECT_EQ(result.err, "dupin: " + folder_.path().string() +
                            ": cannot make a temporary file: Too many open files\n");
}

TEST_F(Batch, a_document_is_not_replaced_by_its_own_mesh) {
  folder_.write("a.stl", sphere("1"));
  const std::string before = folder_.read("a.stl");
  for (const std::vector<std::string>& files :
       {std::vector<std::string>{"a.stl"}, {"c.json", "a.stl"}}) {
    std::vector<std::string> all{"build", "--out-dir", "."};
    all.insert(all.end(), files.begin(), files.end());
    const ProcessResult result = dupin(all);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, HasSubstr("'./a.stl' of 'a.stl' would take the place of 'a.stl'"));
    EXPECT_EQ(folder_.read("a.stl"), before);
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "c.stl"));
  }
}

TEST_F(Batch, counts_one_document_as_one) {
  EXPECT_THAT(dupin({"build", "a.json", "--out-dir", "out"}).out,
              HasSubstr("\n1 document: 1 built, 0 with findings, 0 failed\n"));
}

// Processes of their own do not see each other's files.
TEST_F(Batch, no_document_takes_the_place_of_another_one_by_a_link) {
  const std::filesystem::path out = folder_.path() / "out";
  std::filesystem::create_directory(out);
  std::filesystem::create_symlink("../c.json", out / "a.stl");
  const std::string document = folder_.read("c.json");
  const std::vector<std::string> taken{"build", "a.json", "c.json", "--out-dir", "out"};
  const ProcessResult refused = dupin(taken);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("'out/a.stl' of 'a.json' would take the place of 'c.json'"));
  EXPECT_EQ(folder_.read("c.json"), document);
  EXPECT_FALSE(std::filesystem::exists(out / "c.stl"));

  std::filesystem::remove(out / "a.stl");
  std::filesystem::create_symlink("both.stl", out / "a.stl");
  std::filesystem::create_symlink("both.stl", out / "c.stl");
  const ProcessResult shared = dupin(taken);
  EXPECT_EQ(shared.exit_code, 2);
  EXPECT_THAT(shared.err, HasSubstr("'a.json' and 'c.json' would both become"));
  EXPECT_FALSE(std::filesystem::exists(out / "both.stl"));
}

TEST_F(Batch, makes_the_folder_that_a_link_leads_to) {
  std::filesystem::create_symlink("elsewhere", folder_.path() / "out");
  EXPECT_EQ(dupin({"build", "a.json", "--out-dir", "out", "-q"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "elsewhere/a.stl"));
}

TEST_F(Batch, reports_names_of_any_bytes) {
  folder_.write("a\xFF\"\n.json", sphere("1"));
  const nlohmann::json report = json({"build", "a\xFF\"\n.json", "--out-dir", "out"}, 0);
  EXPECT_EQ(report.at("documents")[0].at("file"), "a\uFFFD\"\n.json");
}

}  // namespace
}  // namespace dupin::test
