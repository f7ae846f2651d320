#include "input.h"

#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "dupin/io/off.h"
#include "dupin/kernel/error.h"
#include "exit_code.h"
#include "support/process.h"
#include "support/shapes.h"

namespace dupin::cli {
namespace {

Input off(const std::string& name, const TriMesh& mesh, const std::string& unit = {}) {
  return {off_text(mesh, {unit, {}}), name};
}

TEST(Input, is_a_document_if_it_begins_with_a_brace) {
  EXPECT_TRUE((Input{" \r\n\t{}", "a"}).is_document());
  EXPECT_TRUE((Input{"\xEF\xBB\xBF\n{}", "a"}).is_document());
  EXPECT_FALSE((Input{"\xEF\xBB\xBF", "a"}).is_document());
  EXPECT_FALSE((Input{"OFF {", "a"}).is_document());
  EXPECT_FALSE((Input{" ", "a"}).is_document());
}

TEST(Input, named_json_is_a_document_unless_it_is_a_mesh) {
  for (const std::string bytes : {"", " \n", "\xEF\xBB\xBF", "[]", "\"a\"", "units"}) {
    EXPECT_TRUE((Input{bytes, "in/a.json"}).is_document()) << bytes;
    EXPECT_FALSE((Input{bytes, "in/a.off"}).is_document()) << bytes;
  }
  EXPECT_FALSE(off("a.json", test::box({0, 0, 0}, {1, 1, 1})).is_document());
}

TEST(Input, of_pipes_can_be_read_only_once) {
  const test::TemporaryFolder folder;
  const std::string pipe = folder.path() / "pipe", file = folder.path() / "file";
  folder.write("file", "OFF");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path :
       {file, (folder.path() / "none").string(), folder.path().string()}) {
    EXPECT_TRUE(can_be_read_again(path)) << path;
    EXPECT_NO_THROW(require_read_again(path, "it is read twice"));
  }
  EXPECT_FALSE(can_be_read_again("-"));
  EXPECT_THROW(require_read_again("-", "it is read twice"), UsageError);
  EXPECT_FALSE(can_be_read_again(pipe));
  try {
    require_read_again(pipe, "it is read twice");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.what(), pipe + ": has to be a regular file: it is read twice");
  }
}

TEST(Input, units_that_are_stated_must_agree) {
  const TriMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(off("a", mesh, "in").unit(), "in");
  EXPECT_EQ(common_unit({off("a", mesh), off("b", mesh)}), "");
  EXPECT_EQ(common_unit({off("a", mesh), off("b", mesh, "in"), off("c", mesh, "in")}), "in");
  try {
    (void)common_unit({off("a", mesh, "mm"), off("b", mesh), off("c", mesh, "in")});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "c: is in in, but a in mm; convert one of them first, with --to-unit");
  }
}

TEST(Input, faults_of_a_solid_name_the_file) {
  TriMesh open = test::box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  for (const bool is_repaired : {false, true}) {
    try {
      is_repaired ? (void)repaired_solid_of(off("a.off", open))
                  : (void)solid_of(off("a.off", open));
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.part(), "a.off");
    }
  }
  const Input good = off("b.off", test::box({0, 0, 0}, {1, 1, 1}));
  EXPECT_TRUE(solid_of(good).contacts().empty());
  EXPECT_EQ(repaired_solid_of(good).report, RepairReport());
}

}  // namespace
}  // namespace dupin::cli
