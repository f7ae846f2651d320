#include "dupin/io/scratch_file.h"

#include <cstdlib>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/scratch_directory.h"

namespace dupin::test {
namespace {

/// With TMPDIR in the test's own folder.
class ScratchFiles : public ScratchDirectory {
 public:
  ScratchFiles() {
    if (const char* before = std::getenv("TMPDIR")) {
      before_ = before;
    }
    ::setenv("TMPDIR", directory().c_str(), 1);
  }
  ~ScratchFiles() override {
    if (before_.empty()) {
      ::unsetenv("TMPDIR");
    } else {
      ::setenv("TMPDIR", before_.c_str(), 1);
    }
  }

 private:
  std::string before_;
};

TEST_F(ScratchFiles, give_back_what_they_were_given_and_have_no_name) {
  ScratchFile file;
  const std::string first(100'000, 'a'), second = "second";
  file.write(1'000'000, first);
  file.write(0, second);
  EXPECT_TRUE(std::filesystem::is_empty(directory()));
  std::vector<char> read(first.size());
  file.read(1'000'000, read);
  EXPECT_EQ(std::string(read.begin(), read.end()), first);
  read.resize(second.size());
  file.read(0, read);
  EXPECT_EQ(std::string(read.begin(), read.end()), second);
  EXPECT_THROW(file.read(1'099'999, read), Error) << "more than has been written";
}

// As scripts unset a variable.
TEST_F(ScratchFiles, are_in_the_usual_folder_where_the_variable_is_empty) {
  ::setenv("TMPDIR", "", 1);
  EXPECT_EQ(temporary_folder(), "/tmp");
  EXPECT_NO_THROW(ScratchFile());
}

TEST_F(ScratchFiles, say_which_folder_they_cannot_be_in) {
  ::setenv("TMPDIR", path("missing").c_str(), 1);
  try {
    const ScratchFile file;
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::io_failed);
    EXPECT_THAT(error.what(), testing::HasSubstr("TMPDIR"));
  }
}

}  // namespace
}  // namespace dupin::test
