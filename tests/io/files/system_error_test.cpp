#include "dupin/io/system_error.h"

#include <cerrno>

#include <gtest/gtest.h>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "support/scratch_directory.h"

namespace dupin {
namespace {

using SystemErrors = test::ScratchDirectory;

TEST(SystemError, has_the_reason_in_its_sentence_and_as_a_number) {
  const SystemError error("cannot read the file", ENOENT, "a.off");
  EXPECT_STREQ(error.what(), "a.off: cannot read the file: No such file or directory");
  EXPECT_EQ(error.code(), Errc::io_failed);
  EXPECT_EQ(error.reason(), ENOENT);
  EXPECT_EQ(error.reason_text(), "No such file or directory");
  EXPECT_STREQ(SystemError("cannot make", EACCES, "b", "; try c").what(),
               "b: cannot make: Permission denied; try c");
}

// Whoever reads and writes throws it.
TEST_F(SystemErrors, tell_why_files_are_not_read_or_written) {
  const auto reason_of = [](const auto& action) {
    try {
      action();
    } catch (const SystemError& error) {
      return error.reason();
    }
    return 0;
  };
  EXPECT_EQ(reason_of([&] { (void)read_file(path("none.off")); }), ENOENT);
  EXPECT_EQ(reason_of([&] { (void)read_mesh(path("none.off")); }), ENOENT);
  EXPECT_EQ(reason_of([&] { (void)read_file(path("")); }), EISDIR);
  EXPECT_EQ(reason_of([&] { write_file(path("none/a.off"), "text"); }), ENOENT);
}

}  // namespace
}  // namespace dupin
