#include <chrono>
#include <cstddef>
#include <filesystem>
#include <random>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "dupin/io/atomic_file.h"
#include "support/scratch_directory.h"

namespace dupin {
namespace {

using KilledWriter = test::ScratchDirectory;

/// Replaces the file by one content after the other until killed.
[[noreturn]] void write_for_ever(const std::filesystem::path& file, const std::string& one,
                                 const std::string& other) {
  for (;;) {
    write_file(file, one);
    write_file(file, other);
  }
}

TEST_F(KilledWriter, leaves_the_old_file_or_the_whole_new_one) {
  const std::string one(std::size_t{3} << 20, '1');
  const std::string other(std::size_t{2} << 20, '2');
  write_file(path("x"), one);
  std::mt19937_64 random(50);
  std::size_t ones = 0;
  std::size_t left_aside = 0;
  constexpr std::size_t kMoments = 50, kMostMoments = 1000;
  std::size_t moment = 0;
  // The moments hit what they aim at: both contents are seen, and files that are being written. A
  // machine that has much else to do needs more of them, and longer ones.
  const auto has_hit = [&] { return ones > 0 && ones < moment && left_aside > 10; };
  for (; moment < kMoments || (moment < kMostMoments && !has_hit()); ++moment) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      write_for_ever(path("x"), one, other);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(random() % (600 * (kMoments + moment))));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    const std::string found = read_file(path("x"));
    ASSERT_TRUE(found == one || found == other) << found.size() << " bytes after " << moment;
    ones += found == one ? 1 : 0;
    for (const auto& entry : std::filesystem::directory_iterator(directory())) {
      if (entry.path().filename() != "x") {
        ++left_aside;
        std::filesystem::remove(entry.path());
      }
    }
  }
  EXPECT_TRUE(has_hit()) << ones << " of " << moment << ", " << left_aside << " left aside";
}

}  // namespace
}  // namespace dupin
