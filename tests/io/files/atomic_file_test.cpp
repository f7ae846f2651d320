#include "dupin/io/atomic_file.h"

#include <array>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <string>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "dupin/kernel/error.h"
#include "support/message_of.h"
#include "support/scratch_directory.h"

namespace dupin {
namespace {

namespace fs = std::filesystem;

using AtomicFile = test::ScratchDirectory;

std::string message_of(const auto& action) { return test::message_of(action, Errc::io_failed); }

std::ptrdiff_t entries(const fs::path& directory) {
  return std::distance(fs::directory_iterator(directory), fs::directory_iterator());
}

TEST_F(AtomicFile, holds_the_bytes_that_were_written) {
  const std::string bytes("a\0b\r\n\xff", 6);
  write_file(path("x"), bytes);
  EXPECT_EQ(read_file(path("x")), bytes);
  write_file(path("x"), "");
  EXPECT_EQ(read_file(path("x")), "");
  EXPECT_EQ(entries(directory()), 1);
}

TEST_F(AtomicFile, leaves_the_old_file_until_commit_and_cleans_up_without) {
  write_file(path("x"), "old");
  {
    const AsideFile aside(path("x"), "new");
    EXPECT_EQ(read_file(path("x")), "old");
    EXPECT_EQ(read_file(aside.path()), "new");
    EXPECT_EQ(aside.path().parent_path(), directory());
  }
  EXPECT_EQ(read_file(path("x")), "old");
  EXPECT_EQ(entries(directory()), 1);
  AsideFile aside(path("x"), "new");
  aside.commit();
  EXPECT_EQ(read_file(path("x")), "new");
  EXPECT_EQ(entries(directory()), 1);
}

TEST(StandardInput, is_read_to_its_end_and_left_open) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const int before = ::dup(STDIN_FILENO);
  ASSERT_EQ(::dup2(ends[0], STDIN_FILENO), STDIN_FILENO);
  const std::string bytes = "OFF\n0 0 0\n";
  ASSERT_EQ(::write(ends[1], bytes.data(), bytes.size()), ssize_t(bytes.size()));
  ::close(ends[1]);
  EXPECT_EQ(read_standard_input("input"), bytes);
  EXPECT_EQ(read_standard_input("input"), "");
  ::close(ends[0]);
  ::close(STDIN_FILENO);
  EXPECT_EQ(test::message_of([] { (void)read_standard_input("input"); }, Errc::io_failed),
            "input: cannot read the file: Bad file descriptor");
  if (before >= 0) {
    ::dup2(before, STDIN_FILENO);
    ::close(before);
  }
}

TEST_F(AtomicFile, is_read_back_from_disk) {
  const std::string bytes(1000001, 'a');  // longer than what is read at once
  const AsideFile aside(path("x"), bytes);
  EXPECT_TRUE(aside.holds(bytes));
  EXPECT_FALSE(aside.holds(bytes + 'a'));
  EXPECT_FALSE(aside.holds(bytes.substr(1)));
  EXPECT_FALSE(aside.holds(""));
  std::string other = bytes;
  other[700000] = 'b';
  EXPECT_FALSE(aside.holds(other));
  fs::resize_file(aside.path(), 0);
  EXPECT_TRUE(aside.holds(""));
  EXPECT_FALSE(aside.holds("a"));
  fs::remove(aside.path());
  EXPECT_NE(message_of([&] { (void)aside.holds(bytes); }).find("cannot read the file: No such"),
            std::string::npos);
}

TEST_F(AtomicFile, keeps_permissions_and_follows_links) {
  write_file(path("x"), "old");
  fs::permissions(path("x"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("x", path("link"));
  write_file(path("link"), "new");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(read_file(path("x")), "new");
  EXPECT_EQ(fs::status(path("x")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(AtomicFile, writes_to_where_a_link_points_though_nothing_is_there) {
  fs::create_directory(path("sub"));
  fs::create_symlink("sub/second", path("first"));
  fs::create_symlink("x", path("sub/second"));
  write_file(path("first"), "new");
  EXPECT_TRUE(fs::is_symlink(path("first")));
  EXPECT_TRUE(fs::is_symlink(path("sub/second")));
  EXPECT_EQ(read_file(path("sub/x")), "new");
  EXPECT_EQ(entries(path("sub")), 2);
  EXPECT_EQ(entries(directory()), 2);
  fs::create_symlink(path("no/where"), path("far"));
  EXPECT_EQ(
      message_of([&] { write_file(path("far"), ""); }),
      path("no/where").string() + ": cannot create a file beside it: No such file or directory");
  fs::create_symlink("round", path("round"));
  EXPECT_EQ(message_of([&] { write_file(path("round"), ""); }),
            path("round").string() + ": cannot write the file: Too many levels of symbolic links");
}

TEST_F(AtomicFile, may_have_the_longest_name_there_is) {
  const std::string longest(static_cast<std::size_t>(::pathconf(directory().c_str(), _PC_NAME_MAX)),
                            'x');
  write_file(path(longest), "1");
  write_file(path(longest), "2");
  EXPECT_EQ(read_file(path(longest)), "2");
  EXPECT_EQ(entries(directory()), 1);
  EXPECT_EQ(message_of([&] { write_file(path(longest + "x"), ""); }),
            path(longest + "x").string() + ": cannot write the file: File name too long");
  EXPECT_EQ(entries(directory()), 1);
}

TEST_F(AtomicFile, writes_into_what_has_no_name_any_more) {
  const int file = ::open(path("x").c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_GE(file, 0);
  fs::remove(path("x"));
  write_file("/proc/self/fd/" + std::to_string(file), "bytes");
  char bytes[8] = {};
  EXPECT_EQ(::pread(file, bytes, sizeof bytes, 0), 5);
  EXPECT_EQ(std::string(bytes), "bytes");
  EXPECT_EQ(entries(directory()), 0);
  ::close(file);
}

TEST_F(AtomicFile, is_abandoned_unless_one_has_taken_its_place) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // in a process that has written nothing yet
  const auto end = [&](bool is_right) {
    fs::remove_all(directory());
    ::_exit(is_right ? 7 : 8);
  };
  EXPECT_EXIT(
      {
        const AsideFile one(path("x"), "1");
        const AsideFile two(path("y"), "2");
        end(abandon_files() && entries(directory()) == 0);
      },
      testing::ExitedWithCode(7), "");
  EXPECT_EXIT(
      {
        AsideFile one(path("x"), "1");
        one.commit();
        end(!abandon_files() && read_file(path("x")) == "1");
      },
      testing::ExitedWithCode(7), "");
}

TEST_F(AtomicFile, writes_to_a_device_without_replacing_it) {
  write_file("/dev/null", "bytes");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFile, says_why_the_system_refused) {
  const std::string here = directory().string();
  EXPECT_EQ(message_of([&] { (void)read_file(path("none")); }),
            here + "/none: cannot read the file: No such file or directory");
  EXPECT_EQ(message_of([&] { (void)read_file(directory()); }),
            here + ": cannot read the file: Is a directory");
  EXPECT_EQ(message_of([&] { write_file(directory(), ""); }),
            here + ": cannot write the file: Is a directory");
  EXPECT_EQ(message_of([&] { write_file(path("no/x"), ""); }),
            here + "/no/x: cannot create a file beside it: No such file or directory");
  EXPECT_EQ(message_of([&] { write_file("/dev/full", "bytes"); }),
            "/dev/full: cannot write the file: No space left on device");
}

TEST_F(AtomicFile, names_end_at_no_nul) {
  const std::string cut = path("a").string(), whole = cut + '\0' + "b";
  write_file(cut, "old");
  const auto refusal = [](const auto& action) -> std::string {
    try {
      action();
    } catch (const Error& error) {
      return error.code() == Errc::invalid_argument ? error.message() : "another error";
    }
    return "no error";
  };
  const std::string fault = "the name of a file cannot have a NUL in it";
  EXPECT_EQ(refusal([&] { (void)read_file(whole); }), fault);
  EXPECT_EQ(refusal([&] { write_file(whole, "new"); }), fault);
  EXPECT_EQ(read_file(cut), "old");
}

TEST_F(AtomicFile, grows_and_changes_until_it_takes_its_place) {
  write_file(path("a"), "old");
  AsideFile file(path("a"));
  file.append("0123");
  file.append("4567");
  EXPECT_TRUE(file.holds("01234567"));
  file.replace(2, "xy");
  EXPECT_TRUE(file.holds_at(1, "1xy4"));
  EXPECT_TRUE(file.holds_at(6, "67"));
  EXPECT_FALSE(file.holds_at(6, "68"));
  EXPECT_FALSE(file.holds_at(6, "678")) << "it ends before";
  EXPECT_TRUE(file.holds_at(8, ""));
  EXPECT_EQ(read_file(path("a")), "old");
  file.commit();
  EXPECT_EQ(read_file(path("a")), "01xy4567");
}

// Which the system takes its time to free: it is closed meanwhile, but closed.
TEST_F(AtomicFile, takes_the_place_of_a_large_file_and_leaves_none_open) {
  const auto open_files = [] { return entries("/proc/self/fd"); };
  const std::ptrdiff_t before = open_files();
  for (const char letter : {'a', 'b', 'c'}) {
    const std::string piece(std::size_t{5} << 20, letter);
    AsideFile file(path("x"));
    file.append(piece);
    file.append(piece);
    file.commit();
    EXPECT_EQ(read_file(path("x")), piece + piece);
  }
  for (int i = 0; i < 1000 && open_files() > before; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(open_files(), before);
  EXPECT_EQ(entries(directory()), 1);
}

}  // namespace
}  // namespace dupin
